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
# The libraries of the host that need no system, and nothing else of its headers.
mkdir -p "$work/host"
ln -sfn /usr/include/nlohmann "$work/host/nlohmann"
ln -sfn /usr/include/fmt "$work/host/fmt"
# compile_part NAME FLAG...: what stands in NAME.cpp, unless it is there.
compile_part() {
    local name=$1
    shift
    local newer
    newer=$(find "$root"/samples/{harness,prefabs,scenes,scene_files} "$root/engine/include" "$here"/*.cpp "$here"/*.hpp -type f -newer "$work/$name.o" \
        -print -quit 2>/dev/null || echo all)
    if [ -z "$newer" ] && [ -e "$work/$name.o" ]; then return 0; fi
    wasm_compile "$@" -frtti -fexceptions -DFMT_HEADER_ONLY -DJSON_HAS_FILESYSTEM=0 -DJSON_HAS_EXPERIMENTAL_FILESYSTEM=0 -DFMT_STATIC_THOUSANDS_SEPARATOR="','" -I"$root" -I"$root/samples" -I"$work/host" \
        -c "$work/$name.cpp" -o "$work/$name.o"
}
{ find "$root"/samples/{harness,prefabs,scenes} "$here" -name node_modules -prune -o -name '*.cpp' ! -name scene_files.cpp -print; } | sort | as_one "$work/scenes.cpp"
printf '%s\n' "$here/scene_files.cpp" "$root"/samples/scene_files/{scene_reader,near_names,printable}.cpp | as_one "$work/scene_reader.cpp"
echo "$root/samples/scene_files/scene_writer.cpp" | as_one "$work/scene_writer.cpp"
compile_part scenes -O1
compile_part scene_reader -Oz
compile_part scene_writer -Oz
mkdir -p "$work/sandbox"
cat "$work/made/exports.txt" "$here/exports.txt" >"$work/sandbox/exports.txt"
for name in plain simd; do
    wasm_link "$work/sandbox/exports.txt" -mexec-model=reactor "$work/$name"/{hot,cold,c}.o "$work"/{scenes,scene_reader,scene_writer}.o -lc++ -lc++abi "$llvm/lib/clang/16/lib/wasi/libclang_rt.builtins-wasm32.a" -o "$work/sandbox/$name.wasm"
done
if [ ! "$here/node_modules/.package-lock.json" -nt "$here/package-lock.json" ]; then (cd "$here" && npm ci --no-audit --no-fund) >&2; fi
cd "$here"
npx tsc --noEmit
npx vite build --logLevel warn
