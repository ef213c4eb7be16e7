#!/usr/bin/env bash
# What Islet costs on small machines: flash, memory, stack, and instructions a step, each measured on the firmware of samples/firmware, which is
# built for every target and run in QEMU. Its hashes must be the host's.
#   tools/footprint.sh               a table. Flash is what the engine and the compiler's runtime take: all functions of the engine
#                                    together, what a large program links (samples/firmware/firmware.cpp), and what a small
#                                    one links (smallest.cpp). docs/microcontrollers.md says what the two use. A second table: ten boxes and a
#                                    ball in the small profile (drawer.cpp) on boards with little flash and memory
#   tools/footprint.sh --json        the same as JSON
#   tools/footprint.sh --write       the table, and its figures into docs/microcontrollers.md
#   tools/footprint.sh --check       the table (without the Cortex-M7, and some without all programs), and whether every figure keeps its limit: part of
#                                    tools/test.sh --release
#   tools/footprint.sh --check-few   the same of a Cortex-M4F, the small profile, and the board cortex-m0: part of tools/test.sh --all
#   tools/footprint.sh --c           what the C interface adds to a program of ten calls on a Cortex-M4F, and whether it is at most 500 bytes
#   tools/footprint.sh --options     what each feature in islet/config.hpp saves on a Cortex-M4F when ISLET_WITHOUT leaves it out alone
# Installs the cross compilers and QEMU with apt if they are missing.
set -euo pipefail
# shellcheck source=tools/lib.sh
. "$(dirname "$0")/lib.sh"

targets=(cortex-m3 cortex-m4f cortex-m4f-lto cortex-m7 cortex-m33 cortex-m55 riscv32)  # -lto: the engine optimised as a whole at the link (ISLET_LTO)

# Limits, so that nothing grows unseen: what was measured, and up to 200 bytes. Of flash for each target, bytes: every function, the large program, the small
# one. (They last rose with contacts that undo what their load makes them give way by, by 0.5 kB. Every function rose by 4 kB with those that read and change
# what could only be given at creation, and by 4 kB each with find_fault and with fleets, which no other function needs. All grew by 0.4 kB with pairs of bodies
# that fall together, and those with the solver's tuning by 0.7 kB with contacts that report the weight above them under shock propagation.
# The small one fell by 2 kB when the contact code of shapes that are left out went. Every function rose by 3.9 kB with exact_angles, which the large program
# leaves out; it rose by 0.4 kB. All rose by 0.3 kB with contacts that learn their loads before they fall asleep,
# and by 0.3 kB with tilted faces that undo deep overlaps. Every function rose by 2.8 kB with find_fault
# of what setters take, ranges of one body, and the recording of pushes that do not wake; all by 0.15 kB with shapes that can meet none in motion. It rose by
# 0.2 kB with what load checks of the room that an image claims, and all by 0.1 kB with joints and pairs that workers list, and again with bouncing in
# a function of its own. They fell, every function by 2.8 kB, with comparisons of whole numbers and fewer of GCC's optimisations, and rose by 0.08 kB with
# touches noted in a set of bits; the large one by 0.45 kB and the small one by 0.17 kB with shapes that are added to static bodies by themselves, and with
# trees of hinges whose first guess is to first order; the large one by 0.5 kB with trees judged by their energy, and every function by 1.7 kB with movers
# that share what their ground gains. All rose by 0.2 kB with deep overlaps that answer to how fast the shapes part, and with bevels that do not catch at seams;
# by 1.7 kB with floors whose pieces have gaps, round edges, or move; by 0.8 kB with manifolds that turn, and landings on gaps; and, with joints, by 0.2 kB with
# limits that take up heavy loads slowly, and by 1.6 kB with springs of welds that swing as asked, and gaps of exact trees that take no more energy than
# there is; all by 0.7 kB with motors and belts that keep awake what they move, and by 0.4 kB, up to 1.1 kB without a floating-point unit, with rows of two
# points that stand one after the other, which take an eighth fewer instructions; and by 1.1 kB with two tests for settled contacts, with
# contacts that land together, rebounds in six sweeps, and points that sink alike; by 1 kB with contacts that share stiffness, and with joints by 0.9 kB with
# what they bear in each substep; by 0.5 kB with what slides along faces, jams, and sensors of sleepers, and with joints by 0.2 kB with hinges that calls open;
# by 0.4 kB with deep overlaps that answer to what presses, contacts without a colour that differ, and what is swept beside trees; by 0.6 kB, and with joints
# by 0.5 kB more, with contacts between others, four more ways out of what nails bodies down, hinges that close from afar, and burdened trees;
# by 0.9 kB with contacts of what rolls, made for the middle of the step; by 0.1 kB with sharers of a contact that are counted in a time that does not grow
# with their square. Every function and the large program rose by 1.9 kB with boxes that meet corner to corner without the general search, and with trees of
# hinges that are planned one by one; the small one fell by 5.7 kB without hulls and seamless floors, and without the ways of bodies where there is no
# continuous collision. Rows that two blocks of lanes can take in turns cost all 0.03 kB, and take 0.6 % fewer instructions.)
declare -A most_flash=(
    [cortex-m3]='243100 110800 57800' [cortex-m4f]='222500 94950 49550' [cortex-m4f-lto]='- 89400 47150' [cortex-m7]='222500 94950 49550'
    [cortex-m33]='222500 94950 49550' [cortex-m55]='222900 95100 49600' [riscv32]='237450 101500 53650'
)
most_stack=4096          # bytes
most_instructions=600000       # a step of the pyramid, in the mean
most_soft_instructions=8150000 # the same without a floating-point unit

