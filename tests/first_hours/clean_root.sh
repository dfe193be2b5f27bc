# SPDX-License-Identifier: Apache-2.0
# A clean Debian in a folder, as a newcomer's machine, and steps taken in it that say what each gave; sourced by the scripts beside it.
# It is of the release that runs here and from the mirror that apt has here; debootstrap and chroot need root. A root that was made once
# is kept in FIRST_HOURS_CACHE, if that names a folder.
steps=0 failures=() layers=
install='apt-get install -qq -y -o Dpkg::Use-Pty=0'

can_make_root() {
    local missing=()
    ((EUID == 0)) || missing+=("root's rights")
    command -v debootstrap >/dev/null || missing+=("debootstrap")
    ((${#missing[@]} == 0)) || { echo "Skipped: $(printf '%s; ' "${missing[@]}")needed for a clean root"; exit 77; }
}

# make_root: into $root, which is deleted at the end unless KEEP_ROOT is set.
make_root() {
    local mirror cached=
    find_release
    mirror=$(apt-get indextargets --format '$(SITE) $(CODENAME) $(COMPONENT)' 'Identifier: Packages' |
        awk -v release="$release" '$2 == release && $3 == "main" {print $1; exit}')
    [[ -n $mirror ]] || { echo "apt knows no mirror of $release here"; exit 2; }
    root=$(mktemp -d "${TMPDIR:-/tmp}/first-hours-XXXXXX")
    trap end_root EXIT
    [[ -z ${FIRST_HOURS_CACHE:-} ]] || cached=$FIRST_HOURS_CACHE/$release.tar
    if [[ -n $cached && -f $cached ]]; then
        tar -C "$root" -xf "$cached"
    else
        debootstrap --variant=minbase "$release" "$root" "$mirror" >"$root.log" 2>&1 || { tail -n 20 "$root.log"; exit 2; }
        rm -f "$root.log"
        [[ -z $cached ]] || tar -C "$root" -cf "$cached" .
    fi
    chmod 755 "$root"  # mktemp makes a folder that only root may enter
    echo force-unsafe-io >"$root/etc/dpkg/dpkg.cfg.d/first-hours"  # the root is deleted at the end, so no file has to reach the disk
    add_ana
    echo "A clean $release with $(chroot "$root" dpkg-query -W | wc -l) packages"
}

find_release() { release=$(. /etc/os-release && echo "$VERSION_CODENAME"); }

add_ana() { chroot "$root" useradd --create-home --home-dir /srv/ana --shell /bin/bash ana; }

end_root() {
    [[ -n ${KEEP_ROOT:-} ]] && { echo "The root is in $root"; return; }
    ! mountpoint -q "$root" || umount "$root"
    rm -rf --one-file-system "$root" ${layers:+"$layers"}
}

# make_packages BUILD: the Debian packages of that build folder.
make_packages() {
    [[ -x $1/tactics && -x $1/draw_samples ]] || { echo "Build first: samples/run"; exit 2; }
    rm -f "$1"/*.deb
    (cd "$1" && cpack -G DEB >cpack.log 2>&1) || { cat "$1/cpack.log"; exit 2; }
}

# program_root BUILD: a root in which the program of that build and what it recommends are installed, and ana has pictures. What the
# packages depend on is kept in FIRST_HOURS_CACHE, too: only the first of the scripts has to install it.
program_root() {
    local build=$1 kept=
    make_packages "$build"
    find_release
    [[ -z ${FIRST_HOURS_CACHE:-} ]] || kept=$FIRST_HOURS_CACHE/$release-program
    if [[ -n $kept && -d $kept ]]; then
        root=$(mktemp -d "${TMPDIR:-/tmp}/first-hours-XXXXXX")
        layers=$(mktemp -d "${TMPDIR:-/tmp}/first-hours-XXXXXX")
        trap end_root EXIT
        mkdir "$layers/upper" "$layers/work"
        chmod 755 "$layers/upper"
        mount -t overlay overlay -o "lowerdir=$kept,upperdir=$layers/upper,workdir=$layers/work" "$root" || cp -a "$kept/." "$root"
    else
        make_root
    fi
    rm -rf "$root/packages"
    mkdir "$root/packages"
    cp "$build"/*.deb "$root/packages/"
    enter root "apt-get update -qq && $install --reinstall /packages/tactics_*.deb /packages/tactics-formats_*.deb man-db" >"$root.log" 2>&1 ||
        { tail -n 20 "$root.log"; exit 2; }
    rm -f "$root.log"
    if [[ -n $kept && ! -d $kept ]]; then
        rm -rf "$kept.new"
        cp -a "$root" "$kept.new" && mv "$kept.new" "$kept"
    fi
    pictures_for "$build"
    echo "A $release with tactics and what it recommends: $(chroot "$root" dpkg-query -W | wc -l) packages"
}

# enter USER WORD...: runs it there; what it mounts ends with it.
enter() {
    local user=$1 home=/root
    shift
    [[ $user == root ]] || home=/srv/$user
    # $0 is the root.
    unshare --mount bash -c 'mount -t proc proc "$0/proc" && mount --rbind /dev "$0/dev" && exec chroot "$0" "$@"' "$root" \
        runuser -u "$user" -- env -i HOME="$home" USER="$user" PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
        LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive bash -c 'cd && eval "$1"' bash "$1"
}

# step WHAT USER COMMANDS [PATTERN]: its answer must fit the pattern, if there is one.
step() {
    local what=$1 user=$2 commands=$3 pattern=${4:-} answer code=0 begin=$SECONDS verdict
    steps=$((steps + 1))
    echo
    echo "== $steps. $what ($user)"
    printf '%s\n' "$commands" | sed 's/^/$ /'
    answer=$(enter "$user" "$commands" 2>&1) || code=$?
    ((code == 0)) && verdict=good || verdict="BAD: exit code $code"
    [[ -z $pattern ]] || grep -qE -e "$pattern" <<<"$answer" || verdict="BAD: it does not say $pattern"
    if [[ $verdict == good ]]; then
        tail -n "${SHOWN_LINES:-8}" <<<"$answer"
    else
        tail -n 60 <<<"$answer"
        failures+=("$steps. $what")
    fi
    echo "-- $verdict after $((SECONDS - begin)) s"
}

close_hours() {
    echo
    ((${#failures[@]} == 0)) || printf 'BAD: %s\n' "${failures[@]}"
    echo "$((steps - ${#failures[@]})) steps good, ${#failures[@]} bad, $((SECONDS / 60)) minutes"
    ((${#failures[@]} == 0))
}

# machine_listens FILE: an embosser on the network at port $port, which keeps in FILE what it was sent last; until machine_off.
machine_listens() {
    exec 3< <(exec python3 -u - "$1" <<'PY'
import os, socket, sys
with socket.create_server(("127.0.0.1", 0)) as server:
    print(server.getsockname()[1], flush=True)
    while True:
        client, _ = server.accept()
        with client, open(sys.argv[1] + ".new", "wb") as file:
            while block := client.recv(65536): file.write(block)
        if os.path.getsize(sys.argv[1] + ".new"): os.rename(sys.argv[1] + ".new", sys.argv[1])
PY
)
    machine=$!
    read -r port <&3
}
machine_off() { kill "$machine"; }

# pictures_for BUILD: into ana's home, as a newcomer has some.
pictures_for() {
    local drawn=$1/first-hours-pictures  # once a build
    [[ $drawn -nt $1/draw_samples ]] || { rm -rf "$drawn" && "$1/draw_samples" "$drawn" >/dev/null; }
    cp -r "$drawn" "$root/srv/ana/pictures"
    # One that only OpenImageIO reads: white, with a black square.
    python3 - "$root/srv/ana/pictures/square.bmp" <<'PY'
import struct, sys
size = 240
rows = b"".join((b"\0\0\0" if 80 <= x < 160 and 80 <= y < 160 else b"\xff\xff\xff") for y in range(size) for x in range(size))
open(sys.argv[1], "wb").write(struct.pack("<2sIHHIIiiHHIIiiII", b"BM", 54 + len(rows), 0, 0, 54, 40, size, size, 1, 24, 0, len(rows), 2835, 2835, 0, 0) + rows)
PY
    chroot "$root" chown -R ana: /srv/ana
}
