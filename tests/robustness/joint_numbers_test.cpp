// Every number in every definition of a joint and every setter, beyond each end of what is allowed: refused. At the ends: taken.
#include <cmath>
#include <string>

#include "refusal.hpp"
#include "support/joint_world.hpp"

namespace {

using namespace islet;
using namespace islet::test;

constexpr float least = std::numeric_limits<float>::denorm_min();  // above 0
constexpr float slop = 0.005f;

/// A number in a definition, and what it may be.
template <class Def>
struct Field {
    std::string name;
    float& (*of)(Def&);
    float low = -most, high = most;
};

class BadJointNumber : public RefusalTest {
protected:
    BadJointNumber() {
        a = w.add_box({0, 20});
        b = w.add_box({3, 20});
        base.body_a = a;
        base.body_b = b;
        machine = add_machine(*w, {40, 0});
        w.step();
        w.errors.clear();
    }

    /// `with(x)` calls the world with x in the place looked at; `undo()` takes back what was taken.
    template <class With, class Undo>
    void expect_range(float low, float high, With&& with, Undo&& undo) {
        for (const float bad : not_finite) expect_refused(Error::not_finite, [&] { with(bad); });
        if (low > -most) {
            for (const float bad : {std::nextafter(low, -most), low - 1, -most}) expect_refused(Error::out_of_range, [&] { with(bad); });
        }
        if (high < most) {
            for (const float bad : {std::nextafter(high, most), 2 * high, most}) expect_refused(Error::out_of_range, [&] { with(bad); });
        }
        for (const float good : {low, high}) {
            w.errors.clear();
            with(good);
            EXPECT_TRUE(w.errors.empty()) << good << " was refused: " << describe(w->last_error());
            EXPECT_EQ(w->validate(), nullptr);
            undo();
        }
    }

    /// Fields of the definition, and those of its base if it has one.
    template <class Def>
    void expect_fields(const Def& good, std::initializer_list<Field<Def>> own) {
        std::vector<Field<Def>> fields = own;
        if constexpr (requires { &Def::base; }) {
            const std::vector<Field<Def>> of_base = {
                {"frame_a.x", [](Def& d) -> float& { return d.base.frame_a.position.x; }, -max_position, max_position},
                {"frame_a.y", [](Def& d) -> float& { return d.base.frame_a.position.y; }, -max_position, max_position},
                {"frame_a.angle", [](Def& d) -> float& { return d.base.frame_a.angle; }},
                {"frame_b.x", [](Def& d) -> float& { return d.base.frame_b.position.x; }, -max_position, max_position},
                {"frame_b.y", [](Def& d) -> float& { return d.base.frame_b.position.y; }, -max_position, max_position},
                {"frame_b.angle", [](Def& d) -> float& { return d.base.frame_b.angle; }},
                {"break_force", [](Def& d) -> float& { return d.base.break_force; }, 0},
                {"break_torque", [](Def& d) -> float& { return d.base.break_torque; }, 0},
            };
            fields.insert(fields.end(), of_base.begin(), of_base.end());
        }
        for (const Field<Def>& field : fields) {
            SCOPED_TRACE(field.name);
            JointId made;
            expect_range(
                field.low, field.high,
                [&](float x) {
                    Def def = good;
                    field.of(def) = x;
                    made = w->create_joint(def);
                    EXPECT_EQ(bool(made), w.errors.empty());
                },
                [&] { w->destroy_joint(made); });
        }
    }

    /// What the joints with a coordinate share.
    template <class Def>
    void expect_coordinate(const Def& good) {
        expect_fields<Def>(good, {
                                     {"spring.hertz", [](Def& d) -> float& { return d.spring.hertz; }, 0},
                                     {"spring.damping_ratio", [](Def& d) -> float& { return d.spring.damping_ratio; }, 0},
                                     {"spring.target", [](Def& d) -> float& { return d.spring.target; }},
                                     {"motor.speed", [](Def& d) -> float& { return d.motor.speed; }},
                                     {"motor.max_force", [](Def& d) -> float& { return d.motor.max_force; }, 0},
                                 });
        Def limited = good;
        limited.limit = {.enable = true, .lower = 1, .upper = 2};
        const float lowest = std::is_same_v<Def, DistanceJointDef> ? 0 : -most;
        const auto of_lower = [](Def& d) -> float& { return d.limit.lower; };
        const auto of_upper = [](Def& d) -> float& { return d.limit.upper; };
        expect_fields<Def>(limited, {{"limit.lower", of_lower, lowest, 2}, {"limit.upper", of_upper, 1, most}});
        if constexpr (requires { &Def::friction; })
            expect_fields<Def>(good, {{"friction", [](Def& d) -> float& { return d.friction; }, 0}});
    }

