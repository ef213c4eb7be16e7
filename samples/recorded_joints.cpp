#include "recorded_joints.hpp"

namespace islet::samples {
namespace {

/// From body to anchor to anchor to body; lines to the middle of the ground would cross the whole picture.
std::vector<RecordedJoint::Point> line_of(const World& world, JointId joint) {
    std::vector<RecordedJoint::Point> line;
    const auto add_centre = [&](BodyId body) {
        if (body && world.type(body) == BodyType::dynamic) line.push_back({body, world.center_of_mass(body), false});
    };
    const BodyId a = world.body_a(joint), b = world.body_b(joint);
    add_centre(a);
    line.push_back({a, world.anchor_a(joint), true});
    line.push_back({b, world.anchor_b(joint), true});
    add_centre(b);
    return line;
}

}  // namespace

std::vector<RecordedJoint> collect_joints(const World& world) {
    std::vector<RecordedJoint> joints;
    for (std::uint32_t slot = 0; slot < world.capacity().joints; ++slot) {
        const JointId joint = world.joint_at(slot);
        if (!joint) continue;
        RecordedJoint& recorded = joints.emplace_back();
        recorded.slot = slot;
        recorded.linear_error = double(world.joint_error(joint).linear);
        // A gear joins two joints, which are drawn already.
        if (world.joint_type(joint) != JointType::gear) recorded.line = line_of(world, joint);
    }
    return joints;
}

}  // namespace islet::samples
