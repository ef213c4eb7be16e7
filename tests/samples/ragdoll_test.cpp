// The ragdoll to take along is a person: of the height and mass asked for, its soles on the point given, bent no farther than people bend.
#include <gtest/gtest.h>

#include <algorithm>

#include "prefabs/ragdoll.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

using samples::BodyPart;
using samples::create_ragdoll;
using samples::Ragdoll;
using samples::RagdollDef;

constexpr Capacity room = {.bodies = 64, .shapes = 64, .contacts = 512, .joints = 64};

/// What encloses all of it, tightly: capsules have no corners.
Aabb extent_of(const World& world, const Ragdoll& doll) {
    Aabb box = {{1e9f, 1e9f}, {-1e9f, -1e9f}};
    for (const BodyId body : doll.bodies) {
        ShapeId shapes[4];
        const std::uint32_t count = world.shapes(body, shapes);
        for (std::uint32_t i = 0; i < count; ++i) {
            const Capsule& c = *world.capsule(shapes[i]);
            for (const Vec2 end : {c.point1, c.point2}) {
                const Vec2 p = transform_point(world.transform(body), end);
                box = merge(box, {p - Vec2{c.radius, c.radius}, p + Vec2{c.radius, c.radius}});
            }
        }
    }
    return box;
}

void create_floor(World& world) { world.create_shape(world.create_body({}), make_offset_box(50, 1, {{0, -1}}), {.friction = 0.6f}); }

TEST(RagdollToTake, HasTheHeightAndMassAskedFor) {
    for (const RagdollDef& def : {RagdollDef{}, RagdollDef{.position = {3, 2}, .height = 1.9f, .mass = 95},
                                  RagdollDef{.position = {-7, 0.5f}, .height = 0.8f, .mass = 11}}) {
        TestWorld world(room);
        const Ragdoll doll = create_ragdoll(*world, def);
        ASSERT_TRUE(doll);
        float mass = 0;
        for (const BodyId body : doll.bodies) mass += world->mass(body);
        EXPECT_NEAR(mass, def.mass, 1e-4f * def.mass);  // rounding; the shares add up to 1
        const Aabb box = extent_of(*world, doll);
        EXPECT_NEAR(box.lower.y, def.position.y, 1e-5f);
        EXPECT_NEAR(box.upper.y - box.lower.y, def.height, 1e-5f);
        // The ankle is above the point given, within the foot, whose length is 15 % of the height.
        EXPECT_LT(box.lower.x, def.position.x);
        EXPECT_GT(box.upper.x, def.position.x);
        EXPECT_EQ(world->last_error(), Error::none);
    }
}

// A leg is 53 % of a person, and the centre of mass lies at 55 to 58 % of the height (Winter's tables: 56 %).
TEST(RagdollToTake, HasAPersonsProportions) {
    TestWorld world(room);
    const Ragdoll doll = create_ragdoll(*world, {});
    float moment = 0;
    for (const BodyId body : doll.bodies) moment += world->mass(body) * world->center_of_mass(body).y;
    EXPECT_GT(moment / 60, 0.55f * 1.6f);
    EXPECT_LT(moment / 60, 0.58f * 1.6f);
    EXPECT_NEAR(world->mass(doll[BodyPart::head]), 0.081f * 60, 1e-3f);
    EXPECT_NEAR(world->joint_position(doll.joints[0]), 0, 1e-6f);
}

/// Steps for ten seconds; joints stay together and within their limits, and nothing flies off.
void expect_sane(World& world, const Ragdoll& doll) {
    for (int step = 0; step < 600; ++step) {
        world.step(1.0f / 60);
        for (const BodyId body : doll.bodies) {
            ASSERT_LT(length(world.linear_velocity(body)), 15.0f) << step;  // m/s; from 2 m up it comes down at 6
            ASSERT_GT(world.position(body).y, -0.05f) << step;
        }
        for (const JointId joint : doll.joints) {
            const JointError error = world.joint_error(joint);
// A body that the ground stops at once leaves its joint open by what the other goes in a substep: m
            ASSERT_LT(error.linear, 15.0f / 240) << step;
            ASSERT_LT(error.angular, 0.15f) << step;  // rad, beyond a limit: 9 degrees as it strikes the ground
        }
    }
}

TEST(RagdollToTake, LimpItFallsAndComesToRest) {
    for (const float push : {-120.0f, -60.0f, -20.0f, 20.0f, 60.0f, 120.0f}) {
        for (const float height : {0.0f, 2.0f}) {
            TestWorld world(room);
            create_floor(*world);
            const Ragdoll doll = create_ragdoll(*world, {.position = {0, height}});
            world->apply_linear_impulse_to_center(doll[BodyPart::torso], {push, 0});
            ASSERT_NO_FATAL_FAILURE(expect_sane(*world, doll)) << push << " N s from " << height << " m";
            EXPECT_LT(world->position(doll[BodyPart::head]).y, 0.9f) << push;  // it lies, sits or kneels
            for (const BodyId body : doll.bodies) EXPECT_LT(length(world->linear_velocity(body)), 0.2f) << push;
        }
    }
}

TEST(RagdollToTake, BracedItStands) {
    TestWorld world(room);
    create_floor(*world);
    const Ragdoll doll = create_ragdoll(*world, {.hertz = 20});
    ASSERT_NO_FATAL_FAILURE(expect_sane(*world, doll));
    EXPECT_GT(world->position(doll[BodyPart::head]).y, 0.9f * 1.6f * 0.92f);  // the head's middle is at 92 %
}

TEST(RagdollToTake, IsMadeWholeOrNotAtAll) {
    for (std::uint32_t bodies = 1; bodies < 11; ++bodies) {
        TestWorld world({.bodies = bodies, .shapes = 64, .contacts = 64, .joints = 64});
        EXPECT_FALSE(create_ragdoll(*world, {}));
        EXPECT_EQ(world->body_count(), 0u);
        EXPECT_EQ(world->last_error(), Error::bodies_full);
    }
    TestWorld world({.bodies = 11, .shapes = 13, .contacts = 64, .joints = 10});
    const Ragdoll doll = create_ragdoll(*world, {});
    EXPECT_TRUE(doll);
    destroy(*world, doll);
    EXPECT_EQ(world->body_count() + world->joint_count() + world->shape_count(), 0u);
    EXPECT_FALSE(create_ragdoll(*world, {.mass = -1}));
    EXPECT_EQ(world->body_count(), 0u);
}

}  // namespace
}  // namespace islet::test
