#!/usr/bin/env bash
# Installs what is missing, builds, and runs the whole test suite without a screen.
#   ./test.sh [--soak] [--asan | --tsan | --debug] [CTEST ARGUMENTS]
#   --soak   with the long tests
#   --asan, --tsan, --debug   in that preset instead of release
# Anything else goes to ctest, e.g. ./test.sh -L core, ./test.sh -R tst_mesh.
set -euo pipefail
. "$(dirname "$(readlink -f "$0")")/resources/packaging/prepare.sh"

preset=release
soak=(-LE '^soak$')
while [ $# -gt 0 ]; do
    case $1 in
        --soak) soak=() ;;
        --asan | --tsan | --debug) preset=${1#--} ;;
        *) break ;;
    esac
    shift
done

fettle_install "$fettle_build_packages$fettle_test_packages"
fettle_lock
fettle_is_configured "$preset" BUILD_TESTING:BOOL=ON || fettle_configure "$preset" -DBUILD_TESTING=ON
fettle_build "$preset" all
fettle_unlock

export LIBGL_ALWAYS_SOFTWARE=1
unset WAYLAND_DISPLAY
# shellcheck disable=SC2016 # the inner shell expands
exec xvfb-run -a -s '-screen 0 1600x1000x24' bash -c '
    openbox >/dev/null 2>&1 &
    manager=$!
    status=0
    ctest "$@" || status=$?
    kill $manager
    echo "Skipped, and why:"
    grep "^SKIP" "$2/Testing/Temporary/LastTest.log" || echo "nothing"
    exit $status
' test.sh --test-dir "$fettle_root/build/$preset" --output-on-failure --no-tests=error -j "$(nproc)" ${soak[@]+"${soak[@]}"} "$@"
