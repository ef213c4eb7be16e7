#!/usr/bin/env bash
# boards_test.sh ISLET CMAKE BALLS MARBLE_MAZE ROBOT_ARM: the library that tools/package.sh makes has what each format asks for (library_manifests.py); its
# CMake files name what is there; it is made alike twice, and over nothing else; the sketches do on the host what their first lines say;
# and the balls are the same in the small profile.
set -euo pipefail

islet=$1 cmake=$2 balls=$3 maze=$4 arm=$5
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failed=false
fail() {
    printf 'FAILED: %s\n' "$*"
    failed=true
}

library=$scratch/Islet
"$islet/tools/package.sh" "$library" >/dev/null
"$islet/tools/package.sh" "$scratch/again" >/dev/null && "$islet/tools/package.sh" "$scratch/again" >/dev/null
diff -r "$library" "$scratch/again" || fail "a second run writes something else"
mkdir "$scratch/precious" && echo data >"$scratch/precious/file"
if "$islet/tools/package.sh" "$scratch/precious" 2>/dev/null || [ ! -e "$scratch/precious/file" ]; then fail "a folder of somebody else's is replaced"; fi
"$islet/tools/package.sh" --url https://example.com/here "$scratch/there" >/dev/null
grep -q '^url=https://example.com/here$' "$scratch/there/library.properties" || fail "--url has no effect"

python3 "$islet/tests/package/library_manifests.py" "$islet" "$library" || fail "the manifests"

# Where Arduino.h defines macros with names of Islet's, as the stub's does.
for sketch in "$library"/examples/*/*.ino; do
    g++ -std=gnu++17 -Wall -Wextra -Werror -fsyntax-only -DSKETCH_FILE="\"$sketch\"" -DSKETCH_NAME='""' -DSKETCH_FRAMES=1 -DSKETCH_SHOWN=1 \
        -I "$islet/samples/boards/stub" -I "$library/src" "$islet/samples/boards/stub/stub.cpp" || fail "$sketch does not compile"
done

# The CMake files, with functions of ESP-IDF's and Zephyr's names that look whether the files are there.
cat >"$scratch/check.cmake" <<'END'
function(idf_component_register)
    cmake_parse_arguments(ARG "" "" "SRCS;INCLUDE_DIRS" ${ARGN})
    foreach(name ${ARG_SRCS} ${ARG_INCLUDE_DIRS})
        if(NOT EXISTS ${LIBRARY}/${name})
            message(FATAL_ERROR "ESP-IDF: there is no ${name}")
        endif()
    endforeach()
    message("idf ${ARG_SRCS}")
endfunction()
foreach(function zephyr_include_directories zephyr_library_sources)
    function(${function})
        foreach(name ${ARGN})
            if(NOT EXISTS ${LIBRARY}/zephyr/${name})
                message(FATAL_ERROR "Zephyr: there is no ${name}")
            endif()
        endforeach()
        message("zephyr ${ARGN}")
    endfunction()
endforeach()
function(zephyr_library_named)
endfunction()
function(zephyr_compile_definitions name)
    message("definition of all ${name}")
endfunction()
function(zephyr_library_compile_definitions name)
    message("definition ${name}")
endfunction()
set(CONFIG_ISLET TRUE)
set(CONFIG_ISLET_WITHOUT_GEAR_JOINTS TRUE)
include(${LIBRARY}/CMakeLists.txt)
include(${LIBRARY}/zephyr/CMakeLists.txt)
set(CONFIG_ISLET_WITHOUT_GEAR_JOINTS FALSE)
set(CONFIG_ISLET_SMALL TRUE)
set(CONFIG_ISLET_WITH_REVOLUTE_JOINTS TRUE)
include(${LIBRARY}/zephyr/CMakeLists.txt)
END
said=$("$cmake" -D LIBRARY="$library" -P "$scratch/check.cmake" 2>&1) || fail "a CMake file: $said"
sources=$(cd "$library" && find src/engine -name '*.cpp' | LC_ALL=C sort | paste -s -d ';')
[ "$(wc -l <<<"${sources//;/$'\n'}")" -gt 80 ] || fail "the engine has few files: $sources"
modules=../${sources//;/;../}
[ "$said" = "idf $sources"$'\nzephyr ../src\nzephyr '"$modules"$'\ndefinition ISLET_WITHOUT_gear_joints\nzephyr ../src\nzephyr '"$modules"$'\n'\
$'definition of all ISLET_SMALL=1\ndefinition of all ISLET_WITH_revolute_joints' ] || fail "the CMake files compile something else: $said"
# Arduino adds object files to the archive one by one, by their names alone.
twice=$(find "$library/src" -name '*.cpp' -printf '%f\n' | sort | uniq -d)
[ -z "$twice" ] || fail "several files are called $twice"

# The sketches. run NAME PROGRAM FRAMES: each frame is 32 lines of at most 128 characters, and a second run prints the same.
run() {
    "$2" >"$scratch/$1.txt" || fail "$1 ends with an error"
    "$2" | cmp -s - "$scratch/$1.txt" || fail "$1 prints something else the second time"
    awk -v name="$1" -v wanted="$3" '
        /^frame [0-9]+$/ { ++frames; line = 0; next }
        /^[ .\047:]*$/ { ++line; if (length($0) > 128 || line > 32) { print name ": line too long or too many"; bad = 1 } dots += length($0) > 0 }
        END { if (frames != wanted || dots < 5 * wanted) { print name ": " frames " frames with " dots " lines"; bad = 1 } exit bad }' "$scratch/$1.txt" ||
        fail "the frames of $1"
    grep -qE "^$1 steps [0-9]+ hash [0-9a-f]{16} " "$scratch/$1.txt" || fail "$1 prints no hash"
}
# picture NAME FRAME
picture() { awk -v frame="$2" '/^frame /{ on = $2 == frame; next } /^[A-Z]/ { on = 0 } on && !/[a-z]/' "$scratch/$1.txt"; }
# rows_with_dots PICTURE_ROWS FROM TO: dots that are not of the walls, in rows of text from the top.
inner_dots() { sed -n "$1,$2p" | sed -E 's/^.//; s/^(.{125}).*/\1/' | tr -cd ".':" | wc -c; }

