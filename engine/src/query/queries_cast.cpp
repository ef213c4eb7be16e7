// Rays and moving shapes against all shapes of a world.
#include "../exact.hpp"

#include "../bodies/bounds.hpp"
#include "../calls/checks.hpp"
#include "../collide/difference.hpp"
#include "../math/float_mode.hpp"
#include "../query/queries.hpp"

namespace islet {

using namespace detail;

namespace detail {
namespace {

/// When a moving interval overlaps a standing one: fractions of the way.
struct Stay {
    float enter = 0;
    float leave = 0;
};

// One axis of the way: the interval lower-upper moves by d. Every operation is monotone, so a larger box is never entered later.
Stay stay_in(float lower, float upper, float d, float inv_d, float box_lower, float box_upper) {
    if (inv_d == 0) return box_lower <= upper && lower <= box_upper ? Stay{-3.0e38f, 3.0e38f} : Stay{3.0e38f, -3.0e38f};
    const float t1 = (box_lower - upper) * inv_d;
    const float t2 = (box_upper - lower) * inv_d;
    return d > 0 ? Stay{t1, t2} : Stay{t2, t1};
}

/// The question: a proxy, which for a ray is one point, and its way.
struct Cast {
    const Core& core;
    const ShapeProxy& moving;
    Vec2 d;
    QueryFilter filter;
    Aabb box;    // at the start, and a little more
    Aabb all;    // around the whole way
    Vec2 inv_d;  // 0 where d is as good as 0

    Cast(const Core& c, const ShapeProxy& p, Vec2 translation, const QueryFilter& f) : core(c), moving(p), d(translation), filter(f) {
        const Aabb start = box_of(p);
        box = expand(start, rounding_of(merge(start, {start.lower + d, start.upper + d})));
        all = merge(box, {box.lower + d, box.upper + d});
        inv_d = {abs(d.x) > 1e-30f ? 1.0f / d.x : 0, abs(d.y) > 1e-30f ? 1.0f / d.y : 0};
    }

    /// The fraction of the way at which the proxy's box enters another, at least 0; above 1 if it does not.
    float entry(const Aabb& to) const {
        if (!meet_at_once(all, to)) return 2.0f;
        const Stay x = stay_in(box.lower.x, box.upper.x, d.x, inv_d.x, to.lower.x, to.upper.x);
        const Stay y = stay_in(box.lower.y, box.upper.y, d.y, inv_d.y, to.lower.y, to.upper.y);
        const float enter = max(0.0f, max(x.enter, y.enter));
        return enter <= min(x.leave, y.leave) ? enter : 2.0f;
    }

