// In a file that includes this, the compiler may use AVX2 from here on to the file's end (never FMA, which would change the bits). It is for files whose
// functions are called only where the processor has AVX2. They include it before every header that holds functions, and end with ISLET_AVX2_END.
#pragma once

#if defined(__x86_64__)

// Included before the compiler is told: the functions in it say by themselves which instructions they need.
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
