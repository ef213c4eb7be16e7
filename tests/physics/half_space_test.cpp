// Half-spaces: what lies, slides, rolls and lands on one does as on a segment of a kilometre; and who asks where it is gets closed formulas.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "islet/mover.hpp"
#include "islet/snapshot.hpp"
#include "support/random.hpp"
#include "support/test_world.hpp"
#include "workers/thread_pool.hpp"

namespace islet::test {
namespace {

constexpr float step_time = 1.0f / 60;
constexpr float gravity = 10;  // m/s^2

enum class Ground { segment, half_space };

/// How a floor lies: turned by an angle, its frame's origin at a place. Gravity leads into it.
struct Lie {
    float angle = 0;
    Vec2 origin = {};
    Transform frame() const { return {origin, make_rot(angle)}; }
};

/// A world in the floor's frame: what is dropped at (x, y) is y over the surface, at `lie`.
class Scene {
public:
    Scene(Ground ground, const Lie& lie, const ShapeDef& surface = {}, float pull_angle = 0)
        : world({.bodies = 64, .shapes = 64, .contacts = 512, .joints = 4}, {.gravity = rotate(make_rot(lie.angle + pull_angle), {0, -gravity})}),
          frame(lie.frame()) {
        floor = world->create_body({.position = lie.origin, .angle = lie.angle});
        if (ground == Ground::segment) {
            floor_shape = world->create_shape(floor, Segment{{500, 0}, {-500, 0}}, surface);
        } else {
            floor_shape = world->create_shape(floor, HalfSpace{}, surface);
        }
    }

    template <class Geometry>
    BodyId drop(const Geometry& geometry, Vec2 at, float angle = 0, Vec2 velocity = {}, const ShapeDef& def = {.density = 1}) {
        BodyDef body{.type = BodyType::dynamic, .position = transform_point(frame, at)};
        body.angle = angle_of(frame.q * make_rot(angle));
        body.linear_velocity = rotate(frame.q, velocity);
        return world.add(geometry, body, def);
    }
    void run(int steps) {
        for (int i = 0; i < steps; ++i) world->step(step_time);
    }
    /// Of a body's centre, in the floor's frame.
    Vec2 place(BodyId body) const { return inv_transform_point(frame, world->center_of_mass(body)); }
    Vec2 velocity(BodyId body) const { return inv_rotate(frame.q, world->linear_velocity(body)); }
    float angle(BodyId body) const { return angle_of(inv_mul(frame.q, world->transform(body).q)); }
    /// Sum of the impulses between floor and world in the last step, N s.
    double impulse() const {
        double sum = 0;
        std::vector<ContactInfo> contacts(64);
        const std::uint32_t count = world->contacts(floor, contacts);
        for (std::uint32_t i = 0; i < count; ++i)
            for (std::uint32_t k = 0; k < contacts[i].point_count; ++k) sum += double(contacts[i].points[k].normal_impulse);
        return sum;
    }

