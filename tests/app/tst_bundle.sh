#!/usr/bin/env bash
# The bundle holds all that it needs, or outside.txt names it. It starts in any folder, for any user, and at any moment.
#   tst_bundle.sh SOURCE_DIR BUILD_DIR
set -euo pipefail
source=$1
build=$2
bundle=$source/resources/packaging/bundle
. "$(dirname "$0")/../support/expect.sh"
trap 'kill $(jobs -p) 2>/dev/null || true; chmod -R u+w "$scratch"; rm -rf "$scratch"' EXIT

# refuses WORDS COMMAND: it ends with status 3, and one line that has these words.
refuses()
{
    local words=$1 status=0
    shift
    "$@" >"$scratch/out" 2>"$scratch/err" || status=$?
    cat "$scratch/out" "$scratch/err"
    [ $status = 3 ] && [ ! -s "$scratch/out" ] && [ "$(wc -l <"$scratch/err")" = 1 ] &&
        grep -qF -e "$words" "$scratch/err"
}

# A name with spaces and Chinese.
place="$scratch/ein Ordner 文件夹"
mkdir "$place"
made=$("$bundle/bundle.sh" "$build" "$place")
file=$place/$(basename "$made")
expect "bundle.sh says which file it made" test -x "$file"

# The bundle has all that it needs inside.
folder="$scratch/aus gepackt 解"
expect "--bundle-extract unpacks" "$file" --bundle-extract "$folder"
for inside in fettle bin/fettle bin/qt.conf lib/fettle/libfettle_simulator.so lib/fettle/fettle_simulator.json LICENSE \
    THIRD-PARTY lib/libQt6Core.so.6 lib/libOpenMeshCore.so.[0-9]* lib/libassimp.so.5 lib/libdraco.so.[0-9]* \
    lib/libzip.so.[0-9]* absent/libexpat.so.1 lib/libopenxr_loader.so.1 plugins/platforms/libqxcb.so \
    plugins/platforms/libqwayland-egl.so plugins/iconengines/libqsvgicon.so plugins/renderers/libopenglrenderer.so \
    translations/qtbase_de.qm translations/qtbase_zh_CN.qm; do
    expect "the bundle has $inside" bash -c 'cd "$1" && ls $2' - "$folder" "$inside"
