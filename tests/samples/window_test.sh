#!/usr/bin/env bash
# window_test.sh WINDOW RUNNER: the sample in a window, on a screen that exists in memory alone, shows its scene, steps as the runner does, and obeys keys and
# mouse. The script runs itself again under xvfb-run.
set -euo pipefail

window=$1 runner=$2
if [ -z "${ISLET_SCREEN:-}" ]; then
    ISLET_SCREEN=1 exec xvfb-run --auto-servernum --server-args="-screen 0 1280x800x24" "$0" "$@"
fi

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failed=false
complain() {
    printf '%s\n' "$*"
    failed=true
}

# Of a picture as SDL writes it, how many pixels have a colour, given as rrggbb.
pixels() {
    local start
    start=$(od -An -tu4 -j10 -N4 "$1" | tr -d ' ')
    tail -c +"$((start + 1))" "$1" | od -An -v -tx4 -w4 | grep -c "ff$2" || true
}

# -- the scene is seen, and steps as it does without a window ---------------------------------------------------------------------------------

"$window" pyramid --frames 60 --picture "$scratch/pyramid.bmp" >"$scratch/out.txt"
hash=$(sed -n 's/.*60 steps, hash //p' "$scratch/out.txt")
wanted=$("$runner" run pyramid --steps 60 | sed -n 's/^ *hash *//p')
[ "$hash" = "$wanted" ] || complain "after 60 steps the window's pyramid has the hash '$hash', the runner's '$wanted'"
# 55 boxes of 1 m, of which some rows of pixels are outlines; the scale is 800 pixels for the view's height.
for color in f7bd6d d8dce3 ffffff; do
    count=$(pixels "$scratch/pyramid.bmp" "$color")
    [ "$count" -gt 20000 ] || complain "the picture of the pyramid has $count pixels of the colour $color"
done

"$window" nowhere >"$scratch/out.txt" 2>&1 && complain "a scene that does not exist is accepted"
grep -q 'is no scene' "$scratch/out.txt" || complain "no word of a scene that does not exist"
"$window" pyramid --frames none >"$scratch/out.txt" 2>&1 && complain "no number of frames is accepted"
grep -q 'takes a number' "$scratch/out.txt" || complain "no word of a number of frames that is none"

# -- keys and mouse ------------------------------------------------------------------------------------------------------------------------------

# play SCENE [OPTION...]: starts the window in the background and gives it the keyboard.
play() {
    "$window" "$@" >"$scratch/out.txt" 2>&1 &
    shown=$(timeout 20 xdotool search --sync --onlyvisible --name "^$1 - step")
    xdotool windowfocus --sync "$shown"
}
title() { xdotool getwindowname "$shown"; }
steps() { title | sed 's/.* step \([0-9]*\).*/\1/'; }
# Waits, 10 s at most, until the command succeeds.
until_true() {
    local tries=0
    until "$@"; do
        tries=$((tries + 1))
        [ "$tries" -lt 100 ] || { complain "waited 10 s for: $*; the title is '$(title)'"; return; }
        sleep 0.1
    done
}
is_paused() { title | grep -q paused; }
steps_are() { [ "$(steps)" = "$1" ]; }
has_steps() { [ "$(steps)" -ge "$1" ]; }
at_most() { [ "$(steps)" -le "$1" ]; }
stop() {
    xdotool key Escape
    wait $!
}

play pyramid
until_true has_steps 30
xdotool key space
until_true is_paused
before=$(steps)
xdotool key Right
until_true steps_are "$((before + 1))"
xdotool keydown Left
until_true at_most "$((before - 10))"
xdotool keyup Left
xdotool key Page_Down
until_true eval 'title | grep -q ^vertical_stack'
stop

# -- the top box of the pyramid is pulled aside -----------------------------------------------------------------------------------------------------

wanted=$("$runner" run pyramid --steps 150 | sed -n 's/^ *hash *//p')
# final_hash BUTTON: after 150 steps in which the mouse went from the top box to the side, with that button held if one is given.
final_hash() {
    play pyramid --frames 150
    until_true has_steps 5
    xdotool mousemove 640 124
    if [ -n "$1" ]; then xdotool mousedown "$1"; fi
    xdotool mousemove 700 110 sleep 0.2 mousemove 900 100
    wait $!
    sed -n 's/.*150 steps, hash //p' "$scratch/out.txt"
}
[ "$(final_hash '')" = "$wanted" ] || complain "a mouse that holds nothing changes the world"
hash=$(final_hash 1)
if [ -z "$hash" ] || [ "$hash" = "$wanted" ]; then complain "the mouse drags no box"; fi

$failed && exit 1
printf 'the window shows, steps, pauses, rewinds, drags and changes scenes\n'
