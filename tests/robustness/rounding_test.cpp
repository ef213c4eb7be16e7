// Worlds in which numbers are rounded by as much as things are large: whatever legal calls leave behind is sound, and its own snapshot can be loaded.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "data/core.hpp"
#include "support/image.hpp"
#include "support/random.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

void expect_sound(TestWorld& w, const std::string& when) {
    const char* broken = w->validate();
    ASSERT_EQ(broken, nullptr) << broken << ": " << when;
    const Image image = save(*w);
    TestWorld other(w->capacity());
    ASSERT_TRUE(other->load(image.bytes())) << describe(other->last_error()) << ": " << when;
    ASSERT_EQ(other->hash(), w->hash());
}

WorldDef floating() { return {.gravity = {0, 0}}; }

void add_shape(World& w, BodyId body, int kind, float size) {
    switch (kind) {
        case 0: w.create_shape(body, Circle{{0.1f * size, 0}, size}); break;
        case 1: w.create_shape(body, make_box(size, 0.5f * size)); break;
        case 2: w.create_shape(body, Capsule{{-size, 0.2f * size}, {size, 0}, 0.3f * size}); break;
        default: w.create_shape(body, Segment{{-size, 0.1f}, {size, 0}});
    }
}

struct Change {
    const char* name;
    void (*make)(World& w, BodyId body);
};

const Change changes[] = {
    {"nothing", [](World&, BodyId) {}},
    {"reset_mass", [](World& w, BodyId b) { w.reset_mass(b); }},
    {"set_mass", [](World& w, BodyId b) { w.set_mass(b, {2, {0.3f, 0.1f}, 0.5f}); }},
    {"set_mass far", [](World& w, BodyId b) { w.set_mass(b, {2, {1e6f, -3e5f}, 0.5f}); }},
    {"set_density", [](World& w, BodyId b) {
         ShapeId shape;
         w.shapes(b, {&shape, 1});
         w.set_density(shape, 3);
     }},
    {"create_shape", [](World& w, BodyId b) { w.create_shape(b, Circle{{1, 1}, 0.3f}); }},
    {"destroy_shape", [](World& w, BodyId b) {
         ShapeId shape;
         w.shapes(b, {&shape, 1});
         w.destroy_shape(shape);
     }},
    {"set_circle", [](World& w, BodyId b) {
         ShapeId shape;
         w.shapes(b, {&shape, 1});
         w.set_circle(shape, Circle{{0.2f, 0}, 0.5f});
     }},
    {"set_fixed_rotation", [](World& w, BodyId b) { w.set_fixed_rotation(b, true); }},
    {"set_type static", [](World& w, BodyId b) { w.set_type(b, BodyType::static_body); }},
    {"set_type kinematic", [](World& w, BodyId b) { w.set_type(b, BodyType::kinematic); }},
    {"set_enabled", [](World& w, BodyId b) {
         w.set_enabled(b, false);
         w.set_enabled(b, true);
     }},
};

// With its centre of mass far away a body's origin is known as exactly as numbers are there, from step to step; given another centre, its boxes must be right.
TEST(Rounding, ACentreOfMassMayComeBackFromFarAway) {
    Random random(1);
    for (const float far : {10.0f, 100.0f, 1e3f, 1e4f, 1e5f, 1e6f, 1e7f}) {
        for (const Change& change : changes) {
            for (int start = 0; start < 10; ++start) {
                TestWorld w({.bodies = 8, .shapes = 8, .contacts = 16}, floating());
                w.add_ground(-20);
                BodyDef def;
                def.type = BodyType::dynamic;
                def.position = {random.between(-5, 5), random.between(-5, 5)};
                def.angle = random.between(-3, 3);
                const BodyId body = w->create_body(def);
                add_shape(*w, body, start % 4, 0.6f);
                w->set_mass(body, {1, {random.between(-1, 1) * far, start % 2 == 0 ? far : -far}, 1});
                if (start % 3 == 0) w->set_angular_velocity(body, random.between(-1, 1));
                const std::string when = std::string(change.name) + ", centre at " + std::to_string(far) + ", start " + std::to_string(start);
                w.step(1 + start % 3);
                ASSERT_NO_FATAL_FAILURE(expect_sound(w, "before " + when));
                change.make(*w, body);
                ASSERT_NO_FATAL_FAILURE(expect_sound(w, "at once after " + when));
                w.step();
                ASSERT_NO_FATAL_FAILURE(expect_sound(w, "a step after " + when));
                w->reset_mass(body);
                ASSERT_NO_FATAL_FAILURE(expect_sound(w, "reset after " + when));
                w.step(3);
                ASSERT_NO_FATAL_FAILURE(expect_sound(w, "steps after " + when));
            }
        }
    }
}

