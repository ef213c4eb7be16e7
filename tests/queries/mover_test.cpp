// The character mover on courses whose geometry says where it must be. After every step no shape may overlap its capsule, by exact distances in double
// precision (known.hpp).
#include "islet/mover.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "known.hpp"
#include "support/effort.hpp"

namespace {

using namespace islet;
using test::cases;
using test::TestWorld;

constexpr float dt = 1.0f / 60;
constexpr float gap = mover_gap;
constexpr float radius = 0.3f;

// Speeds that are reached at once, so that distances are speed times time.
MoverDef sudden() {
    MoverDef def;
    def.ground_acceleration = 1e6f;
    def.air_acceleration = 0;
    return def;
}

struct Hero {
    TestWorld& w;
    MoverDef def = sudden();
    MoverState state;
    float worst_overlap = 0;
    int steps_in_air = 0;

    explicit Hero(TestWorld& world, Vec2 feet) : w(world) { state.position = feet; }

    void step(const MoverInput& input, int steps = 1) {
        for (int i = 0; i < steps; ++i) {
            w->step(dt);
            ASSERT_TRUE(step_mover(*w, def, state, input, dt));
            steps_in_air += state.ground ? 0 : 1;
            watch();
        }
    }
    void watch() {
        const Capsule c{state.position + def.capsule.point1, state.position + def.capsule.point2, def.capsule.radius};
        const oracle::Solid solid = oracle::solid_of(make_proxy(c));
        for (const test::Known& k : test::known_shapes(w)) {
            if (def.collides == nullptr) worst_overlap = std::max(worst_overlap, static_cast<float>(-oracle::signed_distance(solid, k.solid)));
        }
    }
    Vec2 middle() const { return state.position + def.capsule.point1; }
};

void add_slope(TestWorld& w, float degrees) {
    // A block whose upper face goes through the origin.
    const Rot q = make_rot(degrees * pi / 180);
    w.add(make_offset_box(50, 1, {rotate(q, {0, -1}), q}), Vec2{0, 0}, {}, BodyType::static_body);
}

// -- slopes --------------------------------------------------------------------------------------------------------------------------

TEST(Mover, WalksAlongSlopesUpTo50DegreesAtItsSpeed) {
    for (int degrees = -50; degrees <= 50; degrees += 5) {
        SCOPED_TRACE(degrees);
        TestWorld w;
        add_slope(w, static_cast<float>(degrees));
        const Rot q = make_rot(static_cast<float>(degrees) * pi / 180);
        // The middle of the lower end hovers at the radius and the gap above the face.
        Hero hero(w, rotate(q, {0, radius + gap}) - Vec2{0, radius});
        hero.step({}, 5);
        ASSERT_TRUE(hero.state.ground) << "it stands";
        const Vec2 start = hero.state.position;
        hero.step({}, 600);
        EXPECT_LT(distance(hero.state.position, start), 2e-5f) << "and does not creep";
        hero.step({.walk = 5}, 60);
        const Vec2 want = start + rotate(q, {5, 0});  // 5 m/s for one second
        EXPECT_LT(distance(hero.state.position, want), 1e-3f) << hero.state.position.x << ' ' << hero.state.position.y;
        EXPECT_NEAR(dot(hero.middle(), rotate(q, {0, 1})), radius + gap, 1e-4f);
        EXPECT_NEAR(length(hero.state.velocity), 5, 1e-3f);
        EXPECT_EQ(hero.steps_in_air, 0) << "it kept to the ground";
        EXPECT_LE(hero.worst_overlap, 0);
    }
}

TEST(Mover, DoesNotClimbSlopesThatAreTooSteepAndSlidesDownThem) {
    for (const float degrees : {55.0f, 65.0f, 75.0f, 85.0f}) {
        SCOPED_TRACE(degrees);
        TestWorld w;
        w.add_ground(0);
        add_slope(w, degrees);
        Hero hero(w, {-3, gap});
        hero.def.air_acceleration = 20;
        hero.step({.walk = 5}, 120);
        // Where the capsule touches both the floor and the slope: the angle's bisector.
        const float x = -(radius + gap) * std::tan(degrees * pi / 360);
        EXPECT_NEAR(hero.state.position.x, x, 2e-3f);
        EXPECT_NEAR(hero.state.position.y, gap, 1e-3f);
        EXPECT_LE(hero.worst_overlap, 0);
        // Dropped onto the slope it comes down to the same place, walking into it or not.
        for (const float walk : {0.0f, 5.0f}) {
            const Rot q = make_rot(degrees * pi / 180);
            hero.state = {};
            hero.state.position = rotate(q, {2, radius + gap + 0.1f}) - Vec2{0, radius};
            hero.step({.walk = walk}, 240);
            EXPECT_NEAR(hero.state.position.y, gap, 1e-3f) << walk;
            EXPECT_LE(hero.state.position.x, x + 2e-3f) << walk;
        }
        EXPECT_LE(hero.worst_overlap, 0);
    }
}

TEST(Mover, KeepsToTheGroundOverACrest) {
    // Up 40 degrees, level, down 40 degrees.
    TestWorld w;
    const float t = std::tan(40 * pi / 180);
    const Vec2 hill[] = {{-20, 0}, {-5, 0}, {0, 5 * t}, {4, 5 * t}, {9, 0}, {20, 0}};
    std::vector<Vec2> floor(std::rbegin(hill), std::rend(hill));  // solid below: from right to left
    const BodyId body = w->create_body({});
    ASSERT_EQ(w->create_chain(body, floor, false), 5u);
    Hero hero(w, {-8, gap});
    hero.step({}, 2);
    hero.steps_in_air = 0;
    hero.step({.walk = 6}, 300);
    EXPECT_EQ(hero.steps_in_air, 0);
    EXPECT_NEAR(hero.state.position.y, gap, 1e-3f);
    // Its feet went along 3 m, 5 / cos 40 up, 4 m, 5 / cos 40 down and the rest: only the corners are rounded, by less than the radius each.
    const float along = 6 * 5 - 3 - 2 * 5 / std::cos(40 * pi / 180) - 4;
    EXPECT_NEAR(hero.state.position.x, 9 + along, 4 * radius);
    EXPECT_LE(hero.worst_overlap, 0);
}

// -- floors of pieces, steps, gaps -----------------------------------------------------------------------------------------------------

TEST(Mover, FeelsNoSeams) {
    for (const bool chain : {false, true}) {
        SCOPED_TRACE(chain);
        TestWorld w;
        if (chain) {
            std::vector<Vec2> points;
            for (int i = 60; i >= -60; --i) points.push_back({0.37f * static_cast<float>(i), 0});
            w->create_chain(w->create_body({}), points, false);
        } else {
            for (int i = -40; i <= 40; ++i) w.add_box({0.5f * static_cast<float>(i), -0.25f}, 0.25f, 0.25f, {}, BodyType::static_body);
        }
        Hero hero(w, {-15, gap});
        hero.step({}, 2);
        const float start = hero.state.position.x;
        for (int i = 1; i <= 240; ++i) {
            hero.step({.walk = 7});
            ASSERT_NEAR(hero.state.position.y, gap, 1e-4f) << "at x = " << hero.state.position.x;
            ASSERT_NEAR(hero.state.position.x, start + 7 * dt * static_cast<float>(i), 1e-3f);
        }
        EXPECT_LE(hero.worst_overlap, 0);
    }
}

void add_stairs(TestWorld& w, int steps, float rise, float depth) {
    w.add_ground(0);
    for (int i = 1; i <= steps; ++i) {
        const float left = 2 + depth * static_cast<float>(i - 1), top = rise * static_cast<float>(i);
        w.add(make_offset_box(25, 0.5f * top, {{left + 25, 0.5f * top}, {}}), Vec2{0, 0}, {}, BodyType::static_body);
    }
}

TEST(Mover, ClimbsStairsAndComesDownThem) {
    for (const float rise : {0.1f, 0.2f, 0.3f, 0.34f}) {
        SCOPED_TRACE(rise);
        TestWorld w;
        add_stairs(w, 8, rise, 0.5f);
        Hero hero(w, {0, gap});
        hero.step({}, 2);
        hero.steps_in_air = 0;
        hero.step({.walk = 3}, 240);
        EXPECT_GT(hero.state.position.x, 6.5f);
        EXPECT_NEAR(hero.state.position.y, 8 * rise + gap, 1e-3f) << "on top of the eighth step";
        hero.step({.walk = -3}, 300);
        EXPECT_EQ(hero.steps_in_air, 0) << "neither up nor down";
        EXPECT_LT(hero.state.position.x, 1.5f);
        EXPECT_NEAR(hero.state.position.y, gap, 1e-3f) << "down again";
        EXPECT_LE(hero.worst_overlap, 0);
    }
}

TEST(Mover, DoesNotClimbStepsThatAreTooHigh) {
    TestWorld w;
    add_stairs(w, 1, 0.37f, 1);
    Hero hero(w, {0, gap});
    hero.step({.walk = 3}, 240);
    EXPECT_NEAR(hero.state.position.y, gap, 1e-3f);
    // Stopped by the step's edge, 0.37 m high and above the middle of the round end: by the wall below it.
    EXPECT_NEAR(hero.state.position.x, 2 - radius - gap, 2e-3f);
    EXPECT_LE(hero.worst_overlap, 0);
}

TEST(Mover, DoesNotClimbAStepUnderALowCeiling) {
    TestWorld w;
    add_stairs(w, 1, 0.3f, 1);
    // The capsule is 1.8 m tall; there are 2 m above the floor, 1.7 m above the step.
    w.add_box({0, 2.5f}, 50, 0.5f, {}, BodyType::static_body);
    Hero hero(w, {0, gap});
    hero.step({.walk = 3}, 240);
    EXPECT_LT(hero.state.position.x, 2);
    EXPECT_LE(hero.worst_overlap, 0);
}

TEST(Mover, WalksOverANarrowGapAndFallsIntoAWideOne) {
    TestWorld w;
    w.add_box({-10, -1}, 10, 1, {}, BodyType::static_body);
    w.add_box({10.2f, -1}, 10, 1, {}, BodyType::static_body);    // 0.2 m
    w.add_box({32.2f, -1}, 10, 1, {}, BodyType::static_body);    // 2 m
    Hero hero(w, {-2, gap});
    hero.step({}, 2);
    // Over the narrow gap the round end sinks in between the edges, by r - sqrt(r^2 - 0.1^2), with the gap as part of r.
    const float r = radius + gap;
    const float sinks = r - std::sqrt(r * r - 0.01f);
    float lowest = 1;
    for (int i = 0; i < 240; ++i) {
        hero.step({.walk = 1});
        lowest = std::min(lowest, hero.state.position.y);
    }
    EXPECT_NEAR(lowest, gap - sinks, 4e-3f);
    EXPECT_NEAR(hero.state.position.y, gap, 1e-3f);
    EXPECT_EQ(hero.steps_in_air, 0);
    hero.step({.walk = 4}, 320);
    EXPECT_LT(hero.state.position.y, -1.5f) << "the wide one it falls into";
    EXPECT_LE(hero.worst_overlap, 0);
}

TEST(Mover, LeavesALedgeLevelAndFallsAsBodiesDo) {
    TestWorld w;
    w.add_box({-10, 5}, 10, 1, {}, BodyType::static_body);  // its top at 6, its edge at 0
    w.add_ground(0);
    Hero hero(w, {-2, 6 + gap});
    hero.step({}, 2);
    while (hero.state.ground && hero.state.position.x < 3) hero.step({.walk = 5});
    ASSERT_FALSE(hero.state.ground);
    EXPECT_NEAR(hero.state.velocity.x, 5, 1e-3f);
    EXPECT_NEAR(hero.state.velocity.y, 0, 1e-3f) << "no jump and no dive";
    const Vec2 start = hero.state.position;
    int n = 0;
    for (; !hero.state.ground && n < 200; ++n) {
        hero.step({.walk = 5});
        if (hero.state.ground) break;
        const float k = static_cast<float>(n + 1);
        ASSERT_NEAR(hero.state.position.x, start.x + 5 * dt * k, 1e-3f);
        ASSERT_NEAR(hero.state.position.y, start.y - 5 * dt * dt * k * (k + 1), 2e-3f);  // g / 2 dt^2 n (n + 1)
    }
    EXPECT_NEAR(hero.state.position.y, gap, 1e-3f);
    EXPECT_LE(hero.worst_overlap, 0);
}

// -- jumps -----------------------------------------------------------------------------------------------------------------------------

TEST(Mover, JumpsAsHighAsItsSpeedSays) {
    TestWorld w;
    w.add_ground(0);
    Hero hero(w, {0, gap});
    hero.step({}, 2);
    ASSERT_TRUE(hero.state.ground);
    float highest = 0;
    hero.step({.jump = 6});
    for (int n = 1; n < 60; ++n) {
        const float k = static_cast<float>(n);
        const float want = gap + 6 * dt * k - 5 * dt * dt * k * (k + 1);
        if (want > gap) {
            ASSERT_NEAR(hero.state.position.y, want, 1e-4f) << n;
        }
        highest = std::max(highest, hero.state.position.y);
        hero.step({});
    }
    EXPECT_NEAR(highest, 36.0f / 20, 0.06f);  // v^2 / 2 g, less v dt / 2
    hero.step({}, 60);
    EXPECT_NEAR(hero.state.position.y, gap, 1e-4f);
    EXPECT_TRUE(hero.state.ground);
    EXPECT_EQ(hero.state.velocity, Vec2{});
}

TEST(Mover, ACeilingEndsAJump) {
    TestWorld w;
    w.add_ground(0);
    w.add_box({0, 3}, 5, 0.5f, {}, BodyType::static_body);  // its underside at 2.5
    Hero hero(w, {0, gap});
    hero.step({}, 2);
    hero.step({.jump = 9});
    float highest = 0;
    for (int i = 0; i < 60; ++i) {
        hero.step({});
        highest = std::max(highest, hero.state.position.y);
    }
    EXPECT_NEAR(highest, 2.5f - 1.8f - gap, 1e-3f);
    EXPECT_TRUE(hero.state.ground);
    EXPECT_LE(hero.worst_overlap, 0);
}

TEST(Mover, PassesOneWayPlatformsFromBelowAndStandsOnThem) {
    TestWorld w;
    w.add_ground(0);
    const BodyId platform = w.add_box({0, 1.5f}, 2, 0.1f, {}, BodyType::static_body);
    Hero hero(w, {0, gap});
    hero.def.collides = [](const Surface& s, void*) { return s.normal.y > 0.7f && s.separation > -0.05f; };
    hero.step({}, 2);
    hero.step({.jump = 7});
    hero.step({}, 120);
    EXPECT_EQ(hero.state.ground, platform);
    EXPECT_NEAR(hero.state.position.y, 1.6f + gap, 1e-3f);
}

TEST(Mover, FallsThroughAOneWayPlatformWhenToldTo) {
    TestWorld w;
    w.add_ground(0);
    const BodyId platform = w.add_box({0, 1.5f}, 2, 0.1f, {}, BodyType::static_body);
    Hero hero(w, {0, 1.6f + gap});
    struct Rule {
        const World& world;
        BodyId platform;
        bool drop = false;
    } rule{*w, platform};
    hero.def.collides = [](const Surface& s, void* context) {
        const Rule& it = *static_cast<Rule*>(context);
        return it.world.body(s.shape) != it.platform || (!it.drop && s.normal.y > 0.7f && s.separation > -0.05f);
    };
    hero.def.context = &rule;
    hero.step({}, 30);
    EXPECT_EQ(hero.state.ground, platform);
    rule.drop = true;
    hero.step({}, 20);
    rule.drop = false;
    hero.step({}, 60);
    EXPECT_NEAR(hero.state.position.y, gap, 1e-3f);
}

// -- walls and corners -------------------------------------------------------------------------------------------------------------------

TEST(Mover, StandsStillInCorners) {
    struct Corner {
        const char* what;
        float wall;     // degrees from the floor; above 90 it leans over
        float ceiling;  // degrees, 0: none
    };
    for (const Corner& corner : {Corner{"wall", 90, 0}, Corner{"overhang", 120, 0}, Corner{"steep slope", 70, 0}, Corner{"under a slope", 90, 20}}) {
        SCOPED_TRACE(corner.what);
        TestWorld w;
        w.add_ground(0);
        const Rot q = make_rot(corner.wall * pi / 180);
        w.add(make_offset_box(20, 1, {Vec2{3, 0} + rotate(q, {10, -1}), q}), Vec2{0, 0}, {}, BodyType::static_body);
        if (corner.ceiling > 0) {
            const Rot c = make_rot(-corner.ceiling * pi / 180);
            w.add(make_offset_box(20, 1, {Vec2{2.2f, 1.9f} + rotate(c, {0, 1}), c}), Vec2{0, 0}, {}, BodyType::static_body);
        }
        Hero hero(w, {0, gap});
        hero.step({.walk = 6}, 60);
        const Vec2 there = hero.state.position;
        EXPECT_GT(there.x, 1);
        for (int i = 0; i < 120; ++i) {
            hero.step({.walk = 6});
            ASSERT_LT(distance(hero.state.position, there), 1e-5f) << "it trembles, step " << i;
        }
        EXPECT_TRUE(hero.state.ground);
        EXPECT_LE(hero.worst_overlap, 0);
    }
}

TEST(Mover, HoldsInAWedgeOfTwoSteepSlopesAndCanJumpOut) {
    TestWorld w;
    add_slope(w, 65);
    add_slope(w, -65);
    Hero hero(w, {0, 3});
    hero.step({}, 180);
    // Both faces are touched: the middle is (r + gap) / cos 65 above the edge where they meet.
    EXPECT_NEAR(hero.middle().y, (radius + gap) / std::cos(65 * pi / 180), 3e-3f);
    EXPECT_NEAR(hero.middle().x, 0, 3e-3f);
    EXPECT_TRUE(hero.state.ground);
    const Vec2 there = hero.state.position;
    hero.step({}, 60);
    EXPECT_LT(distance(hero.state.position, there), 1e-4f);
    hero.step({.jump = 5}, 1);
    hero.step({}, 10);
    EXPECT_GT(hero.state.position.y, there.y + 0.4f);
    EXPECT_LE(hero.worst_overlap, 0);
}

TEST(Mover, NoSpeedTakesItThroughAThinWall) {
    TestWorld w;
    w.add_ground(0);
    w.add(Segment{{3, 0}, {3, 9}}, Vec2{0, 0}, {}, BodyType::static_body);
    for (const float speed : {50.0f, 400.0f, 20000.0f}) {
        Hero hero(w, {0, gap});
        hero.step({.walk = speed}, 5);
        EXPECT_NEAR(hero.state.position.x, 3 - radius - gap, 1e-3f) << speed;
        EXPECT_LE(hero.worst_overlap, 0);
    }
}

// -- moving ground ---------------------------------------------------------------------------------------------------------------------

TEST(Mover, RidesPlatformsThatMove) {
    for (const Vec2 velocity : {Vec2{2, 0}, Vec2{0, 2}, Vec2{0, -2}, Vec2{-1, 1}, Vec2{3, -1}}) {
        SCOPED_TRACE(velocity.x);
        TestWorld w;
        const BodyId platform = w.add_box({0, 0}, 2, 0.5f, {}, BodyType::kinematic);
        Hero hero(w, {0.7f, 0.5f + gap});
        hero.step({}, 3);
        ASSERT_EQ(hero.state.ground, platform);
        const Vec2 start = hero.state.position;
        w->set_linear_velocity(platform, velocity);
        hero.step({}, 90);
        EXPECT_LT(distance(hero.state.position, start + 1.5f * velocity), 1e-3f);
        EXPECT_EQ(hero.state.velocity, Vec2{}) << "relative to the platform";
        // Jumping off it takes its velocity along.
        hero.step({.jump = 4});
        EXPECT_LT(distance(hero.state.velocity, velocity + Vec2{0, 4 - 10 * dt}), 1e-3f);
        EXPECT_LE(hero.worst_overlap, 0);
    }
}

TEST(Mover, RidesATurningPlatformAsIfBoltedToIt) {
    for (const float turning : {0.5f, -0.5f}) {
        SCOPED_TRACE(turning);
        TestWorld w;
        const BodyId platform = w.add_box({0, 0}, 4, 0.5f, {}, BodyType::kinematic);
        Hero hero(w, {1.5f, 0.5f + gap});
        hero.step({}, 3);
        const Vec2 arm = hero.middle();  // from the platform's centre
        w->set_angular_velocity(platform, turning);
        hero.step({}, 72);
        const Rot q = make_rot(turning * 72 * dt);  // 0.6 rad
        EXPECT_LT(distance(hero.middle(), rotate(q, arm)), 5e-3f);
        EXPECT_EQ(hero.steps_in_air, 0);
        EXPECT_LE(hero.worst_overlap, 0.001f);
    }
}

TEST(Mover, AConveyorCarriesItWithItsSurface) {
    for (const float degrees : {0.0f, 20.0f, -20.0f}) {
        SCOPED_TRACE(degrees);
        TestWorld w;
        const Rot q = make_rot(degrees * pi / 180);
        w.add(make_offset_box(50, 1, {rotate(q, {0, -1}), q}), Vec2{0, 0}, {.tangent_speed = 2}, BodyType::static_body);
        Hero hero(w, rotate(q, {0, radius + gap}) - Vec2{0, radius});
        hero.step({}, 5);
        const Vec2 start = hero.state.position;
        hero.step({}, 60);
        EXPECT_LT(distance(hero.state.position, start + rotate(q, {2, 0})), 1e-3f) << "2 m/s, to the right, for a second";
        hero.step({.walk = -2}, 60);
        EXPECT_LT(distance(hero.state.position, start + rotate(q, {2, 0})), 1e-3f) << "walking against it, it stays where it is";
        EXPECT_LE(hero.worst_overlap, 0);
    }
}

TEST(Mover, APlatformThatTurnsTooSteepThrowsItOff) {
    TestWorld w;
    const BodyId platform = w.add_box({0, 10}, 4, 0.5f, {}, BodyType::kinematic);
    Hero hero(w, {1.5f, 10.5f + gap});
    hero.step({}, 3);
    w->set_angular_velocity(platform, -1);
    hero.step({}, 120);
    EXPECT_FALSE(hero.state.ground);
    EXPECT_LT(hero.state.position.y, 8);
    EXPECT_LE(hero.worst_overlap, 0.001f);
}

TEST(Mover, AWallThatMovesPushesItAlong) {
    TestWorld w;
    w.add_ground(0);
    const BodyId wall = w.add_box({-2, 1}, 0.5f, 1, {}, BodyType::kinematic);
    Hero hero(w, {0, gap});
    hero.step({}, 2);
    w->set_linear_velocity(wall, {1.5f, 0});
    hero.step({}, 180);
    // The wall's face went from -1.5 to 3.
    EXPECT_NEAR(hero.state.position.x, w->position(wall).x + 0.5f + radius + gap, 2e-3f);
    EXPECT_NEAR(hero.state.position.y, gap, 1e-3f);
    EXPECT_LE(hero.worst_overlap, 0.001f);
}

TEST(Mover, ALiftThatCrushesItSaysSo) {
    TestWorld w;
    w.add_box({0, 3.5f}, 5, 0.5f, {}, BodyType::static_body);  // underside at 3
    const BodyId lift = w.add_box({0, -0.5f}, 2, 0.5f, {}, BodyType::kinematic);
    Hero hero(w, {0, gap});
    hero.step({}, 2);
    w->set_linear_velocity(lift, {0, 1});
    hero.step({}, 60);
    EXPECT_EQ(hero.state.squeezed, 0u) << "0.2 m of room are left";
    EXPECT_LE(hero.worst_overlap, 0.001f);
    hero.step({}, 30);
    EXPECT_EQ(hero.state.squeezed, 1u);
    EXPECT_TRUE(is_finite(hero.state.position));
    w->set_linear_velocity(lift, {0, -1});
    hero.step({}, 60);
    EXPECT_EQ(hero.state.squeezed, 0u);
    EXPECT_EQ(hero.state.ground, lift);
}

// -- bodies ------------------------------------------------------------------------------------------------------------------------------

TEST(Mover, PushesAsHardAsItMay) {
    for (const float mass : {1.0f, 20.0f, 200.0f}) {
        SCOPED_TRACE(mass);
        TestWorld w(test::roomy, {.gravity = {0, -10}});
        w.add_ground(0, 100, {.friction = 0});
        const BodyId crate = w.add_box({2, 1}, 0.5f, 1, {.friction = 0, .density = 0.5f * mass});
        Hero hero(w, {1.5f - radius - gap - 1e-6f, gap});
        hero.step({}, 2);
        hero.step({.walk = 3});
        // The momentum that the two would share, but no more than the force can give in a step.
        const float together = mass * 70 / (mass + 70);
        const float want = std::min(3 * together, 400 * dt) / mass;
        EXPECT_NEAR(w->linear_velocity(crate).x, want, 1e-3f * want);
        hero.step({.walk = 3}, 120);
        const float in_time = 400 * 2 / mass;  // force times 2 s
        EXPECT_NEAR(w->linear_velocity(crate).x, std::min(3.0f, in_time), 0.1f);
        EXPECT_NEAR(w->angular_velocity(crate), 0, 1e-2f) << "without toppling it";
        EXPECT_LE(hero.worst_overlap, 0.002f);
    }
}

TEST(Mover, ACrateHeldByMoreFrictionThanItsForceIsAWall) {
    TestWorld w;
    w.add_ground(0, 100, {.friction = 1});
    const BodyId crate = w.add_box({2, 1}, 0.5f, 1, {.friction = 1, .density = 50});  // 100 kg: 1000 N of friction
    Hero hero(w, {0, gap});
    hero.step({.walk = 3}, 180);
    EXPECT_NEAR(w->position(crate).x, 2, 2e-3f);
    EXPECT_NEAR(hero.state.position.x, 1.5f - radius - gap, 5e-3f);
    EXPECT_LE(hero.worst_overlap, 0.002f);
}

TEST(Mover, ItsWeightLiesOnWhatItStandsOn) {
    TestWorld w(test::roomy, {.gravity = {0, -10}});
    w.add_ground(0);
    const BodyId crate = w.add_box({0, 0.5f}, 0.5f, 0.5f, {.density = 30});  // 30 kg
    Hero hero(w, {0, 1 + gap});
    hero.step({}, 120);
    EXPECT_EQ(hero.state.ground, crate);
    float force = 0;
    for (const ContactInfo& c : w.contacts()) {
        for (std::uint32_t i = 0; i < c.point_count; ++i) force += c.points[i].normal_impulse * 4 / dt;  // impulses are of one of 4 substeps
    }
    EXPECT_NEAR(force, (30 + 70) * 10, 20);
}

// -- the same bits, bad input ----------------------------------------------------------------------------------------------------------------

// A walk over everything: stairs, a crate, a lift, jumps.
struct Course {
    TestWorld w;
    Hero hero;
    int at = 0;
    Course() : hero(w, {0, gap}) {
        add_stairs(w, 4, 0.3f, 0.5f);
        w.add_box({-3, 0.5f}, 0.5f, 0.5f);
        w.add_circle({-5, 0.5f});
        w->set_linear_velocity(w.add_box({6, 1.5f}, 1, 0.2f, {}, BodyType::kinematic), {0, 0.4f});
        hero.def = {};
    }
    void run(int steps) {
        for (int i = 0; i < steps; ++i, ++at) {
            const float walk = (at / 100) % 3 == 0 ? -4.0f : 5.0f;
            hero.step({.walk = walk, .jump = at % 70 == 0 ? 5.0f : 0});
        }
    }
};

TEST(Mover, GoesBackWithASnapshotOfTheWorldAndComesToTheSameBits) {
    Course one, two;
    one.run(150);
    two.run(150);
    std::vector<std::byte> image(max_snapshot_bytes(one.w->capacity()));
    ASSERT_GT(one.w->save(image), 0u);
    const MoverState then = one.hero.state;
    one.run(200);
    two.run(200);
    EXPECT_EQ(std::memcmp(&one.hero.state, &two.hero.state, sizeof(MoverState)), 0);
    ASSERT_TRUE(two.w->restore(std::span(image).first(one.w->snapshot_bytes())) || two.w->restore(image));
    two.hero.state = then;
    two.at = 150;
    two.run(200);
    EXPECT_EQ(one.w->hash(), two.w->hash());
    EXPECT_EQ(std::memcmp(&one.hero.state, &two.hero.state, sizeof(MoverState)), 0);
    EXPECT_LE(one.hero.worst_overlap, 0.003f);
}

// Anything may happen in these worlds: heaps of bodies of all shapes, resting, falling, turning, a mover that does what chance says.
TEST(Mover, SinksIntoNothingInRandomWorldsUnlessItSaysThatItHasNoRoom) {
    exact::Random r;
    int squeezed = 0, grounded = 0, steps = 0;
    float worst = 0;
    for (int world = 0; world < (test::slow_build ? 4 : 40); ++world) {
        TestWorld w;
        w.add_ground(0, 20);
        for (const float side : {-1.0f, 1.0f}) w.add_box({side * 13, 5}, 1, 10, {}, BodyType::static_body);
        for (int i = 0; i < 30; ++i) {
            BodyDef def;
            def.type = i % 3 == 0 ? BodyType::static_body : i % 3 == 1 ? BodyType::kinematic : BodyType::dynamic;
            def.position = {r.in(-11, 11), r.in(0.5, 9)};
            def.angle = r.in(-3, 3);
            if (def.type == BodyType::kinematic) {
                def.linear_velocity = {r.in(-0.5, 0.5), r.in(-0.3, 0.3)};
                def.angular_velocity = r.in(-1, 1);
            }
            const BodyId body = w->create_body(def);
            switch (r.below(4)) {
            case 0: w->create_shape(body, Circle{{0, 0}, r.in(0.2, 1)}); break;
            case 1: w->create_shape(body, exact::random_polygon(r, 1.2)); break;
            case 2: w->create_shape(body, Capsule{{-0.7f, 0}, {0.7f, 0}, 0.3f}); break;
            default: w->create_shape(body, make_rounded_box(0.7f, 0.3f, 0.1f));
            }
        }
        Hero hero(w, {r.in(-10, 10), 11});
        hero.def = {};
        MoverInput input;
        for (int i = 0; i < 600; ++i, ++steps) {
            if (r.below(30) == 0) input.walk = r.in(-6, 6);
            input.jump = r.below(40) == 0 ? r.in(2, 9) : 0;
            hero.worst_overlap = 0;
            hero.step(input);
            ASSERT_TRUE(is_finite(hero.state.position) && is_finite(hero.state.velocity));
            ASSERT_LT(length(hero.state.velocity), 200);
            grounded += hero.state.ground ? 1 : 0;
            squeezed += hero.state.squeezed != 0 ? 1 : 0;
            if (hero.state.squeezed == 0) {
                ASSERT_LE(hero.worst_overlap, 0.005f) << "world " << world << ", step " << i;
                worst = std::max(worst, hero.worst_overlap);
            }
        }
        EXPECT_TRUE(w.errors.empty());
    }
    std::printf("%d steps, %d on the ground, %d squeezed, deepest overlap %.2g m\n", steps, grounded, squeezed, static_cast<double>(worst));
    EXPECT_GT(grounded, steps / 6);
    EXPECT_LT(squeezed, steps / 20);
}

TEST(Mover, BadInputIsRefusedAndChangesNothing) {
    TestWorld w;
    w.add_ground(0);
    const float nan = __builtin_nanf("");
    const auto refused = [&](Error error, auto&& spoil) {
        MoverDef def;
        MoverState state{.position = {0, 1}};
        MoverInput input{};
        float step = dt;
        spoil(def, state, input, step);
        const MoverState before = state;
        w->clear_error();
        EXPECT_FALSE(step_mover(*w, def, state, input, step));
        EXPECT_EQ(w->last_error(), error);
        EXPECT_EQ(std::memcmp(&before, &state, sizeof state), 0);
    };
    using D = MoverDef;
    using S = MoverState;
    using I = MoverInput;
    refused(Error::bad_time_step, [](D&, S&, I&, float& t) { t = 0; });
    refused(Error::bad_time_step, [&](D&, S&, I&, float& t) { t = nan; });
    refused(Error::bad_geometry, [](D& d, S&, I&, float&) { d.capsule.radius = -1; });
    refused(Error::out_of_range, [](D& d, S&, I&, float&) { d.up = {0, 2}; });
    refused(Error::not_finite, [&](D& d, S&, I&, float&) { d.up = {nan, 0}; });
    refused(Error::out_of_range, [](D& d, S&, I&, float&) { d.max_slope = 1.6f; });
    refused(Error::out_of_range, [](D& d, S&, I&, float&) { d.step_height = -1; });
    refused(Error::out_of_range, [](D& d, S&, I&, float&) { d.mass = -1; });
    refused(Error::not_finite, [&](D& d, S&, I&, float&) { d.max_push_force = nan; });
    refused(Error::not_finite, [&](D&, S& s, I&, float&) { s.position.x = nan; });
    refused(Error::out_of_range, [](D&, S& s, I&, float&) { s.position.x = 2e7f; });
    refused(Error::out_of_range, [](D&, S& s, I&, float&) { s.velocity.y = 2e6f; });
    refused(Error::not_finite, [&](D&, S& s, I&, float&) { s.ground_point.y = nan; });
    refused(Error::not_finite, [&](D&, S&, I& i, float&) { i.walk = nan; });
    refused(Error::out_of_range, [](D&, S&, I& i, float&) { i.jump = -1; });
}

TEST(Mover, NoFiniteInputGivesANaN) {
    exact::Random r;
    const float sizes[] = {0, 1e-30f, 1e-6f, 0.3f, 1, 50, 1e3f, 1e6f, 1e7f, 1e30f};
    const auto number = [&] { return sizes[r.below(10)] * (r.below(2) == 0 ? 1.0f : -1.0f); };
    int steps = 0;
    for (int i = 0; i < cases(20000); ++i) {
        static TestWorld w;
        if (i == 0) {
            w.add_ground(0);
            w.add_box({1, 1}, 0.5f, 0.5f);
            w->set_linear_velocity(w.add_box({3, 0.2f}, 1, 0.1f, {}, BodyType::kinematic), {1, 0});
        }
        w->set_gravity({0, r.below(10) == 0 ? number() : -10});
        MoverDef def;
        MoverState state{.position = {r.in(-2, 4), r.in(-1, 2)}};
        if (r.below(3) == 0) state.position = {number(), number()};
        if (r.below(3) == 0) state.velocity = {number(), number()};
        if (r.below(2) == 0) state.ground = w->body_at(r.below(3));
        if (r.below(2) == 0) state.ground_normal = {number(), number()};
        if (r.below(2) == 0) state.ground_point = {number(), number()};
        if (r.below(4) == 0) def.capsule = {{number(), number()}, {number(), number()}, std::fabs(number())};
        if (r.below(4) == 0) def.ground_acceleration = std::fabs(number());
        if (r.below(4) == 0) def.gravity_scale = number();
        if (r.below(4) == 0) def.step_height = std::fabs(number());
        if (r.below(4) == 0) def.snap_distance = std::fabs(number());
        if (r.below(4) == 0) def.mass = std::fabs(number());
        if (r.below(4) == 0) def.max_push_force = std::fabs(number());
        steps += step_mover(*w, def, state, {.walk = number(), .jump = std::fabs(number())}, r.below(2) == 0 ? dt : 1) ? 1 : 0;
        ASSERT_TRUE(is_finite(state.position) && is_finite(state.velocity) && is_finite(state.ground_normal) && is_finite(state.ground_point)) << i;
        if (i % 50 == 0) w.step();
        ASSERT_TRUE(w.is_finite()) << i;
    }
    EXPECT_GT(steps, cases(2000));
}

TEST(Mover, WhatItStoodOnMayGo) {
    TestWorld w;
    const BodyId floor = w.add_ground(0);
    Hero hero(w, {0, gap});
    hero.step({}, 3);
    ASSERT_EQ(hero.state.ground, floor);
    w->destroy_body(floor);
    w.errors.clear();
    hero.step({}, 30);
    EXPECT_FALSE(hero.state.ground);
    EXPECT_LT(hero.state.position.y, -1);
    EXPECT_TRUE(w.errors.empty());
}

}  // namespace
