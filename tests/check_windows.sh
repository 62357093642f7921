#!/usr/bin/env bash
# Compiles for Windows, by Debian's MinGW-w64, what needs no library of Windows: core/ whole and the files of Windows in
# app, ui and vr. Only their syntax is checked, for which headers are enough.
#   tests/check_windows.sh BUILD_FOLDER
# It also links the program of tests/windows, which tries what the files of Windows promise, and runs it under Wine if
# that is installed. Nothing is done where nothing has changed since the last time.
#
# The headers are those of this system. Libraries that are only headers, and those of which core needs the declarations,
# are the same on every system. Qt's headers ask the compiler for the system; its features (qconfig.h) are those of
# Debian, which differ from Windows in what none of our files uses. So they serve for -fsyntax-only, and for no more.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "$0")")/.." && pwd)
build=${1:?usage: check_windows.sh BUILD_FOLDER}
mkdir -p "$build"
build=$(cd "$build" && pwd)
compiler=x86_64-w64-mingw32-g++-posix
if ! command -v "$compiler" >/dev/null; then
    echo "SKIP: $compiler is not installed (Debian package g++-mingw-w64-x86-64-posix)"
    exit 77
fi
fail() { echo "check_windows.sh: $*" >&2; exit 1; }

# --- a folder with the headers of the libraries, and nothing else of this system
prefix=$build/prefix
link() { [ -e "$1" ] || fail "$1 is missing, which is installed for the build on this system"; ln -sfn "$1" "$2"; }
mkdir -p "$prefix/include" "$prefix/lib/cmake/OpenMesh" "$prefix/share"
for header in boost eigen3 expat.h expat_external.h nlohmann OpenMesh openxr zip.h zipconf.h; do
    link "/usr/include/$header" "$prefix/include/$header"
