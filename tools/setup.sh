# From a fresh machine to a build: what run.sh and test.sh share. Sourced, never run.
#
# The idea: ask dpkg once which of the packages below are missing, install only these, and leave
# the rest to CMake. When nothing is missing and nothing has changed, all of this takes well under
# a second. On a system without apt it says what is needed and CMake finds it, or fetches it.
#
# shellcheck shell=bash

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)"
readonly root

# Same names on Debian 12, Debian 13 and Ubuntu 24.04.
readonly packages_to_build=(
    g++ cmake ninja-build pkg-config ccache
    python3 python3-glad # writes the OpenGL loader while building
    libglfw3-dev libimgui-dev libstb-dev libgl-dev libegl-dev
    libglm-dev nlohmann-json3-dev libpugixml-dev libcli11-dev libfontconfig-dev
    libhwy-dev
)
readonly packages_to_run=(
    libgl1 libegl1 libglx-mesa0 libegl-mesa0 libgl1-mesa-dri # OpenGL, in software if need be
    libxcursor1 libxi6 libxinerama1 libxrandr2               # opened by GLFW 3.3 when it starts
    fonts-dejavu-core
)
readonly packages_to_test=(
    libgtest-dev libgmock-dev
    xvfb xdotool xclip x11-utils x11-xserver-utils # a screen, hands, a clipboard, Xft.dpi
    imagemagick                                    # reads the pictures the tests compare
    locales                                        # to make a locale with a decimal comma
    python3-jsonschema
)
# One fixed version, for versions format differently; installed where the distribution has it.
readonly packages_to_test_if_available=(clang-format-19)
# The benchmark compares with these; one that a distribution lacks is left out of the table.
readonly packages_to_bench=(libbenchmark-dev)
readonly packages_to_bench_if_available=(
    libglm-dev libeigen3-dev libgsl-dev libboost-dev libsisl-dev lib2geom-dev
)
# The fuzzers need clang's own run-time library, whose package bears a version.
readonly packages_to_fuzz=(clang)
readonly packages_to_fuzz_if_available=(libclang-rt-14-dev libclang-rt-dev)

say() { printf '%s\n' "$*"; }

fail() {
    printf '%s: %s\n' "${0##*/}" "$*" >&2
    exit 1
}

# The names among "$@" that dpkg does not list as installed, one a line.
missing_packages() {
    local installed
    # dpkg-query fails when it knows nothing of a name; what it printed still counts.
    installed="$(dpkg-query -W -f='${db:Status-Abbrev}\t${Package}\n' "$@" 2>/dev/null || true)"
    installed="$(sed -n 's/^.i *\t//p' <<<"$installed")"
    local name
    for name in "$@"; do
        grep -qxF -- "$name" <<<"$installed" || printf '%s\n' "$name"
    done
}

# Runs apt-get as root without questions; its output goes to the log, the end of it on failure.
apt_get() {
    local log="$root/build/setup.log" as_root=()
    mkdir -p "$root/build"
    if [[ $EUID -ne 0 ]]; then
        as_root=(sudo)
    fi
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive NEEDRESTART_SUSPEND=1 \
        apt-get -q -y -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3 "$@" \
        </dev/null >"$log" 2>&1 || {
        tail -n 15 "$log" >&2
        return 1
    }
}

can_become_root() { [[ $EUID -eq 0 ]] || command -v sudo >/dev/null; }

apt_lists_are_empty() { ! compgen -G '/var/lib/apt/lists/*_Packages*' >/dev/null; }

