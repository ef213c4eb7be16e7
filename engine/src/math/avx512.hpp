// Lets the compiler use AVX-512 from here to the end of the file that includes this header, as math/avx2.hpp does with AVX2. A file that includes it ends with
// ISLET_AVX512_END.
//
// AVX-512 has fused operations of its own. What keeps GCC from using them is exact.hpp's fp-contract=off, and that its vectoriser, which fuses all the same, is
// off here; Clang asks its own pragma. (tests/embedded/symbols_test.sh looks for them in the compiled engine.)
#pragma once

// GCC for Windows aligns no stack for such registers, and Microsoft's headers have none of their functions.
#if defined(__x86_64__) && !defined(_WIN32)

// Included before AVX-512 is switched on, since its functions themselves name the instructions that they need.
#include <immintrin.h>

#define ISLET_AVX512
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx512f,avx512vl,avx512dq,avx512bw"))), apply_to = function)
#define ISLET_AVX512_END _Pragma("clang attribute pop")
#else
#pragma GCC target("avx512f,avx512vl,avx512dq,avx512bw")
#pragma GCC optimize("no-tree-vectorize", "no-tree-slp-vectorize")
#define ISLET_AVX512_END
#endif

#else
#define ISLET_AVX512_END
#endif
