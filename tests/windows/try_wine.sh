#!/usr/bin/env bash
# Tries the program for Windows under Wine: whether it writes what the program of this system writes, bit for bit,
# whether its window sculpts, saves, recovers and enters VR, and whether it is installed and removed.
#   tests/windows/try_wine.sh [ZIP [PROGRAM]]
# ZIP is by default what resources/packaging/windows/build.sh made; PROGRAM is build/release/fettle. One line for each
# trial. Status 1: one of them failed.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "$0")")/../.." && pwd)
skip() { echo "SKIP: $*"; exit 77; }
wine=$(command -v wine64 || echo /usr/lib/wine/wine64)
server=$(command -v wineserver || echo /usr/lib/wine/wineserver)
[ -x "$wine" ] || skip "Wine is not installed (Debian package wine64)"
for tool in Xvfb openbox xdotool import unzip; do
    command -v "$tool" >/dev/null || skip "$tool is not installed"
done
if [ "${1-}" != --shown ]; then
    exec "$root/tests/support/with_display.sh" "$0" --shown "$@"
fi
shift
. "$root/tests/support/expect.sh"
trap 'rm -rf "$scratch"' EXIT
zip=$(readlink -f "${1:-$(ls -t "$root"/build/windows/package/fettle-*-windows-x86_64.zip | head -n 1)}")
program=$(readlink -f "${2:-$root/build/release/fettle}")
export WINEPREFIX=$scratch/wine WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml,winemenubuilder.exe=' LC_ALL=C.UTF-8
export HOME=$scratch/home
unset LANGUAGE XDG_CONFIG_HOME XDG_DATA_HOME XDG_STATE_HOME XDG_CACHE_HOME
mkdir "$HOME"
trap '"$server" -k 2>/dev/null || true; rm -rf "$scratch"' EXIT

