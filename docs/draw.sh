#!/usr/bin/env bash
# Makes every picture of the manual again, with the programs of a release build.
#   docs/draw.sh [FOLDER [BUILD]]        FOLDER: where the pictures go (docs/images), BUILD: build/release
# The build needs the samples and the tools; the picture of the comparison needs Box2D too, and is left out without it.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
folder=${1:-$root/docs/images}
build=${2:-$root/build/release}
islet=$build/tools/islet/islet
mkdir -p "$folder"

# scene PICTURE SCENE STEPS [OPTION...]: the scene after so many steps. Cut short, its check is skipped.
scene() { "$islet" run "$2" --steps "$3" --svg "$folder/$1.svg" "${@:4}" >/dev/null; }

scene card_house card_house 60
scene arch arch 60
scene hello hello 40
scene shapes "$root/docs/scenes/shapes.json" 60
scene joints "$root/docs/scenes/joints.json" 20 --draw shapes,joints
scene bullets bullets 60
scene platformer platformer 500
scene sensors sensors 70
scene impulses cairn 240 --draw shapes,contacts,impulses
scene islands cairn 240 --draw shapes,islands
scene chain_ball chain_ball 150
scene v_grooves v_grooves 120
scene swing "$root/samples/scenes/swing.json" 120

for picture in queries snapshots recording memory lcp step folders; do
    "$build/tools/pictures/islet-pictures" "$picture" >"$folder/$picture.svg"
done

compare=$build/tools/compare/islet-compare
if [ -x "$compare" ]; then
    "$compare" bridge --svg "$folder/compare.svg" >/dev/null 2>&1
else
    printf 'compare.svg is left out: there is no %s\n' "$compare" >&2
fi
