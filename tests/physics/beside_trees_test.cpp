// What is swept beside a joint tree: rods, ropes, gears, sliders and contacts that hold a light body which bears, by hinges that are solved exactly, a load of
// many times its mass.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "measure.hpp"
#include "support/random.hpp"

namespace islet::test {
namespace {

enum class Prop { rod, rope, gear, slider, ground };

JointBase joined(World& w, BodyId a, BodyId b, Vec2 at_a, Vec2 at_b) {
    return {.body_a = a, .body_b = b, .frame_a = {inv_transform_point(w.transform(a), at_a), {}}, .frame_b = {inv_transform_point(w.transform(b), at_b), {}}};
}

/// A boom of 2 m and 1 kg on a hinge, held level by a prop. A load hangs on a hinge near its end by a rod of its own.
struct Boom {
    TestWorld world;
    std::vector<BodyId> bodies;

    Boom(Prop prop, float load, std::uint64_t start) {
        Random random(start);
        World& w = *world;
        const Filter meets_none{.mask = 0};
        const float rod = random.between(0.6f, 1.8f), hung = random.between(1.2f, 1.9f), held = random.between(0.8f, 1.9f);
        const BodyId wall = w.create_body({});
        const Filter of_boom = prop == Prop::ground ? Filter{.category = 1, .mask = 2} : meets_none;
        const BodyId boom = world.add(make_box(1, 0.1f), dynamic_at({1, 0}), {.density = 2.5f, .filter = of_boom});
        const JointId hinge = w.create_joint(RevoluteJointDef{.base = joined(w, wall, boom, {0, 0}, {0, 0})});
        const BodyId weight = world.add(make_box(0.2f, 0.2f), dynamic_at({hung, -rod}), {.density = load / 0.16f, .filter = meets_none});
        w.create_joint(RevoluteJointDef{.base = joined(w, boom, weight, {hung, 0}, {hung, 0})});
        bodies = {boom, weight};
        switch (prop) {
        case Prop::rod:
            w.create_joint(DistanceJointDef{.base = joined(w, wall, boom, {0, 1.5f}, {held, 0}), .length = length({held, -1.5f})});
            break;
        case Prop::rope:
            w.create_joint(DistanceJointDef{.base = joined(w, wall, boom, {0, 1.5f}, {held, 0}),
                                            .length = length({held, -1.5f}),
                                            .spring = {.enable = true, .hertz = 0},
                                            .limit = {.enable = true, .lower = 0, .upper = length({held, -1.5f})}});
            break;
        case Prop::gear: {
            const BodyId drum = world.add(Circle{{}, 0.4f}, dynamic_at({-1, 0}), {.density = 2, .filter = meets_none});
            const JointId axle = w.create_joint(
                RevoluteJointDef{.base = joined(w, wall, drum, {-1, 0}, {-1, 0}), .motor = {.enable = true, .speed = 0, .max_force = 1e6f}});
            w.create_joint(GearJointDef{.joint1 = axle, .joint2 = hinge, .ratio = 2});
            bodies.push_back(drum);
            break;
        }
        case Prop::slider: {
            const Vec2 foot = {held, -1.5f};
            const BodyId strut = world.add(make_box(0.5f, 0.5f), dynamic_at(foot), {.filter = meets_none});
            JointBase rail = joined(w, wall, strut, foot, foot);
            rail.frame_a.angle = rail.frame_b.angle = pi / 2;
            w.create_joint(PrismaticJointDef{.base = rail, .motor = {.enable = true, .speed = 0, .max_force = 1e6f}});
            w.create_joint(DistanceJointDef{.base = joined(w, strut, boom, foot, {held, 0}), .length = 1.5f});
            bodies.push_back(strut);
            break;
        }
        case Prop::ground:
            world.add(make_box(0.2f, 0.2f), [&] {
                BodyDef def;
                def.position = {held, -0.3f};
                return def;
            }(), {.filter = {.category = 2, .mask = 1}});
            break;
        }
    }
};

TEST(BesideTrees, ABoomThatBearsManyTimesItsMassComesToRestAndGainsNoEnergy) {
    // Swept rows know the boom's mass alone. (Too stiff for that, they threw it about at up to 35 m/s, with 68 m of its load's weight.)
    struct Case {
        const char* name;
        Prop prop;
        float load;  // kg
    };
    for (const Case& c : {Case{"rod", Prop::rod, 30}, Case{"rod", Prop::rod, 60}, Case{"rope", Prop::rope, 60}, Case{"gear", Prop::gear, 10}, Case{"slider", Prop::slider, 60},
                          Case{"ground", Prop::ground, 20}, Case{"ground", Prop::ground, 45}, Case{"ground", Prop::ground, 100}}) {
        for (std::uint64_t start = 0; start < 10; ++start) {
            const std::string what = std::string(c.name) + ", " + std::to_string(c.load) + " kg, start " + std::to_string(start);
            Boom boom(c.prop, c.load, start);
            const double before = energy_of(*boom.world, boom.bodies);
            double most = before, fastest = 0;
            for (int i = 0; i < 1200; ++i) {
                boom.world.step();
                most = std::fmax(most, energy_of(*boom.world, boom.bodies));
                if (i < 900) continue;
                for (const BodyId body : boom.bodies) fastest = std::fmax(fastest, double(length(boom.world->linear_velocity(body))));
            }
            EXPECT_LT(most - before, 0.01 * g * double(c.load)) << what;  // 1 cm of the load's weight
            EXPECT_LT(fastest, 0.01) << what;
        }
    }
}

// A plank on a hinge whose limits hold it level, or an arm of five, with a load that a weld, a slider or a wheel joint fixes to its tip. (While the
// hinges were solved exactly, loads of 70 times a plank's mass whirled round at 46 m/s: the joint at the tip knew the plank's mass alone.)
TEST(BesideTrees, WhatIsFixedToTheTipOfAHeldArmGainsNoEnergy) {
    enum class Fixed { weld, slider, wheel };
    struct Case {
        Fixed fixed;
        int planks;
        float load;   // times a plank's mass
        float limit;  // rad
    };
    for (const Case& c : {Case{Fixed::weld, 1, 70, 0}, Case{Fixed::weld, 1, 100, 0}, Case{Fixed::weld, 1, 200, 0}, Case{Fixed::weld, 5, 32, 0}, Case{Fixed::weld, 5, 40, 0.3f},
                          Case{Fixed::slider, 5, 40, 0.3f}, Case{Fixed::wheel, 5, 40, 0.3f}})
        for (std::uint64_t start = 0; start < 10; ++start) {
            Random random(start);
            TestWorld world(roomy, sleepless());
            World& w = *world;
            const Filter meets_none{.mask = 0};
            const float half = random.between(0.2f, 0.3f);
            BodyId last = w.create_body({});
            std::vector<BodyId> bodies;
            for (int i = 0; i < c.planks; ++i) {
                const float x = static_cast<float>(2 * i) * half;
                const BodyId plank = world.add(make_box(half, 0.05f), dynamic_at({x + half, 0}), {.filter = meets_none});
                w.create_joint(RevoluteJointDef{.base = joined(w, last, plank, {x, 0}, {x, 0}), .limit = {.enable = true, .lower = -c.limit, .upper = c.limit}});
                bodies.push_back(last = plank);
            }
            const Vec2 tip = {static_cast<float>(2 * c.planks) * half, 0};
            const BodyId load = world.add(make_box(0.2f, 0.2f), dynamic_at(tip), {.density = c.load * w.mass(last) / 0.16f, .filter = meets_none});
            const JointBase base = joined(w, last, load, tip, tip);
            switch (c.fixed) {
            case Fixed::weld: w.create_joint(WeldJointDef{.base = base}); break;
            case Fixed::slider: w.create_joint(PrismaticJointDef{.base = base, .limit = {.enable = true, .lower = 0, .upper = 0}}); break;
            case Fixed::wheel: w.create_joint(WheelJointDef{.base = base, .limit = {.enable = true, .lower = 0, .upper = 0}}); break;
            }
            bodies.push_back(load);
            const double before = energy_of(w, bodies);
            double most = before;
            for (int i = 0; i < 600; ++i) {
                world.step();
                most = std::fmax(most, energy_of(w, bodies));
            }
            EXPECT_LT(most - before, 0.05 * g * double(w.mass(load)))  // 5 cm of the load's weight
                << "joint " << static_cast<int>(c.fixed) << ", " << c.planks << " planks, load " << c.load << ", limit " << c.limit << ", start " << start;
        }
}

TEST(BesideTrees, ADrawbridgeThatARodHoldsNearItsHingeComesToRest) {
    // 2 to 4 m long. (Held up to 0.3 m from its hinge it whirled round at up to 50 rad/s, with 25 kJ.)
    for (const float held : {0.1f, 0.2f, 0.3f, 0.5f, 1.0f}) {
        for (const float slant : {0.0f, 1.0f}) {
            for (int start = 0; start < 10; ++start) {
                TestWorld world;
                World& w = *world;
                const float half = 1 + 0.1f * static_cast<float>(start);
                const Vec2 top = {slant * held, 1.5f};
                const BodyId wall = w.create_body({});
                const BodyId bridge = world.add(make_box(half, 0.1f), dynamic_at({half, 0}), dense(5));
                w.create_joint(RevoluteJointDef{.base = joined(w, wall, bridge, {0, 0}, {0, 0})});
                w.create_joint(DistanceJointDef{.base = joined(w, wall, bridge, top, {held, 0}), .length = length(top - Vec2{held, 0})});
                const double before = energy_of(w, std::vector{bridge});
                double most = before;
                for (int i = 0; i < 1200; ++i) {
                    world.step();
                    most = std::fmax(most, energy_of(w, std::vector{bridge}));
                }
                EXPECT_LT(most - before, 0.01 * g * double(w.mass(bridge))) << held << " m, slant " << slant << ", start " << start;
                EXPECT_LT(std::abs(w.angular_velocity(bridge)), 0.05f) << held << " m, slant " << slant << ", start " << start;
            }
        }
    }
}

TEST(BesideTrees, MechanismsOfHingesWithARodOrTwoGainNoEnergy) {
    // Two to seven boxes of masses 1 : 10 that hang on each other by hinges, and rods between points of them.
    for (std::uint64_t start = 0; start < 40; ++start) {
        Random random(start);
        TestWorld world({.bodies = 16, .shapes = 16, .contacts = 16, .joints = 16}, sleepless());
        World& w = *world;
        std::vector<BodyId> bodies = {w.create_body({})};
        const auto point_of = [&](BodyId body) {
            if (body == bodies[0]) return Vec2{random.between(-1, 1), random.between(-1, 1)};
            return transform_point(w.transform(body), {random.between(-0.5f, 0.5f), random.between(-0.1f, 0.1f)});
        };
        const std::uint32_t count = 2 + random.below(6);
        double mass = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            const BodyId above = bodies[random.below(static_cast<std::uint32_t>(bodies.size()))];
            const Vec2 at = point_of(above), arm = {random.between(-0.5f, 0.5f), random.between(-0.1f, 0.1f)};
            const float angle = random.between(-pi, pi);
            const ShapeDef shape{.density = std::pow(10.0f, random.between(0, 1)), .filter = {.mask = 0}};
            const BodyId body = world.add(make_box(0.5f, 0.1f), dynamic_at(at - rotate(make_rot(angle), arm), angle), shape);
            w.create_joint(RevoluteJointDef{.base = joined(w, above, body, at, at)});
            bodies.push_back(body);
            mass += double(w.mass(body));
        }
        for (std::uint32_t i = 0; i < 1 + start % 2; ++i) {
            const auto a = static_cast<std::uint32_t>(random.below(count + 1)), b = (a + 1 + random.below(count)) % (count + 1);
            const Vec2 at_a = point_of(bodies[a]), at_b = point_of(bodies[b]);
            if (length(at_b - at_a) < 0.1f) continue;
            w.create_joint(DistanceJointDef{.base = joined(w, bodies[a], bodies[b], at_a, at_b), .length = length(at_b - at_a)});
        }
        bodies.erase(bodies.begin());
        const double before = energy_of(w, bodies);
        double most = before;
        for (int i = 0; i < 600; ++i) {
            world.step();
            most = std::fmax(most, energy_of(w, bodies));
        }
        EXPECT_LT(most - before, 0.05 * g * mass) << "start " << start;  // 5 cm of all their weight
    }
}

}  // namespace
}  // namespace islet::test
