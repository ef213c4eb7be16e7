// Hooks: the user's part in who meets, what a contact does, and how materials mix.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/image.hpp"
#include "support/random.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

// -- filter ------------------------------------------------------------------------------------------------------------------------------

struct Asked {
    std::vector<std::pair<ShapeId, ShapeId>> pairs;
    ShapeId refused;
};

bool refuse_one(ShapeId a, ShapeId b, void* context) {
    auto& asked = *static_cast<Asked*>(context);
    asked.pairs.emplace_back(a, b);
    return a != asked.refused && b != asked.refused;
}

TEST(FilterHook, WhatItForbidsFallsThroughAndIsSeenByNoSensor) {
    Asked asked;
    TestWorld w(roomy, {.hooks = {.filter = refuse_one, .context = &asked}});
    w.add_ground();
    const ShapeId gate = w.shape_of(w.add_box({0, 0}, 50, 2, {.sensor = true}, BodyType::static_body));
    const BodyId held = w.add_box({0, 1}), falls = w.add_box({5, 1});
    asked.refused = w.shape_of(falls);
    w.step(60);
    EXPECT_NEAR(w->position(held).y, 0.5f, 0.01f);
    EXPECT_LT(w->position(falls).y, -3);
    EXPECT_EQ(w->sensor_overlaps(gate, {}), 1u);
    for (const auto& [a, b] : asked.pairs) EXPECT_TRUE(w->is_valid(a) && w->is_valid(b));
    const std::size_t before = asked.pairs.size();
    w->set_transform(falls, {5, 1}, 0);
    w->set_hooks({});
    w->set_linear_velocity(falls, {});
    w.step(60);
    EXPECT_NEAR(w->position(falls).y, 0.5f, 0.01f) << "hooks can be taken away";
    EXPECT_EQ(asked.pairs.size(), before);
}

TEST(FilterHook, IsNotAskedAboutWhatFiltersForbid) {
    Asked asked;
    TestWorld w(roomy, {.hooks = {.filter = refuse_one, .context = &asked}});
    w.add_ground(0, 100, {.filter = {.group = -1}});
    w.add_box({0, 0.5f}, 0.5f, 0.5f, {.filter = {.group = -1}});
    w.step(5);
    EXPECT_TRUE(asked.pairs.empty());
}

// Continuous collision must not stop what the hook lets through, and must stop what it does not.
TEST(FilterHook, HoldsForWhatIsFastToo) {
    Asked asked;
    TestWorld w(roomy, {.gravity = {0, 0}, .hooks = {.filter = refuse_one, .context = &asked}});
    w.add_box({0, 0}, 0.05f, 50, {}, BodyType::static_body);
    const BodyId held = w.add_circle({-3, 0}, 0.1f), passes = w.add_circle({-3, 5}, 0.1f);
    asked.refused = w.shape_of(passes);
    w->set_linear_velocity(held, {200, 0});
    w->set_linear_velocity(passes, {200, 0});
    w.step(10);
    EXPECT_LT(w->position(held).x, 0);
    EXPECT_GT(w->position(passes).x, 20);
}

// -- pre_solve ---------------------------------------------------------------------------------------------------------------------------

/// Lets through what comes from below: the platform is solid for shapes that are on top of it.
void one_way(PreSolve& c, void* context) {
    const auto& platform = *static_cast<const ShapeId*>(context);
    const Vec2 up = c.contact.shape_a == platform ? c.contact.normal : -c.contact.normal;
    float separation = 1;
    for (std::uint32_t i = 0; i < c.contact.point_count; ++i) separation = std::min(separation, c.contact.points[i].separation);
    c.enabled = up.y > 0.9f && separation > -0.05f;
}

TEST(PreSolve, AOneWayPlatformIsPassedFromBelowAndHoldsFromAbove) {
    for (const float speed : {9.0f, 40.0f}) {
        ShapeId platform;
        TestWorld w(roomy, {.hooks = {.pre_solve = one_way, .context = &platform}});
        platform = w.shape_of(w.add_box({0, 3}, 5, 0.25f, {.pre_solve = true}, BodyType::static_body));
        const BodyId jumper = w.add_box({0, 0}, 0.3f, 0.3f), free = w.add_box({20, 0}, 0.3f, 0.3f);
        w->set_linear_velocity(jumper, {0, speed});
        w->set_linear_velocity(free, {0, speed});
        bool rises = true;
        for (int i = 0; i < 900; ++i) {
            w.step();
            rises = rises && w->linear_velocity(jumper).y > 0;
            if (rises) { ASSERT_EQ(w->position(jumper).y, w->position(free).y) << "nothing slows it on its way up"; }
        }
        EXPECT_NEAR(w->position(jumper).y, 3.25f + 0.3f, 0.01f);
        EXPECT_FALSE(w->is_awake(jumper)) << "it may rest there";
        EXPECT_EQ(w->validate(), nullptr);
    }
}

