#!/usr/bin/env bash
# Builds Islet and runs a scene: prints what happened and where the picture is.
#   tools/run.sh [SCENE] [options of `islet run`]       e.g. tools/run.sh card_house --steps 600
#   tools/run.sh --web [PORT]                           builds the sandbox, a page to play with the scenes, and serves it on this machine (8080)
# Installs a compiler, CMake and islet's libraries with apt if they are missing; for the page clang, Node.js and what compiles WebAssembly, and by npm Vite.
set -euo pipefail
# shellcheck source=tools/lib.sh
. "$(dirname "$0")/lib.sh"

scene=pyramid
if [ $# -gt 0 ] && [ "${1#-}" = "$1" ]; then
    scene=$1
    shift
elif [ "${1-}" = -h ] || [ "${1-}" = --help ]; then
    sed -n '2,5s/^# *//p' "$0"
    exit 0
elif [ "${1-}" = --web ]; then
    need_wasm_tools
    install_missing
    say "building the sandbox"
    "$root/samples/sandbox/build.sh"
    printf 'sandbox: http://localhost:%s/ (the folder %s, which any server of files can serve; Ctrl-C ends this one)\n' "${2:-8080}" "$root/build/sandbox"
    cd "$root/samples/sandbox"
    exec node node_modules/vite/bin/vite.js preview --port "${2:-8080}" --strictPort --logLevel warn
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
