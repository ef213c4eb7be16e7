// How far shapes without a contact point are apart is known well enough to leave the narrow phase out, and changes nothing that a world does.
#include "step/clearance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "exact_geometry.hpp"
#include "islet/snapshot.hpp"
#include "shapes/manifolds.hpp"
#include "support/effort.hpp"
#include "support/random.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

#if ISLET_MAX_LANES > 1

using detail::Manifold;
using exact::Point;

constexpr float margin = detail::speculative_distance;

double as_double(float a) { return static_cast<double>(a); }

// -- what the narrow phase notes -----------------------------------------------------------------------------------------------------------

// A shape of about a metre, its core in double precision, and its radius.
struct Rounded {
    Polygon polygon;  // or
    Capsule capsule;  // or
    Circle circle;
    float radius = 0;
    exact::Core core;

    Rounded(exact::Random& r, ShapeType type) : radius(type == ShapeType::polygon && r.below(2) == 0 ? 0.0f : r.in(0.01, 0.4)) {
        if (type == ShapeType::polygon) polygon = exact::random_polygon(r, 1, radius);
        capsule = {{r.in(-1, 0), r.in(-1, 1)}, {r.in(0.1, 1), r.in(-1, 1)}, radius};
        circle = {{r.in(-1, 1), r.in(-1, 1)}, radius};
        core = type == ShapeType::polygon   ? exact::core_of(polygon)
               : type == ShapeType::capsule ? exact::core_of(&capsule.point1, 2)
                                            : exact::core_of(&circle.center, 1);
    }
};

Manifold collide_types(const Rounded& a, ShapeType type_a, const Rounded& b, ShapeType type_b, const Transform& pose) {
    if (type_a == ShapeType::polygon) {
        if (type_b == ShapeType::polygon) return detail::collide(a.polygon, b.polygon, pose, margin);
        return type_b == ShapeType::capsule ? detail::collide(a.polygon, b.capsule, pose, margin) : detail::collide(a.polygon, b.circle, pose, margin);
    }
    if (type_b == ShapeType::polygon) return detail::collide(a.capsule, b.polygon, pose, margin);
    return type_b == ShapeType::capsule ? detail::collide(a.capsule, b.capsule, pose, margin) : detail::collide(a.capsule, b.circle, pose, margin);
}

struct Types {
    ShapeType a, b;
};

TEST(Clearance, IsNeverMoreThanTheExactDistance) {
    const Types all[] = {{ShapeType::polygon, ShapeType::polygon}, {ShapeType::polygon, ShapeType::capsule}, {ShapeType::polygon, ShapeType::circle},
                         {ShapeType::capsule, ShapeType::polygon}, {ShapeType::capsule, ShapeType::capsule}, {ShapeType::capsule, ShapeType::circle}};
    constexpr double rounding = 5e-6;  // m, of single precision within some metres
    exact::Random r;
    for (const Types types : all) {
        const std::string what = std::to_string(static_cast<int>(types.a)) + " and " + std::to_string(static_cast<int>(types.b));
        int apart = 0, known = 0;
        for (int i = 0; i < cases(20000); ++i) {
            const Rounded a(r, types.a), b(r, types.b);
            const Transform pose = r.pose(3);
            const Manifold m = collide_types(a, types.a, b, types.b, pose);
            exact::Core moved;
            for (const Point corner : b.core) moved.push_back(exact::moved(pose, corner));
            const double distance = exact::distance(a.core, moved) - as_double(a.radius) - as_double(b.radius);
            ASSERT_LE(as_double(m.clearance), std::max(distance, 0.0) + rounding) << what << ", case " << i;
            if (m.count > 0) { ASSERT_EQ(m.clearance, 0) << what << ", case " << i; }
            if (m.count > 0) continue;
            ++apart;
            known += m.clearance > margin ? 1 : 0;
        }
        EXPECT_GT(apart, cases(5000)) << what;
        // The distance of a circle from a corner takes a square root that nothing else needs.
        EXPECT_GE(known, types.b == ShapeType::circle ? 0 : apart) << what;
    }
}

// -- what a world makes of it --------------------------------------------------------------------------------------------------------------

// A heap of bodies of one to three shapes of all kinds on a rough floor of segments, and what users do to them while they fall and roll.
struct Heap {
    TestWorld w{roomy, {.enable_sleep = false}};
    std::vector<BodyId> bodies;

