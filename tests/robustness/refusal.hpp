// What bad input must lead to: nothing changes, the right error is recorded, and the hook hears of it once.
#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "support/test_world.hpp"

namespace islet::test {

inline constexpr float inf = std::numeric_limits<float>::infinity();
inline constexpr float nan = std::numeric_limits<float>::quiet_NaN();
inline constexpr float most = std::numeric_limits<float>::max();
inline constexpr float not_finite[] = {nan, inf, -inf};
inline constexpr Vec2 not_finite_vectors[] = {{nan, 0}, {0, nan}, {inf, 0}, {0, -inf}, {nan, inf}};

/// A world in the middle of its life: things at rest, asleep, in the air and destroyed.
class RefusalTest : public testing::Test {
protected:
    RefusalTest() {
        ground = w.add_ground();
        sleeper = w.add_box({-20, 0.5f});
        w.step(60);
        box = w.add_box({0, 0.5f});
        ball = w.add_circle({0.1f, 1.6f});
        const BodyId gone = w.add_box({5, 5});
        stale_shape = w.shape_of(gone);
        w.step(3);
        w->destroy_body(gone);
        stale_body = gone;
        shape = w.shape_of(box);
        w.step();
    }

    /// `call` must change nothing and report `error`, once.
    template <class Call>
    void expect_refused(Error error, Call&& call) {
        w.errors.clear();
        w->clear_error();
        const std::uint64_t before = w->hash();
        const std::uint64_t steps = w->step_count();
        call();
        EXPECT_EQ(w->hash(), before) << "the world changed";
        EXPECT_EQ(w->step_count(), steps);
        EXPECT_EQ(w->last_error(), error) << describe(w->last_error());
        EXPECT_EQ(w.errors, std::vector<Error>{error}) << "the hook must hear of it exactly once";
        EXPECT_EQ(w->validate(), nullptr);
    }

    TestWorld w;
    BodyId ground, sleeper, box, ball, stale_body;
    ShapeId shape, stale_shape;
};

}  // namespace islet::test
