// The angle joint against formulas: J = (-1, 1) on the angular velocities, so of two free bodies the reduced inertia is I = Ia Ib / (Ia + Ib), and of one body
// against the ground its own.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <islet/islet.hpp>

namespace {

using namespace islet;

constexpr float dt = 1.0f / 60;

using Storage = StaticWorld<Capacity{.bodies = 16, .shapes = 16, .contacts = 32, .joints = 16}>;

/// A disc of radius 1 m and 2 kg / pi per m^2 has 2 kg and an inertia of 1 kg m^2.
struct Turntable {
    explicit Turntable(AngleJointDef def = {}, const WorldDef& world = {.gravity = {0, 0}}) {
        w = &storage.create(world);
        ground = w->create_body({});
        disc = w->create_body({.type = BodyType::dynamic, .position = {3, 1}});
        w->create_shape(disc, Circle{{}, 1}, {.density = 2 / pi});
        def.base.body_a = ground;
        def.base.body_b = disc;
        joint = w->create_joint(def);
        EXPECT_TRUE(joint) << describe(w->last_error());
    }
    void step(int count = 1) {
        for (int i = 0; i < count; ++i) w->step(dt);
    }
    float angle() const { return w->joint_position(joint); }
    float speed() const { return w->joint_speed(joint); }

