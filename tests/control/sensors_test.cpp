// Sensors: what they see, when they tell of it, and that they push nobody. Overlaps are compared with an oracle in double precision that looks at every
// pair of shapes.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "support/effort.hpp"
#include "support/image.hpp"
#include "support/random.hpp"
#include "support/test_world.hpp"
#include "unit/exact_geometry.hpp"

namespace islet::test {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;  // slots + 1 of sensor and visitor

Pair pair_of(const SensorEvent& e) { return {e.sensor.index1, e.visitor.index1}; }

// -- one at a time -----------------------------------------------------------------------------------------------------------------------

TEST(Sensors, ABallThatFallsThroughASensorIsSeenToComeAndToGoAndIsNotHeldUp) {
    TestWorld with, without;
    const ShapeId gate = with.shape_of(with.add_box({0, -5}, 2, 1, {.sensor = true}, BodyType::static_body));
    const BodyId ball = with.add_circle({0, 0}), free = without.add_circle({0, 0});
    int begun = 0, ended = 0;
    for (int i = 0; i < 120; ++i) {
        const float y = with->position(ball).y;  // events are of the poses that the step begins with
        const bool inside = y - 0.5f <= -4 && y + 0.5f >= -6;
        with.step();
        without.step();
        for (const SensorEvent& e : with->sensor_begin_events()) {
            EXPECT_EQ(e.sensor, gate);
            EXPECT_EQ(e.visitor, with.shape_of(ball));
            EXPECT_TRUE(inside);
            ++begun;
        }
        for (const SensorEvent& e : with->sensor_end_events()) {
            EXPECT_EQ(e.sensor, gate);
            EXPECT_FALSE(inside);
            ++ended;
        }
        EXPECT_EQ(with->sensor_overlaps(gate, {}), inside ? 1u : 0u) << "step " << i;
        EXPECT_TRUE(with->begin_touch_events().empty());
        EXPECT_EQ(with->position(ball), without->position(free)) << "a sensor pushes nobody";
    }
    EXPECT_EQ(begun, 1);
    EXPECT_EQ(ended, 1);
}

// Every type of body with a sensor against every type with a shape.
TEST(Sensors, OfAnyBodySeesShapesOfAnyBodyButTwoStaticOnes) {
    for (const BodyType of_sensor : {BodyType::static_body, BodyType::kinematic, BodyType::dynamic}) {
        for (const BodyType of_visitor : {BodyType::static_body, BodyType::kinematic, BodyType::dynamic}) {
            TestWorld w(roomy, {.gravity = {0, 0}});
            const ShapeId sensor = w.shape_of(w.add_box({0, 0}, 1, 1, {.sensor = true}, of_sensor));
            const ShapeId visitor = w.shape_of(w.add_circle({0.5f, 0}, 0.5f, {}, of_visitor));
            w.step(2);
            const bool sees = of_sensor != BodyType::static_body || of_visitor != BodyType::static_body;
            ShapeId seen;
            EXPECT_EQ(w->sensor_overlaps(sensor, {&seen, 1}), sees ? 1u : 0u) << int(of_sensor) << " against " << int(of_visitor);
            if (sees) { EXPECT_EQ(seen, visitor); }
            EXPECT_TRUE(w.contacts().empty());
            EXPECT_EQ(w->validate(), nullptr);
        }
    }
}

TEST(Sensors, SeeNeitherEachOtherNorTheirOwnBody) {
    TestWorld w(roomy, {.gravity = {0, 0}});
    const BodyId body = w.add_box({0, 0}, 1, 1, {.sensor = true});
    w->create_shape(body, Circle{{0, 0}, 1}, {});
    const BodyId other = w.add_box({0.5f, 0}, 1, 1, {.sensor = true});
    w.step(2);
    const ShapeId second = w.shape_of(other);
    EXPECT_EQ(w->sensor_overlaps(second, {}), 1u) << "the other body's solid shape alone";
    std::vector<ShapeId> shapes(2);
    w->shapes(body, shapes);
    EXPECT_EQ(w->sensor_overlaps(shapes[1], {}), 0u);
}

TEST(Sensors, SeeWhatTheirFilterAllowsAndWhatConsents) {
    TestWorld w(roomy, {.gravity = {0, 0}});
    const ShapeId sensor = w.shape_of(w.add_box({0, 0}, 5, 5, {.filter = {.category = 2, .mask = 5}, .sensor = true}, BodyType::static_body));
    const auto ball = [&](float x, const ShapeDef& def) { return w.shape_of(w.add_circle({x, 0}, 0.25f, def)); };
    const ShapeId seen = ball(-2, {.filter = {.category = 4}});
    ball(-1, {.filter = {.category = 8}});
    ball(0, {.filter = {.category = 1, .mask = 1}});
    const ShapeId shy = ball(1, {.sensor_events = false});
    w.step();
    std::vector<ShapeId> all(4);
    ASSERT_EQ(w->sensor_overlaps(sensor, all), 1u);
    EXPECT_EQ(all[0], seen);
    w->enable_sensor_events(shy, true);
    w.step();
    ASSERT_EQ(w->sensor_begin_events().size(), 1u);
    EXPECT_EQ(w->sensor_begin_events()[0].visitor, shy);
    w->enable_sensor_events(shy, false);
    w->set_filter(seen, {.category = 8});
    EXPECT_EQ(w->sensor_end_events().size(), 2u) << "at once, and again after the next step";
    w.step();
    ASSERT_EQ(w->sensor_end_events().size(), 2u);
    EXPECT_EQ(w->sensor_end_events()[0].visitor, shy) << "in the order of the calls";
    EXPECT_EQ(w->sensor_end_events()[1].visitor, seen);
    w.step();
    EXPECT_TRUE(w->sensor_end_events().empty());
}

TEST(Sensors, SegmentsAndChainsAreSeenFromBothSides) {
    TestWorld w(roomy, {.gravity = {0, 0}});
    const BodyId body = w->create_body({});
    const Vec2 points[] = {{2, 0}, {0, 0}, {-2, 0}};
    w->create_chain(body, points, false);
    w->create_shape(body, Segment{{-2, 3}, {2, 3}});
    const ShapeId probe = w.shape_of(w.add_box({1, -0.3f}, 0.5f, 0.5f, {.sensor = true}, BodyType::kinematic));
    w.step();
    EXPECT_EQ(w->sensor_overlaps(probe, {}), 1u);
    w->set_transform(w->body(probe), {0, 3.2f}, 0.3f);
    w.step();
    EXPECT_EQ(w->sensor_overlaps(probe, {}), 1u);
    const BodyId thin = w->create_body({.type = BodyType::kinematic, .position = {0, 3}, .angle = 0.5f});
    const ShapeId line = w->create_shape(thin, Segment{{-1, 0}, {1, 0}}, {.sensor = true});
    w.step();
    EXPECT_EQ(w->sensor_overlaps(line, {}), 1u) << "a segment that crosses a segment";
}

TEST(Sensors, HaveMassByTheirDensity) {
    TestWorld w;
    const BodyId solid = w.add_box({0, 0}, 1, 2, {.density = 3}), sensor = w.add_box({10, 0}, 1, 2, {.density = 3, .sensor = true});
    EXPECT_EQ(w->mass(sensor), w->mass(solid));
    EXPECT_EQ(w->mass(sensor), 24);
}

// Between two pieces of floor the side of one is no contact, because the other covers it; but not for a body that only its sensor tells of the other.
TEST(Sensors, WhatTheySeeCoversNoSideOfTheFloor) {
    for (const bool sensing : {false, true}) {
        TestWorld w(roomy, {.gravity = {0, 0}});
        w.add_box({-2, -1}, 2, 1, {}, BodyType::static_body);
        w.add_box({2, -1}, 2, 1, {.filter = {.category = 2}}, BodyType::static_body);
        const BodyId ball = w.add_circle({1, -0.2f}, 0.5f, {.filter = {.mask = 1}});
        if (sensing) w->create_shape(ball, Circle{{0, 0}, 1}, {.density = 0, .sensor = true});
        w->set_linear_velocity(ball, {-3, 0});
        w.step(60);
        EXPECT_GT(w->position(ball).x, 0.45f) << (sensing ? "with" : "without") << " a sensor";
    }
}

// A body counts as fast by what of it is solid: a small sensor on it does not make it one, which would have it looked at in every step.
TEST(Sensors, ThinOnesDoNotMakeABodyFast) {
    TestWorld with, without;
    with.add_ground();
    without.add_ground();
    const BodyId a = with.add_box({0, 3}), b = without.add_box({0, 3});
    with->create_shape(a, Circle{{0, 0}, 0.01f}, {.density = 0, .sensor = true});
    for (int i = 0; i < 120; ++i) {
        with.step();
        without.step();
        ASSERT_EQ(with->position(a), without->position(b)) << "and nothing else changes either";
    }
    EXPECT_EQ(with->validate(), nullptr);
}

// -- sleep -------------------------------------------------------------------------------------------------------------------------------

TEST(Sensors, SleepersStayInTheirOverlapsAndAreFoundAsleep) {
    TestWorld w;
    w.add_ground();
    const ShapeId fixed = w.shape_of(w.add_box({0, 0}, 1, 2, {.sensor = true}, BodyType::static_body));
    const BodyId crate = w.add_box({0, 0.5f});
    w.step(120);
    ASSERT_FALSE(w->is_awake(crate)) << "a sensor keeps nobody awake";
    EXPECT_EQ(w->sensor_overlaps(fixed, {}), 1u);
    const BodyId scanner = w.add_box({-6, 0.8f}, 0.5f, 0.5f, {.sensor = true}, BodyType::kinematic);
    w->set_linear_velocity(scanner, {3, 0});
    std::size_t begun = 0, ended = 0;
    for (int i = 0; i < 240; ++i) {
        w.step();
        for (const SensorEvent& e : w->sensor_begin_events()) begun += e.sensor == w.shape_of(scanner) && e.visitor == w.shape_of(crate);
        for (const SensorEvent& e : w->sensor_end_events()) ended += e.sensor == w.shape_of(scanner);
        ASSERT_FALSE(w->is_awake(crate)) << "a sensor wakes nobody";
        ASSERT_EQ(w->validate(), nullptr);
    }
    EXPECT_EQ(begun, 1u);
    EXPECT_EQ(ended, 1u);
}

// A static sensor comes to a sleeper, in each way that a call can bring it there, and leaves it: the next step finds both, and wakes nobody.
TEST(Sensors, FindSleepersThatCallsBringThemTo) {
    for (int way = 0; way < 6; ++way) {
        TestWorld w;
        w.add_ground();
        const BodyId sleeper = w.add_box({0, 0.5f}, 0.5f, 0.5f, {.sensor_events = way != 5});
        const BodyId beam = w->create_body({.position = {way == 0 ? 10.0f : 0.0f, 0.5f}, .enabled = way != 1});
        const ShapeDef seeing = {.filter = {.mask = way == 2 ? 0u : ~0u}, .sensor = true};
        ShapeId sensor;
        if (way != 4) sensor = w->create_shape(beam, Circle{{way == 3 ? 2.0f : 0.0f, 0}, 0.3f}, seeing);
        for (int i = 0; i < 300 && w->is_awake(sleeper); ++i) w.step();
        ASSERT_FALSE(w->is_awake(sleeper)) << way;
        if (way == 0) w->set_transform(beam, {0, 0.5f}, 0);
        if (way == 1) w->set_enabled(beam, true);
        if (way == 2) w->set_filter(sensor, {});
        if (way == 3) w->set_circle(sensor, Circle{{2, 0}, 1.8f});
        if (way == 4) sensor = w->create_shape(beam, Circle{{}, 0.3f}, seeing);
        if (way == 5) w->enable_sensor_events(w.shape_of(sleeper), true);
        std::size_t begun = 0, ended = 0;
        const auto step = [&] {
            w.step();
            begun += w->sensor_begin_events().size();
            ended += w->sensor_end_events().size();
        };
        for (int i = 0; i < 3; ++i) step();
        EXPECT_EQ(begun, 1u) << way;
        EXPECT_EQ(w->sensor_overlaps(sensor, {}), 1u) << way;
        w->set_transform(beam, {10, 0.5f}, 0);
        step();
        EXPECT_EQ(ended, 1u) << way;
        EXPECT_EQ(w->sensor_overlaps(sensor, {}), 0u) << way;
        EXPECT_FALSE(w->is_awake(sleeper)) << way;
    }
}

TEST(Sensors, WhatHasLeftThemWhenItIsPutToSleepIsOutside) {
    TestWorld w(roomy, {.gravity = {0, 0}});
    const ShapeId gate = w.shape_of(w.add_box({0, 0}, 1, 1, {.sensor = true}, BodyType::static_body));
    const BodyId ball = w.add_circle({0, 0}, 0.25f);
    w.step();
    EXPECT_EQ(w->sensor_overlaps(gate, {}), 1u);
    w->set_linear_velocity(ball, {120, 0});
    w.step();
    EXPECT_GT(w->position(ball).x, 1.5f);
    w->sleep(ball);
    w.step();
    EXPECT_EQ(w->sensor_overlaps(gate, {}), 0u);
}

TEST(Sensors, TheirOwnBodyFallsAsleepInsideThem) {
    TestWorld w;
    w.add_ground();
    const BodyId a = w.add_box({0, 0.5f}), b = w.add_box({1.5f, 0.5f});
    const ShapeId ring = w->create_shape(a, Circle{{0, 0}, 3}, {.density = 0, .sensor = true});
    w.step(120);
    EXPECT_FALSE(w->is_awake(a));
    EXPECT_FALSE(w->is_awake(b));
    w->set_linear_velocity(b, {1, 0});
    w.step(30);
    EXPECT_FALSE(w->is_awake(a)) << "overlapping links no islands";
    EXPECT_EQ(w->sensor_overlaps(ring, {}), 2u);
    EXPECT_EQ(w->validate(), nullptr);
}

// -- events of calls ---------------------------------------------------------------------------------------------------------------------

TEST(Sensors, WhatIsDestroyedDisabledOrMovedAwayEndsItsOverlapsAtOnce) {
    for (const int how : {0, 1, 2, 3, 4}) {
        TestWorld w(roomy, {.gravity = {0, 0}});
        const BodyId area = w.add_box({0, 0}, 2, 2, {.sensor = true}, BodyType::static_body);
        const ShapeId sensor = w.shape_of(area);
        const BodyId ball = w.add_circle({0, 0});
        const ShapeId visitor = w.shape_of(ball);
        w.step();
        ASSERT_EQ(w->sensor_begin_events().size(), 1u);
        switch (how) {
        case 0: w->destroy_body(ball); break;
        case 1: w->destroy_shape(sensor); break;
        case 2: w->set_enabled(ball, false); break;
        case 3: w->set_enabled(area, false); break;
        default: w->set_transform(ball, {9, 0}, 0); break;
        }
        ASSERT_EQ(w->sensor_end_events().size(), 1u) << how;
        EXPECT_EQ(w->sensor_end_events()[0].sensor, sensor);
        EXPECT_EQ(w->sensor_end_events()[0].visitor, visitor);
        w.step();
        EXPECT_EQ(w->sensor_end_events().size(), 1u) << "it stays for who reads events only after steps";
        w.step();
        EXPECT_TRUE(w->sensor_end_events().empty());
        EXPECT_TRUE(w->end_touch_events().empty());
        EXPECT_EQ(w->validate(), nullptr);
    }
}

// Touches and overlaps share the memory of their events.
TEST(Sensors, TouchesAndOverlapsThatEndTogetherAreAllToldInTheirOrder) {
    constexpr std::uint32_t count = 40;
    TestWorld w(Capacity{.bodies = 100, .shapes = 100, .contacts = 2 * count + 1}, {.gravity = {0, -10}});
    w.add_ground();
    w.add_box({0, 1}, 99, 3, {.sensor = true}, BodyType::static_body);
    std::vector<BodyId> boxes;
    for (std::uint32_t i = 0; i < count; ++i) boxes.push_back(w.add_box({-60 + 3.0f * static_cast<float>(i), 0.5f}));
    w.step(2);
    Random random(5);
    for (std::size_t i = count; i > 1; --i) std::swap(boxes[i - 1], boxes[random.below(static_cast<std::uint32_t>(i))]);
    std::vector<ShapeId> order;
    for (const BodyId box : boxes) {
        order.push_back(w.shape_of(box));
        w->destroy_body(box);
    }
    for (const int round : {0, 1}) {
        ASSERT_EQ(w->sensor_end_events().size(), count);
        ASSERT_EQ(w->end_touch_events().size(), count);
        for (std::uint32_t i = 0; i < count; ++i) {
            EXPECT_EQ(w->sensor_end_events()[i].visitor, order[i]);
            const TouchEvent& e = w->end_touch_events()[i];
            EXPECT_TRUE(e.shape_a == order[i] || e.shape_b == order[i]);
        }
        if (round == 0) w.step();
    }
    EXPECT_EQ(w->report().dropped_events, 0u);
}

TEST(Sensors, EndsThatFindNoRoomAreCountedAndLoseNothingElse) {
    TestWorld w(Capacity{.bodies = 8, .shapes = 8, .contacts = 3}, {.gravity = {0, 0}});
    const ShapeId sensor = w.shape_of(w.add_box({0, 0}, 9, 3, {.sensor = true}, BodyType::static_body));
    std::vector<BodyId> balls;
    const auto renew = [&] {
        for (const BodyId ball : balls) w->destroy_body(ball);
        balls.clear();
        for (int i = 0; i < 3; ++i) balls.push_back(w.add_circle({3.0f * static_cast<float>(i), 0}));
    };
    renew();
    w.step();
    renew();  // three ends wait
    w.step();
    EXPECT_EQ(w->sensor_end_events().size(), 3u);
    EXPECT_EQ(w->sensor_begin_events().size(), 3u);
    EXPECT_EQ(w->report().dropped_events, 0u);
    renew();  // there is room for three: those of the last step give way
    EXPECT_EQ(w->sensor_end_events().size(), 3u);
    EXPECT_EQ(w->report().dropped_events, 0u);
    EXPECT_TRUE(w.errors.empty());
    w.step();
    EXPECT_EQ(w->sensor_end_events().size(), 3u);
    EXPECT_EQ(w->sensor_overlaps(sensor, {}), 3u);
    EXPECT_EQ(w->sensor_begin_events().size(), 3u);
    EXPECT_EQ(w->validate(), nullptr);
}

// -- the oracle --------------------------------------------------------------------------------------------------------------------------

struct Probe {
    ShapeId id;
    bool sensor, consents;
    float radius;
    std::vector<Vec2> points;
};

/// Points and radius of any shape.
void read_geometry(const World& w, Probe& p) {
    p.radius = 0;
    p.points.clear();
    if (const Circle* c = w.circle(p.id)) { p.points = {c->center}, p.radius = c->radius; }
    if (const Capsule* c = w.capsule(p.id)) { p.points = {c->point1, c->point2}, p.radius = c->radius; }
    if (const Segment* s = w.segment(p.id)) { p.points = {s->point1, s->point2}; }
    if (const ChainSegment* s = w.chain_segment(p.id)) { p.points = {s->segment.point1, s->segment.point2}; }
    if (const Polygon* g = w.polygon(p.id)) { p.points.assign(g->vertices, g->vertices + g->count), p.radius = g->radius; }
}

/// A world of everything, in which sensors of all kinds meet shapes of all kinds, some of them asleep.
class Crowd {
public:
    explicit Crowd(std::uint64_t seed, WorldDef def = {}) : w(roomy, def), random(seed) {
        w.add_ground(-6, 14);
        const BodyId pen = w->create_body({});
        const Vec2 walls[] = {{-9, 12}, {-9, -6}, {-8, -6}};
        w->create_chain(pen, walls, false);
        w->create_shape(pen, Segment{{9, -6}, {9, 12}});
        for (int i = 0; i < 70; ++i) add();
    }

