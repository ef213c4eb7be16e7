#!/usr/bin/env bash
# Builds the sandbox as a static folder, build/sandbox, that any server of files can serve.
#   samples/sandbox/build.sh
# Needs what bindings/js/build.sh needs, and npm, which fetches TypeScript and Vite.
set -euo pipefail

root=$(cd "$(dirname "$0")/../.." && pwd)
here=$root/samples/sandbox
work=$root/build/js
# shellcheck source=tests/determinism/build.sh
. "$root/tests/determinism/build.sh"
# shellcheck source=bindings/js/wasm.sh
. "$root/bindings/js/wasm.sh"

"$root/bindings/js/build.sh"
find "$root"/samples/{harness,prefabs,scenes} "$here/sandbox.cpp" -name '*.cpp' | sort | as_one "$work/scenes.cpp"
if [ -n "$(find "$root"/samples/{harness,prefabs,scenes} "$root/engine/include" "$here/sandbox.cpp" -type f -newer "$work/scenes.o" -print -quit 2>/dev/null || echo all)" ] ||
    [ ! -e "$work/scenes.o" ]; then
    wasm_compile -O1 -frtti -fexceptions -I"$root/samples" -c "$work/scenes.cpp" -o "$work/scenes.o"
fi
mkdir -p "$work/sandbox"
cat "$work/made/exports.txt" "$here/exports.txt" >"$work/sandbox/exports.txt"
for name in plain simd; do
    wasm_link "$work/sandbox/exports.txt" -mexec-model=reactor "$work/$name"/{hot,cold,c}.o "$work/scenes.o" -lc++ -lc++abi -o "$work/sandbox/$name.wasm"
done
if [ ! "$here/node_modules/.package-lock.json" -nt "$here/package-lock.json" ]; then (cd "$here" && npm ci --no-audit --no-fund) >&2; fi
cd "$here"
npx tsc --noEmit
npx vite build --logLevel warn
