#!/usr/bin/env bash
# Builds the package @islet/engine in bindings/js/dist: the engine and the C interface as WebAssembly, with SIMD and without, and the JavaScript for it.
#   bindings/js/build.sh
# What was compiled stays in build/js, for programs that add code of their own (samples/sandbox).
# Needs clang-16, lld-16, wasi-libc, libc++-16-dev-wasm32, binaryen, Python and Node.js; tools/lib.sh installs them (need_wasm_tools).
set -euo pipefail

root=$(cd "$(dirname "$0")/../.." && pwd)
here=$root/bindings/js
dist=$here/dist
work=$root/build/js
# shellcheck source=tests/determinism/build.sh
. "$root/tests/determinism/build.sh"
# shellcheck source=bindings/js/wasm.sh
. "$here/wasm.sh"

# What stands in no folder of the engine but is read by it all the same makes everything new.
newest=$(find "$root"/engine/{include,src} "$root"/bindings/{c,js} "$root/bindings/api.json" -path "$dist" -prune -o -path '*/node_modules' -prune -o \
    -path "$root/*/test/*" -prune -o -path "$root/*/bench/*" -prune -o -path '*/__pycache__' -prune -o -type f -newer "$dist/made" -print -quit 2>/dev/null || echo all)
if [ -z "$newest" ] && [ -e "$dist/made" ] && [ -e "$work/simd/cold.o" ]; then exit 0; fi
rm -rf "$dist"
mkdir -p "$dist" "$work"
touch "$work/began"
"$here/generate.py" "$work/made"

# Where most of a step's time goes is compiled for speed, the rest for size and at the link. Without SIMD all is for size, without the faster paths of fast bodies.
hot='/src/(solver/(kernel_scalar|solver|joint_solve|tree_solve)|broadphase/(pairs|moving_shapes|tree)|step/(contact_update|move_and_sleep|sleep_islands)|island/batches|collide/box|bodies/bounds|math/(vector|trig))\.cpp'
for_speed='-O2 -fno-vectorize -fno-slp-vectorize'
sources=$(find "$root/engine/src" -name '*.cpp' ! -path '*/lcp/*' ! -name '*_avx*.cpp' | sort)
grep -E "$hot" <<<"$sources" | as_one "$work/hot.cpp"
grep -vE "$hot" <<<"$sources" | as_one "$work/cold.cpp"
find "$root/bindings/c/src" "$here/src" "$work/made" -name '*.cpp' ! -name 'layouts.cpp' ! -name 'allocator.cpp' | sort | as_one "$work/c.cpp"
# make_one NAME HOT SHRINK FLAG...: HOT holds the flags of what every step runs, SHRINK the last passes that make the code smaller.
make_one() {
    local name=$1 folder=$work/$1 hot=() shrink=()
    read -r -a hot <<<"$2"
    read -r -a shrink <<<"$3"
    shift 3
    mkdir -p "$folder"
    wasm_compile "$@" "${hot[@]}" -c "$work/hot.cpp" -o "$folder/hot.o"
    wasm_compile "$@" -Oz -flto -c "$work/cold.cpp" -o "$folder/cold.o"
    wasm_compile "$@" -Oz -flto -c "$work/c.cpp" -o "$folder/c.o"
    wasm_compile -Oz -fno-builtin -c "$here/src/allocator.cpp" -o "$folder/allocator.o"
    wasm_link "$work/made/exports.txt" -nostartfiles "$folder"/{hot,cold,c,allocator}.o -o "$folder/linked.wasm"
    wasm_shrink "$folder/linked.wasm" "$folder/islet.wasm" "${shrink[@]}"
}
wasm_compile -fsyntax-only "$work/made/layouts.cpp"
wasm_compile -fsyntax-only "$root/bindings/c/src/layouts.cpp"
# (Constants that stand once in a function are a byte or two each where they are used, instead of five.)
make_one plain '-Oz -flto' '--const-hoisting --reorder-locals --reorder-functions' -DISLET_WITHOUT_shortcuts &
plain=$!
make_one simd "$for_speed" '' -msimd128 -DISLET_MIN_LANES=4
wait "$plain"

cp "$work/plain/islet.wasm" "$dist/islet.wasm"
cp "$work/simd/islet.wasm" "$dist/islet-simd.wasm"
cp "$here"/src/*.js "$here"/src/*.d.ts "$work"/made/{calls,functions}.js "$work/made/types.d.ts" "$dist"
{
    printf '// Made by bindings/js/build.sh: islet.wasm and islet-simd.wasm, packed by gzip.\n'
    for name in plain:islet withSimd:islet-simd; do
        printf "export const %s = '%s';\n" "${name%%:*}" "$(gzip -9 -n -c "$dist/${name#*:}.wasm" | base64 --wrap=0)"
    done
} >"$dist/wasm.js"
touch -r "$work/began" "$dist/made"
