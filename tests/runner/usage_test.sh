#!/usr/bin/env bash
# usage_test.sh ISLET: what the runner does when it is used, and misused.
set -euo pipefail

name=islet
program=$1
# shellcheck source=tests/support/usage.sh
. "$(dirname "$0")/../support/usage.sh"

expect 0 card_house list
expect 0 '"name": "card_house"' list --json
expect 0 'check passed' run hello
expect 0 '"steps": 7' run hello --steps 7 --json --csv "$scratch/out.csv" --svg "$scratch/out.svg" --html "$scratch/out.html"
expect 0 'check skipped' run hello --steps 0 --html "$scratch/start.html"
expect 0 'check skipped' run car --steps 9 --svg "$scratch/drawn.svg" --draw joints,names,islands,boxes,impulses
expect 2 'not in' run hello --draw joints,everything
expect 2 'near names: hello' run helo
expect 2 'required' run
expect 2 'cannot write' run hello --csv "$scratch/missing/out.csv"
expect 2 'cannot write' run hello --svg "$scratch/missing/out.svg"
expect 2 'cannot write' run hello --html "$scratch/missing/out.html"
if [ -e /dev/full ]; then
    expect 2 'cannot write all' run hello --html /dev/full
fi
expect_no_room run hello

"$program" scene pyramid >"$scratch/pyramid.json"
expect 0 "$("$program" run pyramid --json | grep '"hash"')" run "$scratch/pyramid.json" --json
expect 0 'bodies        4' run "$(dirname "$0")/../../samples/scenes/swing.json" --svg "$scratch/swing.svg"
expect 2 'has a script' scene pinball
expect 2 'near names: hello' scene helo
expect 2 "cannot be read" run "$scratch/missing.json"
printf '{"bodies": [{"shapes": [{"circle": {}, "friction": -1}]}]}' >"$scratch/rough.json"
expect 2 "rough.json': cannot make body 0 of the scene: A number is outside its range" run "$scratch/rough.json"
printf '{"extra_contacts": 4000000, "bodies": [{"shapes": [{"circle": {}}]}]}' >"$scratch/greedy.json"
expect 2 "greedy.json': its world would take .* MB, and 100 MB are allowed: raise --memory-limit" run "$scratch/greedy.json" --memory-limit 100MB
printf '{"extra_contacts": 9000000, "bodies": [{"shapes": [{"circle": {}}]}]}' >"$scratch/greedy.json"
expect 2 "greedy.json': A world needs room" run "$scratch/greedy.json"
expect 0 'check passed' run hello --record "$scratch/hello.rec"
expect 0 'every hash as recorded' replay "$scratch/hello.rec"
expect 2 "allowed: raise --memory-limit" replay "$scratch/hello.rec" --memory-limit 4kB
printf '{"steps": 5,\n "bodies": [}' >"$scratch/torn.json"
expect 2 "torn.json': line 2, column 13" run "$scratch/torn.json"

[ "$(wc -l <"$scratch/out.csv")" -eq 8 ] || complain "out.csv must have a header and a line for each step"
grep -q '</svg>' "$scratch/out.svg" || complain "out.svg is not whole"
grep -q '>wheel<' "$scratch/drawn.svg" || complain "--draw names must name the car's joints"
! grep -q '>wheel<' "$scratch/out.svg" || complain "joints must not be named unasked"
for page in out start; do
    [ "$(tail -n 1 "$scratch/$page.html")" = '</html>' ] || complain "$page.html is not whole"
done
exit "$((failures > 0))"
