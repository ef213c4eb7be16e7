#!/usr/bin/env bash
# compare_usage_test.sh ISLET_COMPARE: what the command does when it is used, and misused.
set -euo pipefail

name=islet-compare
program=$1
# shellcheck source=tests/support/usage.sh
. "$(dirname "$0")/../support/usage.sh"

expect 0 pass hello
expect 0 '"pass": true' hello --json
expect 0 '"steps": 7' hello --json --steps 7
expect 0 pass hello pyramid --steps 10 --csv "$scratch/out.csv" --svg "$scratch/out.svg"
expect 0 'Runs scenes' --help
expect 2 'near names: pyramid' pyramidd
expect 2 'name a scene'
expect 2 'not expected' hello --nonsense
expect 0 '^islet-compare [0-9]' --version
expect 2 "no option '--stesp'; near names: --steps" hello --stesp 5
expect 2 'needs the name of a file' hello --csv ''
expect 2 'No such file or directory' hello --csv "$scratch/missing/out.csv"
expect 2 'Is a directory' hello --csv "$scratch"
expect 2 '--steps' hello --steps 0
expect 2 '--steps' hello --steps many
expect 2 'no tolerance' large_pyramid
expect 2 'cannot write' hello --csv "$scratch/missing/out.csv"
expect 2 'cannot write' hello --svg "$scratch/missing/out.svg"
expect 0 ratio --time hello --steps 5

[ "$(grep -c '^hello,' "$scratch/out.csv")" -eq 11 ] || complain "out.csv must have a line for each step and one for the start"
for picture in out-hello.svg out-pyramid.svg; do
    grep -q '</svg>' "$scratch/$picture" || complain "$picture is not whole"
done
exit "$((failures > 0))"