TEST(PreSolve, WhatIsSwitchedOffTouchesNobody) {
    const auto never = [](PreSolve& c, void*) { c.enabled = false; };
    TestWorld w(roomy, {.hooks = {.pre_solve = never}});
    w.add_ground(0, 100, {.pre_solve = true});
    const BodyId box = w.add_box({0, 0.6f});
    for (int i = 0; i < 60; ++i) {
        w.step();
        EXPECT_TRUE(w->begin_touch_events().empty());
        EXPECT_TRUE(w.contacts().empty());
        EXPECT_EQ(w->validate(), nullptr);
    }
    EXPECT_LT(w->position(box).y, -3);
}

struct Count {
    int asked = 0;
    bool on = true;
};

TEST(PreSolve, IsAskedInEveryStepThoughTheManifoldIsKeptAndNotOfSleepers) {
    Count count;
    const auto hook = [](PreSolve& c, void* context) {
        ++static_cast<Count*>(context)->asked;
        c.enabled = static_cast<Count*>(context)->on;
    };
    TestWorld w(roomy, {.hooks = {.pre_solve = hook, .context = &count}});
    w.add_ground();
    const BodyId box = w.add_box({0, 0.5f}, 0.5f, 0.5f, {.pre_solve = true});
    w.add_box({3, 0.5f});
    w.step(20);
    EXPECT_EQ(count.asked, 20) << "of one contact, the other box did not ask";
    EXPECT_GT(w->report().recycled_contacts, 0u);
    w.step(60);
    ASSERT_FALSE(w->is_awake(box));
    const int before = count.asked;
    w.step(10);
    EXPECT_EQ(count.asked, before);
    w->wake(box);
    count.on = false;
    w.step();
    EXPECT_EQ(w->end_touch_events().size(), 1u) << "it lost its ground";
    w.step(30);
    EXPECT_LT(w->position(box).y, 0);
    w->set_hooks({});
    w->enable_pre_solve(w.shape_of(box), false);
    EXPECT_FALSE(w->pre_solve_enabled(w.shape_of(box)));
}

// A box on a plane that is thrown along it stops after v^2 / (2 mu g); the hook gives it another mu than its material has.
TEST(PreSolve, FrictionOfThisStepIsTheHooks) {
    for (const float mu : {0.2f, 0.8f}) {
        float given = mu;
        const auto hook = [](PreSolve& c, void* context) {
            EXPECT_NEAR(c.friction, 0.6f, 1e-6f) << "what the materials make is asked again in each step";
            c.friction = *static_cast<float*>(context);
        };
        TestWorld w(roomy, {.hooks = {.pre_solve = hook, .context = &given}});
        w.add_ground(0, 100, {.pre_solve = true});
        const BodyId box = w.add_box({0, 0.5f}, 0.5f, 0.25f);
        w->set_transform(box, {0, 0.25f}, 0);
        w.step();
        w->set_linear_velocity(box, {4, 0});
        w.step(240);
        EXPECT_NEAR(w->position(box).x, 16 / (2 * mu * 10), 0.04f) << mu;
    }
}

TEST(PreSolve, ASurfaceSpeedOfTheHookCarriesAndEndsWithIt) {
    float speed = 1.5f;
    const auto hook = [](PreSolve& c, void* context) { c.tangent_speed = *static_cast<float*>(context); };
    TestWorld w(roomy, {.hooks = {.pre_solve = hook, .context = &speed}});
    const ShapeId belt = w.shape_of(w.add_ground(0, 100, {.pre_solve = true}));
    const BodyId box = w.add_box({0, 0.5f});
    w->enable_sleep(box, false);
    w.step(120);
    EXPECT_NEAR(w->linear_velocity(box).x, 1.5f, 0.01f);
    const Image image = save(*w);
    TestWorld other;
    ASSERT_TRUE(other->load(image.bytes()));
    EXPECT_EQ(other->hash(), w->hash());
    EXPECT_EQ(other->validate(), nullptr);
    speed = 0;
    w.step(120);
    EXPECT_NEAR(w->linear_velocity(box).x, 0, 0.01f);
    // The same as a conveyor of the material, to the bit.
    speed = 1.5f;
    TestWorld plain;
    plain.add_ground(0, 100, {.tangent_speed = 1.5f});
    const BodyId twin = plain.add_box({0, 0.5f});
    plain->enable_sleep(twin, false);
    TestWorld again(roomy, {.hooks = {.pre_solve = hook, .context = &speed}});
    again.add_ground(0, 100, {.pre_solve = true});
    const BodyId third = again.add_box({0, 0.5f});
    again->enable_sleep(third, false);
    for (int i = 0; i < 90; ++i) {
        plain.step();
        again.step();
        ASSERT_EQ(again->position(third), plain->position(twin));
    }
    EXPECT_TRUE(w->is_valid(belt));
}

