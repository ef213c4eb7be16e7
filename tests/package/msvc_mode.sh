#!/usr/bin/env bash
# msvc_mode.sh ISLET: clang reads every file of the engine and of the C interface, and every public header, in its Microsoft mode: for the target
# x86_64-pc-windows-msvc, with Microsoft's extensions and its rules for templates and layouts. The C++ library's few headers are those of msvc_mode/.
# Then it reads them once more as Microsoft's own compiler would: without knowing itself, so that islet/compiler.hpp takes the other branch.
# It does not link, and Microsoft's own compiler has never read them.
set -euo pipefail

islet=$1
here=$(cd "$(dirname "$0")" && pwd)
command -v clang++ >/dev/null || { echo "left out: there is no clang++" && exit 0; }
mode=(--target=x86_64-pc-windows-msvc -fms-compatibility-version=19.33 -fms-compatibility -fms-extensions -nostdlibinc -isystem "$here/msvc_mode"
    -I "$islet/engine/include" -I "$islet/bindings/c/include" -fsyntax-only -Wall -Wextra -Werror -Wno-ignored-attributes -Wno-unknown-attributes -Wno-unused-function)

mapfile -t sources < <(find "$islet/engine/src" -name '*.cpp' | sort)
status=0
printf '%s\0' "${sources[@]}" | xargs -0 -n 25 -P 2 clang++ "${mode[@]}" -std=c++17 || status=1
for header in "$islet"/engine/include/islet/*.hpp; do
    clang++ "${mode[@]}" -std=c++17 -x c++ -Wno-pragma-once-outside-header "$header" || status=1
done
for header in "$islet/bindings/c/include/islet/islet.h" "$islet/engine/include/islet/islet_lcp.h"; do
    clang "${mode[@]}" -std=c11 -x c "$header" || status=1
done
others=(-isystem "$here/msvc_mode/no_clang" -U__{clang,x86_64,SSE2,BYTE_ORDER,ORDER_BIG_ENDIAN,FLT_EVAL_METHOD}__)
printf '%s\0' "${sources[@]}" | xargs -0 -n 25 -P 2 clang++ "${others[@]}" "${mode[@]}" -Wno-unknown-pragmas -std=c++17 || status=1
[ "$status" -eq 0 ] && printf 'ok: %s sources and the public headers\n' "${#sources[@]}"
exit "$status"