    TestWorld world;
    Transform frame;
    BodyId floor;
    ShapeId floor_shape;
};

const std::vector<Lie>& lies() {
    static const std::vector<Lie> all = {{},
                                         {0.3f, {}},
                                         {-1.2f, {5, 3}},
                                         {pi / 2, {}},
                                         {pi, {0, -7}},
                                         {2.5f, {1000, -1000}},
                                         {-pi / 2, {-20000, 3}},
                                         {1e-4f, {}},
                                         {0.7853982f, {100000, 0}},
                                         {3.0f, {-3, 4}}};
    return all;
}

/// Ten things that are dropped, and what they are told apart by.
struct Dropped {
    const char* name;
    std::function<BodyId(Scene&)> drop;
};

const std::vector<Dropped>& drops() {
    static const std::vector<Dropped> all = {
        {"box",
         [](Scene& s) {
             return s.drop(make_box(0.5f, 0.5f), {0, 0.6f});
         }},
        {"plank",
         [](Scene& s) {
             return s.drop(make_box(3, 0.05f), {1, 0.3f}, 0.05f);
         }},
        {"ball",
         [](Scene& s) {
             return s.drop(Circle{{}, 0.4f}, {0, 1});
         }},
        {"capsule",
         [](Scene& s) {
             return s.drop(Capsule{{-0.5f, 0}, {0.5f, 0}, 0.2f}, {2, 0.5f}, 0.2f);
         }},
        {"triangle",
         [](Scene& s) {
             const Vec2 corners[] = {{-0.5f, -0.3f}, {0.5f, -0.3f}, {0, 0.6f}};
             return s.drop(make_polygon(compute_hull(corners)), {0, 0.5f});
         }},
        {"rounded box",
         [](Scene& s) {
             return s.drop(make_rounded_box(0.4f, 0.3f, 0.1f), {-3, 0.6f}, 0.1f);
         }},
        {"box on its corner",
         [](Scene& s) {
             return s.drop(make_box(0.5f, 0.5f), {0, 1}, 0.6f);
         }},
        {"stack",
         [](Scene& s) {
             for (int i = 0; i < 4; ++i) s.drop(make_box(0.5f, 0.5f), {0, 0.5f + static_cast<float>(i)});
             return s.drop(make_box(0.5f, 0.5f), {0, 4.5f});
         }},
        {"sliding box",
         [](Scene& s) {
             return s.drop(make_box(0.5f, 0.5f), {0, 0.5f}, 0, {3, 0});
         }},
        {"octagon",
         [](Scene& s) {
             std::vector<Vec2> corners;
             for (int i = 0; i < 8; ++i) corners.push_back(rotate(make_rot(static_cast<float>(i) * 0.25f * pi), {0.5f, 0}));
             return s.drop(make_polygon(compute_hull(corners)), {0, 0.8f}, 0.2f);
         }},
    };
    return all;
}

// What rests may be sunk in by a slop of 5 mm, either way; a body placed far from the origin is as exact as its floats.
float tolerance_of(const Lie& lie) { return 0.004f + 4e-7f * (std::fabs(lie.origin.x) + std::fabs(lie.origin.y)); }

TEST(HalfSpace, TenThingsRestAsOnASegmentHoweverItLies) {
    for (const Dropped& thing : drops()) {
        for (const Lie& lie : lies()) {
            Scene a(Ground::segment, lie), b(Ground::half_space, lie);
            const BodyId on_segment = thing.drop(a), on_plane = thing.drop(b);
            a.run(240), b.run(240);
            const std::string where = std::string(thing.name) + " at " + std::to_string(lie.angle) + ", " + std::to_string(lie.origin.x);
            EXPECT_EQ(b.world->validate(), nullptr) << where;
            EXPECT_NEAR(a.place(on_segment).y, b.place(on_plane).y, tolerance_of(lie)) << where;
            EXPECT_NEAR(a.angle(on_segment), b.angle(on_plane), 0.02f) << where;
            EXPECT_NEAR(length(b.velocity(on_plane)), 0, 0.02f) << where;
            // The floor carries what lies on it: a step's impulse is m g dt of all that was dropped. Substeps report the last one's. Far from the origin it
            // flickers by what the rounding of positions presses: up to 2 mm at 20 km, of which a tenth of the weight is 0.3 mm (soft contacts of 30 Hz).
            const double share = std::fabs(lie.origin.x) + std::fabs(lie.origin.y) > 1000 ? 0.1 : 0.02;
            if (b.impulse() > 0) { EXPECT_NEAR(b.impulse(), a.impulse(), share * a.impulse()) << where; }
        }
    }
}

TEST(HalfSpace, FrictionStopsABoxWhereTheFormulaSays) {
    for (const float speed : {1.0f, 2.0f, 4.0f, 7.0f}) {
        for (const Lie& lie : {Lie{}, Lie{0.8f, {}}, Lie{-2.0f, {300, 200}}}) {
            Scene s(Ground::half_space, lie, {.friction = 0.5f});
            const BodyId box = s.drop(make_box(0.5f, 0.25f), {0, 0.25f}, 0, {speed, 0}, {.friction = 0.5f, .density = 1});
            s.run(180);
            const float way = speed * speed / (2 * 0.5f * gravity);  // v^2 / (2 mu g)
            EXPECT_NEAR(s.place(box).x, way, 0.01f + 0.03f * way) << speed << ' ' << lie.angle;
        }
    }
}

TEST(HalfSpace, ASlopeHoldsABoxBelowTheCriticalAngleAndNotAboveIt) {
    const float critical = std::atan(0.6f);
    for (const float lean : {0.9f, 1.1f}) {
        Scene s(Ground::half_space, {0.4f, {}}, {.friction = 0.6f}, lean * critical);
        const BodyId box = s.drop(make_box(0.5f, 0.25f), {0, 0.25f}, 0, {}, {.friction = 0.6f, .density = 1});
        s.run(120);
        if (lean < 1) {
            EXPECT_NEAR(s.place(box).x, 0, 0.01f);
        } else {
            const float a = gravity * (std::sin(lean * critical) - 0.6f * std::cos(lean * critical));
            EXPECT_NEAR(s.place(box).x, 0.5f * a * 4, 0.05f * 0.5f * a * 4);
        }
    }
}

TEST(HalfSpace, ABallRollsAsOnTheSegmentAndAsTheFormulaSays) {
    for (int start = 0; start < 10; ++start) {
        const float lean = 0.02f * static_cast<float>(start + 1);
        Scene a(Ground::segment, {0.2f, {}}, {.friction = 0.9f}, lean), b(Ground::half_space, {0.2f, {}}, {.friction = 0.9f}, lean);
        const BodyId ball_a = a.drop(Circle{{}, 0.5f}, {0, 0.5f}, 0, {}, {.friction = 0.9f, .density = 1});
        const BodyId ball_b = b.drop(Circle{{}, 0.5f}, {0, 0.5f}, 0, {}, {.friction = 0.9f, .density = 1});
        a.run(120), b.run(120);
        EXPECT_NEAR(a.place(ball_a).x, b.place(ball_b).x, 1e-3f);
        const float a_roll = gravity * std::sin(lean) / 1.5f;  // a disc: 2/3 g sin
        EXPECT_NEAR(b.place(ball_b).x, 0.5f * a_roll * 4, 0.03f * 0.5f * a_roll * 4 + 0.01f) << lean;
    }
}

/// The lowest that a fast body came, m: ball, box, capsule and plank.
std::array<float, 4> lowest_of_fast(Ground ground, float speed, bool straight, std::uint64_t seed) {
    Random random(seed);
    const Lie lie{random.between(-pi, pi), {random.between(-100, 100), random.between(-100, 100)}};
    TestWorld world({.bodies = 8, .shapes = 8, .contacts = 64, .joints = 1}, {.gravity = {0, 0}, .max_speed = 600});
    const BodyId floor = world->create_body({.position = lie.origin, .angle = lie.angle});
    ground == Ground::segment ? world->create_shape(floor, Segment{{500, 0}, {-500, 0}}) : world->create_shape(floor, HalfSpace{});
    const float slant = straight ? 0 : random.between(-0.5f, 0.5f);
    const ShapeProxy shapes[] = {make_proxy(Circle{{}, 0.1f}), make_proxy(make_box(0.1f, 0.1f)), make_proxy(Capsule{{-0.2f, 0}, {0.2f, 0}, 0.05f}),
                                 make_proxy(make_box(0.5f, 0.02f))};
    std::array<BodyId, 4> bodies;
    for (std::size_t i = 0; i < 4; ++i) {
        BodyDef def{.type = BodyType::dynamic, .position = transform_point(lie.frame(), {5 * static_cast<float>(i), 1 + random.between(0, speed / 60)})};
        def.angle = straight ? lie.angle : random.between(-pi, pi);
        def.linear_velocity = rotate(lie.frame().q * make_rot(slant), {0, -speed});
        const Vec2* p = shapes[i].points;
        bodies[i] = i == 0   ? world.add(Circle{p[0], shapes[i].radius}, def)
                    : i == 2 ? world.add(Capsule{p[0], p[1], shapes[i].radius}, def)
                             : world.add(make_polygon(compute_hull({p, 4})), def);
    }
    std::array<float, 4> lowest = {1e9f, 1e9f, 1e9f, 1e9f};
    for (int step = 0; step < 30; ++step) {
        world->step(step_time);
        for (std::size_t i = 0; i < 4; ++i)
            for (std::uint32_t k = 0; k < shapes[i].count; ++k) {
                const Vec2 corner = inv_transform_point(lie.frame(), transform_point(world->transform(bodies[i]), shapes[i].points[k]));
                lowest[i] = min(lowest[i], corner.y - shapes[i].radius);
            }
    }
    return lowest;
}

// What cannot be seen is 5 mm.
TEST(HalfSpace, NothingThatFallsFlatComesBelowItHoweverFast) {
    for (const float speed : {5.0f, 20.0f, 60.0f, 150.0f, 300.0f, 500.0f})
        for (std::uint64_t start = 0; start < 10; ++start)
            for (const float lowest : lowest_of_fast(Ground::half_space, speed, true, start)) EXPECT_GE(lowest, -0.005f) << speed << " m/s, start " << start;
}

// What comes at a slant slaps down with its other end, and one in five or so sinks in deeper than that for a moment: not more often than into a segment, and
// never with its middle.
TEST(HalfSpace, WhatLandsAtASlantSinksInNoDeeperThanIntoASegment) {
    for (const float speed : {5.0f, 20.0f, 60.0f, 150.0f, 300.0f, 500.0f}) {
        int deep[2] = {0, 0};
        for (std::uint64_t start = 0; start < 100; ++start) {
            for (const Ground ground : {Ground::segment, Ground::half_space}) {
                for (const float lowest : lowest_of_fast(ground, speed, false, start)) {
                    deep[ground == Ground::half_space] += lowest < -0.005f ? 1 : 0;
                    EXPECT_GE(lowest, -0.1f) << speed << " m/s, start " << start;
                }
            }
        }
        EXPECT_LE(deep[1], deep[0] + 12) << speed << " m/s";  // of 400
    }
}

TEST(HalfSpace, CastsMeetTheClosedFormulas) {
    Random random(3);
    for (int i = 0; i < 2000; ++i) {
        const Lie lie{random.between(-pi, pi), {random.between(-50, 50), random.between(-50, 50)}};
        const HalfSpace h{rotate(make_rot(random.between(-pi, pi)), {0, 1}), random.between(-5, 5)};
        TestWorld world;
        const BodyId floor = world->create_body({.position = lie.origin, .angle = lie.angle});
        const ShapeId shape = world->create_shape(floor, h);
        const Vec2 n = rotate(lie.frame().q, h.normal);
        const float c = h.offset + dot(n, lie.origin);
        const Vec2 from = {random.between(-80, 80), random.between(-80, 80)}, way = {random.between(-80, 80), random.between(-80, 80)};
        const float radius = i % 2 == 0 ? 0 : random.between(0.1f, 2);
        const float gap = dot(n, from) - c - radius, down = dot(n, way);
        if (std::fabs(gap) < 1e-3f || std::fabs(gap + down) < 1e-3f) continue;
        const QueryHit hit = radius == 0 ? world->cast_ray(from, way) : world->cast_shape(make_proxy(Circle{from, radius}), way);
        const bool hits = gap < 0 || gap + down < 0;
        ASSERT_EQ(bool(hit), hits) << i;
        if (hit) {
            EXPECT_EQ(hit.shape, shape);
            EXPECT_NEAR(hit.fraction * length(way), gap < 0 ? 0 : gap / -down * length(way), 2e-3f / std::fmax(0.05f, std::fabs(down) / length(way))) << i;
            EXPECT_NEAR(hit.normal.x, n.x, 1e-4f);
            EXPECT_NEAR(hit.normal.y, n.y, 1e-4f);
            EXPECT_NEAR(hit.separation, gap < 0 ? gap : 0, 1e-3f);
        }
        const ClosestHit near = world->closest(from, 1000);
        const float height = dot(n, from) - c;
        ASSERT_TRUE(near);
        EXPECT_NEAR(near.distance, height > 0 ? height : 0, 1e-3f) << i;
        EXPECT_NEAR(dot(n, near.point), height > 0 ? c : dot(n, from), 1e-3f) << i;
        ShapeId found[2];
        if (std::fabs(height) > 1e-3f) { EXPECT_EQ(world->overlap_point(from, found), height < 0 ? 1u : 0u); }
        const ShapeProxy box = transform_proxy({from, make_rot(random.between(-3, 3))}, make_proxy(make_box(2, 1)));
        float lowest = 1e9f;
        for (std::uint32_t k = 0; k < box.count; ++k) lowest = min(lowest, dot(n, box.points[k]) - c);
        if (std::fabs(lowest) > 1e-3f) { EXPECT_EQ(world->overlap_shape(box, found), lowest < 0 ? 1u : 0u) << i; }
        EXPECT_EQ(world->validate(), nullptr);
    }
}

TEST(HalfSpace, TheMoverWalksOnIt) {
    for (const float slope : {0.0f, 0.3f, -0.5f}) {
        TestWorld world;
        world->create_shape(world->create_body({.angle = slope}), HalfSpace{});
        MoverState hero{.position = {0, 0.5f}};
        for (int i = 0; i < 120; ++i) {
            world->step(step_time);
            step_mover(*world, {}, hero, {.walk = 3}, step_time);
        }
        EXPECT_TRUE(hero.ground) << slope;
        const Vec2 local = inv_rotate(make_rot(slope), hero.position + Vec2{0, 0.3f});  // the middle of the lower end
        EXPECT_NEAR(local.y, 0.31f, 0.02f) << slope;
        EXPECT_NEAR(local.x, 3 * 2, 0.8f) << slope;
    }
}

TEST(HalfSpace, OnlyWhatIsNotDynamicHasOne) {
    TestWorld world;
    const BodyId dynamic = world->create_body({.type = BodyType::dynamic});
    EXPECT_FALSE(world->create_shape(dynamic, HalfSpace{}));
    EXPECT_EQ(world->last_error(), Error::endless_shape);
    const BodyId body = world->create_body({.type = BodyType::kinematic});
    const ShapeId shape = world->create_shape(body, HalfSpace{{3, 4}, 0});
    EXPECT_FALSE(shape);
    EXPECT_EQ(world->last_error(), Error::bad_geometry);
    const ShapeId good = world->create_shape(body, HalfSpace{{0.6f, 0.8f}, -2});
    ASSERT_TRUE(good);
    EXPECT_EQ(world->shape_type(good), ShapeType::half_space);
    EXPECT_EQ(world->half_space(good)->offset, -2);
    world->set_type(body, BodyType::dynamic);
    EXPECT_EQ(world->last_error(), Error::endless_shape);
    EXPECT_EQ(world->type(body), BodyType::kinematic);
    const BodyId box = world.add_box({0, 5});
    world->set_half_space(world.shape_of(box), {});
    EXPECT_EQ(world->last_error(), Error::endless_shape);
    const BodyId wall = world.add_box({0, -5}, 1, 1, {}, BodyType::static_body);
    world->set_half_space(world.shape_of(wall), {{0, -1}, 0});
    EXPECT_EQ(world->shape_type(world.shape_of(wall)), ShapeType::half_space);
    for (const float bad : {1.1e7f, NAN, INFINITY}) EXPECT_FALSE(is_valid(HalfSpace{{0, 1}, bad}));
    EXPECT_EQ(world->validate(), nullptr);
    world->step(step_time);
    EXPECT_EQ(world->validate(), nullptr);
}

// Far from a tilted half-space its box overlaps everything; contacts are made with what comes near it alone.
TEST(HalfSpace, WhatIsFarTakesNoContact) {
    TestWorld world({.bodies = 64, .shapes = 64, .contacts = 64, .joints = 1});
    world->create_shape(world->create_body({.angle = 0.5f}), HalfSpace{});
    for (int i = 0; i < 20; ++i) world.add_circle({static_cast<float>(3 * i), 200});
    world->step(step_time);
    EXPECT_EQ(world->report().contacts, 0u);
    EXPECT_EQ(world->report().dropped_contacts, 0u);
}

TEST(HalfSpace, AKinematicOneCarriesWhatLiesOnItAndMeetsWhatSleeps) {
    for (const float angle : {0.0f, 0.3f}) {
        TestWorld world;
        const Rot q = make_rot(angle);
        const BodyId lift = world->create_body({.type = BodyType::kinematic, .angle = angle});
        world->create_shape(lift, HalfSpace{}, {.friction = 1});
        const BodyId box =
            world.add(make_box(0.5f, 0.5f), BodyDef{.type = BodyType::dynamic, .position = rotate(q, {0, 0.5f}), .angle = angle}, {.friction = 1});
        for (int i = 0; i < 30; ++i) world->step(step_time);
        world->set_linear_velocity(lift, rotate(q, {0, 2}));
        for (int i = 0; i < 60; ++i) world->step(step_time);
        EXPECT_NEAR(inv_rotate(q, world->center_of_mass(box)).y, 2.5f, 0.03f);
        EXPECT_EQ(world->validate(), nullptr);
    }
    // A ceiling comes down on a sleeping box and presses it awake.
    TestWorld world;
    world.add_ground();
    const BodyId box = world.add_box({0, 0.5f});
    const BodyId ceiling = world->create_body({.type = BodyType::kinematic, .position = {0, 3}, .angle = pi + 0.1f});
    world->create_shape(ceiling, HalfSpace{});
    for (int i = 0; i < 300; ++i) world->step(step_time);
    EXPECT_FALSE(world->is_awake(box));
    world->set_linear_velocity(ceiling, {0, -1});
    for (int i = 0; i < 120; ++i) world->step(step_time);
    EXPECT_TRUE(world->is_awake(box));
}

TEST(HalfSpace, SensorsSeeItAndAreItsOwn) {
    TestWorld world;
    const BodyId body = world->create_body({.type = BodyType::kinematic, .angle = 0.2f});
    const ShapeId water = world->create_shape(body, HalfSpace{}, {.sensor = true});
    const BodyId ball = world.add_circle({0, 3});
    int begins = 0, seen_at = 0;
    for (int i = 0; i < 120; ++i) {
        world->step(step_time);
        for (const SensorEvent& e : world->sensor_begin_events()) {
            ++begins;
            seen_at = i;
            EXPECT_EQ(e.sensor, water);
        }
    }
    EXPECT_EQ(begins, 1);
    const float fall = 3 * std::cos(0.2f) - 0.5f, seconds = std::sqrt(2 * fall / std::cos(0.2f) / gravity);
    EXPECT_NEAR(static_cast<float>(seen_at) / 60, seconds, 0.05f);
    EXPECT_LT(world->position(ball).y, -5);
}

TEST(HalfSpace, AOneWayFloorLetsWhatComesFromBelowPassAndHoldsIt) {
    for (const float angle : {0.0f, 0.4f}) {
        const Rot q = make_rot(angle);
        TestWorld world(roomy, {.gravity = rotate(q, {0, -gravity})});
        world->create_shape(world->create_body({.angle = angle}), HalfSpace{}, {.one_way = {0, 1}});
        const BodyId up = world.add(make_box(0.3f, 0.3f),
                                    BodyDef{.type = BodyType::dynamic, .position = rotate(q, {0, -2}), .angle = angle, .linear_velocity = rotate(q, {0, 9})});
        float highest = -9;
        for (int i = 0; i < 240; ++i) {
            world->step(step_time);
            highest = max(highest, inv_rotate(q, world->position(up)).y);
        }
        EXPECT_GT(highest, 1.5f);
        EXPECT_NEAR(inv_rotate(q, world->position(up)).y, 0.3f, 0.01f) << angle;
    }
}

TEST(HalfSpace, AConveyorCarriesAndABouncyOneThrowsBack) {
    Scene s(Ground::half_space, {0.5f, {}}, {.friction = 1, .tangent_speed = 2});
    Scene t(Ground::segment, {0.5f, {}}, {.friction = 1, .tangent_speed = 2});
    const BodyId a = s.drop(make_box(0.5f, 0.5f), {0, 0.5f}, 0, {}, {.friction = 1, .density = 1}),
                 b = t.drop(make_box(0.5f, 0.5f), {0, 0.5f}, 0, {}, {.friction = 1, .density = 1});
    s.run(120), t.run(120);
    EXPECT_NEAR(std::fabs(s.velocity(a).x), 2, 0.02f);
    EXPECT_NEAR(std::fabs(t.velocity(b).x), 2, 0.02f);
    Scene u(Ground::half_space, {-0.7f, {}}, {.restitution = 0.8f});
    const BodyId ball = u.drop(Circle{{}, 0.3f}, {0, 2.3f}, 0, {}, {.restitution = 0.8f, .density = 1});
    float highest = 0;
    bool down = false;
    for (int i = 0; i < 120; ++i) {
        u.run(1);
        if (u.velocity(ball).y > 0.5f) down = true;
        if (down) highest = max(highest, u.place(ball).y - 0.3f);
    }
    EXPECT_NEAR(highest, 0.64f * 2, 0.1f);  // e^2 h
}

// A pile on two half-spaces that make a valley, in 1, 4 and 8 lanes, with 1, 4 and 8 workers, saved and loaded half-way, recorded and replayed.
TEST(HalfSpace, TheBitsAreTheSame) {
    const auto fill = [](TestWorld& w) {
        const BodyId floor = w->create_body({});
        w->create_shape(floor, HalfSpace{rotate(make_rot(0.3f), {0, 1}), 0});
        w->create_shape(floor, HalfSpace{rotate(make_rot(-0.4f), {0, 1}), 0});
        for (int i = 0; i < 40; ++i) {
            const Vec2 at = {static_cast<float>(i % 5) - 2, 3 + 1.2f * static_cast<float>(i / 5)};
            if (i % 3 == 0) w.add_circle(at, 0.4f);
            if (i % 3 == 1) w.add_box(at, 0.4f, 0.3f);
            if (i % 3 == 2) w.add_capsule(at, 0.3f, 0.2f);
        }
    };
    std::vector<std::uint64_t> hashes;
    for (const std::uint32_t lanes : {1u, 4u, 8u, 16u}) {
        for (const std::uint32_t workers : {1u, 4u, 8u, 16u}) {
            samples::ThreadPool pool(workers);
            TestWorld world(roomy, {.lanes = lanes, .tasks = pool.tasks()});
            fill(world);
            for (int i = 0; i < 60; ++i) world->step(step_time);
            std::vector<std::uint64_t> image((world->snapshot_bytes() + 7) / 8);
            const std::span<std::byte> bytes{reinterpret_cast<std::byte*>(image.data()), world->snapshot_bytes()};
            ASSERT_GT(world->save(bytes), 0u);
            TestWorld other(roomy, {.lanes = lanes});
            ASSERT_TRUE(other->load(bytes)) << describe(other->last_error());
            for (int i = 0; i < 120; ++i) world->step(step_time), other->step(step_time);
            EXPECT_EQ(other->hash(), world->hash());
            EXPECT_EQ(world->validate(), nullptr);
            EXPECT_TRUE(world.is_finite());
            hashes.push_back(world->hash());
        }
    }
    for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, hashes[0]);
}

TEST(HalfSpace, ItsBoxEndsAtItsSurfaceAndAtABound) {
    TestWorld world({.bodies = 2, .shapes = 2, .contacts = 4, .joints = 1});
    const BodyId body = world->create_body({.type = BodyType::kinematic});
    world->create_shape(body, HalfSpace{});
    EXPECT_EQ(world->validate(), nullptr);
    EXPECT_LE(world->aabb(world.shape_of(body)).upper.y, 0.01f);
    EXPECT_EQ(world->aabb(world.shape_of(body)).lower.x, -8e7f);
}

TEST(HalfSpace, IsDrawnAsALineWithHatchesInTheView) {
    TestWorld world;
    world->create_shape(world->create_body({.angle = 0.3f}), HalfSpace{});
    struct Lines {
        int count = 0;
        float longest = 0, farthest = 0;
    } lines;
    DebugDraw draw;
    draw.view = {{-10, -10}, {10, 10}};
    draw.context = &lines;
    draw.segment = [](Vec2 a, Vec2 b, const DrawStyle&, void* context) {
        Lines& l = *static_cast<Lines*>(context);
        ++l.count;
        l.longest = max(l.longest, distance(a, b));
        l.farthest = max(l.farthest, max(length(a), length(b)));
    };
    world->draw(draw);
    EXPECT_GT(lines.count, 10);
    EXPECT_LT(lines.count, 100);
    EXPECT_GE(lines.longest, 20.0f * 1.4142f);
    EXPECT_LT(lines.farthest, 200);
}

}  // namespace
}  // namespace islet::test
