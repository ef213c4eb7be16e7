#!/usr/bin/env bash
# flash_test.sh ROOT: the flash table of docs/microcontrollers.md says what tools/footprint.sh --check holds: no figure is above its limit, and none more than
# 300 bytes below it. (A limit is what was measured, and up to 200 bytes.) `tools/footprint.sh --write` writes the table anew. So do the manual's two
# figures of the small profile. README.md names the smallest.
set -euo pipefail

root=$1
# shellcheck source=tests/docs/pages.sh
. "$(dirname "$0")/pages.sh"
limits=$(sed -n '/^declare -A most_flash/,/^)/p' "$root/tools/footprint.sh" | grep -oE "\[[a-z0-9-]+\]='[^']+'" | tr -d "[]'" | tr '=' ' ')

page=$root/docs/microcontrollers.md

# near TARGET WHAT FIGURE LIMIT
near() {
    if [ "$3" -gt "$4" ] || [ "$3" -lt $(($4 - 300)) ]; then complain "$1: flash of $2 is said to be $3; the limit is $4"; fi
}

rows=0 least=
while IFS='|' read -r _ target features smallest _; do
    target=$(tr -d ' ' <<<"$target")
    read -r _ _ most_features most_smallest < <(grep "^$target " <<<"$limits") || { complain "footprint.sh has no limits of $target"; continue; }
    smallest=$(tr -d ' ' <<<"$smallest")
    if [ -z "$least" ] || [ "$smallest" -lt "$least" ]; then least=$smallest; fi
    near "$target" 'the large program' "$(tr -d ' ' <<<"$features")" "$most_features"
    near "$target" 'the small program' "$smallest" "$most_smallest"
    rows=$((rows + 1))
done < <(grep -E '^\| (cortex|riscv)' "$page")
for target in cortex-m4f cortex-m4f-lto; do
    words='A program of boxes and balls takes'
    if [ "$target" = cortex-m4f-lto ]; then words='Cortex-M4F, and'; fi
    figure=$(tr '\n' ' ' <"$page" | grep -oE "$words [0-9 ]+ (bytes of flash|with .-DISLET_LTO=ON)" | head -n 1 | grep -oE '[0-9]+ [0-9]{3}' | tr -d ' ')
    limit=$(sed -nE "s/^at_most $target 'flash of the small profile' .* ([0-9]+)\$/\1/p" "$root/tools/footprint.sh")
    near "$target" 'the small profile' "${figure:-0}" "${limit:-0}"
done
kilobytes=$(((least + 500) / 1000))
grep -q "from $kilobytes kB of flash" "$root/README.md" || complain "README.md does not say that the least flash is $kilobytes kB"
printf '%d targets checked\n' "$rows"
[ "$rows" -ge 6 ] && [ "$failures" -eq 0 ]
