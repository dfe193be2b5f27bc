# SPDX-License-Identifier: Apache-2.0
# What Debian 12 must have, in one place; sourced by samples/run, tests/run and .ci/run.
#
# need PACKAGE... installs those that are missing, as root or with sudo. With neither it says what to install, and the
# build goes on to find out whether the same things are there in another way.

# What the programs are built from and need to run.
build_packages=(
    g++ cmake ninja-build pkg-config
    libopencv-imgproc-dev libfreetype-dev libfontconfig-dev liblouis-dev liblouis-data
    libjpeg62-turbo-dev libpng-dev libtiff-dev zlib1g-dev libexpat1-dev libusb-1.0-0-dev libhidapi-dev libevdev-dev libbrlapi-dev libopenimageio-dev libheif-dev libassimp-dev fonts-dejavu-core
    libboost-dev rapidjson-dev libpappl-dev
)
# What tactics uses at run time if it is there: without these programs print stays in the lines and PDF is refused, and without the
# fonts figures in Helvetica, Arial, Times and Courier, and those that TeX has set, keep many of their words as lines.
run_packages=(tesseract-ocr tesseract-ocr-eng poppler-utils
              fonts-dejavu-extra fonts-lmodern fonts-liberation2 fonts-urw-base35)
# What the tests are built from, and the independent programs that they check our files with.
test_packages=(libgtest-dev libgeos-dev qpdf ghostscript librsvg2-bin imagemagick libtiff-tools
               umockdev libumockdev-dev libxml2-utils admesh python3-jsonschema man-db speech-dispatcher libspeechd2 espeak-ng libasound2
               cups-ipp-utils)
# Sanitizers, fuzzing, and how sources look.
ci_packages=(clang libclang-rt-14-dev clang-format clang-tidy lld git)

need() {
    local missing=() package
    for package in "$@"; do
        dpkg-query -W -f '${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || missing+=("$package")
    done
    ((${#missing[@]} == 0)) && return 0
    local root=()
    if ((EUID != 0)); then
        if ! command -v sudo >/dev/null; then
            echo "Not root and no sudo. If the build fails, have these installed: ${missing[*]}"
            return 0
        fi
        root=(sudo)
    fi
    echo "Installing: ${missing[*]}"
    local quiet=(-o Dpkg::Use-Pty=0 -qq)
    "${root[@]}" apt-get "${quiet[@]}" update
    "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get "${quiet[@]}" install -y --no-install-recommends "${missing[@]}" >/dev/null
}

export CCACHE_SLOPPINESS=pch_defines,time_macros  # for precompiled headers

cores() { nproc 2>/dev/null || echo 2; }

# configure FOLDER OPTION...: only when one of the options is new to it. Ninja if it is there, else make.
configure() {
    local folder=$1 option fresh=0 generator=() options=(-DCMAKE_BUILD_TYPE=Release)
    shift
    command -v ccache >/dev/null && options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
    options+=("$@")
    [[ -f $folder/CMakeCache.txt ]] || { fresh=1; command -v ninja >/dev/null && generator=(-G Ninja); }
    for option in "${options[@]}"; do
        grep -qxFe "$option" "$folder/.configured" 2>/dev/null || fresh=1
    done
    ((fresh)) || return 0
    mkdir -p "$folder"
    cmake -S "$top" -B "$folder" "${generator[@]}" "${options[@]}" >"$folder/configure.log" 2>&1 || {
        cat "$folder/configure.log"
        return 1
    }
    printf '%s\n' "${options[@]}" >>"$folder/.configured"
}

# build FOLDER [TARGET...]: all cores, only what changed.
build() {
    local folder=$1
    shift
    cmake --build "$folder" --parallel "$(cores)" ${1:+--target "$@"}
}

# test_and_count FOLDER [CTEST OPTION...]: runs the tests of a build folder and closes with the counts from ctest's own
# record. Fails when a test fails and when there was no test.
test_and_count() {
    local folder=$1 record=$1/tests.xml
    shift
    rm -f "$record"
    ctest --test-dir "$folder" --output-on-failure --parallel "$(cores)" --output-junit "$record" "$@" || true
    count_tests "$record"
}

count_tests() {
    local total=0 failed=0 skipped=0 head=
    [[ -f $1 ]] && head=$(grep -m1 -A12 '<testsuite' "$1" | tr '\n' ' ')
    [[ $head =~ tests=\"([0-9]+)\" ]] && total=${BASH_REMATCH[1]}
    [[ $head =~ failures=\"([0-9]+)\" ]] && failed=${BASH_REMATCH[1]}
    # ctest counts the tests that were left out as "disabled" and those that say so themselves as "skipped".
    [[ $head =~ skipped=\"([0-9]+)\" ]] && skipped=${BASH_REMATCH[1]}
    local passed=$((total - failed - skipped))
    ((skipped > 0)) && echo "$passed passed, $failed failed, $skipped skipped" || echo "$passed passed, $failed failed"
    ((passed > 0 && failed == 0))
}
