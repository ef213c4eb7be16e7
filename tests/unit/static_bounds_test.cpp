// A level is often one static body of thousands of shapes. To add or to destroy one looks at few of the others; the body's bounds, its boxes and the tree are
// still what a look at all of them gives.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "islet/islet.hpp"
#include "support/effort.hpp"
#include "support/random.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

// A body that is built and torn down at random.
struct Level {
    TestWorld w;
    Random random;
    BodyId body;
    std::vector<ShapeId> shapes;
    bool endless = false;  // has had a half-space, whose box any look at all shapes marks as new

    Level(std::uint64_t seed, Vec2 place) : random(seed) {
        BodyDef def;
        def.position = place;
        def.angle = random.between(-3, 3);
        def.type = random.one_in(3) ? BodyType::dynamic : BodyType::static_body;
        body = w->create_body(def);
    }

    Vec2 point(float reach) { return {random.between(-reach, reach), random.between(-reach, reach)}; }

    void add() {
        ShapeDef def;
        def.sensor = random.one_in(5);
        const Vec2 at = point(random.one_in(4) ? 40.0f : 5.0f);
        // Sizes repeat, as those of tiles do, so that several shapes have the same extent.
        const float size = 0.25f * static_cast<float>(1 + random.below(3));
        ShapeId id;
        switch (random.below(7)) {
            case 0: id = w->create_shape(body, Circle{at, size}, def); break;
            case 1: id = w->create_shape(body, Capsule{at, at + Vec2{size, 0}, size}, def); break;
            case 2: id = w->create_shape(body, Segment{at, at + Vec2{0, size}}, def); break;
            case 3:
                if (w->type(body) != BodyType::dynamic && random.one_in(8)) {
                    id = w->create_shape(body, HalfSpace{{0, 1}, -60}, def);
                    endless = true;
                    break;
                }
                [[fallthrough]];
            case 4: {
                std::array<ShapeId, 5> links;
                std::array<Vec2, 6> points;
                for (std::size_t i = 0; i < points.size(); ++i) points[i] = at + Vec2{static_cast<float>(i), random.between(0, 0.5f)};
                const std::uint32_t made = w->create_chain(body, points, false, def, links);
                shapes.insert(shapes.end(), links.begin(), links.begin() + made);
                return;
            }
            default: id = w->create_shape(body, make_offset_box(size, size, {at, make_rot(0.5f * static_cast<float>(random.below(4)))}), def); break;
        }
        if (id) shapes.push_back(id);
    }
    void destroy() {
        if (shapes.empty()) return;
        const std::size_t i = random.below(static_cast<std::uint32_t>(shapes.size()));
        w->destroy_shape(shapes[i]);
        shapes.erase(shapes.begin() + static_cast<std::ptrdiff_t>(i));
    }
    void change() {
        switch (random.below(12)) {
            case 0: w->set_type(body, BodyType::static_body); break;
            case 1: w->set_type(body, endless ? BodyType::kinematic : BodyType::dynamic); break;
            case 2: w->set_enabled(body, random.one_in(2)); break;
            case 3: w->set_transform(body, {w->transform(body).p + point(1), make_rot(random.between(-3, 3))}); break;
            case 4: w.step(1); break;
            case 5:
                while (shapes.size() > 3) destroy();
                break;
            default: random.one_in(2) ? add() : destroy(); break;
        }
    }
};

class StaticBounds : public testing::TestWithParam<Vec2> {};

TEST_P(StaticBounds, AreThoseOfAllShapesAfterEachAdditionAndDestruction) {
    for (int seed = 0; seed < cases(400); ++seed) {
        Level level(static_cast<std::uint64_t>(seed), GetParam());
        for (int i = 0; i < 60; ++i) {
            level.change();
            ASSERT_STREQ(level.w->validate(), nullptr) << "seed " << seed << ", change " << i;
            if (level.endless || level.w->type(level.body) != BodyType::static_body) continue;
            const std::uint64_t hash = level.w->hash();
            level.w->reset_mass(level.body);  // looks at all shapes
            ASSERT_EQ(level.w->hash(), hash) << "seed " << seed << ", change " << i;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Places, StaticBounds, testing::Values(Vec2{0, 0}, Vec2{-3000, 800}, Vec2{90000, 90000}),
                         [](const auto& place) { return "at" + std::to_string(place.index); });

}  // namespace
}  // namespace islet::test