    void add() {
        BodyDef def;
        const std::uint32_t kind = random.below(8);
        def.type = kind == 0 ? BodyType::static_body : kind == 1 ? BodyType::kinematic : BodyType::dynamic;
        def.position = {random.between(-8, 8), random.between(-5, 8)};
        def.angle = random.between(-3, 3);
        if (kind == 1) {
            def.linear_velocity = {random.between(-2, 2), random.between(-1, 1)};
            def.angular_velocity = random.between(-2, 2);
        }
        const BodyId body = w->create_body(def);
        if (!body) return;
        bodies.push_back(body);
        for (std::uint32_t n = 1 + random.below(2); n > 0; --n) add_shape(body);
    }

    void add_shape(BodyId body) {
        ShapeDef def;
        def.sensor = random.one_in(3);
        def.sensor_events = !random.one_in(5);
        if (random.one_in(4)) def.filter = {.category = 1u + random.below(3), .mask = random.below(4)};
        if (random.one_in(10)) def.filter.group = -1;
        const float size = def.sensor ? random.between(0.2f, 2) : random.between(0.1f, 0.6f);
        const Vec2 at = {random.between(-0.5f, 0.5f), random.between(-0.5f, 0.5f)};
        switch (random.below(5)) {
        case 0: w->create_shape(body, Circle{at, size}, def); break;
        case 1: w->create_shape(body, Capsule{at, at + Vec2{size, 0.3f * size}, 0.4f * size}, def); break;
        case 2: w->create_shape(body, make_offset_box(size, 0.6f * size, {at, make_rot(at.x)}), def); break;
        case 3: w->create_shape(body, make_rounded_box(0.5f * size, 0.3f * size, 0.2f * size), def); break;
        default: {
            const Vec2 corners[] = {at, at + Vec2{size, 0}, at + Vec2{0, size}};
            w->create_shape(body, make_polygon(compute_hull(corners)), def);
        }
        }
    }

