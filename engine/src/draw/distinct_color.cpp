// Geometries as the polygons, circles, capsules and segments of DebugDraw.
#include "../exact.hpp"

#include "../draw/draw_pen.hpp"

namespace islet {

using namespace detail;

// Six hues of 256 tints each; from one number to the next the hue goes on by the golden section of the circle, so that any few in a row are far apart.
// Every other round of sixteen is paler.
DrawColor distinct_color(std::uint32_t n) {
    const std::uint32_t hue = static_cast<std::uint32_t>((std::uint64_t{n * 2654435769u} * 1536u) >> 32);
    const std::uint32_t low = (n & 16u) != 0 ? 128u : 64u;
    constexpr std::uint32_t high = 232;
    const std::uint32_t way = (high - low) * (hue & 255u) / 255u;
    const std::uint32_t up = low + way, down = high - way;
    switch (hue >> 8) {
        case 0: return high << 16 | up << 8 | low;
        case 1: return down << 16 | high << 8 | low;
        case 2: return low << 16 | high << 8 | up;
        case 3: return low << 16 | down << 8 | high;
        case 4: return up << 16 | low << 8 | high;
        default: return high << 16 | low << 8 | down;
    }
}

}  // namespace islet