    Storage storage;
    World* w = nullptr;
    BodyId ground, disc;
    JointId joint;
};

TEST(AngleJoint, LeavesThePointsFree) {
    Turntable t({.limit = {.enable = true}}, {.gravity = {0, -10}});
    t.w->set_linear_velocity(t.disc, {2, 0});
    t.w->set_angular_velocity(t.disc, 1);
    t.step(60);
    EXPECT_NEAR(t.w->position(t.disc).x, 5, 1e-3f);
    EXPECT_NEAR(t.w->position(t.disc).y, 1 - 5, 0.1f);  // h g t / 2 more than -g t^2 / 2
    EXPECT_NEAR(t.angle(), 0, 0.005f);
    EXPECT_NEAR(t.w->joint_error(t.joint).angular, 0, 0.005f);
    EXPECT_EQ(t.w->joint_error(t.joint).linear, 0);
}

// A torque of 5 N m into the limit for four seconds, either way.
TEST(AngleJoint, HoldsItsLimitsWhileDriven) {
    for (const float way : {-1.0f, 1.0f}) {
        Turntable t({.limit = {.enable = true, .lower = -1.2f, .upper = 0.7f}});
        for (int i = 0; i < 240; ++i) {
            t.w->apply_torque(t.disc, 5 * way);
            t.step();
            EXPECT_LE(t.angle(), 0.705f);
            EXPECT_GE(t.angle(), -1.205f);
        }
        EXPECT_NEAR(t.angle(), way > 0 ? 0.7f : -1.2f, 0.005f);
        EXPECT_NEAR(t.w->joint_torque(t.joint), -5 * way, 0.05f);
    }
}

// x(t) = x0 e^(-zeta w t) (cos(wd t) + zeta w / wd sin(wd t)). The engine integrates by implicit Euler, which adds h w / 2 to the damping ratio: in a second,
// at 16 substeps, that takes h w^2 / 2 = 2.1 % of the amplitude. A half more is allowed for.
TEST(AngleJoint, ASpringSwingsAsTheDampedOscillatorDoes) {
    const double omega = 2 * double(pi), x0 = 0.5;
    for (const double zeta : {0.0, 0.2, 0.7}) {
        const JointSpring spring = {.enable = true, .hertz = 1, .damping_ratio = static_cast<float>(zeta), .target = 0.3f};
        Turntable t({.spring = spring}, {.gravity = {0, 0}, .solver = {.substeps = 16}});
        t.w->set_transform(t.disc, {3, 1}, 0.3f + static_cast<float>(x0));
        const double damped = std::sqrt(1 - zeta * zeta) * omega;
        double worst = 0;
        for (int i = 1; i <= 60; ++i) {
            t.step();
            const double time = i * double(dt);
            const double x = x0 * std::exp(-zeta * omega * time) * (std::cos(damped * time) + zeta * omega / damped * std::sin(damped * time));
            worst = std::fmax(worst, std::fabs(double(t.angle()) - 0.3 - x));
        }
        EXPECT_LT(worst, 1.5 * 0.5 * double(dt) / 16 * omega * omega * x0) << "damping ratio " << zeta;
    }
}

// Torque over inertia until the speed is reached: 3 N m on 1 kg m^2 take a second to 3 rad/s.
TEST(AngleJoint, AMotorReachesItsSpeedByItsTorque) {
    Turntable t({.motor = {.enable = true, .speed = 3, .max_force = 3}});
    for (int i = 1; i <= 60; ++i) {
        t.step();
        EXPECT_NEAR(t.speed(), 3 * dt * static_cast<float>(i), 1e-3f);
    }
    t.step(60);
    EXPECT_NEAR(t.speed(), 3, 1e-4f);
    EXPECT_NEAR(t.w->motor_force(t.joint), 0, 1e-3f);
    EXPECT_NEAR(t.angle(), 1.5f + 3, 0.05f) << "past half a turn";
}

// 2 N m slow 1 kg m^2 by 2 rad/s^2, and then hold it.
TEST(AngleJoint, FrictionSlowsByTorqueOverInertia) {
    Turntable t({.friction = 2});
    t.w->set_angular_velocity(t.disc, 4);
    for (int i = 1; i <= 120; ++i) {
        t.step();
        EXPECT_NEAR(t.speed(), 4 - 2 * dt * static_cast<float>(i), 1e-3f);
    }
    t.w->apply_torque(t.disc, 1.9f);
    t.step();
    EXPECT_NEAR(t.speed(), 0, 1e-4f);
}

// Of two free bodies nothing turns the pair: a spring, a motor, a limit and a ratchet act within it.
TEST(AngleJoint, AFreePairKeepsItsAngularMomentum) {
    for (const float inertia_b : {1.0f, 8.0f}) {
        Storage storage;
        World& w = storage.create({.gravity = {0, 0}});
        const BodyId a = w.create_body({.type = BodyType::dynamic, .position = {-4, 0}, .angular_velocity = 3});
        const BodyId b = w.create_body({.type = BodyType::dynamic, .position = {4, 0}, .angular_velocity = -1});
        w.create_shape(a, Circle{{}, 1}, {.density = 2 / pi});
        w.create_shape(b, Circle{{}, 1}, {.density = 2 * inertia_b / pi});
        AngleJointDef def{.base = {.body_a = a, .body_b = b}};
        def.spring = {.enable = true, .hertz = 2, .damping_ratio = 0.1f};
        def.limit = {.enable = true, .lower = -0.5f, .upper = 2};
        def.motor = {.enable = true, .speed = 1, .max_force = 0.5f};
        def.ratchet = {.step = 0.4f};
        ASSERT_TRUE(w.create_joint(def));
        const float before = 3 - inertia_b;
        for (int i = 0; i < 300; ++i) {
            w.step(dt);
            ASSERT_NEAR(w.angular_velocity(a) + inertia_b * w.angular_velocity(b), before, 1e-4f * (3 + inertia_b)) << i;
        }
        EXPECT_NEAR(w.linear_velocity(a).x, 0, 0);
    }
}

// Forward it turns as if nothing were there; back it is held at the last tooth passed, by either way of turning and any phase, and past full turns.
TEST(AngleJoint, ARatchetTurnsForwardFreelyAndHoldsAtEveryTooth) {
    for (const float step : {0.5f, 0.1f, -0.5f, -1.9f}) {
        for (const float phase : {0.0f, 0.03f, -4.0f}) {
            SCOPED_TRACE(testing::Message() << "step " << step << " phase " << phase);
            Turntable t({.ratchet = {step, phase}});
            const float way = step > 0 ? 1.0f : -1.0f;
            float tooth = -1.0e9f * way;
            for (int round = 0; round < 12; ++round) {
                t.w->set_angular_velocity(t.disc, 2 * way);
                const float from = t.angle();
                for (int i = 0; i < 58; ++i) {
                    t.step();
                    ASSERT_NEAR(t.speed(), 2 * way, 1e-3f) << "nothing is there on the way forward";
                }
                EXPECT_NEAR(t.angle() - from, way * 116 / 60, 0.002f);
                t.w->set_angular_velocity(t.disc, 0);
                tooth = phase + step * std::floor((t.angle() - phase) / step);
                for (int i = 0; i < 60; ++i) {  // 4 rad/s^2 backward
                    t.w->apply_torque(t.disc, -4 * way);
                    t.step();
                    ASSERT_GT((t.angle() - tooth) * way, -0.005f) << "round " << round;
                }
                EXPECT_NEAR(t.angle(), tooth, 0.005f) << "round " << round;
                EXPECT_NEAR(t.w->joint_error(t.joint).angular, 0, 0.005f);
            }
            EXPECT_GT(std::fabs(t.angle()), 1.5f * pi);
        }
    }
}

// The angle stands on a tooth when the ratchet is made, or set, and a load pulls back: the tooth counts as passed. (By the end of the first step the angle is a
// little below it, and the drum slipped by a whole step.)
TEST(AngleJoint, ANewRatchetHoldsWhereItIsMade) {
    for (const float step : {0.1f, 0.25f, 1.0f, -0.1f, -0.25f, -1.0f}) {
        for (const float phase : {0.0f, 0.05f, -0.3f, 2.0f}) {
            for (const bool is_set : {false, true}) {
                const JointRatchet ratchet = {.step = step, .phase = phase};
                Turntable t;
                t.w->set_transform(t.disc, {3, 1}, phase);
                if (is_set) {
                    t.w->set_ratchet(t.joint, ratchet);
                } else {
                    AngleJointDef def;
                    def.ratchet = ratchet;
                    def.base.body_a = t.ground;
                    def.base.body_b = t.disc;
                    t.w->destroy_joint(t.joint);
                    t.joint = t.w->create_joint(def);
                }
                for (int i = 0; i < 60; ++i) {
                    t.w->apply_torque(t.disc, step > 0 ? -2.0f : 2.0f);
                    t.step();
                    EXPECT_NEAR(t.angle(), phase, 0.005f) << "step " << step << ", phase " << phase;
                }
            }
        }
    }
}

TEST(AngleJoint, ARatchetAndALimitHoldTogether) {
    Turntable t({.limit = {.enable = true, .lower = -1, .upper = 1.1f}, .ratchet = {.step = 0.5f}});
    for (int i = 0; i < 120; ++i) {
        t.w->apply_torque(t.disc, 3);
        t.step();
        ASSERT_LT(t.angle(), 1.105f);
    }
    EXPECT_NEAR(t.angle(), 1.1f, 0.005f);
    for (int i = 0; i < 120; ++i) {
        t.w->apply_torque(t.disc, -3);
        t.step();
    }
    EXPECT_NEAR(t.angle(), 1, 0.005f);
    t.w->set_ratchet(t.joint, {});
    for (int i = 0; i < 240; ++i) {
        t.w->apply_torque(t.disc, -3);
        t.step();
    }
    EXPECT_NEAR(t.angle(), -1, 0.005f) << "without a ratchet the limit alone holds";
}

TEST(AngleJoint, IsReadBackAsItWasMade) {
    Turntable t({.spring = {true, 3, 0.5f, 0.2f}, .limit = {true, -1, 2}, .motor = {true, 4, 5}, .friction = 6, .ratchet = {0.25f, 0.1f}});
    EXPECT_EQ(t.w->joint_type(t.joint), JointType::angle);
    EXPECT_EQ(t.w->spring(t.joint).hertz, 3);
    EXPECT_EQ(t.w->limit(t.joint).upper, 2);
    EXPECT_EQ(t.w->motor(t.joint).max_force, 5);
    EXPECT_EQ(t.w->joint_friction(t.joint), 6);
    EXPECT_EQ(t.w->ratchet(t.joint).step, 0.25f);
    EXPECT_EQ(t.w->ratchet(t.joint).phase, 0.1f);
    EXPECT_EQ(t.w->last_error(), Error::none);
}

TEST(AngleJoint, RefusesStepsThatAreNone) {
    Turntable t;
    const float nan = __builtin_nanf("");
    for (const JointRatchet bad : {JointRatchet{0.0005f}, JointRatchet{-0.0005f}, JointRatchet{101}, JointRatchet{nan}, JointRatchet{1, nan}}) {
        const std::uint64_t before = t.w->hash();
        EXPECT_FALSE(t.w->create_joint(AngleJointDef{.base = {.body_a = t.ground, .body_b = t.disc}, .ratchet = bad}));
        EXPECT_NE(t.w->last_error(), Error::none);
        t.w->clear_error();
        t.w->set_ratchet(t.joint, bad);
        EXPECT_NE(t.w->last_error(), Error::none);
        t.w->clear_error();
        EXPECT_EQ(t.w->hash(), before);
    }
}

/// Ten discs in a row, each tied to the next by an angle joint with other parts: so that lanes beside each other differ.
void build_row(World& w) {
    BodyId last = w.create_body({});
    for (int i = 0; i < 10; ++i) {
        const float x = static_cast<float>(i);
        const BodyId body = w.create_body({.type = BodyType::dynamic, .position = {3 * x, 0}, .angular_velocity = 3 - x});
        w.create_shape(body, Circle{{}, 1}, {.density = 1 + x});
        AngleJointDef def{.base = {.body_a = last, .body_b = body}};
        if (i % 2 == 1) def.spring = {.enable = true, .hertz = 1 + x, .damping_ratio = 0.1f, .target = 0.1f * x};
        if (i % 3 == 1) def.limit = {.enable = true, .lower = -0.3f, .upper = 0.2f};
        if (i % 3 == 2) def.motor = {.enable = true, .speed = x - 4, .max_force = 2};
        if (i % 4 == 3) def.friction = 1;
        if (i % 2 == 0) def.ratchet = {.step = i % 4 == 0 ? 0.2f : -0.3f, .phase = 0.05f};
        w.create_joint(def);
        last = body;
    }
}

TEST(AngleJoint, GivesTheSameBitsForEveryWidthOfLanes) {
    std::vector<std::uint64_t> hashes;
    for (const std::uint32_t lanes : {1u, 4u, 8u, 16u}) {
        Storage storage;
        World& w = storage.create({.gravity = {0, -1}, .lanes = lanes});
        build_row(w);
        for (int i = 0; i < 200; ++i) w.step(dt);
        hashes.push_back(w.hash());
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

TEST(AngleJoint, IsSavedLoadedAndReplayed) {
    Storage first, second;
    World& w = first.create({.gravity = {0, -1}});
    alignas(8) static std::array<std::byte, 1 << 20> recording;
    ASSERT_TRUE(w.start_recording(recording));
    build_row(w);
    for (int i = 0; i < 100; ++i) w.step(dt);
    w.set_ratchet(w.joint_at(0), {.step = -0.7f, .phase = 0.1f});
    w.set_limit(w.joint_at(1), {});
    alignas(16) static std::array<std::byte, 1 << 18> image;
    const std::size_t bytes = w.save(image);
    ASSERT_GT(bytes, 0u);
    World& loaded = second.create();
    ASSERT_TRUE(loaded.load(std::span(image).first(bytes))) << describe(loaded.last_error());
    EXPECT_EQ(loaded.hash(), w.hash());
    for (int i = 0; i < 100; ++i) {
        w.step(dt);
        loaded.step(dt);
    }
    EXPECT_EQ(loaded.hash(), w.hash());
    EXPECT_EQ(w.validate(), nullptr);
    const std::size_t written = w.stop_recording();
    ASSERT_GT(written, 0u);
    World& again = second.create();
    const ReplayResult result = replay(again, std::span<const std::byte>(recording).first(written));
    EXPECT_EQ(result.end, ReplayEnd::complete);
    EXPECT_EQ(result.steps, 200u);
    EXPECT_EQ(again.hash(), w.hash());
}

}  // namespace