done
link /usr/share/eigen3 "$prefix/share/eigen3"
mkdir -p "$prefix/share/cmake"
link /usr/share/cmake/nlohmann_json "$prefix/share/cmake/nlohmann_json"
cat >"$prefix/lib/cmake/OpenMesh/OpenMeshConfig.cmake" <<'EOF'
# The headers alone, which suffice to compile.
if(NOT TARGET OpenMeshCore)
    add_library(OpenMeshCore INTERFACE IMPORTED)
    get_filename_component(OPENMESH_PREFIX "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
    set_target_properties(OpenMeshCore PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${OPENMESH_PREFIX}/include")
endif()
EOF
for library in expat zip; do # to be found; nothing is in them
    [ -e "$prefix/lib/lib$library.a" ] || x86_64-w64-mingw32-ar rc "$prefix/lib/lib$library.a"
done

# --- which files CMake chooses for Windows, and how it compiles them
configure()
{
    cmake -S "$root" -B "$build/core" -G Ninja --toolchain "$root/resources/packaging/windows/toolchain.cmake" \
        -DFETTLE_WINDOWS_PREFIX="$prefix" -DFETTLE_CORE_ONLY=ON -DFETTLE_WERROR=ON -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_CXX_FLAGS_RELEASE=-O1 -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DBUILD_TESTING=ON \
        >"$build/configure.log" 2>&1 ||
        { cat "$build/configure.log" >&2; fail "CMake could not configure core for Windows"; }
}

jobs=$(nproc)

# Compiles one unit: its name, then the words of the compiler.
compile()
{
    local name=$1
    shift
    "$@" >"$build/units/$name.log" 2>&1 && return 0
    echo "--- $name"
    cat "$build/units/$name.log"
    return 1
}

# Writes what CMake compiles as a unit for each folder, whose headers take most of the time. The files of Windows are
# left out.
units_of_core()
{
    python3 - "$build/core/compile_commands.json" "$build/units" <<'EOF'
import json, os, re, shlex, sys
commands, units = sys.argv[1:]
flags = None
for entry in json.load(open(commands)):
    if "fettle_core.dir" not in entry["command"] or "cmake_pch.hxx.cxx" in entry["file"]:
        continue
    if entry["file"].endswith("_windows.cpp"):
        continue
    # A folder of many files has several of CMake's units, which end with a number.
    name = re.sub(r"_\d+$", "", os.path.basename(entry["file"]).removesuffix("_cxx.cxx").removesuffix(".cpp"))
    if not flags:
        words = shlex.split(entry["command"])[1:]
        # Neither an object nor a precompiled header is made: the compiler reads one more slowly than what is in it.
        flags = [word for i, word in enumerate(words)
                 if word not in ("-c", "-o", "-include") and words[i - 1] not in ("-c", "-o", "-include")]
    with open(os.path.join(units, f"core_{name}.cpp"), "a") as file:
        file.write(f'#include "{entry["file"]}"\n')
if not flags:
    sys.exit("no file of core is compiled for Windows")
with open(os.path.join(units, "core.flags"), "w") as file:
    file.write("\n".join(flags))
EOF
}

check_syntax()
{
    local failed=0 library modules module
    rm -rf "$build/units"
    mkdir -p "$build/units"
    units_of_core || fail "the list of core's files cannot be read"
    mapfile -t flags <"$build/units/core.flags"
    # The compiler takes what a unit includes for headers, and warns of what only headers may not have.
    flags+=(-fsyntax-only -Wno-subobject-linkage)
    modules=(-isystem "$(qmake6 -query QT_INSTALL_HEADERS)")
    for module in QtCore QtGui QtWidgets QtOpenGL QtNetwork; do
        modules+=(-isystem "${modules[1]}/$module")
    done
    # The headers of Windows and Qt take most of the time, so the files of Windows of a library are one unit.
    # A header that a file needs and does not include is not noticed here.
    for library in core app ui vr; do
        (cd "$root" && find "$library" -name '*_windows.cpp' -o -name '*_wgl.cpp' | sort) |
            sed 's/.*/#include "&"/' >"$build/units/windows_$library.cpp"
    done
    # Elsewhere core's headers come after those of Windows, which define words such as near and far.
    (cd "$root" && echo '#include <windows.h>' && find core -name '*.h' | sort | sed 's/.*/#include "&"/') \
        >"$build/units/headers_of_core.cpp"
    export -f compile
    export build
    printf '%s\n' "${flags[@]}" >"$build/units/core.flags"
    printf '%s\n' "${flags[@]}" "${modules[@]}" -DQT_NO_CAST_FROM_ASCII -DQT_NO_CAST_TO_ASCII -DQT_NO_KEYWORDS \
        >"$build/units/qt.flags"
    find "$build/units" -name '*.cpp' -printf '%f\n' | sort |
        xargs -P "$jobs" -I{} bash -c '
            set=core
            [[ {} != windows_* || {} = windows_core.cpp ]] || set=qt
            mapfile -t flags <"$build/units/$set.flags"
            compile "{}" '"$compiler"' "${flags[@]}" "$build/units/{}"' || failed=1
    [ "$failed" = 0 ] || fail "these files do not compile for Windows; the lines above say why"
    echo "compiled for Windows: $(find "$build/units" -name '*.cpp' | wc -l) units"
}

# --- tests/windows
run_under_wine()
{
    cmake --build "$build/core" -j "$jobs" --target platform_check >"$build/build.log" 2>&1 ||
        { tail -n 60 "$build/build.log" >&2; fail "tests/windows does not build"; }
    local wine
    wine=$(command -v wine64 || echo /usr/lib/wine/wine64)
    if [ ! -x "$wine" ]; then
        echo "SKIP: tests/windows was built, but Wine is not installed (Debian package wine64)"
        return 0
    fi
    # Without winemenubuilder, which writes file types into the menus of the user.
    export WINEPREFIX=$build/wine WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml,winemenubuilder.exe='
    unset DISPLAY
    rm -rf "$build/tried"
    mkdir -p "$build/tried"
    local status=0
    timeout 180 "$wine" "$build/core/tests/windows/platform_check.exe" "Z:${build//\//\\}\\tried" || status=$?
    "$(dirname "$wine")/wineserver" -k 2>/dev/null || wineserver -k 2>/dev/null || true
    [ "$status" = 0 ] || fail "tests/windows failed under Wine ($status)"
}

# The state that was compiled: sources, options, compiler. A comparison takes a tenth of a second.
state=$({ "$compiler" --version
    dpkg-query -W qt6-base-dev libopenmesh-dev libeigen3-dev wine64 2>/dev/null || true
    cd "$root" && {
        find core tests/windows resources/packaging/windows -type f
        find app ui vr -name '*.h' -o -name '*_windows.cpp' -o -name '*_wgl.cpp'
    } | sort | xargs sha256sum CMakeLists.txt tests/check_windows.sh; } | sha256sum)
if [ "$(cat "$build/passed" 2>/dev/null || true)" = "$state" ]; then
    echo "nothing has changed since it was compiled for Windows"
    exit 0
fi
rm -f "$build/passed"
configure
run_under_wine
check_syntax
echo "$state" >"$build/passed"
