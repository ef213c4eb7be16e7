// Cortex-M: vectors, start-up, semihosting, and SysTick as a counter of instructions.
#include "board.hpp"
#include "memory_image.hpp"

namespace {

// Operations of Arm's semihosting ("Semihosting for AArch32 and AArch64", Arm 2022).
constexpr std::uint32_t sys_write0 = 0x04;
constexpr std::uint32_t sys_exit_extended = 0x20;
constexpr std::uint32_t application_exit = 0x20026;

std::uint32_t semihosting(std::uint32_t operation, const void* argument) {
    register std::uint32_t r0 __asm__("r0") = operation;
    register const void* r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

[[noreturn]] void leave(std::uint32_t status) {
    const std::uint32_t block[2] = {application_exit, status};
    for (;;) semihosting(sys_exit_extended, block);
}

volatile std::uint32_t& hardware(std::uint32_t address) { return *reinterpret_cast<volatile std::uint32_t*>(address); }

constexpr std::uint32_t systick_control = 0xe000e010u, systick_reload = 0xe000e014u, systick_value = 0xe000e018u;
constexpr std::uint32_t configuration_control = 0xe000ed14u, coprocessor_access = 0xe000ed88u;
constexpr std::uint32_t systick_mask = 0x00ffffffu;

std::uint64_t ticks;         // since start
std::uint32_t last_value;    // of the counter, which counts down
std::uint32_t instructions_per_tick;  // times 256

constexpr std::uint32_t calibration_loops = 500000;  // of two instructions

void count_ticks() {
    const std::uint32_t now = hardware(systick_value);
    ticks += (last_value - now) & systick_mask;
    last_value = now;
}

// The emulator executes one instruction a nanosecond; how many of these make a tick depends on the board's clock. So a loop of known length tells.
void calibrate() {
    hardware(systick_reload) = systick_mask;
    hardware(systick_value) = 0;
    hardware(systick_control) = 5;  // on, processor clock, no interrupt
    last_value = hardware(systick_value);
    count_ticks();
    const auto before = static_cast<std::uint32_t>(ticks);
    std::uint32_t n = calibration_loops;
    __asm__ volatile(".syntax unified\n1: subs %0, %0, #1\n bne 1b" : "+r"(n) : : "cc");
    count_ticks();
    const std::uint32_t taken = static_cast<std::uint32_t>(ticks) - before;
    instructions_per_tick = (256 * 2 * calibration_loops + taken / 2) / taken;
}

}  // namespace

namespace firmware {

void print(const char* text) { semihosting(sys_write0, text); }

std::uint64_t instructions() {
    count_ticks();
    return ticks * instructions_per_tick / 256;
}

std::size_t stack_used() { return painted_stack_used(); }

void disturb_floats([[maybe_unused]] bool on) {
#if defined(__ARM_FP)
    constexpr std::uint32_t mode = 1u << 24 | 3u << 22;  // flush to zero, round towards zero
    std::uint32_t status = 0;
    __asm__ volatile("vmrs %0, fpscr" : "=r"(status));
    status = on ? status | mode : status & ~mode;
    __asm__ volatile("vmsr fpscr, %0" : : "r"(status));
#endif
}

}  // namespace firmware

extern "C" {

[[noreturn]] void reset() {
    firmware::prepare_memory();
#if defined(__ARM_FP)
    hardware(coprocessor_access) = hardware(coprocessor_access) | 0xfu << 20;
    __asm__ volatile("dsb\n isb" : : : "memory");
#endif
#if defined(__ARM_ARCH_6M__)
    hardware(configuration_control) = hardware(configuration_control) | 1u << 3;  // a word that is not aligned is a fault, as on a Cortex-M0+
#endif
    calibrate();
    leave(static_cast<std::uint32_t>(firmware::run()));
}

[[noreturn]] void fault() {
    firmware::print("fault\n");
    leave(3);
}

[[gnu::section(".start"), gnu::used]] const std::uintptr_t vectors[16] = {
    reinterpret_cast<std::uintptr_t>(image_stack_top), reinterpret_cast<std::uintptr_t>(reset), reinterpret_cast<std::uintptr_t>(fault),
    reinterpret_cast<std::uintptr_t>(fault),           reinterpret_cast<std::uintptr_t>(fault), reinterpret_cast<std::uintptr_t>(fault),
    reinterpret_cast<std::uintptr_t>(fault)};
}
