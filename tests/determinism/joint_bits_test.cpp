// Joints and the bits: what of a joint the hash must notice, and what the bits of a world full of joints may not depend on.
#include <gtest/gtest.h>

#include <bit>
#include <functional>
#include <random>
#include <vector>

#include "support/bits.hpp"
#include "support/joint_world.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

constexpr Capacity machine_capacity{.bodies = 64, .shapes = 64, .contacts = 256, .joints = 64};

struct MachineStage {
    TestWorld world{machine_capacity};
    Machine machine = add_machine(*world, {0, 0});
    MachineStage() { world.step(5); }
    World* operator->() { return world.get(); }
    JointId operator[](JointType type) const { return machine[type]; }
};

struct JointChange {
    const char* name;
    std::function<void(MachineStage&)> apply;
};

// One bit of one number.
std::function<void(MachineStage&)> spring_bit(float JointSpring::*number) {
    return [=](MachineStage& s) {
        JointSpring spring = s->spring(s[JointType::prismatic]);
        spring.*number = next_up(spring.*number);
        s->set_spring(s[JointType::prismatic], spring);
    };
}
std::function<void(MachineStage&)> limit_bit(float JointLimit::*number) {
    return [=](MachineStage& s) {
        JointLimit limit = s->limit(s[JointType::revolute]);
        limit.*number = next_up(limit.*number);
        s->set_limit(s[JointType::revolute], limit);
    };
}
std::function<void(MachineStage&)> motor_bit(float JointMotor::*number) {
    return [=](MachineStage& s) {
        JointMotor motor = s->motor(s[JointType::wheel]);
        motor.*number = next_up(motor.*number);
        s->set_motor(s[JointType::wheel], motor);
    };
}

const JointChange joint_matters[] = {
    {"OneBitOfASpringsFrequency", spring_bit(&JointSpring::hertz)},
    {"OneBitOfASpringsDamping", spring_bit(&JointSpring::damping_ratio)},
    {"OneBitOfASpringsTarget", spring_bit(&JointSpring::target)},
    {"ThatASpringIsOn",
     [](MachineStage& s) {
         JointSpring spring = s->spring(s[JointType::distance]);
         spring.enable = false;
         s->set_spring(s[JointType::distance], spring);
     }},
    {"OneBitOfALowerLimit", limit_bit(&JointLimit::lower)},
    {"OneBitOfAnUpperLimit", limit_bit(&JointLimit::upper)},
    {"ThatALimitIsOn",
     [](MachineStage& s) {
         JointLimit limit = s->limit(s[JointType::wheel]);
         limit.enable = false;
         s->set_limit(s[JointType::wheel], limit);
     }},
    {"OneBitOfAMotorsSpeed", motor_bit(&JointMotor::speed)},
    {"OneBitOfAMotorsForce", motor_bit(&JointMotor::max_force)},
    {"ThatAMotorIsOn",
     [](MachineStage& s) {
         JointMotor motor = s->motor(s[JointType::prismatic]);
         motor.enable = false;
         s->set_motor(s[JointType::prismatic], motor);
     }},
    {"AFriction", [](MachineStage& s) { s->set_joint_friction(s[JointType::revolute], next_up(1)); }},
    {"ALength", [](MachineStage& s) { s->set_joint_length(s[JointType::distance], next_up(2)); }},
    {"AVelocity",
     [](MachineStage& s) {
         s->set_joint_velocity(s[JointType::motor], {0, 1e-45f}, 0.5f);
     }},
    {"AnAngularVelocity", [](MachineStage& s) { s->set_joint_velocity(s[JointType::motor], {}, next_up(0.5f)); }},
    {"AGreatestForce", [](MachineStage& s) { s->set_joint_strength(s[JointType::motor], next_up(8), 1); }},
    {"AGreatestTorque", [](MachineStage& s) { s->set_joint_strength(s[JointType::motor], 8, next_up(1)); }},
    {"ATarget",
     [](MachineStage& s) {
         s->set_target(s[JointType::mouse], {4, next_up(5)});
     }},
    {"ABreakForce", [](MachineStage& s) { s->set_break(s[JointType::weld], 1e9f, 0); }},
    {"ABreakTorque", [](MachineStage& s) { s->set_break(s[JointType::gear], 0, 1e9f); }},
    {"WhetherBodiesCollide", [](MachineStage& s) { s->set_collide_connected(s[JointType::pulley], true); }},
    {"AFrameOfA",
     [](MachineStage& s) {
         JointFrame frame = s->frame_a(s[JointType::weld]);
         frame.position.x = next_up(frame.position.x);
         s->set_frames(s[JointType::weld], frame, s->frame_b(s[JointType::weld]));
     }},
    {"AFrameOfB",
     [](MachineStage& s) {
         JointFrame frame = s->frame_b(s[JointType::weld]);
         frame.angle += 1e-3f;
         s->set_frames(s[JointType::weld], s->frame_a(s[JointType::weld]), frame);
     }},
    {"AJointMore", [](MachineStage& s) { join(*s.world, JointType::weld, s.machine.left, s.machine.drone); }},
    {"AJointFewer", [](MachineStage& s) { s->destroy_joint(s[JointType::gear]); }},
    {"AJointMadeAndDestroyed",  // the next id has another generation
     [](MachineStage& s) { s->destroy_joint(join(*s.world, JointType::weld, s.machine.left, s.machine.drone)); }},
    {"TheOrderOfTwoJoints",
     [](MachineStage& s) {
         const JointId weld = s[JointType::weld];
         WeldJointDef def{
             .base = {.body_a = s->body_a(weld), .body_b = s->body_b(weld), .frame_a = s->frame_a(weld), .frame_b = s->frame_b(weld)}};
         def.linear_hertz = 8;
         def.angular_hertz = 5;
         s->destroy_joint(weld);
         s->create_joint(def);
     }},
};

