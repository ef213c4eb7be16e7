#include "../exact.hpp"

#include "../bodies/sleep.hpp"

#include "../broadphase/tree.hpp"
#include "../graph/contacts.hpp"
#include "../graph/joint_graph.hpp"
#include "../graph/sensors.hpp"

namespace islet::detail {

namespace {

void wake_one(Core& core, std::uint32_t body) {
    core.forget_plan();
    core.awake_bodies.set(body);
    core.motions[body].sleep_time = 0;
    unrest_shapes(core, body);
    for_each_contact(core, body, [&](std::uint32_t contact, std::uint32_t) { core.awake_contacts.set(contact); });
    for_each_joint(core, body, [&](std::uint32_t joint, std::uint32_t) {
        if (!is_joint_idle(core, core.joints[joint])) core.awake_joints.set(joint);
    });
}

/// Calls visit(other) for each body that a touching contact or a joint connects to this one; of a joint to the world, visit(null_index).
template <class Visit>
void for_each_neighbor(const Core& core, std::uint32_t body, Visit&& visit) {
    for_each_contact(core, body, [&](std::uint32_t contact, std::uint32_t side) {
        if ((core.manifolds[contact].flags & contact_touching) != 0) visit(other_body(core, contact, side));
    });
    for_each_joint(core, body, [&](std::uint32_t joint, std::uint32_t side) { visit(other_joined(core, joint, side)); });
}

}  // namespace

void rest_shapes(Core& core, std::uint32_t body, std::uint32_t newest) {
    if ((core.bodies[body].flags & body_disabled) != 0) return;
    const Tree tree{&core.state->tree, core.tree};
    for (std::uint32_t s = core.bodies[body].shape_head; s != null_index && newest != 0; s = core.shapes[s].next, --newest) {
        std::uint32_t& leaf = core.shapes[s].tree_node;
        if (leaf != null_index && tree.nodes[leaf].box != core.boxes[s]) {  // happens far from the origin, where rounding exceeds the margin
            tree_remove(tree, leaf);
            leaf = null_index;
        }
        if (leaf == null_index) leaf = tree_insert(tree, core.boxes[s], s);
    }
}

void refit_boxes(Core& core, std::uint32_t body, std::uint32_t newest) {
    update_boxes(core, body, false, newest);
    if (!core.is_awake(body)) rest_shapes(core, body, newest);
}

void unrest_shapes(Core& core, std::uint32_t body) {
    const Tree tree{&core.state->tree, core.tree};
    for (std::uint32_t s = core.bodies[body].shape_head; s != null_index; s = core.shapes[s].next) {
        if (core.shapes[s].tree_node == null_index) continue;
        tree_remove(tree, core.shapes[s].tree_node);
        core.shapes[s].tree_node = null_index;
    }
}

void wake_island(Core& core, std::uint32_t body, Arena arena) {
    if (core.bodies[body].type() == BodyType::static_body || (core.bodies[body].flags & body_disabled) != 0) return;
    if (!has_sleep || core.is_awake(body)) {
        core.motions[body].sleep_time = 0;
        return;
    }
    // Each body enters the queue once, when it wakes.
    std::uint32_t* queue = arena.take<std::uint32_t>(core.capacity.bodies);
    std::uint32_t end = 0;
    const auto reach = [&](std::uint32_t other) {
        if (other == null_index || !core.is_dynamic(other) || core.is_awake(other) || (core.bodies[other].flags & body_disabled) != 0) return;
        wake_one(core, other);
        queue[end++] = other;
    };
    wake_one(core, body);
    queue[end++] = body;
    for (std::uint32_t at = 0; at < end; ++at) for_each_neighbor(core, queue[at], reach);
}

void sleep_island(Core& core, std::uint32_t body, Arena arena) {
    if (!core.is_dynamic(body) || !core.is_awake(body)) return;
    const auto words = static_cast<std::uint32_t>(words_for(core.capacity.bodies));
    const BitSet found{arena.take<std::uint64_t>(words), words};
    found.clear_all();
    std::uint32_t* island = arena.take<std::uint32_t>(core.capacity.bodies);
    std::uint32_t end = 0;
    bool held = false;
    const auto reach = [&](std::uint32_t other) {
        if (other == null_index || !core.is_awake(other) || found.test(other)) return;
        held = held || !core.is_dynamic(other);
        found.set(other);
        island[end++] = other;
    };
    reach(body);
    for (std::uint32_t at = 0; at < end && !held; ++at) for_each_neighbor(core, island[at], reach);
    if (held) return;
    for (std::uint32_t i = 0; i < end; ++i) {
        Motion& motion = core.motions[island[i]];
        motion.force = {0, 0};
        motion.torque = 0;
        if (has_tuning) core.residuals[island[i]] = 0;
        put_to_sleep(core, island[i]);
    }
}

// Written out: with for_each_neighbor every program would be 12 bytes larger.
void wake_neighbors(Core& core, std::uint32_t body, Arena arena) {
    for_each_contact(core, body, [&](std::uint32_t contact, std::uint32_t side) {
        if ((core.manifolds[contact].flags & contact_touching) != 0) wake_island(core, other_body(core, contact, side), arena);
    });
    for_each_joint(core, body, [&](std::uint32_t joint, std::uint32_t side) {
        const std::uint32_t other = other_joined(core, joint, side);
        if (other != null_index) wake_island(core, other, arena);
    });
}

void end_contacts(Core& core, std::uint32_t body) {
    wake_neighbors(core, body, core.arena());
    for_each_contact(core, body, [&](std::uint32_t contact, std::uint32_t) { destroy_contact(core, contact); });
}

void put_to_sleep(Core& core, std::uint32_t body) {
    core.forget_plan();
    core.awake_bodies.clear(body);
    core.motions[body].v = {0, 0};
    core.motions[body].w = 0;
    core.motions[body].sleep_time = 0;
    core.poses[body].flags &= ~static_cast<std::uint32_t>(pose_fast | pose_learns);
    rest_shapes(core, body);
    for_each_contact(core, body, [&](std::uint32_t contact, std::uint32_t side) {
        if (core.is_awake(other_body(core, contact, side))) return;
        core.awake_contacts.clear(contact);
        if (has_sensors && (core.manifolds[contact].flags & contact_overlap) != 0 && !overlaps_sensor(core, contact)) end_overlap(core, contact);
    });
    for_each_joint(core, body, [&](std::uint32_t joint, std::uint32_t side) {
        const std::uint32_t other = other_joined(core, joint, side);
        if (other == null_index || !core.is_awake(other)) core.awake_joints.clear(joint);
    });
}

}  // namespace islet::detail
