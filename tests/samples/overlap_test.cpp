// How deep polygons are in each other, against overlaps known from where they are put.
#include <gtest/gtest.h>

#include <cmath>

#include "harness/overlap.hpp"
#include "scenes/build.hpp"

namespace islet::test {
namespace {

using namespace samples;

std::vector<Overlap> overlaps_in(const Scene& scene, double least = 0) {
    IsletEngine engine;
    engine.load(scene);
    return overlaps_of(polygons_in(scene), engine, least);
}

TEST(Overlap, OfTwoBoxesIsTheShorterWayOut) {
    for (const float angle : {0.0f, 0.4f, 2.0f}) {
        Scene scene;
        const Rot q = make_rot(angle);
        add_static(scene, rotate(q, {0, 0}), make_box(1, 1), {}, angle);
        add_dynamic(scene, rotate(q, {1.9f, 0.5f}), make_box(1, 1), {}, angle);
        const std::vector<Overlap> overlaps = overlaps_in(scene);
        ASSERT_EQ(overlaps.size(), 1u);
        EXPECT_NEAR(overlaps[0].depth, 0.1, 1e-5) << "angle " << angle;
        EXPECT_TRUE(overlaps_in(scene, 0.11).empty());
    }
}

TEST(Overlap, OfACornerInAFaceIsItsDepth) {
    Scene scene;
    add_static(scene, {0, -1}, make_box(5, 1));
    add_dynamic(scene, {0, std::sqrt(2.0f) - 0.2f}, make_box(1, 1), {}, 0.25f * pi);
    const std::vector<Overlap> overlaps = overlaps_in(scene);
    ASSERT_EQ(overlaps.size(), 1u);
    EXPECT_NEAR(overlaps[0].depth, 0.2, 1e-5);
}

TEST(Overlap, IsNoneWhereBoundingBoxesAloneOverlap) {
    Scene scene;
    add_dynamic(scene, {0, 0}, make_box(1, 1), {}, 0.25f * pi);
    add_dynamic(scene, {2, 2}, make_box(1, 1), {}, 0.25f * pi);  // faces towards each other are 0.83 m apart
    EXPECT_TRUE(overlaps_in(scene).empty());
}

TEST(Overlap, CountsNeitherPartsOfOneBodyNorTwoStaticOnesNorSensors) {
    Scene scene;
    ShapeDef sensor;
    sensor.sensor = true;
    add_static(scene, {0, 0}, make_box(1, 1));
    add_static(scene, {0.5f, 0}, make_box(1, 1));
    BodyDef def;
    def.type = BodyType::dynamic;
    def.position = {10, 0};
    add_body(scene, def, {{make_box(1, 1), {}}, {make_box(0.5f, 2), {}}});
    add_dynamic(scene, {10.5f, 0}, make_box(1, 1), sensor);
    EXPECT_TRUE(overlaps_in(scene).empty());
    // Each part counts for itself.
    add_dynamic(scene, {10, 0.5f}, make_box(0.2f, 0.2f));
    EXPECT_EQ(overlaps_in(scene).size(), 2u);
}

}  // namespace
}  // namespace islet::test