    /// Meets one shape; null if it does not.
    QueryHit meet(std::uint32_t shape) const {
        if (!is_queried(core, shape, filter)) return {};
        const Transform t = body_transform(core, core.shapes[shape].body);
        const ShapeProxy seen = seen_from(t, moving);
        const Vec2 way = inv_rotate(t.q, d);
        const CastHit hit = cast_proxy(seen, way, proxy_of(core.geometries[core.shapes[shape].geometry], seen, way));
        if (!hit.hit) return {};
        // Not before its box: so it never matters when a search comes to the box.
        const float fraction = max(hit.fraction, entry(core.boxes[shape]));
        if (fraction > 1) return {};
        return {core.shape_id(shape), transform_point(t, hit.point), rotate(t.q, hit.normal), fraction, hit.separation};
    }
};

/// The first hits behind `after`, if given, up to `limit`; as many as there is room for.
void find_first(const Cast& cast, FirstFew<QueryHit>& found, float limit, const QueryHit* after) {
    const auto reaches = [&](const Aabb& box) { return cast.entry(box) <= (found.full() ? found.items[found.count - 1].fraction : limit); };
    search_shapes(cast.core, reaches, [&](std::uint32_t shape) {
        const QueryHit hit = cast.meet(shape);
        if (hit && hit.fraction <= limit && (after == nullptr || comes_before(*after, hit))) found.add(hit);
    });
}

bool check_cast(const Core& core, const ShapeProxy& shape, Vec2 translation) { return check_proxy(core, shape) && check_translation(core, translation); }

QueryHit first_hit(const Core& core, const ShapeProxy& shape, Vec2 translation, const QueryFilter& filter) {
    if (queries_are_cut(core)) return {};
    const DefaultFloatMode mode;
    QueryHit hit;
    if (!check_cast(core, shape, translation)) return hit;
    FirstFew<QueryHit> found{&hit, 1};
    find_first(Cast(core, shape, translation, filter), found, 1, nullptr);
    return hit;
}

bool any_hit(const Core& core, const ShapeProxy& shape, Vec2 translation, const QueryFilter& filter) {
    if (queries_are_cut(core)) return false;
    const DefaultFloatMode mode;
    if (!check_cast(core, shape, translation)) return false;
    const Cast cast(core, shape, translation, filter);
    bool any = false;
    const auto reaches = [&](const Aabb& box) { return !any && cast.entry(box) <= 1; };
    search_shapes(core, reaches, [&](std::uint32_t s) { any = bool(cast.meet(s)); });
    return any;
}

std::uint32_t all_hits(const Core& core, const ShapeProxy& shape, Vec2 translation, span<QueryHit> out, const QueryFilter& filter) {
    if (queries_are_cut(core)) return 0;
    const DefaultFloatMode mode;
    if (!check_cast(core, shape, translation)) return 0;
    const Cast cast(core, shape, translation, filter);
    FirstFew<QueryHit> found{out.data(), out.size()};
    std::uint32_t count = 0;
    const auto reaches = [&](const Aabb& box) { return cast.entry(box) <= 1; };
    search_shapes(core, reaches, [&](std::uint32_t s) {
        const QueryHit hit = cast.meet(s);
        if (!hit) return;
        ++count;
        found.add(hit);
    });
    return count;
}

void each_hit(const Core& core, const ShapeProxy& shape, Vec2 translation, const QueryFilter& filter, CastVisitor visit_hook, void* context) {
    if (queries_are_cut(core)) return;
    const DefaultFloatMode mode;
    if (!check_cast(core, shape, translation) || visit_hook == nullptr) return;
    const Cast cast(core, shape, translation, filter);
    float limit = 1;
    QueryHit hits[visits_a_search];
    QueryHit last;
    for (bool again = true; again;) {  // each search finds later hits than the one before
        FirstFew<QueryHit> found{hits, visits_a_search};
        find_first(cast, found, limit, last ? &last : nullptr);
        for (std::size_t i = 0; i < found.count; ++i) {
            last = hits[i];
            if (last.fraction > limit) return;
            const float answer = visit_hook(last, context);
            if (answer == 0) return;
            if (answer > 0) limit = min(limit, answer);
        }
        again = found.full();
    }
}

}  // namespace
}  // namespace detail

QueryHit World::cast_ray(Vec2 origin, Vec2 translation, const QueryFilter& filter) const {
    return check_position(core(), origin) ? first_hit(core(), point_proxy(origin), translation, filter) : QueryHit{};
}

bool World::cast_ray_any(Vec2 origin, Vec2 translation, const QueryFilter& filter) const {
    return check_position(core(), origin) && any_hit(core(), point_proxy(origin), translation, filter);
}

std::uint32_t World::cast_ray_all(Vec2 origin, Vec2 translation, span<QueryHit> out, const QueryFilter& filter) const {
    return check_position(core(), origin) ? all_hits(core(), point_proxy(origin), translation, out, filter) : 0;
}

void World::cast_ray_each(Vec2 origin, Vec2 translation, const QueryFilter& filter, CastVisitor visit, void* context) const {
    if (check_position(core(), origin)) each_hit(core(), point_proxy(origin), translation, filter, visit, context);
}

QueryHit World::cast_shape(const ShapeProxy& shape, Vec2 translation, const QueryFilter& filter) const { return first_hit(core(), shape, translation, filter); }

bool World::cast_shape_any(const ShapeProxy& shape, Vec2 translation, const QueryFilter& filter) const { return any_hit(core(), shape, translation, filter); }

std::uint32_t World::cast_shape_all(const ShapeProxy& shape, Vec2 translation, span<QueryHit> out, const QueryFilter& filter) const {
    return all_hits(core(), shape, translation, out, filter);
}

void World::cast_shape_each(const ShapeProxy& shape, Vec2 translation, const QueryFilter& filter, CastVisitor visit, void* context) const {
    each_hit(core(), shape, translation, filter, visit, context);
}

}  // namespace islet
