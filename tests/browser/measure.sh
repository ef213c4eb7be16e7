#!/usr/bin/env bash
# Measures the sandbox in Chromium, on this machine.
#   tests/browser/measure.sh frames [SCENE...]      what a frame costs, the engine and the drawing apart
#   tests/browser/measure.sh opening [RUNS]         how soon the page moves on a slow processor
#   tests/browser/measure.sh memory [MINUTES]       what the page holds while somebody plays at random
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
what=${1:-}
case $what in
frames | opening | memory) shift ;;
*)
    sed -n '2,5s/^# \{0,1\}//p' "$0" >&2
    exit 2
    ;;
esac
"$root/samples/sandbox/build.sh" >&2
cd "$here"
if [ ! node_modules/.package-lock.json -nt package-lock.json ]; then npm ci --no-audit --no-fund >&2; fi
SANDBOX=$root/build/sandbox CHROMIUM=${CHROMIUM:-$(command -v chromium || command -v google-chrome)} node "$what.mjs" "$@"
