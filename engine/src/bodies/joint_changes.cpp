// Destroying and breaking joints, and updating them after a body's change of type.
#include "../exact.hpp"

#include "../bodies/joint_changes.hpp"
#include "../bodies/sleep.hpp"
#include "../broadphase/pairs.hpp"
#include "../constraint/joint_rows.hpp"
#include "../data/parallel.hpp"
#include "../graph/colors.hpp"
#include "../graph/contacts.hpp"
#include "../graph/joint_graph.hpp"
#include "../island/joint_trees.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

namespace {

void untie(Core& core, std::uint32_t i) {
    Joint& j = core.joints[i];
    core.forget_plan();
    if (j.body_a != null_index) wake_island(core, j.body_a, core.arena());
    wake_island(core, j.body_b, core.arena());
    give_color(core, j.color(), j.body_a, j.body_b);
    detach_joint(core, i, 0, j.body_a);
    detach_joint(core, i, 1, j.body_b);
    core.awake_joints.clear(i);
    if ((j.flags & joint_collide) == 0 && j.body_a != null_index) {
        // The bodies' shapes may overlap already. Without this mark their contacts would not be looked for, since the shapes have not moved.
        for (std::uint32_t s = core.bodies[j.body_b].shape_head; s != null_index; s = core.shapes[s].next) mark_moved(core, s);
    }
    clear_slot(j);
    pool_give(core.state->joint_pool, core.joints, i);
}

void remove_gear(Core& core, std::uint32_t i) {
    --core.joints[core.joints[i].joint1].gear_count;
    --core.joints[core.joints[i].joint2].gear_count;
    untie(core, i);
}

// A gear hangs on a body of each of its joints.
void remove_gears(Core& core, std::uint32_t joint) {
    for (const std::uint32_t body : {core.joints[joint].body_a, core.joints[joint].body_b}) {
        if (body == null_index || core.joints[joint].gear_count == 0) continue;
        for (std::uint32_t key = core.bodies[body].joint_head; key != 0;) {
            const std::uint32_t i = constraint_of_key(key);
            const Joint& gear = core.joints[i];
            key = gear.next[side_of_key(key)];
            if (gear.joint_type() == JointType::gear && (gear.joint1 == joint || gear.joint2 == joint)) remove_gear(core, i);
        }
    }
}

}  // namespace

void end_forbidden_contacts(Core& core, const Joint& j) {
    if (j.body_a == null_index) return;
    for_each_contact(core, j.body_b, [&](std::uint32_t contact, std::uint32_t side) {
        const Contact& c = core.contacts[contact];
        if (other_body(core, contact, side) == j.body_a && !may_collide(core, c.shape_a, c.shape_b)) destroy_contact(core, contact);
    });
}

void link_joint_changes() {}

void remove_joint(Core& core, std::uint32_t i) {
    if (core.joints[i].joint_type() == JointType::gear) return remove_gear(core, i);
    if (core.joints[i].gear_count != 0) remove_gears(core, i);
    untie(core, i);
}

void remove_joints(Core& core, std::uint32_t body) {
    // Removing a joint may also remove a gear on the same body, so the list is read anew each time.
    while (core.bodies[body].joint_head != 0) remove_joint(core, constraint_of_key(core.bodies[body].joint_head));
}

std::uint32_t moving_body(const Core& core, const Joint& j) { return core.bodies[j.body_b].type() >= core.bodies[j.body_a].type() ? j.body_b : j.body_a; }

