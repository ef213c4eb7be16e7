// Numbers that are not finite or out of range, in every argument, and geometry that breaks its own rules.
#include <functional>

#include "refusal.hpp"

namespace {

using namespace islet;
using namespace islet::test;

class BadNumbers : public RefusalTest {};

TEST_F(BadNumbers, ABodyIsNotCreatedFromThem) {
    const auto refuse = [&](Error error, auto&& change) {
        BodyDef def;
        def.type = BodyType::dynamic;
        change(def);
        expect_refused(error, [&] { EXPECT_FALSE(w->create_body(def)); });
    };
    for (const Vec2 bad : not_finite_vectors) {
        refuse(Error::not_finite, [&](BodyDef& d) { d.position = bad; });
        refuse(Error::not_finite, [&](BodyDef& d) { d.linear_velocity = bad; });
    }
    for (float BodyDef::*member : {&BodyDef::angle, &BodyDef::angular_velocity, &BodyDef::linear_damping, &BodyDef::angular_damping,
                                   &BodyDef::gravity_scale, &BodyDef::sleep_threshold})
        for (const float bad : not_finite) refuse(Error::not_finite, [&](BodyDef& d) { d.*member = bad; });
    for (float BodyDef::*member : {&BodyDef::linear_damping, &BodyDef::angular_damping, &BodyDef::sleep_threshold})
        refuse(Error::out_of_range, [&](BodyDef& d) { d.*member = -0.001f; });
    refuse(Error::out_of_range, [&](BodyDef& d) { d.type = static_cast<BodyType>(3); });
    refuse(Error::out_of_range, [&](BodyDef& d) { d.type = static_cast<BodyType>(255); });
}

TEST_F(BadNumbers, AShapeIsNotCreatedFromThem) {
    const auto refuse = [&](Error error, auto&& change) {
        ShapeDef def;
        change(def);
        const Vec2 points[] = {{0, 0}, {1, 0}, {2, 1}};
        expect_refused(error, [&] { EXPECT_FALSE(w->create_shape(box, Circle{}, def)); });
        expect_refused(error, [&] { EXPECT_FALSE(w->create_shape(box, make_box(2, 3), def)); });
        expect_refused(error, [&] { EXPECT_EQ(w->create_chain(box, points, false, def), 0u); });
    };
    for (float ShapeDef::*member :
         {&ShapeDef::friction, &ShapeDef::restitution, &ShapeDef::rolling_resistance, &ShapeDef::tangent_speed, &ShapeDef::density})
        for (const float bad : not_finite) refuse(Error::not_finite, [&](ShapeDef& d) { d.*member = bad; });
    for (float ShapeDef::*member : {&ShapeDef::friction, &ShapeDef::restitution, &ShapeDef::rolling_resistance, &ShapeDef::density})
        refuse(Error::out_of_range, [&](ShapeDef& d) { d.*member = -0.001f; });
    refuse(Error::out_of_range, [&](ShapeDef& d) { d.restitution = 1.001f; });
}

struct BadCall {
    const char* name;
    std::function<void(World&, float)> with;
};

TEST_F(BadNumbers, EveryFunctionOfABodyRefusesThem) {
    const BadCall numbers[] = {
        {"set_transform angle",
         [&](World& a, float x) {
             a.set_transform(box, {0, 0}, x);
         }},
        {"set_angular_velocity", [&](World& a, float x) { a.set_angular_velocity(box, x); }},
        {"apply_torque", [&](World& a, float x) { a.apply_torque(box, x); }},
        {"apply_angular_impulse", [&](World& a, float x) { a.apply_angular_impulse(box, x); }},
        {"set_mass mass",
         [&](World& a, float x) {
             a.set_mass(box, {x, {}, 1});
         }},
        {"set_mass inertia",
         [&](World& a, float x) {
             a.set_mass(box, {1, {}, x});
         }},
        {"set_linear_damping", [&](World& a, float x) { a.set_linear_damping(box, x); }},
        {"set_angular_damping", [&](World& a, float x) { a.set_angular_damping(box, x); }},
        {"set_gravity_scale", [&](World& a, float x) { a.set_gravity_scale(box, x); }},
    };
    for (const BadCall& call : numbers) {
        SCOPED_TRACE(call.name);
        for (const float bad : not_finite) expect_refused(Error::not_finite, [&] { call.with(*w, bad); });
    }
    for (const Vec2 bad : not_finite_vectors) {
        expect_refused(Error::not_finite, [&] { w->set_transform(box, bad, 0); });
        expect_refused(Error::not_finite, [&] { w->set_linear_velocity(box, bad); });
        expect_refused(Error::not_finite, [&] { w->apply_force(box, bad, {0, 0}); });
        expect_refused(Error::not_finite, [&] { w->apply_force(box, {0, 0}, bad); });
        expect_refused(Error::not_finite, [&] { w->apply_force_to_center(box, bad); });
        expect_refused(Error::not_finite, [&] { w->apply_linear_impulse(box, bad, {0, 0}); });
        expect_refused(Error::not_finite, [&] { w->apply_linear_impulse(box, {0, 0}, bad); });
        expect_refused(Error::not_finite, [&] { w->apply_linear_impulse_to_center(box, bad); });
        expect_refused(Error::not_finite, [&] { w->set_mass(box, {1, bad, 1}); });
        expect_refused(Error::not_finite, [&] { EXPECT_EQ(w->velocity_at(box, bad), Vec2{}); });
    }
    expect_refused(Error::out_of_range, [&] { w->set_linear_damping(box, -1); });
    expect_refused(Error::out_of_range, [&] { w->set_angular_damping(box, -1); });
    expect_refused(Error::out_of_range, [&] { w->set_mass(box, {0, {}, 1}); });
    expect_refused(Error::out_of_range, [&] { w->set_mass(box, {-1, {}, 1}); });
    expect_refused(Error::out_of_range, [&] { w->set_mass(box, {1, {}, -1}); });
    expect_refused(Error::out_of_range, [&] { w->set_type(box, static_cast<BodyType>(3)); });
}

TEST_F(BadNumbers, EveryFunctionOfAShapeRefusesThem) {
    const BadCall calls[] = {
        {"set_friction", [&](World& a, float x) { a.set_friction(shape, x); }},
        {"set_restitution", [&](World& a, float x) { a.set_restitution(shape, x); }},
        {"set_rolling_resistance", [&](World& a, float x) { a.set_rolling_resistance(shape, x); }},
        {"set_tangent_speed", [&](World& a, float x) { a.set_tangent_speed(shape, x); }},
    };
    for (const BadCall& call : calls) {
        SCOPED_TRACE(call.name);
        for (const float bad : not_finite) expect_refused(Error::not_finite, [&] { call.with(*w, bad); });
    }
    expect_refused(Error::out_of_range, [&] { w->set_friction(shape, -0.1f); });
    expect_refused(Error::out_of_range, [&] { w->set_restitution(shape, -0.1f); });
    expect_refused(Error::out_of_range, [&] { w->set_restitution(shape, 1.1f); });
    expect_refused(Error::out_of_range, [&] { w->set_rolling_resistance(shape, -0.1f); });
}

// -- geometry ----------------------------------------------------------------------------------------------------------------------------

TEST_F(BadNumbers, GeometryThatBreaksItsRulesIsRefused) {
    const auto refuse = [&](const auto& geometry) {
        expect_refused(Error::bad_geometry, [&] { EXPECT_FALSE(w->create_shape(box, geometry)); });
    };
    for (const float radius : {0.0f, -1.0f, nan, inf, -inf, 2.0e7f}) {
        SCOPED_TRACE(radius);
        refuse(Circle{{0, 0}, radius});
        refuse(Capsule{{0, 0}, {1, 0}, radius});
    }
    for (const Vec2 bad : not_finite_vectors) {
        refuse(Circle{bad, 1});
        refuse(Capsule{bad, {0, 0}, 1});
        refuse(Capsule{{0, 0}, bad, 1});
        refuse(Segment{bad, {0, 0}});
        refuse(Segment{{0, 0}, bad});
        refuse(ChainSegment{bad, {{0, 0}, {1, 0}}, {2, 0}});
        refuse(ChainSegment{{-1, 0}, {bad, {1, 0}}, {2, 0}});
        refuse(ChainSegment{{-1, 0}, {{0, 0}, bad}, {2, 0}});
        refuse(ChainSegment{{-1, 0}, {{0, 0}, {1, 0}}, bad});
    }
    refuse(Capsule{{1, 1}, {1, 1}, 1});
    refuse(Capsule{{1, 1}, {1.004f, 1}, 1});
    refuse(Segment{{1, 1}, {1, 1}});
    refuse(Segment{{0, 0}, {0, 0.004f}});
    refuse(ChainSegment{{-1, 0}, {{0, 0}, {0, 0}}, {2, 0}});
}

// Corners as they come, with the normals that belong to them.
Polygon by_hand(std::initializer_list<Vec2> corners, float radius = 0) {
    Polygon p;
    p.radius = radius;
    for (const Vec2 v : corners) p.vertices[p.count++] = v;
    for (std::uint32_t i = 0; i < p.count; ++i) {
        p.centroid += (1.0f / static_cast<float>(p.count)) * p.vertices[i];
        p.normals[i] = normalize(right_perp(p.vertices[(i + 1) % p.count] - p.vertices[i]));
    }
    return p;
}

TEST_F(BadNumbers, PolygonsMustBeConvexAndCounterClockwise) {
    const Polygon good = by_hand({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    ASSERT_TRUE(is_valid(good));
    const auto refuse = [&](const char* what, const Polygon& p) {
        SCOPED_TRACE(what);
        EXPECT_FALSE(is_valid(p));
        expect_refused(Error::bad_geometry, [&] { EXPECT_FALSE(w->create_shape(box, p)); });
    };
    refuse("empty", Polygon{});
    refuse("one corner", by_hand({{0, 0}}));
    refuse("two corners", by_hand({{0, 0}, {1, 0}}));
    refuse("clockwise", by_hand({{0, 1}, {1, 1}, {1, 0}, {0, 0}}));
    refuse("concave", by_hand({{0, 0}, {2, 0}, {1, 0.5f}, {2, 2}, {0, 2}}));
    refuse("a bow tie", by_hand({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));
    refuse("a pentagram", by_hand({{0, 1}, {-0.59f, -0.81f}, {0.95f, 0.31f}, {-0.95f, 0.31f}, {0.59f, -0.81f}}));
    refuse("no area", by_hand({{0, 0}, {1, 0}, {2, 0}}));
    refuse("all corners the same", by_hand({{1, 1}, {1, 1}, {1, 1}}));
    refuse("a repeated corner", by_hand({{0, 0}, {1, 0}, {1, 0}, {0, 1}}));
    refuse("too large", by_hand({{0, 0}, {2e7f, 0}, {0, 2e7f}}));
    refuse("negative radius", by_hand({{0, 0}, {1, 0}, {0, 1}}, -0.1f));
    for (const float bad : not_finite) {
        refuse("radius not finite", by_hand({{0, 0}, {1, 0}, {0, 1}}, bad));
        Polygon p = good;
        p.vertices[2].x = bad;
        refuse("corner not finite", p);
        p = good;
        p.normals[1].y = bad;
        refuse("normal not finite", p);
        p = good;
        p.centroid.x = bad;
        refuse("centroid not finite", p);
    }
    Polygon p = good;
    p.normals[0] = {0, -2};
    refuse("a normal not of unit length", p);
    p = good;
    p.normals[0] = {0, 1};
    refuse("a normal that points inwards", p);
    p = good;
    p.count = 9;
    refuse("too many corners", p);
    p.count = 0xffffffffu;
    refuse("far too many corners", p);
}

TEST_F(BadNumbers, BoxesOfNoSizeCannotBeMade) {
    for (const float bad : {0.0f, -1.0f, nan, inf, 2.0e7f}) {
        SCOPED_TRACE(bad);
        for (const Polygon& p : {make_box(bad, 1), make_box(1, bad), make_rounded_box(bad, 1, 0.1f)}) {
            EXPECT_EQ(p.count, 0u);
            expect_refused(Error::bad_geometry, [&] { EXPECT_FALSE(w->create_shape(box, p)); });
        }
    }
}

TEST_F(BadNumbers, ChainsMayEndWhereTheWorldDoes) {
    // An open end goes on straight in thought, so what is beyond it lies beyond the limit of coordinates.
    for (const float sign : {1.0f, -1.0f}) {
        for (const float other : {0.0f, 9.999e6f, -1e7f}) {
            const Vec2 across[] = {{sign * other, 0}, {sign * 1e7f, 0}}, up[] = {{3, sign * 1e7f}, {2, sign * other}, {-1e7f, sign * other}};
            EXPECT_EQ(w->create_chain(ground, across, false), 1u) << other;
            EXPECT_EQ(w->create_chain(ground, up, false), 2u) << other;
        }
    }
    EXPECT_TRUE(w.errors.empty());
    EXPECT_EQ(w->validate(), nullptr);
    const Vec2 beyond[] = {{0, 0}, {1.001e7f, 0}};
    expect_refused(Error::bad_chain, [&] { EXPECT_EQ(w->create_chain(ground, beyond, false), 0u); });
    expect_refused(Error::bad_geometry, [&] { EXPECT_FALSE(w->create_shape(ground, ChainSegment{{-4.1e7f, 0}, {{0, 0}, {1, 0}}, {2, 0}})); });
}

TEST_F(BadNumbers, ChainsNeedEnoughPointsThatAreApart) {
    const Vec2 two[] = {{0, 0}, {1, 0}};
    const Vec2 repeated[] = {{0, 0}, {1, 0}, {1, 0}, {2, 0}};
    const Vec2 closed[] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}};
    std::vector<ShapeId> out(4);
    const auto refuse = [&](Error error, std::span<const Vec2> points, bool loop) {
        expect_refused(error, [&] { EXPECT_EQ(w->create_chain(ground, points, loop, {}, out), 0u); });
        for (const ShapeId id : out) EXPECT_FALSE(id) << "an id was written";
    };
    refuse(Error::bad_chain, {}, false);
    refuse(Error::bad_chain, {}, true);
    refuse(Error::bad_chain, std::span(two, 1), false);
    refuse(Error::bad_chain, two, true);
    refuse(Error::bad_chain, repeated, false);
    refuse(Error::bad_chain, closed, true);
    for (const Vec2 bad : not_finite_vectors) {
        for (int at = 0; at < 3; ++at) {
            Vec2 points[] = {{0, 0}, {1, 0}, {2, 1}};
            points[at] = bad;
            refuse(Error::not_finite, points, false);
            refuse(Error::not_finite, points, true);
        }
    }
}

}  // namespace
