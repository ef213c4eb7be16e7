// What the same bits need of the compiler, said in the source because a user's flags are the user's. Every .cpp of the engine includes this file first.
//
// Each operation on floats is the IEEE one: no product is fused with a sum, nothing is reordered, no number is taken for impossible. Where a compiler
// cannot be told so in the source it refuses here, or the world refuses to be made (Error::inexact_build).
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
// The last one is about size and speed alone: a square root that need not report errors is one instruction. (no-fast-math would bring errors back.)
#pragma GCC optimize("no-fast-math", "fp-contract=off", "no-math-errno")
#if defined(__x86_64__) || defined(__i386__)
// The vectoriser of GCC 12 makes fused operations of alternating sums and differences all the same, so there are none to be had.
#pragma GCC target("no-fma,no-fma4,no-avx512f")
#endif
#endif

#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ == 2
#error "Islet cannot keep its bits in registers that hold more digits than a float (x87): add -msse2 -mfpmath=sse for the files in engine/src"
#endif
