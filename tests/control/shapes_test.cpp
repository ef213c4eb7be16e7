// Changing shapes where they are, and pushing them: geometry, density, explosions, wind, contacts of a body.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/random.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

// -- geometry ----------------------------------------------------------------------------------------------------------------------------

TEST(Geometry, CanBeReplacedUnderALivingShape) {
    TestWorld w;
    w.add_ground();
    const BodyId body = w.add_circle({0, 0.5f});
    const ShapeId shape = w.shape_of(body);
    w.step(20);
    ASSERT_EQ(w.contacts().size(), 1u);
    w->set_polygon(shape, make_box(1, 0.25f));
    EXPECT_EQ(w->end_touch_events().size(), 1u);
    EXPECT_EQ(w->shape_type(shape), ShapeType::polygon);
    EXPECT_NEAR(w->mass(body), 1, 1e-6f) << "2 m by 0.5 m at 1 kg/m^2";
    EXPECT_EQ(w->validate(), nullptr);
    w.step(60);
    EXPECT_NEAR(w->position(body).y, 0.25f, 0.01f);
    w.step(120);
    ASSERT_FALSE(w->is_awake(body));
    w->set_capsule(shape, {{-1, 0}, {1, 0}, 0.4f});
    EXPECT_TRUE(w->is_awake(body));
    EXPECT_NEAR(w->mass(body), 2 * 0.8f + pi * 0.16f, 1e-5f);
    EXPECT_EQ(w->validate(), nullptr);
    w.step(60);
    EXPECT_NEAR(w->position(body).y, 0.4f, 0.012f);
    const ShapeId wall = w.shape_of(w.add_box({3, 0}, 1, 1, {}, BodyType::static_body));
    w->set_segment(wall, {{-1, 0.5f}, {1, 0.5f}});
    w->set_circle(shape, {{0, 0}, 0.3f});
    w.step(60);
    EXPECT_EQ(w->validate(), nullptr);
    EXPECT_NEAR(w->position(body).y, 0.3f, 0.01f);
    EXPECT_EQ(w->last_error(), Error::none);
}

TEST(Geometry, IsReplacedOnlyWhereThereIsRoom) {
    TestWorld w(Capacity{.bodies = 4, .shapes = 4, .contacts = 4, .geometries = 2});
    const ShapeId a = w.shape_of(w.add_circle({0, 0}, 1)), b = w.shape_of(w.add_circle({3, 0}, 1)), c = w.shape_of(w.add_circle({6, 0}, 2));
    const std::uint64_t before = w->hash();
    w->set_circle(a, {{0, 0}, 3});
    EXPECT_EQ(w->last_error(), Error::geometries_full);
    EXPECT_EQ(w->hash(), before);
    w->clear_error();
    w->set_circle(c, {{0, 0}, 3});
    EXPECT_EQ(w->last_error(), Error::none) << "it gives its own back";
    EXPECT_EQ(w->circle(c)->radius, 3);
    w->set_circle(a, {{0, 0}, 3});
    EXPECT_EQ(w->last_error(), Error::none) << "it shares";
    w->set_circle(b, {{0, 0}, 1});
    EXPECT_EQ(w->validate(), nullptr);
}

TEST(Density, DecidesTheMass) {
    TestWorld w;
    const BodyId body = w.add_box({0, 0}, 1, 1);
    EXPECT_EQ(w->density(w.shape_of(body)), 1);
    w->set_density(w.shape_of(body), 2.5f);
    EXPECT_EQ(w->density(w.shape_of(body)), 2.5f);
    EXPECT_NEAR(w->mass(body), 10, 1e-5f);
    EXPECT_NEAR(w->rotational_inertia(body), 10 * 8.0f / 12, 1e-4f);
}

// -- contacts ----------------------------------------------------------------------------------------------------------------------------

