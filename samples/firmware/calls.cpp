// Runs the ten calls of ten_calls.c or ten_calls.cpp, and prints what they came to: the same for both.
#include "board.hpp"
#include "console.hpp"

extern "C" int ten_calls(float found[4]);

namespace firmware {

int run() {
    float found[4] = {};
    const int error = ten_calls(found);
    for (const float value : found) {
        print_decimal(static_cast<std::uint32_t>(1e6f * (10 + value)));
        print("\n");
    }
    return error;
}

}  // namespace firmware
