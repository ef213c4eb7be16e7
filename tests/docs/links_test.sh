#!/usr/bin/env bash
# links_test.sh ROOT: every relative link of the pages leads to a file, and to a heading of it if it names one; every page has a picture, is in the index, and
# no picture or page is left over. README.md has at most 150 lines, a picture less than 60 kB, the film 1 MB. No page names a folder of somebody's machine.
set -euo pipefail

root=$(cd "$1" && pwd)
# shellcheck source=tests/docs/pages.sh
. "$(dirname "$0")/pages.sh"

# anchors PAGE: its headings as links name them.
anchors() { prose "$1" | sed -n 's/^##* //p' | tr '[:upper:]' '[:lower:]' | sed 's/[^a-z0-9 _-]//g; s/ /-/g'; }
# names_heading PAGE NAME: a page's headings are read once.
declare -A headings
names_heading() {
    [ -n "${headings[$1]+known}" ] || headings[$1]=$'\n'$(anchors "$1")$'\n'
    [[ ${headings[$1]} == *$'\n'"$2"$'\n'* ]]
}
links() { prose "$1" | grep -oE '\]\([^)]+\)' | sed 's/^](//; s/)$//' || true; }

checked=0
mapfile -t others < <(find "$root"/{engine,samples,tests,tools} -name '*.md' ! -path '*/node_modules/*')
mapfile -t own < <(pages "$root")
for page in "${own[@]}" "${others[@]}"; do
    while IFS= read -r link; do
        [ -n "$link" ] || continue
        case $link in http://* | https://*) continue ;; esac
        checked=$((checked + 1))
        file=${link%%#*}
        target=$page
        [ -z "$file" ] || target=${page%/*}/$file
        if [ ! -e "$target" ]; then
            complain "$page: there is no $link"
        elif [ "$link" != "$file" ] && ! names_heading "$target" "${link#*#}"; then
            complain "$page: $link names no heading"
        fi
    done < <(links "$page")
done

used=$(for page in "${own[@]}"; do links "$page"; done | sed -n 's|.*images/||p' | sort -u)
for picture in "$root"/docs/images/*; do
    grep -qxF "$(basename "$picture")" <<<"$used" || complain "no page shows $picture"
    most=60000
    [ "$(basename "$picture")" != film.svg ] || most=1000000
    [ "$(wc -c <"$picture")" -lt "$most" ] || complain "$picture is too large"
done
for page in "${own[@]}"; do
    name=$(basename "$page")
    prose "$page" | grep -E '^!\[.+\]\(.*images/.+\)$' >/dev/null || [ "$name" = promises.md ] || complain "$page has no picture"
    [ "$name" = README.md ] || links "$root/docs/README.md" | grep -xF "$name" >/dev/null || complain "the index does not name $name"
    ! grep -nE '(^|[^a-z.])/(tmp|home|root|work|Users)/' "$page" || complain "$page names a folder of somebody's machine"
done
[ "$(wc -l <"$root/README.md")" -le 150 ] || complain "README.md has more than 150 lines"

printf '%d links of %d pages checked\n' "$checked" $((${#own[@]} + ${#others[@]}))
[ "$checked" -gt 100 ] && [ "$failures" -eq 0 ]