TEST(Contacts, OfABodyAreThoseOfTheWorldThatItIsPartOfAndBearItsWeight) {
    TestWorld w;
    w.add_ground();
    std::vector<BodyId> stack;
    for (int i = 0; i < 4; ++i) stack.push_back(w.add_box({0, 0.5f + static_cast<float>(i)}));
    w.step(40);
    for (std::size_t i = 0; i < stack.size(); ++i) {
        std::vector<ContactInfo> own(w->contacts(stack[i], {}));
        ASSERT_EQ(own.size(), i + 1 < stack.size() ? 2u : 1u);
        EXPECT_EQ(w->contacts(stack[i], std::span(own).first(1)), own.size()) << "says how many there are";
        w->contacts(stack[i], own);
        float below = 0;
        for (const ContactInfo& c : own) {
            EXPECT_TRUE(w->body(c.shape_a) == stack[i] || w->body(c.shape_b) == stack[i]);
            const BodyId other = w->body(c.shape_a) == stack[i] ? w->body(c.shape_b) : w->body(c.shape_a);
            if (w->position(other).y > w->position(stack[i]).y) continue;
            for (std::uint32_t k = 0; k < c.point_count; ++k) below += c.points[k].normal_impulse;
        }
        // As the comment on ContactPoint says: over a substep of dt / 4.
        EXPECT_NEAR(below / (1.0f / 240), 10 * static_cast<float>(stack.size() - i), 0.3f) << "N, of the boxes from " << i << " on";
    }
}

// -- explosions --------------------------------------------------------------------------------------------------------------------------

TEST(Explosion, PushesASquareThatFacesItByItsSide) {
    for (const float falloff : {0.0f, 2.0f, 4.0f}) {
        TestWorld w(roomy, {.gravity = {0, 0}});
        const BodyId box = w.add_box({3, 0}, 1, 1, {.density = 0.5f});  // 2 kg, 1 m from the middle of its face to radius 1
        w->explode({.radius = 1, .falloff = falloff, .impulse_per_length = 5});
        // The face is 2 m away and 2 m wide; of the falloff half is left at 2 m, or three quarters at 4 m.
        const float left = falloff == 0 ? 0 : 1 - 1 / falloff;
        EXPECT_NEAR(w->linear_velocity(box).x, 5 * 2 * left / 2, 1e-5f) << falloff;
        EXPECT_NEAR(w->linear_velocity(box).y, 0, 1e-6f);
        EXPECT_NEAR(w->angular_velocity(box), 0, 1e-6f);
    }
}

TEST(Explosion, PushesByTheWidthAcrossItsDirection) {
    struct Case {
        const char* what;
        float width;
        BodyId body;
    };
    TestWorld w(roomy, {.gravity = {0, 0}});
    std::vector<Case> cases;
    // All of them 10 m from the explosion, in one direction after another, which they face as they stand.
    const auto at = [](int i) { return 10.0f * Vec2{make_rot(static_cast<float>(i)).c, make_rot(static_cast<float>(i)).s}; };
    cases.push_back({"disc", 1, w.add_circle(at(0), 0.5f)});
    cases.push_back({"bar end on", 0.4f, w.add(Capsule{{-1, 0}, {1, 0}, 0.2f}, {.type = BodyType::dynamic, .position = at(1), .angle = 1})});
    cases.push_back({"bar across", 2.4f, w.add(Capsule{{0, -1}, {0, 1}, 0.2f}, {.type = BodyType::dynamic, .position = at(2), .angle = 2})});
    cases.push_back({"rounded box", 1.2f, w.add(make_rounded_box(0.9f, 0.5f, 0.1f), {.type = BodyType::dynamic, .position = at(3), .angle = 3})});
    cases.push_back({"diamond", std::sqrt(2.0f), w.add(make_box(0.5f, 0.5f), {.type = BodyType::dynamic, .position = at(4), .angle = 4 + pi / 4})});
    w->explode({.radius = 20, .impulse_per_length = -3});
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Vec2 impulse = w->mass(cases[i].body) * w->linear_velocity(cases[i].body);
        const Vec2 inwards = -0.1f * at(static_cast<int>(i));
        EXPECT_NEAR(dot(impulse, inwards), 3 * cases[i].width, 2e-3f) << cases[i].what;
        EXPECT_NEAR(cross(impulse, inwards), 0, 2e-3f) << cases[i].what;
    }
}

