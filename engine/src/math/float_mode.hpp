// The processor's floating-point mode. A host may have switched on flush-to-zero (audio code does, and linking with -ffast-math does so for the whole program)
// or another rounding, which would change results. The engine computes in the IEEE default mode and then restores the host's mode.
#pragma once

#include <cstdint>

#if defined(__SSE2__) || defined(_M_X64)
#include <immintrin.h>
#endif

namespace islet::detail {

/// While it lives: round to nearest, no flush-to-zero, no traps.
class DefaultFloatMode {
public:
    DefaultFloatMode(const DefaultFloatMode&) = delete;
    DefaultFloatMode& operator=(const DefaultFloatMode&) = delete;

#if defined(__SSE2__) || defined(_M_X64)
    DefaultFloatMode() : saved_(_mm_getcsr()) { _mm_setcsr(0x1f80u); }
    ~DefaultFloatMode() { _mm_setcsr(saved_); }

private:
    std::uint32_t saved_;
#elif defined(__aarch64__)
    DefaultFloatMode() {
        __asm__ volatile("mrs %0, fpcr" : "=r"(saved_));
        __asm__ volatile("msr fpcr, %0" : : "r"(std::uint64_t{0}));
    }
    ~DefaultFloatMode() { __asm__ volatile("msr fpcr, %0" : : "r"(saved_)); }

private:
    std::uint64_t saved_ = 0;
#elif defined(__arm__) && defined(__ARM_FP)
    // Clears only the bits of the mode: half precision, default NaN, flush to zero, rounding, traps. Other bits belong to vectors (a wrong one is a fault on
    // the M55).
    DefaultFloatMode() {
        __asm__ volatile("vmrs %0, fpscr" : "=r"(saved_));
        __asm__ volatile("vmsr fpscr, %0" : : "r"(saved_ & ~std::uint32_t{0x07c89f00u}));
    }
    ~DefaultFloatMode() { __asm__ volatile("vmsr fpscr, %0" : : "r"(saved_)); }

private:
    std::uint32_t saved_ = 0;
#elif defined(__riscv_flen)
    DefaultFloatMode() { __asm__ volatile("csrrwi %0, frm, 0" : "=r"(saved_)); }
    ~DefaultFloatMode() { __asm__ volatile("csrw frm, %0" : : "r"(saved_)); }

private:
    unsigned long saved_ = 0;
#else
    DefaultFloatMode() {}
    ~DefaultFloatMode() {}
#endif
};

}  // namespace islet::detail