    template <class Set>
    void expect_setter(const char* name, float low, float high, Set&& set) {
        SCOPED_TRACE(name);
        expect_range(low, high, set, [] {});
    }

    BodyId a, b;
    JointBase base;
    Machine machine;
};

TEST_F(BadJointNumber, InAHinge) { expect_coordinate(RevoluteJointDef{.base = base}); }
TEST_F(BadJointNumber, InASlider) { expect_coordinate(PrismaticJointDef{.base = base}); }
TEST_F(BadJointNumber, InAWheel) { expect_coordinate(WheelJointDef{.base = base}); }

TEST_F(BadJointNumber, InAnAngleJoint) {
    using Def = AngleJointDef;
    expect_coordinate(Def{.base = base});
    expect_fields<Def>({.base = base, .ratchet = {.step = 1}},
                       {{"ratchet.phase", [](Def& d) -> float& { return d.ratchet.phase; }, -1e4f, 1e4f}});
}

TEST_F(BadJointNumber, InARod) {
    expect_coordinate(DistanceJointDef{.base = base, .length = 3});
    expect_fields<DistanceJointDef>({.base = base},
                                    {{"length", [](DistanceJointDef& d) -> float& { return d.length; }, slop, max_position}});
}

TEST_F(BadJointNumber, InAWeld) {
    using Def = WeldJointDef;
    expect_fields<Def>({.base = base}, {
                                           {"linear_hertz", [](Def& d) -> float& { return d.linear_hertz; }, 0},
                                           {"linear_damping_ratio", [](Def& d) -> float& { return d.linear_damping_ratio; }, 0},
                                           {"angular_hertz", [](Def& d) -> float& { return d.angular_hertz; }, 0},
                                           {"angular_damping_ratio", [](Def& d) -> float& { return d.angular_damping_ratio; }, 0},
                                       });
}

TEST_F(BadJointNumber, InAMotor) {
    using Def = MotorJointDef;
    expect_fields<Def>({.base = base}, {
                                           {"linear_velocity.x", [](Def& d) -> float& { return d.linear_velocity.x; }},
                                           {"linear_velocity.y", [](Def& d) -> float& { return d.linear_velocity.y; }},
                                           {"angular_velocity", [](Def& d) -> float& { return d.angular_velocity; }},
                                           {"max_force", [](Def& d) -> float& { return d.max_force; }, 0},
                                           {"max_torque", [](Def& d) -> float& { return d.max_torque; }, 0},
                                           {"linear_hertz", [](Def& d) -> float& { return d.linear_hertz; }, 0},
                                           {"linear_damping_ratio", [](Def& d) -> float& { return d.linear_damping_ratio; }, 0},
                                           {"angular_hertz", [](Def& d) -> float& { return d.angular_hertz; }, 0},
                                           {"angular_damping_ratio", [](Def& d) -> float& { return d.angular_damping_ratio; }, 0},
                                       });
}

TEST_F(BadJointNumber, InAMouse) {
    using Def = MouseJointDef;
    expect_fields<Def>({.body = b}, {
                                        {"target.x", [](Def& d) -> float& { return d.target.x; }, -max_position, max_position},
                                        {"target.y", [](Def& d) -> float& { return d.target.y; }, -max_position, max_position},
                                        {"hertz", [](Def& d) -> float& { return d.hertz; }, least},
                                        {"damping_ratio", [](Def& d) -> float& { return d.damping_ratio; }, 0},
                                        {"max_force", [](Def& d) -> float& { return d.max_force; }, 0},
                                    });
}

TEST_F(BadJointNumber, InAPulley) {
    using Def = PulleyJointDef;
    const Def good{.base = base, .ground_a = {0, 30}, .ground_b = {5, 30}};
    expect_fields<Def>(good, {
                                 {"ground_a.x", [](Def& d) -> float& { return d.ground_a.x; }, -max_position, max_position},
                                 {"ground_a.y", [](Def& d) -> float& { return d.ground_a.y; }, -max_position, max_position},
                                 {"ground_b.x", [](Def& d) -> float& { return d.ground_b.x; }, -max_position, max_position},
                                 {"ground_b.y", [](Def& d) -> float& { return d.ground_b.y; }, -max_position, max_position},
                                 {"ratio", [](Def& d) -> float& { return d.ratio; }, least, max_ratio},
                             });
}

TEST_F(BadJointNumber, InAGear) {
    using Def = GearJointDef;
    const Def good{.joint1 = machine[JointType::revolute], .joint2 = machine[JointType::prismatic]};
    expect_fields<Def>(good, {
                                 {"ratio", [](Def& d) -> float& { return d.ratio; }, -max_ratio, max_ratio},
                                 {"break_torque", [](Def& d) -> float& { return d.break_torque; }, 0},
                             });
    for (const float zero : {0.0f, -0.0f}) {
        Def bad = good;
        bad.ratio = zero;
        expect_refused(Error::out_of_range, [&] { EXPECT_FALSE(w->create_joint(bad)); });
    }
}

TEST_F(BadJointNumber, InASetter) {
    for (const JointType type : {JointType::revolute, JointType::prismatic, JointType::distance, JointType::wheel, JointType::angle}) {
        SCOPED_TRACE(name_of(type));
        const JointId j = machine[type];
        expect_setter("spring.hertz", 0, most, [&](float x) { w->set_spring(j, {true, x, 1, 0}); });
        expect_setter("spring.damping_ratio", 0, most, [&](float x) { w->set_spring(j, {true, 1, x, 0}); });
        expect_setter("spring.target", -most, most, [&](float x) { w->set_spring(j, {true, 1, 1, x}); });
        expect_setter("motor.speed", -most, most, [&](float x) { w->set_motor(j, {true, x, 1}); });
        expect_setter("motor.max_force", 0, most, [&](float x) { w->set_motor(j, {true, 1, x}); });
        expect_setter("limit.lower", type == JointType::distance ? 0 : -most, 2, [&](float x) { w->set_limit(j, {true, x, 2}); });
        expect_setter("limit.upper", 1, most, [&](float x) { w->set_limit(j, {true, 1, x}); });
        if (type != JointType::distance) expect_setter("friction", 0, most, [&](float x) { w->set_joint_friction(j, x); });
    }
    for (const JointType type : joint_types) {
        SCOPED_TRACE(name_of(type));
        const JointId j = machine[type];
        expect_setter("break force", 0, most, [&](float x) { w->set_break(j, x, 1); });
        expect_setter("break torque", 0, most, [&](float x) { w->set_break(j, 1, x); });
        if (type == JointType::mouse || type == JointType::pulley || type == JointType::gear) continue;
        const float far = max_position;
        expect_setter("frame_a.x", -far, far, [&](float x) { w->set_frames(j, {{x, 0}, 0}, {}); });
        expect_setter("frame_a.y", -far, far, [&](float x) { w->set_frames(j, {{0, x}, 0}, {}); });
        expect_setter("frame_a.angle", -most, most, [&](float x) { w->set_frames(j, {{}, x}, {}); });
        expect_setter("frame_b.x", -far, far, [&](float x) { w->set_frames(j, {}, {{x, 0}, 0}); });
        expect_setter("frame_b.y", -far, far, [&](float x) { w->set_frames(j, {}, {{0, x}, 0}); });
        expect_setter("frame_b.angle", -most, most, [&](float x) { w->set_frames(j, {}, {{}, x}); });
    }
    const JointId rod = machine[JointType::distance], motor = machine[JointType::motor], mouse = machine[JointType::mouse];
    expect_setter("length", slop, max_position, [&](float x) { w->set_joint_length(rod, x); });
    expect_setter("velocity.x", -most, most, [&](float x) { w->set_joint_velocity(motor, {x, 0}, 0); });
    expect_setter("velocity.y", -most, most, [&](float x) { w->set_joint_velocity(motor, {0, x}, 0); });
    expect_setter("angular velocity", -most, most, [&](float x) { w->set_joint_velocity(motor, {}, x); });
    expect_setter("max_force", 0, most, [&](float x) { w->set_joint_strength(motor, x, 1); });
    expect_setter("max_torque", 0, most, [&](float x) { w->set_joint_strength(motor, 1, x); });
    expect_setter("target.x", -max_position, max_position, [&](float x) { w->set_target(mouse, {x, 0}); });
    expect_setter("target.y", -max_position, max_position, [&](float x) { w->set_target(mouse, {0, x}); });
}

}  // namespace
