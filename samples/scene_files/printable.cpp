#include "scene_files/printable.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace islet::samples {
namespace {

/// A code point and how many bytes it takes; of no bytes where there is none.
struct CodePoint {
    std::uint32_t value = 0;
    std::size_t bytes = 0;
};

CodePoint first_of(std::string_view text) {
    const auto byte = [text](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
    const std::uint32_t lead = byte(0);
    if (lead < 0x80) return {lead, 1};
    const std::size_t bytes = lead < 0xc2 ? 0 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : lead < 0xf5 ? 4 : 0;
    if (bytes == 0 || bytes > text.size()) return {};
    std::uint32_t value = lead & (0x7fu >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return {};
        value = value << 6 | (byte(i) & 0x3f);
    }
    constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool is_surrogate = value >= 0xd800 && value < 0xe000;
    return value < least[bytes] || value > 0x10ffff || is_surrogate ? CodePoint{} : CodePoint{value, bytes};
}

}  // namespace

std::string printable(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    while (!text.empty()) {
        const CodePoint c = first_of(text);
        const bool is_control = c.value < 0x20 || (c.value >= 0x7f && c.value < 0xa0);
        const bool is_none = c.bytes == 0 || (c.value & 0xfffe) == 0xfffe || (c.value >= 0xfdd0 && c.value <= 0xfdef);
        if (is_none)
            out += "\xef\xbf\xbd";
        else if (is_control)
            out += ' ';
        else
            out += text.substr(0, c.bytes);
        text.remove_prefix(std::max<std::size_t>(c.bytes, 1));
    }
    return out;
}

std::string markup(std::string_view text) {
    std::string out;
    for (const char c : printable(text)) out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    return out;
}

}  // namespace islet::samples