// The ends of a large shape are rounded as numbers of their size are, however near the centre is.
TEST(Rounding, AShapeOfAnySizeMayMoveAndTurn) {
    Random random(2);
    for (const float size : {1.0f, 1e2f, 1e4f, 1e5f, 1e6f, 5e6f}) {
        for (int start = 0; start < 12; ++start) {
            TestWorld w({.bodies = 8, .shapes = 8, .contacts = 16}, floating());
            BodyDef def;
            def.type = start % 2 == 0 ? BodyType::dynamic : BodyType::kinematic;
            def.enable_sleep = false;
            def.position = {random.between(-5, 5), random.between(-5, 5)};
            def.angle = random.between(-3, 3);
            const float slow = start % 3 == 0 ? 1.0f : start % 3 == 1 ? 1e-3f : 1e-5f;
            def.linear_velocity = {random.between(-1, 1) * slow, random.between(-1, 1) * slow};
            def.angular_velocity = start < 6 ? slow * random.between(-1, 1) / size : slow * random.between(-1, 1);
            const BodyId body = w->create_body(def);
            add_shape(*w, body, start % 4, size);
            if (start % 5 == 0) add_shape(*w, body, (start + 1) % 4, 0.5f);
            for (int i = 0; i < 60; ++i) {
                w.step();
                ASSERT_NO_FATAL_FAILURE(expect_sound(w, "size " + std::to_string(size) + ", start " + std::to_string(start) + ", step " + std::to_string(i)));
            }
        }
    }
}

// Each step is rounded to what numbers there are: 0.6 of the distance between two becomes a whole one.
TEST(Rounding, AStepMayBeRoundedUpForEver) {
    for (const float place : {0.3f, 10.0f, 300.0f, 1000.0f, 3000.0f, 30e3f, 1e6f, 9e6f}) {
        for (const float part : {0.3f, 0.51f, 0.6f, 0.9f, 1.4f, 3.5f}) {
            TestWorld w({.bodies = 8, .shapes = 8, .contacts = 16}, floating());
            const float spacing = std::bit_cast<float>(std::bit_cast<std::uint32_t>(place) + 1) - place;
            BodyDef def;
            def.type = BodyType::kinematic;
            def.position = {place, 0};
            def.enable_sleep = false;
            def.linear_velocity = {60 * part * spacing, 0};
            const BodyId body = w->create_body(def);
            w->create_shape(body, make_box(0.5f, 0.5f));
            for (int i = 0; i < 40; ++i) {
                w.step(100);
                ASSERT_NO_FATAL_FAILURE(expect_sound(w, "at " + std::to_string(place) + ", part " + std::to_string(part)));
            }
        }
    }
}

// What rounding cannot have done is a fault still.
TEST(Rounding, ABoxThatIsOffIsAFault) {
    for (const float off : {0.08f, 0.12f, 0.2f}) {
        TestWorld w(roomy, floating());
        const BodyId box = w.add_box({3, 4});
        w->set_linear_velocity(box, {1, 0});
        w.step(100);
        ASSERT_EQ(w->validate(), nullptr);
        detail::Core& core = detail::Core::of(*w);
        const Aabb good = core.boxes[0];
        core.boxes[0] = {{good.lower.x + off, good.lower.y}, {good.upper.x + off, good.upper.y}};
        EXPECT_NE(w->validate(), nullptr) << "moved by " << off;
        core.boxes[0] = good;
        const float slack = core.motions[0].slack;
        core.motions[0].slack += off;
        EXPECT_NE(w->validate(), nullptr) << "slack " << off;
        core.motions[0].slack = slack;
        core.poses[0].center.x += 1e-4f;
        EXPECT_NE(w->validate(), nullptr) << "the centre";
    }
}

// Any density that is taken leaves a sound world.
TEST(Rounding, AnyDensityIsRefusedOrSound) {
    for (const float density : {1e-30f, 1e10f, 1e30f, 1e38f, 3.4e38f}) {
        for (const float size : {0.01f, 1.0f, 100.0f, 1e5f}) {
            for (int kind = 0; kind < 3; ++kind) {
                TestWorld w({.bodies = 8, .shapes = 8, .contacts = 16}, floating());
                const BodyId body = w->create_body({.type = BodyType::dynamic, .angular_velocity = 1});
                add_shape(*w, body, kind, size);
                add_shape(*w, body, (kind + 1) % 3, 0.5f * size);
                ShapeId shape;
                w->shapes(body, {&shape, 1});
                w->set_density(shape, density);
                const std::string when = "density " + std::to_string(density) + ", size " + std::to_string(size) + ", kind " + std::to_string(kind);
                ASSERT_NO_FATAL_FAILURE(expect_sound(w, when));
                w.step(3);
                ASSERT_NO_FATAL_FAILURE(expect_sound(w, when));
                w->set_density(shape, 1);
                ASSERT_NO_FATAL_FAILURE(expect_sound(w, when));
            }
        }
    }
}

}  // namespace
}  // namespace islet::test
