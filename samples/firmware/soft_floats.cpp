// In the place of the compiler's multiplication of floats, where that is slow and there is no floating-point unit. (A program's own function comes before one
// of the compiler's library. Without a unit, floats are passed as their bits.)
#include "soft_multiply.hpp"

#if defined(__ARM_ARCH_6M__)
extern "C" std::uint32_t __aeabi_fmul(std::uint32_t a, std::uint32_t b) { return firmware::soft_multiply(a, b); }
#elif defined(__riscv) && !defined(__riscv_flen)
extern "C" std::uint32_t __mulsf3(std::uint32_t a, std::uint32_t b) { return firmware::soft_multiply(a, b); }
#endif
