#!/usr/bin/env bash
# The bundle on a bare Debian of another release, without Qt: first commands on a system without any desktop, then the
# window and the simulator under Xvfb with Mesa's software OpenGL, as a user who is not root.
#   tst_bundle_chroot.sh SOURCE_DIR BUILD_DIR [RELEASE]     default: trixie (Debian 13)
# Runs where FETTLE_EFFORT is long or soak; needs root, debootstrap and the network. FETTLE_CHROOT=FOLDER keeps the
# system there for the next time. Pictures are left in BUILD_DIR/screenshots.
set -euo pipefail
source=$(realpath "$1")
build=$(realpath "$2")
release=${3-trixie}

skip()
{
    printf 'SKIP   : app/bundle_chroot: %s\n' "$*"
    exit 77
}
case ${FETTLE_EFFORT-small} in
    long | soak) ;;
    *) skip "a bare Debian is made with --long only" ;;
esac
[ "$(id -u)" = 0 ] || skip "a chroot needs root"
[ "$(. /etc/os-release && echo "${VERSION_CODENAME-}")" != "$release" ] || skip "this is $release itself"
command -v debootstrap >/dev/null || skip "debootstrap is not installed"
# With mounts and processes of its own: they end with it.
if [ -z "${FETTLE_UNSHARED-}" ]; then
    unshare --mount --pid --mount-proc --fork true 2>/dev/null || skip "this machine allows no mounts"
    FETTLE_UNSHARED=1 exec unshare --mount --pid --mount-proc --fork --kill-child "$0" "$source" "$build" "$release"
fi

. "$(dirname "$0")/../support/expect.sh"
root=${FETTLE_CHROOT:-$scratch/$release}
clean_up()
{
    # shellcheck disable=SC2046 # numbers
    kill $(jobs -p) 2>/dev/null || true
    umount -R "$root/proc" "$root/dev" 2>/dev/null || true
    rm -rf --one-file-system "$scratch"
}
trap clean_up EXIT
# shellcheck disable=SC2016 # apt-get fills this in
mirror=$(apt-get indextargets --format '$(ORIGIN) $(REPO_URI)' 'Created-By: Packages' |
    awk '$1 == "Debian" && !found++ {print $2}')
if [ ! -e "$root/etc/apt/sources.list" ]; then
    debootstrap --variant=minbase "$release" "$root" "$mirror" >"$scratch/debootstrap.log" 2>&1 || {
        tail -n 3 "$scratch/debootstrap.log"
        skip "$release could not be fetched from $mirror"
    }
fi
mkdir -p "$root/proc" "$root/dev"
mount -t proc proc "$root/proc"
mount --rbind /dev "$root/dev"

inside() { chroot "$root" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin "$@"; }
as_user=(chroot --userspec=1000:1000 "$root" env -i HOME=/home/pupil PATH=/usr/bin:/bin LANG=C.UTF-8)
user() { "${as_user[@]}" "$@"; }

"$source/resources/packaging/bundle/bundle.sh" "$build" "$scratch" >"$scratch/made"
name=$(basename "$(cat "$scratch/made")")
mkdir -p "$root/opt" "$root/home/pupil"
chown 1000:1000 "$root/home/pupil"
rm -rf "$root/home/pupil/.cache" "$root/home/pupil/.config"
cp "$scratch/$name" "$root/opt/fettle.run"
program=/opt/fettle.run
expect "there is no Qt" test -z "$(find "$root/usr" -name 'libQt*')"

# Commands, with nothing installed.
cat >"$scratch/strokes.json" <<'END'
{"format": "fettle-strokes", "version": 1, "strokes": [
  {"tool": "pull", "radius": 8, "symmetry": "x", "spacing": 0.2,
   "samples": [{"position": [25, 0, 0]}, {"position": [30, 4, 0]}]},
  {"tool": "smooth", "radius": 6, "samples": [{"position": [0, 25, 0]}]}]}
END
cp "$scratch/strokes.json" "$source/tests/app/tetrahedron.dae" "$root/home/pupil/"
cd "$scratch"
here() { "$build/fettle" "$@"; }
here new ball here.stl
here replay --strokes strokes.json --in here.stl --out here.glb >/dev/null
here convert here.glb here.obj >/dev/null
work=/home/pupil
expect "--version, the first start, in a folder with a file named as a library" \
    user sh -c 'mkdir -p "$1" && cd "$1" && echo none >libc.so.6 && exec "$2" --version' - $work/named "$program"
expect "--help" user "$program" --help
expect "new" user "$program" new ball $work/there.stl
expect "check" user "$program" check $work/there.stl
expect "replay" user "$program" replay --strokes $work/strokes.json --in $work/there.stl --out $work/there.glb
expect "convert" user "$program" convert $work/there.glb $work/there.obj
expect "a foreign format, in a sandbox" user "$program" check $work/tetrahedron.dae
for format in stl glb obj; do
    expect "the same bits in .$format" cmp "here.$format" "$root$work/there.$format"
done
sha256sum here.glb

# The window.
inside sh -c 'command -v Xvfb xdotool xwd xwdtopnm' >/dev/null || {
    inside apt-get -q update && inside DEBIAN_FRONTEND=noninteractive apt-get -q -y install --no-install-recommends \
        xvfb openbox xdotool x11-apps netpbm libgl1-mesa-dri libegl1
} >"$scratch/apt.log" 2>&1 || { tail -n 5 "$scratch/apt.log"; exit 1; }
expect "there is still no Qt" test -z "$(find "$root/usr" -name 'libQt*')"
mkdir -p "$root/tmp/.X11-unix" "$build/screenshots"
chmod 1777 "$root/tmp" "$root/tmp/.X11-unix"
user Xvfb :77 -screen 0 1600x1000x24 -nolisten tcp >"$scratch/xvfb.log" 2>&1 &
for ((i = 0; i < 100; ++i)); do
    [ ! -e "$root/tmp/.X11-unix/X77" ] || break
    sleep 0.1
done
on_display=("${as_user[@]}" DISPLAY=:77 LIBGL_ALWAYS_SOFTWARE=1)
shown() { "${on_display[@]}" "$@"; }
shown openbox >/dev/null 2>&1 &
picture() { shown sh -c 'xwd -silent -root | xwdtopnm 2>&- | pnmtopng 2>&-' >"$build/screenshots/$1.png"; }
windows() { shown xdotool search --onlyvisible --class fettle | wc -l; }
has_windows() { [ "$(windows)" -ge "$1" ]; }

"${on_display[@]}" "$program" $work/there.stl >"$scratch/window.log" 2>&1 &
window=$!
expect "the window opens" wait_for 60 has_windows 1
sleep 5
picture "bundle-$release-window"
shown xdotool mousemove 800 480 mousedown 1 mousemove_relative --sync 40 -40 mousemove_relative --sync 40 -40 mouseup 1
sleep 3
picture "bundle-$release-sculpted"
expect "a stroke changes the picture" \
    bash -c '! cmp -s "$1" "$2"' - "$build/screenshots/bundle-$release-"{window,sculpted}.png
expect "the window has nothing to complain of ($(cat "$scratch/window.log"))" test ! -s "$scratch/window.log"
kill "$window"
wait "$window" || true

"${on_display[@]}" "$program" --vr-simulator $work/there.stl >"$scratch/simulator.log" 2>&1 &
window=$!
expect "the simulator opens a second window ($(cat "$scratch/simulator.log"))" wait_for 60 has_windows 2
sleep 5
picture "bundle-$release-simulator"
kill "$window"
wait "$window" || true
exit $failed
