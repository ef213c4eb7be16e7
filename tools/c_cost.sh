#!/usr/bin/env bash
# What the C interface takes of the time: a pyramid of 55 boxes in C and in C++ (tools/c_cost), counted in instructions by Valgrind, which no other program
# on the machine changes.
#   tools/c_cost.sh    prints the instructions of a step and of reading a pose. Fails if the results differ, or if a step in C takes a thousandth more
set -euo pipefail
# shellcheck source=tools/lib.sh
. "$(dirname "$0")/lib.sh"

case ${1-} in
'') ;;
-h | --help) sed -n '2,4s/^# \{0,1\}//p' "$0"; exit 0 ;;
*) die "$0: unknown option $1; there is none but --help" ;;
esac

need_build_tools
need valgrind command_exists valgrind
install_missing
[ -e "$root/build/release/CMakeCache.txt" ] || configure release -DISLET_BUILD_TESTS=OFF -DISLET_BUILD_TOOLS=OFF -DISLET_WERROR=OFF
build release --target islet_c >&2

out=$root/build/c_cost
mkdir -p "$out"
libraries=("$root/build/release/bindings/c/libislet_c.a" "$root/build/release/engine/libislet.a")
cc -std=c11 -O2 -I"$root/bindings/c/include" "$root/tools/c_cost/boxes.c" "${libraries[@]}" -lm -o "$out/c"
c++ -std=c++20 -O2 -I"$root/engine/include" "$root/tools/c_cost/boxes.cpp" "${libraries[1]}" -o "$out/cpp"

# instructions PROGRAM STEPS READS
instructions() { valgrind --tool=callgrind --callgrind-out-file=/dev/null "$out/$1" "$2" "$3" 2>&1 >/dev/null | awk '/Collected/ { print $NF }'; }

for program in c cpp; do
    [ "$("$out/$program" 120 1)" = "$("$out/cpp" 120 1)" ] || die "C and C++ do not come to the same"
    start=$(instructions "$program" 60 0) steps=$(instructions "$program" 120 0) reads=$(instructions "$program" 120 10)
    declare "step_$program=$(((steps - start) / 60))" "pose_$program=$(((reads - steps) / (120 * 10 * 55)))"
done
printf '%-32s %9s %9s %9s\n' 'instructions' 'in C++' 'in C' 'more'
# row NAME IN_CPP IN_C
row() { printf '%-32s %9d %9d %9d\n' "$1" "$2" "$3" $(($3 - $2)); }
# shellcheck disable=SC2154  # declared above
row 'a step' "$step_cpp" "$step_c"
# shellcheck disable=SC2154
row 'a pose' "$pose_cpp" "$pose_c"
row 'a step, and all 55 poses' $((step_cpp + 55 * pose_cpp)) $((step_c + 55 * pose_c))
[ $((1000 * (step_c - step_cpp))) -le "$step_cpp" ] || die "a step in C takes a thousandth more than in C++"
