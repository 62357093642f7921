# shellcheck shell=bash disable=SC2034 # the tables are read by the scripts that source this
# Sourced by run.sh, test.sh, bundle/bundle.sh and windows/build.sh: installs what is missing, configures, builds.
# Everything said here goes to stderr; stdout belongs to the program.

fettle_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

# package and reason, one per line; a package with ? is wanted only where the distribution has it
fettle_build_packages='
g++                 compiles the program (C++20)
cmake               describes the build
ninja-build         runs the build
qt6-base-dev        Qt: windows, widgets, OpenGL
libqt6opengl6-dev   Qt: OpenGL classes
qt6-3d-dev          Qt3D: the view of the model
qt6-svg-dev         Qt: icons
qt6-svg-plugins?    Qt: icons, a package of its own since Debian 13
qt6-tools-dev       Qt: translations in the build
qt6-l10n-tools      Qt: translations in the build
qt6-translations-l10n  Qt: the translations of its own texts
libopenmesh-dev     OpenMesh: the mesh kernel
libeigen3-dev       Eigen: vectors and matrices
libboost-dev        Boost.Multiprecision: exact points where faces cross
nlohmann-json3-dev  JSON: stroke files, reports, glTF
libassimp-dev       Assimp: reads the formats for which we have no reader
libdraco-dev        Draco: unpacks glTF that it packed
libexpat1-dev       Expat: the XML of 3MF and AMF
libzip-dev          libzip: the packages that 3MF files are, and zipped AMF
libopenxr-dev       OpenXR: the headset
libgl-dev           OpenGL
libegl-dev          OpenGL of the headset, under Wayland
libx11-dev          OpenGL of the headset, under X11
libgl1-mesa-dri     OpenGL drivers, with one in software
fonts-wqy-microhei  a font that has Chinese
'
fettle_test_packages='
libcgal-dev         CGAL: an independent check of meshes
libtinygltf-dev     tinygltf: reads what we write
libbenchmark-dev    Google Benchmark
clang-format        checks the format of the sources
clang               libFuzzer, which tries every reader with random bytes
libclang-rt-dev     the libraries of libFuzzer and the sanitizers
g++-mingw-w64-x86-64-posix?  compiles core and the files of Windows for Windows
python3             reads what that check has to compile
openxr-layer-corevalidation  says where a client of OpenXR breaks its rules
xvfb                a display without a screen
openbox             a window manager for that display
dbus-daemon         a session bus, for a desktop that says whether it is dark
desktop-file-utils  checks the desktop entry
appstream           checks the description for software centres
locales             the German one, for tests where numbers have commas
shared-mime-info    checks the file types
dpkg-dev            makes the .deb
file                makes the .deb
debootstrap         makes a bare Debian 13, on which the bundle is tried (--long)
'
fettle_bundle_packages='
patchelf            tells each file where the others are
binutils            says what each file needs
qt6-wayland         Qt: windows under Wayland
qt6-xdgdesktopportal-platformtheme?  Qt: file dialogs of the desktop
fcitx5-frontend-qt6?  Qt: an input method for Chinese
'

fettle_say() { printf '%s\n' "$*" >&2; }
fettle_fail() { fettle_say "fettle: $*"; exit 3; }

fettle_as_root()
{
    if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi
}

fettle_apt_install()
{
    # of a hundred packages that could not be fetched, one tells the story
    fettle_as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y \
        -o Dpkg::Use-Pty=0 -o DPkg::Lock::Timeout=300 install --no-install-recommends "$@" 2>&1 |
        awk '/^(E: Failed to fetch|Err:|Ign:)/ && n++ {next} /^  / && seen[$0]++ {next} {print; fflush()}' >&2
}

# fettle_missing NAMES: those packages that are not installed, and that no installed one provides.
fettle_missing()
{
    dpkg-query -W -f='${db:Status-Status} ${Package}, ${Provides}\n' | awk -v names="$1" '
        sub(/^installed /, "") {
            gsub(/ *\([^)]*\)/, "")
            n = split($0, name, ", *")
            for (i = 1; i <= n; ++i) have[name[i]]
        }
        END {n = split(names, name, "\n"); for (i = 1; i <= n; ++i) if (!(name[i] in have)) print name[i]}'
}

# fettle_names TABLE: the packages of the table, without those that this distribution does not have.
fettle_names()
{
    local package reason
    while read -r package reason; do
        case $package in
            '') ;;
            *\?) ! apt-cache show "${package%\?}" >/dev/null 2>&1 || printf '%s\n' "${package%\?}" ;;
            *) printf '%s\n' "$package" ;;
        esac
    done <<<"$1"
}

