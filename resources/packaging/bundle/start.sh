#!/bin/sh
# Fettle @VERSION@ for Linux (@ARCHITECTURE@): this text, and behind it an archive (tar.gz) with the program and what it
# needs.
#   THIS_FILE [ARGUMENTS]                starts Fettle with these arguments
#   THIS_FILE --bundle-extract FOLDER    unpacks it into a new folder; FOLDER/fettle starts it then
# The first start unpacks into the user's cache, later ones start from there; a temporary folder serves where that
# cannot be written. The environment of the program stays as it was, except for LD_LIBRARY_PATH where the system lacks
# libraries of a desktop.
set -u
sum=@SUM@ # SHA-256 of the archive
size=@SIZE@ # bytes of this text

fail()
{
    printf 'fettle: %s\n' "$*" >&2
    exit 3
}

archive() { tail -c +$((size + 1)) "$self"; }
# unpack FOLDER: into a folder that is there. Its time becomes that of now, by which the removal below knows its age.
unpack() { archive | tar -xzmf - -C "$1"; }

check_archive()
{
    found=$(archive | sha256sum)
    [ "${found%% *}" = "$sum" ] ||
        fail "$self is damaged or not complete: its archive is not the one that was packed. Copy it anew"
}

# is_used FOLDER: whether a program runs from there.
is_used()
{
    [ -e /proc/self/exe ] || return 0
    # shellcheck disable=SC2010 # one process for all of them
    ls -l /proc/[0-9]*/exe 2>/dev/null | grep -qF -e " -> $(cd "$1" 2>/dev/null && pwd -P)/"
}

# look FOLDER: asks the loader what the program there needs. Sets `missing`, the libraries that the system lacks, and
# `problem`, what else is wrong.
look()
{
    missing=
    problem="there is no @LOADER@"
    [ -x @LOADER@ ] || return
    problem="files are missing in $1"
    [ "$(find "$1" ! -type d | wc -l)" -eq @FILES@ ] || return
    said=$(for object in lib/libQt6Gui.so.6 ${DISPLAY:+plugins/platforms/libqxcb.so}; do
        LD_TRACE_LOADED_OBJECTS=1 @LOADER@ "$1/$object" 2>&1
    done)
    problem=$(printf '%s\n' "$said" | grep 'version .* not found\|error while loading' | head -n 1)
    for name in $(printf '%s\n' "$said" | sed -n 's/^[[:space:]]*\([^ ]*\) => not found.*/\1/p' | sort -u); do
        if [ -e "$1/absent/$name" ]; then
            missing="$missing $name"
        else
            problem="$1/lib/$name is missing"
        fi
    done
}

# try FOLDER: looks, and starts the program there for its version, unless start() will refuse it.
try()
{
    look "$1"
    [ -z "$problem" ] || return
    [ -z "$missing" ] || [ -z "${DISPLAY-}${WAYLAND_DISPLAY-}" ] || return
    said=$(run "$1" --version 2>&1) || problem=${said:-the program ends with status $?}
}

# run FOLDER ARGUMENTS: becomes the program there. (An empty part of LD_LIBRARY_PATH would be the working directory.)
run()
{
    folder=$1
    shift
    if [ -n "$missing" ]; then
        LD_LIBRARY_PATH=$folder/absent${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
        export LD_LIBRARY_PATH
    fi
    exec "$folder/bin/fettle" "$@"
}

# start FOLDER ARGUMENTS
start()
{
    if [ -n "$missing" ]; then
        # With a desktop, its driver would meet our older copies. Without one, no driver draws, and no other program is
        # started that the variable could lead astray.
        [ -z "${DISPLAY-}${WAYLAND_DISPLAY-}" ] ||
            fail "this system has no$missing, parts of its desktop or graphics driver. On Debian and Ubuntu:" \
                "apt install$(for name in $missing; do sed -n "s/^$name / /p" "$1/absent/packages"; done |
                    sort -u | tr -d '\n') libgl1-mesa-dri"
    fi
    run "$@"
}

