// The pool of joints filled to its last place and beyond, and worlds with no room for joints at all.
#include <algorithm>

#include "refusal.hpp"
#include "support/joint_world.hpp"

namespace {

using namespace islet;
using namespace islet::test;

// Runs a call that finds no room: the world must be as before.
template <class Call>
void expect_full(TestWorld& w, Call&& call) {
    w.errors.clear();
    const std::uint64_t before = w->hash();
    call();
    EXPECT_EQ(w->hash(), before) << "a call that found no room changed the world";
    EXPECT_EQ(w.errors, std::vector<Error>{Error::joints_full});
    EXPECT_EQ(w->last_error(), Error::joints_full);
    EXPECT_EQ(w->validate(), nullptr);
}

// As many boxes as wanted, a metre apart, in the air above a ground.
struct JointedRow : TestWorld {
    explicit JointedRow(std::uint32_t joints, int boxes) : TestWorld({.bodies = 64, .shapes = 64, .contacts = 128, .joints = joints}) {
        ground = add_ground();
        for (int i = 0; i < boxes; ++i) all.push_back(add_box({2.0f * static_cast<float>(i), 5}));
    }
    BodyId ground;
    std::vector<BodyId> all;
};

TEST(JointCapacity, JointsFillTheirPoolToTheLastPlace) {
    JointedRow w(4, 6);
    std::vector<JointId> ids;
    for (std::size_t i = 0; i < 4; ++i) ids.push_back(join(*w, JointType::revolute, w.all[i], w.all[i + 1]));
    EXPECT_TRUE(w.errors.empty());
    EXPECT_EQ(w->joint_count(), 4u);
    for (const JointId id : ids) EXPECT_TRUE(w->is_valid(id));
    for (const JointType type : joint_types) {
        if (type == JointType::gear) continue;
        SCOPED_TRACE(name_of(type));
        expect_full(w, [&] { EXPECT_FALSE(join(*w, type, w.all[4], w.all[5])); });
    }
    const JointId anchored[] = {ids[0], ids[2]};
    expect_full(w, [&] { EXPECT_FALSE(w->create_joint(GearJointDef{anchored[0], anchored[1]})); });

    w->destroy_joint(ids[2]);
    EXPECT_EQ(w->joint_count(), 3u);
    const JointId again = join(*w, JointType::weld, w.all[4], w.all[5]);
    EXPECT_EQ(again.index1, ids[2].index1);
    EXPECT_NE(again, ids[2]);
    EXPECT_FALSE(w->is_valid(ids[2]));
    expect_full(w, [&] { EXPECT_FALSE(join(*w, JointType::weld, w.all[0], w.all[5])); });
    w.step(30);
    EXPECT_EQ(w->validate(), nullptr);
    EXPECT_EQ(w->report().joints, 4u);
}

TEST(JointCapacity, APlaceUsedAgainRemembersNothing) {
    // The same joint made in a fresh place and in one that an active joint of another type left moves the same way.
    Transform poses[2];
    for (const bool used : {false, true}) {
        JointedRow w(1, 2);
        if (used) {
            MotorJointDef motor{.base = base_at_b(*w, w.ground, w.all[0]), .max_force = 500, .max_torque = 20};
            motor.base.break_force = 1e9f;
            motor.base.frame_a.angle = 1;
            motor.linear_hertz = 3;
            w->create_joint(motor);
            w.step(20);
            w->destroy_joint(w->joint_at(0));
            for (std::size_t i = 0; i < 2; ++i) {
                w->set_transform(w.all[i], {2.0f * static_cast<float>(i), 5}, 0);
                w->set_linear_velocity(w.all[i], {});
                w->set_angular_velocity(w.all[i], 0);
            }
        }
        join(*w, JointType::revolute, w.all[0], w.all[1]);
        w.step(60);
        poses[used ? 1 : 0] = w->transform(w.all[1]);
    }
    EXPECT_EQ(poses[0], poses[1]);
}

TEST(JointCapacity, GenerationsGoOnThroughManyReuses) {
    JointedRow w(2, 2);
    std::vector<JointId> seen;
    for (int i = 0; i < 1000; ++i) {
        const JointId id = join(*w, joint_types[static_cast<std::size_t>(i) % 8], w.all[0], w.all[1]);
        ASSERT_TRUE(w->is_valid(id)) << i;
        EXPECT_EQ(std::count(seen.begin(), seen.end(), id), 0);
        seen.push_back(id);
        w->destroy_joint(id);
    }
    for (const JointId id : seen) EXPECT_FALSE(w->is_valid(id));
    EXPECT_EQ(w->joint_count(), 0u);
    EXPECT_EQ(w->validate(), nullptr);
}

TEST(JointCapacity, AWorldWithoutRoomForJointsWorks) {
    JointedRow w(0, 2);
    for (const JointType type : joint_types) {
        if (type == JointType::gear) continue;
        expect_full(w, [&] { EXPECT_FALSE(join(*w, type, w.all[0], w.all[1])); });
    }
    w.errors.clear();
    EXPECT_EQ(w->joint_count(), 0u);
    EXPECT_FALSE(w->joint_at(0));
    EXPECT_FALSE(w->is_valid(JointId{1, 1}));
    EXPECT_TRUE(w.errors.empty());
    w->destroy_joint({1, 1});
    EXPECT_EQ(w.errors, std::vector<Error>{Error::stale_id});
    w.step(120);
    EXPECT_EQ(w->validate(), nullptr);
    EXPECT_NEAR(w->position(w.all[0]).y, 0.5f, 0.01f);
    EXPECT_TRUE(w->broken_joints().empty());
    EXPECT_EQ(w->report().joints, 0u);
}

TEST(JointCapacity, EveryJointOfAFullPoolMayBreakInOneStep) {
    JointedRow w(40, 41);
    std::vector<JointId> ids;
    for (std::size_t i = 0; i < 40; ++i) {
        WeldJointDef def{.base = base_at_b(*w, w.ground, w.all[i])};
        def.base.break_force = 1;  // N, less than the box weighs
        def.base.user_data = i;
        ids.push_back(w->create_joint(def));
    }
    w.step();
    const auto broken = w->broken_joints();
    ASSERT_EQ(broken.size(), 40u);
    for (std::size_t i = 0; i < 40; ++i) {
        EXPECT_EQ(broken[i].joint, ids[i]) << "ordered by slot";
        EXPECT_EQ(broken[i].user_data, i);
        EXPECT_FALSE(w->is_valid(ids[i]));
    }
    EXPECT_EQ(w->joint_count(), 0u);
    EXPECT_EQ(w->report().joints, 0u);
    EXPECT_TRUE(w.errors.empty());
    EXPECT_EQ(w->validate(), nullptr);
    for (std::size_t i = 0; i < 40; ++i) EXPECT_TRUE(join(*w, JointType::weld, w.ground, w.all[i])) << "all places are free again";
    w.step();
    EXPECT_TRUE(w->broken_joints().empty()) << "an event is told once";
}

TEST(JointCapacity, NothingIsWrittenBeyondTheBlock) {
    // Every joint of another type than its neighbours and in many islands, so that runs are short and padding is long.
    constexpr Capacity capacity{.bodies = 60, .shapes = 60, .contacts = 60, .joints = 96};
    constexpr std::size_t bytes = world_bytes(capacity);
    for (const std::uint32_t lanes : {1u, 4u, 8u, 16u}) {
        const Block block(bytes + 256);
        const std::span<std::byte> guard = block.span().subspan(bytes);
        for (std::byte& b : guard) b = std::byte{0x77};
        WorldDef def;
        def.lanes = lanes;
        World* world = World::create(block.span().first(bytes), capacity, def);
        ASSERT_NE(world, nullptr);
        BodyDef box;
        box.type = BodyType::dynamic;
        while (world->body_count() < capacity.bodies) {
            box.position = {1.5f * static_cast<float>(world->body_count()), 0};
            world->create_shape(world->create_body(box), make_box(0.3f, 0.3f));
        }
        for (std::uint32_t i = 0; world->joint_count() < capacity.joints; ++i)
            join(*world, joint_types[i % 8], world->body_at(i % 60), world->body_at((i + 1 + i / 60) % 60));
        for (int i = 0; i < 60; ++i) world->step(1.0f / 60);
        EXPECT_EQ(world->validate(), nullptr);
        for (const std::byte b : guard) ASSERT_EQ(b, std::byte{0x77});
    }
}

}  // namespace