# Boards for which drawer.cpp alone is built, and their limits: flash (bytes), memory of the world (bytes), instructions of a step in the mean.
boards=(cortex-m0 stm32f103 riscv32imc)
declare -A most_on_board=([cortex-m0]='48050 11752 1780000' [stm32f103]='44050 11752 1100000' [riscv32imc]='55500 11752 1480000')

mode=table
few=false
for argument in "$@"; do
    case $argument in
    --json) mode=json ;;
    --check) mode=check ;;
    --check-few) mode=check few=true ;;
    --write) mode='write' ;;
    --c) mode=c ;;
    --options) mode=options ;;
    -h | --help)
        sed -n '2,15s/^# \{0,1\}//p' "$0"
        exit 0
        ;;
    *) die "$0: unknown option $argument; there are --json, --check, --check-few, --write, --c and --options" ;;
    esac
done

need_build_tools
need_firmware_tools
install_missing

# build_firmware FOLDER TARGET [OPTION...]: the programs, or `only` some of them, in build/firmware/FOLDER.
only=()
build_firmware() {
    local folder=$root/build/firmware/$1 target=$2
    shift 2
    cmake -S "$root/samples/firmware" -B "$folder" --toolchain "$root/samples/firmware/toolchains/$target.cmake" \
        -DCMAKE_COMPILE_WARNING_AS_ERROR=ON -DISLET_PRECOMPILE=ON "$@" >&2
    cmake --build "$folder" --parallel "$(jobs)" "${only[@]/#/--target=}" >&2
}

# share FOLDER PROGRAM LIBRARY [AWK ARGUMENT...]: bytes of code and constants that it puts into the image.
share() { awk -v library="$3" "${@:4}" -f "$root/tools/footprint/share.awk" "$1/$2.elf.map"; }

# flash FOLDER PROGRAM: the engine's and the compiler's runtime's. Of what is optimised at the link nothing but the engine is.
flash() { echo $(($(share "$1" "$2" libislet.a -v optimised=1) + $(share "$1" "$2" libgcc.a))); }

# What a program on the host prints, without what only a board can tell.
hashes() { sed -n 's/^\([a-z]*\) steps \([0-9]*\) hash \([0-9a-f]*\).*/\1 \2 \3/p'; }

# deepest_stack PLACE...: bytes that any function compiled there needs, and through which calls.
deepest_stack() { stack_from '' "$@"; }

