// What works on several corners or faces at once, where the processor has vectors, gives the bits of one after another.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "../../engine/src/bodies/bounds.hpp"
#include "../../engine/src/collide/outline_pair.hpp"
#include "support/random.hpp"

namespace islet::detail {
namespace {

using test::Random;

Polygon random_polygon(Random& random) {
    const float size = std::pow(10.0f, random.between(-1, 1));
    for (;;) {
        if (random.one_in(4)) return make_offset_box(random.between(0.1f, 1) * size, size, {{random.between(-3, 3), 0}, make_rot(random.between(-3, 3))}, 0.1f);
        Vec2 points[max_polygon_vertices];
        const std::uint32_t count = 3 + random.below(max_polygon_vertices - 2);
        for (std::uint32_t i = 0; i < count; ++i) points[i] = size * rotate(make_rot(random.between(-3.14f, 3.14f)), {1, 0});
        const Polygon p = make_polygon(compute_hull({points, count}), random.one_in(2) ? 0.0f : random.between(0.01f, 0.3f));
        if (p.count != 0) return p;
    }
}

Geometry random_geometry(Random& random) {
    Geometry g;
    const Vec2 at = {random.between(-2, 2), random.between(-2, 2)};
    switch (random.below(4)) {
    case 0:
        g.type = static_cast<std::uint32_t>(ShapeType::circle);
        g.circle = {at, random.between(0.05f, 2)};
        return g;
    case 1:
        g.type = static_cast<std::uint32_t>(ShapeType::capsule);
        g.capsule = {at, at + Vec2{random.between(0.1f, 2), random.between(-1, 1)}, random.between(0.05f, 2)};
        return g;
    default: return geometry_of(random_polygon(random));
    }
}

Transform random_transform(Random& random) {
    const float far = std::pow(10.0f, random.between(-1, 4));
    return {{random.between(-far, far), random.one_in(5) ? 0.0f : random.between(-far, far)}, make_rot(random.between(-3, 3))};
}

bool same_bits(float a, float b) { return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }
bool same_bits(Vec2 a, Vec2 b) { return same_bits(a.x, b.x) && same_bits(a.y, b.y); }

// The room in a box that ends, on one side, where the tight box made corner by corner does, is nothing; if that side were one bit elsewhere, it would not be.
TEST(AtOnce, TightBoxesEndWhereThoseMadeCornerByCornerDo) {
    constexpr float far = std::numeric_limits<float>::infinity();
    Random random(1);
    for (int i = 0; i < 20000; ++i) {
        const Geometry g = random_geometry(random);
        const Transform t = random_transform(random);
        const Aabb tight = expand(aabb_of(g, t), 0.5f * speculative_distance);
        EXPECT_EQ(room_in_box({tight.lower, {far, far}}, g, t), 0) << i;
        EXPECT_EQ(room_in_box({{tight.lower.x, -far}, {far, far}}, g, t), 0) << i;
        EXPECT_EQ(room_in_box({{-far, tight.lower.y}, {far, far}}, g, t), 0) << i;
        EXPECT_EQ(room_in_box({{-far, -far}, {tight.upper.x, far}}, g, t), 0) << i;
        EXPECT_EQ(room_in_box({{-far, -far}, {far, tight.upper.y}}, g, t), 0) << i;
        const float less = std::nextafter(tight.upper.y, -far);
        EXPECT_EQ(room_in_box({{-far, -far}, {far, less}}, g, t), less - tight.upper.y) << i;
    }
}

TEST(AtOnce, OutlinesAreMovedAsCornerByCorner) {
    Random random(2);
    for (int i = 0; i < 20000; ++i) {
        const Polygon p = random_polygon(random);
        const Transform t = random_transform(random);
        const Vec2 origin = {random.between(-2, 2), random.between(-2, 2)}, first = rotate(t.q, p.vertices[0]) + (t.p - origin);
        const Outline o = outline_of(p, t, origin);
        ASSERT_EQ(o.count, p.count);
        for (std::uint32_t k = 0; k < p.count; ++k) {
            EXPECT_TRUE(same_bits(o.vertices[k], first + rotate(t.q, p.vertices[k] - p.vertices[0]))) << i << ", corner " << k;
            EXPECT_TRUE(same_bits(o.normals[k], rotate(t.q, p.normals[k]))) << i << ", face " << k;
        }
    }
}

TEST(AtOnce, TheBestAxisIsThatFoundFaceByFace) {
    Random random(3);
    std::uint32_t others = 0;
    for (int i = 0; i < 20000; ++i) {
        const Polygon p = random_polygon(random), q = random_polygon(random);
        const Transform t = {{random.between(-5, 5), random.between(-5, 5)}, make_rot(random.between(-3, 3))};
        const Outline a = outline_of(p, p.vertices[0]), b = outline_of(q, t, p.vertices[0]);
        const LineOutline line = outline_of(b.vertices[0], b.vertices[1], 0.1f);
        const Axis best = best_axis(a, b), wanted = best_axis<Outline, Outline>(a, b);
        EXPECT_TRUE(best.face == wanted.face && same_bits(best.separation, wanted.separation)) << i;
        const Axis to_line = best_axis(a, line), wanted_to_line = best_axis<Outline, LineOutline>(a, line);
        EXPECT_TRUE(to_line.face == wanted_to_line.face && same_bits(to_line.separation, wanted_to_line.separation)) << i;
        others += best.face > 3;
    }
    EXPECT_GT(others, 1000u);  // faces behind the first four are found, too
}

}  // namespace
}  // namespace islet::detail
