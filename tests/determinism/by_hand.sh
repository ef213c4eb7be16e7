#!/usr/bin/env bash
# The engine without CMake, and under flags that ruin results elsewhere: each build comes to the golden hashes, or is refused with its sentence.
#   tests/determinism/by_hand.sh [--few] [WORK_FOLDER]
# --few: the manual's by Clang, one by GCC under flags that ruin results, the refusals, and the sizes.
# First, by each compiler, file by file as docs/using-islet.md says, with all objects in one folder; then with flags of the user's own, many files as one (build.sh).
# The scenes and the program are built once by GCC, with exact flags: only what the engine is compiled with differs. The engine of some rows is C++17; their
# scenes, which are C++20, take its spans, and are built once more. Prints one line per build, as they end; exit
# status 1 if one is not as it must be. What is missing is left out by name. Takes five minutes of processor time.
set -euo pipefail

root=$(cd "$(dirname "$0")/../.." && pwd)
few=false
if [ "${1:-}" = --few ]; then
    few=true
    shift
fi
work=${1:-$(mktemp -d)}
[ $# -ge 1 ] || trap 'rm -rf "$work"' EXIT
mkdir -p "$work"
work=$(cd "$work" && pwd)
# shellcheck source=tests/determinism/build.sh
. "$root/tests/determinism/build.sh"
processor=$(uname -m)

# What shows first that bits were lost: stacks, joints, rolling, continuous collision, and a crowd of which few move.
scenes=()
for scene in hello pyramid card_house car ragdoll bullets hourglass confined; do scenes+=(--scene "$scene"); done

# Linking and running are work for one core: a core each for as many rows at once keeps all of them busy.
at_once=$jobs
jobs=1
running=0
rm -f "$work/failed"
failed=false  # within a row
# row ...: in the background. (What ended before `wait -n` began has left no status, so a failure is a file.)
row() {
    if [ "$running" -ge "$at_once" ]; then
        wait -n || true
        running=$((running - 1))
    fi
    { "$@" && ! $failed; } || touch "$work/failed" &
    running=$((running + 1))
}

report() { printf '%-18s %-44s %s\n' "$@"; }
first_complaint() { grep -m 1 -E 'error|undefined' "$1" || tail -n 1 "$1"; }

# is_there NAME PROGRAM
is_there() {
    command -v "$2" >/dev/null 2>&1 && return
    report "$1" "$2" "left out: there is no $2"
    return 1
}

# judge WANTED STATUS RESULT: WANTED is `same`, or words of the refusal.
judge() {
    case $1 in
    same) [ "$2" -eq 0 ] || failed=true ;;
    *) { [ "$2" -ne 0 ] && grep -q "$1" <<<"$3"; } || failed=true ;;
    esac
}

