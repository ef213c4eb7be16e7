#!/usr/bin/env bash
# Makes a library for boards, in the layout that Arduino, PlatformIO, ESP-IDF and Zephyr expect.
#   tools/package.sh [--url URL] [FOLDER]     into FOLDER (build/package/Islet unless given), which is made anew; URL is where the library will be found
#   library.properties, keywords.txt          Arduino
#   library.json                              PlatformIO
#   idf_component.yml, CMakeLists.txt         ESP-IDF
#   zephyr/                                   Zephyr: module.yml, Kconfig, CMakeLists.txt
#   src/                                      islet.hpp, all public headers in one; islet_options.h, which it includes: what the engine is compiled without;
#                                             and engine/, whose files are compiled into an archive: a program links those that it needs
#   examples/                                 the sketches of samples/boards
# The templates are in tools/package. In them @VERSION@ and the like stand for what the tree says.
set -euo pipefail

url=https://islet.invalid
if [ "${1:-}" = --url ] && [ $# -ge 2 ]; then
    url=$2
    shift 2
fi
case ${1:-} in
-h | --help)
    sed -n '2,11s/^# \{0,1\}//p' "$0"
    exit 0
    ;;
-*)
    printf '%s: unknown option %s; there is --help\n' "$0" "$1" >&2
    exit 2
    ;;
esac
root=$(cd "$(dirname "$0")/.." && pwd)
templates=$root/tools/package
out=${1:-$root/build/package/Islet}
# Only what this script has made is made anew.
if [ -e "$out" ] && [ ! -e "$out/src/islet_options.h" ]; then
    printf '%s: %s is there already, and is not a library of Islet\n' "$0" "$out" >&2
    exit 2
fi
new=$out.new
rm -rf "$new" && mkdir -p "$new/src" "$new/zephyr" "$new/examples"

config=$root/engine/include/islet/config.hpp
version=$(sed -n 's/^#define ISLET_VERSION_STRING "\(.*\)".*/\1/p' "$root/engine/include/islet/version.hpp")
features=$(sed -nE 's/^ +FEATURE\(([a-z_]+).*/\1/p; s/^ +JOINT\(([a-z_]+).*/\1_joints/p' "$config")
features+=$'\njoints'
# What the small profile leaves out, and can have all the same.
extras=$(sed -nE 's/^ +FEATURE\(([a-z_]+), [a-z_]+, full\).*/\1/p; s/^ +JOINT\(([a-z_]+).*/\1_joints/p' "$config")
extras+=$'\njoints'

# The engine's files, but for the matrix solvers.
mapfile -t sources < <(cd "$root/engine/src" && find . -name '*.cpp' ! -path './lcp/*' | sed 's/^\.\///' | LC_ALL=C sort)
mapfile -t parts < <(cd "$root/engine/src" && find . -name '*.hpp' ! -path './lcp/*' | sed 's/^\.\///' | LC_ALL=C sort)

options=
for feature in $extras; do
    options+=$'config ISLET_WITH_'"${feature^^}"$'\n\tbool "Put back: '"${feature//_/ }"$'"\n\tdepends on ISLET_SMALL\n\n'
done
for feature in $features; do
    options+=$'config ISLET_WITHOUT_'"${feature^^}"$'\n\tbool "Leave out: '"${feature//_/ }"$'"\n\n'
done

# fill FILE: the template, with what the tree says.
fill() {
    local text
    text=$(cat "$templates/$1")
    text=${text//@VERSION@/$version}
    text=${text//@SENTENCE@/A 2D rigid-body physics engine in one fixed block of memory.}
    text=${text//@URL@/$url}
    text=${text//@FEATURES@/${features//$'\n'/ }}
    text=${text//@EXTRAS@/${extras//$'\n'/ }}
    text=${text//@OPTIONS@$'\n'/$options}
    text=${text//@SOURCES@/${sources[*]/#/src/engine/}}
    text=${text//@MODULE_SOURCES@/${sources[*]/#/../src/engine/}}
    printf '%s\n' "$text" >"$new/$1"
}
for name in library.properties library.json idf_component.yml CMakeLists.txt README.md zephyr/module.yml zephyr/CMakeLists.txt zephyr/Kconfig; do fill "$name"; done
cp "$root/LICENSE" "$new/LICENSE"

mapfile -t headers < <(find "$root/engine/include/islet" -name '*.hpp' ! -name layout.hpp ! -name lcp.hpp ! -name span.hpp | LC_ALL=C sort)
# The classes, structs and functions that an editor shows in colours: those of the public headers.
{
    printf '# Made by tools/package.sh of the public headers.\n'
    sed -nE 's/^(struct|class|enum class) ([A-Z][A-Za-z0-9]+).*/\2\tKEYWORD1/p' "${headers[@]}" | sort -u
    sed -nE 's/^    [A-Za-z][A-Za-z0-9_:<> *&]* \**&*([a-z][a-z_0-9]+)\(.*\)( const)?;.*/\1\tKEYWORD2/p' "$root/engine/include/islet/world.hpp" | sort -u
} >"$new/keywords.txt"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$root/tools/amalgamate.sh" "$work" >/dev/null
sed '0,/^#pragma once$/s//&\n\n#include "islet_options.h"/' "$work/islet.hpp" >"$new/src/islet.hpp"
{
    printf '// How the engine is compiled on boards. Its parts take flash. To leave one out that you do not use, take away the "//" before its line, or compile with\n'
    printf '// -DISLET_WITHOUT_<name>. Calls that need it then fail with Error::feature_cut.\n#pragma once\n\n'
    printf '#if !defined(ISLET_THREADS)\n#define ISLET_THREADS 0  // 1: a world may be stepped on several cores, by a task system of yours\n#endif\n\n'
    printf '// The floats of Arduino on an RP2040 are those of its ROM, which know no subnormal numbers.\n'
    printf '#if !defined(ISLET_SUBNORMALS) && defined(ARDUINO_ARCH_RP2040) && defined(__ARM_ARCH_6M__)\n#define ISLET_SUBNORMALS 0\n#endif\n\n'
    for feature in $features; do printf '// #define ISLET_WITHOUT_%s 1\n' "$feature"; done
    printf '\n// The small profile, for boards with 64 kB of flash and 16 to 20 kB of memory: boxes and other polygons, balls, bouncing and queries. It leaves out all\n'
    printf '// else, and a world takes less memory. Instead of this line, -DISLET_SMALL=1 does the same if the library and your program are both compiled with it.\n'
    printf '// #define ISLET_SMALL 1\n\n'
    printf '// To put a feature back into the small profile, take away the "//" before its line:\n'
    for feature in $extras; do printf '// #define ISLET_WITH_%s 1\n' "$feature"; done
} >"$new/src/islet_options.h"
for file in "${sources[@]}" "${parts[@]}"; do
    mkdir -p "$new/src/engine/$(dirname "$file")"
    sed -E 's/^#include "islet\/[a-z_]+\.hpp"$/#include "islet.hpp"/' "$root/engine/src/$file" >"$new/src/engine/$file"
done

for sketch in "$root"/samples/boards/*/*.ino; do
    folder=$new/examples/$(basename "$(dirname "$sketch")")
    mkdir -p "$folder"
    cp "$sketch" "$root/samples/boards/display.h" "$folder/"
done

rm -rf "$out"
mv "$new" "$out"
printf '%s\n' "$out"
