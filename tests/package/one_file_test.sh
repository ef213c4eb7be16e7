#!/usr/bin/env bash
# one_file_test.sh ISLET BUILD PROGRAM LIBRARY...: what tools/amalgamate.sh writes compiles by one command without flags, by each compiler there is; the
# README's program prints the same as PROGRAM, which CMake built; and scenes come to the golden hashes. (With flags that ruin bits
# elsewhere: tests/determinism/by_hand.sh.)
# AVX2 and AVX-512 stay in the copies that only processors with them run. The LIBRARYs are those of the scenes. BUILD is a folder for it all.
set -euo pipefail

islet=$1 build=$2 program=$3
libraries=("${@:4}")
failed=false
fail() {
    printf 'FAILED: %s\n' "$*"
    failed=true
}

rm -rf "$build" && mkdir -p "$build"
"$islet/tools/amalgamate.sh" "$build" >/dev/null
cp -r "$build" "$build.again" && "$islet/tools/amalgamate.sh" "$build.again" >/dev/null
diff -r "$build" "$build.again" || fail "a second run writes something else"
rm -r "$build.again"
cd "$build"
sed 's|#include <islet/islet.hpp>|#include "islet.hpp"|' "$islet/samples/programs/hello_world.cpp" >hello.cpp
sed 's|#include <islet/lcp.hpp>|#include "islet.hpp"|' "$islet/samples/programs/lcp.cpp" >lcp.cpp
grep -q '#include <islet/' hello.cpp lcp.cpp && fail "a program still includes a header of the tree"
sed 's|#include <islet/islet.h>|#include "islet.h"|' "$islet/samples/programs/hello_world.c" >hello.c
sed 's|#include <islet/islet_lcp.h>|#include "islet_lcp.h"|' "$islet/tests/c/lcp.c" >lcp_c.c
cp "$islet/tests/c/check.h" .
grep -n '#include "' islet.h islet_c.cpp | grep -v -E ':#include "islet.hp{0,2}"' && fail "an include of the tree is left in the C interface"
grep -n '#include "' islet.hpp islet.cpp islet_lcp.cpp | grep -v -E ':#include "islet(.hpp|_lcp.h)"' && fail "an include of the tree is left"
g++ -std=c++20 -O0 -I "$islet/engine/include" -I "$islet/samples" -c "$islet/tests/determinism/hashes.cpp" -o hashes.o

# compare_hashes NAME OBJECT: of scenes that use all of the kernels.
compare_hashes() {
    local scenes=() scene result
    for scene in hello pyramid card_house car ragdoll bullets hourglass joint_grid; do scenes+=(--scene "$scene"); done
    g++ hashes.o "$2" -Wl,--start-group "${libraries[@]}" -Wl,--end-group -pthread -o "$2.hashes"
    result=$("./$2.hashes" "$islet/tests/determinism/golden.txt" --most-steps 60 --large-steps 10 --lanes 1,4,8 "${scenes[@]}") || fail "$1: other hashes"
    printf '%-8s %s\n' "$1" "$(tail -n 1 <<<"$result")"
}

# Functions that use registers of a kind: the copies for eight and sixteen lanes must, and no others may.
functions_with() { objdump -d --no-show-raw-insn "$2" | awk -v register="%$1" '/^[0-9a-f]+ </ { name = $2 } $0 ~ register { print name }' | sort -u; }

for compiler in g++ clang++; do
    command -v "$compiler" >/dev/null || { printf '%s: left out, there is none\n' "$compiler" && continue; }
    # The command of the manual, in two parts: the engine is looked at below, and is compiled once.
    "$compiler" -std=c++20 -c islet.cpp -o "$compiler.o"
    "$compiler" -std=c++20 "$compiler.o" hello.cpp -o "hello-$compiler"
    diff <("$program") <("./hello-$compiler") || fail "$compiler: the program prints something else"
    cc -std=c11 -c hello.c -o hello_c.o
    if [ "$compiler" = g++ ]; then # the command of the manual for C: no flags, so C++17
        cc islet.cpp islet_c.cpp hello.c -o "hello-c-$compiler" -lstdc++ -lm
    else
        "$compiler" -std=c++20 "$compiler.o" islet_c.cpp hello_c.o -o "hello-c-$compiler"
    fi
    diff <("$program") <("./hello-c-$compiler") || fail "$compiler: the program in C prints something else"
    "$compiler" -std=c++20 islet_lcp.cpp lcp.cpp -o "lcp-$compiler"
    "./lcp-$compiler" >/dev/null || fail "$compiler: the matrix solvers find no solution"
    cc -std=c11 -c lcp_c.c -o lcp_c.o
    "$compiler" -std=c++20 islet_lcp.cpp lcp_c.o -o "lcp-c-$compiler"
    "./lcp-c-$compiler" >/dev/null || fail "$compiler: the matrix solvers in C find no solution"
    compare_hashes "$compiler" "$compiler.o"
    if [ "$(uname -m)" = x86_64 ]; then
        functions_with '[yz]mm' "$compiler.o" >wide.txt
        grep -q eight_lanes wide.txt || fail "$compiler: no AVX2 anywhere"
        grep -v -E 'eight_lanes|sixteen_lanes' wide.txt && fail "$compiler: AVX2 where every processor runs it"
        functions_with zmm "$compiler.o" >widest.txt
        grep -q sixteen_lanes widest.txt || fail "$compiler: no AVX-512 anywhere"
        grep -v sixteen_lanes widest.txt && fail "$compiler: AVX-512 where processors without it run it"
    fi
done

if $failed; then exit 1; fi
