// Floors of segments laid end to end, not a chain: what slides or rolls over them must not notice where a piece ends, but free ends and corners are hit.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "measure.hpp"

namespace islet::test {
namespace {

enum class Slider { ball, box, capsule, wedge };
enum class Laid { on_bodies, on_one_body, apart, uneven, with_boxes, as_capsules };

constexpr float side = 0.25f;  // m: from each slider's middle to the floor

/// How the floor lies: slanted by `slope`, with gravity across it, and passed this way or that.
struct Lie {
    float slope = 0;  // rad
    bool leftwards = false;
    float start = 0;  // m from the first seam

    Transform pose() const { return {{3, -2}, make_rot(slope)}; }
};

BodyId add_slider(TestWorld& world, Slider kind, const BodyDef& def, const ShapeDef& material) {
    const Vec2 wedge[] = {{-0.35f, -side}, {0.3f, -side}, {0.4f, 0.1f}, {0, 0.3f}, {-0.4f, 0}};
    switch (kind) {
        case Slider::ball: return world.add(Circle{{}, side}, def, material);
        case Slider::box: return world.add(make_box(side, side), def, material);
        case Slider::capsule: return world.add(Capsule{{-0.3f, 0}, {0.3f, 0}, side}, def, material);
        case Slider::wedge: return world.add(make_polygon(compute_hull(wedge)), def, material);
    }
    return {};
}

/// Lays pieces of a metre, more or less, from -3 m to `length`.
void lay(TestWorld& world, Laid laid, const Lie& lie, float length, const ShapeDef& material) {
    const Transform pose = lie.pose();
    const BodyId one = world->create_body({});
    int index = 0;
    for (float x = -3; x < length; ++index) {
        const float wide = index % 3 == 0 ? 0.7f : 1.0f, end = x + wide;
        const float height = laid == Laid::uneven ? 2e-5f * static_cast<float>(index * 7 % 5 - 2) : 0;
        const bool turned = index % 2 == 0;  // from which end a segment is drawn is nothing
        const float cut = laid == Laid::apart ? 0.001f : 0;
        const Vec2 left = {x, height}, right = {end - cut, height};
        const Segment drawn =
            turned ? Segment{transform_point(pose, left), transform_point(pose, right)} : Segment{transform_point(pose, right), transform_point(pose, left)};
        if (laid == Laid::with_boxes && index % 2 == 0) {
            BodyDef def;
            def.position = transform_point(pose, {x + 0.5f * wide, -0.3f});
            def.angle = lie.slope;
            world.add(make_box(0.5f * wide, 0.3f), def, material);
        } else if (laid == Laid::as_capsules) {
            const Vec2 down = {0, 0.1f};
            world->create_shape(one, Capsule{transform_point(pose, left - down), transform_point(pose, right - down), 0.1f}, material);
        } else if (laid == Laid::on_bodies) {
            world.add(drawn, BodyDef{}, material);
        } else {
            world->create_shape(one, drawn, material);
        }
        x = end;
    }
}

class LineFloor : public testing::TestWithParam<std::tuple<Laid, Slider, float>> {};

// Without friction nothing is lost: ten starts, some on a slope and some leftwards.
TEST_P(LineFloor, HasNoBump) {
    const auto [laid, kind, speed] = GetParam();
    const float length = std::fmin(200.0f, 4 * speed + 10);
    for (int start = 0; start < 10; ++start) {
        const Lie lie = {0.3f * static_cast<float>(start % 4) - 0.3f, start % 3 == 1, 0.097f * static_cast<float>(start)};
        WorldDef def = sleepless();
        const Transform pose = lie.pose();
        def.gravity = rotate(pose.q, {0, -10});
        TestWorld world({.bodies = 512, .shapes = 512, .contacts = 256, .geometries = 512}, def);
        const ShapeDef smooth = rough(0);
        lay(world, laid, lie, length, smooth);
        const float from = lie.leftwards ? length - 2 - lie.start : lie.start;
        const BodyId slider = add_slider(world, kind, dynamic_at(transform_point(pose, {from, side}), lie.slope), smooth);
        world.step(60);  // it settles
        const Vec2 along = rotate(pose.q, {lie.leftwards ? -1.0f : 1.0f, 0}), up = rotate(pose.q, {0, 1});
        world->set_linear_velocity(slider, speed * along);
        const float height = dot(up, world->position(slider));
        double highest = 0, fastest = 0, turned = 0;
        const int steps = static_cast<int>(60 * (length - 5 - lie.start) / speed);
        for (int i = 0; i < steps; ++i) {
            world.step();
            highest = std::fmax(highest, std::fabs(double(dot(up, world->position(slider)) - height)));
            fastest = std::fmax(fastest, std::fabs(double(dot(up, world->linear_velocity(slider)))));
            turned = std::fmax(turned, std::fabs(double(world->angle(slider) - lie.slope)));
        }
        const double lost = double(speed - dot(along, world->linear_velocity(slider)));
        // Nobody sees a rise of 2 mm, nor 5 cm/s, which lifts by a tenth of a millimetre. What climbs 0.08 mm pays for it: g h = v dv.
        const double climbed = laid == Laid::uneven ? g * 8e-5 / double(speed) : 0;
        EXPECT_LT(std::fabs(lost), (laid == Laid::as_capsules ? 0.002 : 0.001) * double(speed) + climbed) << "m/s, start " << start;
        EXPECT_LT(highest, 0.002) << "m, start " << start;
        EXPECT_LT(fastest, 0.05) << "m/s up or down, start " << start;
        if (kind != Slider::ball) { EXPECT_LT(turned, 0.01) << "rad, start " << start; }
    }
}

std::string name_of_slide(const testing::TestParamInfo<LineFloor::ParamType>& test) {
    constexpr const char* floors[] = {"segments", "segments_of_one_body", "segments_1_mm_apart", "uneven_segments", "segments_and_boxes", "capsules"};
    constexpr const char* sliders[] = {"ball", "box", "capsule", "wedge"};
    return std::string(sliders[int(std::get<1>(test.param))]) + "_over_" + floors[int(std::get<0>(test.param))] + "_at_" +
           std::to_string(int(std::get<2>(test.param)));
}
INSTANTIATE_TEST_SUITE_P(Lines, LineFloor,
                         testing::Combine(testing::Values(Laid::on_bodies, Laid::on_one_body, Laid::apart, Laid::uneven, Laid::with_boxes),
                                          testing::Values(Slider::ball, Slider::box, Slider::capsule, Slider::wedge),
                                          testing::Values(1.0f, 5.0f, 20.0f, 50.0f, 100.0f)),
                         name_of_slide);
INSTANTIATE_TEST_SUITE_P(Capsules, LineFloor,
                         testing::Combine(testing::Values(Laid::as_capsules), testing::Values(Slider::ball, Slider::box, Slider::capsule, Slider::wedge),
                                          testing::Values(1.0f, 5.0f, 20.0f, 50.0f)),
                         name_of_slide);

/// A line of kinks, from left to right.
std::vector<Vec2> kinked(float degrees) {
    std::vector<Vec2> points;
    Vec2 at = {-60, 0};
    points.push_back(at);
    points.push_back(at = {2, 0});
    for (int i = 0; i < 30; ++i) {
        // Up, level, down, level.
        const float angle = (i % 4 == 0 ? 1.0f : i % 4 == 2 ? -1.0f : 0.0f) * degrees * pi / 180;
        points.push_back(at += 1.5f * Vec2{make_rot(angle).c, make_rot(angle).s});
    }
    points.push_back(at += Vec2{100, 0});
    return points;
}

struct Ride {
    double speed = 0, x = 0, deepest = 0;
};

Ride ride_over(const std::vector<Vec2>& points, bool chain, Slider kind, float x, float speed, int steps) {
    TestWorld world({.bodies = 64, .shapes = 128, .contacts = 256, .geometries = 128}, sleepless());
    const ShapeDef smooth = rough(0);
    const BodyId ground = world->create_body({});
    if (chain) {
        const std::vector<Vec2> reversed(points.rbegin(), points.rend());
        world->create_chain(ground, reversed, false, smooth);
    } else {
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            world->create_shape(ground, i % 2 == 0 ? Segment{points[i], points[i + 1]} : Segment{points[i + 1], points[i]}, smooth);
    }
    BodyDef def = dynamic_at({x, side});
    def.linear_velocity = {speed, 0};
    const BodyId slider = add_slider(world, kind, def, smooth);
    Ride ride;
    for (int i = 0; i < steps; ++i) {
        world.step();
        ride.deepest = std::fmax(ride.deepest, deepest_overlap(world));
    }
    ride.speed = double(length(world->linear_velocity(slider)));
    ride.x = double(world->position(slider).x);
    return ride;
}

// Kinks are what they are for a chain: the ball climbs, flies and lands, and is not stopped by an end.
TEST(LineFloorKinks, AreThoseOfAChain) {
    for (const float degrees : {2.0f, 5.0f, 10.0f, 20.0f, 30.0f}) {
        for (const float speed : {2.0f, 6.0f, 10.0f, 20.0f}) {
            double lines = 0, chains = 0, behind = 0;
            for (int start = 0; start < 10; ++start) {
                const std::vector<Vec2> points = kinked(degrees);
                const float x = -3 + 0.17f * static_cast<float>(start);
                const int steps = static_cast<int>(60 * 30 / speed);
                const Ride by_line = ride_over(points, false, Slider::ball, x, speed, steps), by_chain = ride_over(points, true, Slider::ball, x, speed, steps);
                lines += 0.1 * by_line.speed, chains += 0.1 * by_chain.speed, behind += 0.1 * (by_chain.x - by_line.x);
            }
            EXPECT_GT(lines, chains - 0.02 * double(speed)) << degrees << " degrees at " << speed << " m/s";
            EXPECT_LT(behind, 0.5) << degrees << " degrees at " << speed << " m/s";
        }
    }
}

// What ends in the air, or stands on the floor, is hit: from either side, at ten places.
TEST(LineFloorEnds, AreHitIfNothingGoesOnThere) {
    for (const Slider kind : {Slider::ball, Slider::box, Slider::capsule, Slider::wedge}) {
        for (const float speed : {2.0f, 20.0f}) {
            for (int start = 0; start < 10; ++start) {
                for (int obstacle = 0; obstacle < 4; ++obstacle) {
                    if (obstacle == 3 && kind == Slider::wedge) continue;  // its face hangs over, and drives it under the edge
                    TestWorld world({.bodies = 64, .shapes = 64, .contacts = 64}, sleepless());
                    const ShapeDef smooth = rough(0);
                    for (int i = -5; i < 10; ++i)
                        if (obstacle != 1 || i < 5) world.add(Segment{{static_cast<float>(i), 0}, {static_cast<float>(i + 1), 0}}, BodyDef{}, smooth);
                    // A wall that stands on a seam; one that goes on in its own pieces; one on the middle of a piece; a floor 20 cm higher (its end is bare).
                    if (obstacle == 0) world.add(Segment{{5, 0}, {5, 2}}, BodyDef{}, smooth);
                    if (obstacle == 1)
                        for (int i = 0; i < 5; ++i)
                            world.add(Segment{{5, 0.4f * static_cast<float>(i)}, {5, 0.4f * static_cast<float>(i + 1)}}, BodyDef{}, smooth);
                    if (obstacle == 2) world.add(Segment{{5.5f, 0}, {5.5f, 2}}, BodyDef{}, smooth);
                    if (obstacle == 3)
                        for (int i = 5; i < 10; ++i) world.add(Segment{{static_cast<float>(i), 0.2f}, {static_cast<float>(i + 1), 0.2f}}, BodyDef{}, smooth);
                    BodyDef def = dynamic_at({-3 + 0.11f * static_cast<float>(start), side});
                    def.linear_velocity = {speed, 0};
                    def.fixed_rotation = true;
                    const BodyId slider = add_slider(world, kind, def, smooth);
                    float farthest = -100;
                    for (int i = 0; i < 300; ++i) {
                        world.step();
                        farthest = std::fmax(farthest, world->position(slider).x);
                    }
                    // (Balls are thrown over an edge below their middle.)
                    if (obstacle == 3 && (kind == Slider::ball || kind == Slider::capsule)) {
                        EXPECT_LT(world->linear_velocity(slider).x, 0.9f * speed) << "slider " << int(kind) << ", start " << start;
                    } else {
                        EXPECT_LT(farthest, 5.5f - 0.2f) << "obstacle " << obstacle << ", slider " << int(kind) << ", " << speed << " m/s, start " << start;
                    }
                    EXPECT_GT(world->position(slider).y, side - 0.02f)
                        << "obstacle " << obstacle << ", slider " << int(kind) << ", " << speed << " m/s, start " << start;
                }
            }
        }
    }
}

// A ball whose middle is just over a gap too narrow to see lies on both sides of it.
TEST(LineFloorEnds, HoldABallThatLiesOnAGap) {
    for (const float gap : {0.0f, 0.0002f, 0.0005f, 0.0009f, 0.001f, 0.002f, 0.004f}) {
        for (const float radius : {0.02f, 0.1f, 0.5f}) {
            for (int start = 0; start < 10; ++start) {
                for (const bool boxes : {false, true}) {
                    if (boxes && gap >= 0.001f) continue;
                    TestWorld world({.bodies = 8, .shapes = 8, .contacts = 64}, sleepless());
                    for (const float s : {-1.0f, 1.0f}) {
                        if (boxes) world.add(make_box(1, 0.5f), Vec2{s * (1 + 0.5f * gap), -0.5f}, rough(0.3f), BodyType::static_body);
                        if (!boxes) world.add(Segment{{s * 0.5f * gap, 0}, {s * 2, 0}}, BodyDef{}, rough(0.3f));
                    }
                    const BodyId ball =
                        world.add(Circle{{}, radius}, dynamic_at({gap * 0.1f * (static_cast<float>(start) - 4.5f), radius + 0.2f}), rough(0.3f));
                    world.step(300);
                    EXPECT_NEAR(world->position(ball).y, radius, 0.002)
                        << "gap " << gap << ", radius " << radius << ", start " << start << (boxes ? ", boxes" : "");
                }
            }
        }
    }
}

}  // namespace
}  // namespace islet::test
