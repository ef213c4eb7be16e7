// Conservative advancement (Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996): two shapes that are d apart along a direction n do
// not meet before they have come d nearer along n, and no point of them does so faster than the centres approach each other along n plus what the
// turning can add. So time may go on by d over that speed, and never passes an impact.
#include "../exact.hpp"

#include "../collide/time_of_impact.hpp"

#include "../data/features.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

namespace {

// The way left shrinks at least by half or so in each pass, unless shapes turn by each other closely.
inline constexpr std::uint32_t max_advances = 48;

// The core's points at a fraction of the step, relative to `from`.
void place(Vec2* out, const MovingCore& s, float fraction, Vec2 from) {
    const Rot q = rotation_at(s.path, fraction);
    const Vec2 center = center_at(s.path, fraction) - from;
    for (std::uint32_t i = 0; i < s.core.count; ++i) out[i] = center + rotate(q, s.core.points[i]);
}

bool rests(const BodyPath& path) { return path.way == Vec2{0, 0} && path.turn == 0; }

}  // namespace

Rot rotation_at(const BodyPath& path, float fraction) { return integrate(path.q, fraction * path.turn); }
Vec2 center_at(const BodyPath& path, float fraction) { return path.center + fraction * path.way; }

float time_of_impact(const MovingCore& a, const MovingCore& b, float gap, float end) {
    constexpr float uneven = 1.01f;  // rotation_at turns a little faster in one part of the way than in another
    const float turning = uneven * (abs(a.path.turn) * a.reach + abs(b.path.turn) * b.reach);
    const float near = a.core.radius + b.core.radius + gap;
    float fraction = 0;
    Vec2 points_a[max_polygon_vertices], points_b[max_polygon_vertices];
    for (std::uint32_t pass = 0; pass < max_advances; ++pass) {
        if (pass == 0 || !rests(a.path)) place(points_a, a, fraction, a.path.center);
        if (pass == 0 || !rests(b.path)) place(points_b, b, fraction, a.path.center);
        const DistanceResult nearest = core_distance(points_a, a.core.count, points_b, b.core.count);
        const float left = nearest.distance - near;
        const float approach = dot(a.path.way - b.path.way, nearest.normal) + turning;
        if (left <= gap) {
            if (fraction > 0) return fraction;
            return nearest.normal == Vec2{0, 0} ? overlaps_from_the_start : approach > 0 ? 0 : no_impact;
        }
        if (!(approach * (end - fraction) > left)) return no_impact;
        fraction += left / approach;
    }
    return fraction;
}

}  // namespace islet::detail
