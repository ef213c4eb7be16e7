// The same bits everywhere: every scene, at every width of lanes, against the hashes in golden.txt. This test is built and run by every compiler, at
// every optimisation level and under the sanitizers, so a pass there is equality between them.
//
// When the engine's results are meant to change: ISLET_UPDATE_GOLDEN=1 tests/islet_determinism_tests --gtest_filter=GoldenFile.*
// rewrites golden.txt (so does the program `islet_hashes` with --update). Builds with asserts or sanitizers run the benchmark scenes to their near checkpoint only.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <tuple>

#include "golden.hpp"

namespace islet::test {
namespace {

#ifdef NDEBUG
constexpr int most_large_steps = 1 << 30;
#else
constexpr int most_large_steps = 20;
#endif

bool updating() {
    const char* wish = std::getenv("ISLET_UPDATE_GOLDEN");
    return wish != nullptr && std::string(wish) == "1";
}

// Rewrites the file once, before the tests that compare with it.
class Update : public testing::Environment {
public:
    void SetUp() override {
        if (!updating()) return;
        const golden::Table old = golden::read(golden::file());
        golden::Table table;
        for (const samples::SceneInfo& info : samples::catalogue())
            table.push_back({info.name, golden::run(info, golden::checkpoints_of(old, info), 0, 1 << 30)});
        ASSERT_TRUE(golden::write(golden::file(), table)) << "cannot write " << golden::file();
    }
};
const testing::Environment* const update = testing::AddGlobalTestEnvironment(new Update);

class Golden : public testing::TestWithParam<std::tuple<samples::SceneInfo, std::uint32_t>> {};

TEST_P(Golden, HashIsTheSameOnEveryMachine) {
    const auto& [info, lanes] = GetParam();
    const golden::Table table = golden::read(golden::file());
    const std::vector<golden::Checkpoint> due = golden::checkpoints_of(table, info);
    const bool large = std::string(info.group) == "benchmark";
    const std::vector<golden::Checkpoint> seen = golden::run(info, due, lanes, large ? most_large_steps : 1 << 30);
    ASSERT_FALSE(seen.empty());
    for (std::size_t i = 0; i < seen.size(); ++i)
        EXPECT_EQ(golden::hex(seen[i].hash), golden::hex(due[i].hash)) << "after " << seen[i].steps << " steps";
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden, testing::Combine(testing::ValuesIn(samples::catalogue()), testing::Values(1u, 4u, 8u, 16u)),
                         [](const auto& test) {
                             return std::string(std::get<0>(test.param).name) + "_lanes_" + std::to_string(std::get<1>(test.param));
                         });

TEST(GoldenFile, NamesEverySceneAndNoOther) {
    const golden::Table table = golden::read(golden::file());
    ASSERT_FALSE(table.empty()) << "no hashes in " << golden::file();
    for (const golden::Entry& entry : table) EXPECT_NE(samples::find_scene(entry.scene), nullptr) << entry.scene << " is no scene";
    for (const samples::SceneInfo& info : samples::catalogue()) {
        const bool known = std::any_of(table.begin(), table.end(), [&](const golden::Entry& e) { return e.scene == info.name; });
        EXPECT_TRUE(known) << info.name << " has no golden hash";
    }
}

}  // namespace
}  // namespace islet::test
