// Good input at the edges of what is allowed: whatever happens, the numbers stay finite and the invariants hold.
#include <cmath>

#include "refusal.hpp"
#include "support/random.hpp"

namespace {

using namespace islet;
using namespace islet::test;

void expect_sound_world(const TestWorld& w, const char* when) {
    const char* broken = w->validate();
    EXPECT_EQ(broken, nullptr) << broken << ", " << when;
    EXPECT_TRUE(w.is_finite()) << when;
}

// A heap of every kind of body, `at` metres from the origin.
void add_heap(TestWorld& w, Vec2 at, float size = 0.5f, const ShapeDef& shape = {}) {
    w.add(make_box(40 * size, 2 * size), at - Vec2{0, 2 * size}, shape, BodyType::static_body);
    for (int i = 0; i < 30; ++i) {
        const Vec2 p = at + Vec2{size * 2.1f * static_cast<float>(i % 5), size * (1.5f + 2.2f * static_cast<float>(i / 5))};
        switch (i % 4) {
        case 0: w.add(make_box(size, size), p, shape); break;
        case 1: w.add(Circle{{0, 0}, size}, p, shape); break;
        case 2: w.add(Capsule{{-0.5f * size, 0}, {0.5f * size, 0}, 0.5f * size}, p, shape); break;
        default: w.add(make_rounded_box(0.8f * size, 0.4f * size, 0.1f * size), p, shape);
        }
    }
}

TEST(Stress, AnyTimeStepUpToASecond) {
    for (const float dt : {1.0f / 240, 1.0f / 120, 1.0f / 60, 1.0f / 30, 1.0f / 20, 0.1f, 0.25f, 0.5f, 1.0f}) {
        SCOPED_TRACE(dt);
        TestWorld w;
        add_heap(w, {0, 0});
        for (int i = 0; i < 200; ++i) {
            w.step(1, dt);
            expect_sound_world(w, "while stepping");
            if (HasFailure()) return;
        }
    }
}

TEST(Stress, TimeStepsThatJumpAbout) {
    TestWorld w;
    add_heap(w, {0, 0});
    Random random(4);
    for (int i = 0; i < 400; ++i) w.step(1, std::pow(10.0f, random.between(-5, 0)));
    expect_sound_world(w, "after steps of 10 microseconds to a second");
}

TEST(Stress, TimeStepsDownToAMicrosecond) {
    TestWorld w;
    add_heap(w, {0, 0});
    w.step(20);
    w.step(5, min_time_step);
    expect_sound_world(w, "after short steps");
    w.step(20);
    expect_sound_world(w, "after going on");
    const std::uint64_t hash = w->hash();
    for (const float dt : {std::nextafter(min_time_step, 0.0f), 1e-9f, 1e-20f, 1e-37f, 1.2e-38f, 1e-40f, 1.4e-45f}) {
        w.errors.clear();
        w.step(1, dt);
        EXPECT_EQ(w.errors, std::vector{Error::bad_time_step}) << dt;
    }
    EXPECT_EQ(w->hash(), hash) << "a step refused changes nothing";
}

TEST(Stress, HugeVelocitiesAreCutDownToTheSpeedLimit) {
    for (const float speed : {1e3f, 1e6f, 1e12f, 1e18f, 1e19f, 1e25f, 1e38f}) {
        SCOPED_TRACE(speed);
        TestWorld w;
        w.add_ground();
        add_heap(w, {0, 0});
        const BodyId bullet = w.add_circle({0, 100}, 0.1f);
        w->set_linear_velocity(bullet, {speed, 0});
        w.step();
        expect_sound_world(w, "after a step");
        EXPECT_NEAR(length(w->linear_velocity(bullet)), WorldDef{}.max_speed, 0.1f) << "the direction is kept, the speed is limited";
        w->set_linear_velocity(w.add_circle({0, 30}, 0.2f), {0, -speed});
        w->set_angular_velocity(w.add_box({5, 30}), speed);
        w.step(100);
        expect_sound_world(w, "in the end");
    }
}

TEST(Stress, MassesFromSpecksToMoons) {
    for (const float density : {1e-30f, 1e-20f, 1e-6f, 1e6f, 1e15f, 1e25f}) {
        SCOPED_TRACE(density);
        TestWorld w;
        ShapeDef shape;
        shape.density = density;
        add_heap(w, {0, 0}, 0.5f, shape);
        w.step(200);
        expect_sound_world(w, "alone");
        add_heap(w, {0, 15});
        w.step(200);
        expect_sound_world(w, "with a heap of ordinary weight on top");
    }
}

TEST(Stress, ShapesFromDustToIslands) {
    for (const float size : {1e-15f, 1e-12f, 1e-10f, 1e-8f, 1e-6f, 1e-4f, 1e-2f, 1e2f, 1e4f, 1e5f}) {
        SCOPED_TRACE(size);
        TestWorld w;
        w.add_ground(-4 * size);
        for (int i = 0; i < 20; ++i) {
            const Vec2 p{size * static_cast<float>(i % 3), size * static_cast<float>(i)};
            w.add_circle(p, size);
            if (is_valid(make_box(size, size))) w.add_box(p, size, size);
            if (2 * size > 0.006f) w.add_capsule(p, size, size);
        }
        EXPECT_TRUE(w.errors.empty());
        for (int i = 0; i < 100; ++i) {
            w.step();
            expect_sound_world(w, "while stepping");
            if (HasFailure()) return;
        }
    }
}

TEST(Stress, ADiscOfAnySizeThatIsAllowed) {
    for (const float radius : {1e-45f, 1e-38f, 1e-30f, 1e-22f, 1e-20f, 1e-19f, 1e-11f, 1e-9f, 1e6f, 1e7f}) {
        SCOPED_TRACE(radius);
        TestWorld w;
        if (!is_valid(Circle{{0, 0}, radius})) continue;
        const BodyId disc = w.add_circle({0, 0}, radius);
        w->apply_torque(disc, 1);
        w->apply_force_to_center(disc, {1, 0});
        w.step(10);
        expect_sound_world(w, "after ten steps");
    }
}

TEST(Stress, AHundredKilometresOut) {
    for (const Vec2 at : {Vec2{1e5f, 0}, Vec2{-1e5f, 1e5f}, Vec2{0, -1e6f}, Vec2{1e7f, 1e7f}, Vec2{1e20f, 0}, Vec2{3e38f, -3e38f}}) {
        SCOPED_TRACE(at.x);
        TestWorld w;
        add_heap(w, at);
        w.step(200);
        expect_sound_world(w, "far out");
    }
}

TEST(Stress, DeepOverlapsAreResolvedWithoutAnExplosion) {
    TestWorld w;
    w.add_ground();
    for (int i = 0; i < 60; ++i) i % 2 == 0 ? w.add_box({0, 0.5f}) : w.add_circle({0, 0.5f});
    for (int i = 0; i < 300; ++i) {
        w.step();
        for (const BodyId id : w.bodies()) ASSERT_LT(length(w->linear_velocity(id)), 100.0f) << "in step " << i;
    }
    expect_sound_world(w, "after five seconds");
    // They have left each other: no contact is deeper than half a radius.
    for (const ContactInfo& c : w.contacts())
        for (std::uint32_t i = 0; i < c.point_count; ++i) EXPECT_GT(c.points[i].separation, -0.25f);
}

TEST(Stress, EverythingInOnePlace) {
    TestWorld w({.bodies = 200, .shapes = 200, .contacts = 4000});
    for (int i = 0; i < 200; ++i) w.add_circle({0, 0});
    w.step();
    EXPECT_GT(w->report().overflow_contacts, 0u);
    EXPECT_GT(w->report().dropped_contacts, 0u);
    w.step(59);
    expect_sound_world(w, "with more contacts wanted than there is room");
}

TEST(Stress, EveryScheduleAtItsExtremes) {
    for (const Schedule schedule : {Schedule::soft, Schedule::classic}) {
        for (int kind = 0; kind < 6; ++kind) {
            SCOPED_TRACE(kind);
            SolverDef d;
            d.schedule = schedule;
            if (kind == 0) d.substeps = 64;
            if (kind == 1) d.iterations = 256;
            if (kind == 2) d.omega = 1.99f;
            if (kind == 3) d.relax_iterations = 0, d.contact_damping_ratio = 0, d.contact_push_speed = 1e6f;
            if (kind == 4) d.contact_hertz = 1e-3f, d.baumgarte = 0;
            if (kind == 5) d.contact_hertz = 1e6f, d.baumgarte = 1, d.warm_start = false;
            TestWorld w;
            w->set_solver(d);
            add_heap(w, {0, 0});
            w.step(60);
            expect_sound_world(w, "after a second");
        }
    }
}

}  // namespace
