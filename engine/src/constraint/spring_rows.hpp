// Springs of joints in lanes: SplitSpring (softness.hpp), with what a joint knows of its neighbours.
#pragma once

#include "../constraint/joint_rows.hpp"
#include "../constraint/softness.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

/// SplitSpring in lanes. A lane without a spring has a kick below 0.
template <std::uint32_t W>
struct SpringRows {
    float kick[W], scale[W], late[W];
};

/// Joints of the body of j that has most of them, and can be pushed. As many springs, each of the same frequency alone, swing a light body at most so many
/// times faster, squared.
ISLET_SHARED float crowd_of(const Joint& j, const Pose* poses, const Body* bodies) {
    std::uint32_t most = 1;
    for (const std::uint32_t body : {j.body_a, j.body_b}) {
        if (body == null_index || !is_positive(poses[body].inv_mass)) continue;
        const std::uint32_t count = bodies[body].joint_count;
        if (count > most) most = count;
    }
    return static_cast<float>(most);
}

template <std::uint32_t W>
ISLET_SHARED void set_spring(SpringRows<W>& r, std::uint32_t lane, const SplitSpring& spring) {
    r.kick[lane] = spring.kick;
    r.scale[lane] = spring.scale;
    r.late[lane] = spring.late;
}

}  // namespace islet::detail
