#!/usr/bin/env bash
# Makes every picture of the manual again, with the programs of a release build.
#   docs/draw.sh [FOLDER [BUILD]]        FOLDER: where the pictures go (docs/images), BUILD: build/release
# The build needs the samples and the tools; the picture of the comparison needs Box2D too, those of environments the
# package for Python; they are left out without it.
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
scene hello hello 180
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
"$islet" sweep arch --steps 240 --vary friction=0.1:0.9:33 --seeds 20 --plot "$folder/sweep.svg" >/dev/null

for picture in queries snapshots recording memory lcp step folders pgs film; do
    "$build/tools/pictures/islet-pictures" "$picture" >"$folder/$picture.svg"
done

# displays PICTURE PROGRAM FRAME...: what sketches for boards send to a display, side by side. A character of their text is two dots.
displays() {
    local picture=$1
    shift
    while [ $# -gt 0 ]; do
        "$build/samples/boards/$1" | awk -v frame="$2" '/^frame / { on = $2 == frame; next } /[a-zA-Z]/ { on = 0 } on' | sed 's/^/=/'
        echo next
        shift 2
    done | awk '
        function put(from, to, y) { path = path sprintf("M%d %dh%dv1h-%dz", x0 + from, y0 + y, to - from, to - from) }
        function row(line, y, both, upper,    x, c, from) {
            from = -1
            for (x = 0; x <= 128; ++x) {
                c = substr(line, x + 1, 1)
                if (c != "" && index(both upper, c)) { if (from < 0) from = x }
                else if (from >= 0) { put(from, x, y); from = -1 }
            }
        }
        BEGIN { x0 = y0 = 6 }
        /^=/ { line = substr($0, 2); row(line, y, ":", "\047"); row(line, y + 1, ":", "."); y += 2; next }
        {
            panels = panels sprintf("<rect x=\"%d\" y=\"2\" width=\"136\" height=\"72\" rx=\"3\" fill=\"#10151c\"/>\n", x0 - 4)
            x0 += 142
            y = 0
        }
        END {
            printf "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d 76\" width=\"%d\" shape-rendering=\"crispEdges\">\n", x0 - 4, 2 * (x0 - 4)
            printf "%s<path fill=\"#bfe3ff\" d=\"%s\"/>\n</svg>\n", panels, path
        }' >"$folder/$picture.svg"
}
displays boards balls 70 marble_maze 100 robot_arm 100

# Learning curves (bindings/python/examples/train.py writes them), and what the package for Python draws.
examples=$root/bindings/python/examples
if command -v python3 >/dev/null; then
    python3 "$examples/curve.py" cart_pole="$root/docs/learning/cart_pole.csv" bipedal_walker="$root/docs/learning/bipedal_walker.csv" >"$folder/learning.svg"
fi
if [ -d "$build/python/islet" ]; then
    PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$build/python /usr/bin/python3 "$examples/pictures.py" "$folder"
else
    printf 'environments.svg and walking.svg are left out: there is no %s\n' "$build/python/islet" >&2
fi

compare=$build/tools/compare/islet-compare
if [ -x "$compare" ]; then
    "$compare" bridge --svg "$folder/compare.svg" >/dev/null 2>&1
else
    printf 'compare.svg is left out: there is no %s\n' "$compare" >&2
fi
