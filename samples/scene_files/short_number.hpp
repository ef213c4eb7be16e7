// Floats as people write them.
#pragma once

#include <fmt/format.h>

#include <string>

namespace islet::samples {

/// The shortest decimal that reads back as the same float, as a double: 0.016666668 rather than 0.01666666753590107.
inline double short_number(float value) { return std::stod(fmt::format("{}", value)); }

}  // namespace islet::samples
