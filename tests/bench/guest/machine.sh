# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# A virtual machine with Debian's own kernel and one program in it. To be sourced, by benches that set `bench`, their name, `kernel`, a
# folder, and `modules`, which the program loads in that order; `options` of qemu besides may be set.
options=()
top=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../../.." && pwd)

# The tools are there, and so is the kernel: 70 MB are downloaded into the folder once.
need_machine() {
    local tool package module
    for tool in qemu-system-x86_64 cpio apt-get g++; do
        command -v "$tool" >/dev/null || { echo "$bench: $tool is missing; install qemu-system-x86, cpio and g++" >&2; exit 1; }
    done
    [[ -f $top/build/libtactics_nouns.a ]] || { echo "$bench: build the project first (tests/run)" >&2; exit 1; }
    if ! has_all_modules; then
        mkdir -p "$kernel"
        package=$(apt-cache depends linux-image-amd64 | awk '/Depends: linux-image/ {print $2; exit}')
        (cd "$kernel" && apt-get download "$package" >/dev/null 2>&1)
        local wanted=('./boot/vmlinuz-*')
        for module in "${modules[@]}"; do wanted+=("./lib/modules/*/$module.ko"); done
        dpkg-deb --fsys-tarfile "$kernel"/linux-image-*.deb | tar -x -C "$kernel" --wildcards "${wanted[@]}"
        rm "$kernel"/linux-image-*.deb
    fi
}

has_all_modules() {
    compgen -G "$kernel/boot/vmlinuz-*" >/dev/null || return 1
    local module
    for module in "${modules[@]}"; do [[ -n $(find "$kernel/lib/modules" -name "$module.ko" -print -quit) ]] || return 1; done
}

# make_guest SOURCE LIBRARIES...: a first RAM disk in $scratch/initrd: the program, what it is linked to, the modules; besides, what is
# laid in $scratch/guest before.
make_guest() {
    local source=$1 module program library
    shift
    mkdir -p "$scratch/guest/modules" "$scratch/guest/dev"
    for module in "${modules[@]}"; do
        cp "$(find "$kernel/lib/modules" -name "$module.ko" -print -quit)" "$scratch/guest/modules/"
    done
    printf '%s\n' "${modules[@]}" >"$scratch/guest/modules/list"
    g++ -std=c++20 -O2 -I"$top" -static-libstdc++ -static-libgcc "$source" -o "$scratch/guest/init" "$@"
    for program in "$scratch"/guest/*; do
        [[ -f $program && -x $program ]] || continue
        # What it is linked to, with what loads it.
        ldd "$program" | grep -o '/[^ ]*' | while read -r library; do
            mkdir -p "$scratch/guest$(dirname "$library")"
            cp -L "$library" "$scratch/guest$library"
        done
    done
    (cd "$scratch/guest" && find . | cpio -o -H newc --quiet >"$scratch/initrd")
}

# A processor of qemu's own: KVM is not there everywhere, and these trials need no speed. On a busy host the kernel would find its
# timer broken (no_timer_check).
machine=(qemu-system-x86_64 -accel tcg -cpu max -nodefaults -no-reboot -display none)
words="console=ttyS0 quiet panic=-1 reboot=t mitigations=off random.trust_cpu=on no_timer_check"

# run_machine SOURCE LIBRARIES...: prints the rows that its program prints; 1 if it does not come to its END, or a row says BAD.
run_machine() {
    scratch=$(mktemp -d)
    trap 'rm -rf "$scratch"' EXIT
    make_guest "$@"
    timeout 600 "${machine[@]}" -m 256 -serial stdio "${options[@]}" -kernel "$kernel"/boot/vmlinuz-* -initrd "$scratch/initrd" \
        -append "$words" </dev/null | tr -d '\r' >"$scratch/said" || true
    grep '^|' "$scratch/said" || true
    if ! grep -q '^END' "$scratch/said" || grep -q 'BAD |' "$scratch/said"; then
        tail -n 20 "$scratch/said" >&2
        echo "$bench: a trial failed" >&2
        return 1
    fi
}
