// The whole catalogue: every scene runs on Islet for its steps and keeps what its own check states in numbers.
//
// Builds with asserts or sanitizers run the benchmark scenes, which are several times slower there, for 40 steps, and the steady ones, which last for
// minutes, for 120. They ask only what does not depend on the steps: how many bodies and shapes there are, and that every number is finite.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "harness/checks.hpp"
#include "harness/engine.hpp"
#include "physics/measure.hpp"
#include "scenes/catalogue.hpp"
#include "support/kept_plan.hpp"

namespace islet::test {
namespace {

using samples::CheckLine;
using samples::IsletEngine;
using samples::Scene;
using samples::SceneInfo;

bool is_large(const SceneInfo& info) { return std::string(info.group) == "benchmark"; }
bool is_long(const SceneInfo& info) { return std::string(info.group) == "steady"; }

class EveryScene : public testing::TestWithParam<SceneInfo> {};

TEST_P(EveryScene, KeepsItsCheck) {
    const Scene scene = GetParam().make();
    ASSERT_TRUE(scene.check) << "a scene without a check";
    EXPECT_EQ(scene.name, GetParam().name);
    IsletEngine engine;
    engine.load(scene);
    const bool cut_short = slow_build && (is_large(GetParam()) || is_long(GetParam()));
    const int steps = cut_short ? std::min(scene.steps, is_large(GetParam()) ? 40 : 120) : scene.steps;
    for (int i = 0; i < steps; ++i) {
        engine.advance(scene, i, scene.dt);
        ASSERT_EQ(engine.world().report().dropped_contacts, 0u) << "step " << i;
        if (i % 7 == 0) expect_kept_plan_is_right(engine.world());
        ASSERT_FALSE(HasFailure()) << "step " << i;
    }

    if (cut_short) {
        EXPECT_EQ(samples::count_not_finite(engine), 0u);
    } else {
        const std::vector<CheckLine> lines = scene.check(engine);
        EXPECT_FALSE(lines.empty());
        for (const CheckLine& line : lines)
            EXPECT_TRUE(line.pass()) << line.what << ": " << line.value << " is not within " << line.low << " to " << line.high;
    }
    EXPECT_EQ(engine.world().last_error(), Error::none) << describe(engine.world().last_error());
    const char* broken = engine.world().validate();
    EXPECT_EQ(broken, nullptr) << broken;

    // The dimensions that make a benchmark scene the same one as elsewhere. Contacts count near pairs too, so box margins move them: a quarter.
    struct Size {
        const char* scene;
        std::size_t bodies, shapes, contacts, joints;
    };
    constexpr Size sizes[] = {
        {"large_pyramid", 5051, 5051, 14950, 0}, {"many_pyramids", 22001, 22020, 58000, 0},
        {"joint_grid", 10000, 10000, 0, 19794},  // and, elsewhere, six joints between bodies that are held, which Islet refuses
        {"tumbler", 2027, 2029, 8823, 1},        {"washer", 8102, 8140, 29669, 0},
        {"spinner", 6078, 6437, 23049, 1},       {"rain", 11001, 15505, 20651, 10000},
        {"smash", 9601, 9601, 6296, 0},          {"compounds", 3001, 6282, 26221, 0},
        {"junkyard", 8002, 8262, 24341, 0},
    };
    const auto* size = std::find_if(std::begin(sizes), std::end(sizes), [&](const Size& s) { return scene.name == s.scene; });
    EXPECT_EQ(size != std::end(sizes), is_large(GetParam())) << "the size of every benchmark scene is stated, and of no other";
    if (size == std::end(sizes)) return;
    if (cut_short && scene.extra_bodies > 0) return;  // its script has not made them all yet
    EXPECT_EQ(engine.counts().bodies, size->bodies);
    EXPECT_EQ(engine.counts().joints, size->joints);
    EXPECT_EQ(engine.counts().shapes, size->shapes);
    if (!cut_short) { EXPECT_NEAR(double(engine.counts().contacts), double(size->contacts), 0.3 * double(size->contacts)); }
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, testing::ValuesIn(samples::catalogue()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Scenes, NamesAreUniqueAndFound) {
    for (const SceneInfo& info : samples::catalogue()) {
        const SceneInfo* found = samples::find_scene(info.name);
        ASSERT_NE(found, nullptr);
        EXPECT_EQ(found, &info) << info.name << " is there twice";
    }
}

}  // namespace
}  // namespace islet::test
