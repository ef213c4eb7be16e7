// A pile of ragdolls whose bones are torn out and put back, with their joints, for ten thousand steps.
#include <gtest/gtest.h>

#include <algorithm>

#include "harness/spawn.hpp"
#include "physics/measure.hpp"
#include "scenes/benchmark_doll.hpp"
#include "support/random.hpp"

namespace {

using namespace islet;
using namespace islet::test;

constexpr auto bone_count = static_cast<std::uint32_t>(samples::bone_count);
constexpr std::uint32_t dolls = 10;
constexpr std::uint32_t bones = dolls * bone_count;

class Churn {
public:
    explicit Churn(std::uint32_t lanes) : w_(capacity(), def(lanes)) {
        w_.add_ground(0, 4);
        w_.add_box({-4, 3}, 0.5f, 4, {}, BodyType::static_body);
        w_.add_box({4, 3}, 0.5f, 4, {}, BodyType::static_body);
        for (std::uint32_t i = 0; i < dolls; ++i) {
            const Vec2 at = {static_cast<float>(i % 3) * 2 - 2, 1 + 2 * static_cast<float>(i / 3)};
            prefabs_.push_back(samples::make_benchmark_doll({.position = at, .group = static_cast<int>(i) + 1}));
            dolls_.push_back(samples::spawn(*w_, prefabs_.back()));
        }
    }

    void run(int steps) {
        EXPECT_EQ(w_->joint_count(), dolls * (bone_count - 1));
        for (int i = 0; i < steps; ++i) {
            // 2 % of the bones go, with all their joints and shapes; those that went in the step before come back.
            for (const std::uint32_t bone : gone_) put_back(bone);
            gone_.clear();
            std::uint32_t joints = dolls * (bone_count - 1);
            for (std::uint32_t k = 0; k < bones / 50; ++k) {
                const std::uint32_t bone = random_.below(bones);
                if (std::find(gone_.begin(), gone_.end(), bone) != gone_.end()) continue;
                const std::uint32_t held = w_->joints(body(bone), {});
                w_->destroy_body(body(bone));
                joints -= held;
                gone_.push_back(bone);
            }
            w_.step();
            EXPECT_EQ(w_->joint_count(), joints) << "in step " << i;
            EXPECT_EQ(w_->body_count(), 3 + bones - gone_.size());
            if (i % 100 != 99) continue;
            const char* broken = w_->validate();
            EXPECT_EQ(broken, nullptr) << broken << ", in step " << i;
            EXPECT_TRUE(w_.is_finite()) << "in step " << i;
            if (testing::Test::HasFailure()) return;
        }
        EXPECT_TRUE(w_.errors.empty());
    }

    std::uint64_t hash() const { return w_->hash(); }

private:
    static Capacity capacity() {
        return {.bodies = bones + 3, .shapes = 2 * bones + 3, .contacts = 4000, .joints = dolls * (bone_count - 1)};
    }
    static WorldDef def(std::uint32_t lanes) {
        WorldDef d;
        d.lanes = lanes;
        return d;
    }

    BodyId& body(std::uint32_t bone) { return dolls_[bone / bone_count].bodies[bone % bone_count]; }

    // Where its parent, or else a child, says that it should be; where it stood at first if it has neither.
    void put_back(std::uint32_t bone) {
        const std::uint32_t doll = bone / bone_count;
        const samples::Prefab& prefab = prefabs_[doll];
        samples::PrefabIds& made = dolls_[doll];
        samples::SceneBody plan = prefab.bodies[bone % bone_count];
        for (const samples::SceneJoint& joint : prefab.joints) {
            if (joint.body_a != bone % bone_count && joint.body_b != bone % bone_count) continue;
            const std::size_t other = joint.body_a == bone % bone_count ? joint.body_b : joint.body_a;
            if (!w_->is_valid(made.bodies[other])) continue;
            const Transform now = w_->transform(made.bodies[other]);
            plan.def.position = transform_point(now, plan.def.position - prefab.bodies[other].def.position);
            plan.def.angle = angle_of(now.q);
            plan.def.linear_velocity = w_->linear_velocity(made.bodies[other]);
            break;
        }
        body(bone) = samples::spawn(*w_, plan);
        for (std::size_t j = 0; j < prefab.joints.size(); ++j) {
            const samples::SceneJoint& joint = prefab.joints[j];
            if (joint.body_a != bone % bone_count && joint.body_b != bone % bone_count) continue;
            // One whose other bone is gone as well comes back with that.
            if (w_->is_valid(made.bodies[joint.body_a]) && w_->is_valid(made.bodies[joint.body_b]))
                made.joints[j] = samples::spawn(*w_, joint, made.bodies, made.joints);
        }
    }

    TestWorld w_;
    Random random_{11};
    std::vector<samples::Prefab> prefabs_;
    std::vector<samples::PrefabIds> dolls_;
    std::vector<std::uint32_t> gone_;
};

TEST(Churn, RagdollsLoseAndRegainBonesInEveryStep) {
    Churn churn(0);
    churn.run(slow_build ? 600 : 10000);
}

TEST(Churn, GivesTheSameBitsAtEveryWidth) {
    std::uint64_t hashes[3];
    for (std::size_t i = 0; i < 3; ++i) {
        Churn churn(i == 0 ? 1u : i == 1 ? 4u : 8u);
        churn.run(slow_build ? 100 : 500);
        hashes[i] = churn.hash();
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

}  // namespace