[ "$(uname -m)" = @ARCHITECTURE@ ] || fail "this file is for @ARCHITECTURE@, and this machine is $(uname -m)"
case $0 in
    */*) self=$0 ;;
    *) self=./$0 ;;
esac
[ -r "$self" ] || fail "$self cannot be read, so the program in it cannot be unpacked"

if [ "${1-}" = --bundle-extract ]; then
    [ $# -eq 2 ] || fail "--bundle-extract needs one folder, which it makes"
    check_archive
    place=$2
    mkdir "$place" 2>/dev/null || fail "$place cannot be made: it has to be a new folder in one that can be written"
    trap 'rm -rf "$place"; exit 3' HUP INT TERM
    umask 022
    unpack "$place" && exit 0
    rm -rf "$place"
    fail "the program could not be unpacked into $place; what tar said is above"
fi

case ${XDG_CACHE_HOME-} in
    /*) cache=$XDG_CACHE_HOME/Fettle/bundle ;;
    *) cache=${HOME:-/dev/null}/.cache/Fettle/bundle ;;
esac
place=$cache/$(printf %.16s "$sum")
# Only what this user unpacked is started.
if [ -O "$place" ]; then
    look "$place"
    if [ -z "$problem" ]; then
        touch -c "$place" 2>/dev/null
        start "$place" "$@"
    fi
    is_used "$place" || rm -rf "$place" 2>/dev/null # files were removed from it, or none may be started there
fi

check_archive
if mkdir -p "$cache" 2>/dev/null && part=$(mktemp -d "$cache/part-XXXXXX" 2>/dev/null); then
    trap 'rm -rf "$part"; exit 3' HUP INT TERM
    if unpack "$part" 2>/dev/null; then
        try "$part"
        if [ -z "$problem" ]; then
            sync -f "$part" 2>/dev/null        # otherwise a power cut may leave empty files under the final name
            mv -T "$part" "$place" 2>/dev/null # fails where another start was faster
            # Removes versions that were not started for a month, and what a killed start left half unpacked.
            find "$cache" -mindepth 1 -maxdepth 1 \( -mtime +30 -o -name 'part-*' -mtime +0 \) |
                while IFS= read -r old; do
                    is_used "$old" || rm -rf "$old"
                done
        fi
    fi
    rm -rf "$part"
    trap - HUP INT TERM
    if [ -O "$place" ]; then
        look "$place" # perhaps it is another start's, or a damaged one that is in use
        [ -n "$problem" ] || start "$place" "$@"
    fi
fi

# The cache cannot be written, is full, or programs may not be started there: this once, from a temporary folder.
place=$(mktemp -d "${TMPDIR:-/tmp}/fettle-XXXXXX" 2>/dev/null) ||
    fail "the program could be unpacked neither into $cache nor into ${TMPDIR:-/tmp}"
trap 'rm -rf "$place"; exit 3' HUP INT TERM
if ! unpack "$place" 2>/dev/null; then
    rm -rf "$place"
    fail "the program could be unpacked neither into $cache nor into ${TMPDIR:-/tmp}; it takes @ROOM@ MB"
fi
try "$place"
if [ -n "$problem" ]; then
    rm -rf "$place"
    fail "Fettle cannot run here ($(printf '%s\n' "$problem" | head -n 1)). It needs glibc @GLIBC@ and a libstdc++" \
        "with GLIBCXX_@GLIBCXX@, or newer ones, and a folder of which programs may be started"
fi
trap - HUP INT TERM
# Removes the folder as soon as no program runs from it.
(
    trap '' HUP INT TERM
    while
        sleep 2
        is_used "$place"
    do :; done
    rm -rf "$place"
) </dev/null >/dev/null 2>&1 &
start "$place" "$@"
