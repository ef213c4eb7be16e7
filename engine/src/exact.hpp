// What the compiler must do so that the bits are the same. The source demands it, because the user chooses the flags. Every .cpp of the engine includes this
// file first.
//
// Each operation on floats must be the IEEE one: no product is fused with a sum, nothing is reordered, and infinities and NaN count. Where the source cannot
// make the compiler comply, compilation fails here, or World::create fails (Error::inexact_build).
#pragma once

#if defined(__clang__)
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "Islet cannot keep its bits under -ffast-math or -ffinite-math-only: add -fno-fast-math for the files in engine/src"
#endif
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wignored-pragmas"  // some processors do not know the first pragma
#pragma float_control(precise, on)
#pragma clang diagnostic pop
#pragma clang fp contract(off) reassociate(off)

#elif defined(__GNUC__)
// no-math-errno is for size and speed alone: a square root that need not set errno is one instruction. (no-fast-math would turn errno on again.)
#pragma GCC optimize("no-fast-math", "fp-contract=off", "no-math-errno")
#if defined(__x86_64__) || defined(__i386__)
// The vectoriser of GCC 12 still fuses alternating sums and differences, so the processor's fused instructions are ruled out.
#pragma GCC target("no-fma,no-fma4,no-avx512f")
#endif
#if defined(__thumb__) && !defined(__thumb2__)
// In a build for size, GCC ends a function of a Cortex-M0 by popping the stack into registers that -fipa-ra does not know of, so it has that off for this
// processor. The first pragma above switches it on again: callers then lose what they keep in these registers.
#pragma GCC optimize("no-ipa-ra")
#endif
#elif defined(_MSC_VER)
#if defined(_M_FP_FAST)
#error "Islet cannot keep its bits under /fp:fast: add /fp:precise for the files in engine/src"
#endif
#pragma float_control(precise, on)
#pragma fp_contract(off)
#endif

#if defined(_M_IX86_FP) && _M_IX86_FP < 2
#error "Islet cannot keep its bits in registers that hold more digits than a float (x87): add /arch:SSE2 for the files in engine/src"
#endif
#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ == 2
#error "Islet cannot keep its bits in registers that hold more digits than a float (x87): add -msse2 -mfpmath=sse for the files in engine/src"
#endif
