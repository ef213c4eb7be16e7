// Joints of disabled bodies.
#include "../exact.hpp"

#include "../graph/joint_graph.hpp"

namespace islet::detail {

bool has_disabled_body(const Core& core, const Joint& j) {
    for (const std::uint32_t body : bodies_of(core, j).body)
        if (body != null_index && (core.bodies[body].flags & body_disabled) != 0) return true;
    return false;
}

void refresh_awake_joints(Core& core) {
    if constexpr (has_joints) {
        for_each_live(core.state->joint_pool, core.joints, [&](std::uint32_t i) { core.awake_joints.assign(i, is_joint_awake(core, core.joints[i])); });
        core.state->trees_stale = 1;
    }
}

}  // namespace islet::detail
