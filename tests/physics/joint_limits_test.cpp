// A limit holds where it was set, whatever drives the joint against it.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>

#include "measure.hpp"

namespace islet::test {
namespace {

constexpr double tolerance = 0.005;  // rad or m: 5 mm at the end of a door of 1 m

enum class LimitOn { hinge, slider, wheel, rope };
enum class Drive { motor, load };

class Limit : public testing::TestWithParam<std::tuple<LimitOn, Drive, float, bool>> {};

TEST_P(Limit, HoldsWhereItIsSet) {
    const auto [kind, drive, mass, side_up] = GetParam();
    const bool up = side_up || (kind == LimitOn::rope && drive == Drive::load);  // a rod under a load from above tips over
    for (int start = 0; start < 10; ++start) {
        WorldDef def = sleepless();
        if (drive == Drive::motor) def.gravity = {0, 0};
        TestWorld world(roomy, def);
        const BodyId ground = world->create_body({});
        const float side = up ? 1.0f : -1.0f, limit = 0.3f + 0.13f * static_cast<float>(start);
        const BodyId door = world.add(make_box(0.5f, 0.1f), dynamic_at({kind == LimitOn::hinge ? 0.5f : kind == LimitOn::rope ? 0.2f : 0, 0}), dense(mass / 0.2f));
        const JointLimit bounds = {.enable = true, .lower = up ? -2.0f : -limit, .upper = up ? limit : 2.0f};
        // 50 N or N m, and in proportion to what is heavier.
        const JointMotor motor = {.enable = drive == Drive::motor, .speed = 2 * side, .max_force = std::fmax(50.0f, 50 * mass)};
        JointBase base = {.body_a = ground, .body_b = door};
        JointId joint;
        switch (kind) {
        case LimitOn::hinge:
            base.frame_b.position = {-0.5f, 0};
            joint = world->create_joint(RevoluteJointDef{.base = base, .limit = bounds, .motor = motor});
            break;
        case LimitOn::slider: joint = world->create_joint(PrismaticJointDef{.base = base, .limit = bounds, .motor = motor}); break;
        case LimitOn::wheel:
            joint = world->create_joint(WheelJointDef{.base = base, .spring = {.enable = false}, .limit = bounds});
            break;
        case LimitOn::rope:
            joint = world->create_joint(DistanceJointDef{.base = base, .length = 1, .limit = {.enable = true, .lower = up ? 0 : limit, .upper = up ? limit : 5}, .motor = motor});
            break;
        }
        // The load hangs on the door, and is 10 times as heavy; a slider's and a wheel's axis is A's x: gravity pulls along it.
        if (drive == Drive::load) {
            if (kind != LimitOn::hinge) world->set_gravity({10 * side, 0});
            if (kind == LimitOn::hinge && up) world->set_gravity({0, 10});
            const BodyId load = world.add(Circle{{}, 0.2f}, dynamic_at({kind == LimitOn::hinge ? 1.0f : kind == LimitOn::rope ? 0.5f : 0.3f * side, 0}), dense(10 * mass / (pi * 0.04f)));
            JointBase hung = {.body_a = door, .body_b = load, .frame_a = {{kind == LimitOn::hinge ? 0.5f : 0.3f * side, 0}, {}}};
            world->create_joint(RevoluteJointDef{.base = hung});
        }
        if (kind == LimitOn::rope && !up) world->set_transform(door, {limit + 0.5f, 0}, 0);
        // What is driven is at its limit from its arrival on. What falls arrives with a blow and rebounds: the limit stops it within one step's way, takes at least
        // half of its energy, so that it gets up no more than half as high, and it is at its limit after two thirds of ten seconds.
        const double at = double(up || kind == LimitOn::rope ? limit : -limit), outwards = up ? 1 : -1;
        bool arrived = false;
        double farthest = 0, beyond = 0, rebound = 0;
        for (int i = 0; i < 600; ++i) {
            if (kind == LimitOn::wheel && drive == Drive::motor) world->apply_force_to_center(door, {side * motor.max_force, 0});
            world.step();
            const double past = outwards * (double(world->joint_position(joint)) - at);
            arrived = arrived || past > -tolerance;
            if (!arrived) continue;
            beyond = std::fmax(beyond, past);
            rebound = std::fmax(rebound, -past);
            if (drive == Drive::motor || i > 400) farthest = std::fmax(farthest, std::fabs(past));
        }
        EXPECT_TRUE(arrived) << "start " << start;
        EXPECT_LT(farthest, tolerance) << "start " << start;
        if (drive == Drive::load) {
            // Where it has fallen, m; the squared speed on arrival is 2 g times that, and for the hinge 10.5 / 10.34 of it: moment by moment of inertia.
            const auto depth = [swings = kind == LimitOn::hinge](double x) { return swings ? std::sin(x) : x; };
            const double fall = depth(kind == LimitOn::rope ? double(limit) - 0.2 : double(limit));
            EXPECT_LT(beyond, std::sqrt(20 * fall * 10.5 / 10.34) / 60 + tolerance) << "start " << start;
            EXPECT_LT(depth(double(limit)) - depth(double(limit) - rebound), 0.5 * fall + tolerance) << "start " << start;
        }
        ASSERT_EQ(world.errors.size(), 0u);
    }
}

// The part of a steady force F that the limit does not yet take for its load, F exp(-t / T), presses the joint past the limit by its share of F / (m (2 pi hertz)^2).
constexpr double load_time = 128.0 / 60;  // s, T

/// A slider of which 100 m/s^2 pull at its limit, where it begins.
struct Pulled {
    TestWorld world;
    JointId slider;
    Pulled() : world(roomy, definition()) {
        const BodyId ground = world->create_body({}), box = world.add_box({0, 0});
        slider = world->create_joint(PrismaticJointDef{.base = {.body_a = ground, .body_b = box}, .limit = {.enable = true, .lower = -1, .upper = 0}});
    }
    static WorldDef definition() {
        WorldDef def = sleepless();
        def.gravity = {100, 0};
        return def;
    }
    double past_after(double seconds, float dt) {
        world.step(static_cast<int>(std::lround(seconds / double(dt))), dt);
        return double(world->joint_position(slider));
    }
};

TEST(LimitLoad, ALimitTakesUpItsLoadInTheSameTimeWhateverTheTimeStep) {
    for (const float dt : {1.0f / 480, 1.0f / 240, 1.0f / 60, 1.0f / 30}) {
        Pulled pulled;
        const double early = pulled.past_after(0.5, dt), late = pulled.past_after(1.5, dt);
        EXPECT_GT(early, 1e-4) << "dt 1/" << std::lround(1 / dt);
        // The mean is an Euler step at a time: off by dt / 2T in the exponent.
        EXPECT_NEAR(late / early, std::exp(-1.5 / load_time), 0.03) << "dt 1/" << std::lround(1 / dt);
    }
}

TEST(LimitLoad, ALimitHoldsItsLoadWhenTheTimeStepChanges) {
    for (const float then : {1.0f / 240, 1.0f / 120, 1.0f / 30, 1.0f / 15}) {
        Pulled pulled;
        pulled.past_after(20, 1.0f / 60);
        const double hertz = std::fmin(60, 1 / double(then)), give = 100 / (2 * double(pi) * hertz * 2 * double(pi) * hertz);  // a quarter of 4 substeps
        double farthest = 0;
        for (int i = 0; i < 20; ++i) farthest = std::fmax(farthest, std::fabs(pulled.past_after(0.1, then)));
        EXPECT_LT(farthest, 0.05 * give) << "then 1/" << std::lround(1 / then);
    }
}

std::string name_of_limit(const testing::TestParamInfo<Limit::ParamType>& test) {
    constexpr const char* kinds[] = {"hinge", "slider", "wheel", "rope"};
    return std::string(kinds[int(std::get<0>(test.param))]) + (std::get<1>(test.param) == Drive::motor ? "_driven_" : "_loaded_") +
           std::to_string(int(10 * std::get<2>(test.param))) + "_hg_" + (std::get<3>(test.param) ? "upper" : "lower");
}
INSTANTIATE_TEST_SUITE_P(Joints, Limit,
                         testing::Combine(testing::Values(LimitOn::hinge, LimitOn::slider, LimitOn::wheel, LimitOn::rope), testing::Values(Drive::motor, Drive::load),
                                          testing::Values(0.2f, 2.0f, 50.0f, 1000.0f), testing::Bool()),
                         name_of_limit);

}  // namespace
}  // namespace islet::test
