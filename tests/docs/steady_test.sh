#!/usr/bin/env bash
# steady_test.sh ROOT ISLET: the table of docs/steady.md has the rows that `islet steady` prints, with what is wanted of them, and what the page calls
# reached is reached from the first start of each scene. (All starts take minutes: the page says how to run them.)
# shellcheck disable=SC2016  # what stands in single quotes is for awk and sed
set -euo pipefail
export LC_ALL=C

root=$(cd "$1" && pwd) program=$2
# shellcheck source=tests/docs/pages.sh
. "$(dirname "$0")/pages.sh"
page=$root/docs/steady.md

# rows: of each line of a table its sentence, what is wanted and the verdict, with bars between.
rows() { awk -F '  +' -v OFS='|' '$NF ~ /^(NOT )?(REACHED|reached)$/ { print $2, $(NF - 1), $NF }'; }

printed=$("$program" steady --quick)
mapfile -t said < <(awk '/^```text$/ { inside = 1; next } /^```/ { inside = 0 } inside' "$page" | rows)
checked=0
while IFS='|' read -r what wanted verdict; do
    checked=$((checked + 1))
    found=no
    for row in "${said[@]}"; do
        [[ $row == "$what|$wanted|"* ]] || continue
        found=yes
        # One start may reach what another does not.
        [ "$verdict" = reached ] || [ "${row##*|}" != reached ] || complain "steady.md says that this is reached, and start 0 does not: $what"
    done
    [ $found = yes ] || complain "steady.md has no row: $what, wanted $wanted"
done < <(rows <<<"$printed")

printf '%d rows checked\n' "$checked"
[ "$checked" -gt 40 ] && [ "${#said[@]}" -ge "$checked" ] && [ "$failures" -eq 0 ]
