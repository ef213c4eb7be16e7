// Crowds: things of all shapes heaped on each other. How deep they overlap is what their contacts say, and none may stay deep.
#include <gtest/gtest.h>

#include "harness/engine.hpp"
#include "measure.hpp"
#include "scenes/catalogue.hpp"
#include "support/polygon_sites.hpp"

namespace islet::test {
namespace {

double depth_of(const ContactInfo& contact) {
    double depth = 0;
    for (std::uint32_t i = 0; i < contact.point_count; ++i) depth = std::fmax(depth, -double(contact.points[i].separation));
    return depth;
}

/// m/s, at which the surfaces of a contact move apart at its first point.
double parting_speed(const World& world, const ContactInfo& contact) {
    const auto speed_of = [&](ShapeId shape) {
        const BodyId body = world.body(shape);
        const Vec2 arm = contact.points[0].point - world.center_of_mass(body);
        return world.linear_velocity(body) + world.angular_velocity(body) * Vec2{-arm.y, arm.x};
    };
    return double(dot(contact.normal, speed_of(contact.shape_b) - speed_of(contact.shape_a)));
}

TEST(Crowds, FewSlowContactsAreDeepInTheYardAndTheDrum) {
    // Of some 17 000 contacts after five seconds, those deeper than 5 cm and slower than 0.5 m/s: a hundred would not be seen. (Springs of 30 Hz alone leave 496
    // and 290.)
    if (slow_build) return;
    for (const char* name : {"junkyard", "washer"}) {
        const samples::Scene scene = samples::find_scene(name)->make();
        samples::IsletEngine engine;
        engine.load(scene);
        for (int step = 0; step < 300; ++step) engine.advance(scene, step, scene.dt);
        int deep = 0;
        ContactInfo contact;
        for (std::uint32_t slot = 0; slot < engine.world().capacity().contacts; ++slot) {
            if (!engine.world().contact_at(slot, contact) || depth_of(contact) < 0.05) continue;
            if (std::fabs(parting_speed(engine.world(), contact)) < 0.5) ++deep;
        }
        EXPECT_LT(deep, 100) << name;
    }
}

TEST(Crowds, PilesOfMixedPolygonsOverlapByMillimetres) {
    // 300 polygons of 0.1 to 0.8 m in a bin, ten starts. Wanted is less than a hundredth of their size, 4 mm, on average, and no pair deeper than 7 cm.
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        Random random(seed);
        TestWorld world({.bodies = 512, .shapes = 512, .contacts = 4096}, sleepless());
        world.add_ground(0, 20, rough(0.5f));
        for (const float side : {-1.0f, 1.0f}) world.add_box({side * 5, 40}, 0.5f, 40, rough(0.5f), BodyType::static_body);
        for (int i = 0; i < 300; ++i) {
            const Polygon polygon = random_polygon(random, 3 + static_cast<std::uint32_t>(i % 6));
            const Vec2 at = {static_cast<float>(i % 8) - 3.5f, 1 + static_cast<float>(i / 8)};
            world.add(polygon, dynamic_at(at, random.between(-pi, pi)), rough(0.5f));
        }
        world.step(600);
        double sum = 0;
        const std::vector<ContactInfo> contacts = world.contacts();
        for (const ContactInfo& contact : contacts) sum += depth_of(contact);
        EXPECT_LT(sum / static_cast<double>(contacts.size()), 0.004) << "seed " << seed;
        EXPECT_LT(deepest_overlap(world), 0.07) << "seed " << seed;
    }
}

/// J, of what `build` makes, which overlaps, in the two seconds in which it parts.
template <class Build>
double parting_energy(Build&& build) {
    TestWorld world({.bodies = 128, .shapes = 128, .contacts = 512}, sleepless());
    world.add_ground();
    const std::vector<BodyId> bodies = build(world);
    double most = 0;
    for (int step = 0; step < 120; ++step) {
        world.step(1);
        double energy = 0;
        for (const BodyId body : bodies) energy += kinetic_energy(*world, body);
        most = std::fmax(most, energy);
    }
    return most;
}

/// 1/s, at which the contact of two bodies undoes an overlap, by its spring of 30 Hz with a damping ratio of 10 at 240 substeps a second (softness.hpp).
constexpr double spring_rate = 2 * 3.14159265 * 30 / (2 * 10 + 2 * 3.14159265 * 30 / 240);

TEST(Crowds, WhatIsMadeOverlappingPartsNoFasterThanItsSpringsPush) {
    // Each contact parts by its spring's rate times its overlap, and what stands on i others goes i times as fast: that is their energy if nothing relaxes.
    // (Columns had up to 3.6 times as much, rows 4.1 times: each step undid most of their overlaps at once.)
    Vec2 corners[6];
    for (int i = 0; i < 6; ++i) corners[i] = 0.5f * rotate(make_rot(static_cast<float>(i) * pi / 3), {1, 0});
    const Polygon hexagon = make_polygon(compute_hull(corners));
    for (const float share : {0.02f, 0.05f, 0.1f}) {
        for (const int kind : {0, 1, 2}) {
            const float height = kind == 1 ? std::sqrt(3.0f) / 2 : 1.0f;
            float mass = 0;
            const double energy = parting_energy([&](TestWorld& world) {
                std::vector<BodyId> bodies;
                for (int i = 0; i < 10; ++i) {
                    const BodyDef at = dynamic_at({0, (static_cast<float>(i) + 0.5f) * height * (1 - share)});
                    bodies.push_back(kind == 0 ? world.add(make_box(0.5f, 0.5f), at) : kind == 1 ? world.add(hexagon, at) : world.add(Circle{{}, 0.5f}, at));
                }
                mass = world->mass(bodies[0]);
                return bodies;
            });
            const double speed = spring_rate * double(share * height);
            EXPECT_LT(energy, 385 * 0.5 * double(mass) * speed * speed) << "kind " << kind << ", overlap " << share;  // 1^2 + ... + 10^2 = 385
        }
        // Ten rows of ten bricks, each pushed sideways, too, from the middle: 0.5^2 + ... + 4.5^2 is 41.25 on either side.
        const double energy = parting_energy([&](TestWorld& world) {
            std::vector<BodyId> bodies;
            for (int i = 0; i < 100; ++i) {
                const float along = static_cast<float>(i % 10) + (i / 10 % 2 == 0 ? 0.0f : 0.5f), up = static_cast<float>(i / 10) + 0.5f;
                bodies.push_back(world.add(make_box(0.5f, 0.25f), dynamic_at((1 - share) * Vec2{along, 0.5f * up})));
            }
            return bodies;
        });
        const double along = spring_rate * double(share), up = along / 2;
        EXPECT_LT(energy, 10 * 0.25 * (2 * 41.25 * along * along + 385 * up * up)) << "bricks, overlap " << share;
    }
}

}  // namespace
}  // namespace islet::test
