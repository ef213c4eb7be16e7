// Floors made of pieces, as users draw them: what slides or rolls over one must not notice where a piece ends.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "measure.hpp"

namespace islet::test {
namespace {

enum class SliderKind { box, capsule, ball, flat_bevel, bevel, chamfer, octagon };
enum class Pieces { boxes, one_body, chain };

struct Ride {
    double fastest_rise = 0;  // m/s, of the slider's centre, either way
    double highest = 0;       // m that its centre was above or below where it began
    double speed_lost = 0;    // m/s
    double turned = 0;        // rad
};

/// A crate whose lower corners are cut off, `width` before its sides and `height` up them.
Polygon crate(float width, float height) {
    const Vec2 corners[] = {{-0.5f, 0.25f}, {-0.5f, height - 0.25f}, {width - 0.5f, -0.25f}, {0.5f - width, -0.25f}, {0.5f, height - 0.25f}, {0.5f, 0.25f}};
    return make_polygon(compute_hull(corners));
}

Polygon octagon() {
    const float low = 0.25f * 0.41421356f;  // half a side
    const Vec2 corners[] = {{low, -0.25f}, {0.25f, -low}, {0.25f, low}, {low, 0.25f}, {-low, 0.25f}, {-0.25f, low}, {-0.25f, -low}, {-low, -0.25f}};
    return make_polygon(compute_hull(corners));
}

/// A kilometre of floor in pieces of one metre, and what slides over it without friction.
Ride slide(Pieces pieces, SliderKind kind, float speed) {
    constexpr int length = 1000;  // m
    TestWorld world({.bodies = length + 64, .shapes = length + 64, .contacts = 256, .geometries = length + 64}, sleepless());
    ShapeDef smooth = rough(0);
    const BodyId one = world->create_body({});
    if (pieces == Pieces::chain) {
        std::vector<Vec2> points;
        for (int i = length + 10; i >= -10; --i) points.push_back({static_cast<float>(i), 0});
        world->create_chain(one, points, false, smooth);
    }
    for (int i = -10; i < length + 10 && pieces != Pieces::chain; ++i) {
        const Vec2 center = {static_cast<float>(i) + 0.5f, -0.5f};
        if (pieces == Pieces::boxes) world.add(make_box(0.5f, 0.5f), center, smooth, BodyType::static_body);
        if (pieces == Pieces::one_body) world->create_shape(one, make_offset_box(0.5f, 0.5f, {center, {}}), smooth);
    }
    BodyDef def = dynamic_at({0, 0.25f});
    BodyId slider;
    if (kind == SliderKind::box) slider = world.add(make_box(0.25f, 0.25f), def, smooth);
    if (kind == SliderKind::capsule) slider = world.add(Capsule{{-0.3f, 0}, {0.3f, 0}, 0.25f}, def, smooth);
    if (kind == SliderKind::ball) slider = world.add(Circle{{}, 0.25f}, def, smooth);
    if (kind == SliderKind::flat_bevel) slider = world.add(crate(0.2f, 0.035f), def, smooth);
    if (kind == SliderKind::bevel) slider = world.add(crate(0.1f, 0.05f), def, smooth);
    if (kind == SliderKind::chamfer) slider = world.add(crate(0.01f, 0.01f), def, smooth);
    if (kind == SliderKind::octagon) slider = world.add(octagon(), def, smooth);
    world.step(60);  // it settles
    world->set_linear_velocity(slider, {speed, 0});
    const float height = world->position(slider).y;
    Ride ride;
    for (int i = 0; static_cast<float>(i) < 60 * static_cast<float>(length) / speed; ++i) {
        world.step();
        ride.fastest_rise = std::fmax(ride.fastest_rise, std::fabs(double(world->linear_velocity(slider).y)));
        ride.highest = std::fmax(ride.highest, std::fabs(double(world->position(slider).y - height)));
        ride.turned = std::fmax(ride.turned, std::fabs(double(world->angle(slider))));
    }
    ride.speed_lost = double(speed - world->linear_velocity(slider).x);
    return ride;
}

class Floor : public testing::TestWithParam<std::tuple<Pieces, SliderKind, float>> {};

TEST_P(Floor, AKilometreOfItHasNoBump) {
    const auto [pieces, kind, speed] = GetParam();
    const Ride ride = slide(pieces, kind, speed);
    EXPECT_LT(ride.fastest_rise, 0.01) << "m/s, up or down";
    EXPECT_LT(ride.highest, 0.001) << "m";
    EXPECT_LT(std::fabs(ride.speed_lost), 0.001 * double(speed));
    EXPECT_LT(ride.turned, 0.01) << "rad";
}

std::string name_of_ride(const testing::TestParamInfo<Floor::ParamType>& test) {
    constexpr const char* floors[] = {"boxes", "boxes_of_one_body", "chain"};
    constexpr const char* sliders[] = {"box",    "capsule", "ball", "crate_bevelled_by_10_degrees", "crate_bevelled_by_27_degrees", "crate_chamfered_by_1_cm",
                                       "octagon"};
    return std::string(sliders[int(std::get<1>(test.param))]) + "_over_" + floors[int(std::get<0>(test.param))] + "_at_" +
           std::to_string(int(std::get<2>(test.param)));
}
INSTANTIATE_TEST_SUITE_P(Floors, Floor,
                         testing::Combine(testing::Values(Pieces::boxes, Pieces::one_body, Pieces::chain),
                                          testing::Values(SliderKind::box, SliderKind::capsule, SliderKind::ball, SliderKind::flat_bevel, SliderKind::bevel,
                                                          SliderKind::chamfer, SliderKind::octagon),
                                          testing::Values(5.0f, 50.0f)),
                         name_of_ride);

TEST(FloorOfPieces, AWallOnItStopsWhatSlides) {
    for (const auto& [wall_height, gap] : {std::pair{0.05f, 0.0f}, {0.3f, 0.0f}, {1.0f, 0.0f}, {0.02f, 0.02f}, {0.3f, 0.05f}}) {
        TestWorld world({.bodies = 32, .shapes = 32, .contacts = 64}, sleepless());
        for (int i = 0; i < 10; ++i) world.add(make_box(0.5f - 0.5f * gap, 0.5f), Vec2{static_cast<float>(i), -0.5f}, rough(0), BodyType::static_body);
        // Its top is that much higher than the floor's.
        world.add(make_box(0.5f, 0.5f), Vec2{10, wall_height - 0.5f}, rough(0), BodyType::static_body);
        BodyDef def = dynamic_at({0, 0.25f});
        def.linear_velocity = {5, 0};
        def.fixed_rotation = true;
        const BodyId box = world.add(make_box(0.25f, 0.25f), def, rough(0));
        world.step(300);
        EXPECT_NEAR(world->position(box).x, 9.25, 0.02) << "a wall of " << wall_height << " m, gaps of " << gap;
        EXPECT_NEAR(world->linear_velocity(box).x, 0, 1e-3);
    }
}

// Where two boxes meet at a ridge, their corners are those of one surface: what tips over it goes as fast as over a chain.
TEST(FloorOfPieces, ARidgeOfTwoPiecesIsThatOfAChain) {
    constexpr float reach = 10;  // m, of either piece
    for (const float degrees : {3.0f, 10.0f, 30.0f}) {
        const Rot down = make_rot(-degrees * pi / 180);
        const Vec2 along = rotate(down, {1, 0}), up = rotate(down, {0, 1});
        for (const float speed : {0.5f, 1.2f, 5.0f}) {
            for (int start = 0; start < 6; ++start) {
                for (const float bevel : {0.0f, 0.05f}) {
                    double speeds[2] = {0, 0};
                    for (const bool chain : {false, true}) {
                        TestWorld world({.bodies = 4, .shapes = 8, .contacts = 32}, sleepless());
                        const BodyId ground = world->create_body({});
                        const Vec2 ridge[] = {reach * along, {0, 0}, {-reach, 0}};
                        if (chain) {
                            world->create_chain(ground, ridge, false, rough(0));
                        } else {
                            world->create_shape(ground, make_offset_box(0.5f * reach, 0.5f, {{-0.5f * reach, -0.5f}, {}}), rough(0));
                            world->create_shape(ground, make_offset_box(0.5f * reach, 0.5f, {0.5f * reach * along - 0.5f * up, down}), rough(0));
                        }
                        BodyDef def = dynamic_at({-0.5f - speed + 0.06f * static_cast<float>(start), 0.25f});
                        def.linear_velocity = {speed, 0};
                        const BodyId body = world.add(bevel > 0 ? crate(2 * bevel, bevel) : make_box(0.5f, 0.25f), def, rough(0));
                        world.step(120);
                        speeds[chain ? 1 : 0] = double(length(world->linear_velocity(body)));
                    }
                    EXPECT_NEAR(speeds[0], speeds[1], 0.02 * speeds[1]) << degrees << " degrees, " << speed << " m/s, start " << start << ", bevel " << bevel;
                }
            }
        }
    }
}

// Flat floors whose pieces have gaps, round edges or leaning sides, or move: what is wider than a gap slides over them as over a plane.
enum class Kind { gaps_of_5_mm, gaps_of_5_cm, rounded_tiles, falling_diagonals, rising_diagonals, triangles_on_tips, dynamic_raft, wall_with_gaps };
enum class Load { box, rounded_box, chamfered_box, wide_foot, narrow_foot, triangle, capsule, sled };

// Adds a piece from x to x + 1, its top at y = 0.
void add_piece(TestWorld& world, BodyId ground, Kind kind, float x, const ShapeDef& material) {
    const auto add = [&](span<const Vec2> corners, float radius = 0) { world->create_shape(ground, make_polygon(compute_hull(corners), radius), material); };
    const Vec2 a = {x, 0}, b = {x + 1, 0}, c = {x, -1}, d = {x + 1, -1};
    if (kind == Kind::falling_diagonals || kind == Kind::rising_diagonals) {
        const Vec2 first[] = {c, kind == Kind::falling_diagonals ? d : b, a}, second[] = {d, b, kind == Kind::falling_diagonals ? a : c};
        add(first);
        add(second);
    } else if (kind == Kind::triangles_on_tips) {
        const Vec2 corners[] = {a, {x + 0.5f, -1}, b};
        add(corners);
    } else {
        const bool rounded = kind == Kind::rounded_tiles;
        const float inset = rounded ? 0.05f : kind == Kind::gaps_of_5_mm ? 0.0025f : kind == Kind::dynamic_raft ? 0.0f : 0.025f, top = rounded ? -0.05f : 0.0f;
        const Vec2 corners[] = {{x + inset, -0.9f}, {x + 1 - inset, -0.9f}, {x + 1 - inset, top}, {x + inset, top}};
        add(corners, rounded ? 0.05f : 0.0f);
    }
}

BodyId add_load(TestWorld& world, Load load, const BodyDef& def, const ShapeDef& material) {
    if (load == Load::sled) {  // of three boxes, so it has seams itself
        const BodyId sled = world->create_body(def);
        for (const float x : {-0.5f, 0.0f, 0.5f}) world->create_shape(sled, make_offset_box(0.25f, 0.4f, {{x, 0}, {}}), material);
        return sled;
    }
    const auto add = [&](span<const Vec2> corners) { return world.add(make_polygon(compute_hull(corners)), def, material); };
    const Vec2 chamfered[] = {{-0.3f, -0.4f}, {0.3f, -0.4f}, {0.4f, -0.3f}, {0.4f, 0.4f}, {-0.4f, 0.4f}, {-0.4f, -0.3f}};
    const Vec2 wide[] = {{-0.5f, -0.4f}, {0.5f, -0.4f}, {0.3f, 0.4f}, {-0.3f, 0.4f}}, narrow[] = {{-0.2f, -0.4f}, {0.2f, -0.4f}, {0.5f, 0.4f}, {-0.5f, 0.4f}};
    const Vec2 triangle[] = {{-0.4f, -0.4f}, {0.4f, -0.4f}, {0, 0.3f}};
    switch (load) {
        case Load::rounded_box: return world.add(make_rounded_box(0.32f, 0.32f, 0.08f), def, material);
        case Load::chamfered_box: return add(chamfered);
        case Load::wide_foot: return add(wide);
        case Load::narrow_foot: return add(narrow);
        case Load::triangle: return add(triangle);
        case Load::capsule: return world.add(Capsule{{-0.3f, 0}, {0.3f, 0}, 0.4f}, def, material);
        default: return world.add(make_box(0.4f, 0.4f), def, material);
    }
}

class RoughFloor : public testing::TestWithParam<std::tuple<Kind, Load>> {};

TEST_P(RoughFloor, IsAPlaneForWhatIsWiderThanItsGaps) {
    const auto [kind, load] = GetParam();
    const float across = kind == Kind::wall_with_gaps ? 0.5f * pi : 0;  // a wall is a floor on its side, with gravity that presses against it
    for (const float speed : {2.0f, 8.0f, 20.0f}) {
        for (int start = 0; start < 10; ++start) {
            WorldDef settings = sleepless();
            settings.gravity = rotate(make_rot(across), {0, -10});
            TestWorld world({.bodies = 4, .shapes = 160, .contacts = 256, .geometries = 160}, settings);
            if (kind == Kind::dynamic_raft) world.add(make_box(100, 1), Vec2{0, -1.9f}, rough(0), BodyType::static_body);
            BodyDef floor;
            floor.angle = across;
            if (kind == Kind::dynamic_raft) floor.type = BodyType::dynamic;
            const BodyId ground = world->create_body(floor);
            for (float x = -4; x < 2.5f * speed + 6; ++x) add_piece(world, ground, kind, x, rough(0));
            BodyDef def = dynamic_at(rotate(make_rot(across), {0.1f * static_cast<float>(start), 0.42f}));
            def.angle = across;
            def.linear_velocity = rotate(make_rot(across), {speed, 0});
            const BodyId body = add_load(world, load, def, rough(0));
            world.step(12);  // it lands
            const auto velocity = [&] { return inv_rotate(make_rot(across), world->linear_velocity(body) - world->linear_velocity(ground)); };
            double hop = 0;
            for (int i = 0; i < 130; ++i) {
                world.step();
                hop = std::fmax(hop, std::fabs(double(velocity().y)));
            }
            EXPECT_NEAR(velocity().x, speed, 0.005 * double(speed)) << speed << " m/s, start " << start;
            EXPECT_LT(hop, 0.05) << "m/s, at " << speed << " m/s, start " << start;
        }
    }
}

std::string name_of_slide(const testing::TestParamInfo<RoughFloor::ParamType>& test) {
    constexpr const char* floors[] = {"gaps_of_5_mm",     "gaps_of_5_cm",      "rounded_tiles",  "falling_diagonals",
                                      "rising_diagonals", "triangles_on_tips", "a_dynamic_raft", "a_wall_with_gaps"};
    constexpr const char* loads[] = {"box", "rounded_box", "chamfered_box", "wide_foot", "narrow_foot", "triangle", "capsule", "sled"};
    return std::string(loads[int(std::get<1>(test.param))]) + "_over_" + floors[int(std::get<0>(test.param))];
}
INSTANTIATE_TEST_SUITE_P(Floors, RoughFloor,
                         testing::Combine(testing::Values(Kind::gaps_of_5_mm, Kind::gaps_of_5_cm, Kind::rounded_tiles, Kind::falling_diagonals,
                                                          Kind::rising_diagonals, Kind::triangles_on_tips, Kind::dynamic_raft, Kind::wall_with_gaps),
                                          testing::Values(Load::box, Load::rounded_box, Load::chamfered_box, Load::wide_foot, Load::narrow_foot, Load::triangle,
                                                          Load::capsule, Load::sled)),
                         name_of_slide);

TEST(FloorOfPieces, FrictionBrakesABoxAsOnASlab) {
    constexpr float speed = 10, friction = 0.3f;
    constexpr double way = double(speed) * double(speed) / (2 * double(friction) * g);  // m: Coulomb's
    for (const Kind kind :
         {Kind::gaps_of_5_mm, Kind::gaps_of_5_cm, Kind::rounded_tiles, Kind::falling_diagonals, Kind::rising_diagonals, Kind::triangles_on_tips}) {
        for (const Load load : {Load::box, Load::rounded_box, Load::wide_foot, Load::sled}) {
            for (int start = 0; start < 10; ++start) {
                TestWorld world({.bodies = 4, .shapes = 128, .contacts = 256, .geometries = 128}, sleepless());
                const BodyId ground = world->create_body({});
                for (float x = -4; x < 24; x += 1) add_piece(world, ground, kind, x, rough(friction));
                const float from = 0.1f * static_cast<float>(start);
                BodyDef def = dynamic_at({from, 0.4f});
                def.linear_velocity = {speed, 0};
                const BodyId body = add_load(world, load, def, rough(friction));
                world.step(300);
                EXPECT_NEAR(double(world->position(body).x - from), way, 0.01 * way) << "floor " << int(kind) << ", load " << int(load) << ", start " << start;
            }
        }
    }
}

// The same with gaps of 5 cm, where the setting is off, is turned off before the box comes, and is turned on again before.
TEST(FloorOfPieces, SwitchedOffBodiesCatchAtEdges) {
    constexpr double way = 10.0 * 10 / (2 * 0.3 * g);  // m: Coulomb's
    const auto slid = [](bool made_seamless, bool seamless) {
        double sum = 0;
        for (int start = 0; start < 10; ++start) {
            WorldDef settings = sleepless();
            settings.seamless_floors = made_seamless;
            TestWorld world({.bodies = 4, .shapes = 128, .contacts = 256, .geometries = 128}, settings);
            EXPECT_EQ(world->seamless_floors(), made_seamless);
            const BodyId ground = world->create_body({});
            for (float x = -4; x < 24; x += 1) add_piece(world, ground, Kind::gaps_of_5_cm, x, rough(0.3f));
            world->enable_seamless_floors(seamless);
            BodyDef def = dynamic_at({0.1f * static_cast<float>(start), 0.4f});
            def.linear_velocity = {10, 0};
            const BodyId body = add_load(world, Load::box, def, rough(0.3f));
            world.step(300);
            sum += double(world->position(body).x) - 0.1 * start;
        }
        return sum / 10;
    };
    EXPECT_NEAR(slid(true, true), way, 0.01 * way);
    EXPECT_NEAR(slid(false, true), way, 0.01 * way);
    EXPECT_LT(slid(false, false), 0.8 * way);
    EXPECT_LT(slid(true, false), 0.8 * way);
}

// Hills cut into triangles are those of a chain of the same form: they take as little energy, in the mean of ten starts.
TEST(FloorOfPieces, HillsOfTrianglesTakeTheEnergyThatAChainTakes) {
    constexpr float speed = 8;  // m/s
    const auto hill = [](float x) { return 0.1f * std::sin(0.5f * x); };
    for (const Load load : {Load::box, Load::narrow_foot, Load::triangle}) {
        double lost[3] = {0, 0, 0};  // over triangles cut this way, that way, and over a chain; of the kinetic energy
        for (int cut = 0; cut < 3; ++cut) {
            for (int start = 0; start < 10; ++start) {
                TestWorld world({.bodies = 4, .shapes = 128, .contacts = 128, .geometries = 128}, sleepless());
                const BodyId ground = world->create_body({});
                std::vector<Vec2> points;
                for (float x = 40; x >= -4; x -= 1) points.push_back({x, hill(x)});
                if (cut == 2) world->create_chain(ground, points, false, rough(0));
                for (float x = -4; x < 40 && cut != 2; x += 1) {
                    const Vec2 a = {x, hill(x)}, b = {x + 1, hill(x + 1)}, c = a - Vec2{0, 1}, d = b - Vec2{0, 1};
                    const Vec2 first[] = {c, cut == 0 ? d : b, a}, second[] = {d, b, cut == 0 ? a : c};
                    for (const span<const Vec2> corners : {span<const Vec2>(first), span<const Vec2>(second)})
                        world->create_shape(ground, make_polygon(compute_hull(corners)), rough(0));
                }
                const float from = 0.1f * static_cast<float>(start);
                BodyDef def = dynamic_at({from, hill(from) + 0.55f});
                def.linear_velocity = {speed, 0};
                const BodyId body = add_load(world, load, def, rough(0));
                world.step(20);  // it lands
                const double before = energy_of(*world, span(&body, 1));
                world.step(160);
                lost[cut] += 0.1 * (before - energy_of(*world, span(&body, 1))) / (0.5 * double(world->mass(body) * speed * speed));
            }
        }
        EXPECT_NEAR(lost[0], lost[2], 0.02) << "load " << int(load);
        EXPECT_NEAR(lost[1], lost[2], 0.02) << "load " << int(load);
    }
}

// A gap is no floor: what fits into it goes in, and a ball rests on both its edges.
TEST(FloorOfPieces, ABallRestsOnTheEdgesOfAGap) {
    for (const float radius : {0.03f, 0.1f, 0.4f}) {
        for (const float gap : {0.005f, 0.02f, 0.05f}) {
            TestWorld world({.bodies = 4, .shapes = 4, .contacts = 16}, sleepless());
            for (const float side : {-1.0f, 1.0f}) world.add(make_box(1, 0.5f), Vec2{side * (1 + 0.5f * gap), -0.5f}, rough(0.5f), BodyType::static_body);
            const BodyId ball = world.add(Circle{{}, radius}, dynamic_at({0.001f, radius}), rough(0.5f));
            world.step(300);
            const double half = 0.5 * double(gap), height = std::sqrt(double(radius) * double(radius) - half * half);
            EXPECT_NEAR(world->position(ball).x, 0, 0.003) << "radius " << radius << ", gap " << gap;
            EXPECT_NEAR(world->position(ball).y, height, 0.003) << "radius " << radius << ", gap " << gap;
        }
    }
    TestWorld world({.bodies = 4, .shapes = 4, .contacts = 16}, sleepless());
    for (const float side : {-1.0f, 1.0f}) world.add(make_box(1, 0.5f), Vec2{1.06f * side, -0.5f}, rough(0.5f), BodyType::static_body);
    const BodyId box = world.add(make_box(0.05f, 0.05f), dynamic_at({0, 0.06f}), rough(0.5f));
    world.step(120);
    EXPECT_LT(world->position(box).y, -1) << "a box of 10 cm falls through a gap of 12 cm";
}

TEST(FloorOfPieces, ARidgeOfTwoPiecesCarriesABall) {
    // Two slopes meet at a ridge of 20 degrees on either side: a ball that rolls slowly over it keeps to the surface.
    TestWorld world({.bodies = 8, .shapes = 8, .contacts = 32}, sleepless());
    const float slope = 20 * pi / 180;
    const Vec2 left[] = {{0, 0}, {-4, -4 * 0.36397f}, {-4, -4}, {0, -4}}, right[] = {{0, 0}, {0, -4}, {4, -4}, {4, -4 * 0.36397f}};
    world.add(make_polygon(compute_hull(left)), Vec2{0, 0}, rough(1), BodyType::static_body);
    world.add(make_polygon(compute_hull(right)), Vec2{0, 0}, rough(1), BodyType::static_body);
    const float r = 0.2f;
    BodyDef def = dynamic_at({-2 - r * make_rot(slope).s, -2 * 0.36397f + r * make_rot(slope).c});
    def.linear_velocity = rotate(make_rot(slope), {3.3f, 0});
    def.angular_velocity = -3.3f / r;
    const BodyId ball = world.add(Circle{{}, r}, def, rough(1));
    double deepest = 0, highest = 0;
    bool over = false;
    for (int i = 0; i < 240 && world->position(ball).x < 3; ++i) {
        world.step();
        const Vec2 p = world->position(ball);
        over |= p.x > 1;
        // Distance of its surface from the ridge line: from the corner between the slopes' normals, from a slope elsewhere.
        const double x = std::fabs(double(p.x)), y = double(p.y), c = std::cos(double(slope)), s = std::sin(double(slope));
        const double along = x * c - y * s, gap = along < 0 ? std::hypot(x, y) - double(r) : x * s + y * c - double(r);
        deepest = std::fmax(deepest, -gap);
        highest = std::fmax(highest, x < 0.5 ? gap : 0);
    }
    EXPECT_TRUE(over);
    EXPECT_LT(deepest, 0.01);
    EXPECT_LT(highest, 0.02);
}

}  // namespace
}  // namespace islet::test
