#!/usr/bin/env bash
# The same bits on every processor: builds the engine, the scenes and the program that compares hashes with golden.txt for other processors, runs it
# there under an emulator, and prints one line per target, as they end. Episodes of the environments for learning, which the test python.episodes has recorded in
# build/release/episodes, are replayed there, too.
#   tests/determinism/targets.sh [--few] [--steps N] [WORK_FOLDER]
# --few: those four that differ most, in lanes, byte order, width and calls.
# Emulators are slow, so the scenes run to their checkpoints of at most N steps (60 unless given), and the benchmark scenes are left out. Exit status 1
# if a hash differs or a build fails. A target whose compiler or emulator is missing is left out by name. (Microcontrollers: tools/footprint.sh; other
# compilers and flags on this machine: matrix.sh.)
set -euo pipefail

root=$(cd "$(dirname "$0")/../.." && pwd)
steps=60
few=false
if [ "${1:-}" = --few ]; then
    few=true
    shift
fi
if [ "${1:-}" = --steps ]; then
    steps=$2
    shift 2
fi
work=${1:-$(mktemp -d)}
temporary=$([ $# -ge 1 ] && echo false || echo true)
tidy() {
    mapfile -t started < <(jobs -p)
    [ ${#started[@]} -eq 0 ] || kill "${started[@]}" 2>/dev/null || true
    if $temporary; then rm -rf "$work"; fi
}
trap tidy EXIT
mkdir -p "$work"
work=$(cd "$work" && pwd)  # Wine wants its folder's whole path
# shellcheck source=tests/determinism/build.sh
. "$root/tests/determinism/build.sh"

# under_wine PROGRAM ARGUMENT...: a program for Windows, with a folder of Wine's own. (The linker has added ".exe" to the name. Wine's stderr is about itself.)
under_wine() { WINEPREFIX=$work/wine WINEDEBUG=-all wine "$1.exe" "${@:2}" 2>/dev/null | tr -d '\r'; }

# in_32_bits PROGRAM ARGUMENT...: on this processor, or under an emulator where the (virtual) machine runs no programs of 32 bits.
in_32_bits() {
    local status=0 cannot_run=126
    "$1" >/dev/null 2>&1 || status=$? # which says how it is used
    if [ "$status" -eq "$cannot_run" ]; then qemu-i386 "$@"; else "$@"; fi
}

# Running is work for one core, compiling for many: a core each for as many targets at once keeps all of them busy.
at_once=$jobs
jobs=1
recordings=()
for recording in "$root"/build/release/episodes/*.recording; do
    if [ -e "$recording" ]; then recordings+=(--recording "$recording"); fi
done
[ ${#recordings[@]} -ne 0 ] || echo "no episodes to replay: build the package for Python, and run ctest -R python.episodes" >&2
running=0
rm -f "$work/failed"
report() { printf '%-12s %-30s %-6s %s\n' "$@"; }

# check ...: check_one in the background. (What ended before `wait -n` began has left no status, so a failure is a file.)
check() {
    if [ "$running" -ge "$at_once" ]; then
        wait -n || true
        running=$((running - 1))
    fi
    { check_one "$@" || touch "$work/failed"; } &
    running=$((running + 1))
}

# check_one NAME PROCESSOR LANES RUN... -- COMPILER FLAG... [-- LINK_FLAG...]: RUN is what the program is started by, and may be nothing.
check_one() {
    local name=$1 processor=$2 lanes=$3 workers=1 run=() link=() result status=0 folder=$work/$1
    # A processor of 32 bits without vectors has no set of pairs, so its workers look for pairs in another way.
    if [ "$processor" = armv7l ]; then workers=1,2; fi
    shift 3
    while [ "$1" != -- ]; do
        run+=("$1")
        shift
    done
    shift
    local command=()
    while [ $# -gt 0 ] && [ "$1" != -- ]; do
        command+=("$1")
        shift
    done
    if [ $# -gt 0 ]; then
        shift
        link=("$@")
    fi
    for needed in "${command[0]}" "${run[@]:0:1}"; do
        if ! command -v "$needed" >/dev/null 2>&1; then
            report "$name" "${command[0]}" "$lanes" "left out: there is no $needed"
            return
        fi
    done
    if {
        build_scenes "$folder-scenes" "$processor" "${command[@]}" &&
            build_engine "$folder" "$processor" "${command[@]}" &&
            "${command[@]}" "$folder"/*.o "$folder-scenes"/*.o "${link[@]}" -o "$folder/hashes"
    } >"$work/$name.log" 2>&1; then
        result=$("${run[@]}" "$folder/hashes" "$root/tests/determinism/golden.txt" --lanes "$lanes" --workers "$workers" --most-steps "$steps" --large-steps 0 "${recordings[@]}" 2>&1) || status=$?
    else
        result="does not build: $(grep -m 1 -E 'error|undefined' "$work/$name.log" || tail -n 1 "$work/$name.log")"
        status=1
    fi
    report "$name" "$(basename "${command[0]}") $(printf '%s\n' "${command[@]}" | grep -m 1 -E '^-O')" "$lanes" "$result"
    return "$status"
}

report target compiler lanes "scenes up to $steps steps, without the benchmark scenes"
# The slowest emulators first.
check aarch64 aarch64 1,4 qemu-aarch64 -- aarch64-linux-gnu-g++ -O2 -- -static
check s390x s390x 1 qemu-s390x -- s390x-linux-gnu-g++ -O2 -- -static
if ! $few; then
    check armhf armv7l 1 qemu-arm -- arm-linux-gnueabihf-g++ -O2 -- -static
    check riscv64 riscv64 1 qemu-riscv64 -- riscv64-linux-gnu-g++ -O2 -- -static -Wl,--no-relax  # which takes 8 s
fi
llvm=/usr/lib/llvm-16
wasm=(clang++-16 --target=wasm32-wasi -O2 -cxx-isystem "$llvm/include/wasm32-wasi/c++/v1")
# Not optimised once more at the link, by Binaryen: that takes 15 s, and Emscripten does it below.
wasm_link=(-O0 -std=c++20 "-L$llvm/lib/wasm32-wasi" "$root/tests/determinism/wasm_throw.cpp" "-Wl,-z,stack-size=1048576")
if ! $few; then check wasm wasm32 1 node --no-warnings "$root/tests/determinism/wasi.mjs" -- "${wasm[@]}" -- "${wasm_link[@]}"; fi
check wasm-simd wasm32 1,4 node --no-warnings "$root/tests/determinism/wasi.mjs" -- "${wasm[@]}" -msimd128 -- "${wasm_link[@]}"
if ! $few; then
    export NODE_PATH=/usr/share/nodejs # Debian's Emscripten has a part there, where only Debian's Node.js looks by itself
    emscripten_link=(-sNODERAWFS=1 -sALLOW_MEMORY_GROWTH=1 -sTOTAL_STACK=1048576 -fexceptions)
    check emscripten wasm32 1,4 node --no-experimental-fetch -- em++ -O2 -fexceptions -msimd128 -- "${emscripten_link[@]}"
    # Unoptimised, with the instructions of this very machine at hand. (Optimised by both compilers: by_hand.sh.)
    check x86-64 x86_64 1,4,8 -- g++ -O0 -march=native
    if command -v wine >/dev/null 2>&1; then
        check windows x86_64 1,4,8 under_wine -- x86_64-w64-mingw32-g++-posix -O2 -- -static
    else
        report windows wine 1,4,8 "left out: there is no wine"
    fi
fi
# (The 32-bit library alone, without the package that clashes with cross compilers, leaves <asm/...> where the 64-bit one has it.)
check x86-32 i686 1,4 in_32_bits -- g++-12 -m32 -O2 -msse2 -idirafter /usr/include/x86_64-linux-gnu
wait
if [ -e "$work/failed" ]; then exit 1; fi
