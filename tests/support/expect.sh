# shellcheck shell=bash
# Sourced by tests that are scripts. Makes the folder `scratch`, which the script removes at its end by a trap.
# The script ends with `exit $failed`.
scratch=$(mktemp -d)
failed=0

# fail WORDS: reports a failure, and goes on.
fail()
{
    printf 'FAIL: %s\n' "$*"
    failed=1
}

# expect WHAT COMMAND: reports a failure if the command fails, with what it said.
expect()
{
    local what=$1
    shift
    "$@" >"$scratch/said" 2>&1 && return 0
    fail "$what"
    cat "$scratch/said"
}
