#!/usr/bin/env bash
# Checks that clang-format would change nothing, and that no line is longer than 120 columns.
#   tests/check_format.sh [--fix]
# Other versions of clang-format than 14 (Debian 12) format otherwise: there the check is skipped and says so.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

mapfile -t files < <(find core ui vr app tests -name '*.cpp' -o -name '*.h' | sort)
format=$(command -v clang-format-14 || command -v clang-format) || {
    echo "check_format.sh: clang-format is not installed (Debian package clang-format-14)" >&2
    exit 1
}
if ! "$format" --version | grep -q 'version 14\.'; then
    echo "check_format.sh: skipped, $("$format" --version) is not version 14" >&2
elif [ "${1-}" = --fix ]; then
    printf '%s\0' "${files[@]}" | xargs -0 -n 20 -P "$(nproc)" "$format" -i
else
    printf '%s\0' "${files[@]}" | xargs -0 -n 20 -P "$(nproc)" "$format" --dry-run -Werror
fi
# Columns are characters, not bytes.
if LC_ALL=C.UTF-8 grep -HnE '.{121}' "${files[@]}"; then
    echo "check_format.sh: these lines are longer than 120 columns" >&2
    exit 1
fi