    /// What happens between two steps.
    void meddle(int step) {
        if (step % 7 == 0 && !bodies.empty()) {
            const std::size_t i = random.below(static_cast<std::uint32_t>(bodies.size()));
            w->destroy_body(bodies[i]);
            bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(i));
            add();
        }
        if (step % 11 == 0) w->set_transform(any(), {random.between(-8, 8), random.between(-5, 8)}, random.between(-3, 3));
        if (step % 13 == 0) w->set_enabled(any(), random.one_in(2));
        if (step % 17 == 0) w->set_filter(w.shape_of(any()), {.mask = random.below(4)});
        if (step % 19 == 0) w->set_linear_velocity(any(), {random.between(-9, 9), random.between(0, 9)});
        if (step % 23 == 0) w->set_type(any(), static_cast<BodyType>(random.below(3)));
        if (step % 29 == 0) w->set_circle(w.shape_of(any()), Circle{{0, 0}, random.between(0.1f, 1)});
        if (step % 31 == 0) w->enable_sensor_events(w.shape_of(any()), random.one_in(2));
    }
    BodyId any() { return bodies[random.below(static_cast<std::uint32_t>(bodies.size()))]; }

    TestWorld w;
    Random random;
    std::vector<BodyId> bodies;
};

bool agree(const Filter& a, const Filter& b) {
    if (a.group == b.group && a.group != 0) return a.group > 0;
    return (a.mask & b.category) != 0 && (b.mask & a.category) != 0;
}

