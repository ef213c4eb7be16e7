# What the tests of the commands' usage share. Sourced with `name` and `program` set, and `subcommand` if the test is about one alone; ends in
# exit "$((failures > 0))".
# shellcheck shell=bash
# shellcheck disable=SC2154
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0

# expect STATUS WORDS ARGUMENT...: the exit status, and words that the output (both streams) must hold.
expect() {
    local wanted=$1 words=$2 status=0 out
    shift 2
    out=$("$program" ${subcommand:+"$subcommand"} "$@" 2>&1) || status=$?
    if [ "$status" -ne "$wanted" ] || ! grep -q -- "$words" <<<"$out"; then
        printf '%s %s\n  status %s, wanted %s; wanted the words "%s" in:\n%s\n' "$name" "$*" "$status" "$wanted" "$words" "$out"
        failures=$((failures + 1))
    fi
}

complain() {
    printf '%s\n' "$*"
    failures=$((failures + 1))
}

# expect_no_room ARGUMENT...: where nothing can be printed the command says so and fails.
expect_no_room() {
    local status=0
    [ -e /dev/full ] || return 0
    "$program" "$@" >/dev/full 2>"$scratch/no_room" || status=$?
    [ "$status" -eq 2 ] || complain "$name $*: status $status though nothing could be printed"
    grep -q 'cannot write' "$scratch/no_room" || complain "$name $*: no word of what could not be printed"
}