# stack_from FUNCTION PLACE...: the same of one function, by its mangled name.
stack_from() { find "${@:2}" -name '*.ci' -print0 | sort -z | xargs -0 awk -v root="$root" -v start="$1" -f "$root/tools/footprint/stack.awk"; }

if [ "$mode" = options ]; then
    # The list itself: polygons last, for the smallest program needs them.
    mapfile -t parts < <(sed -nE 's/^ +FEATURE\(([a-z_]+).*/\1/p; s/^ +JOINT\(([a-z_]+).*/\1_joints/p' "$root/engine/include/islet/config.hpp" | grep -v '^polygons$')
    parts+=(joints polygons)
    build_firmware option cortex-m4f -DISLET_TRIMMED=OFF -DISLET_WITHOUT=
    programs=(whole firmware smallest)
    with=()
    for program in "${programs[@]}"; do with+=("$(flash "$root/build/firmware/option" "$program")"); done
    printf '%-18s %14s %14s %14s\n' 'without' 'every function' 'large program' 'small program'
    for part in "${parts[@]}"; do
        say "without $part"
        build_firmware option cortex-m4f -DISLET_TRIMMED=OFF "-DISLET_WITHOUT=$part"
        printf '%-18s' "$part"
        for i in "${!programs[@]}"; do printf ' %14d' $((with[i] - $(flash "$root/build/firmware/option" "${programs[i]}"))); done
        printf '\n'
    done
    exit 0
fi

if [ "$mode" = c ]; then
    # ten_calls PRINTED MOST NAME [OPTION...]: both programs, which must print the same. MOST: bytes that C may take more.
    ten_calls() {
        local printed=$1 most=$2 folder=$root/build/firmware/$3 program in_flash=()
        shift 3
        build_firmware "${folder##*/}" cortex-m4f -DISLET_C=ON -DISLET_TRIMMED=OFF "$@"
        ctest --test-dir "$folder" --tests-regex calls --verbose >"$folder/calls.log" 2>&1 || die "the programs fail: $folder/calls.log"
        diff <(sed -n 's/^1: \([0-9]\)/\1/p' "$folder/calls.log") <(sed -n 's/^2: \([0-9]\)/\1/p' "$folder/calls.log") ||
            die "C and C++ do not come to the same"
        for program in calls_cpp calls_c; do in_flash+=("$(arm-none-eabi-size -A "$folder/$program.elf" | awk '/^\.(text|rodata|data|ARM)/ { sum += $2 } END { print sum }')"); done
        printf '%-48s %8d %8d %6d\n' "$printed" "${in_flash[@]}" $((in_flash[1] - in_flash[0]))
        [ $((in_flash[1] - in_flash[0])) -le "$most" ] || die "$printed, the C interface adds more than $most bytes"
    }
    only=(calls_c calls_cpp)
    printf '%-48s %8s %8s %6s\n' 'flash, bytes' 'in C++' 'in C' 'more'
    # Where the link optimises, other functions of the engine are inlined in one program and not in the other, which is more than C's own.
    ten_calls 'file by file' 500 c
    ten_calls 'Islet optimised as a whole (ISLET_LTO)' 700 c-lto -DISLET_LTO=ON
    ten_calls 'Islet and the program optimised as a whole' 500 c-lto-program -DISLET_LTO=ON -DISLET_LTO_PROGRAM=ON
    exit 0
fi

say "the host"
[ -e "$root/build/release/CMakeCache.txt" ] || configure release -DISLET_BUILD_TESTS=OFF -DISLET_BUILD_TOOLS=OFF -DISLET_WERROR=OFF
build release --target firmware --target drawer
wanted=$("$root/build/release/samples/firmware/firmware" | hashes)

failed=false
complaints=()
complain() {
    failed=true
    complaints+=("$*")
}

# at_most TARGET WHAT VALUE LIMIT
at_most() { [ "$3" -le "$4" ] || complain "$1: $2 is $3, more than $4"; }

# The code of a Cortex-M7 and of an M33 is that of the M55 to a few hundred bytes, and so are its instructions.
if [ "$mode" = check ]; then targets=(cortex-m3 cortex-m4f cortex-m4f-lto cortex-m55 riscv32); fi
if $few; then
    targets=(cortex-m4f)
    boards=(cortex-m0)