# as_manual FOLDER COMMAND...: the manual's command, in FOLDER; here for as many files at once as there are cores.
as_manual() {
    local folder=$1
    shift
    (cd "$folder" && printf '%s\n' "$root"/engine/src/*/*.cpp | xargs -P "$jobs" -n 8 "$@" -I "$root/engine/include" -c)
}

# quickly FOLDER COMMAND...: the engine in three files.
quickly() {
    local folder=$1 source
    shift
    find "$root/engine/src" -name '*.cpp' ! -path '*/lcp/*' ! -name '*_avx*.cpp' | sort | as_one "$folder/engine.cpp"
    for source in "$folder/engine.cpp" "$root"/engine/src/*/*_avx*.cpp; do
        "$@" -I "$root/engine/include" -c "$source" -o "$folder/$(basename "$source" .cpp).o" || return
    done
}

# build_user [FLAG]: the scenes and the program.
build_user() {
    local user=$work/user${1:-}
    build_scenes "$user" "$processor" g++ "$@" &&
        g++ -std=c++20 -O1 -ffp-contract=off "$@" -I "$root/engine/include" -I "$root/samples" -c "$root/tests/determinism/hashes.cpp" -o "$user/program.o"
}

own_span=-DISLET_STD_SPAN=0

# link_and_run FOLDER STANDARD COMPILER: prints what the program ends with.
link_and_run() {
    local user=$work/user
    [ "$2" = -std=c++20 ] || user+=$own_span
    "$3" "$1"/*.o "$user"/*.o -pthread -o "$1/hashes" || return
    "$1/hashes" "$root/tests/determinism/golden.txt" --most-steps 60 --lanes 1,4,8,16 "${scenes[@]}" 2>&1 | tail -n 1
}

# check WANTED NAME HOW COMPILER FLAG...: HOW is as_manual or quickly. C++20, unless a flag names a standard.
check() {
    local wanted=$1 name=$2 how=$3 compiler=$4 folder=$work/$2 result='' status=0 standard=-std=c++20 flag
    shift 3
    for flag in "$@"; do case $flag in -std=*) standard=$flag ;; esac done
    is_there "$name" "$compiler" || return 0
    rm -rf "$folder" && mkdir -p "$folder"
    "$how" "$folder" "$1" "$standard" "${@:2}" >"$work/$name.log" 2>&1 || status=$?
    if [ "$status" -eq 0 ]; then result=$(link_and_run "$folder" "$standard" "$compiler" 2>>"$work/$name.log") || status=$?; fi
    result=${result:-$(first_complaint "$work/$name.log")}
    judge "$wanted" "$status" "$result"
    report "$name" "$*" "$result"
}

# refused NAME COMPILER FLAG...: no file of the engine compiles.
refused() {
    local name=$1 status=0
    shift
    is_there "$name" "$1" || return 0
    "$@" -std=c++20 -I "$root/engine/include" -c "$root/engine/src/math/vector.cpp" -o "$work/$name.o" >"$work/$name.log" 2>&1 || status=$?
    judge 'Islet cannot keep its bits' "$status" "$(first_complaint "$work/$name.log")"
    report "$name" "$*" "$(first_complaint "$work/$name.log" | sed 's/.*Islet cannot/refused: Islet cannot/')"
}

# What a program takes for a world's size must not depend on its flags. same_size NAME COMPILER FLAG...
same_size() {
    local name=$1 compiler=$2 flags=("${@:3}") sizes=() flag
    is_there "$name" "${compiler%% *}" || return 0
    cat >"$work/$name.cpp" <<'END'
#include "islet/layout.hpp"
extern constexpr unsigned bytes_of_a_world = unsigned(islet::world_bytes({.bodies = 64, .shapes = 64, .contacts = 256, .joints = 16}));
END
    for flag in '' "${flags[@]}"; do
        # shellcheck disable=SC2086  # several flags, or none
        sizes+=("$($compiler -std=c++20 $flag -I "$root/engine/include" -S "$work/$name.cpp" -o - | grep -A 9 '^bytes_of_a_world:' | grep -m 1 -oE '[0-9]{4,}' | head -n 1 || echo '?')")
    done
    result="${sizes[*]}"
    [ "$(printf '%s\n' "${sizes[@]}" | sort -u | wc -l)" -eq 1 ] && [ "${sizes[0]}" != '?' ] || failed=true
    report "$name" "${compiler%% -cxx*} [${flags[*]}]" "$result bytes"
}

# build_host: the firmware for this machine, in the folder `host`.
build_host() {
    local here=$root/samples/firmware
    rm -rf "$work/host" && mkdir -p "$work/host"
    quickly "$work/host" g++ -std=c++20 -O0 &&
        g++ -std=c++20 -ffp-contract=off -I "$root/engine/include" "$here"/{firmware,scenes,floats,board_host,console}.cpp "$work"/host/*.o -o "$work/host/firmware"
}

# board NAME FLAG...: the firmware by hand, on an emulated Cortex-M4F; its hashes must be those of the host's.
board() {
    local name=$1 folder=$work/$1 status=0 result here=$root/samples/firmware command source
    shift
    { is_there "$name" arm-none-eabi-g++ && is_there "$name" qemu-system-arm; } || return 0
    rm -rf "$folder" && mkdir -p "$folder"
    hashes_of() { sed -n 's/^\([a-z]*\) steps \([0-9]*\) hash \([0-9a-f]*\).*/\1 \2 \3/p'; }
    command=(arm-none-eabi-g++ -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -ffreestanding -std=c++20 -fno-exceptions -fno-rtti -fno-threadsafe-statics
        -ffunction-sections -fdata-sections -fno-tree-loop-distribute-patterns)
    {
        quickly "$folder" "${command[@]}" -DISLET_THREADS=0 "$@" &&
            for source in firmware scenes floats board_cortex_m console runtime; do
                "${command[@]}" -Os -ffp-contract=off "${@:1:1}" -I "$root/engine/include" -c "$here/$source.cpp" -o "$folder/$source.o" || break
            done &&
            "${command[@]}" "${@:1:1}" "$folder"/*.o -nostdlib -static -Wl,-T,"$here/firmware.ld",--gc-sections,--entry=reset \
                -Wl,--defsym=flash_origin=0,--defsym=flash_length=0x80000,--defsym=ram_origin=0x20000000,--defsym=ram_length=0x40000,--defsym=stack_length=4096 \
                -lgcc -o "$folder/firmware.elf" &&
            qemu-system-arm -machine mps2-an386 -icount shift=0 -display none -monitor none -serial none \
                -semihosting-config enable=on,target=native -kernel "$folder/firmware.elf" >"$folder/board.txt" 2>&1 &&
            "$work/host/firmware" >"$folder/host.txt" &&
            diff <(hashes_of <"$folder/host.txt") <(hashes_of <"$folder/board.txt")
    } >"$work/$name.log" 2>&1 || status=$?
    if [ "$status" -eq 0 ]; then result="$(hashes_of <"$folder/board.txt" | grep -c .) hashes, the host's"; else result=$(first_complaint "$work/$name.log"); fi
    judge same "$status" "$result"
    report "$name" "arm-none-eabi-g++ $*" "$result"
}

(
    { build_user || touch "$work/failed"; } >"$work/user.log" 2>&1 &
    if ! $few; then
        { build_user "$own_span" || touch "$work/failed"; } >"$work/user-own-span.log" 2>&1 &
        { build_host || touch "$work/failed"; } >"$work/host.log" 2>&1 &
    fi
    wait
)
# The longest first.
row check same by-hand-clang++ as_manual clang++ -O1
if ! $few; then
    row check same by-hand-g++ as_manual g++ -O1  # optimised more: below
    row board cortex-m4f-softfp -mfloat-abi=softfp -O2
    row board cortex-m4f-fast -mfloat-abi=hard -O3 -ffast-math -funsigned-char
    row check same cpp17-clang++ quickly clang++ -Os -std=gnu++17 -mfma -funsigned-char
    row check same cpp17-g++ quickly g++ -O2 -std=gnu++17 -mfma -funsigned-char
    row check "floats are not IEEE's" contract-clang++ quickly clang++ -O1 -mfma -ffp-contract=fast
fi
row check same fast-g++ quickly g++ -O3 -march=native -ffast-math -DISLET_WITHOUT_shortcuts  # which must not decide anything
row refused x87 g++ -m32 -O2
row refused fast-clang++ clang++ -O3 -march=native -ffast-math
row refused finite-clang++ clang++ -O2 -ffinite-math-only
row same_size size g++ -march=native -mno-sse4
row same_size size-clang++ clang++ -march=native
row same_size size-wasm 'clang++-16 --target=wasm32-wasi -cxx-isystem /usr/lib/llvm-16/include/wasm32-wasi/c++/v1' -msimd128
row same_size size-aarch64 aarch64-linux-gnu-g++ -march=armv8.2-a+sve
wait
if [ -e "$work/failed" ]; then exit 1; fi
