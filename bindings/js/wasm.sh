# Shared by what builds WebAssembly: how it is compiled and linked. Meant to be sourced; the caller sets `root`.
# shellcheck shell=bash disable=SC2154

llvm=/usr/lib/llvm-16

# wasm_compile FLAG...
wasm_compile() {
    clang++-16 --target=wasm32-wasi -std=c++20 -fno-fast-math -ffp-contract=off -fno-math-errno -fno-exceptions -fno-rtti -fno-threadsafe-statics \
        -mbulk-memory -ffunction-sections -fdata-sections -DISLET_THREADS=0 -cxx-isystem "$llvm/include/wasm32-wasi/c++/v1" -I"$root/engine/include" -I"$root/engine/src" \
        -I"$root/bindings/c/include" -I"$root/bindings/c/src" -Wno-undefined-internal "$@"
}

# wasm_link EXPORTS FLAG...: EXPORTS names what is exported, a name a line.
wasm_link() {
    local exports=()
    mapfile -t exports < <(sed 's/^/-Wl,--export=/' "$1")
    shift
    clang++-16 --target=wasm32-wasi "-L$llvm/lib/wasm32-wasi" -nodefaultlibs -Wl,--no-entry,--gc-sections,--strip-all,--stack-first,-z,stack-size=262144 \
        "${exports[@]}" "$@" -lc
}
