#!/usr/bin/env bash
# Fettle on a bare Debian 12: installs what is missing, builds, starts.
#   ./run.sh [FILE]          opens the window, with FILE in it
#   ./run.sh check FILE ...  and every other argument goes to the program
#   ./run.sh --build-only    stops after the build; the program is build/release/fettle
set -euo pipefail
. "$(dirname "$(readlink -f "$0")")/resources/packaging/prepare.sh"

fettle_install "$fettle_build_packages" release -DBUILD_TESTING=OFF
fettle_lock
fettle_is_configured release || fettle_configure release -DBUILD_TESTING=OFF
fettle_build release fettle
fettle_unlock

[ "${1-}" != --build-only ] || exit 0

# A bare system has no locale: Qt then warns and cannot read file names beyond ASCII.
[ -n "${LC_ALL-}${LC_CTYPE-}${LANG-}" ] || export LC_ALL=C.UTF-8
exec "$fettle_root/build/release/fettle" "$@"