/// Pairs of sensor and visitor that overlap now, and in `close` those that are too near to say in single precision.
std::set<Pair> brute_force(const World& w, std::set<Pair>& close) {
    std::vector<Probe> shapes;
    for (std::uint32_t slot = 0; slot < w.capacity().bodies; ++slot) {
        const BodyId body = w.body_at(slot);
        if (!body || !w.is_enabled(body)) continue;
        std::vector<ShapeId> ids(w.shapes(body, {}));
        w.shapes(body, ids);
        for (const ShapeId id : ids) {
            Probe p{id, w.is_sensor(id), w.sensor_events_enabled(id), 0, {}};
            read_geometry(w, p);
            shapes.push_back(p);
        }
    }
    std::set<Pair> found;
    for (const Probe& sensor : shapes) {
        if (!sensor.sensor) continue;
        const BodyId of_sensor = w.body(sensor.id);
        const auto core = exact::core_of(sensor.points.data(), static_cast<std::uint32_t>(sensor.points.size()), w.transform(of_sensor));
        for (const Probe& visitor : shapes) {
            const BodyId of_visitor = w.body(visitor.id);
            if (visitor.sensor || !visitor.consents || of_visitor == of_sensor || !agree(w.filter(sensor.id), w.filter(visitor.id))) continue;
            if (w.type(of_sensor) == BodyType::static_body && w.type(of_visitor) == BodyType::static_body) continue;
            const auto other = exact::core_of(visitor.points.data(), static_cast<std::uint32_t>(visitor.points.size()), w.transform(of_visitor));
            const double gap = exact::distance(core, other) - double(sensor.radius) - double(visitor.radius);
            const Pair pair{sensor.id.index1, visitor.id.index1};
            const bool deep = gap == 0 && exact::best_face_gap(core, other) < -1e-5 && exact::best_face_gap(other, core) < -1e-5;
            if (std::abs(gap) < 1e-5 && !deep) close.insert(pair);
            if (gap <= 0) found.insert(pair);
        }
    }
    return found;
}