done
outside=$(sed '/^#/d; /^$/d' "$bundle/outside.txt")
while read -r library; do
    name=${library#"$folder/"}
    dynamic=$(readelf -d "$library")
    while read -r needed; do
        [ -e "$folder/lib/$needed" ] || [[ $'\n'$outside$'\n' = *$'\n'$needed$'\n'* ]] ||
            fail "$name needs $needed, which is neither inside nor in outside.txt"
    done < <(sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' <<<"$dynamic")
    path=$(sed -n 's/.*(RPATH).*\[\(.*\)\]/\1/p' <<<"$dynamic")
    [ "$(realpath -m "${path/\$ORIGIN/${library%/*}}")" = "$folder/lib" ] ||
        fail "$name does not look in lib by its own place, but in \"$path\""
    [[ $name = bin/fettle || $name = lib/fettle/* ]] || grep -qE -e " ${name##*/}( |\$)" "$folder/THIRD-PARTY" ||
        fail "$name is not in THIRD-PARTY"
done < <(find "$folder/bin" "$folder/lib" "$folder/plugins" -type f \( -name '*.so*' -o -perm -u+x \))
while read -r name; do
    [ ! -e "$folder/lib/$name" ] || fail "$name is inside, although outside.txt names it"
done <<<"$outside"
for library in "$folder"/absent/*.so*; do
    name=${library##*/}
    grep -q "^$name [a-z]" "$folder/absent/packages" || fail "no package is known for $name in absent"
    grep -qE -e " $name( |\$)" "$folder/THIRD-PARTY" || fail "$name in absent is not in THIRD-PARTY"
done
expect "no licence is missing that THIRD-PARTY refers to" bash -c '
    grep -oE "/usr/share/common-licenses/[A-Za-z0-9.+-]*[A-Za-z0-9]" "$1" | sort -u | while read -r path; do
        [ ! -r "$path" ] || grep -qxF -e "Common licence: ${path##*/}" "$1" || { echo "$path"; exit 1; }
    done' - "$folder/THIRD-PARTY"

# Headers are compiled in, so their packages are in THIRD-PARTY, too. Not the C library, the compiler, the kernel, and
# the declarations of OpenGL and X11.
if [ -e "$build/build.ninja" ] && ninja -C "$build" -t deps >"$scratch/deps" 2>/dev/null; then
    mapfile -t headers < <(
        awk '/^[^ ]/ {ours = /^(core|ui|vr|app)\//} ours && $1 ~ /^\/usr\// {print $1}' "$scratch/deps" | sort -u |
            xargs -r realpath -qe | sort -u)
    dpkg-query -S "${headers[@]}" 2>/dev/null | sed 's/[,:].*//' | sort -u >"$scratch/packages" || true
    expect "the build knows its headers" test -s "$scratch/packages"
    xargs dpkg-query -W -f='${source:Package}\n' <"$scratch/packages" | sort -u |
        grep -vE '^(glibc|gcc-[0-9]+|linux|libglvnd|mesa|libx11|xorgproto|libxcb)$' >"$scratch/headers"
    while read -r name; do
        expect "the headers of $name are compiled in, so THIRD-PARTY has it" \
            grep -q "^    $name " "$folder/THIRD-PARTY"
    done <"$scratch/headers"
fi

# at HOME COMMAND: with the least environment, from another folder. clean: with the first home.
home=$scratch/home
mkdir "$home"
at() { (cd / && exec env -i HOME="$1" PATH=/usr/bin:/bin "${@:2}"); }
clean() { at "$home" "$@"; }
cat >"$scratch/strokes.json" <<'END'
{"format": "fettle-strokes", "version": 1, "strokes": [
  {"tool": "pull", "radius": 8, "samples": [{"position": [25, 0, 0]}, {"position": [26, 1, 0]}]}]}
END
four_at_once()
{
    local pids=() pid
    for _ in 1 2 3 4; do
        clean "$file" --version &
        pids+=($!)
    done
    for pid in "${pids[@]}"; do
        wait "$pid" || return 1
    done
}
expect "four first starts at once" four_at_once
expect "they leave one folder" test "$(ls -A "$home/.cache/Fettle/bundle" | wc -l)" = 1
unpacked=$(echo "$home"/.cache/Fettle/bundle/*)
expect "new" clean "$file" new ball "$scratch/ball.stl"
expect "check" clean "$file" check "$scratch/ball.stl"
played=(replay --strokes "$scratch/strokes.json" --in "$scratch/ball.stl" --out)
expect "replay" clean "$file" "${played[@]}" "$scratch/inside.stl"
"$build/fettle" "${played[@]}" "$scratch/built.stl" >/dev/null
expect "it makes the same bits as the program that was built" cmp "$scratch/inside.stl" "$scratch/built.stl"
expect "a drawing, without a display" clean "$file" sheet "$scratch/ball.stl" -o "$scratch/sheet.pdf"
expect "a foreign format, which it reads in a child of its own" \
    clean "$file" check "$source/tests/app/tetrahedron.dae"
expect "started by its unpacked folder" clean "$folder/fettle" check "$scratch/ball.stl"
ln -s "$folder/fettle" "$scratch/a link"
expect "started by a link" clean "$scratch/a link" check "$scratch/ball.stl"
status=0
clean "$file" check "$scratch/no such file.stl" >/dev/null 2>&1 || status=$?
expect "the exit status is the program's" test $status = 2
expect "later starts unpack nothing" test "$(echo "$home"/.cache/Fettle/bundle/*)" = "$unpacked"

# Others' libraries of the same names are not taken.
mkdir "$scratch/others"
echo "no library" >"$scratch/others/libQt6Core.so.6"
expect "LD_LIBRARY_PATH of others" clean LD_LIBRARY_PATH="$scratch/others" "$file" check "$scratch/ball.stl"

# A system without its desktop: here a loader that does not find them, by names that no system has.
bare=$scratch/bare
mkdir -p "$bare/.cache/Fettle"
cp -a "$home/.cache/Fettle/bundle" "$bare/.cache/Fettle/"
entry=$(echo "$bare"/.cache/Fettle/bundle/*)
sed 's/libX11\.so\.6/libX_1.so.6/g' "$entry/lib/libQt6Gui.so.6" >"$scratch/gui"
cat "$scratch/gui" >"$entry/lib/libQt6Gui.so.6"
mv "$entry/absent/libX11.so.6" "$entry/absent/libX_1.so.6"
echo "libX_1.so.6 libx11-6" >>"$entry/absent/packages"
expect "commands without a desktop take what is absent" \
    at "$bare" "$file" check "$scratch/ball.stl"
says="this system has no libX_1.so.6, parts of its desktop or graphics driver. On Debian and Ubuntu:"
expect "with a display it says what the desktop lacks" refuses "$says apt install libx11-6 libgl1-mesa-dri" \
    at "$bare" DISPLAY=:77 "$file" check "$scratch/ball.stl"
rm "$entry/lib/libassimp.so.5"
expect "what was removed from the cache is unpacked again" \
    at "$bare" DISPLAY=:77 "$file" check "$scratch/ball.stl"
expect "and is there then" test -e "$entry/lib/libassimp.so.5"

# Versions of long ago go when a new one comes, if they do not run; what a killed start left goes earlier.
mkdir "$bare/.cache/Fettle/bundle/"{old,recent,part-killed}
touch -d "40 days ago" "$bare/.cache/Fettle/bundle/old"
touch -d "2 days ago" "$bare/.cache/Fettle/bundle/"{recent,part-killed}
rm -rf "$entry"
expect "a start beside other versions" at "$bare" "$file" --version
expect "the old one is gone, the recent one is there" \
    test ! -e "$bare/.cache/Fettle/bundle/old" -a -e "$bare/.cache/Fettle/bundle/recent" -a -e "$entry/bin/fettle"
expect "what was half unpacked is gone" test ! -e "$bare/.cache/Fettle/bundle/part-killed"

# A start leaves nothing where nothing can be kept.
mkdir "$scratch/tmp"
expect "a home that cannot be written" \
    at /proc/nowhere TMPDIR="$scratch/tmp" "$file" check "$scratch/ball.stl"
for ((i = 0; i < 100; ++i)); do
    [ -n "$(ls -A "$scratch/tmp")" ] || break
    sleep 0.1
done
expect "its temporary folder is removed" test -z "$(ls -A "$scratch/tmp")"
expect "neither a home nor a temporary folder" \
    refuses "the program could be unpacked neither into /proc/nowhere/.cache/Fettle/bundle nor into /proc" \
    at /proc/nowhere TMPDIR=/proc "$file" check "$scratch/ball.stl"

# A file that was copied badly.
size=$(stat -c %s "$file")
head -c "$((size - 1000))" "$file" >"$scratch/short.run"
{ head -c "$((size / 2))" "$file"; printf 'x'; tail -c +"$((size / 2 + 2))" "$file"; } >"$scratch/wrong.run"
chmod +x "$scratch"/*.run
for bad in short wrong; do
    expect "a $bad file" refuses "$scratch/$bad.run is damaged or not complete" \
        at "$scratch" "$scratch/$bad.run" --version
done
expect "--bundle-extract into a folder that is there" \
    refuses "$folder cannot be made" "$file" --bundle-extract "$folder"
expect "--bundle-extract without a folder" refuses "--bundle-extract needs one folder" "$file" --bundle-extract

# Another user, and folders that cannot be written.
if [ "$(id -u)" = 0 ] && command -v setpriv >/dev/null; then
    chmod a+rx "$scratch"
    mkdir "$scratch/other"
    chown 65534 "$scratch/other"
    chmod -R a-w "$place" "$folder"
    as_other() { at "$scratch/other" setpriv --reuid 65534 --regid 65534 --clear-groups env "$@"; }
    expect "another user" as_other "$file" check "$scratch/ball.stl"
    expect "another user, unpacked by root" as_other "$folder/fettle" check "$scratch/ball.stl"
    expect "a user does not start what another unpacked" as_other XDG_CACHE_HOME="$home/.cache" "$file" --version
fi

# The window. What it maps is inside or the system's, and never both; its environment is what it was given.
mkdir -p "$scratch/run"
chmod 700 "$scratch/run"
env -i HOME="$home" PATH=/usr/bin:/bin DISPLAY="$DISPLAY" LIBGL_ALWAYS_SOFTWARE=1 XDG_RUNTIME_DIR="$scratch/run" \
    "$file" --vr-simulator "$scratch/ball.stl" 2>"$scratch/window" &
window=$!
for ((i = 0; i < 600; ++i)); do
    grep -q libopenglrenderer "/proc/$window/maps" 2>/dev/null && break
    sleep 0.1
done
sleep 1
expect "the window draws by Qt3D ($(cat "$scratch/window"))" \
    grep -q "$unpacked/plugins/renderers/libopenglrenderer" "/proc/$window/maps"
expect "the simulator is inside" grep -q "$unpacked/lib/fettle/libfettle_simulator" "/proc/$window/maps"
while read -r mapped; do
    [ ! -e "$unpacked/lib/${mapped##*/}" ] || fail "the window maps $mapped of the system, although it is inside, too"
    [[ $mapped != *[Qq]t* ]] || fail "the window maps $mapped, Qt of the system"
done < <(awk '$6 ~ /\.so/ {print $6}' "/proc/$window/maps" | sort -u | grep -v "^$unpacked")
tr '\0' '\n' <"/proc/$window/environ" | sed 's/=.*//' | sort | tr '\n' ' ' >"$scratch/environment"
expect "its environment is what it was given ($(cat "$scratch/environment"))" \
    grep -qx "DISPLAY HOME LIBGL_ALWAYS_SOFTWARE PATH \(PWD \)\?XDG_RUNTIME_DIR " "$scratch/environment"
kill "$window"
wait "$window" 2>/dev/null || true
exit $failed
