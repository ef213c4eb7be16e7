// The joints of a world, as a recording needs them.
#pragma once

#include <vector>

#include <islet/islet.hpp>

namespace islet::samples {

/// A joint is drawn as a line through points that are fixed to bodies, with a dot at its anchors.
struct RecordedJoint {
    struct Point {
        BodyId body;  // null: fixed in the world
        Vec2 place;   // m, in the world
        bool is_anchor = false;
    };

    std::uint32_t slot = 0;  // 0 <= slot < capacity().joints
    std::vector<Point> line;
    double linear_error = 0;  // m, how far the joint is from what it holds
};

std::vector<RecordedJoint> collect_joints(const World& world);

}  // namespace islet::samples