std::set<Pair> seen_by_sensors(const World& w) {
    std::set<Pair> all;
    for (std::uint32_t slot = 0; slot < w.capacity().bodies; ++slot) {
        const BodyId body = w.body_at(slot);
        if (!body) continue;
        std::vector<ShapeId> ids(w.shapes(body, {}));
        w.shapes(body, ids);
        for (const ShapeId id : ids) {
            if (!w.is_sensor(id)) continue;
            std::vector<ShapeId> visitors(w.sensor_overlaps(id, {}));
            w.sensor_overlaps(id, visitors);
            for (const ShapeId v : visitors) EXPECT_TRUE(all.insert({id.index1, v.index1}).second) << "seen twice";
        }
    }
    return all;
}

TEST(Sensors, SeeWhatBruteForceSeesInEveryStepOfRandomWorlds) {
    std::size_t pairs = 0, close_pairs = 0, asleep = 0;
    for (std::uint64_t seed = 1; seed <= (test::slow_build ? 2u : 12u); ++seed) {
        Crowd crowd(seed);
        World& w = *crowd.w;
        for (int step = 1; step <= 150; ++step) {
            crowd.meddle(step);
            std::set<Pair> close;
            const std::set<Pair> expected = brute_force(w, close);
            crowd.w.step();
            ASSERT_EQ(w.report().dropped_contacts, 0u);
            const std::set<Pair> seen = seen_by_sensors(w);
            std::vector<Pair> differ;
            std::set_symmetric_difference(expected.begin(), expected.end(), seen.begin(), seen.end(), std::back_inserter(differ));
            for (const Pair& p : differ)
                ASSERT_TRUE(close.count(p) != 0) << "seed " << seed << ", step " << step << ": shapes " << p.first << " and " << p.second
                                                 << (expected.count(p) != 0 ? " overlap" : " do not overlap");
            pairs += seen.size();
            close_pairs += close.size();
            asleep += w.body_count() - w.report().awake_bodies;
            if (step % 25 == 0) { ASSERT_EQ(w.validate(), nullptr); }
        }
    }
    EXPECT_GT(pairs, test::slow_build ? 3000u : 30000u);
    EXPECT_LT(close_pairs, pairs / 500);
    EXPECT_GT(asleep, test::slow_build ? 50u : 1000u);
}

