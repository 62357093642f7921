#!/usr/bin/env bash
# Installs what is missing, builds, and runs the whole test suite without a screen.
#   ./test.sh [--long | --soak] [--asan | --tsan | --debug] [CTEST ARGUMENTS]
#   --long   the fuzzers, the random tests and the pictures in full, which without it are a sample; with release it
#            builds debug, too
#   --soak   the same, and the tests that take hours
#   --asan, --tsan, --debug   in that preset instead of release
# Anything else goes to ctest, e.g. ./test.sh -L core, ./test.sh -R core/mesh.
set -euo pipefail
. "$(dirname "$(readlink -f "$0")")/resources/packaging/prepare.sh"

preset=release
soak=(-LE '^soak$')
while [ $# -gt 0 ]; do
    case $1 in
        --long) export FETTLE_EFFORT=long ;;
        --soak) export FETTLE_EFFORT=long; soak=() ;;
        --asan | --tsan | --debug) preset=${1#--} ;;
        *) break ;;
    esac
    shift
done

fettle_install "$fettle_build_packages$fettle_test_packages$fettle_bundle_packages" "$preset" -DBUILD_TESTING=ON
"$fettle_root/tests/check_format.sh" >&2
"$fettle_root/tests/check_subjects.sh" >&2
fettle_lock
fettle_is_configured "$preset" BUILD_TESTING:BOOL=ON || fettle_configure "$preset" -DBUILD_TESTING=ON
# First what needs no library of ours and fails at once: the layout of the sources and the sizes of classes.
fettle_build "$preset" test_app
"$fettle_root/build/$preset/tests/app/test_app" -silent >&2 ||
    fettle_fail "the sources break a rule of the layout; the lines above say which"
fettle_build "$preset" all
if [ "${FETTLE_EFFORT-}" = long ] && [ "$preset" = release ]; then
    # Release builds compile the files of a folder together, which hides missing includes; debug builds do not.
    fettle_is_configured debug BUILD_TESTING:BOOL=ON || fettle_configure debug -DBUILD_TESTING=ON
    fettle_build debug all
fi
fettle_unlock

status=0
log=$fettle_root/build/$preset/Testing/Temporary/LastTest.log
rm -f "$log" # of an earlier run
# Some tests wait rather than compute.
ctest --test-dir "$fettle_root/build/$preset" --output-on-failure --no-tests=error -j "$(($(nproc) + 2))" \
    ${soak[@]+"${soak[@]}"} "$@" || status=$?
[ -f "$log" ] || exit $status # nothing was to run, as with -N
echo "Skipped, and why:"
grep "^SKIP" "$log" || echo "nothing"
echo "The slowest, in seconds:"
awk '/^[0-9]+\/[0-9]+ Testing: / {name = $3} /^Test time =/ {printf "%7.1f  %s\n", $4, name}' "$log" | sort -rn | sed -n 1,20p
exit $status
