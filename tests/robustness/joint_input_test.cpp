// Bad arguments to every public function on joints: ids, types, bodies. Numbers are in joint_numbers_test.cpp.
#include <functional>

#include "refusal.hpp"
#include "support/joint_world.hpp"

namespace {

using namespace islet;
using namespace islet::test;

constexpr std::uint32_t bit(JointType type) { return 1u << static_cast<std::uint32_t>(type); }
constexpr std::uint32_t any = (1u << joint_type_count) - 1;
constexpr std::uint32_t sprung =
    bit(JointType::revolute) | bit(JointType::prismatic) | bit(JointType::distance) | bit(JointType::wheel) | bit(JointType::angle);
constexpr std::uint32_t rubbing = sprung & ~bit(JointType::distance);
constexpr std::uint32_t driven = bit(JointType::motor) | bit(JointType::mouse);
constexpr std::uint32_t geared = bit(JointType::pulley) | bit(JointType::gear);
constexpr std::uint32_t framed = sprung | bit(JointType::weld) | bit(JointType::motor);

bool is_zero(const JointSpring& s) { return !s.enable && s.hertz == 0 && s.damping_ratio == 0 && s.target == 0; }
bool is_zero(const JointLimit& l) { return !l.enable && l.lower == 0 && l.upper == 0; }
bool is_zero(const JointMotor& m) { return !m.enable && m.speed == 0 && m.max_force == 0; }
bool is_zero(const JointFrame& f) { return f.position == Vec2{} && f.angle == 0; }
bool is_zero(const JointError& e) { return e.linear == 0 && e.angular == 0; }

struct JointCall {
    const char* name;
    std::uint32_t types;                                   // that have a use for it
    std::function<bool(World&, JointId)> returns_nothing;  // calls it; true if what came back is null or zero
};

const JointCall joint_calls[] = {
    {"joint_type", any, [](World& w, JointId j) { return w.joint_type(j) == JointType{}; }},
    {"body_a", any, [](World& w, JointId j) { return !w.body_a(j); }},
    {"body_b", any, [](World& w, JointId j) { return !w.body_b(j); }},
    {"frame_a", any, [](World& w, JointId j) { return is_zero(w.frame_a(j)); }},
    {"frame_b", any, [](World& w, JointId j) { return is_zero(w.frame_b(j)); }},
    {"set_frames", framed, [](World& w, JointId j) { return w.set_frames(j, {}, {}), true; }},
    {"anchor_a", any, [](World& w, JointId j) { return w.anchor_a(j) == Vec2{}; }},
    {"anchor_b", any, [](World& w, JointId j) { return w.anchor_b(j) == Vec2{}; }},
    {"collide_connected", any, [](World& w, JointId j) { return !w.collide_connected(j); }},
    {"set_collide_connected", framed | bit(JointType::pulley), [](World& w, JointId j) { return w.set_collide_connected(j, true), true; }},
    {"set_break", any, [](World& w, JointId j) { return w.set_break(j, 1e30f, 1e30f), true; }},
    {"user_data", any, [](World& w, JointId j) { return w.user_data(j) == 0; }},
    {"set_user_data", any, [](World& w, JointId j) { return w.set_user_data(j, 1), true; }},
    {"joint_position", sprung, [](World& w, JointId j) { return w.joint_position(j) == 0; }},
    {"joint_speed", sprung, [](World& w, JointId j) { return w.joint_speed(j) == 0; }},
    {"spring", sprung, [](World& w, JointId j) { return is_zero(w.spring(j)); }},
    {"set_spring", sprung, [](World& w, JointId j) { return w.set_spring(j, {.enable = true, .hertz = 3}), true; }},
    {"limit", sprung, [](World& w, JointId j) { return is_zero(w.limit(j)); }},
    {"set_limit", sprung, [](World& w, JointId j) { return w.set_limit(j, {.enable = true, .lower = 0, .upper = 3}), true; }},
    {"motor", sprung, [](World& w, JointId j) { return is_zero(w.motor(j)); }},
    {"set_motor", sprung, [](World& w, JointId j) { return w.set_motor(j, {.enable = true, .speed = 1, .max_force = 1}), true; }},
    {"joint_friction", rubbing, [](World& w, JointId j) { return w.joint_friction(j) == 0; }},
    {"set_joint_friction", rubbing, [](World& w, JointId j) { return w.set_joint_friction(j, 1), true; }},
    {"motor_force", sprung, [](World& w, JointId j) { return w.motor_force(j) == 0; }},
    {"ratchet", bit(JointType::angle), [](World& w, JointId j) { const JointRatchet r = w.ratchet(j); return r.step == 0 && r.phase == 0; }},
    {"set_ratchet", bit(JointType::angle), [](World& w, JointId j) { return w.set_ratchet(j, {.step = 1, .phase = 2}), true; }},
    {"joint_length", bit(JointType::distance), [](World& w, JointId j) { return w.joint_length(j) == 0; }},
    {"set_joint_length", bit(JointType::distance), [](World& w, JointId j) { return w.set_joint_length(j, 3), true; }},
    {"set_joint_velocity", bit(JointType::motor),
     [](World& w, JointId j) {
         return w.set_joint_velocity(j, {1, 2}, 3), true;
     }},
    {"joint_linear_velocity", bit(JointType::motor), [](World& w, JointId j) { return w.joint_linear_velocity(j) == Vec2{}; }},
    {"joint_angular_velocity", bit(JointType::motor), [](World& w, JointId j) { return w.joint_angular_velocity(j) == 0; }},
    {"joint_max_force", driven, [](World& w, JointId j) { return w.joint_max_force(j) == 0; }},
    {"joint_max_torque", driven, [](World& w, JointId j) { return w.joint_max_torque(j) == 0; }},
    {"set_joint_strength", driven, [](World& w, JointId j) { return w.set_joint_strength(j, 1, 2), true; }},
    {"softness", driven | bit(JointType::weld), [](World& w, JointId j) { return w.softness(j).linear_hertz == 0; }},
    {"set_softness", driven | bit(JointType::weld), [](World& w, JointId j) { return w.set_softness(j, {.linear_hertz = 3}), true; }},
    {"joint_ratio", geared, [](World& w, JointId j) { return w.joint_ratio(j) == 0; }},
    {"set_joint_ratio", geared, [](World& w, JointId j) { return w.set_joint_ratio(j, 2), true; }},
    {"joint1", bit(JointType::gear), [](World& w, JointId j) { return !w.joint1(j); }},
    {"joint2", bit(JointType::gear), [](World& w, JointId j) { return !w.joint2(j); }},
    {"break_force", any, [](World& w, JointId j) { return w.break_force(j) == 0; }},
    {"break_torque", any, [](World& w, JointId j) { return w.break_torque(j) == 0; }},
    {"set_grounds", bit(JointType::pulley),
     [](World& w, JointId j) {
         return w.set_grounds(j, {38, 30}, {42, 30}), true;
     }},
    {"target", bit(JointType::mouse), [](World& w, JointId j) { return w.target(j) == Vec2{}; }},
    {"set_target", bit(JointType::mouse),
     [](World& w, JointId j) {
         return w.set_target(j, {1, 2}), true;
     }},
    {"ground_a", bit(JointType::pulley), [](World& w, JointId j) { return w.ground_a(j) == Vec2{}; }},
    {"ground_b", bit(JointType::pulley), [](World& w, JointId j) { return w.ground_b(j) == Vec2{}; }},
    {"joint_force", any, [](World& w, JointId j) { return w.joint_force(j) == Vec2{}; }},
    {"joint_torque", any, [](World& w, JointId j) { return w.joint_torque(j) == 0; }},
    {"joint_error", any, [](World& w, JointId j) { return is_zero(w.joint_error(j)); }},
    {"destroy_joint", any, [](World& w, JointId j) { return w.destroy_joint(j), true; }},
};

/// A world that also holds a machine of all joints in motion, and knows the id of a joint that is gone.
class BadJoint : public RefusalTest {
protected:
    BadJoint() {
        machine = add_machine(*w, {40, 0});
        stale = join(*w, JointType::weld, machine.left, machine.drone);
        w.step(3);
        w->destroy_joint(stale);
        w.step();
        w.errors.clear();
    }
    /// Two boxes in the air that nothing joins.
    BodyId loose_box(float x) { return w.add_box({x, 20}); }

