#!/usr/bin/env bash
# Makes one file that starts Fettle on any Linux whose glibc is not older than that of this Debian, from the built
# program and installed Debian packages: fettle-VERSION-linux-ARCHITECTURE.run. README.md beside it says how it works.
#   bundle.sh                      installs what is missing, builds, and leaves the file in build/release/package
#   bundle.sh BUILD_FOLDER FOLDER  of a build that is there, into that folder; installs nothing
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
. "$here/../prepare.sh"

if [ $# -eq 2 ]; then
    build=$(realpath "$1")
    folder=$(realpath "$2")
elif [ $# -eq 0 ]; then
    build=$fettle_root/build/release
    folder=$build/package
    fettle_install "$fettle_build_packages$fettle_bundle_packages" release -DBUILD_TESTING=OFF
    fettle_lock
    fettle_is_configured release || fettle_configure release -DBUILD_TESTING=OFF
    fettle_build release fettle
    fettle_unlock
else
    fettle_fail "bundle.sh takes no argument, or the folder of a build and the folder for the file."
fi
for tool in patchelf readelf dpkg-query qmake6 gzip; do
    command -v "$tool" >/dev/null ||
        fettle_fail "bundle.sh: $tool is not installed; the tables in prepare.sh have its package"
done

# Plugins of Qt, in its folder of plugins; one with ? where the packages have it.
#   Platforms X11, Wayland, and one without a display for reports; OpenGL under X11 by GLX or EGL; the renderer of Qt3D;
#   pictures and icons; dialogs of the desktop through its portal; input methods of Chinese among others.
plugins='
platforms/libqxcb.so
platforms/libqoffscreen.so
platforms/libqwayland-egl.so
platforms/libqwayland-generic.so
wayland-shell-integration/libxdg-shell.so
wayland-graphics-integration-client/libqt-plugin-wayland-egl.so
wayland-decoration-client/libbradient.so
xcbglintegrations/libqxcb-egl-integration.so
xcbglintegrations/libqxcb-glx-integration.so
renderers/libopenglrenderer.so
imageformats/libqgif.so
imageformats/libqico.so
imageformats/libqjpeg.so
imageformats/libqsvg.so
iconengines/libqsvgicon.so
platformthemes/libqxdgdesktopportal.so?
platforminputcontexts/libcomposeplatforminputcontextplugin.so
platforminputcontexts/libibusplatforminputcontextplugin.so
platforminputcontexts/libfcitx5platforminputcontextplugin.so?
'

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
stage=$scratch/fettle
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$build/CMakeCache.txt")
architecture=$(uname -m)
mapfile -t outside < <(sed '/^#/d; /^$/d' "$here/outside.txt")

fettle_say "Collecting Fettle $version and what it needs"
cmake --install "$build" --prefix "$stage" --strip >"$scratch/install.log" 2>&1 ||
    { cat "$scratch/install.log" >&2; fettle_fail "bundle.sh: $build could not be installed; see above."; }
[ -x "$stage/bin/fettle" ] || fettle_fail "bundle.sh: $build: the program is not built there"
rm -f "$stage/share/doc/fettle/THIRD-PARTY" # that of the libraries beside the program; ours has more

mkdir -p "$stage/lib" "$stage/absent"
sources=() # the files of packages that are inside
queue=("$stage/bin/fettle")
[ ! -e "$stage/lib/fettle/libfettle_simulator.so" ] || queue+=("$stage/lib/fettle/libfettle_simulator.so")
plugin_folder=$(qmake6 -query QT_INSTALL_PLUGINS)
for plugin in $plugins; do
    from=$plugin_folder/${plugin%\?}
    if [ ! -e "$from" ]; then
        [ "$plugin" != "${plugin%\?}" ] ||
            fettle_fail "bundle.sh: $from is missing; the tables in prepare.sh have its package"
        continue
    fi
    mkdir -p "$stage/plugins/${plugin%/*}"
    install -m 755 "$from" "$stage/plugins/${plugin%\?}"
    sources+=("$from")
    queue+=("$stage/plugins/${plugin%\?}")
done
translations=$(qmake6 -query QT_INSTALL_TRANSLATIONS)
mkdir -p "$stage/translations"
for language in "$fettle_root"/translations/fettle_*.ts; do
    language=${language##*/fettle_}
    from=$translations/qtbase_${language%.ts}.qm
    [ -e "$from" ] || continue # English has none
    cp "$from" "$stage/translations/"
    sources+=("$from")
done

# Follows what each file needs. What is outside goes to absent, with what only that needs.
declare -A is_outside is_used is_inside where # by soname; where: its file in this system
for name in "${outside[@]}"; do is_outside[$name]=1; done
PATH=$PATH:/usr/sbin:/sbin ldconfig -p >"$scratch/libraries"
kind=$(sed -n 's/^\tlibQt6Core\.so\.6 \(([^)]*)\) => .*/\1/p' "$scratch/libraries")
while read -r name file; do
    where[$name]=$file
done < <(awk -v kind="$kind" '$2 == kind {print $1, $4}' "$scratch/libraries")
find_needed() # FILE: sets `needed`, sonames of all that it names
{
    local name
    mapfile -t needed < <(readelf -d "$1" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p')
    for name in "${needed[@]}"; do
        [ -n "${where[$name]-}" ] || [[ $name = ld-linux* ]] ||
            fettle_fail "bundle.sh: ${1#"$stage/"} needs $name, which is not installed"
    done
}
copy() # NAME FOLDER
{
    install -m 755 "${where[$1]}" "$stage/$2/$1"
    sources+=("${where[$1]}")
    is_inside[$1]=1
    queue+=("$stage/$2/$1")
}
for ((i = 0; i < ${#queue[@]}; ++i)); do
    find_needed "${queue[i]}"
    if [[ " ${needed[*]} " = *" libOpenGL.so.0 "* ]]; then # outside.txt says why
        patchelf --replace-needed libOpenGL.so.0 libGL.so.1 "${queue[i]}"
        find_needed "${queue[i]}"
    fi
    for name in "${needed[@]}"; do
        if [ -n "${is_outside[$name]-}" ]; then
            is_used[$name]=1
        elif [ -z "${is_inside[$name]-}" ]; then
            copy "$name" lib
        fi
    done
done
queue=()
absent=("${!is_used[@]}")
for ((i = 0; i < ${#absent[@]}; ++i)); do
    name=${absent[i]}
    case $name in # every Linux has them, and the first ones cannot be there a second time
        ld-linux* | libc.so.* | libm.so.* | libdl.so.* | libpthread.so.* | librt.so.* | libresolv.so.*) continue ;;
        libgcc_s.so.* | libstdc++.so.*) continue ;;
    esac
    [ -z "${is_inside[$name]-}" ] || continue
    copy "$name" absent
    find_needed "$stage/absent/$name"
    absent+=("${needed[@]}")
done
# For the sentence that names what a system lacks: soname and package.
for file in "$stage"/absent/*; do
    file=${where[${file##*/}]#/usr}
    printf '%s\n' "$file" "/usr$file"
done | xargs dpkg-query -S 2>/dev/null | sed 's/^\([^:,]*\)[:,].* .*\//\1 /' | awk '{print $2, $1}' |
    LC_ALL=C sort -u >"$scratch/packages" || true
mv "$scratch/packages" "$stage/absent/"

# Each file finds the others by its own place (DT_RPATH, which goes before LD_LIBRARY_PATH: that of Steam or of another
# program may have other libraries of these names). The environment stays as it is, so nothing leaks into programs that
# Fettle starts.
set_path() # PATH FILE...
{
    local path=$1 file
    shift
    for file; do
        [ ! -f "$file" ] || patchelf --force-rpath --set-rpath "$path" "$file"
    done
}
# shellcheck disable=SC2016 # $ORIGIN is for the loader
{
    set_path '$ORIGIN/../lib' "$stage/bin/fettle"
    set_path '$ORIGIN' "$stage"/lib/*
    set_path '$ORIGIN/..' "$stage"/lib/fettle/*.so
    set_path '$ORIGIN/../../lib' "$stage"/plugins/*/*
}
cat >"$stage/bin/qt.conf" <<'END'
[Paths]
Prefix=..
Plugins=plugins
Translations=translations
END
ln -s bin/fettle "$stage/fettle"

"$here/../third_party.sh" "$version" "$stage/THIRD-PARTY" "${sources[@]}"
mv "$stage/share/doc/fettle/copyright" "$stage/LICENSE"

# The newest versions of the C and C++ libraries that a file inside asks for.
{ find "$stage/bin" "$stage/lib" "$stage/plugins" -type f -exec readelf -V {} + 2>/dev/null || true; } |
    grep -o 'Name: GLIBC[A-Z]*_[23][.0-9]*' | sort -Vu >"$scratch/versions"
glibc=$(sed -n 's/.* GLIBC_//p' "$scratch/versions" | tail -n 1)
glibcxx=$(sed -n 's/.* GLIBCXX_//p' "$scratch/versions" | tail -n 1)

# The same files give the same archive: sorted, without owners, with the time of the commit.
when=$(git -C "$fettle_root" log -1 --format=%ct 2>/dev/null || stat -c %Y "$fettle_root/CMakeLists.txt")
tar -C "$stage" --sort=name --owner=0 --group=0 --numeric-owner --mode=u+w,go=rX --mtime="@$when" -cf - . |
    gzip -6n >"$scratch/archive"
sum=$(sha256sum "$scratch/archive")
sum=${sum%% *}

# The text in front says how long it is itself.
head()
{
    sed -e "s/@VERSION@/$version/g; s/@ARCHITECTURE@/$architecture/g; s/@GLIBC@/$glibc/g" \
        -e "s/@GLIBCXX@/$glibcxx/g; s/@SUM@/$sum/g; s|@LOADER@|$loader|g" \
        -e "s/@ROOM@/$room/g; s/@FILES@/$files/g; s/@SIZE@/$1/g" "$here/start.sh"
}
files=$(find "$stage" ! -type d | wc -l)
room=$(($(du -sk "$stage" | cut -f1) / 1000))
loader=$(patchelf --print-interpreter "$stage/bin/fettle")
size=$(head 0000 | wc -c)
[ "${#size}" = 4 ] || fettle_fail "bundle.sh: start.sh has $size bytes, and has to have 1000 to 9999"
mkdir -p "$folder"
file=$folder/fettle-$version-linux-$architecture.run
{
    head "$size"
    cat "$scratch/archive"
} >"$file.part"
chmod 755 "$file.part"
mv "$file.part" "$file"
fettle_say "$file: $(($(stat -c %s "$file") / 1000000)) MB, needs glibc $glibc"
printf '%s\n' "$file"
