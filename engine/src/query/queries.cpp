#include "../exact.hpp"

#include "../query/queries.hpp"

#include "../calls/checks.hpp"
#include "../shapes/shape_types.hpp"

namespace islet::detail {

ShapeProxy proxy_of(const Geometry& g, [[maybe_unused]] const ShapeProxy& seen, [[maybe_unused]] Vec2 way) {
    Around near{};
    if constexpr (has_endless) {
        near = around({seen.points, seen.count, seen.radius}, {});
        near.reach += length(way);
    }
    Vec2 room[4];
    ShapeProxy p = proxy_of(corners_near(g, near, room));
    p.one_sided = kind_of(g) == ShapeKind::front;
    return p;
}

ShapeProxy seen_from(const Transform& t, const ShapeProxy& p) {
    ShapeProxy seen = p;
    for (std::uint32_t i = 0; i < p.count; ++i) seen.points[i] = inv_transform_point(t, p.points[i]);
    return seen;
}

bool check_proxy(const Core& core, const ShapeProxy& p) {
    if (!check(core, islet::is_valid(p), Error::bad_geometry)) return false;
    for (std::uint32_t i = 0; i < p.count; ++i) {
        if (!check_position(core, p.points[i])) return false;
    }
    return true;
}

bool check_translation(const Core& core, Vec2 translation) {
    return check_range(core, translation.x, -max_translation, max_translation) && check_range(core, translation.y, -max_translation, max_translation);
}

Aabb box_of(const ShapeProxy& p) {
    Aabb box{p.points[0], p.points[0]};
    for (std::uint32_t i = 1; i < p.count; ++i) box = {min(box.lower, p.points[i]), max(box.upper, p.points[i])};
    return expand(box, p.radius);
}

}  // namespace islet::detail