// A gear hangs on a moving body of each of its joints, so that it joins their islands and they sleep together. If both joints have the same moving body, the
// gear also hangs on the other body of joint 2, on which its row may act as well.
void hang_gears(Core& core, std::uint32_t body) {
    bool geared = false;
    for_each_joint(core, body, [&](std::uint32_t joint, std::uint32_t) { geared = geared || core.joints[joint].gear_count != 0; });
    if (!geared) return;
    for (std::uint32_t i = 0; i < core.state->joint_pool.high_water; ++i) {
        Joint& gear = core.joints[i];
        if (!pool_live(core.state->joint_pool, core.joints, i) || gear.joint_type() != JointType::gear) continue;
        const Joint& j1 = core.joints[gear.joint1];
        const Joint& j2 = core.joints[gear.joint2];
        if (j1.body_a != body && j1.body_b != body && j2.body_a != body && j2.body_b != body) continue;
        detach_joint(core, i, 0, gear.body_a);
        detach_joint(core, i, 1, gear.body_b);
        gear.body_a = moving_body(core, j1);
        gear.body_b = moving_body(core, j2);
        if (gear.body_a == gear.body_b) gear.body_b = gear.body_b == j2.body_b ? j2.body_a : j2.body_b;
        attach_joint(core, i, 0, gear.body_a);
        attach_joint(core, i, 1, gear.body_b);
        wake_island(core, gear.body_a, core.arena());
        wake_island(core, gear.body_b, core.arena());
        core.awake_joints.assign(i, is_joint_awake(core, gear));
    }
}

void release_joint_colors(Core& core, std::uint32_t body) {
    for_each_joint(core, body, [&](std::uint32_t joint, std::uint32_t) {
        Joint& j = core.joints[joint];
        give_color(core, j.color(), j.body_a, j.body_b);
        j.set_color(no_color);
    });
}

void assign_joint_colors(Core& core, std::uint32_t body) {
    for_each_joint(core, body, [&](std::uint32_t joint, std::uint32_t) {
        Joint& j = core.joints[joint];
        if (j.joint_type() != JointType::gear) j.set_color(take_color(core, j.body_a, j.body_b));
        core.awake_joints.assign(joint, is_joint_awake(core, j));
    });
}

namespace {

inline constexpr std::uint32_t checked_grain = 4;  // words of 64 joints that are worth a task

// 1/s, of the last substep
float substep_rate(const Core& core) { return is_positive(core.state->last_substep) ? 1.0f / core.state->last_substep : 0; }

bool breaks(const Joint& j, float inv_h) {
    if ((j.generation & 1u) == 0 || !j.can_break()) return false;
    return (j.flags & joint_torn) != 0 || bears_too_much(j, inv_h);
}

// Notes what a joint bore, and breaks it if that was too much.
ISLET_PART void finish_joint(Core& core, std::uint32_t i, float inv_h) {
    Joint& j = core.joints[i];
    note_load(core, j);
    if (!breaks(j, inv_h)) return;
    core.break_events[core.break_count++] = {core.joint_id(i),         j.body_a != null_index ? core.body_id(j.body_a) : BodyId{},
                                             core.body_id(j.body_b),   inv_h * j.force_impulse,
                                             inv_h * j.torque_impulse, j.user_data};
    remove_joint(core, i);
}

}  // namespace

bool breaks(const Core& core, const Joint& j) { return breaks(j, substep_rate(core)); }

void finish_joints(Core& core, Arena arena) {
    const float inv_h = substep_rate(core);
    const BitSet awake = core.awake_joints;
    if (!has_workers(core)) return awake.for_each([&](std::uint32_t i) { finish_joint(core, i, inv_h); });
    // Workers find the few joints for which there is something to do.
    const BitSet found{arena.take_last<std::uint64_t>(awake.word_count), awake.word_count};  // the beginning serves wake_island
    for_ranges(core, awake.word_count, checked_grain, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t w = first; w < end; ++w) found.words[w] = 0;
        awake.for_each_in(first, end, [&](std::uint32_t i) {
            if (load_has_changed(core, core.joints[i]) || breaks(core.joints[i], inv_h)) found.set(i);
        });
    });
    found.for_each([&](std::uint32_t i) { finish_joint(core, i, inv_h); });
}

}  // namespace islet::detail