# install_packages REQUIRED... [-- OPTIONAL...]
install_packages() {
    local required=() optional=() missing=() missing_optional=() name seen_separator=false
    for name in "$@"; do
        if [[ $name == -- ]]; then
            seen_separator=true
        elif $seen_separator; then
            optional+=("$name")
        else
            required+=("$name")
        fi
    done

    if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
        say_what_to_install_without_apt
        return
    fi
    mapfile -t missing < <(missing_packages "${required[@]}")
    if [[ ${#optional[@]} -gt 0 ]]; then
        mapfile -t missing_optional < <(missing_packages "${optional[@]}")
    fi
    if [[ ${#missing[@]} -eq 0 && ${#missing_optional[@]} -eq 0 ]]; then
        return
    fi
    if ! can_become_root; then
        say "Not installed, and neither root nor sudo is at hand to install it. As root, run:"
        say "    apt-get install ${missing[*]} ${missing_optional[*]}"
        return
    fi

    if [[ ${#missing[@]} -gt 0 ]] || apt_lists_are_empty; then
        apt_get update || fail "apt-get update failed (see above); is the network there?"
    fi
    for name in "${missing_optional[@]}"; do
        if [[ -n "$(apt-cache madison "$name" 2>/dev/null)" ]]; then
            missing+=("$name")
        fi
    done
    if [[ ${#missing[@]} -gt 0 ]]; then
        say "Installing ${#missing[@]} packages: ${missing[*]}"
        apt_get install --no-install-recommends "${missing[@]}" ||
            fail "apt-get install failed (see above and build/setup.log)"
    fi
}

say_what_to_install_without_apt() {
    say "No apt here. Splineloft needs: a C++20 compiler, CMake 3.25, Ninja, pkg-config, Python 3,"
    say "OpenGL and EGL headers, GLFW 3.3, Dear ImGui 1.86 to 1.92, GLM, glad 2, nlohmann/json,"
    say "pugixml, CLI11, Highway 1.0, stb_image_write, fontconfig and the DejaVu Sans font; to test,"
    say "GoogleTest."
    say "Libraries that CMake does not find it will try to fetch."
}

require_build_tools() {
    local tool
    for tool in cmake ninja; do
        command -v "$tool" >/dev/null || fail "$tool is not installed"
    done
    if [[ -z ${CXX:-} ]] && ! command -v c++ g++ clang++ >/dev/null; then
        fail "no C++ compiler is installed"
    fi
}

set_up_for_running() {
    install_packages "${packages_to_build[@]}" "${packages_to_run[@]}"
    require_build_tools
}

set_up_for_tests() {
    install_packages "${packages_to_build[@]}" "${packages_to_run[@]}" "${packages_to_test[@]}" \
        -- "${packages_to_test_if_available[@]}"
    require_build_tools
}

set_up_for_bench() {
    install_packages "${packages_to_build[@]}" "${packages_to_bench[@]}" \
        -- "${packages_to_bench_if_available[@]}"
    require_build_tools
}

set_up_for_fuzzing() {
    install_packages "${packages_to_build[@]}" "${packages_to_fuzz[@]}" \
        -- "${packages_to_fuzz_if_available[@]}"
    require_build_tools
}

build_folder() { printf '%s/build/%s' "$root" "$1"; }

# True when CMake has configured this preset here before, from the presets as they are now.
is_configured() {
    local folder
    folder="$(build_folder "$1")"
    [[ -f $folder/build.ninja && $folder/.configured -nt $root/CMakePresets.json ]] &&
        ! was_moved "$folder"
}

# CMake refuses a build folder whose checkout has been moved or copied since.
was_moved() {
    [[ -f $1/CMakeCache.txt ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$1/CMakeCache.txt"
}

# configure PRESET [CMAKE ARGUMENT...]; its output goes to a log, all of it on failure.
configure() {
    local preset="$1" folder
    folder="$(build_folder "$preset")"
    mkdir -p "$folder"
    local log="$folder/configure.log" fresh=()
    if was_moved "$folder"; then
        fresh=(--fresh)
    fi
    rm -f "$folder/.configured"
    cmake -S "$root" --preset "$preset" "${fresh[@]}" "${@:2}" >"$log" 2>&1 || {
        cat "$log" >&2
        fail "CMake could not configure the preset '$preset' (see above)"
    }
    touch "$folder/.configured"
}

# build PRESET [TARGET]; quiet but for errors unless a person is watching.
build() {
    local arguments=()
    if [[ $# -gt 1 ]]; then
        arguments+=(--target "$2")
    fi
    if [[ ! -t 1 ]]; then
        arguments+=(-- --quiet)
    fi
    cmake --build "$(build_folder "$1")" "${arguments[@]}" ||
        fail "the build of the preset '$1' failed (see above)"
}
