// What needs no world: shapes and numbers as plain values; and worlds made of any block, capacity and definition.
#include "hosts.hpp"
#include "player.hpp"

namespace islet::fuzz {

namespace {

template <class Shape>
void expect_mass(const Shape& shape, float density) {
    const MassData mass = compute_mass(shape, density);
    if (is_valid(shape)) return;
    expect(mass.mass == 0 && mass.inertia == 0 && mass.center.x == 0 && mass.center.y == 0, "what is no shape has a mass");
}

template <class Shape>
void expect_box(const Shape& shape, const Transform& pose) {
    if (!is_valid(shape) || !is_finite(pose.p)) return;
    const Aabb box = compute_aabb(shape, pose);
    expect(box.lower.x <= box.upper.x && box.lower.y <= box.upper.y, "a shape has no box");
}

void expect_unit(Rot q) {
    expect(abs(q.c * q.c + q.s * q.s - 1) < 1e-5f, "a rotation is none");
}

}  // namespace

void Player::try_geometry() {
    const Vec2 at = in.point();
    const Transform pose = {at, make_rot(in.number())};
    const Circle c = circle();
    const Capsule k = capsule();
    const Segment s = segment();
    const Polygon p = polygon();
    const float density = in.number();
    expect_mass(c, density);
    expect_mass(k, density);
    expect_mass(p, density);
    expect_box(c, pose);
    expect_box(k, pose);
    expect_box(s, pose);
    expect_box(p, pose);
    is_valid(chain_segment());
    const Polygon moved = transform_polygon(pose, p);
    expect(moved.count == 0 || is_valid(moved), "a polygon was moved to where it is none");

    const ShapeProxy a = proxy(), b = proxy();
    const Separation apart = separation(a, b);
    const Vec2 from = in.point(), way = in.point();
    const CastHit ray = cast_ray(a, from, way), cast = cast_shape(a, way, b);
    if (is_valid(a) && is_valid(b)) {
        expect(is_finite(apart.distance) && is_finite(apart.point_a) && is_finite(apart.point_b) && is_finite(apart.normal), "shapes are nowhere from each other");
        overlaps(a, b);
        contains(a, from);
    } else {
        expect(!cast && !overlaps(a, b), "what is no shape was met");
    }
    for (const CastHit& hit : {ray, cast}) {
        if (!hit) continue;
        expect(hit.fraction >= 0 && hit.fraction <= 1 && hit.separation <= 0, "a cast meets what is not on its way");
        expect(is_finite(hit.point) && is_finite(hit.normal), "a cast meets what is nowhere");
    }
}

void Player::try_math() {
    constexpr float half_turn = 3.1415929f;
    const Vec2 v = in.point();
    const float angle = in.number();
    expect_unit(make_rot(angle));
    expect_unit(integrate(make_rot(angle), in.number()));
    expect_unit(normalize(Rot{v.x, v.y}));
    const float of_vector = atan2(v.y, v.x), of_rotation = angle_of(make_rot(angle));
    expect(abs(of_vector) <= half_turn && abs(of_rotation) <= half_turn, "an angle is more than half a turn");
    const Vec2 unit = normalize(v);
    const float squared = length_squared(unit);
    expect(squared == 0 || abs(squared - 1) < 1e-5f, "a unit vector is none");
    expect(!(length(v) < 0) && !(distance(v, unit) < 0), "a length is below zero");
    for (std::uint32_t code = in.byte(), i = 0; i < 2; ++i) expect(describe(static_cast<Error>(code * i)) != nullptr, "an error without words");
}

// A second world, in a block that may be too small or lie badly. It must be sound from the start.
void Player::try_create() {
    Capacity c;
    c.bodies = in.below(16);
    c.shapes = in.below(16);
    c.contacts = in.below(16);
    c.joints = in.below(8);
    c.events = in.below(4);
    const std::span<std::byte> block = in.below(4) == 0 ? std::span(f.spare).subspan(in.below(32), in.byte() * 16) : std::span(f.spare);
    WorldDef def = world_def();
    if (in.flag()) def.tasks = backwards_tasks(in.byte());
    Error error = Error::none;
    World* made = World::create(block, c, def, &error);
    expect((made == nullptr) == (error != Error::none), "a world was made with an error, or none without");
    if (made == nullptr) return;
    made->create_shape(made->create_body({}), Circle{});
    made->step(1.0f / 60);
    if (const char* broken = made->validate()) test::broken(broken);
}

}  // namespace islet::fuzz
