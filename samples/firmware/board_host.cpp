// The host: an ordinary program.
#include <cstdio>

#include "board.hpp"

namespace firmware {

void print(const char* text) { std::fputs(text, stdout); }
std::uint64_t instructions() { return 0; }
std::size_t stack_used() { return 0; }

}  // namespace firmware

int main() { return firmware::run(); }
