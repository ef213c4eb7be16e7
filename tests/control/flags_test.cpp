// What a shape is told to do later is known to the world as well as what it was made with.
#include <gtest/gtest.h>

#include <vector>

#include "support/test_world.hpp"

namespace {

using namespace islet;
using namespace islet::test;

TEST(ShapeFlags, AWorldIsSoundAndItsImageLoadsWhicheverIsSetLater) {
    void (*const changes[])(World&, ShapeId) = {
        [](World& w, ShapeId s) { w.enable_sensor_events(s, false); },
        [](World& w, ShapeId s) { w.enable_hit_events(s, true); },
        [](World& w, ShapeId s) { w.enable_pre_solve(s, true); },
    };
    for (const auto change : changes) {
        TestWorld w, other;
        const BodyId ball = w.add_circle({0, 4});
        change(*w, w.shape_of(ball));
        EXPECT_EQ(w->validate(), nullptr);
        std::vector<std::byte> image(w->snapshot_bytes());
        ASSERT_EQ(w->save(image), image.size());
        EXPECT_TRUE(other->load(image)) << describe(other->last_error());
        EXPECT_EQ(other->hash(), w->hash());
        EXPECT_TRUE(w.errors.empty());
    }
    // Whoever calls these has what they need linked.
    TestWorld w;
    EXPECT_TRUE(w->hit_events().empty());
    EXPECT_TRUE(w->sensor_begin_events().empty());
    w->set_hooks({});
}

}  // namespace
