#!/usr/bin/env bash
# lab_usage_test.sh ISLET_LAB: what the command does when it is used, and misused.
set -euo pipefail

name=islet-lab
program=$1
# shellcheck source=tests/support/usage.sh
. "$(dirname "$0")/../../support/usage.sh"

few=(--step 100 --iterations 20 --method pgs)
expect 0 'hello after step 100' hello "${few[@]}"
expect 0 '"method": "pgs"' hello --json "${few[@]}"
expect 0 'nncg' hello "${few[@]}" --method nncg
expect 0 'lemke' hello --step 100 --iterations 20
expect 0 'pgs' hello "${few[@]}" --csv "$scratch/out.csv"
expect 0 'substep of 2.5 ms' hello "${few[@]}" --substep-h 0.0025
expect 0 'nothing touches' hello --step 1 --method pgs
expect 0 'Measures how' --help
expect 2 'near names: pyramid' pyramidd
expect 2 'near names: pgs' hello --method pgss
expect 2 'near names: jacobi, l1_jacobi' hello --method l1jacobi
expect 2 'symmetric_pgs' hello --method gauss
expect 2 'name a scene'
expect 2 'not expected' hello --nonsense
expect 0 '^islet-lab [0-9]' --version
expect 2 "no option '--stp'; near names: --step" hello --stp 5
expect 2 'needs the name of a file' hello --csv ''
expect 2 'No such file or directory' hello --csv "$scratch/missing/out.csv"
expect 2 'Is a directory' hello --csv "$scratch"
expect 2 '{largest,all}' hello --islands some
expect 2 '--step' hello --step -1
expect 2 '--omega' hello --omega 2
expect 2 '--omega' hello --omega nan
expect 2 '--substep-h' hello --substep-h nan
expect 2 '--iterations' hello --iterations many
expect 2 '--islands' hello --islands some
expect 2 'cannot write' hello --csv "$scratch/missing/out.csv"
expect_no_room hello "${few[@]}"

[ "$(head -n 1 "$scratch/out.csv")" = scene,island,method,start,iteration,seconds,residual ] || complain "out.csv has no header"
if command -v gnuplot >/dev/null; then
    expect 0 'pgs' hello "${few[@]}" --svg "$scratch/out"
    grep -q '</svg>' "$scratch/out-hello.svg" || complain "out-hello.svg is not whole"
    expect 2 'cannot write' hello "${few[@]}" --svg "$scratch/missing/out"
else
    expect 2 'gnuplot' hello "${few[@]}" --svg "$scratch/out"
fi
exit "$((failures > 0))"
