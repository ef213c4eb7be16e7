#!/usr/bin/env bash
# names_test.sh ROOT: every name in the text of the manual (`World::set_solver`, `contacts_full`) exists in the code, so a page cannot name what is gone.
# Two places are left out: promises.md, which has a test of its own, and the names of Box2D, in the first column of box2d.md.
# shellcheck disable=SC2016  # what stands in single quotes is for grep
set -euo pipefail
export LC_ALL=C

root=$(cd "$1" && pwd)
# shellcheck source=tests/docs/pages.sh
. "$(dirname "$0")/pages.sh"

# Shorter words, and such as M_ii, are variables of formulas. CMake has names of its own.
words() { grep -oE '[A-Za-z_][A-Za-z0-9_]{3,}' | { grep -vE '^(CMAKE|[A-Z])_' || true; } | sort -u; }

names_of() {
    prose "$1" | case $(basename "$1") in
        box2d.md) sed 's/^|[^|]*|/|/' ;;
        *) cat ;;
    esac | { grep -oE '`[^`]+`' || true; } | words
}

known=$(mktemp)
trap 'rm -f "$known"' EXIT
{
    find "$root"/{engine,bindings,samples,tools,tests,docs} \( -name node_modules -o -name dist \) -prune -o -type f ! -name '*.md' ! -name '*.svg' ! -path '*/tests/docs/*' -print
    find "$root" -maxdepth 1 -type f ! -name '*.md'
} | tee >(words >"$known.paths") | xargs -d '\n' cat | words >"$known"
sort -u -o "$known" "$known" "$known.paths"
rm -f "$known.paths"

checked=0
for page in $(pages "$root"); do
    [ "$(basename "$page")" != promises.md ] || continue
    mapfile -t names < <(names_of "$page")
    checked=$((checked + ${#names[@]}))
    mapfile -t missing < <(printf '%s\n' "${names[@]}" | comm -23 - "$known")
    [ -z "${missing[*]}" ] || complain "$(basename "$page") names what does not exist: ${missing[*]}"
done

printf '%d names checked\n' "$checked"
[ "$checked" -gt 300 ] && [ "$failures" -eq 0 ]
