// One, four, eight and sixteen lanes give the same bits, whatever a contact's or a joint's neighbours in its block are.
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/forge.hpp"
#include "support/random.hpp"
#include "support/test_world.hpp"

namespace {

using namespace islet;
using namespace islet::test;

/// The same world with each width of lanes. What is done to it is done to each.
class AllLanes {
public:
    explicit AllLanes(const WorldDef& def = {}) {
        for (std::size_t i = 0; i < worlds_.size(); ++i) {
            WorldDef own = def;
            own.lanes = widths[i];
            worlds_[i] = std::make_unique<TestWorld>(Capacity{.bodies = 64, .shapes = 96, .contacts = 256, .joints = 64}, own);
        }
    }

    /// call(world) of each. What it returns is that of the first: ids are equal.
    template <class Call>
    auto each(Call&& call) {
        for (std::size_t i = 1; i < worlds_.size(); ++i) call(*worlds_[i]);
        return call(*worlds_[0]);
    }

    TestWorld& one() { return *worlds_[0]; }

    /// A sentence if after a step the worlds differ or one of them is unsound, else null.
    const char* step(float dt = 1.0f / 60) {
        each([&](TestWorld& w) { w->step(dt); });
        for (const auto& w : worlds_) {
            if (const char* fault = (*w)->validate()) return fault;
            if (!w->is_finite()) return "a body is nowhere";
        }
        for (const auto& w : worlds_)
            if ((*w)->hash() != one()->hash()) return "lanes differ";
        return nullptr;
    }

