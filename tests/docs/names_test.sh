#!/usr/bin/env bash
# names_test.sh ROOT: every name in the text of the manual (`World::set_solver`, `contacts_full`) exists in the code, so a page cannot name what is gone.
# Names of JavaScript are those of C and of fields in camel case. Left out: promises.md, which has a test of its own, and the names of other engines, in the
# first columns of their pages. Those of Chipmunk are checked where its headers are installed.
# shellcheck disable=SC2016  # what stands in single quotes is for grep
set -euo pipefail
export LC_ALL=C

root=$(cd "$1" && pwd)
# shellcheck source=tests/docs/pages.sh
. "$(dirname "$0")/pages.sh"

# Shorter words, and such as M_ii, are variables of formulas. CMake has names of its own.
words() { grep -aoE '[A-Za-z_][A-Za-z0-9_]{3,}' | { grep -vE '^(CMAKE|[A-Z])_' || true; } | sort -u; }

names_of() {
    prose "$1" | case $(basename "$1") in
        box2d.md | chipmunk.md | matter-js.md | planck.md) sed 's/^|[^|]*|/|/' ;;
        *) cat ;;
    esac | { grep -oE '`[^`]+`' || true; } | words
}

known=$(mktemp)
trap 'rm -f "$known"' EXIT
{
    find "$root"/{engine,bindings,samples,tools,tests,docs} \( -name node_modules -o -name dist -o -name __pycache__ \) -prune -o -type f ! -name '*.md' ! -name '*.svg' ! -path '*/tests/docs/*' -print
    find "$root" -maxdepth 1 -type f ! -name '*.md'
} | tee >(words >"$known.paths") | xargs -d '\n' cat | words >"$known"
sed -E 's/^islet_(world_)?//; s/_([a-z0-9])/\U\1/g' "$known" >"$known.camel"
sort -u -o "$known" "$known" "$known.paths" "$known.camel"
rm -f "$known.paths" "$known.camel"

checked=0
for page in $(pages "$root"); do
    [ "$(basename "$page")" != promises.md ] || continue
    mapfile -t names < <(names_of "$page")
    checked=$((checked + ${#names[@]}))
    mapfile -t missing < <(printf '%s\n' "${names[@]}" | comm -23 - "$known")
    [ -z "${missing[*]}" ] || complain "$(basename "$page") names what does not exist: ${missing[*]}"
done

if [ -e /usr/include/chipmunk/chipmunk.h ]; then
    mapfile -t names < <(sed -n 's/^| \(`cp[^|]*\)|.*/\1/p' "$root/docs/chipmunk.md" | words)
    checked=$((checked + ${#names[@]}))
    mapfile -t missing < <(printf '%s\n' "${names[@]}" | comm -23 - <(cat /usr/include/chipmunk/*.h | words))
    [ -z "${missing[*]}" ] || complain "chipmunk.md names what Chipmunk does not have: ${missing[*]}"
fi

printf '%d names checked\n' "$checked"
[ "$checked" -gt 300 ] && [ "$failures" -eq 0 ]
