// What the firmware needs of the machine it runs on. One file per family: board_cortex_m.cpp, board_riscv.cpp, and board_host.cpp, which makes the same
// program an ordinary one, whose hashes the others must repeat.
#pragma once

#include <cstddef>
#include <cstdint>

namespace firmware {

/// Writes the text to the console: semihosting on the boards.
void print(const char* text);

/// Instructions executed so far; 0 where nothing counts them. On a Cortex-M, ask at least once every 2^24 ticks of SysTick.
std::uint64_t instructions();

/// The deepest the stack has been, bytes; 0 where nothing tells.
std::size_t stack_used();

/// Makes the processor round towards zero and, where it can, flush denormal numbers to zero, or sets it right again: a program may run like that, and the
/// engine must not notice. Nothing on the host and without a floating-point unit.
void disturb_floats(bool on);

/// The program proper. Returns its exit status.
int run();

}  // namespace firmware
