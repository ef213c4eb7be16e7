// Words and numbers on the console, without a C library.
#pragma once

#include <cstdint>

namespace firmware {

void print_decimal(std::uint32_t value);
/// Sixteen hexadecimal digits.
void print_hash(std::uint64_t value);

}  // namespace firmware
