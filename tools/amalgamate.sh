#!/usr/bin/env bash
# Writes the engine as one header and one source.
#   tools/amalgamate.sh [FOLDER]   islet.hpp, islet.cpp, islet_lcp.cpp, islet.h, islet_lcp.h and islet_c.cpp into FOLDER (build/amalgamation unless given)
# They need nothing else and no flags but -std=c++20 (or c++17):
#   g++ -std=c++20 -O2 islet.cpp game.cpp
# islet.hpp holds all the public headers. islet.cpp is the engine, islet_lcp.cpp the matrix solvers, for programs that use them. Programs in C include islet.h
# and link islet_c.cpp too.
set -euo pipefail

case ${1:-} in
-h | --help)
    sed -n '2,7s/^# \{0,1\}//p' "$0"
    exit 0
    ;;
-*)
    printf '%s: unknown option %s; there is --help\n' "$0" "$1" >&2
    exit 2
    ;;
esac
root=$(cd "$(dirname "$0")/.." && pwd)
engine=$root/engine
parts=$root/tools/amalgamate
out=${1:-$root/build/amalgamation}
mkdir -p "$out"

# Paths from engine/, sorted in the same way everywhere.
listed() { (cd "$engine" && find "$@" | LC_ALL=C sort); }

# flatten ROOTS GIVEN [NAMESPACE]
flatten() { awk -v engine="$engine" -v roots="${1//$'\n'/\\n}" -v given="${2//$'\n'/\\n}" -v inner="${3:-}" -f "$parts/flatten.awk"; }

version=$(sed -n 's/^#define ISLET_VERSION_STRING "\(.*\)".*/\1/p' "$engine/include/islet/version.hpp")
head() {
    printf '// Islet %s: %s\n// Made by tools/amalgamate.sh; edit the files it is made of, not this one.\n//\n' "$version" "$1"
    sed 's/^/\/\/ /; s/ *$//' "$root/LICENSE"
}

headers=$(listed include -name '*.hpp')
sources=$(listed src -name '*.cpp' ! -path '*/lcp/*' ! -name '*_avx*.cpp')
lcp=$(listed src/lcp -name '*.cpp')
before=$headers$'\nsrc/exact.hpp\nsrc/math/avx2.hpp\nsrc/math/avx512.hpp'

# wide LANES COPY NAME: what runs with so many lanes, once more, in a namespace COPY: the compiler may use AVX2 or AVX-512 (NAME) here, and nowhere else.
wide() {
    printf '\n#if defined(__x86_64__) && ISLET_MAX_LANES >= %s\n' "$1"
    printf '#if !defined(__clang__)\n#pragma GCC push_options\n#endif\n'
    grep -v '^#pragma once' "$engine/src/math/$3.hpp"
    flatten "$(listed src -name "*_$3.cpp")" "$before" "$2" | grep -v "^ISLET_${3^^}_END"
    printf '\nISLET_%s_END\n#if !defined(__clang__)\n#pragma GCC pop_options\n#endif\n\n' "${3^^}"
    sed "s/@copy@/$2/g; s/@lanes@/$1/g" "$parts/wide_kernels.inc"
    if [ -e "$parts/$2.inc" ]; then cat "$parts/$2.inc"; fi
    printf '#endif\n'
}

# Names of the headers that are macros elsewhere, in Arduino.h and windows.h: they are none inside.
macros=(abs min max round radians degrees bit sq word)
{
    head "all the public headers as one."
    printf '#pragma once\n\n'
    for name in "${macros[@]}"; do printf '#pragma push_macro("%s")\n#undef %s\n' "$name" "$name"; done
    flatten "$headers" ''
    printf '\n'
    for name in "${macros[@]}"; do printf '#pragma pop_macro("%s")\n' "$name"; done
} >"$out/islet.hpp.new"
{
    head "the engine as one source. Compile it with -std=c++20 (or c++17), as your program is."
    flatten src/exact.hpp ''
    printf '\n#include "islet.hpp"\n'
    flatten "$sources" "$before"
    wide 8 eight_lanes avx2
    wide 16 sixteen_lanes avx512
} >"$out/islet.cpp.new"
{
    head "the matrix solvers as one source. A program that calls islet::lcp needs it beside islet.hpp."
    flatten src/exact.hpp ''
    printf '\n#include "islet.hpp"\n#include "islet_lcp.h"\n'
    flatten "$lcp" "$before"$'\ninclude/islet/islet_lcp.h'
} >"$out/islet_lcp.cpp.new"
cat "$engine/include/islet/islet_lcp.h" >"$out/islet_lcp.h.new"
cat "$root/bindings/c/include/islet/islet.h" >"$out/islet.h.new"
{
    head "the interface for C as one source. A program in C needs it and islet.cpp."
    printf '\n#include "islet.h"\n#include "islet.hpp"\n'
    (cd "$root/bindings/c/src" && cat types.inc.hpp glue.hpp && find . -name '*.cpp' | LC_ALL=C sort | xargs cat) |
        grep -v -E '^#include "|^#pragma once'
} >"$out/islet_c.cpp.new"

# Only now, so that no half-written file stays, and what did not change need not be compiled anew.
for name in islet.hpp islet.cpp islet_lcp.cpp islet.h islet_lcp.h islet_c.cpp; do
    if cmp -s "$out/$name.new" "$out/$name"; then rm "$out/$name.new"; else mv "$out/$name.new" "$out/$name"; fi
    printf '%s\n' "$out/$name"
done
