#!/usr/bin/env bash
# snippets_test.sh COMPILER ISLET PAGE.md...: every C++ block of the pages compiles: a whole program by itself; a piece of one inside a function that knows
# the names of snippet_names.hpp. (All pieces are one file, since what takes time is the headers.) A page need not have one, but all pages together must
# have 15.
set -euo pipefail

compiler=$1 islet=$2
shift 2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
here=$(cd "$(dirname "$0")" && pwd)
failures=0 blocks=0

# compile FILE: the messages name the page and its line.
compile() {
    "$compiler" -std=c++20 -fsyntax-only -Wall -Wextra -Werror -Wno-unused-variable -Wno-unused-but-set-variable -Wno-missing-field-initializers \
        -I "$islet/engine/include" -I "$islet/samples" -I "$here" "$1" || failures=1
}

printf '#include "snippet_names.hpp"\n' >"$scratch/pieces.cpp"
for page in "$@"; do
    rm -f "$scratch"/block-*
    awk -v out="$scratch/block-" '/^```cpp$/ { ++n; inside = 1; start = FNR; next } /^```$/ { inside = 0 } inside { if (!(n in begun)) print start > (out n ".line"); begun[n]; print > (out n) }' "$page"
    for block in "$scratch"/block-*[0-9]; do
        [ -e "$block" ] || continue
        blocks=$((blocks + 1))
        start="#line $(($(cat "$block.line") + 1)) \"$page\""
        if grep -q 'int main()' "$block"; then
            { printf '%s\n' "$start" && cat "$block"; } >"$scratch/program.cpp"
            compile "$scratch/program.cpp"
        else
            {
                grep '^#include' "$block" || true
                printf 'void snippet_%d() {\n%s\n' "$blocks" "$start"
                sed 's/^#include.*//' "$block"
                printf '}\n'
            } >>"$scratch/pieces.cpp"
        fi
    done
done
compile "$scratch/pieces.cpp"
printf '%d blocks\n' "$blocks"
[ "$blocks" -ge 15 ] || failures=1
exit "$failures"
