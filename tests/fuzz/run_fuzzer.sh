#!/usr/bin/env bash
# Fuzzes the reader of a format for as long as FETTLE_EFFORT says. Its findings stay in the build folder, where the next
# run begins.
#   run_fuzzer.sh FUZZERS_DIR FORMAT
set -euo pipefail
case ${FETTLE_EFFORT:-small} in
    soak) seconds=3600 found=$1/found/$2_soak ;;
    long) seconds=20 found=$1/found/$2 ;;
    *) seconds=3 found=$1/found/$2 ;;
esac
mkdir -p "$found"
export FETTLE_FORMAT=$2
exec "$1/fuzz_reader" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=1024 -malloc_limit_mb=256 -max_len=16384 \
    -artifact_prefix="$1/$2-" "$found" "$(dirname "$(readlink -f "$0")")/corpus/$2"
