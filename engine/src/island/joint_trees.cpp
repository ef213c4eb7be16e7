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
    for (std::uint32_t i = 0; i < s.joint_pool.high_water; ++i) core.joints[i].flags &= ~static_cast<std::uint32_t>(joint_exact | joint_anchor);
    const auto wanted = static_cast<JointTrees>(s.solver.joint_trees);
    if (!has_joint(JointType::revolute) || wanted == JointTrees::off) return;

    const std::uint32_t bodies = s.body_pool.high_water;
    const Forest forest(bodies, temporary);
    for (std::uint32_t i = 0; i < s.joint_pool.high_water; ++i) {
        Joint& j = core.joints[i];
        if ((j.generation & 1u) != 0 && j.joint_type() == JointType::revolute && forest.add(core, j)) j.flags |= joint_exact;
    }
    for (std::uint32_t i = 0; i < s.joint_pool.high_water; ++i) {
        Joint& j = core.joints[i];
        if ((j.flags & joint_exact) == 0) {
            if ((j.generation & 1u) != 0) forest.note_burden(core, j);
            continue;
        }
        if (forest.is_anchor(core, j)) j.flags |= joint_anchor;
        if ((j.flags & joint_loaded) != 0) forest.tree_of(core, j).asked = true;
    }

    // A hinge's load is the mass of all bodies that hang on it. It is compared with the lighter of the hinge's two bodies.
    float* load = temporary.take<float>(bodies);
    for (std::uint32_t i = 0; i < bodies; ++i) load[i] = core.bodies[i].mass;
    PlannedLink* order = temporary.take<PlannedLink>(tree_capacity(core.capacity));
    const std::uint32_t count = order_links(core, false, order, temporary);
    for (std::uint32_t k = 0; k < count; ++k) {
        const PlannedLink b = order[k];
        if (b.joint == null_index || !Forest::moves(core, b.body)) continue;
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
        if (wanted == JointTrees::all ||
            ((of.acted ? of.asked : of.loaded) && !of.swept && !(of.acted && of.burdened) && !(of.taut && (of.breaks || of.acted)))) {
            ++s.exact_joints;
        } else {
            j.flags &= ~static_cast<std::uint32_t>(joint_exact | joint_anchor);
        }
    }
}

// For each body the function keeps the number of its hinges and the XOR of their indices: once one hinge is left, the XOR is its index.
std::uint32_t order_links(const Core& core, bool awake, PlannedLink* out, Arena temporary) {
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
    std::uint32_t count = 0;
    for_each_hinge([&](std::uint32_t i, const Joint& j) {
        if ((j.flags & joint_anchor) != 0) {
            out[count++] = {Forest::moves(core, j.body_a) ? j.body_b : j.body_a, i};
            return;
        }
        for (const std::uint32_t body : {j.body_a, j.body_b}) {
            ++ends[body].count;
            ends[body].joints ^= i;
        }
    });
    const std::uint32_t anchors = count;
    constexpr std::uint32_t queued = 1u << 31;
    const auto look_at = [&](std::uint32_t body) {
        if (ends[body].count != 1 || !Forest::moves(core, body)) return;  // a queued body's count is larger than any other
        ends[body].count |= queued;
        out[count++].body = body;
    };
    for_each_hinge([&](std::uint32_t, const Joint& j) {
        look_at(j.body_a);
        look_at(j.body_b);
    });
    for (std::uint32_t at = anchors; at < count; ++at) {
        const std::uint32_t body = out[at].body;
        out[at].joint = null_index;
        if (ends[body].count == queued) continue;  // a root: all its hinges lead to bodies before it
        const std::uint32_t joint = out[at].joint = ends[body].joints;
        const std::uint32_t parent = other_end(core.joints[joint], body);
        --ends[parent].count;
        ends[parent].joints ^= joint;
        look_at(parent);
    }
    return count;
}

ISLET_APART void plan_links(const Core& core, Plan& plan, const Islands& islands, Arena temporary) {
    const std::uint32_t bodies = core.state->body_pool.high_water;
    PlannedLink* ordered = temporary.take<PlannedLink>(tree_capacity(core.capacity));
    const std::uint32_t count = order_links(core, true, ordered, temporary);
    std::uint32_t* root_of = temporary.take<std::uint32_t>(bodies);         // by body: the root of its tree, which is the last of the tree's links
    std::uint32_t* first_of = temporary.take<std::uint32_t>(bodies);        // by root: how many links its tree has; then the first of them
    std::uint32_t* place_of = temporary.take<std::uint32_t>(bodies);        // by body: its link; by root, until that is placed: the tree's next one
    std::uint32_t* next = temporary.take<std::uint32_t>(plan.batch_count);  // by batch: the next tree's first link
    const auto parent_of = [&](const PlannedLink& link) {
        const std::uint32_t parent = link.joint != null_index ? other_end(core.joints[link.joint], link.body) : null_index;
        return parent != null_index && Forest::moves(core, parent) ? parent : null_index;
    };
    const auto is_root = [&](const PlannedLink& link) { return Forest::moves(core, link.body) && root_of[link.body] == link.body; };
    const auto tree_of = [&](const PlannedLink& link) { return root_of[Forest::moves(core, link.body) ? link.body : parent_of(link)]; };
    for (std::uint32_t i = count; i-- > 0;) {  // parents before their children
        const PlannedLink& link = ordered[i];
        const std::uint32_t parent = parent_of(link);
        if (Forest::moves(core, link.body)) root_of[link.body] = parent != null_index ? root_of[parent] : link.body;
        if (is_root(link)) first_of[link.body] = 0;
        const std::uint32_t root = tree_of(link);
        ++first_of[root];
        ++plan.batches[islands.batch_of(root)].link_count;
    }
    for (std::uint32_t b = 0; b < plan.batch_count; ++b) {
        next[b] = plan.batches[b].first_link = plan.link_count;
        plan.link_count += plan.batches[b].link_count;
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t body = ordered[i].body;
        if (!is_root(ordered[i])) continue;
        std::uint32_t& first = next[islands.batch_of(body)];
        place_of[body] = first;
        first += first_of[body];
        first_of[body] = place_of[body];
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t place = place_of[tree_of(ordered[i])]++;
        if (Forest::moves(core, ordered[i].body)) place_of[ordered[i].body] = place;
        plan.links[place] = ordered[i];
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t parent = parent_of(plan.links[i]);
        plan.parent_links[i] = parent != null_index ? place_of[parent] - first_of[root_of[parent]] : null_index;
    }
}

void link_joint_trees() {}

}  // namespace islet::detail
