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

status=0
ctest --test-dir "$fettle_root/build/$preset" --output-on-failure --no-tests=error -j "$(($(nproc) + 1))" ${soak[@]+"${soak[@]}"} "$@" || status=$?
echo "Skipped, and why:"
grep "^SKIP" "$fettle_root/build/$preset/Testing/Temporary/LastTest.log" || echo "nothing"
exit $status
