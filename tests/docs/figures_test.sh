#!/usr/bin/env bash
# figures_test.sh ROOT [ISLET]: the figures that the manual gives are those of the code. ISLET, the program, prints some of them.
# (Flash: flash_test.sh. The tables of lcp.md: tests/unit/lcp_page_test.cpp.)
# shellcheck disable=SC2016  # what stands in single quotes is for sed
set -euo pipefail
export LC_ALL=C

root=$(cd "$1" && pwd)
# shellcheck source=tests/docs/pages.sh
. "$(dirname "$0")/pages.sh"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
checked=0
headers=engine/include/islet

# number FILE PATTERN: what the pattern's group finds in the file, read as one line.
number() { tr -s '[:space:]' ' ' <"$root/$1" | sed -nE "s#.*$2.*#\1#p" | tr -d " '"; }

# same PAGE PATTERN FILE PATTERN [SCALE]: the page's figure, times SCALE, is the code's.
same() {
    local said real
    said=$(number "docs/$1" "$2") real=$(number "$3" "$4")
    checked=$((checked + 1))
    awk -v said="$said" -v real="$real" -v scale="${5-1}" 'BEGIN {
        difference = said * scale - real
        exit !(said != "" && real != "" && difference * difference <= 1e-12 * real * real)
    }' || complain "$1 says \"$said\" for $2; $3 has \"$real\""
}

n='([0-9][0-9.e ]*)'
same using-islet.md "No coordinate may exceed $n km" $headers/types.hpp "max_position = ${n}f" 1000
same bodies-and-shapes.md "convex, up to $n corners" $headers/geometry.hpp "max_polygon_vertices = $n"
same bodies-and-shapes.md "must be more than $n mm" engine/src/geometry/convex.hpp "min_length = ${n}f" 0.001
same bodies-and-shapes.md "\`friction\` \| 0 to $n, " $headers/types.hpp "max_coefficient = ${n}f"
same bodies-and-shapes.md "\`friction\` \| 0 to 1e9, default $n" $headers/types.hpp "struct ShapeDef \{ float friction = ${n}f"
same bodies-and-shapes.md "\`WorldDef::restitution_threshold\` \($n m" $headers/types.hpp "float restitution_threshold = ${n}f"
same bodies-and-shapes.md "\`sleep_threshold\` \($n m" $headers/types.hpp "float sleep_threshold = ${n}f"
same fast-bodies.md "default is $n m/s" $headers/types.hpp "float max_speed = ${n}f"
same events.md "\`WorldDef::hit_threshold\` \($n m" $headers/types.hpp "float hit_threshold = ${n}f"
same character.md "\`max_slope\` \| $n rad" $headers/mover.hpp "float max_slope = ${n}f"
same character.md "\`step_height\` \| $n m" $headers/mover.hpp "float step_height = ${n}f"
same character.md "\`snap_distance\` \| $n m" $headers/mover.hpp "float snap_distance = ${n}f"
same character.md "\`max_push_force\` \| $n kg" $headers/mover.hpp "float mass = $n;"
same character.md "\`max_push_force\` \| 70 kg, $n N" $headers/mover.hpp "float max_push_force = $n;"
same solver.md "\`soft\` .default. \| has $n substeps" $headers/types.hpp "substeps = $n;"
same solver.md "\`contact_hertz\` \($n Hz" $headers/types.hpp "float contact_hertz = ${n}f"
same solver.md "\`contact_push_speed\` \($n m" $headers/types.hpp "float contact_push_speed = ${n}f"
same solver.md "raise \`joint_tree_load\` \($n by default" $headers/types.hpp "float joint_tree_load = ${n}f"
same solver.md "The largest value is ([0-9.]*[0-9])\. " $headers/types.hpp "max_shock = ${n}f"
same snapshots.md "goes back by up to $n frames" samples/rollback/peer.hpp "int window = $n;"
same recording.md "needs more than $n GB" tools/islet/replay_file.hpp "usual_memory_limit = ([0-9']+)" 1e9

# The formats of this version, as versions.md lists them.
version=$(sed -nE 's/.*ISLET_VERSION_STRING "(.*)"/\1/p' "$root/$headers/version.hpp")
formats=$(for what in snapshot delta recording; do
    real=$(number $headers/format.hpp "${what}_format = ([a-z_0-9]+);")
    [ "$real" != snapshot_format ] || real=$(number $headers/format.hpp 'snapshot_format = ([0-9]+);')
    printf ' %s |' "$real"
done)
formats="| $version |$formats $(number samples/scene_files/scene_file.hpp 'scene_format = ([0-9]+);') |"
checked=$((checked + 1))
grep -qxF "$formats" "$root/docs/versions.md" || complain "versions.md has no row $formats"

# Each type of joint has its row in joints.md. (Features: tests/features.)
mapfile -t joints < <(sed -nE 's/^ +JOINT\(([a-z_]+).*/\1/p' "$root/$headers/config.hpp")
for name in "${joints[@]}"; do
    checked=$((checked + 1))
    grep -qE "^\| ${name}[ |]" "$root/docs/joints.md" || complain "joints.md has no row of $name joints"
done

# The memory of worlds on a Cortex-M, from the compiler for it; without one this part is left out.
if command -v arm-none-eabi-g++ >/dev/null; then
    {
        printf '#include <islet/layout.hpp>\nusing namespace islet;\n'
        grep -E '^\| [0-9]+ \| [0-9]+ \| [0-9]+ \| [0-9]+ \| [0-9 ]+\|$' "$root/docs/microcontrollers.md" | tr -d ' ' | while IFS='|' read -r _ bodies contacts joints geometries bytes _; do
            printf 'static_assert(world_bytes({.bodies = %d, .shapes = %d, .contacts = %d, .joints = %d, .geometries = %d}) == %d);\n' \
                "$bodies" "$bodies" "$contacts" "$joints" "$geometries" "$bytes"
        done
    } >"$scratch/worlds.cpp"
    checked=$((checked + $(grep -c static_assert "$scratch/worlds.cpp")))
    arm-none-eabi-g++ -std=c++20 -mcpu=cortex-m4 -mthumb -ffreestanding -fsyntax-only -I "$root/engine/include" "$scratch/worlds.cpp" ||
        complain "microcontrollers.md: the memory of a world is another"
else
    printf 'left out, for want of arm-none-eabi-g++: the memory of worlds\n'
fi

# chain_ball, with its joint tree solved exactly and swept: how far joints come apart, as solver.md says.
if [ $# -gt 1 ]; then
    apart() { "$2" run chain_ball --joint-trees "$1" | sed -nE 's/.*in the whole run by ([0-9.e-]+) m .*/\1/p'; }
    exact=$(apart automatic "$2") swept=$(apart off "$2")
    said_exact=$(number docs/solver.md 'comes apart by more than ([0-9.]+) mm') said_swept=$(number docs/solver.md 'come apart by up to ([0-9.]+) m[. ]')
    checked=$((checked + 2))
    awk -v real="$exact" -v said="$said_exact" 'BEGIN { exit !(real > 0 && real <= said / 1000 && real > said / 2000) }' ||
        complain "solver.md says that the joints of chain_ball come apart by at most $said_exact mm; it is $exact m"
    awk -v real="$swept" -v said="$said_swept" 'BEGIN { exit !(real > 0.95 * said && real < 1.05 * said) }' ||
        complain "solver.md says that swept joints of chain_ball come apart by $said_swept m; it is $swept m"
fi

printf '%d figures checked\n' "$checked"
[ "$checked" -gt 30 ] && [ "$failures" -eq 0 ]
