#!/usr/bin/env bash
# Checks that the subject of each commit is `area: Imperative subject` of at most 72 characters.
#   tests/check_subjects.sh [COMMIT]     those after that commit; default: since the rule holds
# Where the history does not go back so far, only the last commit is checked.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

git rev-parse --git-dir >/dev/null 2>&1 || {
    echo "check_subjects.sh: skipped, this is no checkout of git" >&2
    exit 0
}
since=${1-13cf249e}
range=(-1)
if git rev-parse -q --verify "$since^{commit}" >/dev/null; then
    range=("$since..HEAD")
fi
if git log --no-merges --format='%h %s' "${range[@]}" |
    LC_ALL=C.UTF-8 grep -vE '^[0-9a-f]+ [a-z0-9][a-z0-9_/., +-]*: [A-Z]' ||
    git log --no-merges --format='%h %s' "${range[@]}" | LC_ALL=C.UTF-8 grep -E '^[0-9a-f]+ .{73}'; then
    echo "check_subjects.sh: these subjects are not \"area: Imperative subject\" of at most 72 characters" >&2
    exit 1
fi