fi

# write_figures: the manual's tables of targets and of worlds, row by row, from `rows` and `worlds`. A row is known by its target, or by its first numbers.
write_figures() {
    local page=$root/docs/microcontrollers.md new
    new=$(mktemp)
    awk -v boards="$(printf '%s\n' "${board_rows[@]}")" -v targets="$(printf '%s\n' "${rows[@]}")" -v worlds="$worlds" '
        function spaced(n,  text) {
            for (text = ""; length(n) > 3; n = substr(n, 1, length(n) - 3)) text = " " substr(n, length(n) - 2) text
            return n text
        }
        BEGIN {
            count = split(targets, line, "\n")
            for (i = 1; i <= count; ++i) {
                split(line[i], t, " +")
                made["| " t[1] " |"] = "| " t[1] " | " spaced(t[3]) " | " spaced(t[4]) " | " spaced(t[5]) " | " spaced(t[6]) " | " spaced(t[7]) " | " spaced(t[8]) " |"
            }
            count = split(boards, line, "\n")
            for (i = 1; i <= count; ++i) {
                split(line[i], t, " +")
                made["| `" t[1] "` |"] = "| `" t[1] "` | " spaced(t[2]) " | " spaced(t[3]) " | " spaced(t[4]) " | " spaced(t[5]) " |"
            }
            count = split(worlds, line, "\n")
            for (i = 1; i <= count; ++i) {
                split(line[i], t, " +")
                key = "| " t[1] " | " t[3] " | " t[4] " | " t[5] " |"
                made[key] = key " " spaced(t[6]) " |"
            }
        }
        {
            for (key in made) if (index($0, key) == 1) { $0 = made[key]; break }
            print
        }' "$page" >"$new"
    cat "$new" >"$page"
    rm -f "$new"
}

