#!/usr/bin/env bash
# Builds the program for Windows on Debian 12, by MinGW-w64, and makes an installer and a zip. See ../README.md.
#   resources/packaging/windows/build.sh [--libraries]
#   --libraries   only the libraries
# It can be stopped at any time, and goes on where it was. The libraries are kept outside the tree, in
# ${XDG_CACHE_HOME:-~/.cache}/fettle-windows; FETTLE_WINDOWS_CACHE names another folder.
set -euo pipefail
windows=$(dirname "$(readlink -f "$0")")
. "$windows/../prepare.sh"
. "$windows/libraries.sh"
case $*-$# in
    -0 | --libraries-1) ;;
    *) fettle_fail "build.sh takes no argument, or --libraries." ;;
esac

fettle_windows_packages='
g++-mingw-w64-x86-64-posix  compiles for Windows
cmake               describes the build
ninja-build         runs the build
qt6-base-dev        Qt: its tools, which run here
qt6-tools-dev       Qt: translations in the build
qt6-l10n-tools      Qt: translations in the build
qt6-translations-l10n  Qt: the translations of its own texts
libeigen3-dev       Eigen: headers only
libboost-dev        Boost.Multiprecision: headers only
nlohmann-json3-dev  JSON: headers only
libopenxr-dev       OpenXR: its licence
libz-mingw-w64-dev  zlib for Windows
libstb-dev          Assimp: textures, headers only
libutfcpp-dev       Assimp: UTF-8, headers only
libwine-dev         Qt: the headers of Wintab, for pens
python3             OpenXR: writes a part of its source
dpkg-dev            unpacks source packages
patch               applies patches to them
librsvg2-bin        draws the icon
icoutils            makes a Windows icon of it
nsis                makes the installer
'
fettle_install "$fettle_windows_packages" windows
cache=$(realpath -m "${FETTLE_WINDOWS_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/fettle-windows}")
compiler=x86_64-w64-mingw32-g++-posix
libraries=$cache/prefix
qt_host_cmake=$(qmake6 -query QT_INSTALL_LIBS)/cmake
sources=() # the folders of the source packages that were built
mkdir -p "$cache"
exec 8>"$cache/lock" # one build at a time in one cache
flock 8
build_libraries
[ $# = 0 ] || exit 0

build=$fettle_root/build/windows
fettle_lock
# The files of a library that was built long ago are older than what was built with another.
keys="$libraries ${key_of[*]}"
if [ "$(cat "$build/keys" 2>/dev/null)" != "$keys" ]; then
    rm -rf "$build"
    mkdir -p "$build"
    echo "$keys" >"$build/keys"
fi
fettle_is_configured windows || fettle_configure windows "-DFETTLE_WINDOWS_PREFIX=$libraries" -DQT_HOST_PATH=/usr \
    "-DQT_HOST_PATH_CMAKE_DIR=$qt_host_cmake"
fettle_build windows all

# What else is inside: the run-time of GCC, and headers.
inside=(/usr/x86_64-w64-mingw32/lib/{zlib1,libwinpthread-1}.dll /usr/include/stb/stb_image.h /usr/include/utf8.h
    /usr/include/wine/wine/windows/wintab.h /usr/share/qt6/translations/qtbase_de.qm)
for file in libstdc++-6.dll libgcc_s_seh-1.dll; do
    inside+=("$("$compiler" -print-file-name="$file")")
done
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$build/CMakeCache.txt")
"$windows/../third_party.sh" "$version" "$build/THIRD-PARTY.txt" "${sources[@]}" "${inside[@]}"
rm -rf "$build/package"
(cd "$build" && cpack) >"$build/package.log" 2>&1 || {
    tail -n 40 "$build/package.log" "$build"/package/_CPack_Packages/*/NSIS/NSISOutput.log >&2 || true
    fettle_fail "CPack could not make the packages; what it said stands above"
}
rm -rf "$build/package/_CPack_Packages"
fettle_unlock
ls -l "$build/package"
