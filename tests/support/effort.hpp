// How much a test can afford to try.
#pragma once

namespace islet::test {

// Asserts, sanitizers and coverage make a step several times slower: such builds (all that leave NDEBUG out) run the large scenes shorter.
#ifdef NDEBUG
inline constexpr bool slow_build = false;
#else
inline constexpr bool slow_build = true;
#endif

/// So many random cases; a fortieth of them where each is many times slower, and what is looked for is bad memory rather than bad answers.
constexpr int cases(int n) { return slow_build ? n / 40 : n; }

/// The same for what is tried at places along a line: how many times as far they are apart.
inline constexpr float stride = slow_build ? 40 : 1;

}  // namespace islet::test
