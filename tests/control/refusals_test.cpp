// Bad input to what leads, changes and pushes bodies and shapes: refused by name, and nothing has changed. And images that lie about sensors, locks, disabled
// bodies and hooks.
#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "robustness/refusal.hpp"
#include "support/forge.hpp"
#include "support/joint_world.hpp"

namespace islet::test {
namespace {

class ControlRefusal : public RefusalTest {};

TEST_F(ControlRefusal, EveryFunctionOfABodyRefusesNullAndStaleIds) {
    const std::vector<std::function<void(BodyId)>> calls = {
        [&](BodyId b) { w->set_target(b, {}, 0.1f); },     [&](BodyId b) { w->lock_x(b, true); },
        [&](BodyId b) { w->lock_y(b, true); },             [&](BodyId b) { EXPECT_FALSE(w->is_x_locked(b)); },
        [&](BodyId b) { EXPECT_FALSE(w->is_y_locked(b)); }, [&](BodyId b) { EXPECT_FALSE(w->is_rotation_fixed(b)); },
        [&](BodyId b) { w->set_enabled(b, false); },       [&](BodyId b) { EXPECT_FALSE(w->is_enabled(b)); },
        [&](BodyId b) { w->set_sleep_threshold(b, 1); },   [&](BodyId b) { EXPECT_EQ(w->sleep_threshold(b), 0); },
        [&](BodyId b) { EXPECT_EQ(w->contacts(b, {}), 0u); },
    };
    for (std::size_t i = 0; i < calls.size(); ++i) {
        SCOPED_TRACE(i);
        expect_refused(Error::null_id, [&] { calls[i]({}); });
        expect_refused(Error::stale_id, [&] { calls[i](stale_body); });
    }
}

TEST_F(ControlRefusal, EveryFunctionOfAShapeRefusesNullAndStaleIds) {
    const std::vector<std::function<void(ShapeId)>> calls = {
        [&](ShapeId s) { w->set_circle(s, {}); },
        [&](ShapeId s) { w->set_capsule(s, {{0, 0}, {1, 0}, 1}); },
        [&](ShapeId s) { w->set_segment(s, {{0, 0}, {1, 0}}); },
        [&](ShapeId s) { w->set_polygon(s, make_box(1, 1)); },
        [&](ShapeId s) { EXPECT_EQ(w->density(s), 0); },
        [&](ShapeId s) { w->set_density(s, 1); },
        [&](ShapeId s) { EXPECT_EQ(w->material(s), SurfaceMaterial{}); },
        [&](ShapeId s) { w->set_material(s, {}); },
        [&](ShapeId s) { EXPECT_FALSE(w->is_sensor(s)); },
        [&](ShapeId s) { EXPECT_EQ(w->sensor_overlaps(s, {}), 0u); },
        [&](ShapeId s) { EXPECT_FALSE(w->sensor_events_enabled(s)); },
        [&](ShapeId s) { w->enable_sensor_events(s, false); },
        [&](ShapeId s) { EXPECT_FALSE(w->hit_events_enabled(s)); },
        [&](ShapeId s) { w->enable_hit_events(s, true); },
        [&](ShapeId s) { EXPECT_FALSE(w->pre_solve_enabled(s)); },
        [&](ShapeId s) { w->enable_pre_solve(s, true); },
        [&](ShapeId s) { w->apply_wind(s, {}); },
    };
    for (std::size_t i = 0; i < calls.size(); ++i) {
        SCOPED_TRACE(i);
        expect_refused(Error::null_id, [&] { calls[i]({}); });
        expect_refused(Error::stale_id, [&] { calls[i](stale_shape); });
    }
}

TEST_F(ControlRefusal, NumbersThatAreNoneOrOutOfRange) {
    for (const float bad : not_finite) {
        SCOPED_TRACE(bad);
        expect_refused(Error::not_finite, [&] { w->explode({.radius = bad}); });
        expect_refused(Error::not_finite, [&] { w->explode({.falloff = bad}); });
        expect_refused(Error::not_finite, [&] { w->explode({.impulse_per_length = bad}); });
        expect_refused(Error::not_finite, [&] { w->apply_wind(shape, {.drag = bad}); });
        expect_refused(Error::not_finite, [&] { w->apply_wind(shape, {.lift = bad}); });
        expect_refused(Error::not_finite, [&] { w->apply_wind(shape, {.density = bad}); });
        expect_refused(Error::not_finite, [&] { w->set_density(shape, bad); });
        expect_refused(Error::not_finite, [&] { w->set_sleep_threshold(box, bad); });
        expect_refused(Error::not_finite, [&] { w->set_hit_threshold(bad); });
        expect_refused(Error::not_finite, [&] { w->set_material(shape, {.friction = bad}); });
        expect_refused(Error::not_finite, [&] { w->set_target(box, {{0, 0}, {bad, 0}}, 0.1f); });
        expect_refused(Error::bad_geometry, [&] { w->set_circle(shape, {{0, 0}, bad}); });
    }
    for (const Vec2 bad : not_finite_vectors) {
        expect_refused(Error::not_finite, [&] { w->explode({.position = bad}); });
        expect_refused(Error::not_finite, [&] { w->apply_wind(shape, {.velocity = bad}); });
        expect_refused(Error::not_finite, [&] { w->set_target(box, {bad, {}}, 0.1f); });
    }
    expect_refused(Error::out_of_range, [&] { w->explode({.radius = -1}); });
    expect_refused(Error::out_of_range, [&] { w->explode({.falloff = -1}); });
    expect_refused(Error::out_of_range, [&] { w->explode({.position = {2e7f, 0}}); });
    expect_refused(Error::out_of_range, [&] { w->apply_wind(shape, {.velocity = {2e6f, 0}}); });
    expect_refused(Error::out_of_range, [&] { w->apply_wind(shape, {.drag = -1}); });
    expect_refused(Error::out_of_range, [&] { w->apply_wind(shape, {.density = -1}); });
    expect_refused(Error::out_of_range, [&] { w->set_density(shape, -1); });
    expect_refused(Error::out_of_range, [&] { w->set_sleep_threshold(box, -1); });
    expect_refused(Error::out_of_range, [&] { w->set_hit_threshold(-1); });
    expect_refused(Error::out_of_range, [&] { w->set_material(shape, {.restitution = 2}); });
    expect_refused(Error::out_of_range, [&] { w->set_target(box, {{0, 0}, {2, 0}}, 0.1f); });
    for (const float dt : {0.0f, -1.0f, 2.0f, 9.0e-7f, nan}) expect_refused(Error::bad_time_step, [&] { w->set_target(box, {}, dt); });
    expect_refused(Error::bad_geometry, [&] { w->set_capsule(shape, {{0, 0}, {0, 0}, 1}); });
    expect_refused(Error::bad_geometry, [&] { w->set_segment(shape, {{0, 0}, {0, 0}}); });
    expect_refused(Error::bad_geometry, [&] { w->set_polygon(shape, {}); });
    expect_refused(Error::not_a_sensor, [&] { EXPECT_EQ(w->sensor_overlaps(shape, {}), 0u); });
}

TEST(ControlDefs, OfWorldsAreChecked) {
    for (const float bad : {nan, inf, -1.0f}) EXPECT_EQ(TestWorld(roomy, {.hit_threshold = bad}).get(), nullptr);
    EXPECT_EQ(TestWorld(Capacity{.bodies = 1, .shapes = 1, .contacts = 1, .hits = max_capacity + 1}).get(), nullptr);
}

// -- images ------------------------------------------------------------------------------------------------------------------------------

constexpr Capacity small{.bodies = 24, .shapes = 32, .contacts = 64, .joints = 4};

void fill(World& w) {
    const auto add = [&](BodyType type, Vec2 at, const auto& geometry, const ShapeDef& shape = {}) {
        const BodyId body = w.create_body({.type = type, .position = at});
        w.create_shape(body, geometry, shape);
        return body;
    };
    add(BodyType::static_body, {0, -1}, make_box(20, 1), {.pre_solve = true});
    add(BodyType::static_body, {0, 1}, make_box(3, 2), {.sensor = true});
    const BodyId scanner = add(BodyType::kinematic, {-4, 1}, Circle{{0, 0}, 1}, {.sensor = true});
    w.set_linear_velocity(scanner, {1, 0});
    BodyId boxes[10];
    for (int i = 0; i < 10; ++i) boxes[i] = add(BodyType::dynamic, {0.7f * static_cast<float>(i) - 3, 0.5f + 0.3f * static_cast<float>(i % 3)},
                                                make_box(0.3f, 0.3f), {.sensor_events = i != 4, .hit_events = i % 2 == 0, .material = 3});
    const BodyId off = add(BodyType::dynamic, {0, 5}, make_box(0.3f, 0.3f)), locked = add(BodyType::dynamic, {1, 5}, make_box(0.3f, 0.3f));
    w.create_joint(RevoluteJointDef{.base = base_at_b(w, off, locked)});
    w.set_enabled(off, false);
    w.lock_y(locked, true);
    for (int i = 0; i < 40; ++i) w.step(1.0f / 60);
    w.destroy_body(boxes[3]);
}

Hooks conveyor() {
    Hooks hooks;
    hooks.pre_solve = [](PreSolve& c, void*) { c.tangent_speed = 0.5f; };
    return hooks;
}

TEST(ControlImages, EveryWordMayLie) {
    TestWorld source(small, {.hooks = conveyor()}), victim(small, {.hooks = conveyor()});
    fill(*source);
    ASSERT_EQ(source->validate(), nullptr) << source->validate();
    ASSERT_GT(source->sensor_end_events().size(), 0u);
    const Image image = save(*source);
    ASSERT_TRUE(victim->load(image.bytes())) << describe(victim->last_error());
    int accepted = 0, refused = 0;
    const std::size_t words = image.bytes().size() / 4;
    for (std::size_t i = 0; i < words; ++i) {
        const std::uint32_t good = word(image, i);
        // Besides the usual lies each bit of the flags that decide who tells whom.
        for (const std::uint32_t lie : {0u, 0xffffffffu, good + 1, good ^ 1u, good ^ 2u, good ^ 4u, good ^ 8u, good ^ 32u, good ^ 64u, good ^ 128u, good ^ 0x10000u,
                                        good ^ 0x20000u, 0x7fc00000u, 0x7f800000u}) {
            if (lie == good) continue;
            Image forged = image;
            set_word(forged, i, lie);
            seal(forged.bytes());
            const std::uint64_t before = victim->hash();
            if (!victim->load(forged.bytes())) {
                ++refused;
                ASSERT_EQ(victim->hash(), before) << "word " << i;
                continue;
            }
            ++accepted;
            ASSERT_EQ(victim->validate(), nullptr) << "word " << i << ", lie " << lie << ": " << victim->validate();
            for (int step = 0; step < 5; ++step) victim->step(1.0f / 60);
            ASSERT_EQ(victim->validate(), nullptr) << "word " << i << ", lie " << lie << ": " << victim->validate();
        }
    }
    EXPECT_GT(accepted, 1000);
    EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace islet::test
