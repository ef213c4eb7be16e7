#!/usr/bin/env bash
# pictures_test.sh ROOT BUILD: docs/draw.sh still makes every picture of docs/images, and no other. (Not the same bytes: what bodies do may change.)
set -euo pipefail

root=$1 build=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$root/docs/draw.sh" "$scratch" "$build"
# Without Box2D there is no comparison to draw, without Python there are no environments.
for picture in compare learning environments walking; do
    [ -e "$scratch/$picture.svg" ] || cp "$root/docs/images/$picture.svg" "$scratch"
done
diff <(ls "$root/docs/images") <(ls "$scratch")
# The film moves, and as many bodies of it as before.
moving() { grep -c '@keyframes b' "$1"; }
if [ "$(moving "$scratch/film.svg")" -lt 50 ] || [ "$(moving "$scratch/film.svg")" -ne "$(moving "$root/docs/images/film.svg")" ]; then
    printf 'the film of README.md moves otherwise: make it again with docs/draw.sh\n'
    exit 1
fi
for picture in "$scratch"/*.svg; do
    tail -n 1 "$picture" | grep '</svg>' >/dev/null || { printf '%s is no whole picture\n' "$picture"; exit 1; }
done
