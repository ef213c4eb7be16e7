#!/usr/bin/env bash
# islet_usage_test.sh ISLET: what it does when it is used, and misused.
set -euo pipefail

name=islet
program=$1
# shellcheck source=tests/support/usage.sh
. "$(dirname "$0")/../../support/usage.sh"

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

# Starts of scenes that have several, and the table of them all.
expect 0 'check passed' run flat_bounce --start 3
expect 2 "'flat_bounce' has starts 0 to 9" run flat_bounce --start 10
expect 2 "'hello' has one start only" run hello --start 1
expect 0 '  2 .* reached' steady flat_bounce --starts 2
expect 0 '2 of 2 reached' steady flat_bounce --quick --jobs 1
expect 0 '"reached": true' steady flat_bounce --quick --json
expect 2 "'hello' is no row" steady hello
expect 2 'near names: flat_bounce' steady flat_bounse
expect 2 'there are: islet' steady flat_bounce --engine newton
expect 2 'excludes' steady flat_bounce --quick --starts 2
expect_no_room steady flat_bounce --quick

# Sweeps: a table, and its parts made by processes of their own.
sweep=(sweep card_house --vary friction=0.2:0.8:3 --vary 'substeps=2,4' --seeds 3 --steps 30)
expect 0 '18 runs (6 points, 3 seeds)' "${sweep[@]}" --csv "$scratch/sweep.csv" --plot "$scratch/sweep.svg" --manifest "$scratch/whole.json"
[ "$(wc -l <"$scratch/sweep.csv")" -eq 19 ] || complain "sweep --csv: not a line for each run"
for shard in 0 1 2 3; do expect 0 "shard $shard of 4" "${sweep[@]}" --shards 4 --shard "$shard" --manifest "$scratch/part$shard.json"; done
"$program" "${sweep[@]}" >"$scratch/one_process.txt"
"$program" "${sweep[@]}" --jobs 1 >"$scratch/one_job.txt"
"$program" sweep --merge "$scratch"/part?.json >"$scratch/merged.txt"
cmp "$scratch/one_process.txt" "$scratch/one_job.txt" || complain 'sweep: another table with one job'
cmp "$scratch/one_process.txt" "$scratch/merged.txt" || complain 'sweep: another table of four shards'
expect 0 '"friction": 0.2' sweep --merge "$scratch/whole.json" --json --plot "$scratch/merged.svg"
cmp "$scratch/sweep.svg" "$scratch/merged.svg" || complain 'sweep: another picture of a manifest'
expect 2 'runs are missing' sweep --merge "$scratch"/part[012].json
expect 2 "sweep.svg': this is no whole manifest" sweep --merge "$scratch/whole.json" "$scratch/sweep.svg"
expect 2 'No such file or directory' sweep --merge "$scratch/missing.json"
expect 2 'needs a scene' sweep
expect 2 'needs a scene' sweep hello --merge "$scratch/whole.json"
expect 2 'near names: hello' sweep helo
expect 2 'near names: friction' sweep hello --vary fricton=1
expect 2 'is no number' sweep hello --vary friction=high
expect 2 "friction=-1: bodies\\[0\\].shapes\\[0\\].friction: A number is outside its range" sweep hello --vary friction=-1
expect 2 'has one start only' sweep hello --start 1
expect 2 '--shard is 0 to 3' sweep hello --shards 4 --shard 4 --manifest "$scratch/x.json"
expect 2 'one shard makes no table' sweep hello --shards 4
expect 2 'one shard makes no table' sweep hello --shards 4 --manifest "$scratch/x.json" --json
expect 2 'needs something to --vary' sweep hello --plot "$scratch/x.svg"
expect 2 'cannot write' sweep hello --csv "$scratch/missing/x.csv"
expect 2 'raise --memory-limit' sweep hello --memory-limit 4kB
printf '{"steps": 5, "bodies": [{"type": "dynamic", "shapes": [{"circle": {}}]}]}' >"$scratch/drop.json"
expect 0 'gravity' sweep "$scratch/drop.json" --vary gravity=1,2
expect 2 "missing.json'" sweep "$scratch/missing.json"
expect_no_room sweep hello --seeds 1

