// Questions to the world. Good arguments must find something finite, bad ones nothing; and the ways to ask the same thing must agree.
#include "player.hpp"

namespace islet::fuzz {

namespace {

void expect_good(const QueryHit& hit) {
    if (!hit) return;
    expect(is_finite(hit.point) && is_finite(hit.normal), "a query found what is not finite");
    expect(hit.fraction >= 0 && hit.fraction <= 1 && hit.separation <= 0, "a query found what is not on the way");
}

/// What a visitor is told, and when it has had enough.
struct Visits {
    std::uint32_t count = 0;
    std::uint32_t enough = 0xffffffffu;
    float answer = 1;
    QueryHit first = {};

    static float cast(const QueryHit& hit, void* context) {
        auto& self = *static_cast<Visits*>(context);
        if (self.count++ == 0) self.first = hit;
        expect_good(hit);
        return self.count >= self.enough ? 0 : self.answer;
    }
    static bool overlap(ShapeId, void* context) {
        auto& self = *static_cast<Visits*>(context);
        return ++self.count < self.enough;
    }
};

}  // namespace

void Player::ask() {
    ask_by_casts();
    ask_by_overlaps();
    const Vec2 from = in.point();
    const ClosestHit closest = w.closest(from, in.size());
    if (closest) expect(is_finite(closest.point) && is_finite(closest.normal) && closest.distance >= 0, "the closest point is none");
    Surface surfaces[4];
    const ShapeProxy near = proxy();
    const std::uint32_t n = w.surfaces_near(near, in.size(), surfaces);
    for (std::uint32_t i = 0; i < n && i < 4; ++i) {
        expect(is_finite(surfaces[i].point) && is_finite(surfaces[i].normal), "a surface is nowhere");
        expect(i == 0 || surfaces[i - 1].separation <= surfaces[i].separation, "surfaces are not told from the nearest on");
    }
}

void Player::ask_by_casts() {
    const Vec2 from = in.point(), way = in.point();
    QueryFilter filter;
    if (in.flag()) {
        const std::uint32_t category = in.byte();
        filter = {category, in.byte(), in.flag()};
    }
    QueryHit hits[4];
    const QueryHit ray = w.cast_ray(from, way, filter);
    expect_good(ray);
    expect(w.cast_ray_any(from, way, filter) == bool(ray), "two ways to cast a ray disagree");
    std::uint32_t met = w.cast_ray_all(from, way, hits, filter);
    expect((met > 0) == bool(ray) && (met == 0 || hits[0].shape == ray.shape), "the first of all hits is not the first hit");
    Visits all;
    w.cast_ray_each(from, way, filter, Visits::cast, &all);
    expect(all.count == met && all.first.shape == ray.shape, "a ray tells one by one of other hits than all at once");

    const ShapeProxy moving = proxy();
    const QueryHit cast = w.cast_shape(moving, way, filter);
    expect_good(cast);
    expect(w.cast_shape_any(moving, way, filter) == bool(cast), "two ways to cast a shape disagree");
    met = w.cast_shape_all(moving, way, hits, filter);
    expect((met > 0) == bool(cast) && (met == 0 || hits[0].shape == cast.shape), "the first of all that a shape hits is not the first hit");
    all = {};
    w.cast_shape_each(moving, way, filter, Visits::cast, &all);
    expect(all.count == met && all.first.shape == cast.shape, "a moving shape tells one by one of other hits than all at once");

    // Visitors that stop, cut the way or ignore, and one that is none.
    Visits some;
    some.enough = 1 + in.below(3);
    some.answer = in.number();
    w.cast_ray_each(from, way, filter, Visits::cast, &some);
    some.count = 0;
    w.cast_shape_each(moving, way, filter, Visits::cast, &some);
    expect(some.count <= some.enough, "a visitor that has had enough is told more");
    w.cast_ray_each(from, way, filter, nullptr, nullptr);
    w.cast_shape_each(moving, way, filter, nullptr, nullptr);
}

void Player::ask_by_overlaps() {
    const Vec2 lower = in.point(), upper = in.point();
    const Aabb box = {lower, upper};
    const ShapeProxy shape = proxy();
    ShapeId ids[4];
    Visits visits;
    w.overlap_box_each(box, {}, Visits::overlap, &visits);
    expect(w.overlap_box(box, ids) == visits.count, "a box finds one by one other shapes than all at once");
    visits = {};
    w.overlap_shape_each(shape, {}, Visits::overlap, &visits);
    expect(w.overlap_shape(shape, ids) == visits.count, "a shape finds one by one other shapes than all at once");
    visits = {};
    w.overlap_point_each(lower, {}, Visits::overlap, &visits);
    expect(w.overlap_point(lower, ids) == visits.count, "a point finds one by one other shapes than all at once");
    if (visits.count < 2) return;
    visits = {};
    visits.enough = 1;
    w.overlap_point_each(lower, {}, Visits::overlap, &visits);
    expect(visits.count == 1, "a visitor that has had enough is told more");
}

}  // namespace islet::fuzz
