// A contact whose bodies hardly moved relative to each other since its manifold was made keeps it (the idea of contact recycling is Box2D 3.2's,
// which credits persistent manifolds as in PhysX). The test here asks how far the two surfaces have slipped at the contact points themselves.
//
// A kept manifold keeps its normal and its lever arms as they were in the world, and only its separations follow the bodies. That is more than an
// economy: over a few hundredths of a radian it leaves out the geometric stiffness of a loaded contact, which a Gauss-Seidel solver cannot balance
// in a few sweeps. With the exact geometry in each step a column of 30 boxes buckles within ten seconds (so it does in Box2D 3.2 without recycling).
#include "../exact.hpp"

#include "../world/contact_update.hpp"

#include "../broadphase/contacts.hpp"
#include "../broadphase/pairs.hpp"
#include "../broadphase/sensors.hpp"
#include "../collide/manifold.hpp"
#include "../math/boxes.hpp"
#include "../math/copies.hpp"
#include "../math/scalar.hpp"
#include "../memory/colors.hpp"
#include "../memory/parallel.hpp"
#include "../world/continuous.hpp"
#include "../world/hooks.hpp"
#include "../world/one_way.hpp"
#include "../world/seams.hpp"
#include "../world/sleep.hpp"

namespace islet::detail {

namespace {

inline constexpr float recycle_distance = 2.0f * linear_slop;  // m that the bodies may slip before a manifold is made anew
inline constexpr std::uint32_t update_grain = 4;                // words of 64 contacts that are worth a task
inline constexpr std::uint32_t clear_grain = 16;                // words of 64 bodies that are worth a task
inline constexpr float recycle_turn = 0.1f;                    // rad that a body may turn

// One of the two is not dynamic.
ISLET_SHARED bool has_floor(const Pose& a, const Pose& b) { return !(min(a.inv_mass, b.inv_mass) > 0); }

// Against what cannot be pushed, a fast body looks as far ahead as it may come in this step.
ISLET_SHARED bool looks_ahead(const Pose& a, const Pose& b) { return ((a.flags | b.flags) & pose_fast) != 0 && has_floor(a, b); }

bool can_recycle(const ContactManifold& m, const Pose& a, const Pose& b) {
    if ((m.flags & contact_posed) == 0) return false;
    const Rot turn_a = inv_mul(m.rotation_a, a.q);
    const Rot turn_b = inv_mul(m.rotation_b, b.q);
    if (min(turn_a.c, turn_b.c) < 0 || max(abs(turn_a.s), abs(turn_b.s)) > recycle_turn) return false;
    const std::uint32_t count = m.count();
    if (count == 0) {
        // Nothing touches yet: bound the relative motion of any two points, and stay well within the speculative margin.
        const Vec2 shift = b.center - a.center - m.offset;
        const float reach = 0.5f * speculative_distance - a.max_extent * abs(turn_a.s) - b.max_extent * abs(turn_b.s);
        return reach > 0 && length_squared(shift) < reach * reach;
    }
    // Besides the points of the manifold others may come near as one body turns against the other, by at most the smaller one's size times the turn.
    // They were apart by more than the speculative distance.
    const float turn = abs(turn_b.s * turn_a.c - turn_b.c * turn_a.s);
    const float reach = recycle_distance - 2.0f * min(a.max_extent, b.max_extent) * turn;
    if (reach <= 0) return false;
    for (std::uint32_t i = 0; i < count; ++i)
        if (length_squared(slip_of(m, i, a, b)) > reach * reach) return false;
    return true;
}

// The narrow phase function for the two types; A has the higher rank (see contacts.cpp).
Manifold dispatch(const Geometry& a, const Geometry& b, const Transform& b_in_a, float margin) {
    const auto type_b = b.shape_type();
    const auto against = [&](const auto& shape_a) {
        switch (type_b) {
            case ShapeType::circle: return collide(shape_a, b.circle, b_in_a, margin);
            case ShapeType::capsule: return collide(shape_a, b.capsule, b_in_a, margin);
            case ShapeType::polygon: return collide(shape_a, b.polygon, b_in_a, margin);
            default: return Manifold{};
        }
    };
    switch (a.shape_type()) {
        case ShapeType::circle: return collide(a.circle, b.circle, b_in_a, margin);
        case ShapeType::capsule: return against(a.capsule);
        case ShapeType::segment: return against(Capsule{a.segment.point1, a.segment.point2, 0});
        case ShapeType::polygon: return against(a.polygon);
        case ShapeType::chain_segment: return against(a.chain);
    }
    return {};
}

// Of what a fast body is about to hit in this step the manifold is made as the two will stand when they meet, whatever way that is off: from there to
// where they are now is but a slip. (A plane through what is nearest now would throw back what is about to pass.)
Stand stand_of(const Core& core, const ContactManifold& m, std::uint32_t shape_a, std::uint32_t shape_b, bool ahead, float dt) {
    if (has_continuous && ahead) {
        const Sweep a = sweep_ahead(core, m.body_a, dt), b = sweep_ahead(core, m.body_b, dt);
        const float t = time_to_touch(core, shape_a, a, shape_b, b);
        if (t > 0 && t < 1) return {center_at(b, t) - center_at(a, t), rotation_at(a, t), rotation_at(b, t)};
    }
    return stand_now(core, m.body_a, m.body_b);
}

// A new manifold that keeps the impulses of points whose features it shares with the old one.
ISLET_SHARED void remake(Core& core, std::uint32_t index, bool ahead, float dt) {
    const Contact& c = core.contacts[index];
    ContactManifold& m = core.manifolds[index];
    const Stand stand = stand_of(core, m, c.shape_a, c.shape_b, ahead, dt);
    const Vec2 center_a = core.bodies[m.body_a].local_center;
    const Transform b_in_a = pose_between(core, m.body_a, m.body_b, stand);
    Manifold fresh = dispatch(core.geometries[core.shapes[c.shape_a].geometry], core.geometries[core.shapes[c.shape_b].geometry], b_in_a,
                              speculative_distance);
    if (fresh.count > 0 && has_floor(core.poses[m.body_a], core.poses[m.body_b])) mend_inner_edges(core, c, b_in_a, fresh);

    const ContactManifold old = m;
    m.normal = rotate(stand.a, fresh.normal);
    m.offset = stand.offset;
    m.rotation_a = stand.a;
    m.rotation_b = stand.b;
    m.ids = 0;
    if (fresh.count == 0) m.rolling_impulse = 0;
    for (std::uint32_t i = 0; i < 2; ++i) {
        m.anchors[i] = {0, 0};
        m.separation[i] = m.normal_impulse[i] = m.tangent_impulse[i] = 0;
        if (i >= fresh.count) continue;
        const ManifoldPoint& point = fresh.points[i];
        m.anchors[i] = rotate(stand.a, point.point - center_a);
        m.separation[i] = point.separation;
        m.ids |= static_cast<std::uint32_t>(point.id) << (16 * i);
        for (std::uint32_t j = 0; j < old.count(); ++j) {
            if ((old.ids >> (16 * j) & 0xffffu) != point.id) continue;
            m.normal_impulse[i] = old.normal_impulse[j];
            m.tangent_impulse[i] = old.tangent_impulse[j];
        }
    }
    m.flags = (m.flags & ~(3u << contact_count_shift)) | fresh.count << contact_count_shift | contact_posed;
}

// The fat boxes no longer overlap, and neither body is about to hit the other, which is static (see find_pairs).
bool has_parted(const Core& core, std::uint32_t index, float dt) {
    const Contact& c = core.contacts[index];
    const ContactManifold& m = core.manifolds[index];
    Aabb a = core.boxes[c.shape_a], b = core.boxes[c.shape_b];
    if (meet(a, b)) return false;
    const bool fast_a = (core.poses[m.body_a].flags & pose_fast) != 0 && core.bodies[m.body_b].type() == BodyType::static_body;
    const bool fast_b = (core.poses[m.body_b].flags & pose_fast) != 0 && core.bodies[m.body_a].type() == BodyType::static_body;
    if (!fast_a && !fast_b) return true;
    if (fast_a) {
        a = box_ahead(core, c.shape_a, dt);
    } else {
        b = box_ahead(core, c.shape_b, dt);
    }
    return !meet(a, b);
}

enum class Change : std::uint8_t { none, changes, parts };

// Works on one contact alone, so contacts may be updated in any order or in parallel; what changes shared state is only reported.
Change update(Core& core, std::uint32_t index, float dt, std::uint32_t& recycled) {
    ContactManifold& m = core.manifolds[index];
    const Pose& a = core.poses[m.body_a];
    const Pose& b = core.poses[m.body_b];
    if (((a.flags | b.flags) & pose_moved) != 0) {
        if (has_parted(core, index, dt)) return Change::parts;
    }
    if (has_sensors && (m.flags & contact_sensor) != 0)
        return overlaps_sensor(core, index) == ((m.flags & contact_overlap) != 0) ? Change::none : Change::changes;
    const bool ahead = looks_ahead(a, b);
    const bool one_way = has_one_way && (m.flags & contact_one_way) != 0;
    if (one_way && !decide_one_way(core, index, m.flags, dt)) {
        m.forget_points();
        m.forget_impulses();
    } else if (!ahead && can_recycle(m, a, b)) {
        ++recycled;
    } else {
        remake(core, index, ahead, dt);
        if (one_way) mend_one_way(core, index);
    }
    const bool is = m.count() > 0;
    if (has_hooks && (m.flags & contact_asks) != 0 && is) return Change::changes;  // maybe: what the hook will say is not known yet
    return is == ((m.flags & contact_touching) != 0) ? Change::none : Change::changes;
}

void begin_touch(Core& core, std::uint32_t index, BitSet to_wake) {
    ContactManifold& m = core.manifolds[index];
    const Contact& c = core.contacts[index];
    m.flags |= contact_touching;
    assign_color(core, index);
    push_touch(core, core.begin_events, core.begin_count, core.sensor_begins, {core.shape_id(c.shape_a), core.shape_id(c.shape_b)});
    if (core.is_dynamic(m.body_a) && !core.is_awake(m.body_a)) to_wake.set(m.body_a);
    if (core.is_dynamic(m.body_b) && !core.is_awake(m.body_b)) to_wake.set(m.body_b);
}

void end_touch(Core& core, std::uint32_t index) {
    core.manifolds[index].flags &= ~static_cast<std::uint32_t>(contact_touching);
    release_color(core, index);
    record_end_event(core, index);
}

// What a contact has become changes shared state.
void commit(Core& core, std::uint32_t index, BitSet to_wake) {
    const ContactManifold& m = core.manifolds[index];
    if (has_sensors && (m.flags & contact_sensor) != 0) return (m.flags & contact_overlap) != 0 ? end_overlap(core, index) : begin_overlap(core, index);
    // What the hook made of it holds for one step, even if there is no hook any more.
    if (has_hooks && (m.flags & contact_asks) != 0 && m.count() > 0) {
        mix_materials(core, index);
        if (core.hooks.pre_solve != nullptr) ask_pre_solve(core, index);
    }
    const bool was = (m.flags & contact_touching) != 0;
    if (was == (m.count() > 0)) return;
    if (was) {
        end_touch(core, index);
    } else {
        begin_touch(core, index, to_wake);
    }
}

}  // namespace

void update_contacts(Core& core, float dt) {
    Arena arena = core.arena();
    const auto take_bits = [&](std::uint32_t bits) {
        const auto words = static_cast<std::uint32_t>(words_for(bits));
        BitSet set{arena.take<std::uint64_t>(words), words};
        set.clear_all();
        return set;
    };
    const BitSet changed = take_bits(core.capacity.contacts);
    const BitSet parted = take_bits(core.capacity.contacts);
    const BitSet to_wake = take_bits(core.capacity.bodies);

    // Word by word of the set of awake contacts, each range with its own count.
    const std::uint32_t words = core.awake_contacts.word_count;
    std::uint32_t* recycled = arena.take<std::uint32_t>(range_count(words, update_grain));
    core.report.recycled_contacts = 0;
    std::memset(recycled, 0, std::size_t{range_count(words, update_grain)} * 4);
    for_ranges(core, words, update_grain, [&](std::uint32_t first, std::uint32_t end) {
        std::uint32_t kept = 0;
        core.awake_contacts.for_each_in(first, end, [&](std::uint32_t i) {
            const Change change = update(core, i, dt, kept);
            if (change == Change::none) return;
            changed.set(i);
            if (change == Change::parts) parted.set(i);
        });
        recycled[first / update_grain] = kept;
    });
    for (std::uint32_t i = 0; i < range_count(words, update_grain); ++i) core.report.recycled_contacts += recycled[i];

    // What changes shared state, in index order.
    changed.for_each([&](std::uint32_t i) {
        if (parted.test(i)) {
            destroy_contact(core, i);
        } else {
            commit(core, i, to_wake);
        }
    });
    for_ranges(core, core.awake_bodies.word_count, clear_grain, [&](std::uint32_t first, std::uint32_t end) {
        core.awake_bodies.for_each_in(first, end,
                                      [&](std::uint32_t body) { core.poses[body].flags &= ~static_cast<std::uint32_t>(pose_moved); });
    });
    to_wake.for_each([&](std::uint32_t body) { wake_island(core, body, arena); });
}

}  // namespace islet::detail
