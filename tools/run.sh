#!/usr/bin/env bash
# Builds Islet and runs a scene: prints what happened and where the picture is.
#   tools/run.sh [SCENE] [options of `islet run`]       e.g. tools/run.sh card_house --steps 600
# Installs a compiler, CMake and islet's libraries with apt if they are missing.
set -euo pipefail
# shellcheck source=tools/lib.sh
. "$(dirname "$0")/lib.sh"

scene=pyramid
if [ $# -gt 0 ] && [ "${1#-}" = "$1" ]; then
    scene=$1
    shift
elif [ "${1-}" = -h ] || [ "${1-}" = --help ]; then
    sed -n '2,4s/^# *//p' "$0"
    exit 0
fi

need_build_tools
install_missing

# The first time, only what a scene needs; whoever has built more keeps it.
options=()
[ -e "$root/build/release/CMakeCache.txt" ] || options=(-DISLET_BUILD_TESTS=OFF -DISLET_WERROR=OFF)
say "building"
configure release -DISLET_BUILD_TOOLS=ON "${options[@]}"
build release --target islet_runner

say "running $scene"
picture=$root/build/pictures/$scene.svg
arguments=("$@")
case " $* " in *" --svg"*) picture= ;; *) arguments+=(--svg "$picture") ;; esac
mkdir -p "$root/build/pictures"
status=0
"$root/build/release/tools/islet/islet" run "$scene" "${arguments[@]}" || status=$?
if [ "$status" -lt 2 ] && [ -n "$picture" ]; then
    # What --json prints must stay JSON.
    case " $* " in *" --json "*) exec >&2 ;; esac
    printf 'picture: %s\n' "$picture"
fi
exit "$status"
