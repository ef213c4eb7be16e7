#!/usr/bin/env bash
# The same bits from every compiler, at every optimisation level: builds the engine and a small program that compares hashes with golden.txt, by g++
# and clang++ at -O0 to -O3 and -O3 -march=native, and once more for a user who compiles and links with -ffast-math.
#   tests/determinism/matrix.sh [WORK_FOLDER]
# Small scenes run to their near checkpoint in all builds and to their far one in some optimised ones; the benchmark scenes run to their near one.
# Each at lanes 1, 4, 8 and 16. The scenes themselves are built once per compiler, with the same flags for exactness as the engine. Prints one line per
# build; exit status 1 if a hash differs or a build fails. Takes about two minutes on two cores. Other processors: targets.sh.
set -euo pipefail

root=$(cd "$(dirname "$0")/../.." && pwd)
work=${1:-$(mktemp -d)}
[ $# -ge 1 ] || trap 'rm -rf "$work"' EXIT
mkdir -p "$work"
# shellcheck source=tests/determinism/build.sh
. "$root/tests/determinism/build.sh"
processor=$(uname -m)

# build NAME COMPILER FLAG...: the program NAME/hashes.
build() {
    local folder=$work/$1 compiler=$2
    build_scenes "$work/$compiler-scenes" "$processor" "$compiler" -O2 -march=native || return
    shift
    build_engine "$folder" "$processor" "$@" || return
    "$@" "$folder"/*.o "$work/$compiler-scenes"/*.o -o "$folder/hashes"
}

failed=false
# check NAME MOST_STEPS COMPILER FLAG...
check() {
    local name=$1 most_steps=$2 compiler=$3 result status=0
    shift 3
    if ! command -v "$compiler" >/dev/null 2>&1; then
        printf '%-24s left out: there is no %s\n' "$name" "$compiler"
        return
    fi
    if build "$name" "$compiler" "$@" >"$work/$name.log" 2>&1; then
        result=$("$work/$name/hashes" "$root/tests/determinism/golden.txt" --lanes 1,4,8,16 --most-steps "$most_steps" --large-steps "${large_steps:-10}" 2>&1) || status=$?
    else
        result="does not build: $(grep -m 1 -E 'error|undefined' "$work/$name.log" || tail -n 1 "$work/$name.log")"
        status=1
    fi
    [ "$status" -eq 0 ] || failed=true
    printf '%-24s %s\n' "$name" "$result"
}

for compiler in g++ clang++; do
    # Unoptimised code is ten times slower: its large scenes, which take seconds a step there, are those of the optimised builds only.
    large_steps=0 check "$compiler-O0" 60 "$compiler" -O0
    check "$compiler-O1" 60 "$compiler" -O1
    check "$compiler-O2" 60 "$compiler" -O2
    check "$compiler-O3" 60 "$compiler" -O3
    check "$compiler-O3-native" 1000000 "$compiler" -O3 -march=native
    check "$compiler-fast-math" 1000000 "$compiler" -O3 -march=native -ffast-math
done
if $failed; then exit 1; fi
