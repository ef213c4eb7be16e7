#!/usr/bin/env bash
# standard_test.sh ISLET: with an older standard than C++20 the first error that a compiler reports says what Islet needs, whichever header is included first.
set -euo pipefail

islet=$1
failed=false
for compiler in g++ clang++; do
    command -v "$compiler" >/dev/null || continue
    for header in "$islet"/engine/include/islet/*.hpp; do
        name=islet/$(basename "$header")
        # These hold no C++ but macros and a plain struct.
        case $name in islet/config.hpp | islet/visibility.hpp | islet/tasks.hpp) continue ;; esac
        log=$("$compiler" -std=c++17 -fsyntax-only -I "$islet/engine/include" -include "$name" -x c++ /dev/null 2>&1 || true)
        grep -m 1 'error' <<<"$log" | grep -q 'Islet needs C++20' || { printf '%s, %s: the first error is another\n' "$compiler" "$name" && failed=true; }
        "$compiler" -std=c++20 -fsyntax-only -I "$islet/engine/include" -include "$name" -x c++ /dev/null || failed=true
    done
done
if $failed; then exit 1; fi