// Who believes events alone knows what overlaps.
TEST(Sensors, EventsAddUpToTheOverlaps) {
    Crowd crowd(77);
    World& w = *crowd.w;
    std::set<Pair> known;
    std::size_t told = 0;
    for (int step = 1; step <= 400; ++step) {
        crowd.meddle(step);
        crowd.w.step();
        // Ends first: those of calls before the step come with it.
        for (const SensorEvent& e : w.sensor_end_events()) EXPECT_EQ(known.erase(pair_of(e)), 1u) << "step " << step;
        for (const SensorEvent& e : w.sensor_begin_events()) EXPECT_TRUE(known.insert(pair_of(e)).second) << "step " << step;
        told += w.sensor_end_events().size() + w.sensor_begin_events().size();
        ASSERT_EQ(known, seen_by_sensors(w)) << "step " << step;
    }
    EXPECT_GT(told, 500u);
}

// -- determinism -------------------------------------------------------------------------------------------------------------------------

std::vector<std::uint32_t> told(const World& w) {
    std::vector<std::uint32_t> all;
    for (const SensorEvent& e : w.sensor_begin_events()) all.insert(all.end(), {1, e.sensor.index1, e.sensor.generation, e.visitor.index1});
    for (const SensorEvent& e : w.sensor_end_events()) all.insert(all.end(), {2, e.sensor.index1, e.sensor.generation, e.visitor.index1});
    for (const TouchEvent& e : w.begin_touch_events()) all.insert(all.end(), {3, e.shape_a.index1, e.shape_b.index1});
    for (const TouchEvent& e : w.end_touch_events()) all.insert(all.end(), {4, e.shape_a.index1, e.shape_b.index1});
    return all;
}