TEST(Explosion, ActsWhereTheShapeIsNearest) {
    TestWorld w(roomy, {.gravity = {0, 0}});
    const BodyId plank = w.add_box({0, 1}, 2, 0.1f);
    w->explode({.position = {1, 0}, .radius = 3, .impulse_per_length = 1});
    // Straight up under its right half: 4 m wide, at an arm of 1 m.
    EXPECT_NEAR(w->linear_velocity(plank).y, 4 / w->mass(plank), 1e-4f);
    EXPECT_NEAR(w->angular_velocity(plank), 4 * 1 / w->rotational_inertia(plank), 1e-4f);
}

TEST(Explosion, InsideAShapePushesItsMiddleAway) {
    TestWorld w(roomy, {.gravity = {0, 0}});
    const BodyId box = w.add_box({0, 0}, 1, 1), ball = w.add_circle({10, 0}, 1);
    w->explode({.position = {-0.5f, 0}, .radius = 1, .impulse_per_length = 2});
    EXPECT_NEAR(w->linear_velocity(box).x, 2 * 2 / w->mass(box), 1e-5f);
    EXPECT_EQ(w->angular_velocity(box), 0);
    w->explode({.position = {10, 0}, .radius = 1, .impulse_per_length = 2});
    EXPECT_NEAR(length(w->linear_velocity(ball)), 2 * 2 / w->mass(ball), 1e-5f);
}

TEST(Explosion, WakesWhatItReachesAndSparesSensorsOtherCategoriesAndWhatIsFixed) {
    TestWorld w;
    w.add_ground();
    const BodyId near = w.add_box({0, 0.5f}), far = w.add_box({30, 0.5f}), other = w.add_box({2, 0.5f}, 0.5f, 0.5f, {.filter = {.category = 2}});
    const BodyId platform = w.add_box({-3, 0}, 1, 1, {}, BodyType::kinematic);
    w.step(90);
    ASSERT_FALSE(w->is_awake(near));
    w->explode({.position = {0, -1}, .radius = 5, .impulse_per_length = 10, .mask = 1});
    EXPECT_TRUE(w->is_awake(near));
    EXPECT_GT(w->linear_velocity(near).y, 5);
    EXPECT_FALSE(w->is_awake(far));
    EXPECT_FALSE(w->is_awake(other));
    EXPECT_EQ(w->linear_velocity(platform), Vec2{});
    const BodyId sensor = w.add_box({0, 9}, 1, 1, {.sensor = true});
    w->explode({.position = {0, 7}, .radius = 5, .impulse_per_length = 10});
    EXPECT_EQ(w->linear_velocity(sensor), Vec2{});
}

// -- wind --------------------------------------------------------------------------------------------------------------------------------

// F = rho u^2 / 2 times area times coefficient, over one step of dt: dv = F dt / m.
TEST(Wind, PushesDiscsAndSquaresByTheirWidth) {
    const float q = 0.5f * 1.225f * 64;
    TestWorld w(roomy, {.gravity = {0, 0}});
    const BodyId disc = w.add_circle({0, 0}, 0.5f), square = w.add_box({10, 0}, 1, 1), diamond = w.add_box({20, 0}, 1, 1);
    w->set_transform(diamond, {20, 0}, pi / 4);
    for (const BodyId body : {disc, square, diamond}) w->apply_wind(w.shape_of(body), {.velocity = {8, 0}, .drag = 1.5f, .lift = 0.7f});
    w.step(1, 0.01f);
    EXPECT_NEAR(w->linear_velocity(disc).x, 1.5f * q * 1 * 0.01f / w->mass(disc), 1e-4f);
    EXPECT_NEAR(w->linear_velocity(square).x, 1.5f * q * 2 * 0.01f / 4, 1e-4f);
    EXPECT_NEAR(w->linear_velocity(diamond).x, 1.5f * q * 2 * std::sqrt(2.0f) * 0.01f / 4, 1e-4f);
    for (const BodyId body : {disc, square, diamond}) {
        EXPECT_NEAR(w->linear_velocity(body).y, 0, 1e-5f) << "lift of faces that are alike cancels";
        EXPECT_NEAR(w->angular_velocity(body), 0, 1e-5f);
    }
}

