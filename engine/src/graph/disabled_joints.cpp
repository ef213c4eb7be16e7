// Joints of disabled bodies.
#include "../exact.hpp"

#include "../graph/joint_graph.hpp"

namespace islet::detail {

bool has_disabled_body(const Core& core, const Joint& j) {
    const auto off = [&](std::uint32_t body) { return body != null_index && (core.bodies[body].flags & body_disabled) != 0; };
    if (off(j.body_a) || off(j.body_b)) return true;
    if (j.joint_type() != JointType::gear) return false;
    const Joint& j1 = core.joints[j.joint1];
    const Joint& j2 = core.joints[j.joint2];
    return off(j1.body_a) || off(j1.body_b) || off(j2.body_a) || off(j2.body_b);
}

void refresh_awake_joints(Core& core) {
    if constexpr (has_joints) {
        for_each_live(core.state->joint_pool, core.joints, [&](std::uint32_t i) { core.awake_joints.assign(i, is_joint_awake(core, core.joints[i])); });
        core.state->trees_stale = 1;
    }
}

}  // namespace islet::detail
