// The joints of a world, as pictures need them.
#pragma once

#include <vector>

#include <islet/islet.hpp>

namespace islet::samples {

struct DrawnJoint {
    std::uint32_t slot = 0;  // 0 <= slot < capacity().joints
    BodyId body_a, body_b;
    Vec2 anchor_a, anchor_b;  // m, in the world
    double linear_error = 0;  // m, how far the joint is from what it holds
};

std::vector<DrawnJoint> collect_joints(const World& world);

}  // namespace islet::samples