// A plate at an angle a to the stream offers sin a of its length and is lifted by q c L sin a cos a, its lower face to the wind.
TEST(Wind, LiftsAPlateByItsAngle) {
    for (const float degrees : {10.0f, 30.0f, 60.0f}) {
        const float a = degrees * pi / 180;
        TestWorld w(roomy, {.gravity = {0, 0}});
        const BodyId plate = w.add(make_box(1, 0.0001f), {.type = BodyType::dynamic, .angle = -a}, {.density = 1000});
        w->apply_wind(w.shape_of(plate), {.velocity = {-10, 0}, .drag = 0, .lift = 2});
        w.step(1, 0.01f);
        // The stream comes from the right and the right end is low, so the plate is pressed down.
        const float force = 0.5f * 1.225f * 100 * 2 * 2 * std::sin(a) * std::cos(a);
        EXPECT_NEAR(w->linear_velocity(plate).y, -force * 0.01f / w->mass(plate), 0.002f * force * 0.01f / w->mass(plate) + 1e-4f) << degrees;
        EXPECT_NEAR(w->linear_velocity(plate).x, 0, 1e-4f * force);
    }
}

// It falls until drag bears its weight: m g = rho c A v^2 / 2.
TEST(Wind, OfItsOwnFallGivesABodyATerminalSpeed) {
    TestWorld w;
    const BodyId ball = w.add_circle({0, 0}, 0.2f, {.density = 3});
    for (int i = 0; i < 1200; ++i) {
        w->apply_wind(w.shape_of(ball), {.drag = 0.9f});
        w.step();
    }
    const float terminal = std::sqrt(2 * w->mass(ball) * 10 / (1.225f * 0.9f * 0.4f));
    EXPECT_NEAR(w->linear_velocity(ball).y, -terminal, 0.02f * terminal);
}

TEST(Wind, TurnsWhatItStrikesOffCentreAndLeavesSleepersIfAsked) {
    TestWorld w(roomy, {.gravity = {0, 0}});
    const BodyId vane = w->create_body({.type = BodyType::dynamic, .awake = false});
    w->create_shape(vane, Circle{{0, 0}, 0.5f}, {.density = 5});
    const ShapeId sail = w->create_shape(vane, make_offset_box(0.1f, 1, {{0, 2}, {}}));
    w->apply_wind(sail, {.velocity = {5, 0}, .wake = false});
    EXPECT_FALSE(w->is_awake(vane));
    w->apply_wind(sail, {.velocity = {5, 0}});
    EXPECT_TRUE(w->is_awake(vane));
    const float inertia = w->rotational_inertia(vane), arm = 2 - w->center_of_mass(vane).y;
    w.step(1, 0.01f);
    EXPECT_NEAR(w->angular_velocity(vane), -0.5f * 1.225f * 25 * 2 * arm * 0.01f / inertia, 1e-4f);
}

// A breeze of 0.5 * 1.225 * 1 * 1 = 0.6 N on a box of 10 N that friction holds, in every step for 2 s.
TEST(Wind, LetsABodyAtRestFallAsleepIfAsked) {
    for (const bool wake : {false, true}) {
        TestWorld w;
        w.add_ground();
        const BodyId box = w.add_box({0, 0.5f});
        for (int i = 0; i < 120; ++i) {
            w->apply_wind(w.shape_of(box), {.velocity = {1, 0}, .wake = wake});
            w.step();
        }
        EXPECT_EQ(w->is_awake(box), wake);
    }
}

}  // namespace
}  // namespace islet::test
