#!/usr/bin/env bash
# flash_test.sh ROOT: the flash table of docs/microcontrollers.md says what tools/footprint.sh --check holds: no figure is above its limit, and none more than
# 300 bytes below it. (A limit is what was measured, and up to 200 bytes.) `tools/footprint.sh --write` writes the table anew.
set -euo pipefail

root=$1
# shellcheck source=tests/docs/pages.sh
. "$(dirname "$0")/pages.sh"
limits=$(sed -n '/^declare -A most_flash/,/^)/p' "$root/tools/footprint.sh" | grep -oE "\[[a-z0-9-]+\]='[^']+'" | tr -d "[]'" | tr '=' ' ')

# near TARGET WHAT FIGURE LIMIT
near() {
    if [ "$3" -gt "$4" ] || [ "$3" -lt $(($4 - 300)) ]; then complain "$1: flash of $2 is said to be $3; the limit is $4"; fi
}

rows=0
while IFS='|' read -r _ target features smallest _; do
    target=$(tr -d ' ' <<<"$target")
    read -r _ _ most_features most_smallest < <(grep "^$target " <<<"$limits") || { complain "footprint.sh has no limits of $target"; continue; }
    near "$target" 'every feature' "$(tr -d ' ' <<<"$features")" "$most_features"
    near "$target" 'boxes and balls' "$(tr -d ' ' <<<"$smallest")" "$most_smallest"
    rows=$((rows + 1))
done < <(grep -E '^\| (cortex|riscv)' "$root/docs/microcontrollers.md")
printf '%d targets checked\n' "$rows"
[ "$rows" -ge 6 ] && [ "$failures" -eq 0 ]
