// RISC-V: start-up, semihosting, and the processor's own count of instructions.
#include "board.hpp"
#include "memory_image.hpp"

__asm__(".option arch, +zicsr");  // a set of its own since 2019; the compiler's names for processors without floats leave it out

namespace {

// Operations of semihosting, as on Arm ("RISC-V Semihosting", RISC-V International 2023).
constexpr std::uint32_t sys_write0 = 0x04;
constexpr std::uint32_t sys_exit_extended = 0x20;
constexpr std::uint32_t application_exit = 0x20026;

std::uint32_t semihosting(std::uint32_t operation, const void* argument) {
    register std::uint32_t a0 __asm__("a0") = operation;
    register const void* a1 __asm__("a1") = argument;
    // The two shifts, which do nothing, mark the break as a call; none of the three may be compressed, nor cross a page.
    __asm__ volatile(
        ".option push\n .option norvc\n .balign 16\n"
        "slli zero, zero, 0x1f\n ebreak\n srai zero, zero, 7\n"
        ".option pop"
        : "+r"(a0)
        : "r"(a1)
        : "memory");
    return a0;
}

[[noreturn]] void leave(std::uint32_t status) {
    const std::uint32_t block[2] = {application_exit, status};
    for (;;) semihosting(sys_exit_extended, block);
}

}  // namespace

namespace firmware {

void print(const char* text) { semihosting(sys_write0, text); }

std::uint64_t instructions() {
    std::uint32_t high = 0, low = 0, again = 0;
    do {
        __asm__ volatile("csrr %0, minstreth\n csrr %1, minstret\n csrr %2, minstreth" : "=r"(high), "=r"(low), "=r"(again));
    } while (high != again);
    return std::uint64_t{high} << 32 | low;
}

std::size_t stack_used() { return painted_stack_used(); }

void disturb_floats([[maybe_unused]] bool on) {
#if defined(__riscv_flen)
    __asm__ volatile("csrw frm, %0" : : "r"(on ? 1u : 0u));  // 1: round towards zero
#endif
}

}  // namespace firmware

extern "C" {

[[noreturn, gnu::used]] void begin() {
    firmware::prepare_memory();
    leave(static_cast<std::uint32_t>(firmware::run()));
}

[[noreturn, gnu::used, gnu::aligned(4)]] void fault() {
    firmware::print("fault\n");
    leave(3);
}

// The stack, the handler of faults and the floating-point unit, before there is any C++.
[[gnu::section(".start"), gnu::used, gnu::naked]] void start() {
    __asm__ volatile(
        "la sp, image_stack_top\n"
        "la t0, fault\n csrw mtvec, t0\n"
#if defined(__riscv_flen)
        "li t0, 0x2000\n csrs mstatus, t0\n fscsr zero\n"
#endif
        "j begin");
}
}
