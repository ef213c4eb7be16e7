// Making chains. A program that makes none does not link this file, nor the functions with which chains collide (shapes/chain_segment.cpp).
#include "../exact.hpp"

#include "../bodies/geometry_pool.hpp"
#include "../calls/checks.hpp"
#include "../calls/recorder.hpp"
#include "../shapes/manifolds.hpp"
#include "../world/shapes.hpp"

namespace islet {

using namespace detail;

ISLET_DEFINE_CREATE_SHAPE(chain_segment, ChainSegment)
ISLET_DEFINE_SET_SHAPE(chain_segment, ChainSegment)

std::uint32_t World::create_chain(BodyId id, span<const Vec2> points, bool loop, const ShapeDef& def, span<ShapeId> out) {
    Core& c = core();
    note_call<Call::create_chain>(c, id, points, loop, def);
    if (!check_there(c, has_chains)) return 0;
    const std::uint32_t body = find_slot(c, id);
    if (body == null_index || !check_shape_def(c, def)) return 0;
    const std::size_t n = points.size();
    if (!check(c, n >= (loop ? 3u : 2u) && n <= max_capacity, Error::bad_chain)) return 0;
    const auto segments = static_cast<std::uint32_t>(loop ? n : n - 1);

    // An open end goes on straight, so its ghost point is the mirror image of the next point.
    const auto segment_at = [&](std::uint32_t i) {
        const Vec2 p1 = points[i];
        const Vec2 p2 = points[(i + 1) % n];
        const Vec2 before = i > 0 ? points[i - 1] : (loop ? points[n - 1] : p1 - (p2 - p1));
        const Vec2 after = i + 2 < n ? points[i + 2] : (loop ? points[(i + 2) % n] : p2 + (p2 - p1));
        return ChainSegment{before, {p1, p2}, after};
    };
    for (const Vec2 point : points)
        if (!check_finite(c, point)) return 0;
    for (std::uint32_t i = 0; i < segments; ++i)
        if (!check(c, islet::is_valid(segment_at(i)), Error::bad_chain)) return 0;
    if (!check(c, c.capacity.shapes - c.state->shape_pool.count >= segments, Error::shapes_full)) return 0;

    const auto geometry_at = [&](std::uint32_t i) { return geometry_of(segment_at(i)); };
    // Either all segments are made or none, so they are counted first. (A segment that the chain repeats is counted each time.)
    std::uint32_t fresh = 0;
    for (std::uint32_t i = 0; i < segments; ++i) fresh += find_geometry(c, geometry_at(i)) == null_index ? 1 : 0;
    if (!check(c, geometry_capacity(c.capacity) - c.state->geometry_pool.count >= fresh, Error::geometries_full)) return 0;

    for (std::uint32_t i = 0; i < segments; ++i) {
        const std::uint32_t index = add_shape(c, body, geometry_at(i), def);
        if (i < out.size()) out[i] = c.shape_id(index);
    }
    shapes_changed(c, body, segments);
    return segments;
}

}  // namespace islet