class JointMatters : public testing::TestWithParam<JointChange> {};

TEST_P(JointMatters, ChangesTheHash) {
    MachineStage plain, changed;
    ASSERT_EQ(plain->hash(), changed->hash());
    GetParam().apply(changed);
    EXPECT_NE(plain->hash(), changed->hash());
    EXPECT_TRUE(changed.world.errors.empty());
}

INSTANTIATE_TEST_SUITE_P(Hash, JointMatters, testing::ValuesIn(joint_matters), [](const auto& test) { return std::string(test.param.name); });

const JointChange joint_does_not_matter[] = {
    {"UserData",
     [](MachineStage& s) {
         for (const JointId j : s.machine.joints) s->set_user_data(j, 0x1234567890abcdefull);
     }},
    {"Reading",
     [](MachineStage& s) {
         for (const JointId j : s.machine.joints) {
             (void)s->joint_force(j);
             (void)s->joint_torque(j);
             (void)s->joint_error(j);
             (void)s->anchor_a(j);
         }
         (void)s->joint_position(s[JointType::revolute]);
         (void)s->joint_speed(s[JointType::distance]);
     }},
    {"ARefusedJoint", [](MachineStage& s) { join(*s.world, JointType::weld, s.machine.left, s.machine.left); }},
    {"ARefusedNumber", [](MachineStage& s) { s->set_joint_friction(s[JointType::revolute], -1); }},
    {"AWrongType",
     [](MachineStage& s) {
         s->set_target(s[JointType::weld], {1, 2});
     }},
};

class JointDoesNotMatter : public testing::TestWithParam<JointChange> {};

TEST_P(JointDoesNotMatter, LeavesTheHashAsItWas) {
    MachineStage plain, changed;
    GetParam().apply(changed);
    EXPECT_EQ(plain->hash(), changed->hash());
    plain.world.step(30);
    changed.world.step(30);
    EXPECT_EQ(plain->hash(), changed->hash()) << "and the future";
}

INSTANTIATE_TEST_SUITE_P(Hash, JointDoesNotMatter, testing::ValuesIn(joint_does_not_matter),
                         [](const auto& test) { return std::string(test.param.name); });

// -- what the bits may not depend on -------------------------------------------------------------------------------------------------------

// Four machines side by side, two of them pushed over, and joints that come and go.
std::vector<std::uint64_t> story(World& w) {
    std::vector<Machine> machines;
    for (int i = 0; i < 4; ++i) machines.push_back(add_machine(w, {30.0f * static_cast<float>(i), 0}));
    std::vector<std::uint64_t> hashes;
    for (int step = 0; step < 240; ++step) {
        const Machine& m = machines[static_cast<std::size_t>(step) % 4];
        if (step == 50) w.set_type(machines[1].arm, BodyType::static_body);
        if (step == 90) w.set_type(machines[1].arm, BodyType::dynamic);
        if (step == 60) w.set_type(machines[2].cart, BodyType::kinematic), w.set_linear_velocity(machines[2].cart, {0.25f, 0});
        if (step == 70) w.set_break(machines[3][JointType::pulley], 1, 0);
        if (step % 60 == 30) w.apply_linear_impulse_to_center(m.bob, {3, 2});
        if (step % 40 == 20) w.destroy_joint(join(w, joint_types[static_cast<std::size_t>(step) % 8], m.left, m.drone));
        w.step(1.0f / 60);
        if (step % 20 == 19) hashes.push_back(w.hash());
    }
    EXPECT_EQ(w.validate(), nullptr);
    EXPECT_LT(w.joint_count(), 4 * joint_type_count) << "one broke";
    return hashes;
}

