#!/usr/bin/env bash
# Runs clang-tidy over the sources that changed since a commit, headers in every folder included.
#   tests/run_clang_tidy.sh [COMMIT]     default: main
# Needs the Debian package clang-tidy; configures the debug preset if it is not configured yet.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

base=${1-main}
[ -e build/debug/compile_commands.json ] || cmake --preset debug -DBUILD_TESTING=ON >&2
# A changed header is seen through the .cpp of its name.
mapfile -t files < <(git diff --name-only --diff-filter=d "$base" -- '*.cpp' '*.h' | sed 's/\.h$/.cpp/' | sort -u |
    while read -r file; do [ ! -e "$file" ] || echo "$file"; done)
[ ${#files[@]} -gt 0 ] || { echo "no source changed since $base"; exit 0; }
printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P "$(nproc)" clang-tidy -p build/debug --quiet \
    --extra-arg=-Wno-unknown-warning-option # of GCC