TEST(PreSolve, WhatTheHookMadeOfAContactIsOverWhenItIsNoLongerAsked) {
    const auto hook = [](PreSolve& c, void*) {
        c.tangent_speed = 1.5f;
        c.friction = 2;
    };
    enum Way { shape_tells_no_more, hook_is_gone, another_shape_of_the_body_changes };
    for (const Way way : {shape_tells_no_more, hook_is_gone, another_shape_of_the_body_changes}) {
        TestWorld w(roomy, {.hooks = {.pre_solve = hook}});
        // Rolling resistance, which a box has no use for, makes the contact one that looks for a surface speed.
        const BodyId ground = w.add_ground(0, 100, {.friction = 0.5f, .rolling_resistance = 0.1f, .pre_solve = true});
        const ShapeId belt = w.shape_of(ground);
        const BodyId box = w.add_box({0, 0.5f});
        w->enable_sleep(box, false);
        w.step(120);
        ASSERT_NEAR(w->linear_velocity(box).x, 1.5f, 0.01f);
        if (way == shape_tells_no_more) w->enable_pre_solve(belt, false);
        if (way == hook_is_gone) w->set_hooks({});
        if (way == another_shape_of_the_body_changes) w->set_friction(belt, 0.4f);
        ASSERT_EQ(w->validate(), nullptr) << w->validate();
        w.step(1);
        ASSERT_EQ(w->validate(), nullptr) << w->validate();
        w.step(119);
        EXPECT_NEAR(w->linear_velocity(box).x, way == another_shape_of_the_body_changes ? 1.5f : 0, 0.01f);
        if (way != another_shape_of_the_body_changes) {
            ContactInfo info;
            ASSERT_TRUE(w->contact_at(0, info));
            EXPECT_NEAR(info.friction, std::sqrt(0.5f * ShapeDef{}.friction), 1e-6f);
        }
    }
}

TEST(PreSolve, NumbersThatAreNoneAreRefused) {
    struct Bad {
        float friction, speed;
    };
    for (const Bad bad : {Bad{NAN, 0}, {-1, 0}, {2e9f, 0}, {0.6f, INFINITY}, {0.6f, 2e6f}}) {
        Bad given = bad;
        const auto hook = [](PreSolve& c, void* context) {
            c.friction = static_cast<Bad*>(context)->friction;
            c.tangent_speed = static_cast<Bad*>(context)->speed;
        };
        TestWorld w(roomy, {.hooks = {.pre_solve = hook, .context = &given}}), plain;
        for (TestWorld* each : {&w, &plain}) each->add_ground(0, 100, {.friction = 0.6f, .pre_solve = each == &w});
        const BodyId box = w.add_box({0, 0.5f}), twin = plain.add_box({0, 0.5f});
        w->set_linear_velocity(box, {3, 0});
        plain->set_linear_velocity(twin, {3, 0});
        w.step(30);
        plain.step(30);
        EXPECT_TRUE(w->last_error() == Error::not_finite || w->last_error() == Error::out_of_range);
        EXPECT_EQ(w->validate(), nullptr);
        EXPECT_EQ(w->position(box), plain->position(twin)) << "as if the hook had said nothing";
    }
}

// -- mixing ------------------------------------------------------------------------------------------------------------------------------

TEST(Mixing, FollowsTheHooksAndGetsTheMaterialsIds) {
    struct Materials {
        std::vector<std::uint32_t> ids;
    } seen;
    Hooks hooks;
    hooks.mix_friction = [](float a, std::uint32_t material_a, float b, std::uint32_t material_b, void* context) {
        static_cast<Materials*>(context)->ids = {material_a, material_b};
        return material_a == 7 || material_b == 7 ? 0.0f : a + b;
    };
    hooks.mix_restitution = [](float a, std::uint32_t, float b, std::uint32_t, void*) { return a * b; };
    hooks.context = &seen;
    TestWorld w(roomy, {.hooks = hooks});
    w.add_ground(0, 100, {.friction = 0.3f, .restitution = 0.5f, .material = 5});
    const BodyId box = w.add_box({0, 0.5f}, 0.5f, 0.5f, {.friction = 0.4f, .restitution = 0.5f, .material = 6});
    w.step(2);
    ASSERT_EQ(w.contacts().size(), 1u);
    EXPECT_FLOAT_EQ(w.contacts()[0].friction, 0.7f);
    EXPECT_FLOAT_EQ(w.contacts()[0].restitution, 0.25f);
    EXPECT_EQ(seen.ids, (std::vector<std::uint32_t>{5, 6}));
    SurfaceMaterial ice = w->material(w.shape_of(box));
    EXPECT_EQ(ice, (SurfaceMaterial{0.4f, 0.5f, 0, 0, 6}));
    ice.id = 7;
    w->set_material(w.shape_of(box), ice);
    EXPECT_EQ(w.contacts()[0].friction, 0) << "a change of material mixes anew";
    w->set_linear_velocity(box, {3, 0});
    w.step(60);
    EXPECT_NEAR(w->linear_velocity(box).x, 3, 1e-4f);
}

