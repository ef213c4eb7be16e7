// Games step by the time of a frame, which jumps. What holds at a steady rate must not flail when it does.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "measure.hpp"

namespace islet::test {
namespace {

struct Frames {
    const char* name;
    float low, high;  // s
    enum { in_turns, at_random, between } how;
};
const Frames all_frames[] = {
    {"1/30 and 1/120 s in turns", 1.0f / 120, 1.0f / 30, Frames::in_turns},   {"1/30 or 1/120 s", 1.0f / 120, 1.0f / 30, Frames::at_random},
    {"1/30 or 1/144 s", 1.0f / 144, 1.0f / 30, Frames::at_random},            {"1/30 and 1/90 s in turns", 1.0f / 90, 1.0f / 30, Frames::in_turns},
    {"between 1/144 and 1/30 s", 1.0f / 144, 1.0f / 30, Frames::between},
};

/// The time of each frame, s.
class Clock {
public:
    Clock(const Frames& frames, unsigned seed) : frames_(frames), random_(seed) {}
    float next() {
        const double u = static_cast<double>(random_()) / 4294967296.0;
        if (frames_.how == Frames::between) return frames_.low + static_cast<float>(u) * (frames_.high - frames_.low);
        const bool is_long = frames_.how == Frames::in_turns ? (count_++ & 1) != 0 : u < 0.5;
        return is_long ? frames_.high : frames_.low;
    }

private:
    const Frames& frames_;
    std::mt19937 random_;
    int count_ = 0;
};

// Two or three bars in a row, each held by a motor at speed 0 that is several times as strong as it needs to be. The middle of one
// bar of 2 m that falls freely has sqrt(3 g L) / 2 = 3.9 m/s after a quarter turn; what is held may give way at half of that.
TEST(FrameTimes, ArmsOnMotorsDoNotFlail) {
    for (const int bars : {2, 3})
        for (const float torque : {50.0f, 200.0f, 1000.0f, 1.0e5f})
            for (const Frames& frames : all_frames)
                for (unsigned seed = 0; seed < 3; ++seed) {
                    TestWorld w(roomy, sleepless());
                    BodyId before = w->create_body({});
                    std::vector<BodyId> arm;
                    std::vector<JointId> hinges;
                    for (int i = 0; i < bars; ++i) {
                        RevoluteJointDef hinge;
                        hinge.base.body_a = before;
                        hinge.base.frame_a.position = {i == 0 ? 0.0f : 1.0f, 0};
                        hinge.base.frame_b.position = {-1, 0};
                        hinge.base.body_b = before = w.add_box({1 + 2 * static_cast<float>(i), 0}, 1, 0.1f);
                        hinge.motor = {.enable = true, .speed = 0, .max_force = torque};
                        arm.push_back(before);
                        hinges.push_back(w->create_joint(hinge));
                    }
                    Clock clock(frames, seed);
                    double fastest = 0, gap = 0;
                    for (double time = 0; time < (slow_build ? 2 : 20);) {
                        const float dt = clock.next();
                        w->step(dt);
                        time += double(dt);
                        for (const BodyId bar : arm) fastest = std::fmax(fastest, double(length(w->linear_velocity(bar))));
                        gap = std::fmax(gap, widest_gap(*w, hinges));
                    }
                    const std::string what = std::to_string(bars) + " bars, " + std::to_string(torque) + " N m, " +
                                           frames.name + ", start " + std::to_string(seed);
                    EXPECT_LT(fastest, 2) << what;
                    EXPECT_LT(gap, 0.02) << what;  // a hundredth of a bar
                }
}

TEST(FrameTimes, StacksStand) {
    for (const Frames& frames : all_frames)
        for (unsigned seed = 0; seed < 3; ++seed) {
            TestWorld w(roomy, sleepless());
            w.add_ground();
            BodyId top;
            for (int i = 0; i < 10; ++i) top = w.add_box({0.01f * static_cast<float>(i & 1), 0.5f + static_cast<float>(i)});
            Clock clock(frames, seed);
            for (double time = 0; time < (slow_build ? 3 : 30);) {
                const float dt = clock.next();
                w->step(dt);
                time += double(dt);
            }
            EXPECT_GT(w->position(top).y, 9.4f) << frames.name << ", start " << seed;
            EXPECT_LT(std::fabs(w->position(top).x), 0.1f) << frames.name << ", start " << seed;
        }
}

}  // namespace
}  // namespace islet::test
