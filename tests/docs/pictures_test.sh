#!/usr/bin/env bash
# pictures_test.sh ROOT BUILD: docs/draw.sh still makes every picture of docs/images, and no other. (Not the same bytes: what bodies do may change.)
set -euo pipefail

root=$1 build=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$root/docs/draw.sh" "$scratch" "$build"
# Without Box2D there is no comparison to draw.
[ -e "$scratch/compare.svg" ] || cp "$root/docs/images/compare.svg" "$scratch"
diff <(ls "$root/docs/images") <(ls "$scratch")
for picture in "$scratch"/*.svg; do
    tail -n 1 "$picture" | grep '</svg>' >/dev/null || { printf '%s is no whole picture\n' "$picture"; exit 1; }
done
