#include "recorded_joints.hpp"

namespace islet::samples {
namespace {

/// From body to body through the anchors; a pulley's line goes over its fixed points, a mouse joint's starts at its target.
std::vector<RecordedJoint::Point> line_of(const World& world, JointId joint) {
    const BodyId a = world.body_a(joint), b = world.body_b(joint);
    std::vector<RecordedJoint::Point> line;
    if (a) line.push_back({a, world.center_of_mass(a), false});
    line.push_back({a, world.anchor_a(joint), true});
    if (world.joint_type(joint) == JointType::pulley) {
        line.push_back({{}, world.ground_a(joint), false});
        line.push_back({{}, world.ground_b(joint), false});
    }
    line.push_back({b, world.anchor_b(joint), true});
    line.push_back({b, world.center_of_mass(b), false});
    return line;
}

}  // namespace

std::vector<RecordedJoint> collect_joints(const World& world) {
    std::vector<RecordedJoint> joints;
    for (std::uint32_t slot = 0; slot < world.capacity().joints; ++slot) {
        const JointId joint = world.joint_at(slot);
        // A gear couples two joints that are drawn already.
        if (!joint || world.joint_type(joint) == JointType::gear) continue;
        joints.push_back({slot, line_of(world, joint), double(world.joint_error(joint).linear)});
    }
    return joints;
}

}  // namespace islet::samples
