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

# wait_for SECONDS COMMAND: waits until the command succeeds, and fails if it does not within the time.
wait_for()
{
    local end=$((SECONDS + $1))
    shift
    until "$@" >/dev/null 2>&1; do
        [ $SECONDS -lt $end ] || return 1
        sleep 0.2
    done
}