TEST(Mixing, AbsurdResultsAreTakenForTheNearestThatIsSound) {
    for (const float mixed : {NAN, -3.0f, INFINITY, 1e30f}) {
        static float result;
        result = mixed;
        Hooks hooks;
        hooks.mix_friction = [](float, std::uint32_t, float, std::uint32_t, void*) { return result; };
        hooks.mix_restitution = hooks.mix_friction;
        TestWorld w(roomy, {.hooks = hooks});
        w.add_ground();
        w.add_box({0, 1});
        w.step(60);
        EXPECT_TRUE(w.is_finite());
        EXPECT_EQ(w->validate(), nullptr);
    }
}

// -- all together ------------------------------------------------------------------------------------------------------------------------

// A function of what the contact looks like alone.
void whimsical(PreSolve& c, void*) {
    const std::uint32_t sum = c.contact.shape_a.index1 + c.contact.shape_b.index1;
    c.enabled = sum % 5 != 0 || c.contact.normal.y > 0.5f;
    if (sum % 3 == 0) c.friction *= 0.5f;
    if (sum % 7 == 0) c.tangent_speed = 0.5f;
}

TEST(HooksTogether, GiveTheSameBitsWithAnyWorkersAndAfterGoingBack) {
    const auto backwards = [](void*, std::uint32_t count, void (*task)(void*, std::uint32_t), void* data) {
        for (std::uint32_t i = count; i-- > 0;) task(data, i);
    };
    Hooks hooks;
    hooks.filter = [](ShapeId a, ShapeId b, void*) { return (a.index1 + b.index1) % 11 != 0; };
    hooks.pre_solve = whimsical;
    hooks.mix_friction = [](float a, std::uint32_t ma, float b, std::uint32_t mb, void*) { return ma == mb ? 0.1f : a * b; };
    const auto fill = [](TestWorld& w) {
        w.add_ground(0, 100, {.pre_solve = true});
        Random random(8);
        for (int i = 0; i < 150; ++i) {
            const Vec2 at = {random.between(-5, 5), 1 + 0.4f * static_cast<float>(i)};
            const ShapeDef def{.pre_solve = i % 3 == 0, .material = random.below(3)};
            i % 2 == 0 ? w.add_circle(at, 0.3f, def) : w.add_box(at, 0.3f, 0.2f, def);
        }
    };
    TestWorld one(roomy, {.hooks = hooks}), two(roomy, {.hooks = hooks, .tasks = {backwards, nullptr, 2}}),
        four(roomy, {.hooks = hooks, .tasks = {backwards, nullptr, 4}}), back(roomy, {.hooks = hooks});
    for (TestWorld* w : {&one, &two, &four}) fill(*w);
    for (int i = 0; i < 240; ++i) {
        if (i == 100) { ASSERT_TRUE(back->load(save(*one).bytes())); }
        for (TestWorld* w : {&one, &two, &four}) w->step();
        if (i >= 100) back.step();
        ASSERT_EQ(two->hash(), one->hash()) << i;
        ASSERT_EQ(four->hash(), one->hash()) << i;
        if (i >= 100) { ASSERT_EQ(back->hash(), one->hash()) << i; }
        if (i % 40 == 0) { ASSERT_EQ(one->validate(), nullptr); }
    }
}

TEST(HooksTogether, AreNoPartOfHashesAndSnapshots) {
    TestWorld with(roomy, {.hooks = {.pre_solve = [](PreSolve&, void*) {}}}), without;
    for (TestWorld* w : {&with, &without}) {
        w->add_ground(0, 100, {.pre_solve = true});
        w->add_box({0, 1});
    }
    for (int i = 0; i < 60; ++i) {
        with.step();
        without.step();
        ASSERT_EQ(with->hash(), without->hash()) << "a hook that changes nothing changes nothing";
    }
    EXPECT_EQ(save(*with), save(*without));
    EXPECT_NE(with->hooks(), without->hooks());
    ASSERT_TRUE(with->restore(save(*without).bytes()));
    EXPECT_NE(with->hooks().pre_solve, nullptr) << "the host's own stays";
}

}  // namespace
}  // namespace islet::test
