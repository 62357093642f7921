#!/usr/bin/env bash
# Runs a program on a display of its own, without a screen and with a window manager: programs side by side take no focus from each other.
#   with_display.sh PROGRAM [ARGUMENTS]
set -uo pipefail
place=$(mktemp -d)
trap 'kill $(jobs -p) 2>/dev/null; wait; rm -rf "$place"' EXIT
mkfifo "$place/display" "$place/managed"

Xvfb -displayfd 3 -screen 0 1600x1000x24 -nolisten tcp 3>"$place/display" 2>"$place/said" &
read -r number <"$place/display" || {
    cat "$place/said" >&2
    exit 1
}
# One thread draws: tests run side by side anyway, and more threads cost more than they bring in small windows.
export DISPLAY=:$number LIBGL_ALWAYS_SOFTWARE=1 LP_NUM_THREADS=0
unset WAYLAND_DISPLAY
openbox --startup "sh -c 'echo >$place/managed'" >/dev/null 2>&1 &
read -r -t 60 <>"$place/managed" || {
    echo "with_display.sh: openbox does not start" >&2
    exit 1
}

"$@"