# fettle_install TABLE PRESET [CMAKE ARGUMENTS]: installs the packages of the table that are missing. Where there is no
# dpkg, it says what is wanted, and the command that builds then.
fettle_install()
{
    local names missing package reason
    names=$(fettle_names "$1")
    if ! command -v dpkg-query >/dev/null; then
        fettle_say "fettle: this is not Debian (there is no dpkg-query), so nothing can be installed from here." \
            "Wanted are, by their Debian names: ${names//$'\n'/ }"
        fettle_say "When they are installed, this builds $fettle_root/build/$2:"
        fettle_say "  $(printf '%q ' cmake -S "$fettle_root" --preset "${@:2}")&&" \
            "$(printf '%q ' cmake --build "$fettle_root/build/$2" -j "$(fettle_jobs)")"
        exit 3
    fi
    missing=$(fettle_missing "$names")
    [ -n "$missing" ] || return 0

    fettle_say "Fettle needs these Debian packages, which are not installed yet:"
    while read -r package reason; do
        package=${package%\?}
        if grep -qxF -- "${package:-none}" <<<"$missing"; then
            printf '  %-22s %s\n' "$package" "$reason" >&2
        fi
    done <<<"$1"
    command -v apt-get >/dev/null ||
        fettle_fail "there is no apt-get here to install them with. Install them and start again."
    if [ "$(id -u)" != 0 ] && ! command -v sudo >/dev/null; then
        fettle_fail "installing needs root and there is no sudo. As root: apt-get install --no-install-recommends ${missing//$'\n'/ }"
    fi

    fettle_say "Installing them with apt-get."
    # shellcheck disable=SC2086
    if ! apt-get -qq -s install --no-install-recommends $missing >/dev/null 2>&1 || ! fettle_apt_install $missing; then
        fettle_say "The package list is old or empty: fetching it anew."
        fettle_as_root apt-get -q -o DPkg::Lock::Timeout=300 update >&2 ||
            fettle_fail "apt-get update failed (is there a network?). Still missing: ${missing//$'\n'/ }"
        missing=$(fettle_missing "$(fettle_names "$1")")
        fettle_apt_install $missing ||
            fettle_fail "apt-get could not install these packages (is there a network?): ${missing//$'\n'/ }"
    fi
}

# Parallel jobs: one per core, and 1.5 GB of memory for each.
fettle_jobs()
{
    local cores memory limit
    cores=$(nproc)
    memory=$(awk '/^MemAvailable:/ {print int($2 / 1024)}' /proc/meminfo 2>/dev/null || true)
    limit=$(cat /sys/fs/cgroup/memory.max 2>/dev/null || true)
    case $limit in
        '' | *[!0-9]*) ;;
        *) limit=$((limit / 1048576)); [ "$limit" -ge "${memory:-$limit}" ] || memory=$limit ;;
    esac
    [ "$((${memory:-1500} / 1500))" -ge "$cores" ] || cores=$((${memory:-1500} / 1500))
    echo "$((cores > 0 ? cores : 1))"
}

# fettle_configure PRESET [CMAKE ARGUMENTS]: into build/PRESET.
fettle_configure()
{
    local preset=$1 build=$fettle_root/build/$1 fresh=
    shift
    # A tree that was moved or copied would still point to its old place.
    if [ -e "$build/CMakeCache.txt" ]; then
        grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$fettle_root" "$build/CMakeCache.txt" || fresh=--fresh
    fi
    fettle_say "Configuring build/$preset"
    mkdir -p "$build"
    rm -f "$build/configured"
    # shellcheck disable=SC2086
    cmake -S "$fettle_root" --preset "$preset" $fresh "$@" >"$build/configure.log" 2>&1 ||
        cmake -S "$fettle_root" --preset "$preset" --fresh "$@" >"$build/configure.log" 2>&1 || {
        cat "$build/configure.log" >&2
        fettle_fail "CMake could not configure build/$preset; what it said stands above and in build/$preset/configure.log"
    }
    touch "$build/configured"
}

# fettle_is_configured PRESET [CACHE ENTRY]
fettle_is_configured()
{
    local build=$fettle_root/build/$1
    [ -e "$build/build.ninja" ] && [ -e "$build/configured" ] &&
        [ ! "$fettle_root/CMakePresets.json" -nt "$build/configured" ] &&
        grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$fettle_root" "$build/CMakeCache.txt" &&
        { [ -z "${2-}" ] || grep -qxF "$2" "$build/CMakeCache.txt"; }
}

# fettle_build PRESET TARGET: silent where there is nothing to do.
fettle_build()
{
    local build=$fettle_root/build/$1 target=$2 jobs
    if ninja -C "$build" -n "$target" 2>/dev/null | grep -q 'no work to do'; then
        return 0
    fi
    jobs=$(fettle_jobs)
    fettle_say "Building build/$1 ($jobs at a time)"
    cmake --build "$build" -j "$jobs" --target "$target" >&2 || fettle_fail "the build failed; what the compiler said stands above."
}

# One build at a time in one tree: others wait. Ends with fettle_unlock.
fettle_lock()
{
    mkdir -p "$fettle_root/build"
    exec 9>"$fettle_root/build/lock"
    flock 9
}

fettle_unlock() { exec 9>&-; }