"$wine" wineboot -i >/dev/null 2>&1
unzip -q "$zip" -d "$scratch/unpacked"
folder=$(echo "$scratch"/unpacked/*)
# A name with a space and Chinese
mv "$folder" "$scratch/ein Ordner 文件夹"
folder="$scratch/ein Ordner 文件夹"
here() { "$program" "$@"; }
there() { timeout 300 "$wine" "$folder/fettle.com" "$@"; }

done=0
told() { printf '%-8s %s\n' "$1" "$2"; done=$((done + 1)); }
# tried WHAT COMMAND: one line, whether the command succeeds.
tried()
{
    local what=$1
    shift
    if "$@" >"$scratch/said" 2>&1; then
        told ok "$what"
    else
        told FAIL "$what"
        head -n 8 "$scratch/said"
        failed=1
    fi
}

# same [STATUS] WHAT ARGUMENTS: both programs end with the status, which is 0 if it is not given, print the same, and
# leave the same files. Only the separators of paths and the time taken may differ.
for side in here there; do
    mkdir -p "$scratch/$side/class/film"
    cp -r "$root"/resources/{lessons,brushes} "$root"/tests/app/tetrahedron.dae "$scratch/$side/class"
    cat >"$scratch/$side/class/strokes.json" <<'END'
{"format": "fettle-strokes", "version": 1, "strokes": [
  {"tool": "pull", "radius": 8, "samples": [{"position": [50, 0, 0]}, {"position": [51, 3, 0]}]},
  {"tool": "snake", "radius": 6,
   "samples": [{"position": [0, 50, 0]}, {"position": [0, 60, 5]}, {"position": [0, 70, 0]}]},
  {"tool": "smooth", "radius": 9, "samples": [{"position": [50, 3, 0]}, {"position": [50, 0, 3]}]}]}
END
    printf '%s\n' 'solid broken' 'facet normal 0 0 1' 'outer loop' 'vertex 0 0 0' 'vertex 1 0 0' \
        >"$scratch/$side/class/broken.stl"
done
same()
{
    local expected=0 what side
    if [[ $1 = [0-9] ]]; then
        expected=$1
        shift
    fi
    what=$1
    shift
    for side in here there; do
        local status=0
        (cd "$scratch/$side/class" && "$side" "$@" >"$scratch/$side.out" 2>"$scratch/$side.err") || status=$?
        sed -i 's#\\#/#g; s/Time: [0-9.]* s/Time/' "$scratch/$side.out" "$scratch/$side.err"
        echo "$status" >"$scratch/$side.status"
    done
    local part
    if [ "$(cat "$scratch/here.status")" != "$expected" ]; then
        told FAIL "$what: status $(cat "$scratch/here.status") on this system"
        head -n 8 "$scratch/here.err"
        failed=1
        return 0
    fi
    for part in status out err; do
        if ! cmp -s "$scratch/here.$part" "$scratch/there.$part"; then
            told FAIL "$what: $part differs"
            diff -a "$scratch/here.$part" "$scratch/there.$part" | head -n 8 | cut -c1-200 || true
            failed=1
            return 0
        fi
    done
    if ! diff -r "$scratch/here" "$scratch/there" >"$scratch/difference"; then
        told FAIL "$what: files differ"
        head -n 8 "$scratch/difference" | cut -c1-200
        failed=1
        return 0
    fi
    told ok "$what (status $(cat "$scratch/here.status"))"
}

same "help" --help
same "help of a command" help convert
for shape in ball cube torus vase head tablet; do
    same "new $shape" new "$shape" "$shape.stl"
done
same "check" check ball.stl head.stl
same "check --print --json" check --print --json vase.stl
same 2 "check of a folder" check --csv .
for format in obj ply off glb 3mf; do
    same "convert to $format" convert head.stl "head.$format"
    same "convert from $format" convert "head.$format" "head-$format.stl"
done
same "convert with fewer triangles" convert head.stl small.glb --triangles 500
same "a foreign format, read by a process of its own" convert tetrahedron.dae tetrahedron.stl
same 2 "a file that is not whole" check broken.stl
same 2 "a file that is not there" check nowhere.stl
same "a name in Chinese" convert ball.stl 球.obj
same 2 "a file that cannot be repaired" convert broken.stl repaired.stl --repair
same "replay" replay --strokes strokes.json --in ball.stl --out sculpted.stl
same "replay with pictures" replay --strokes strokes.json --in ball.stl --frames film
same "boolean union" boolean union ball.stl cube.stl -o both.glb
same "boolean subtract" boolean subtract cube.stl ball.stl -o rest.obj
for lesson in first-clay mug creature toy-car; do
    same "lesson $lesson" lesson "$lesson" --json -o "$lesson.glb"
done
same "lesson of a folder, packed" lesson lessons/mug --pack mug.zip
same "lesson, its pages" lesson mug --texts --language de
same "brush" brush scales
same "brush --picture" brush scales --picture scales.png
for side in here there; do
    (cd "$scratch/$side/class" && mkdir models && cp ball.stl head.obj vase.stl models &&
        "$side" report models -o models.html && "$side" sheet head.stl vase.stl -o sheet.pdf) >/dev/null 2>&1 || true
done
tried "report writes a page" test -s "$scratch/here/class/models.html" -a -s "$scratch/there/class/models.html"
# The languages of the two systems write dates, and sort names, by rules of their own.
tried "the pages are the same" diff <(grep -v 'print-ready: ' "$scratch/here/class/models.html") \
    <(grep -v 'print-ready: ' "$scratch/there/class/models.html")
tried "sheet writes a PDF" test "$(head -c 5 "$scratch/there/class/sheet.pdf")" = %PDF-

# --- the window
pictures=$root/build/windows/screenshots
mkdir -p "$pictures"
titled() { xdotool search --onlyvisible --name "$1"; }
opened() { "$wine" "$folder/fettle.exe" "$@" & disown; }
killed()
{
    pkill -9 -f "${scratch##*/}.*fettle[.]exe" || true
    "$server" -k9 || true
    "$server" -w
    wait_for 20 bash -c '! xdotool search --onlyvisible --name Fettle'
}
# A picture, after the window has come to rest
picture() { sleep 8; import -window root "$pictures/$1.png"; }
drag()
{
    xdotool mousemove 800 480 mousedown 1 mousemove_relative --sync 40 -40 mousemove_relative --sync 40 -40 mouseup 1
}
cd "$scratch/there/class"
cp ball.stl clay.stl
opened clay.stl
tried "the window opens" wait_for 60 titled '^clay.stl – Fettle$'
picture window
drag
tried "a drag sculpts" wait_for 20 titled '^clay.stl\* – Fettle$'
picture sculpted
xdotool key ctrl+s
tried "Ctrl+S saves" wait_for 20 titled '^clay.stl – Fettle$'
tried "the file is not what it was" bash -c '! cmp -s ball.stl clay.stl'
tried "it is print-ready" here check clay.stl
cp clay.stl saved.stl
drag
tried "another drag" wait_for 20 titled '^clay.stl\* – Fettle$'
sleep 3 # the journal is written once a second
killed
opened clay.stl
tried "after a kill it opens again" wait_for 60 titled '^clay.stl – Fettle$'
picture recovery
xdotool key alt+o
tried "Recover brings the stroke back" wait_for 20 titled '^clay.stl\* – Fettle$'
picture recovered
tried "the file is as it was saved" cmp saved.stl clay.stl
killed
# Wine starts programs as administrator, and then OpenXR's loader does not use XR_RUNTIME_JSON. It takes paths in the
# code page of the system, which the program's manifest makes UTF-8 since Windows 10 of 2019, and not under Wine 8.
cp -r "$folder" "$scratch/plain"
folder=$scratch/plain
"$wine" reg add 'HKLM\SOFTWARE\Khronos\OpenXR\1' /v ActiveRuntime /f \
    /d "$("$wine" winepath -w "$folder/lib/fettle/fettle_simulator.json" | tr -d '\r')" >/dev/null || true