    explicit Heap(std::uint64_t seed) {
        Random random(seed);
        const BodyId ground = w->create_body({});
        for (int i = -16; i < 16; ++i) {
            const auto at = [](int corner) { return Vec2{0.5f * static_cast<float>(corner), corner % 2 == 0 ? 0.0f : 0.1f}; };
            w->create_shape(ground, Segment{at(i), at(i + 1)});
        }
        w.add_box({-8, 4}, 0.5f, 5, {}, BodyType::static_body);
        w.add_box({8, 4}, 0.5f, 5, {}, BodyType::static_body);
        for (int i = 0; i < 60; ++i) {
            BodyDef def{.position = {random.between(-6, 6), random.between(1, 14)}};
            def.type = BodyType::dynamic;
            def.angle = random.between(-3, 3);
            def.linear_velocity = {random.between(-3, 3), random.between(-6, 1)};
            def.angular_velocity = random.between(-4, 4);
            bodies.push_back(w->create_body(def));
            for (std::uint32_t shapes = 1 + random.below(3); shapes > 0; --shapes) add_shape(random, bodies.back());
        }
    }
    void add_shape(Random& random, BodyId body) {
        const Vec2 at = {random.between(-0.6f, 0.6f), random.between(-0.6f, 0.6f)};
        const Vec2 corners[] = {at, at + Vec2{random.between(0.3f, 0.9f), 0}, at + Vec2{random.between(-0.2f, 0.5f), random.between(0.3f, 0.9f)}};
        switch (random.below(4)) {
            case 0: w->create_shape(body, make_offset_box(0.4f, random.between(0.05f, 0.4f), {at, make_rot(random.between(-3, 3))})); break;
            case 1: w->create_shape(body, make_polygon(compute_hull(corners), random.between(0, 0.1f))); break;
            case 2: w->create_shape(body, Capsule{at, at + Vec2{0.5f, 0.2f}, 0.15f}); break;
            default: w->create_shape(body, Circle{at, random.between(0.1f, 0.4f)}); break;
        }
    }
    // What a user may do between two steps.
    void change(Random& random) {
        const BodyId body = bodies[random.below(static_cast<std::uint32_t>(bodies.size()))];
        switch (random.below(8)) {
            case 0: w->set_transform(body, {random.between(-6, 6), random.between(1, 10)}, random.between(-3, 3)); break;
            case 1: w->set_linear_velocity(body, {random.between(-60, 60), random.between(-60, 60)}); break;
            case 2: add_shape(random, body); break;
            case 3: w->destroy_shape(w.shape_of(body)); break;
            case 4: w->set_mass(body, {random.between(0.5f, 5), {random.between(-0.3f, 0.3f), random.between(-0.3f, 0.3f)}, random.between(0.2f, 2)}); break;
            case 5: w->set_type(body, random.one_in(2) ? BodyType::kinematic : BodyType::dynamic); break;
            case 6: w->set_enabled(body, random.one_in(3)); break;
            default: w->set_transform(body, {w->position(body) + Vec2{random.between(-0.3f, 0.3f), 0}, w->transform(body).q}); break;
        }
    }
};

// A triangle beside another one, with `gap` m between their long sides.
struct Triangles {
    TestWorld w{roomy, {.gravity = {0, 0}, .enable_sleep = false}};
    BodyId body;

    explicit Triangles(float gap) {
        const Vec2 below[] = {{0, 0}, {2, 0}, {0, 2}}, above[] = {{0, 0}, {-2, 0}, {0, -2}};
        w.add(make_polygon(compute_hull(below)), Vec2{0, 0}, {}, BodyType::static_body);
        const float beyond = 2 + 0.70710678f * gap;
        body = w.add(make_polygon(compute_hull(above)), Vec2{beyond, beyond});
    }
};

int known_clearances(const World& world) {
    const detail::Core& core = detail::Core::of(world);
    int known = 0;
    core.awake_contacts.for_each([&](std::uint32_t i) { known += core.clearances[i] > margin && core.manifolds[i].count() == 0 ? 1 : 0; });
    return known;
}

TEST(Clearance, AWorldThatForgetsThemInEachStepTakesTheSameSteps) {
    // A world that is restored knows no clearance.
    int known = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        Heap knows(seed), forgets(seed);
        Random changes(seed + 100), same_changes(seed + 100);
        for (int step = 0; step < cases(300); ++step) {
            std::vector<std::byte> image(forgets.w->snapshot_bytes());
            ASSERT_GT(forgets.w->save(image), 0u);
            ASSERT_TRUE(forgets.w->restore(image));
            EXPECT_EQ(known_clearances(*forgets.w), 0);
            known += known_clearances(*knows.w);
            knows.w.step();
            forgets.w.step();
            if (step % 4 == 3) {
                knows.change(changes);
                forgets.change(same_changes);
            }
            ASSERT_EQ(knows.w->hash(), forgets.w->hash()) << "start " << seed << ", step " << step;
        }
    }
    EXPECT_GT(known, 10 * cases(300));  // more than one in each step
}

TEST(Clearance, IsForgottenWhenTheCentreOfMassIsElsewhereInTheBody) {
    // In a step the shape comes near by 6 mm. Then its centre of mass is put back to where it was, and the shape stays.
    Triangles t(0.0254f);
    t.w.step();
    ASSERT_EQ(known_clearances(*t.w), 1);
    const Vec2 way = {-0.0042f, -0.0042f}, center = t.w->center_of_mass(t.body);
    t.w->set_linear_velocity(t.body, 60 * way);
    t.w.step();
    ASSERT_EQ(known_clearances(*t.w), 1);
    t.w->set_linear_velocity(t.body, {0, 0});
    t.w->set_mass(t.body, {1, t.w->local_center_of_mass(t.body) - way, 1});
    ASSERT_LT(distance(t.w->center_of_mass(t.body), center), 1e-5f);
    t.w.step();
    EXPECT_EQ(t.w.contacts().size(), 1u);
}

#endif

}  // namespace
}  // namespace islet::test
