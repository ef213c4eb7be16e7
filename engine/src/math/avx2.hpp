// Lets the compiler use AVX2 from here to the end of the file that includes this header (never FMA, which would change the bits). Only files whose functions
// run only on processors with AVX2 may include it. They include it before every header that holds functions, and end with ISLET_AVX2_END.
#pragma once

#if defined(__x86_64__) && !defined(_MSC_VER)

// Included before AVX2 is switched on, since its functions themselves name the instructions that they need.
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
