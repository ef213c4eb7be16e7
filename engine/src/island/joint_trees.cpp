#include "island/joint_trees.hpp"

#include "island/union_find.hpp"
#include "math/scalar.hpp"

namespace islet::detail {

namespace {

// The end of the hinge that is not `body`.
std::uint32_t other_end(const Joint& j, std::uint32_t body) { return j.body_a == body ? j.body_b : j.body_a; }

bool moves(const Core& core, std::uint32_t body) { return core.poses[body].inv_mass > 0; }

// Calls visit(body, joint) for each body of the forest that the hinges make for which wants(joint) holds, leaves first; `joint` ties it to its parent,
// which comes later, or is null_index at the root of a tree that nothing holds. A hinge of a loop is never visited.
//
// Of each body are kept the number of its hinges and the XOR of their indices, which is the last one's index once the others are gone.
template <class Wants, class Visit>
void for_each_leaf(const Core& core, Arena temporary, Wants&& wants, Visit&& visit) {
    const std::uint32_t bodies = core.state->body_pool.high_water;
    struct Ends {
        std::uint32_t count, joints;
    };
    Ends* ends = temporary.take<Ends>(bodies);
    std::uint32_t* queue = temporary.take<std::uint32_t>(bodies);
    std::memset(ends, 0, std::size_t{bodies} * sizeof(Ends));
    const auto for_each_wanted = [&](auto&& work) {
        for (std::uint32_t i = 0; i < core.state->joint_pool.high_water; ++i)
            if ((core.joints[i].generation & 1u) != 0 && wants(i)) work(i, core.joints[i]);
    };
    for_each_wanted([&](std::uint32_t i, const Joint& j) {
        for (const std::uint32_t body : {j.body_a, j.body_b}) {
            ++ends[body].count;
            ends[body].joints ^= i;
        }
    });
    std::uint32_t queued = 0;
    constexpr std::uint32_t in_queue = 1u << 31;
    const auto look_at = [&](std::uint32_t body) {
        if (ends[body].count != 1 || !moves(core, body)) return;  // of those in the queue the count is larger than any
        ends[body].count |= in_queue;
        queue[queued++] = body;
    };
    for_each_wanted([&](std::uint32_t, const Joint& j) {
        look_at(j.body_a);
        look_at(j.body_b);
    });
    for (std::uint32_t at = 0; at < queued; ++at) {
        const std::uint32_t body = queue[at];
        if (ends[body].count == in_queue) {
            visit(body, null_index);
            continue;
        }
        const std::uint32_t joint = ends[body].joints;
        const std::uint32_t parent = other_end(core.joints[joint], body);
        visit(body, joint);
        --ends[parent].count;
        ends[parent].joints ^= joint;
        look_at(parent);
    }
}

// What is known of the bodies that hinges link, at the root of each such set.
struct Links {
    bool held;    // by a static or kinematic body
    bool swept;   // sweeps do better: a hinge closes a loop, or something acts on the angle of one
    bool loaded;  // a hinge bears so much that sweeping would not do
};

}  // namespace

void choose_trees(Core& core, Arena temporary) {
    State& s = *core.state;
    if (s.trees_stale == 0) return;
    s.trees_stale = 0;
    s.exact_joints = 0;
    for (std::uint32_t i = 0; i < s.joint_pool.high_water; ++i) core.joints[i].flags &= ~static_cast<std::uint32_t>(joint_exact);
    const SolverDef def = unpack(s.solver);
    if (!has_joint(JointType::revolute) || def.joint_trees == JointTrees::off) return;

    const std::uint32_t bodies = s.body_pool.high_water;
    const UnionFind sets{temporary.take<std::uint32_t>(bodies)};
    Links* links = temporary.take<Links>(bodies);
    for (std::uint32_t i = 0; i < bodies; ++i) {
        sets.parent[i] = i;
        links[i] = {};
    }
    for (std::uint32_t i = 0; i < s.joint_pool.high_water; ++i) {
        Joint& j = core.joints[i];
        if ((j.generation & 1u) == 0 || j.joint_type() != JointType::revolute) continue;
        const bool moves_a = moves(core, j.body_a), moves_b = moves(core, j.body_b);
        if (!moves_a && !moves_b) continue;
        const std::uint32_t a = sets.root_of(moves_a ? j.body_a : j.body_b), b = sets.root_of(moves_b ? j.body_b : j.body_a);
        const bool holds = !moves_a || !moves_b;
        if (holds ? links[a].held : a == b || (links[a].held && links[b].held)) {
            links[a].swept = links[b].swept = true;
            continue;
        }
        j.flags |= joint_exact;
        const bool acts = (j.flags & (joint_spring | joint_limit | joint_motor)) != 0;
        const std::uint32_t root = sets.join(a, b);
        links[root] = {links[a].held || links[b].held || holds, links[a].swept || links[b].swept || acts, false};
    }

    // What a hinge bears: the mass of all that hangs on it, beside the lighter of its two bodies.
    const bool all = def.joint_trees == JointTrees::all;
    float* load = temporary.take<float>(bodies);
    for (std::uint32_t i = 0; i < bodies; ++i) load[i] = core.bodies[i].mass;
    const auto is_exact = [&](std::uint32_t i) { return (core.joints[i].flags & joint_exact) != 0; };
    for_each_leaf(core, temporary, is_exact, [&](std::uint32_t body, std::uint32_t joint) {
        if (joint == null_index) return;
        const std::uint32_t parent = other_end(core.joints[joint], body);
        const float own = core.bodies[body].mass;
        const float lighter = moves(core, parent) ? min(own, core.bodies[parent].mass) : own;
        Links& of = links[sets.root_of(body)];
        of.loaded = of.loaded || load[body] >= def.joint_tree_load * lighter;
        load[parent] += load[body];
    });
    for (std::uint32_t i = 0; i < s.joint_pool.high_water; ++i) {
        Joint& j = core.joints[i];
        if ((j.flags & joint_exact) == 0) continue;
        const Links& of = links[sets.root_of(moves(core, j.body_a) ? j.body_a : j.body_b)];
        if (all || (of.loaded && !of.swept)) {
            ++s.exact_joints;
        } else {
            j.flags &= ~static_cast<std::uint32_t>(joint_exact);
        }
    }
}

std::uint32_t order_trees(const Core& core, TreeBody* out, Arena temporary) {
    std::uint32_t count = 0;
    const auto wants = [&](std::uint32_t i) { return (core.joints[i].flags & joint_exact) != 0 && core.awake_joints.test(i); };
    for_each_leaf(core, temporary, wants, [&](std::uint32_t body, std::uint32_t joint) { out[count++] = {body, joint}; });
    return count;
}

void link_joint_trees() {}

}  // namespace islet::detail
