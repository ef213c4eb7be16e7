// Every invariant of a world, checked one by one. For tests: slow and thorough.
#include "broadphase/contacts.hpp"
#include "broadphase/tree.hpp"
#include "world/bounds.hpp"
#include "memory/joint_graph.hpp"
#include "world/checks.hpp"
#include "world/joints.hpp"

namespace islet {

using namespace detail;

namespace {

template <class T>
const char* validate_pool(const PoolState& pool, const T* slots, std::uint32_t capacity) {
    if (pool.high_water > capacity || pool.count > pool.high_water) return "a pool holds more than its capacity";
    std::uint32_t live = 0;
    for (std::uint32_t i = 0; i < pool.high_water; ++i) live += slots[i].generation & 1u;
    if (live != pool.count) return "a pool miscounts its live slots";
    std::uint32_t free = 0;
    for (std::uint32_t i = pool.free_head; i != null_index; i = slots[i].next_free) {
        if (i >= pool.high_water || (slots[i].generation & 1u) != 0) return "a free list holds a live slot";
        if (++free > pool.high_water) return "a free list has a cycle";
    }
    return live + free == pool.high_water ? nullptr : "a pool lost a slot";
}

const char* validate_body(const Core& c, std::uint32_t i) {
    const Body& b = c.bodies[i];
    const Pose& pose = c.poses[i];
    const Motion& motion = c.motions[i];
    if (!is_finite(pose.center) || !is_finite(pose.q.c) || !is_finite(pose.q.s) || !is_finite(motion.v) || !is_finite(motion.w))
        return "a body's state is not finite";
    if (abs(pose.q.c * pose.q.c + pose.q.s * pose.q.s - 1.0f) > 1.0e-4f) return "a rotation is not of unit length";
    const bool awake = c.is_awake(i);
    if (awake && b.type() == BodyType::static_body) return "a static body is awake";
    if (b.type() != BodyType::dynamic && (pose.inv_mass != 0 || b.colors != 0)) return "a body that cannot be pushed has a mass or a colour";

    std::uint32_t shapes = 0;
    std::uint32_t prev = null_index;
    for (std::uint32_t s = b.shape_head; s != null_index; s = c.shapes[s].next, ++shapes) {
        if (!pool_live(c.state->shape_pool, c.shapes, s) || c.shapes[s].body != i || c.shapes[s].prev != prev || shapes > b.shape_count)
            return "a body's list of shapes is broken";
        if ((c.shapes[s].tree_node != null_index) == awake) return "a shape is in the wrong half of the broad phase";
        if (!awake && c.tree[c.shapes[s].tree_node].child2 != s) return "a tree leaf does not know its shape";
        if (!awake && c.tree[c.shapes[s].tree_node].box != c.boxes[s]) return "a tree leaf has another box than its shape";
        if (!contains(expand(c.boxes[s], 1.0e-3f * (1.0f + abs(pose.center.x) + abs(pose.center.y)) * 0.01f + 1.0e-4f), shape_aabb(c, s)))
            return "a shape has left its fat box";
        prev = s;
    }
    if (shapes != b.shape_count) return "a body miscounts its shapes";

    std::uint32_t contacts = 0;
    std::uint32_t colors = 0;
    std::uint32_t prev_key = 0;
    for (std::uint32_t key = b.contact_head; key != 0; ++contacts) {
        const std::uint32_t contact = edge_of_key(key);
        const std::uint32_t side = side_of_key(key);
        if (!pool_live(c.state->contact_pool, c.contacts, contact) || contacts > b.contact_count) return "a body's list of contacts is broken";
        const ContactManifold& m = c.manifolds[contact];
        if ((side == 0 ? m.body_a : m.body_b) != i || c.contacts[contact].prev[side] != prev_key) return "a contact is in the wrong list";
        if (m.color() != no_color && b.type() == BodyType::dynamic) {
            if ((colors >> m.color() & 1u) != 0) return "two constraints of a body share a colour";
            colors |= 1u << m.color();
        }
        prev_key = key;
        key = c.contacts[contact].next[side];
    }
    if (contacts != b.contact_count) return "a body miscounts its contacts";

    std::uint32_t joints = 0;
    prev_key = 0;
    for (std::uint32_t key = b.joint_head; key != 0; ++joints) {
        const std::uint32_t joint = edge_of_key(key);
        const std::uint32_t side = side_of_key(key);
        if (!pool_live(c.state->joint_pool, c.joints, joint) || joints > b.joint_count) return "a body's list of joints is broken";
        const Joint& j = c.joints[joint];
        if ((side == 0 ? j.body_a : j.body_b) != i || j.prev[side] != prev_key) return "a joint is in the wrong list";
        if (j.color() != no_color && b.type() == BodyType::dynamic) {
            if ((colors >> j.color() & 1u) != 0) return "two constraints of a body share a colour";
            colors |= 1u << j.color();
        }
        prev_key = key;
        key = j.next[side];
    }
    if (joints != b.joint_count) return "a body miscounts its joints";
    if (colors != b.colors) return "a body's colours are not those of its constraints";
    return nullptr;
}

const char* validate_contact(const Core& c, std::uint32_t i) {
    const Contact& contact = c.contacts[i];
    const ContactManifold& m = c.manifolds[i];
    if (c.shapes[contact.shape_a].body != m.body_a || c.shapes[contact.shape_b].body != m.body_b) return "a contact's bodies are not its shapes'";
    if (!c.pairs.contains(PairSet::key(contact.shape_a, contact.shape_b))) return "a contact is missing from the pair set";
    if (c.awake_contacts.test(i) != (c.is_awake(m.body_a) || c.is_awake(m.body_b))) return "a contact is awake though its bodies sleep, or the reverse";
    const bool touching = (m.flags & contact_touching) != 0;
    if (touching && m.count() == 0) return "a touching contact has no points";
    if (!touching && m.color() != no_color) return "a contact that does not touch has a colour";
    if (touching && c.is_dynamic(m.body_a) && c.is_dynamic(m.body_b) && c.is_awake(m.body_a) != c.is_awake(m.body_b))
        return "an island is half asleep";
    return nullptr;
}

const char* validate_joint(const Core& c, std::uint32_t i) {
    const Joint& j = c.joints[i];
    const auto live = [&](std::uint32_t body) { return pool_live(c.state->body_pool, c.bodies, body); };
    const auto type = j.joint_type();
    if (!live(j.body_b) || (type == JointType::mouse ? j.body_a != null_index : !live(j.body_a))) return "a joint's body is gone";
    const bool awake_a = j.body_a != null_index && c.is_awake(j.body_a), awake_b = c.is_awake(j.body_b);
    if (c.awake_joints.test(i) != (awake_a || awake_b)) return "a joint is awake though its bodies sleep, or the reverse";
    if (j.body_a != null_index && c.is_dynamic(j.body_a) && c.is_dynamic(j.body_b) && awake_a != awake_b) return "an island is half asleep";
    if (type == JointType::gear) {
        for (const std::uint32_t joint : {j.joint1, j.joint2}) {
            if (!pool_live(c.state->joint_pool, c.joints, joint)) return "a gear's joint is gone";
            const Joint& geared = c.joints[joint];
            if (geared.gear_count == 0) return "a joint does not know its gear";
        }
        const Joint& j1 = c.joints[j.joint1];
        const Joint& j2 = c.joints[j.joint2];
        if (j.body_a == j.body_b || j.body_a != moving_body(c, j1) || (j.body_b != j2.body_a && j.body_b != j2.body_b))
            return "a gear hangs on the wrong bodies";
    }
    const float numbers[] = {j.impulse.x, j.impulse.y, j.angular_impulse, j.spring_impulse, j.motor_impulse, j.friction_impulse, j.lower_impulse,
                             j.upper_impulse, j.coordinate};
    for (const float a : numbers)
        if (!is_finite(a)) return "a joint's impulse is not finite";
    return nullptr;
}

}  // namespace

const char* World::validate() const {
    const Core& c = core();
    const State& s = *c.state;
    const char* bad = validate_pool(s.body_pool, c.bodies, c.capacity.bodies);
    if (bad == nullptr) bad = validate_pool(s.shape_pool, c.shapes, c.capacity.shapes);
    if (bad == nullptr) bad = validate_pool(s.contact_pool, c.contacts, c.capacity.contacts);
    if (bad == nullptr) bad = validate_pool(s.joint_pool, c.joints, c.capacity.joints);
    if (bad == nullptr) bad = tree_validate({&c.state->tree, c.tree});
    if (bad == nullptr && c.moved_shapes.count() != s.moved_count) bad = "the shapes that moved are miscounted";
    for (std::uint32_t i = 0; bad == nullptr && i < s.body_pool.high_water; ++i)
        if (pool_live(s.body_pool, c.bodies, i)) bad = validate_body(c, i);
    std::uint32_t references = 0;
    for (std::uint32_t i = 0; bad == nullptr && i < s.geometry_pool.high_water; ++i) references += c.geometries[i].references;
    if (bad == nullptr && references != s.shape_pool.count) bad = "geometries are not referenced once per shape";
    for (std::uint32_t i = 0; bad == nullptr && i < s.contact_pool.high_water; ++i)
        if (pool_live(s.contact_pool, c.contacts, i)) bad = validate_contact(c, i);
    std::uint32_t awake_joints = 0, gears = 0, gear_ends = 0;
    for (std::uint32_t i = 0; bad == nullptr && i < s.joint_pool.high_water; ++i) {
        if (!pool_live(s.joint_pool, c.joints, i)) continue;
        bad = validate_joint(c, i);
        awake_joints += c.awake_joints.test(i) ? 1 : 0;
        gears += c.joints[i].joint_type() == JointType::gear ? 1 : 0;
        gear_ends += c.joints[i].gear_count;
    }
    if (bad == nullptr && gear_ends != 2 * gears) bad = "joints miscount their gears";
    if (bad == nullptr && awake_joints != c.awake_joints.count()) bad = "a destroyed joint is awake";
    std::uint32_t pairs = 0;
    for (std::uint32_t i = 0; bad == nullptr && i <= c.pairs.mask; ++i) pairs += c.pairs.keys[i] != 0 ? 1 : 0;
    if (bad == nullptr && pairs != s.contact_pool.count) bad = "the pair set does not hold one key per contact";
    return bad;
}

}  // namespace islet
