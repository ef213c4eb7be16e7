// What covers the side of a piece of floor holds there alone: whoever reaches past it must not sink into the piece. And who lands on a floor with gaps keeps
// his way. (What slides over floors: floor_test.cpp.)
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "measure.hpp"
#include "queries/oracle.hpp"
#include "support/random.hpp"

namespace islet::test {
namespace {

/// The shape as a set of points.
template <class Shape>
oracle::Solid solid(const Shape& shape, const Transform& pose = {}) {
    return oracle::solid_of(make_proxy(shape), pose);
}

/// How deep a body's shape is in a solid that stands still, m.
template <class Shape>
double depth_in(const World& world, BodyId body, const Shape& shape, const oracle::Solid& still) {
    return -oracle::signed_distance(solid(shape, {world.position(body), make_rot(world.angle(body))}), still);
}

enum class Fence { segment, capsule, thin_box };

// A box with a fence flush at its side, over whose edge a plank tumbles. The plank's end that reaches beyond the fence's foot must not come into the box.
TEST(BesidePieces, APlankThatTumblesOverAFenceStaysOutOfTheBoxBehindIt) {
    for (const Fence fence : {Fence::segment, Fence::capsule, Fence::thin_box}) {
        for (const float height : {0.01f, 0.05f, 0.2f}) {
            for (std::uint64_t seed = 0; seed < 40; ++seed) {
                Random random(seed);
                TestWorld world;
                const BodyId level = world->create_body({});
                const Polygon box = make_offset_box(3, 0.5f, {{3, -0.5f}, {}});
                world->create_shape(level, box, rough(0.6f));
                if (fence == Fence::segment) world->create_shape(level, Segment{{0, -0.5f}, {0, height}}, rough(0.6f));
                if (fence == Fence::capsule) world->create_shape(level, Capsule{{-0.05f, -0.5f}, {-0.05f, height - 0.05f}, 0.05f}, rough(0.6f));
                if (fence == Fence::thin_box)
                    world->create_shape(level, make_offset_box(0.01f, 0.25f + 0.5f * height, {{-0.01f, 0.5f * height - 0.25f}, {}}), rough(0.6f));
                BodyDef def = dynamic_at({random.between(-0.9f, 0.2f), 1.3f}, random.between(-1.5f, 1.5f));
                def.linear_velocity = {random.between(-1, 3), random.between(-5, 0)};
                def.angular_velocity = random.between(-6, 3);
                const Polygon shape = make_box(1, 0.1f);
                const BodyId plank = world.add(shape, def, rough(0.6f));
                double deepest = 0;
                for (int i = 0; i < 180; ++i) {
                    world.step();
                    deepest = std::fmax(deepest, depth_in(*world, plank, shape, solid(box)));
                }
                EXPECT_LT(deepest, 0.05) << "m, fence " << int(fence) << " " << height << " m high, start " << seed;
            }
        }
    }
}

/// What lies in the groove above the round edge of a tile touches the edge and the box beside it.
template <class Shape>
void expect_out_of_the_groove(const Shape& shape, const char* what) {
    for (const float round : {0.05f, 0.1f, 0.2f, 0.3f}) {
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            Random random(seed);
            TestWorld world;
            const BodyId level = world->create_body({});
            const Polygon box = make_offset_box(0.7f, 0.5f, {{0.7f, -0.5f}, {}});
            Polygon tile = make_offset_box(0.7f - round, 0.5f - round, {{-0.7f, -0.5f}, {}});
            tile.radius = round;
            world->create_shape(level, tile, rough(0.6f));
            world->create_shape(level, box, rough(0.6f));
            const BodyId body = world.add(shape, dynamic_at({random.between(-0.5f * round, 0), 0.15f}, random.between(-3, 3)), rough(0.6f));
            double deepest = 0;
            for (int i = 0; i < 180; ++i) {
                world.step();
                deepest = std::fmax(deepest, std::fmax(depth_in(*world, body, shape, solid(box)), depth_in(*world, body, shape, solid(tile))));
            }
            EXPECT_LT(deepest, 0.015) << "m, " << what << ", rounded by " << round << " m, start " << seed;
        }
    }
}

TEST(BesidePieces, SmallBodiesLieInTheGrooveOverARoundEdge) {
    const std::vector<Vec2> hexagon = regular(6, 0.11f), triangle = regular(3, 0.12f);
    expect_out_of_the_groove(make_box(0.1f, 0.1f), "box");
    expect_out_of_the_groove(make_polygon(compute_hull(hexagon)), "hexagon");
    expect_out_of_the_groove(make_polygon(compute_hull(triangle)), "triangle");
    expect_out_of_the_groove(Capsule{{-0.08f, 0}, {0.08f, 0}, 0.05f}, "capsule");
    expect_out_of_the_groove(Circle{{}, 0.1f}, "ball");
}

// Without friction and restitution, whoever lands keeps the speed along the floor. A fast body meets the next tile's side on its free flight, when it is past
// the face on which it lands.
TEST(BesidePieces, ABoxThatLandsFlatOnTilesWithGapsKeepsItsSpeedAlongThem) {
    struct Landing {
        float gap, across, down;
    };
    for (const auto& [gap, across, down] : {Landing{0, 5, 6}, {0.005f, 5, 6}, {0.02f, 5, 6}, {0.05f, 5, 6}, {0.02f, 3, 3}, {0.02f, 2, 8}, {0.05f, 10, 10}}) {
        for (int start = 0; start < 200; ++start) {
            TestWorld world({.bodies = 4, .shapes = 64, .contacts = 128, .geometries = 64}, sleepless());
            const BodyId floor = world->create_body({});
            for (float x = -4; x < 24; ++x) world->create_shape(floor, make_offset_box(0.5f - 0.5f * gap, 0.5f, {{x + 0.5f, -0.5f}, {}}), rough(0));
            BodyDef def = dynamic_at({0.005f * static_cast<float>(start), 0.85f});
            def.linear_velocity = {across, -down};
            const BodyId box = world.add(make_box(0.4f, 0.4f), def, rough(0));
            world.step(30);
            EXPECT_NEAR(world->linear_velocity(box).x, across, 0.02 * double(across)) << "gaps of " << gap << " m, start " << start;
        }
    }
}

}  // namespace
}  // namespace islet::test