rows=()   # the table
items=()  # the JSON
worlds=
for target in "${targets[@]}"; do
    say "$target"
    folder=$root/build/firmware/$target
    only=()
    tests=()
    case $mode-$target in
    *-lto)
        build_firmware "$target" "${target%-lto}" -DISLET_LTO=ON
        programs=(firmware smallest)
        graphs=$folder/firmware.elf.ltrans0.ltrans.ci
        sizes=(-)
        ;;
    check-cortex-m3 | check-riscv32) # every function: a Cortex-M4F's tell
        only=(firmware smallest)
        tests=(--tests-regex '^(firmware|smallest)$')
        build_firmware "$target" "$target"
        programs=("${only[@]}")
        graphs=$folder/CMakeFiles/islet_firmware.dir
        sizes=(-)
        ;;
    check-cortex-m55) # the other programs are those of a Cortex-M4F to a few bytes
        only=(firmware)
        tests=(--tests-regex '^firmware$')
        build_firmware "$target" "$target"
        programs=("${only[@]}")
        graphs=$folder/CMakeFiles/islet_firmware.dir
        sizes=(-)
        ;;
    *)
        build_firmware "$target" "$target"
        programs=(whole firmware smallest)
        graphs=$folder/CMakeFiles/islet_whole.dir
        sizes=()
        ;;
    esac

    # "firmware" prints what its scenes came to; ctest knows how to run it.
    status=0
    log=$(ctest --test-dir "$folder" --verbose "${tests[@]}" 2>&1) || status=$?
    printed=$(sed -n 's/^1: //p' <<<"$log")
    [ "$status" -eq 0 ] || complain "$target: the firmware fails: $(grep -E 'fault|\*\*\*' <<<"$log" | head -n 3)"
    [ "$(hashes <<<"$printed")" = "$wanted" ] || complain "$target: the hashes are not the host's: $(hashes <<<"$printed" | tr '\n' ' ')"

    read -r -a limits <<<"${most_flash[$target]}"
    for program in "${programs[@]}"; do
        at_most "$target" "flash of $program" "$(flash "$folder" "$program")" "${limits[${#sizes[@]}]}"
        sizes+=("$(flash "$folder" "$program")")
    done
    stack=$(deepest_stack "$graphs") || complain "$target: nothing bounds the engine's stack"
    deepest=${stack%% *}
    [ -d "$graphs" ] && graphs=$folder/CMakeFiles/islet_firmware.dir
    stack=$(deepest_stack "$graphs" "$folder/CMakeFiles/firmware.dir") || complain "$target: nothing bounds the firmware's stack"
    bound=${stack%% *}
    per_step() { sed -n "s/^$1 .* instructions \([0-9]*\) .*/\1/p" <<<"$printed"; }
    pyramid=$(per_step pyramid) ragdoll=$(per_step ragdoll) circles=$(per_step circles)
    worlds=$(sed -n 's/^world //p' <<<"$printed")

    at_most "$target" 'the deepest stack' "$deepest" "$most_stack"
    # The graphs do not know memcpy and the compiler's runtime: a few words.
    at_most "$target" "the stack that the firmware used" "$(sed -n 's/^stack //p' <<<"$printed")" $((bound + 64))
    if [ "$target" = cortex-m3 ]; then most=$most_soft_instructions; else most=$most_instructions; fi
    at_most "$target" 'instructions a step of the pyramid' "$pyramid" "$most"

    [ ${#sizes[@]} -eq 3 ] || sizes+=(-)
    rows+=("$(printf '%-14s %9s %8s %9s %7d %9d %9d %9d' "$target" "${sizes[@]}" "$deepest" "$pyramid" "$ragdoll" "$circles")")
    items+=("$(printf '{"target": "%s", "flash": {"every_function": %s, "every_feature": %s, "smallest": %s}, "stack": %d, ' \
        "$target" "${sizes[@]/-/null}" "$deepest")$(printf '"instructions": {"pyramid": %d, "ragdoll": %d, "circles": %d}}' \
        "$pyramid" "$ragdoll" "$circles")")
done

# "drawer" on boards with little, against the host's whole engine. The F103's flash holds it if the engine is optimised as a whole.
board_rows=()
only=(drawer)
wanted_drawer=$("$root/build/release/samples/firmware/drawer" | hashes)
for target in "${boards[@]}"; do
    say "$target"
    folder=$root/build/firmware/$target
    case $target in
    stm32f103) build_firmware "$target" "$target" -DISLET_LTO=ON ;;
    *) build_firmware "$target" "$target" ;;
    esac
    status=0
    log=$(ctest --test-dir "$folder" --no-tests=error --tests-regex drawer --verbose 2>&1) || status=$?
    printed=$(sed -n 's/^[0-9]*: //p' <<<"$log")
    [ "$status" -eq 0 ] || complain "$target: drawer fails: $(grep -E 'fault|\*\*\*|No tests' <<<"$log" | head -n 3)"
    [ "$(hashes <<<"$printed")" = "$wanted_drawer" ] || complain "$target: the hash of drawer is not the host's"
    read -r -a limits <<<"${most_on_board[$target]}"
    measured=("$(flash "$folder" drawer)" "$(sed -n 's/^memory //p' <<<"$printed")" "$(sed -n 's/^drawer .* instructions \([0-9]*\) .*/\1/p' <<<"$printed")")
    whats=('flash' 'memory of the world' 'instructions a step')
    for i in 0 1 2; do at_most "$target" "${whats[i]}" "${measured[i]}" "${limits[i]}"; done
    board_rows+=("$(printf '%-14s %9d %8d %9d %9d' "$target" "${measured[0]}" "${measured[1]}" "$(sed -n 's/^stack //p' <<<"$printed")" "${measured[2]}")")
done

# The smallest program in the small profile; both folders were built above.
if $few; then
    only=(small)
    build_firmware cortex-m4f-lto cortex-m4f -DISLET_LTO=ON
