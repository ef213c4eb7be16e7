#include "../exact.hpp"

#include "../island/joint_trees.hpp"

#include "../island/batches.hpp"
#include "../math/inlining.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

namespace {

// The end of the hinge that is not `body`.
std::uint32_t other_end(const Joint& j, std::uint32_t body) { return j.body_a == body ? j.body_b : j.body_a; }

}  // namespace

void choose_trees(Core& core, Arena temporary) {
    State& s = *core.state;
    if (s.trees_stale == 0) return;
    s.trees_stale = 0;
    s.exact_joints = 0;
    for (std::uint32_t i = 0; i < s.joint_pool.high_water; ++i) core.joints[i].flags &= ~static_cast<std::uint32_t>(joint_exact);
    const auto wanted = static_cast<JointTrees>(s.solver.joint_trees);
    if (!has_joint(JointType::revolute) || wanted == JointTrees::off) return;

    const std::uint32_t bodies = s.body_pool.high_water;
    const Forest forest(bodies, temporary);
    for (std::uint32_t i = 0; i < s.joint_pool.high_water; ++i) {
        Joint& j = core.joints[i];
        if ((j.generation & 1u) != 0 && j.joint_type() == JointType::revolute && forest.add(core, j)) j.flags |= joint_exact;
    }

    // What a hinge bears: the mass of all that hangs on it, beside the lighter of its two bodies.
    float* load = temporary.take<float>(bodies);
    for (std::uint32_t i = 0; i < bodies; ++i) load[i] = core.bodies[i].mass;
    TreeBody* order = temporary.take<TreeBody>(tree_capacity(core.capacity));
    const std::uint32_t count = order_trees(core, false, order, temporary);
    for (std::uint32_t k = 0; k < count; ++k) {
        const TreeBody b = order[k];
        if (b.joint == null_index) continue;
        const std::uint32_t parent = other_end(core.joints[b.joint], b.body);
        const float own = core.bodies[b.body].mass;
        const float lighter = Forest::moves(core, parent) ? min(own, core.bodies[parent].mass) : own;
        Forest::Tree& of = forest.tree_of(core, core.joints[b.joint]);
        of.loaded = of.loaded || load[b.body] >= s.solver.joint_tree_load * lighter;
        load[parent] += load[b.body];
    }

    for (std::uint32_t i = 0; i < s.joint_pool.high_water; ++i) {
        Joint& j = core.joints[i];
        if ((j.flags & joint_exact) == 0) continue;
        const Forest::Tree& of = forest.tree_of(core, j);
        if (wanted == JointTrees::all || (of.loaded && !of.swept)) {
            ++s.exact_joints;
        } else {
            j.flags &= ~static_cast<std::uint32_t>(joint_exact);
        }
    }
}

// Of each body are kept the number of its hinges and the XOR of their indices, which is the last one's index once the others are gone.
std::uint32_t order_trees(const Core& core, bool awake, TreeBody* out, Arena temporary) {
    const std::uint32_t bodies = core.state->body_pool.high_water;
    struct Ends {
        std::uint32_t count, joints;
    };
    Ends* ends = temporary.take<Ends>(bodies);
    std::memset(ends, 0, std::size_t{bodies} * sizeof(Ends));
    const auto for_each_hinge = [&](auto&& visit) {
        for (std::uint32_t i = 0; i < core.state->joint_pool.high_water; ++i)
            if ((core.joints[i].flags & joint_exact) != 0 && (!awake || core.awake_joints.test(i))) visit(i, core.joints[i]);
    };
    for_each_hinge([&](std::uint32_t i, const Joint& j) {
        for (const std::uint32_t body : {j.body_a, j.body_b}) {
            ++ends[body].count;
            ends[body].joints ^= i;
        }
    });
    std::uint32_t count = 0;
    constexpr std::uint32_t queued = 1u << 31;
    const auto look_at = [&](std::uint32_t body) {
        if (ends[body].count != 1 || !Forest::moves(core, body)) return;  // of those in the queue the count is larger than any
        ends[body].count |= queued;
        out[count++].body = body;
    };
    for_each_hinge([&](std::uint32_t, const Joint& j) {
        look_at(j.body_a);
        look_at(j.body_b);
    });
    for (std::uint32_t at = 0; at < count; ++at) {
        const std::uint32_t body = out[at].body;
        out[at].joint = null_index;
        if (ends[body].count == queued) continue;  // all its hinges are gone: a root
        const std::uint32_t joint = out[at].joint = ends[body].joints;
        const std::uint32_t parent = other_end(core.joints[joint], body);
        --ends[parent].count;
        ends[parent].joints ^= joint;
        look_at(parent);
    }
    return count;
}

ISLET_APART void plan_trees(const Core& core, Plan& plan, const Islands& islands, Arena temporary) {
    TreeBody* ordered = temporary.take<TreeBody>(tree_capacity(core.capacity));
    std::uint32_t* place_of = temporary.take<std::uint32_t>(core.state->body_pool.high_water);  // of a body, among its batch's
    const std::uint32_t count = order_trees(core, true, ordered, temporary);
    for (std::uint32_t i = 0; i < count; ++i) ++plan.batches[islands.batch_of(ordered[i].body)].end_tree;
    for (std::uint32_t b = 0; b < plan.batch_count; ++b) {
        Batch& batch = plan.batches[b];
        batch.first_tree = plan.tree_count;
        plan.tree_count += batch.end_tree;
        batch.end_tree = batch.first_tree;
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        Batch& batch = plan.batches[islands.batch_of(ordered[i].body)];
        place_of[ordered[i].body] = batch.end_tree - batch.first_tree;
        plan.tree_bodies[batch.end_tree++] = ordered[i];
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        const TreeBody& b = plan.tree_bodies[i];
        const std::uint32_t parent = b.joint != null_index ? other_end(core.joints[b.joint], b.body) : null_index;
        plan.tree_parents[i] = parent != null_index && Forest::moves(core, parent) ? place_of[parent] : null_index;
    }
}

void link_joint_trees() {}

}  // namespace islet::detail
