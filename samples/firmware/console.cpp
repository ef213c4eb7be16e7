#include "console.hpp"

#include "board.hpp"

namespace firmware {

void print_decimal(std::uint32_t value) {
    char text[11];
    char* at = text + 10;
    *at = 0;
    do {
        *--at = static_cast<char>('0' + value % 10);
        value /= 10;
    } while (value != 0);
    print(at);
}

void print_hash(std::uint64_t value) {
    char text[17] = {};
    for (int i = 15; i >= 0; --i, value >>= 4) text[i] = "0123456789abcdef"[value & 15u];
    print(text);
}

}  // namespace firmware
