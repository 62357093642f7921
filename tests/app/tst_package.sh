#!/usr/bin/env bash
# The .deb holds what an installation must bring, and the files it brings are valid.
#   tst_package.sh SOURCE_DIR BUILD_DIR
set -euo pipefail
source=$1
. "$(dirname "$0")/../support/expect.sh"
trap 'rm -rf "$scratch"' EXIT

packaging=$source/resources/packaging
expect "the desktop entry is valid" desktop-file-validate "$packaging/org.fettle.Fettle.desktop"
# Versions from 1.0 on warn that there is no homepage; older ones do not know that warning.
metainfo_is_valid()
{
    appstreamcli validate --no-net "$1" || appstreamcli validate --no-net --override=url-homepage-missing=info "$1"
}
expect "the metainfo is valid" metainfo_is_valid "$packaging/org.fettle.Fettle.metainfo.xml"
mkdir -p "$scratch/mime/packages"
cp "$packaging/org.fettle.Fettle.mime.xml" "$scratch/mime/packages/"
expect "the file types are valid" update-mime-database "$scratch/mime"
for type in model/stl model/obj application/x-ply application/x-amf; do
    expect "the file types know $type" grep -q "^$type\$" "$scratch/mime/types"
    expect "the desktop entry opens $type" grep -q "^MimeType=.*$type;" "$packaging/org.fettle.Fettle.desktop"
done
expect "the desktop entry begins in the simulator, too" grep -q '^Exec=fettle --vr-simulator$' "$packaging/org.fettle.Fettle.desktop"
expect "the shell scripts parse" bash -c 'for script; do bash -n "$script" || exit 1; done' scripts \
    "$source/run.sh" "$source/test.sh" "$source/tests/support/with_display.sh" "$source/tests/support/expect.sh" \
    "$source/tests/check_windows.sh" "$packaging/prepare.sh" "$packaging/man_page.sh" "$packaging/third_party.sh" \
    "$packaging/bundle/bundle.sh" "$packaging/bundle/start.sh" "$packaging/fettle.bash" "$packaging"/windows/*.sh \
    "$source"/tests/windows/*.sh

cpack --config "$2/CPackConfig.cmake" -B "$scratch/package" >"$scratch/cpack.log" 2>&1 ||
    { cat "$scratch/cpack.log"; exit 1; }
deb=$(echo "$scratch"/package/fettle_*.deb)
files=$(dpkg-deb --contents "$deb" | awk '{print $6}')
for file in usr/bin/fettle usr/lib/fettle/libfettle_simulator.so usr/lib/fettle/fettle_simulator.json \
    usr/share/applications/org.fettle.Fettle.desktop usr/share/icons/hicolor/scalable/apps/fettle.svg \
    usr/share/mime/packages/org.fettle.Fettle.xml usr/share/metainfo/org.fettle.Fettle.metainfo.xml \
    usr/share/doc/fettle/copyright usr/share/doc/fettle/THIRD-PARTY usr/share/man/man1/fettle.1.gz \
    usr/share/bash-completion/completions/fettle usr/share/doc/fettle/reference/command-output.md; do
    expect "the package brings $file" grep -qx "\./$file" <<<"$files"
done
manual=$(dpkg-deb --fsys-tarfile "$deb" | tar -xO ./usr/share/man/man1/fettle.1.gz | zcat | sed 's/\\-/-/g')
for option in size bed repair no-clobber picture; do
    expect "the manual page lists --$option" grep -q "^.fB--$option" <<<"$manual"
done
release=$(. /etc/os-release && echo "$ID${VERSION_ID-}")
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$2/CMakeCache.txt")
expect "the version says for which release it is" test "$(dpkg-deb --field "$deb" Version)" = "$version-1+$release"
expect "so does the file's name ($deb)" \
    test "${deb##*/}" = "fettle_$version-1+${release}_$(dpkg --print-architecture).deb"
dpkg-deb --fsys-tarfile "$deb" | tar -xO ./usr/share/doc/fettle/THIRD-PARTY >"$scratch/third-party"
for name in qt6-base qt6-3d assimp draco expat openxr-sdk-source eigen3 nlohmann-json3; do
    expect "THIRD-PARTY lists $name with its version" grep -q "^    $name [0-9]" "$scratch/third-party"
done
expect "THIRD-PARTY has the terms of the LGPL" grep -q "^Common licence: LGPL-3$" "$scratch/third-party"
depends=$(dpkg-deb --field "$deb" Depends)
for library in libqt6widgets6 libqt63drender6 'libopenmesh[0-9.]*' 'libdraco[0-9]*' libqt6svg6 qt6-svg-plugins \
    qt6-translations-l10n libgl1-mesa-dri; do
    expect "the package depends on $library (Depends: $depends)" grep -q "\b$library\b" <<<"$depends"
done

# Where there is no dpkg, run.sh and test.sh print a command that builds. Here it configures a copy of the sources, and
# lists what it would build.
mkdir "$scratch/tools" "$scratch/copy of it"
find /usr/bin/ /bin/ -maxdepth 1 ! -name 'dpkg*' ! -name 'apt*' ! -type d -exec ln -sft "$scratch/tools" {} +
tar -C "$source" --exclude=./build --exclude=./.git -cf - . | tar -C "$scratch/copy of it" -xf -
for script in run.sh test.sh; do
    status=0
    (cd / && PATH=$scratch/tools "$scratch/copy of it/$script" 2>"$scratch/printed") || status=$?
    expect "$script refuses to install where there is no dpkg" test $status = 3
    command=$(sed -n 's/^  \(cmake .*\)/\1/p' "$scratch/printed")
    expect "$script prints a command" grep -q '^cmake .* && cmake --build ' <<<"$command"
    expect "the command of $script works up to the compiler" \
        bash -c 'cd / && PATH=$1 && eval "$2 --target help" >"$3"' - "$scratch/tools" "$command" "$scratch/targets"
    expect "it would build the program" grep -q '^fettle_app: ' "$scratch/targets"
done
expect "that of test.sh builds the tests, too" grep -q '^test_core_mesh: ' "$scratch/targets"
exit $failed
