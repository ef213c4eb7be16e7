// What the compiler must do for the bits to be the same. The source says it, since the flags are the user's. Every .cpp of the engine includes this file first.
//
// Each operation on floats is the IEEE one: no product is fused with a sum, nothing is reordered, infinities and NaN are allowed for. Where the source cannot
// make a compiler do so, compilation fails here, or World::create fails (Error::inexact_build).
#pragma once

#if defined(__clang__)
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "Islet cannot keep its bits under -ffast-math or -ffinite-math-only: add -fno-fast-math for the files in engine/src"
#endif
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wignored-pragmas"  // the first is not known for every processor
#pragma float_control(precise, on)
#pragma clang diagnostic pop
#pragma clang fp contract(off) reassociate(off)

#elif defined(__GNUC__)
// no-math-errno is about size and speed alone: a square root that need not report errors is one instruction. (no-fast-math would turn reports on again.)
#pragma GCC optimize("no-fast-math", "fp-contract=off", "no-math-errno")
#if defined(__x86_64__) || defined(__i386__)
// The vectoriser of GCC 12 fuses alternating sums and differences all the same, so the processor's fused instructions are ruled out.
#pragma GCC target("no-fma,no-fma4,no-avx512f")
#endif
#endif

#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ == 2
#error "Islet cannot keep its bits in registers that hold more digits than a float (x87): add -msse2 -mfpmath=sse for the files in engine/src"
#endif
