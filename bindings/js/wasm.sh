# Shared by what builds WebAssembly: how it is compiled and linked. Meant to be sourced; the caller sets `root`.
# shellcheck shell=bash disable=SC2154

llvm=/usr/lib/llvm-16

# wasm_compile FLAG...
wasm_compile() {
    clang++-16 --target=wasm32-wasi -std=c++20 -fno-fast-math -ffp-contract=off -fno-math-errno -fno-exceptions -fno-rtti -fno-threadsafe-statics \
        -mbulk-memory -msign-ext -mnontrapping-fptoint -ffunction-sections -fdata-sections -DISLET_THREADS=0 \
        -cxx-isystem "$llvm/include/wasm32-wasi/c++/v1" -I"$root/engine/include" -I"$root/engine/src" \
        -I"$root/bindings/c/include" -I"$root/bindings/c/src" -Wno-undefined-internal "$@"
}

# wasm_link EXPORTS FLAG...: EXPORTS names what is exported, a name a line. At the link a function with many callers is never copied into them, and no loop gets
# counters of its own for each address: both are larger.
wasm_link() {
    local exports=()
    mapfile -t exports < <(sed 's/^/-Wl,--export=/' "$1")
    shift
    clang++-16 --target=wasm32-wasi "-L$llvm/lib/wasm32-wasi" -nodefaultlibs -Wl,--no-entry,--gc-sections,--strip-all,--stack-first,-z,stack-size=262144 \
        -Wl,-mllvm,-inline-threshold=-50,-mllvm,-disable-lsr \
        "${exports[@]}" "$@" -lc
}

# wasm_shrink FROM TO [PASS...]: the same code in fewer bytes, with the same results; at the end by these passes of wasm-opt. (Nothing but the end of the stack
# lies in the first 1024 bytes of the memory, so offsets may be folded into addresses: --low-memory-unused.)
wasm_shrink() {
    wasm-opt --enable-simd --enable-bulk-memory --enable-sign-ext --enable-nontrapping-float-to-int --enable-mutable-globals --strip-debug --strip-producers \
        --low-memory-unused --converge --flatten --simplify-locals-nonesting --rereloop -Oz --code-folding -Oz "${@:3}" "$1" -o "$2"
}
