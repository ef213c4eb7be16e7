// Every scene with a stated tolerance agrees with Box2D within it.
#include <gtest/gtest.h>

#include "compare/compare.hpp"

namespace {

using namespace islet::compare;

class ReferenceScene : public testing::TestWithParam<Tolerance> {};

TEST_P(ReferenceScene, AgreesWithBox2d) {
    const Tolerance& tolerance = GetParam();
    const auto* info = islet::samples::find_scene(tolerance.scene);
    ASSERT_NE(info, nullptr);
    const Comparison comparison = compare_scene(*info, tolerance);
    ASSERT_EQ(comparison.lacks, "");
    EXPECT_FALSE(comparison.checks.empty());
    for (const Check& check : comparison.checks) EXPECT_TRUE(check.pass()) << check.name << ": " << check.value << ", more than " << check.limit << ", known " << check.known;
}

INSTANTIATE_TEST_SUITE_P(All, ReferenceScene, testing::ValuesIn(tolerances()),
                         [](const auto& instance) { return std::string(instance.param.scene); });

TEST(Reference, AtLeastTwentyFourScenesAreCompared) { EXPECT_GE(tolerances().size(), 24u); }

TEST(Reference, EveryToleranceSaysWhy) {
    for (const Tolerance& t : tolerances()) EXPECT_NE(std::string(t.reason), "") << t.scene;
}

}  // namespace
