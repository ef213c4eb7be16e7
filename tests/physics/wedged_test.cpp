// Stones that hold each other by being wedged: arches, rows clamped between two walls, piles under a piston. Their contacts are tilted and deep, and they are
// to come to rest all the same, at the default settings, from ten starts each.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "arch.hpp"
#include "measure.hpp"
#include "support/random.hpp"

namespace islet::test {
namespace {

constexpr std::uint64_t starts = slow_build ? 1 : 10;
constexpr float settling_seconds = slow_build ? 2 : 20;  // after which all is to rest; a slow build runs too short to ask for it

std::vector<Vec2> centers_of(const TestWorld& world, const std::vector<BodyId>& bodies) {
    std::vector<Vec2> all;
    for (const BodyId id : bodies) all.push_back(world->center_of_mass(id));
    return all;
}

/// m, the farthest that one of the bodies is from where it was.
float farthest_from(const std::vector<Vec2>& before, const TestWorld& world, const std::vector<BodyId>& bodies) {
    float most = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) most = max(most, length(world->center_of_mass(bodies[i]) - before[i]));
    return most;
}

// A half circle of equal stones on the ground, each of them about a metre long, whose thickness is 0.15 of the radius: an arch needs 0.107 to stand by itself
// (Heyman, "The safety of masonry arches", 1969). Arches of 59 stones fall.
TEST(Wedged, ArchesOfUpToFiftyOneStonesStandAndComeToRest) {
    for (const int stones : {7, 15, 25, 35, 43, 51})
        for (std::uint64_t seed = 0; seed < starts; ++seed) {
            Random random(seed);
            TestWorld world;
            const float radius = static_cast<float>(stones) / pi, thickness = 0.15f * radius;
            world.add_ground(0, 3 * radius, rough(0.9f));
            const std::vector<BodyId> arch =
                add_arch(world, stones, radius, thickness, rough(0.9f), [&] { return Vec2{random.between(-0.0001f, 0.0001f) * radius, 0}; });
            const std::vector<Vec2> before = centers_of(world, arch);
            world.step(static_cast<int>(60 * settling_seconds));
            const std::string what = std::to_string(stones) + " stones, start " + std::to_string(seed);
            EXPECT_LT(farthest_from(before, world, arch), 0.5f * thickness) << what;
            if (!slow_build) { EXPECT_EQ(world->report().awake_bodies, 0u) << what; }
        }
}

// Blocks of 0.5 m in a row between a wall and a press on rails, with nothing below. Friction of 0.9 at either end holds them from a force of 0.56 of their
// weight on, and the line of thrust stays inside them.
TEST(Wedged, RowsOfBlocksHangBetweenAWallAndAPressAndDoNotShake) {
    for (const int blocks : {3, 5, 7, 9, 11})
        for (const float height : {1.0f, 2.0f})
            for (const float force : {1.0f, 2.0f, 4.0f, 8.0f, 16.0f})
                for (std::uint64_t seed = 0; seed < starts; ++seed) {
                    Random random(seed);
                    TestWorld world(roomy, sleepless());
                    const float width = 0.5f * static_cast<float>(blocks);
                    world.add_box({-1, 0}, 1, 5, rough(0.9f), BodyType::static_body);
                    for (const float side : {-2.5f, 2.5f}) world.add_box({width + 50, side}, 50, 0.5f, rough(0), BodyType::static_body);
                    std::vector<BodyId> row;
                    for (int i = 0; i < blocks; ++i)
                        row.push_back(
                            world.add_box({0.5f * static_cast<float>(i) + 0.25f, random.between(-0.002f, 0.002f)}, 0.25f, 0.5f * height, rough(0.9f)));
                    const BodyId press = world.add_box({width + 0.5f, 0}, 0.5f, 2, rough(0.9f));
                    const float weight = 10 * world->mass(row[0]) * static_cast<float>(blocks);
                    for (int i = 0; i < 30 * static_cast<int>(settling_seconds); ++i) {
                        world->apply_force_to_center(press, {-force * weight, 0});
                        world.step();
                    }
                    const std::string what = std::to_string(blocks) + " blocks of " + std::to_string(height) + " m, pressed by " + std::to_string(force) +
                                             " times their weight, start " + std::to_string(seed);
                    for (const BodyId block : row) {
                        EXPECT_LT(std::fabs(world->position(block).y), 0.25f) << what;  // half a block's length
                        if (!slow_build) { EXPECT_LT(length(world->linear_velocity(block)), 0.01f) << what; }
                    }
                }
}

void add_shape(World& world, BodyId body, std::string_view kind, Random& random) {
    if (kind == "boxes") world.create_shape(body, make_box(0.5f, 0.5f), {});
    if (kind == "balls") world.create_shape(body, Circle{{0, 0}, 0.5f}, {});
    if (kind == "triangles") world.create_shape(body, make_polygon(compute_hull(regular(3, 0.6f))), {});
    if (kind == "capsules") world.create_shape(body, Capsule{{-0.4f, 0}, {0.4f, 0}, 0.25f}, {});
    if (kind == "crosses") {
        world.create_shape(body, make_box(0.5f, 0.15f), {});
        world.create_shape(body, make_box(0.15f, 0.5f), {});
    }
    if (kind == "polygons") {
        const float radius = random.between(0.4f, 0.6f);  // by itself: compilers order the arguments of a call as they like
        world.create_shape(body, make_polygon(compute_hull(regular(3 + static_cast<int>(random.below(6)), radius))), {});
    }
}

// Forty things in a shaft 6 m wide, and after four seconds a piston on them. Wanted is that nine of ten piles rest.
TEST(Wedged, PilesComeToRestUnderAPistonOfThriceTheirWeight) {
    std::uint64_t runs = 0, restless = 0;
    for (const char* kind : {"boxes", "balls", "triangles", "capsules", "crosses", "polygons"})
        for (std::uint64_t seed = 0; seed < starts; ++seed) {
            Random random(seed);
            TestWorld world;
            world.add_ground();
            for (const float side : {-4.0f, 4.0f}) world.add_box({side, 19}, 1, 20, {}, BodyType::static_body);
            std::vector<BodyId> pile;
            float mass = 0;
            for (int i = 0; i < 40; ++i) {
                const Vec2 at = {(static_cast<float>(i % 4) - 1.5f) * 1.45f + random.between(-0.1f, 0.1f), 0.7f + 1.4f * static_cast<float>(i / 4)};
                const BodyId body = world->create_body(dynamic_at(at, random.between(-3, 3)));
                add_shape(*world, body, kind, random);
                mass += world->mass(body);
                pile.push_back(body);
            }
            world.step(240);
            float top = 0;
            for (const BodyId body : pile) top = max(top, world->position(body).y);
            ShapeDef iron = rough(0.1f);
            iron.density = 3 * mass / 5.8f;
            pile.push_back(world.add_box({0, top + 1.2f}, 2.9f, 0.5f, iron));
            world.step(static_cast<int>(60 * settling_seconds));
            for (const BodyId body : pile) EXPECT_LT(std::fabs(world->position(body).x), 3) << kind << ", start " << seed;
            ++runs;
            restless += world->report().awake_bodies > 0;
        }
    if (!slow_build) { EXPECT_LE(10 * restless, runs); }
}

// A thin wedge laid into the floor by half. Where there is but one substep its contact cannot lift it out, and continuous collision does not let it through:
// what cannot move has no speed.
TEST(Wedged, WhatIsStuckInAFloorGathersNoSpeed) {
    for (std::uint64_t seed = 0; seed < 10 * starts; ++seed) {
        Random random(seed);
        WorldDef def;
        def.solver.substeps = 1;
        TestWorld world(roomy, def);
        world.add_ground();
        const Vec2 corners[] = {{-0.5f, -0.0625f}, {0.5f, -0.0625f}, {-0.5f, 0.0625f}};
        const float angle = random.between(-0.1f, 0.1f) + (seed % 2 == 0 ? 0 : pi);
        const BodyId wedge = world.add(make_polygon(compute_hull(corners)), Vec2{0, 0}, {}, BodyType::dynamic);
        world->set_transform(wedge, {0, 0}, angle);
        world->set_transform(wedge, Vec2{0, random.between(-0.002f, 0.002f)} - world->center_of_mass(wedge), angle);
        world.step(600);
        EXPECT_LT(length(world->linear_velocity(wedge)), 0.1f) << seed;  // it fell to 32 m/s
        EXPECT_LT(std::abs(world->angular_velocity(wedge)), 1.0f) << seed;
    }
}

}  // namespace
}  // namespace islet::test
