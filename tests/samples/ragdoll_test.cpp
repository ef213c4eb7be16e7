// The ragdoll to take along is a person: of the height and mass asked for, its soles on the point given, bent no farther than people bend.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "prefabs/ragdoll.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

using samples::BodyPart;
using samples::create_ragdoll;
using samples::Ragdoll;
using samples::RagdollDef;

constexpr Capacity crowd_room = {.bodies = 64, .shapes = 64, .contacts = 512, .joints = 64};

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
        TestWorld world(crowd_room);
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
    TestWorld world(crowd_room);
    const Ragdoll doll = create_ragdoll(*world, {});
    float moment = 0;
    for (const BodyId body : doll.bodies) moment += world->mass(body) * world->center_of_mass(body).y;
    EXPECT_GT(moment / 60, 0.55f * 1.6f);
    EXPECT_LT(moment / 60, 0.58f * 1.6f);
    EXPECT_NEAR(world->mass(doll[BodyPart::head]), 0.081f * 60, 1e-3f);
    EXPECT_NEAR(world->joint_position(doll.joints[0]), 0, 1e-6f);
}

// What anybody would ask of a person of 1.6 m and 60 kg who is pushed and drops.
constexpr float body_height = 1.6f, torso_mass = 0.355f * 60, gravity = 10;
constexpr float substep = 1.0f / 240;
constexpr float thinnest_pair = (0.020f + 0.025f) * body_height;  // m, the radii of a forearm and an upper arm: farther apart, a gap is seen between their ends
constexpr float visible = 0.005f;                                 // m, of what lies still
constexpr float wrong_bend = 20 * pi / 180, still_bend = pi / 180;  // rad beyond a limit: of a blow, for a moment, and of what lies still

/// The greatest speed of a part: its push, the fall of all of it, and the tip of a rod of its height that tips over, all in line.
float most_speed(float push, float drop) {
    return std::abs(push) / torso_mass + std::sqrt(2 * gravity * drop) + std::sqrt(3 * gravity * body_height);
}

/// The height of the lowest axis of its capsules, in radii, and how far the lowest of their surfaces is above the floor, m.
struct Lowest {
    float axis = 1e9f, surface = 1e9f;
};
Lowest lowest_of(const World& world, const Ragdoll& doll) {
    Lowest low;
    for (const BodyId body : doll.bodies) {
        ShapeId shapes[4];
        const std::uint32_t count = world.shapes(body, shapes);
        for (std::uint32_t i = 0; i < count; ++i) {
            const Capsule& c = *world.capsule(shapes[i]);
            for (const Vec2 end : {c.point1, c.point2}) {
                const float height = transform_point(world.transform(body), end).y;
                low = {std::min(low.axis, height / c.radius), std::min(low.surface, height - c.radius)};
            }
        }
    }
    return low;
}

/// Steps for ten seconds: nothing flies off, sinks into the floor, comes apart or bends wrongly; at the end it lies still, whole and on the floor.
void expect_sane(World& world, const Ragdoll& doll, float fastest) {
    for (int step = 0; step < 600; ++step) {
        world.step(1.0f / 60);
        for (const BodyId body : doll.bodies) ASSERT_LT(length(world.linear_velocity(body)), fastest) << step;
        ASSERT_GT(lowest_of(world, doll).axis, 0.5f) << step;  // continuous collision lets a shape in by half its radius
        for (const JointId joint : doll.joints) {
            const JointError error = world.joint_error(joint);
            // A part that the ground stops at once leaves its joint open by what the other goes in a substep; and no gap is seen.
            ASSERT_LT(error.linear, std::min(fastest * substep, thinnest_pair)) << step;
            ASSERT_LT(error.angular, wrong_bend) << step;
        }
    }
    EXPECT_GT(lowest_of(world, doll).surface, -visible);
    for (const BodyId body : doll.bodies) EXPECT_FALSE(world.is_awake(body)) << "it moves, or trembles";
    for (const JointId joint : doll.joints) {
        EXPECT_LT(world.joint_error(joint).linear, visible);
        EXPECT_LT(world.joint_error(joint).angular, still_bend);
    }
}

TEST(RagdollToTake, LimpItFallsAndLiesStill) {
    // A head lies at its radius, or on both crossed arms.
    constexpr float lying = (0.045f + 2 * 0.025f + 2 * 0.020f) * body_height;
    // Sometimes it stays propped on its elbows, its head half as high as if it sat.
    constexpr float propped_up = 0.25f * body_height;
    int propped = 0;
    for (const float push : {-120.0f, -60.0f, -20.0f, 20.0f, 60.0f, 120.0f}) {
        for (const float drop : {0.0f, 0.5f, 1.0f, 2.0f}) {
            SCOPED_TRACE(std::to_string(push) + " N s from " + std::to_string(drop) + " m");
            TestWorld world(crowd_room);
            create_floor(*world);
            const Ragdoll doll = create_ragdoll(*world, {.position = {0, drop}});
            world->apply_linear_impulse_to_center(doll[BodyPart::torso], {push, 0});
            ASSERT_NO_FATAL_FAILURE(expect_sane(*world, doll, most_speed(push, drop)));
            const float head = world->position(doll[BodyPart::head]).y;
            EXPECT_LT(head, propped_up);
            if (!(head < lying + visible)) ++propped;
        }
    }
    EXPECT_LE(propped, 2);  // of 24
}

TEST(RagdollToTake, BracedItStands) {
    TestWorld world(crowd_room);
    create_floor(*world);
    const Ragdoll doll = create_ragdoll(*world, {.hertz = 20});
    const float head = world->position(doll[BodyPart::head]).y;
    ASSERT_NO_FATAL_FAILURE(expect_sane(*world, doll, most_speed(0, 0)));
    // Its centre of mass is over its feet, and it has sunk by no more than is seen at the sole, knee, hip, waist and neck.
    float moment = 0;
    for (const BodyId body : doll.bodies) moment += world->mass(body) * world->center_of_mass(body).x;
    EXPECT_GT(moment / 60, -0.03f * body_height);  // the heel
    EXPECT_LT(moment / 60, 0.082f * body_height);  // the toes
    EXPECT_GT(world->position(doll[BodyPart::head]).y, head - 5 * visible);
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
