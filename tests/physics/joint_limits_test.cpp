// A limit holds where it was set, whatever drives the joint against it.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>

#include "measure.hpp"

namespace islet::test {
namespace {

constexpr double tolerance = 0.005;  // rad or m: 5 mm at the end of a door of 1 m

enum class Kind { hinge, slider, wheel, rope };
enum class Drive { motor, load };

class Limit : public testing::TestWithParam<std::tuple<Kind, Drive, float, bool>> {};

TEST_P(Limit, HoldsWhereItIsSet) {
    const auto [kind, drive, mass, side_up] = GetParam();
    const bool up = side_up || (kind == Kind::rope && drive == Drive::load);  // a rod under a load from above tips over
    for (int start = 0; start < 10; ++start) {
        WorldDef def = sleepless();
        if (drive == Drive::motor) def.gravity = {0, 0};
        TestWorld world(roomy, def);
        const BodyId ground = world->create_body({});
        const float side = up ? 1.0f : -1.0f, limit = 0.3f + 0.13f * static_cast<float>(start);
        const BodyId door = world.add(make_box(0.5f, 0.1f), dynamic_at({kind == Kind::hinge ? 0.5f : kind == Kind::rope ? 0.2f : 0, 0}), dense(mass / 0.2f));
        const JointLimit bounds = {.enable = true, .lower = up ? -2.0f : -limit, .upper = up ? limit : 2.0f};
        // 50 N or N m, and in proportion to what is heavier.
        const JointMotor motor = {.enable = drive == Drive::motor, .speed = 2 * side, .max_force = std::fmax(50.0f, 50 * mass)};
        JointBase base = {.body_a = ground, .body_b = door};
        JointId joint;
        switch (kind) {
        case Kind::hinge:
            base.frame_b.position = {-0.5f, 0};
            joint = world->create_joint(RevoluteJointDef{.base = base, .limit = bounds, .motor = motor});
            break;
        case Kind::slider: joint = world->create_joint(PrismaticJointDef{.base = base, .limit = bounds, .motor = motor}); break;
        case Kind::wheel:
            joint = world->create_joint(WheelJointDef{.base = base, .spring = {.enable = false}, .limit = bounds});
            break;
        case Kind::rope:
            joint = world->create_joint(DistanceJointDef{.base = base, .length = 1, .limit = {.enable = true, .lower = up ? 0 : limit, .upper = up ? limit : 5}, .motor = motor});
            break;
        }
        // The load hangs on the door, and is 10 times as heavy; a slider's and a wheel's axis is A's x: gravity pulls along it.
        if (drive == Drive::load) {
            if (kind != Kind::hinge) world->set_gravity({10 * side, 0});
            if (kind == Kind::hinge && up) world->set_gravity({0, 10});
            const BodyId load = world.add(Circle{{}, 0.2f}, dynamic_at({kind == Kind::hinge ? 1.0f : kind == Kind::rope ? 0.5f : 0.3f * side, 0}), dense(10 * mass / (pi * 0.04f)));
            JointBase hung = {.body_a = door, .body_b = load, .frame_a = {{kind == Kind::hinge ? 0.5f : 0.3f * side, 0}, {}}};
            world->create_joint(RevoluteJointDef{.base = hung});
        }
        if (kind == Kind::rope && !up) world->set_transform(door, {limit + 0.5f, 0}, 0);
        double farthest = 0;
        for (int i = 0; i < 600; ++i) {
            if (kind == Kind::wheel && drive == Drive::motor) world->apply_force_to_center(door, {side * motor.max_force, 0});
            world.step();
            if (i > 400) farthest = std::fmax(farthest, std::fabs(double(world->joint_position(joint)) - double(up || kind == Kind::rope ? limit : -limit)));
        }
        EXPECT_LT(farthest, tolerance) << "start " << start;
        ASSERT_EQ(world.errors.size(), 0u);
    }
}

std::string name_of_limit(const testing::TestParamInfo<Limit::ParamType>& test) {
    constexpr const char* kinds[] = {"hinge", "slider", "wheel", "rope"};
    return std::string(kinds[int(std::get<0>(test.param))]) + (std::get<1>(test.param) == Drive::motor ? "_driven_" : "_loaded_") +
           std::to_string(int(10 * std::get<2>(test.param))) + "_hg_" + (std::get<3>(test.param) ? "upper" : "lower");
}
INSTANTIATE_TEST_SUITE_P(Joints, Limit,
                         testing::Combine(testing::Values(Kind::hinge, Kind::slider, Kind::wheel, Kind::rope), testing::Values(Drive::motor, Drive::load),
                                          testing::Values(0.2f, 2.0f, 50.0f, 1000.0f), testing::Bool()),
                         name_of_limit);

}  // namespace
}  // namespace islet::test
