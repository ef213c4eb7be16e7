// What rocks on something round: roly-polies, boards and capsules on balls. Rolling, they do no work, so what they have of energy stays or is lost to friction.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "measure.hpp"

namespace islet::test {
namespace {

// A body that rests on something round, or is round below.
struct Rocker {
    const char* name;
    std::function<BodyId(TestWorld&)> build;
    double height;  // m, of its centre of mass above the contact point, about which it begins to turn; 0: as it lies on the ground
};

BodyId roly_poly(TestWorld& w, const Polygon* weight) {
    w.add_ground();
    const BodyId toy = w.add_circle({0, 0.5f}, 0.5f, rough(1));
    ShapeDef heavy = rough(1);
    heavy.density = 20;
    if (weight != nullptr)
        w->create_shape(toy, *weight, heavy);
    else
        w->create_shape(toy, Circle{{0, -0.3f}, 0.15f}, heavy);
    return toy;
}
BodyId on_a_ball(TestWorld& w, float radius, const std::function<BodyId()>& add) {
    w.add_circle({0, 0}, radius, rough(1), BodyType::static_body);
    return add();
}

const Rocker rockers[] = {
    {"a ball with a box in its lower half",
     [](TestWorld& w) {
         const Polygon weight = make_offset_box(0.1f, 0.1f, {{0, -0.3f}});
         return roly_poly(w, &weight);
     },
     0},
    {"a ball with a smaller one in its lower half", [](TestWorld& w) { return roly_poly(w, nullptr); }, 0},
    {"a thin board on a ball", [](TestWorld& w) { return on_a_ball(w, 1, [&] { return w.add_box({0, 1.05f}, 1, 0.05f, rough(1)); }); }, 0.05},
    {"a thick board on a ball", [](TestWorld& w) { return on_a_ball(w, 0.5f, [&] { return w.add_box({0, 0.7f}, 1, 0.2f, rough(1)); }); }, 0.2},
    {"a capsule across a ball", [](TestWorld& w) { return on_a_ball(w, 1, [&] { return w.add_capsule({0, 1.1f}, 1, 0.1f, rough(1)); }); }, 0.1},
};

/// Lets the rocker roll at `spin` (rad/s).
void push(World& w, BodyId body, const Rocker& rocker, float spin) {
    const double height = rocker.height > 0 ? rocker.height : double(w.center_of_mass(body).y);
    w.set_linear_velocity(body, {-spin * static_cast<float>(height), 0});
    w.set_angular_velocity(body, spin);
}

TEST(RoundRockers, GainsNoEnergy) {
    for (const Rocker& rocker : rockers)
        for (const float rate : {30.0f, 60.0f, 120.0f, 240.0f})
            for (const float spin : {0.45f, 0.6f, 0.9f}) {
                if (slow_build && rate > 60) continue;
                const std::string what = std::string(rocker.name) + " at " + std::to_string(rate) + " Hz, " + std::to_string(spin) + " rad/s";
                TestWorld w(roomy, sleepless());
                const BodyId body = rocker.build(w);
                w->step(1 / rate);
                const double rest = energy_of(*w, {&body, 1});
                push(*w, body, rocker, spin);
                const double start = energy_of(*w, {&body, 1}) - rest;
                double most = 0, last = 0;
                for (int i = 0; i < static_cast<int>(rate) * (slow_build ? 5 : 60); ++i) {
                    w->step(1 / rate);
                    last = energy_of(*w, {&body, 1}) - rest;
                    most = std::fmax(most, last);
                }
                EXPECT_LT(most, 1.1 * start) << what;
                EXPECT_LT(last, start) << what;
            }
}

// Small swings of a body that rolls on the flat, with its centre of mass d below the middle of a circle of radius r: it turns about its contact point, with the
// inertia I + m (r - d)^2, and m g d for each radian takes it back.
TEST(RoundRockers, ARolyPolySwingsAtTheRateOfItsFormula) {
    for (int which = 0; which < 2; ++which) {
        TestWorld w(roomy, sleepless());
        const BodyId toy = rockers[which].build(w);
        const double m = double(w->mass(toy)), below = 0.5 - double(w->center_of_mass(toy).y), above = 0.5 - below;
        const double rate = std::sqrt(m * g * below / (double(w->rotational_inertia(toy)) + m * above * above));  // rad/s
        push(*w, toy, rockers[which], 0.5f);
        constexpr int turns = 20;  // of its swing, twice a period
        double first = 0, last = 0, time = 0, before = double(w->angle(toy));
        for (int crossed = 0; crossed <= turns && time < 100; time += double(step_time)) {
            w->step(step_time);
            const double now = double(w->angle(toy));
            if (before * now < 0) {
                last = time + double(step_time) * before / (before - now);
                if (crossed++ == 0) first = last;
            }
            before = now;
        }
        EXPECT_TRUE(w.errors.empty());
        EXPECT_NEAR(turns * double(pi) / (last - first), rate, 0.02 * rate) << rockers[which].name;
    }
}

}  // namespace
}  // namespace islet::test