TEST(JointBits, AreTheSameAtEveryWidth) {
    std::vector<std::uint64_t> first;
    for (const std::uint32_t lanes : {1u, 4u, 8u, 16u}) {
        std::vector<std::uint64_t> hashes;
        for (const Schedule schedule : {Schedule::soft, Schedule::classic}) {
            WorldDef def;
            def.lanes = lanes;
            def.solver.schedule = schedule;
            TestWorld world(machine_capacity, def);
            for (const std::uint64_t hash : story(*world)) hashes.push_back(hash);
        }
        if (first.empty()) first = hashes;
        EXPECT_EQ(hashes, first) << "lanes " << lanes;
    }
}

TEST(JointBits, DoNotDependOnWhatTheBlockHeldBefore) {
    std::vector<std::uint64_t> first;
    std::mt19937 random(7);
    for (const int kind : {0, 1, 2, 3}) {
        Block block(world_bytes(machine_capacity));
        for (std::byte& b : block.span())
            b = kind == 0 ? std::byte{0} : kind == 1 ? std::byte{0xff} : kind == 2 ? static_cast<std::byte>(random()) : std::byte{0x7f};
        World* world = World::create(block.span(), machine_capacity, {});
        ASSERT_NE(world, nullptr);
        const auto hashes = story(*world);
        if (first.empty()) first = hashes;
        EXPECT_EQ(hashes, first) << "memory " << kind;
    }
}

TEST(JointBits, AreTheSameAfterDestroyingEverythingAndRebuilding) {
    std::vector<std::uint64_t> hashes[2];
    for (std::vector<std::uint64_t>& run : hashes) {
        TestWorld world(machine_capacity);
        story(*world);
        for (const BodyId id : world.bodies()) world->destroy_body(id);
        EXPECT_EQ(world->joint_count(), 0u);
        run = story(*world);
    }
    EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(JointBits, ARefilledWorldMovesLikeAFreshOne) {
    // Emptied last made first, the free slots stand in the order of a fresh world.
    TestWorld fresh(machine_capacity), used(machine_capacity);
    Machine old = add_machine(*used, {0, 0});
    for (std::size_t i = old.joints.size(); i-- > 0;) used->destroy_joint(old.joints[i]);
    const std::vector<BodyId> bodies = used.bodies();
    for (std::size_t i = bodies.size(); i-- > 0;) used->destroy_body(bodies[i]);
    old = add_machine(*used, {0, 0});
    const Machine first = add_machine(*fresh, {0, 0});
    used.step(200);
    fresh.step(200);
    for (std::size_t i = 0; i < bodies.size(); ++i) EXPECT_EQ(used->transform(used.bodies()[i]), fresh->transform(fresh.bodies()[i]));
    for (std::size_t i = 0; i < old.joints.size(); ++i) EXPECT_EQ(used->joint_force(old.joints[i]), fresh->joint_force(first.joints[i]));
}

TEST(JointBits, OfAGearOverIslandsThatShareNothingElse) {
    // A gear whose first joint lost one of its bodies to the static world, and whose other joint stands on a moving kinematic body: the islands must
    // still be solved together.
    std::vector<std::uint64_t> first;
    for (const std::byte fill : {std::byte{0}, std::byte{0xff}, std::byte{0x3f}}) {
        Block block(world_bytes(machine_capacity));
        for (std::byte& b : block.span()) b = fill;
        World& w = *World::create(block.span(), machine_capacity, {});
        const auto add = [&](BodyType type, float x) {
            BodyDef def;
            def.type = type;
            def.position = {x, 0};
            const BodyId id = w.create_body(def);
            w.create_shape(id, make_box(0.4f, 0.4f));
            return id;
        };
        const BodyId carrier = add(BodyType::kinematic, 0), wheel = add(BodyType::dynamic, 2);
        const BodyId a = add(BodyType::dynamic, 6), b = add(BodyType::dynamic, 8);
        const JointId one = join(w, JointType::revolute, a, b), two = join(w, JointType::revolute, carrier, wheel);
        const JointId gear = w.create_joint(GearJointDef{one, two, 1});
        w.set_type(b, BodyType::static_body);
        w.set_linear_velocity(carrier, {-0.5f, 0});
        w.set_gravity({0, -3});
        std::vector<std::uint64_t> hashes;
        for (int i = 0; i < 60; ++i) {
            w.step(1.0f / 60);
            hashes.push_back(w.hash());
        }
        EXPECT_EQ(w.validate(), nullptr);
        EXPECT_LT(w.joint_error(gear).angular, 0.01f);
        if (first.empty()) first = hashes;
        EXPECT_EQ(hashes, first);
    }
}

}  // namespace
}  // namespace islet::test