"$program" scene pyramid >"$scratch/pyramid.json"
expect 0 "$("$program" run pyramid --json | grep '"hash"')" run "$scratch/pyramid.json" --json
expect 0 'bodies        4' run "$(dirname "$0")/../../../samples/scenes/swing.json" --svg "$scratch/swing.svg"
expect 2 'has a script' scene pinball
expect 2 'near names: hello' scene helo
expect 2 "cannot be read" run "$scratch/missing.json"
printf '{"bodies": [{"shapes": [{"circle": {}, "friction": -1}]}]}' >"$scratch/rough.json"
expect 2 "rough.json': bodies\\[0\\].shapes\\[0\\].friction: A number is outside its range" run "$scratch/rough.json"
printf '{"extra_contacts": 4000000, "bodies": [{"shapes": [{"circle": {}}]}]}' >"$scratch/greedy.json"
expect 2 "greedy.json': extra_contacts: must be at most" run "$scratch/greedy.json"
expect 2 "hello': its world would take .* MB, and 0 MB are allowed: raise --memory-limit" run hello --memory-limit 4kB
expect 0 'check passed' run hello --record "$scratch/hello.rec"
expect 0 'every hash as recorded' replay "$scratch/hello.rec"
cp "$scratch/hello.rec" "$scratch/old.rec"
printf '\001' | dd of="$scratch/old.rec" bs=1 seek=4 conv=notrunc 2>"$scratch/dd.log"
expect 2 'This is a recording of format 1; Islet 0\.[0-9.]* reads format [0-9]*\.' replay "$scratch/old.rec"
printf '{"format": 7, "novelty": 1, "bodies": []}' >"$scratch/later.json"
expect 2 "later.json': format: this is a scene file of format 7; Islet 0\.[0-9.]* reads format 1" run "$scratch/later.json"
expect 2 "allowed: raise --memory-limit" replay "$scratch/hello.rec" --memory-limit 4kB
printf '{"steps": 5,\n "bodies": [}' >"$scratch/torn.json"
expect 2 "torn.json': line 2, column 13" run "$scratch/torn.json"

# What is wrong is said with what was meant, and why.
expect 0 '^islet 0[.][0-9]*[.][0-9]*$' --version
expect 2 'Subcommands:'
expect 2 "no command 'lst'; near names: list" lst
expect 2 "no option '--stesp'; near names: --steps" run hello --stesp 5
expect 2 '{as-found,colored,downward,upward}' run hello --sweep-order up
expect 2 '{all,automatic,off}' run hello --joint-trees some
expect 0 'TEXT:{as-found,colored,downward,upward}' run --help
expect 2 'needs the name of a file' run hello --csv ''
expect 2 'needs the name of a file' run hello --record ''
expect 2 'No such file or directory' run hello --csv "$scratch/missing/out.csv"
expect 2 'No such file or directory' run "$scratch/missing.json"
expect 2 'Is a directory' run hello --svg "$scratch"
mkdir "$scratch/folder.json"
expect 2 'Is a directory' run "$scratch/folder.json"
expect 2 'Is a directory' replay "$scratch"
expect 2 'this is a JSON file, no recording' replay "$scratch/rough.json"
expect 2 'this is a picture, no recording' replay "$scratch/out.svg"
expect 2 'this is a table of steps, no recording' replay "$scratch/out.csv"
"$program" run hello --steps 2 --record "$scratch/hello.rec" >/dev/null
cp "$scratch/hello.rec" "$scratch/hello.rec.json"
expect 2 '.islet replay. takes it' run "$scratch/hello.rec.json"
expect 0 '(55 awake), 56 shapes' run pyramid --steps 0
for command in '' run scene replay bench; do
    # shellcheck disable=SC2086
    ! "$program" $command --help | LC_ALL=C grep -q '[[:cntrl:]]' || complain "islet $command --help prints control bytes"
done

# What has no room falls through: everything that shows the run says so.
crates=
for ((i = 0; i < 60; ++i)); do
    crates="$crates, {\"type\": \"dynamic\", \"position\": [0, 2], \"shapes\": [{\"box\": [0.5, 0.5]}]}"
done
printf '{"steps": 60, "bodies": [{"shapes": [{"box": [9, 1]}]}%s]}' "$crates" >"$scratch/crowd.json"
expect 0 'there was no room for some contacts' run "$scratch/crowd.json" --svg "$scratch/crowd.svg" --html "$scratch/crowd.html"
expect 0 'extra_contacts' run "$scratch/crowd.json"
grep -q 'without room' "$scratch/crowd.svg" || complain "crowd.svg must say that contacts had no room"
grep -q '"dropped":[1-9]' "$scratch/crowd.html" || complain "crowd.html must know that contacts had no room"
! grep -q 'without room' "$scratch/out.svg" || complain "out.svg speaks of contacts that had room"

[ "$(wc -l <"$scratch/out.csv")" -eq 8 ] || complain "out.csv must have a header and a line for each step"
grep -q '</svg>' "$scratch/out.svg" || complain "out.svg is not whole"
grep -q '>wheel<' "$scratch/drawn.svg" || complain "--draw names must name the car's joints"
! grep -q '>wheel<' "$scratch/out.svg" || complain "joints must not be named unasked"
for page in out start; do
    [ "$(tail -n 1 "$scratch/$page.html")" = '</html>' ] || complain "$page.html is not whole"
done
exit "$((failures > 0))"