opened --vr-simulator clay.stl
tried "the simulator's window opens" wait_for 60 titled '^VR Simulator$'
picture simulator
killed

# --- the installer, which lies beside the zip
setup=${zip%.zip}.exe
place=$("$wine" winepath -u 'C:\users\'"$(id -un)"'\AppData\Local\Programs\Fettle')
key='HKCU\Software\Microsoft\Windows\CurrentVersion\Uninstall\Fettle'
knows() { "$wine" reg query "$key" /v UninstallString; }
ends_with() { local status=0; timeout 120 "${@:2}" || status=$?; [ $status = "$1" ]; }
tried "it installs without questions" ends_with 0 "$wine" "$setup" /S
tried "what it installs runs" "$wine" "$place/fettle.com" check "$scratch/there/class/ball.stl"
tried "Windows knows how to remove it" knows
tried "models are offered to be opened with it" \
    "$wine" reg query 'HKCU\Software\Classes\.stl\OpenWithProgids' /v Fettle.Model
cp "$scratch/there/class/ball.stl" "$place" || true
tried "it installs over itself" ends_with 0 "$wine" "$setup" /S
"$wine" "$place/fettle.exe" & disown
tried "it opens a window" wait_for 60 titled 'Fettle$'
tried "nothing is installed while it runs" ends_with 2 "$wine" "$setup" /S
tried "all of it is still there" test -e "$place/fettle.exe" -a -e "$place/fettle.com" -a -e "$place/Qt6Core.dll"
killed
"$wine" "$place/uninstall.exe" /S || true
tried "Windows knows it no more" wait_for 20 bash -c '! "$@"' - "$wine" reg query "$key"
tried "a model in its folder is all that stays" wait_for 20 bash -c '[ "$(ls "$1")" = ball.stl ]' - "$place"
echo "$done trials; pictures: $pictures"
exit $failed
