#!/usr/bin/env bash
# bench_usage_test.sh ISLET: what `islet bench` does when it is used, and misused.
set -euo pipefail

name='islet bench'
program=$1
subcommand=bench
# shellcheck source=tests/support/usage.sh
. "$(dirname "$0")/../../support/usage.sh"

few=(--steps 3 --repeat 2)
expect 0 'hello  *islet' hello "${few[@]}"
expect 0 '"engine": "islet"' hello --json "${few[@]}"
expect 0 '"steps": 3' hello --json "${few[@]}"
expect 0 large_pyramid --steps 1 --repeat 1 --engine islet  # no scene: the benchmark
expect 0 '"workers": 2' hello --json --workers 2 --engine islet "${few[@]}"
expect 2 'near names: pyramid' pyramidd
expect 2 'there are: islet' hello --engine newton
expect 2 '--repeat' hello --repeat 0
expect 2 '--steps' hello --steps 0
expect 2 '--steps' hello --steps many
expect 2 'not expected' hello --nonsense
expect 0 '  60  ' hello --quick --engine islet
expect 2 'excludes' hello --quick --steps 3

# Small worlds: without valgrind their steps are timed. (Counting takes most of a minute; each world runs here as valgrind would run it.)
no_valgrind=$scratch/bin
mkdir "$no_valgrind"
small=$(PATH=$no_valgrind "$program" bench --small 2>"$scratch/said")
grep -q 'valgrind, which is not installed' "$scratch/said" || complain "it must say that nothing counts instructions: $(cat "$scratch/said")"
[ "$(head -n 1 <<<"$small" | tr -s ' ')" = 'world lanes us a step' ] || complain "the header of small worlds: $small"
for world in boxes_3 boxes_10 boxes_55 car_beside_8_boxes ragdoll chain_of_10 balls_64; do
    grep -qE "^$world +1 +[0-9]+\.[0-9]{2}$" <<<"$small" || complain "no row of one lane for $world in: $small"
    [ -z "$("$program" bench --small-world "$world" --steps 2 --lanes 1 2>&1)" ] || complain "$world alone must print nothing"
done
PATH=$no_valgrind "$program" bench --small --json 2>/dev/null | grep -q '"us_per_step": ' || complain 'the JSON of small worlds has no times'
expect 2 'not in' --small-world nothing
expect 2 'excludes' --small --quick

# What workers would take: a table, or JSON.
expect 0 '^step .*' hello --span "${few[@]}"
expect 0 ' 16 workers ' hello --span "${few[@]}"
expect 0 ' 3 workers ' hello --span --workers 3 "${few[@]}"
expect 0 '"ms_chain": ' hello --span --json "${few[@]}"
expect 0 'hello: 60 steps' hello --span --quick
expect 2 'excludes' --span --small
expect 2 'excludes' hello --span --engine islet

# Standard output holds results only, from its first byte: other engines' greetings must not get in.
first=$("$program" bench hello --json "${few[@]}" 2>/dev/null | head -c 1)
[ "$first" = '[' ] || complain "JSON must begin with [, not '$first'"
errors=$("$program" bench hello "${few[@]}" 2>&1 >/dev/null)
[ -z "$errors" ] || complain "there is nothing to say on standard error, but: $errors"
rows=$("$program" bench hello hello --engine islet --engine islet "${few[@]}" | wc -l)
[ "$rows" -eq 2 ] || complain "a name said twice counts once: $rows lines, wanted 2"

# Interrupted in its second scene it has shown the first, says so, and its JSON is whole. Long ones begin with an estimate.
interrupt() { # interrupt FILE WORDS ARGUMENT...: its output goes to FILE; interrupts it when WORDS are among what was printed
    local file=$1 words=$2 status=0 i
    shift 2
    : >"$file"
    : >"$scratch/errors" # what an earlier one printed would end the wait at once
    "$program" bench "$@" >"$file" 2>"$scratch/errors" &
    for ((i = 0; i < 600; ++i)); do
        ! grep -q "$words" "$file" "$scratch/errors" || break
        sleep 0.1
    done
    kill -INT $!
    wait $! || status=$?
    [ "$status" -eq 130 ] || complain "islet bench $*: status $status after an interruption, wanted 130"
    grep -q interrupted "$scratch/errors" || complain "islet bench $*: it does not say that it was interrupted"
}
interrupt "$scratch/table" '^hello' hello large_pyramid --engine islet --steps 50000 --repeat 1
grep -q '^hello  *islet .* 1.00$' "$scratch/table" || complain "a row that was done is lost: $(cat "$scratch/table")"
grep -q 'this takes about' "$scratch/errors" || complain "a long bench must begin with an estimate"
interrupt "$scratch/json" 'this takes' large_pyramid --engine islet --steps 50000 --repeat 1 --json
[ "$(cat "$scratch/json")" = '[]' ] || complain "interrupted JSON must be whole: $(cat "$scratch/json")"
exit "$((failures > 0))"