run Balls "$balls" 30
# They lie below at the end of the first five seconds, and above at the end of the next.
below=$(picture Balls 140 | inner_dots 17 31) above=$(picture Balls 140 | inner_dots 2 16)
[ "$below" -gt $((4 * above)) ] || fail "the balls are not below: $below characters there, $above above"
below=$(picture Balls 290 | inner_dots 17 31) above=$(picture Balls 290 | inner_dots 2 16)
[ "$above" -gt $((4 * below)) ] || fail "the balls are not above: $above characters there, $below below"

# Each line of islet_options.h does what it says when its "//" is taken away.
cat >"$scratch/check.cpp" <<'END'
#include "engine/data/features.hpp"
#define CHECK(name, ...) static_assert(islet::detail::has_##name == WANTED);
#define CHECK_JOINT(name, ...) static_assert(islet::detail::has_joint(islet::JointType::name) == WANTED);
ISLET_FEATURES(CHECK)
ISLET_JOINT_TYPES(CHECK_JOINT)
END
# options NAME PATTERN: a copy of the library with these lines switched on.
options() {
    cp -r "$library" "$scratch/$1"
    sed -i -E "s/^\/\/ (#define ISLET_$2)/\1/" "$scratch/$1/src/islet_options.h"
}
options without 'WITHOUT_'
g++ -std=gnu++17 -fsyntax-only -DWANTED=false -I "$scratch/without/src" "$scratch/check.cpp" || fail "ISLET_WITHOUT_ in islet_options.h leaves something in"
options with '(SMALL|WITH_)'
g++ -std=gnu++17 -fsyntax-only -DWANTED=true -I "$scratch/with/src" "$scratch/check.cpp" || fail "ISLET_WITH_ in islet_options.h puts something not back"

# In the small profile, with what they need beside it, the balls are the same.
options small '(SMALL|WITH_chains|WITH_continuous|WITH_seamless_floors) '
[ "$(grep -c '^#define ISLET_' "$scratch/small/src/islet_options.h")" -eq 6 ] || fail "islet_options.h: the small profile cannot be switched on"
# (As one file, which must not hold the code of eight lanes and more.)
find "$scratch/small/src/engine" -name '*.cpp' ! -name '*_avx*.cpp' -printf '#include "%p"\n' | LC_ALL=C sort >"$scratch/small/all.cpp"
if g++ -std=gnu++17 -O1 -DISLET_MAX_LANES=4 -I "$scratch/small/src" -c "$scratch/small/all.cpp" -o "$scratch/small/islet.o" &&
    g++ -std=gnu++17 -O1 -DISLET_MAX_LANES=4 -DSKETCH_FILE="\"$scratch/small/examples/Balls/Balls.ino\"" -DSKETCH_NAME='"Balls"' -DSKETCH_FRAMES=300 -DSKETCH_SHOWN=10 \
        -I "$islet/samples/boards/stub" -I "$scratch/small/src" "$islet"/samples/boards/stub/stub.cpp "$islet"/samples/firmware/{console,board_host}.cpp \
        "$scratch/small/islet.o" -o "$scratch/small/balls"; then
    "$scratch/small/balls" | diff "$scratch/Balls.txt" - >"$scratch/small.diff" ||
        fail "the balls are others in the small profile: $(tail -n 3 "$scratch/small.diff")"
else
    fail "Balls does not compile or link in the small profile"
fi

run MarbleMaze "$maze" 40
grep -q '^in the hole after frames: ' "$scratch/MarbleMaze.txt" || fail "the marble finds no hole"

run RobotArm "$arm" 40
for joint in 0 1 2; do
    for said in "at its limit: joint $joint" "free again: joint $joint"; do grep -qx "$said" "$scratch/RobotArm.txt" || fail "the arm never says: $said"; done
done
if $failed; then exit 1; fi
