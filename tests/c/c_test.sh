#!/usr/bin/env bash
# c_test.sh ISLET WORK HELLO LIBRARY...: C programs compile as C11 with each compiler there is, without a warning, link without a C++ library, and do what they
# should. The page's program is samples/programs/hello_world.c and prints what HELLO, that of C++, prints. Every function of islet.h is called by a test.
set -euo pipefail

islet=$1 work=$2 hello=$3
libraries=("${@:4}")
failed=false
fail() {
    printf 'FAILED: %s\n' "$*"
    failed=true
}

rm -rf "$work" && mkdir -p "$work"
cd "$work"
for compiler in gcc clang; do
    command -v "$compiler" >/dev/null || { printf '%s: left out, there is none\n' "$compiler" && continue; }
    for program in "$islet"/tests/c/{calls,refusals,lcp}.c "$islet/samples/programs/hello_world.c"; do
        name=$compiler-$(basename "$program" .c)
        if ! "$compiler" -std=c11 -Wall -Wextra -pedantic -Werror -I "$islet/bindings/c/include" -I "$islet/engine/include" "$program" "${libraries[@]}" -lm -o "$name"; then
            fail "$compiler: $program"
        elif ! "./$name" >"$name.txt"; then
            tail -n 20 "$name.txt"
            fail "$name"
        else
            printf '%s: %s\n' "$name" "$(tail -n 1 "$name.txt")"
        fi
    done
    # What the program does not call it does not link, as in C++ (engine/src/data/features.hpp): joints, chains, recordings, the profile.
    nm -C "$compiler-hello_world" | grep -E ' [TtW] .*(solve_joint_run|collide\(islet::ChainSegment|write_call|note_stage)' && fail "$compiler: the program links too much"
    diff <("$hello") "$compiler-hello_world.txt" || fail "$compiler: the C program prints something else than that of C++"
    "$compiler" -std=c11 -Wall -Wextra -pedantic -Werror -I "$islet/bindings/c/include" -I "$islet/engine/include" -c "$islet"/tests/c/{machines,fleets,kinds,defaults}.c || fail "$compiler: machines.c, fleets.c, kinds.c or defaults.c"
    if "$compiler" -x c++ -std=c++20 -fsyntax-only -Wall -Wextra -pedantic -Werror -I "$islet/bindings/c/include" -I "$islet/engine/include" - \
        <<<'#include <islet/islet.h>
#include <islet/islet_lcp.h>
#include <islet/islet.hpp>
#include <islet/lcp.hpp>'; then printf '%s: the headers together\n' "$compiler"; else fail "$compiler: islet.h is no C++"; fi
done

# The page: its program is the one above; its pieces compile.
diff "$islet/samples/programs/hello_world.c" <(awk '/^```/ { if (block ~ /int main/) exit; block = ""; inside = ($0 == "```c"); next } inside { block = block $0 "\n" } END { printf "%s", block }' "$islet/docs/c.md") ||
    fail "the program of docs/c.md is not samples/programs/hello_world.c"
{
    printf '#include <islet/islet.h>\n#include <islet/islet_lcp.h>\n#include <stdio.h>\nvoid pieces(IsletWorld* world, IsletBodyId crate);\nvoid pieces(IsletWorld* world, IsletBodyId crate) {\n'
    awk '/^```/ { if (inside && block !~ /int main/) printf "{\n%s}\n", block; block = ""; inside = ($0 == "```c"); next } inside { block = block $0 "\n" }' "$islet/docs/c.md"
    printf '}\n'
} >pieces.c
cc -std=c11 -Wall -Wextra -Wno-unused-but-set-variable -pedantic -Werror -I "$islet/bindings/c/include" -I "$islet/engine/include" -c pieces.c || fail "a piece of docs/c.md does not compile"

functions=0
while read -r name; do
    functions=$((functions + 1))
    grep -q "\b$name(" "$islet"/tests/c/{calls,machines,fleets,lcp}.c || fail "no test calls $name as it should be"
done < <(sed -n 's/^ISLET_C_API [^(]*\b\(islet_[a-z0-9_]*\)(.*/\1/p' "$islet/bindings/c/include/islet/islet.h" "$islet/engine/include/islet/islet_lcp.h")
printf '%d functions, each called\n' "$functions"
[ "$functions" -gt 300 ] || fail "there should be more than 300 functions"

if $failed; then exit 1; fi