TEST(Sensors, SnapshotsCarryThemAndTheirPendingEvents) {
    Crowd crowd(3);
    World& w = *crowd.w;
    // At a moment when some have been reported and others wait.
    for (int step = 0; step < 60 || w.sensor_end_events().empty() || w.end_touch_events().empty(); ++step) {
        ASSERT_LT(step, 1000);
        crowd.meddle(step);
        crowd.w.step();
    }
    const std::size_t reported = w.sensor_end_events().size(), touches = w.end_touch_events().size();
    for (int i = 0; i < 12; ++i) w.destroy_body(crowd.bodies[static_cast<std::size_t>(i)]);
    ASSERT_GT(w.sensor_end_events().size(), reported);
    ASSERT_GT(w.end_touch_events().size(), touches);
    const Image image = save(w);
    TestWorld restored(Capacity{.bodies = 200, .shapes = 400, .contacts = 3000}), loaded;
    ASSERT_TRUE(restored->restore(image.bytes()));
    ASSERT_TRUE(loaded->load(image.bytes())) << describe(loaded->last_error());
    EXPECT_EQ(seen_by_sensors(*loaded), seen_by_sensors(w));
    EXPECT_EQ(save(*loaded), image);
    for (int step = 0; step < 90; ++step) {
        crowd.w.step();
        restored.step();
        loaded.step();
        ASSERT_EQ(told(*restored), told(w)) << step;
        ASSERT_EQ(told(*loaded), told(w)) << step;
        ASSERT_EQ(restored->hash(), w.hash());
        ASSERT_EQ(loaded->hash(), w.hash());
    }
}

TEST(Sensors, TellTheSameWithAnyNumberOfWorkers) {
    // One thread that claims to be several, and does the tasks backwards.
    const auto backwards = [](void*, std::uint32_t count, void (*task)(void*, std::uint32_t), void* data) {
        for (std::uint32_t i = count; i-- > 0;) task(data, i);
    };
    Crowd one(9), two(9, {.tasks = {backwards, nullptr, 2}}), four(9, {.tasks = {backwards, nullptr, 4}});
    for (int step = 1; step <= 200; ++step) {
        for (Crowd* c : {&one, &two, &four}) {
            c->meddle(step);
            c->w.step();
        }
        ASSERT_EQ(told(*two.w), told(*one.w)) << step;
        ASSERT_EQ(told(*four.w), told(*one.w)) << step;
        ASSERT_EQ(two.w->hash(), one.w->hash());
        ASSERT_EQ(four.w->hash(), one.w->hash());
    }
}

}  // namespace
}  // namespace islet::test
