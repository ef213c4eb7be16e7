// The one floating-point function that the engine takes from the machine.
#pragma once

#include "islet/math.hpp"

namespace islet::detail {

/// IEEE square root, correctly rounded, so the same bits everywhere: one instruction on every target with a floating-point unit.
/// Never call it with a negative number: without -fno-math-errno the compiler leaves that case to the C library's sqrtf.
[[gnu::always_inline]] inline float sqrt(float a) { return __builtin_sqrtf(a); }

}  // namespace islet::detail
