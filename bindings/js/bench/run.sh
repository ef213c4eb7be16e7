#!/usr/bin/env bash
# Islet beside Box2D and Rapier in node: prints times a step, ratios and the packages' sizes.
#   bindings/js/bench/run.sh [SCENE...]
# Needs what samples/sandbox/build.sh needs; npm fetches the other engines.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
"$here/../../../samples/sandbox/build.sh" >&2
cd "$here"
if [ ! node_modules/.package-lock.json -nt package-lock.json ]; then npm ci --no-audit --no-fund >&2; fi
node bench.js "$@"
