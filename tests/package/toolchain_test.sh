#!/usr/bin/env bash
# toolchain_test.sh CMAKE COMPILER ISLET BUILD: configures the engine in BUILD as for Emscripten, whose toolchain file calls its processor x86, with a clang
# that compiles for WebAssembly; wants no flag of a processor in any command.
set -euo pipefail

cmake=$1 compiler=$2 islet=$3 build=$4

rm -rf "$build"
mkdir -p "$build"
cat >"$build/toolchain.cmake" <<END
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR x86)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_CXX_COMPILER $compiler)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
END
"$cmake" -S "$islet/engine" -B "$build" --toolchain "$build/toolchain.cmake" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
if grep -oE -e ' -m[a-z][^ ]*' "$build/compile_commands.json" | sort | uniq -c | grep .; then
    echo 'flags of another processor reach WebAssembly'
    exit 1
fi
