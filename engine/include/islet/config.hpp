// What a build of the engine has in it.
#pragma once

/// The widest lanes that the constraint kernels are compiled for: 1, 4 or 8. Unless given, as wide as the target's baseline has vectors (on x86-64
/// eight too, used where the processor turns out to have AVX2), and 1 where it has none. Decides the size of the scratch memory, so the engine and
/// those who use it must agree. The bits are the same.
#if !defined(ISLET_MAX_LANES)
#if defined(__x86_64__) || defined(_M_X64)
#define ISLET_MAX_LANES 8
#elif defined(__SSE2__) || defined(__ARM_NEON) || defined(__wasm_simd128__)
#define ISLET_MAX_LANES 4
#else
#define ISLET_MAX_LANES 1
#endif
#endif