fi
profile=("$(flash "$root/build/firmware/cortex-m4f" small)" "$(flash "$root/build/firmware/cortex-m4f-lto" small)")
at_most cortex-m4f 'flash of the small profile' "${profile[0]}" 36950
at_most cortex-m4f-lto 'flash of the small profile' "${profile[1]}" 35400
stack=$(stack_from _ZN5islet5World4stepEf "$root/build/firmware/cortex-m4f/CMakeFiles/islet_drawer.dir" 2>/dev/null) || true  # (create calls by pointer)
step_stack=${stack%% *}
at_most cortex-m4f 'the stack of a step in the small profile' "$step_stack" 1300

# What a Cortex-M4F takes without what can be left out, and whether that is refused.
measure_cut() {
    say "a Cortex-M4F without what can be left out"
    local log status=0
    only=()
    build_firmware cortex-m4f-cut cortex-m4f -DISLET_TRIMMED=OFF \
        '-DISLET_WITHOUT=shortcuts;capsules;segments;half_spaces;chains;hulls;restitution;surfaces;sleep;bullets;sensors;hits;hooks;one_way;disabling;queries;recorder;tuning;profile;joints'
    log=$(ctest --test-dir "$root/build/firmware/cortex-m4f-cut" --no-tests=error --tests-regex refusals --verbose 2>&1) || status=$?
    [ "$status" -eq 0 ] || complain "what is left out: $(grep -E 'refused|fault|\*\*\*|No tests' <<<"$log" | head -n 3)"
    [ "$(sed -n 's/^[0-9]*: //p' <<<"$log" | hashes)" = "$(head -n 1 <<<"$wanted")" ] ||
        complain "what is left out changes the pyramid"
    cut=$(flash "$root/build/firmware/cortex-m4f-cut" smallest)
    at_most 'cortex-m4f' 'flash of the smallest program with all left out' "$cut" 49900
}
cut=
$few || measure_cut

if [ "$mode" = json ]; then
    separator=
    printf '{"targets": ['
    for item in "${items[@]}"; do
        printf '%s\n  %s' "$separator" "$item"
        separator=,
    done
    separator=
    printf '],\n "smallest_with_all_left_out": %d,\n "worlds": [' "$cut"
    while read -r bodies shapes contacts joints geometries bytes; do
        printf '%s\n  {"bodies": %d, "shapes": %d, "contacts": %d, "joints": %d, "geometries": %d, "bytes": %d}' \
            "$separator" "$bodies" "$shapes" "$contacts" "$joints" "$geometries" "$bytes"
        separator=,
    done <<<"$worlds"
    printf ']}\n'
else
    printf '%-14s %28s %7s %29s\n' '' 'flash, bytes' 'stack,' 'instructions a step'
    printf '%-14s %9s %8s %9s %7s %9s %9s %9s\n' '' 'every' 'large' 'small' '' '' '' '64'
    printf '%-14s %9s %8s %9s %7s %9s %9s %9s\n' 'target' 'function' 'program' 'program' 'bytes' 'pyramid' 'ragdoll' 'balls'
    printf '%s\n' "${rows[@]}"
    $few || printf 'Boxes and balls with all left out that can be (ISLET_WITHOUT), on the Cortex-M4F: %d bytes.\n' "$cut"
    printf 'Boxes and balls in the small profile, on the Cortex-M4F: %d bytes; optimised at the link %d. A step needs %d bytes of stack.\n' \
        "${profile[@]}" "$step_stack"
    printf '\n%-14s %9s %8s %9s %9s\n' 'ten boxes, ball' 'flash' 'memory' 'stack' 'a step'
    printf '%s\n' "${board_rows[@]}"
    printf '\n%8s %8s %8s %8s %10s %14s\n' 'bodies' 'shapes' 'contacts' 'joints' 'geometries' 'memory, bytes'
    while read -r bodies shapes contacts joints geometries bytes; do
        printf '%8d %8d %8d %8d %10d %14d\n' "$bodies" "$shapes" "$contacts" "$joints" "$geometries" "$bytes"
    done <<<"$worlds"
fi
if [ "$mode" = write ]; then write_figures; fi
if $failed && [ "$mode" != table ]; then
    printf '%s\n' "${complaints[@]}" >&2
    exit 1
fi
[ ${#complaints[@]} -eq 0 ] || printf '%s\n' "${complaints[@]}" >&2
