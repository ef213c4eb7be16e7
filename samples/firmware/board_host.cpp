// The host: an ordinary program.
#include <cstdio>

#include "board.hpp"

namespace firmware {

void print(const char* text) { std::fputs(text, stdout); }
std::uint64_t instructions() { return 0; }
std::size_t stack_used() { return 0; }
void disturb_floats(bool) {}

}  // namespace firmware

int main() { return firmware::run(); }
