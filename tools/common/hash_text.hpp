// How a hash of a world is written, in tables and in JSON.
#pragma once

#include <cstdint>
#include <string>

#include <fmt/format.h>

namespace islet::tools {

/// 16 hexadecimal digits.
inline std::string hash_text(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

}  // namespace islet::tools
