#!/usr/bin/env bash
# standard_test.sh ISLET LIBRARY: the public headers compile as C++17 and as C++20 without a warning, whichever comes first, and so does a program. Its world
# has the same hash with LIBRARY, the engine in C++20, and with the one-file form in C++17, also where the program is C++20. Mixed without ISLET_STD_SPAN they do
# not link. With an older standard the first error that a compiler reports says what Islet needs. (All golden hashes in C++17: tests/determinism/by_hand.sh.)
set -euo pipefail

islet=$1 library=$2
failed=false
fail() {
    printf 'FAILED: %s\n' "$*"
    failed=true
}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
warnings=(-Wall -Wextra -pedantic -Wconversion -Wno-sign-conversion -Wshadow -Wdouble-promotion -Werror)

for compiler in g++ clang++; do
    command -v "$compiler" >/dev/null || continue
    for header in "$islet"/engine/include/islet/*.hpp; do
        name=islet/$(basename "$header")
        for standard in c++17 c++20; do
            "$compiler" "-std=$standard" "${warnings[@]}" -fsyntax-only -I "$islet/engine/include" -include "$name" -x c++ /dev/null || fail "$compiler, $standard: $name"
        done
        # These hold no C++ but macros and a plain struct.
        case $name in islet/config.hpp | islet/visibility.hpp | islet/tasks.hpp) continue ;; esac
        log=$("$compiler" -std=c++14 -fsyntax-only -I "$islet/engine/include" -include "$name" -x c++ /dev/null 2>&1 || true)
        grep -m 1 'error' <<<"$log" | grep -q 'Islet needs C++17' || fail "$compiler, $name: the first error is another"
    done
    # program NAME FLAG...
    program() { "$compiler" "${warnings[@]}" "${@:2}" -I "$islet/engine/include" -c "$islet/tests/package/standards/drop.cpp" -o "$scratch/$1.o" || fail "$compiler: $*"; }
    program 20 -std=c++20
    program 20-own-span -std=c++20 -DISLET_STD_SPAN=0
    program 17 -std=gnu++17
done

cd "$scratch"
"$islet/tools/amalgamate.sh" one_file >/dev/null
g++ -std=gnu++17 -Wall -Wextra -Werror -c one_file/islet.cpp -o engine17.o || fail "the one-file form in C++17"
g++ 20.o "$library" -pthread -o in20
./in20 >wanted.txt || fail "the program in C++20"
for name in 17 20-own-span; do
    g++ "$name.o" engine17.o -o "$name.program"
    diff wanted.txt <("./$name.program") || fail "$name: another hash"
    if g++ "$name.o" "$library" -pthread -o mixed 2>mixed.txt; then fail "$name links with an engine in C++20"; fi
done
if $failed; then exit 1; fi
