// Asks the processor what it can do. (The compiler's own function for this would need its runtime library.)
#pragma once

#if defined(__x86_64__)
#include <cpuid.h>
#endif

namespace islet::detail {

#if defined(__x86_64__)
/// What leaf 7 says, if the operating system saves the registers whose bits of XCR0 are `saved`; else no bits.
struct CpuFeatures {
    unsigned ebx = 0, ecx = 0;

    explicit CpuFeatures(unsigned saved) {
        unsigned a = 0, b = 0, c = 0, d = 0;
        if (__get_cpuid(1, &a, &b, &c, &d) == 0 || (c & bit_OSXSAVE) == 0 || (c & bit_AVX) == 0) return;
        unsigned low = 0;
        unsigned high = 0;
        __asm__("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
        if ((low & saved) != saved || __get_cpuid_count(7, 0, &a, &b, &c, &d) == 0) return;
        ebx = b;
        ecx = c;
    }
};
#endif

inline bool cpu_has_avx2() {
#if defined(__x86_64__)
    return (CpuFeatures(0x06).ebx & bit_AVX2) != 0;
#else
    return false;
#endif
}

/// AVX-512 without a catch. The first processors that had it ran slower while they used it; those with VBMI2, from Ice Lake and Zen 4 on, do not.
inline bool cpu_has_avx512() {
#if defined(__x86_64__)
    constexpr unsigned wanted = bit_AVX512F | bit_AVX512DQ | bit_AVX512BW | bit_AVX512VL;
    const CpuFeatures has(0xe6);
    return (has.ebx & wanted) == wanted && (has.ecx & bit_AVX512VBMI2) != 0;
#else
    return false;
#endif
}

}  // namespace islet::detail
