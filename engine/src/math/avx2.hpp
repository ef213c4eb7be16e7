// From here to the end of the file the compiler may use AVX2 (never FMA, which would change the bits). For files whose functions are called only where the
// processor has it; they include this before all that holds functions, and end with ISLET_AVX2_END.
#pragma once

#if defined(__x86_64__)

// Before the switch: its functions say by themselves what they need.
#include <immintrin.h>

#define ISLET_AVX2
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#define ISLET_AVX2_END _Pragma("clang attribute pop")
#else
#pragma GCC target("avx2")
#define ISLET_AVX2_END
#endif

#else
#define ISLET_AVX2_END
#endif