    /// The first such sentence in so many steps.
    const char* run(int steps, float dt = 1.0f / 60) {
        for (int i = 0; i < steps; ++i)
            if (const char* fault = step(dt)) return fault;
        return nullptr;
    }

private:
    static constexpr std::array<std::uint32_t, 4> widths{1, 4, 8, 16};
    std::array<std::unique_ptr<TestWorld>, widths.size()> worlds_;
};

/// The contacts of an image, to be changed.
std::span<detail::ContactManifold> manifolds_in(Image& image) {
    const detail::ImageHeader h = header_of(image.bytes());
    std::size_t at = sizeof h;
    detail::Core nowhere;
    std::span<detail::ContactManifold> found;
    detail::for_each_part(nowhere, h, [&](auto& part, std::uint64_t bytes) {
        if constexpr (std::is_same_v<std::remove_reference_t<decltype(part)>, detail::ContactManifold*>)
            found = {reinterpret_cast<detail::ContactManifold*>(&image[at]), h.used.contacts};
        at += bytes;
    });
    return found;
}

// -- what a contact no longer has, its neighbours still have ------------------------------------------------------------------------------

/// Balls that roll over a floor, each with a surface of its own.
std::vector<BodyId> roll_balls(AllLanes& lanes, std::initializer_list<ShapeDef> surfaces) {
    lanes.each([](TestWorld& w) { return w.add_ground(); });
    std::vector<BodyId> balls;
    float x = 0;
    for (const ShapeDef& surface : surfaces) {
        balls.push_back(lanes.each([&](TestWorld& w) {
            const BodyId ball = w.add_circle({x, 0.5f}, 0.5f, surface);
            w->set_linear_velocity(ball, {3, 0});
            return ball;
        }));
        x += 3;
    }
    return balls;
}

using ChangeOfShape = std::function<void(World&, ShapeId)>;

TEST(Lanes, ARollingResistanceThatEndsEndsForEachContactAlone) {
    const ChangeOfShape changes[] = {
        [](World& w, ShapeId s) { w.set_rolling_resistance(s, 0); },
        [](World& w, ShapeId s) { w.set_material(s, {}); },
        [](World& w, ShapeId s) { w.set_material(s, {.tangent_speed = 1}); },
        [](World& w, ShapeId s) { w.set_tangent_speed(s, 2), w.set_rolling_resistance(s, 0); },
    };
    for (const ChangeOfShape& change : changes) {
        for (std::size_t which = 0; which < 4; ++which) {
            AllLanes lanes;
            const ShapeDef rolls{.rolling_resistance = 0.1f};
            const std::vector<BodyId> balls = roll_balls(lanes, {rolls, rolls, rolls, rolls});
            ASSERT_STREQ(lanes.run(10), nullptr);
            lanes.each([&](TestWorld& w) { change(*w, w.shape_of(balls[which])); });
            ASSERT_STREQ(lanes.run(20), nullptr) << "change " << &change - changes << " of ball " << which;
        }
    }
}

TEST(Lanes, ARollingImpulseEndsWithTheResistance) {
    AllLanes lanes;
    const std::vector<BodyId> balls = roll_balls(lanes, {{.rolling_resistance = 0.1f}});
    ASSERT_STREQ(lanes.run(10), nullptr);
    TestWorld& w = lanes.one();
    Image image = save(*w);
    ASSERT_NE(manifolds_in(image)[0].rolling_impulse, 0);
    w->set_rolling_resistance(w.shape_of(balls[0]), 0);
    w.step();
    w->set_rolling_resistance(w.shape_of(balls[0]), 0.1f);
    image = save(*w);
    EXPECT_NE(manifolds_in(image)[0].flags & detail::contact_special, 0u);
    EXPECT_EQ(manifolds_in(image)[0].rolling_impulse, 0) << "neither the old one nor the contact's load is there again";
}

TEST(Lanes, AMixingHookThatGoesLeavesWhatTwoShapesWereMixedTo) {
    const auto nothing = [](float, std::uint32_t, float, std::uint32_t, void*) { return 0.0f; };
    const auto much = [](float, std::uint32_t, float, std::uint32_t, void*) { return 0.9f; };
    for (const ShapeDef& neighbor :
         {ShapeDef{.restitution = 0.5f}, ShapeDef{.hit_events = true}, ShapeDef{.rolling_resistance = 0.1f}, ShapeDef{.tangent_speed = 1}}) {
        for (const bool bounces_first : {false, true}) {
            WorldDef def;
            def.hooks.mix_restitution = bounces_first ? +much : +nothing;
            const ShapeDef mixed{.restitution = bounces_first ? 0 : 0.8f};
            AllLanes lanes(def);
            lanes.each([](TestWorld& w) { return w.add_ground(); });
            lanes.each([&](TestWorld& w) {
                for (const ShapeDef* surface : {&mixed, &neighbor}) {
                    const BodyId ball = w.add_circle({surface == &mixed ? -3.0f : 3.0f, 0.52f}, 0.5f, *surface);
                    w->set_linear_velocity(ball, {0, -3});
                }
            });
            ASSERT_STREQ(lanes.step(1.0e-4f), nullptr);  // the pairs are found and their materials mixed
            lanes.each([](TestWorld& w) { w->set_hooks({}); });
            ASSERT_STREQ(lanes.run(30), nullptr) << "bounces first: " << bounces_first;
        }
    }
}

// An image may hold contacts that are special or bouncy where their shapes are not, and impulses of what they do not have. It may also hold any number.
TEST(Lanes, AnImageWhoseContactsAreNotAsTheirShapesSay) {
    Random random(17);
    for (int round = 0; round < 60; ++round) {
        TestWorld w;
        w.add_ground();
        for (int i = 0; i < 16; ++i) {
            ShapeDef surface;
            if (random.one_in(3)) surface.restitution = 0.7f;
            if (random.one_in(3)) surface.rolling_resistance = 0.2f;
            if (random.one_in(3)) surface.tangent_speed = 2;
            surface.hit_events = random.one_in(3);
            const Vec2 at = {static_cast<float>(i % 6) * 1.05f, 0.5f + static_cast<float>(i / 6) * 1.1f};
            const BodyId body = random.one_in(2) ? w.add_circle(at, 0.5f, surface) : w.add_box(at, 0.5f, 0.5f, surface);
            w->set_linear_velocity(body, {random.between(-3, 3), random.between(-6, 0)});
        }
        w.step(15);
        Image image = save(*w);
        for (detail::ContactManifold& m : manifolds_in(image)) {
            for (const std::uint32_t flag : {detail::contact_special, detail::contact_bouncy})
                if (random.one_in(2)) m.flags ^= flag;
            const float size = random.one_in(4) ? std::pow(10.0f, random.between(-40, 38)) : random.between(0, 1);
            if (random.one_in(2)) m.rolling_impulse = random.between(-1, 1) * size;
            if (random.one_in(4)) m.normal_impulse[random.below(2)] = random.between(-1, 1) * size;
            if (random.one_in(4)) m.tangent_impulse[random.below(2)] = random.between(-1, 1) * size;
            if (random.one_in(8)) m.separation[random.below(2)] = random.between(-1, 1) * size;
            if (random.one_in(8)) m.anchors[random.below(2)].x = random.between(-1, 1) * size;
        }
        seal(image.bytes());
        AllLanes lanes;
        bool loaded = true;
        lanes.each([&](TestWorld& to) { loaded = loaded && to->load(image.bytes()); });
        ASSERT_TRUE(loaded);
        ASSERT_STREQ(lanes.run(10), nullptr) << "round " << round;
    }
}

}  // namespace