    Machine machine;
    JointId stale;
};

// -- ids -------------------------------------------------------------------------------------------------------------------------------

TEST_F(BadJoint, EveryFunctionRefusesANullOrStaleJoint) {
    const JointId good = machine[JointType::gear];
    const JointId ids[] = {
        {}, stale, {good.index1, good.generation + 2}, {400, 1}, {513, 1}, {0xffffffffu, 1}, {1u << 31, 1}, {good.index1, 0}};
    for (const JointId id : ids) {
        for (const JointCall& call : joint_calls) {
            SCOPED_TRACE(call.name);
            expect_refused(id ? Error::stale_id : Error::null_id, [&] { EXPECT_TRUE(call.returns_nothing(*w, id)); });
        }
        EXPECT_FALSE(w->is_valid(id));
    }
}

TEST_F(BadJoint, EveryFunctionRefusesTypesThatHaveNoUseForIt) {
    int refused = 0;
    for (const JointCall& call : joint_calls) {
        for (const JointType type : joint_types) {
            if ((call.types & bit(type)) != 0) continue;
            SCOPED_TRACE(std::string(call.name) + " of a " + name_of(type) + " joint");
            expect_refused(Error::wrong_joint_type, [&] { EXPECT_TRUE(call.returns_nothing(*w, machine[type])); });
            ++refused;
        }
    }
    EXPECT_GT(refused, 100);
}

TEST_F(BadJoint, EveryFunctionServesTheTypesThatHaveAUseForIt) {
    for (const JointCall& call : joint_calls) {
        if (std::string_view(call.name) == "destroy_joint") continue;  // lest the rest are gone
        for (const JointType type : joint_types) {
            if ((call.types & bit(type)) == 0) continue;
            call.returns_nothing(*w, machine[type]);
            EXPECT_TRUE(w.errors.empty()) << call.name << " of a " << name_of(type) << " joint: " << describe(w->last_error());
            w.errors.clear();
        }
    }
    EXPECT_EQ(w->validate(), nullptr);
}

TEST_F(BadJoint, AskingWhetherAnIdIsValidIsNoError) {
    EXPECT_FALSE(w->is_valid(JointId{}));
    EXPECT_FALSE(w->is_valid(stale));
    EXPECT_TRUE(w->is_valid(machine[JointType::mouse]));
    EXPECT_FALSE(w->joint_at(511));
    EXPECT_FALSE(w->joint_at(512));
    EXPECT_FALSE(w->joint_at(0xffffffffu));
    EXPECT_EQ(w->joint_count(), joint_type_count);
    EXPECT_TRUE(w.errors.empty());
}

TEST_F(BadJoint, AnIdFromBeforeItsSlotWasUsedAgainStaysStale) {
    const JointId reborn = join(*w, JointType::weld, machine.left, machine.drone);
    EXPECT_EQ(reborn.index1, stale.index1);
    EXPECT_EQ(w->joint_at(reborn.index1 - 1), reborn);
    expect_refused(Error::stale_id, [&] { w->destroy_joint(stale); });
    EXPECT_TRUE(w->is_valid(reborn));
}

TEST_F(BadJoint, TheListOfABodysJointsNeedsABody) {
    JointId out[4];
    expect_refused(Error::null_id, [&] { EXPECT_EQ(w->joints({}, out), 0u); });
    expect_refused(Error::stale_id, [&] { EXPECT_EQ(w->joints(stale_body, out), 0u); });
    // As far as they fit; the count is of all.
    EXPECT_EQ(w->joints(machine.drone, {}), 2u);
    EXPECT_EQ(w->joints(machine.drone, std::span(out).first(1)), 2u);
    EXPECT_EQ(out[0], machine[JointType::mouse]) << "newest first";
    EXPECT_EQ(out[1], JointId{});
    EXPECT_EQ(w->joints(ground, out), 0u);
}

// -- bodies ----------------------------------------------------------------------------------------------------------------------------

// Runs a call for a joint of every type that ties two bodies.
template <class Call>
void for_each_tie(Call&& call) {
    for (const JointType type : joint_types) {
        if (type == JointType::mouse || type == JointType::gear) continue;
        SCOPED_TRACE(name_of(type));
        call(type);
    }
}

TEST_F(BadJoint, BodiesMustBeLive) {
    for (const BodyId bad : {BodyId{}, stale_body, BodyId{0xffffffffu, 3}, BodyId{600, 1}}) {
        const Error error = bad ? Error::stale_id : Error::null_id;
        JointBase first{.body_a = bad, .body_b = box}, second{.body_a = box, .body_b = bad};
        for (const JointBase& base : {first, second}) {
            expect_refused(error, [&] { EXPECT_FALSE(w->create_joint(RevoluteJointDef{.base = base})); });
            expect_refused(error, [&] { EXPECT_FALSE(w->create_joint(PrismaticJointDef{.base = base})); });
            expect_refused(error, [&] { EXPECT_FALSE(w->create_joint(DistanceJointDef{.base = base})); });
            expect_refused(error, [&] { EXPECT_FALSE(w->create_joint(WeldJointDef{.base = base})); });
            expect_refused(error, [&] { EXPECT_FALSE(w->create_joint(WheelJointDef{.base = base})); });
            expect_refused(error, [&] { EXPECT_FALSE(w->create_joint(MotorJointDef{.base = base})); });
            expect_refused(error, [&] { EXPECT_FALSE(w->create_joint(AngleJointDef{.base = base})); });
            expect_refused(error, [&] { EXPECT_FALSE(w->create_joint(PulleyJointDef{.base = base, .ground_a = {0, 50}})); });
        }
        expect_refused(error, [&] { EXPECT_FALSE(w->create_joint(MouseJointDef{.body = bad})); });
    }
}

TEST_F(BadJoint, ABodyCannotBeJoinedToItself) {
    for (const BodyId body : {box, ground, sleeper})
        for_each_tie([&](JointType type) { expect_refused(Error::same_body, [&] { EXPECT_FALSE(join(*w, type, body, body)); }); });
}

TEST_F(BadJoint, OneOfTheBodiesMustBeDynamic) {
    const BodyId wall = w.add_box({30, 5}, 1, 1, {}, BodyType::static_body);
    const BodyId lift = w.add_box({33, 5}, 1, 1, {}, BodyType::kinematic);
    const BodyId door = w.add_box({36, 5}, 1, 1, {}, BodyType::kinematic);
    for (const auto& [a, b] : {std::pair{ground, wall}, {wall, lift}, {lift, wall}, {lift, door}})
        for_each_tie(
            [&, a = a, b = b](JointType type) { expect_refused(Error::no_dynamic_body, [&] { EXPECT_FALSE(join(*w, type, a, b)); }); });
    for (const BodyId body : {wall, lift})
        expect_refused(Error::no_dynamic_body, [&] { EXPECT_FALSE(w->create_joint(MouseJointDef{.body = body})); });
}

TEST_F(BadJoint, ARopeOfAPulleyIsAtLeastASlopLong) {
    const BodyId a = loose_box(0), b = loose_box(5);
    PulleyJointDef def{.base = {.body_a = a, .body_b = b}, .ground_a = {0, 25}, .ground_b = {5, 25}};
    for (const float shorter : {0.0f, 0.004f}) {
        PulleyJointDef bad = def;
        bad.ground_a = w->position(a) + Vec2{0, shorter};
        expect_refused(Error::out_of_range, [&] { EXPECT_FALSE(w->create_joint(bad)); });
        bad = def;
        bad.ground_b = w->position(b) + Vec2{shorter, 0};
        expect_refused(Error::out_of_range, [&] { EXPECT_FALSE(w->create_joint(bad)); });
    }
    def.ground_a = w->position(a) + Vec2{0, 0.006f};
    EXPECT_TRUE(w->create_joint(def));
    w.step(30);
    EXPECT_EQ(w->validate(), nullptr);
}

// -- gears -----------------------------------------------------------------------------------------------------------------------------

TEST_F(BadJoint, AGearCouplesHingesAndSlidersOnly) {
    const JointId hinge = machine[JointType::revolute];
    for (const JointType type : joint_types) {
        if (type == JointType::revolute || type == JointType::prismatic) continue;
        SCOPED_TRACE(name_of(type));
        expect_refused(Error::wrong_joint_type, [&] { EXPECT_FALSE(w->create_joint(GearJointDef{hinge, machine[type]})); });
        expect_refused(Error::wrong_joint_type, [&] { EXPECT_FALSE(w->create_joint(GearJointDef{machine[type], hinge})); });
    }
}

TEST_F(BadJoint, AGearsJointsMustBeLive) {
    const JointId hinge = machine[JointType::revolute];
    for (const JointId bad : {JointId{}, stale, JointId{0xffffffffu, 1}}) {
        const Error error = bad ? Error::stale_id : Error::null_id;
        expect_refused(error, [&] { EXPECT_FALSE(w->create_joint(GearJointDef{bad, hinge})); });
        expect_refused(error, [&] { EXPECT_FALSE(w->create_joint(GearJointDef{hinge, bad})); });
    }
}

TEST_F(BadJoint, AGearNeedsTwoBodiesThatMove) {
    const JointId hinge = machine[JointType::revolute];
    expect_refused(Error::same_body, [&] { EXPECT_FALSE(w->create_joint(GearJointDef{hinge, hinge})) << "with itself"; });
    const BodyId a = loose_box(0), b = loose_box(5);
    const JointId left = join(*w, JointType::revolute, a, b), right = join(*w, JointType::prismatic, ground, b);
    expect_refused(Error::same_body, [&] { EXPECT_FALSE(w->create_joint(GearJointDef{left, right})) << "both move b"; });
    const JointId other = join(*w, JointType::revolute, ground, loose_box(9));
    w->set_type(b, BodyType::static_body);
    expect_refused(Error::no_dynamic_body, [&] { EXPECT_FALSE(w->create_joint(GearJointDef{right, other})) << "nothing of right moves"; });
    expect_refused(Error::no_dynamic_body, [&] { EXPECT_FALSE(w->create_joint(GearJointDef{other, right})); });
    EXPECT_TRUE(w->create_joint(GearJointDef{left, other})) << "a moves";
}

}  // namespace
