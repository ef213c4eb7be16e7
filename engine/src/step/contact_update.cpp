// If two bodies have hardly moved relative to each other since their contact's manifold was made, the contact keeps the manifold. (The idea of recycling
// contacts is that of Box2D 3.2, which credits the persistent manifolds of PhysX.) The measure here is how far the two surfaces have slipped at the contact
// points.
//
// A kept manifold keeps its normal and lever arms in the world; only its separations follow the bodies. This does more than save time. Over a few hundredths of
// a radian it leaves out the geometric stiffness of a loaded contact, which a Gauss-Seidel solver cannot balance in a few sweeps. With the exact geometry in
// each step, a column of 30 boxes buckles within ten seconds, as it does in Box2D 3.2 without recycling. The faces of moving bodies also keep their manifold
// while a load presses them into each other, because separations follow that motion exactly. Made anew for it, a column of 100 boxes takes up its own lean
// again and again as it settles, and falls.
//
// But a normal that lags behind bodies which turn together holds them like a spring between them and the world: cargo would brake its swing, and no box would
// slide off a board before that has tilted by 0.1 rad. So where both bodies turn faster than a column leans, the manifold turns with them.
#include "../exact.hpp"

#include "../step/contact_update.hpp"

#include "../bodies/sleep.hpp"
#include "../broadphase/pairs.hpp"
#include "../data/parallel.hpp"
#include "../graph/colors.hpp"
#include "../graph/contacts.hpp"
#include "../graph/hooks.hpp"
#include "../graph/sensors.hpp"
#include "../math/boxes.hpp"
#include "../math/inlining.hpp"
#include "../math/scalar.hpp"
#include "../shapes/manifolds.hpp"
#include "../shapes/shape_types.hpp"
#include "../step/continuous.hpp"
#include "../step/inner_edges.hpp"
#include "../step/one_way.hpp"

namespace islet::detail {

namespace {

inline constexpr float recycle_distance = 2.0f * linear_slop;  // m that the surfaces may slip before a manifold is made anew
inline constexpr std::uint32_t update_grain = 4;               // words of 64 contacts that are worth a task
inline constexpr std::uint32_t clear_grain = 16;               // words of 64 bodies that are worth a task
inline constexpr float load_rate = 0.07f;                      // 1/s, at which the load of a contact follows the force that it bears
inline constexpr float most_load = 1.0e28f;                    // N
inline constexpr float worth_learning = 0.4f * linear_slop;    // m; a contact that would rise by less learns its load slowly
inline constexpr float learning_tilt = 0.01f;                  // sine of the angle between gravity and the normal of a face that learns, at most
inline constexpr float learning_friction = 0.5f;               // its friction, as a share of its load, at most
inline constexpr float recycle_turn = 0.1f;                    // rad that a body may turn before a manifold is made anew
inline constexpr float least_lag = 0.001f;                     // rad that a manifold may lag behind two bodies that turn
inline constexpr float turn_rate = 0.015f;                     // rad/s of bodies with which a manifold turns: at a body that is not dynamic
inline constexpr float level_turn_rate = 0.05f;                // of two bodies that meet with a level face; card houses fall if it is less
inline constexpr float wedged_turn_rate = 0.15f;               // of all others; arches, whose stones press against each other, fold if it is less
inline constexpr float turn_alike = 0.1f;                      // share of their rates by which two bodies on a level face may differ
inline constexpr float level_face = 0.3f;                      // tangent of the angle between gravity and the normal of a level face, at most

// How the load of a contact follows the force that it bore in the last step. It is slow: a pile moves as if its contacts did not know their load. But when an
// island has come to rest (pose_learns), level faces, as those of columns and walls, learn their load at once. So a stack rises by most of what it has sunk by
// before it falls asleep. (Ten boxes then lie 0.01 m too low instead of 0.03, thirty 0.07 m instead of 0.29, and a brick wall of 20 rows 0.025 m. If tilted
// faces and corners learn too, a pile of 500 boxes slides into another one, and sleeps seconds later. Loads that are followed quickly in every step pump up the
// sway of a wall of 30 rows to 0.8 m/s, even if that is done in quiet islands only.)
struct LoadFollower {
    float keep = 1;   // share of the old load
    float gain = 0;   // 1/s, of the impulses of the last substep
    float force = 0;  // 1/s, what the impulses of the last substep come to
    float give = 0;   // s^2, by which a contact gives way: 1 / omega^2
    Vec2 gravity;     // m/s^2

    LoadFollower(const State& state, float dt) : gravity(state.gravity) {
        if (!(state.last_substep > 0)) return;
        const float share = min(load_rate * dt, 1.0f);
        keep = 1 - share;
        gain = share / state.last_substep;
        force = 1.0f / state.last_substep;
        const float omega = 2.0f * pi * min(state.solver.contact_hertz, 0.125f * static_cast<float>(state.solver.substeps) / dt);
        give = 1.0f / (omega * omega);
    }
    void follow(ContactManifold& m) const {
        if ((m.flags & contact_special) != 0 || m.count() == 0) return;
        const float load = keep * m.load + gain * (m.normal_impulse[0] + m.normal_impulse[1]);
        m.load = load >= 0 && load < most_load ? load : 0;
    }
    // `inv_mass` (1/kg) is that of both bodies together.
    void learn(ContactManifold& m, float inv_mass) const {
        const float impulse = m.normal_impulse[0] + m.normal_impulse[1];
        if ((m.flags & contact_special) != 0 || m.count() != 2) return;
        if (!(abs(cross(m.normal, gravity)) < learning_tilt * abs(dot(m.normal, gravity)))) return;
        if (abs(m.tangent_impulse[0] + m.tangent_impulse[1]) > learning_friction * impulse) return;
        const float load = force * impulse;
        if (load < most_load && give * inv_mass * abs(load - m.load) > worth_learning) m.load = load;
    }
};

// True if one of the two bodies is not dynamic.
ISLET_SHARED bool has_floor(const Pose& a, const Pose& b) { return !(min(a.inv_mass, b.inv_mass) > 0); }

bool comes_fast(const Approach& approach) { return approach.most() > 2.0f * fast_way; }

// True if the surfaces have slipped little at the points of a contact that has `count` of them, 1 or 2.
ISLET_PART bool has_kept_points(const ContactManifold& m, const Pose& a, const Pose& b, std::uint32_t count, Rot turn_a, Rot turn_b) {
    // As one body turns against the other, points that are not in the manifold may come near, by at most the smaller body's size times the turn. They were
    // apart by more than the speculative distance.
    const float turn = abs(turn_b.s * turn_a.c - turn_b.c * turn_a.s);
    const float size = min(a.max_extent, b.max_extent);
    const float reach = recycle_distance - 2.0f * size * turn;
    if (reach <= 0) return false;
    // Faces of moving bodies that are pressed into each other do not slip: separations follow. (slip_of, with what both points share worked out once.)
    const Vec2 shift = b.center - a.center - rotate(turn_b, m.offset);
    const Rot apart = {turn_b.c - turn_a.c, turn_b.s - turn_a.s};
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec2 slip = shift + rotate(apart, m.anchors[i]);
        if (length_squared(slip) <= reach * reach) continue;
        const float sunk = clamp(dot(slip, m.normal), -0.5f * size, 0.0f);
        if (count != 2 || has_floor(a, b) || length_squared(slip) - sunk * sunk > reach * reach) return false;
    }
    return true;
}

// True if neither body has turned far since the manifold was made.
ISLET_PART bool have_turned_little(Rot turn_a, Rot turn_b) { return !(min(turn_a.c, turn_b.c) < 0 || max(abs(turn_a.s), abs(turn_b.s)) > recycle_turn); }

// Turns the manifold, with all that it holds of how the bodies stood, as far as the bodies have turned together. (It then lags by half a step in the mean.
// Turned ahead by that much, it would keep the spin of two bodies that are pressed together; but pressed hard, they would gain spin.)
ISLET_SHARED void turn_along(const Core& core, ContactManifold& m, const Pose& a, const Pose& b) {
    const Rot turn = inv_mul(m.rotation_a, a.q);
    if (abs(turn.s) <= least_lag) return;
    const float wa = core.motions[m.body_a].w, wb = core.motions[m.body_b].w, slower = min(abs(wa), abs(wb));
    const Vec2 gravity = core.state->gravity;
    const bool level = m.count() == 2 && abs(cross(m.normal, gravity)) <= level_face * abs(dot(m.normal, gravity));
    const float least = has_floor(a, b) ? turn_rate : level && abs(wa - wb) < turn_alike * slower ? level_turn_rate : wedged_turn_rate;
    if (!(wa * wb > 0) || !(slower > least)) return;
    m.normal = rotate(turn, m.normal);
    m.normal = (1.5f - 0.5f * length_squared(m.normal)) * m.normal;  // a unit vector, however often it is turned
    m.offset = rotate(turn, m.offset);
    for (Vec2& anchor : m.anchors) anchor = rotate(turn, anchor);
    m.rotation_a = a.q;
    m.rotation_b = normalize(turn * m.rotation_b);
}

bool can_recycle(const ContactManifold& m, const Pose& a, const Pose& b) {
    if ((m.flags & (contact_posed | contact_ahead)) != contact_posed) return false;
    const Rot turn_a = inv_mul(m.rotation_a, a.q);
    const Rot turn_b = inv_mul(m.rotation_b, b.q);
    if (!have_turned_little(turn_a, turn_b)) return false;
    const std::uint32_t count = m.count();
    if (count == 0) {
        // Nothing touches yet. The bound of the relative motion of any two points must stay well within the speculative distance.
        const Vec2 shift = b.center - a.center - m.offset;
        const float reach = 0.5f * speculative_distance - a.max_extent * abs(turn_a.s) - b.max_extent * abs(turn_b.s);
        return reach > 0 && length_squared(shift) < reach * reach;
    }
    return has_kept_points(m, a, b, count, turn_a, turn_b);
}

// True if the contact touches as before, and all that an update does is to keep its manifold. Of most contacts of a pile two tests tell that. (False says
// nothing.)
ISLET_PART bool is_settled(const ContactManifold& m, const Pose& a, const Pose& b) {
    constexpr std::uint32_t asked = contact_touching | contact_posed | contact_sensor | contact_asks | contact_one_way | contact_ahead | contact_untold;
    if ((m.flags & asked) != (contact_touching | contact_posed) || ((a.flags | b.flags) & (pose_moved | pose_fast | pose_learns)) != 0) return false;
    const std::uint32_t count = m.count();
    if (count == 0) return false;
    const Rot turn_a = inv_mul(m.rotation_a, a.q), turn_b = inv_mul(m.rotation_b, b.q);
    return abs(turn_a.s) <= least_lag && have_turned_little(turn_a, turn_b) && has_kept_points(m, a, b, count, turn_a, turn_b);
}

// How the bodies of a contact come together in this step. Two bodies that fall together do not look ahead for each other: each goes at least a quarter of the
// way by which they come together, and neither comes through half of the other. What falls together and lands exactly piles up to towers, which topple later.
ISLET_SHARED Approach approach_to(const Core& core, const ContactManifold& m, float dt, float fall) {
    const Pose& a = core.poses[m.body_a];
    const Pose& b = core.poses[m.body_b];
    const Vec2 va = core.motions[m.body_a].v, vb = core.motions[m.body_b].v;
    const Approach approach = approach_of(a, b, core.motions[m.body_a], core.motions[m.body_b], dt, fall);
    if ((a.flags & b.flags & pose_fast) == 0 || has_floor(a, b)) return approach;
    const float way = approach.most(), slower = min(length_squared(va), length_squared(vb));
    const bool together = way * way < 16 * dt * dt * slower && way <= min(core.bodies[m.body_a].min_extent, core.bodies[m.body_b].min_extent);
    return together ? Approach{} : approach;
}

// Calls the narrow-phase function for the types of the two shapes. A has the higher rank, and one of the two is solid. No world holds types that are left out.
Manifold dispatch(const Geometry& a, const Geometry& b, const Transform& b_in_a, float margin) {
    return with_shape(a, [&](const auto& shape_a) {
        return with_shape(b, [&](const auto& shape_b) -> Manifold {
            using A = RowOf<decltype(shape_a)>;
            using B = RowOf<decltype(shape_b)>;
            if constexpr (A::is_there && B::is_there && B::rank <= A::rank && B::kind == ShapeKind::solid) return collide(shape_a, shape_b, b_in_a, margin);
            ISLET_UNREACHABLE();
        });
    });
}

// Makes the manifold of two shapes as they stand, without points farther apart than `margin`.
Manifold manifold_at(const Core& core, const Contact& c, const ContactManifold& m, const Stand& stand, float margin, Transform& b_in_a) {
    b_in_a = pose_between(core, m.body_a, m.body_b, stand);
    return dispatch(core.geometries[core.shapes[c.shape_a].geometry], core.geometries[core.shapes[c.shape_b].geometry], b_in_a, margin);
}

// Makes the manifold with which two shapes will touch in this step. If they are about to meet, it is made as they will stand at the time of impact; the motion
// until then is treated as slip. (A plane through the points that are nearest now would throw back a shape that is about to pass.) After the first point has
// met, another one comes down up to twice as fast, as the body turns about the first.
Manifold manifold_ahead(const Core& core, const Contact& c, const ContactManifold& m, const Approach& approach, float dt, Stand& stand, float& margin,
                        Transform& b_in_a) {
    const float most = min(approach.most(), max_speed_limit);  // m: a step lasts at most a second, and no body moves faster, whatever velocity it was given
    margin = speculative_distance + 2.0f * most;
    const Manifold now = manifold_at(core, c, m, stand, margin, b_in_a);
    // Where the body is now, a chain segment may leave the contact to its neighbour although the body will come to that segment.
    const bool is_link = kind_of(core.geometries[core.shapes[c.shape_a].geometry]) == ShapeKind::front;
    if (now.count == 0 && !is_link) return now;
    if (now.count != 0) {
        const float apart = least_separation(now);
        if (apart <= speculative_distance) return now;
        if (!is_link && apart + dot(rotate(stand.a, now.normal), approach.way) > approach.turn) return {};
    }
    const bool held = !has_floor(core.poses[m.body_a], core.poses[m.body_b]);
    const BodyPath a = path_ahead(core, m.body_a, dt, held), b = path_ahead(core, m.body_b, dt, held);
    const float t = time_to_touch(core, c.shape_a, a, c.shape_b, b);
    if (!(t > 0 && t < 1)) return {};
    stand = {center_at(b, t) - center_at(a, t), rotation_at(a, t), rotation_at(b, t)};
    margin = speculative_distance + 2.0f * (1.0f - t) * most;
    return manifold_at(core, c, m, stand, margin, b_in_a);
}

// Makes the manifold anew. Points whose features the old manifold had keep their impulses.
ISLET_SHARED void remake(Core& core, std::uint32_t index, const Approach& approach, float dt) {
    const Contact& c = core.contacts[index];
    ContactManifold& m = core.manifolds[index];
    Stand stand = stand_now(core, m.body_a, m.body_b);
    const Vec2 center_a = core.bodies[m.body_a].local_center;
    Transform b_in_a;
    float margin = speculative_distance;
    Manifold fresh = is_continuous(core) && comes_fast(approach) ? manifold_ahead(core, c, m, approach, dt, stand, margin, b_in_a)
                                                                 : manifold_at(core, c, m, stand, margin, b_in_a);
    const bool has_pieces = (core.bodies[m.body_a].shape_count | core.bodies[m.body_b].shape_count) > 1;
    if (fresh.count > 0 && (has_pieces || has_floor(core.poses[m.body_a], core.poses[m.body_b]))) mend_inner_edges(core, c, b_in_a, margin, fresh);

    m.normal = rotate(stand.a, fresh.normal);
    const bool lands = fresh.count > 0 && approach.turn - dot(m.normal, approach.way) > 2.0f * speculative_distance;
    m.offset = stand.offset;
    m.rotation_a = stand.a;
    m.rotation_b = stand.b;
    if (fresh.count == 0) m.rolling_impulse = 0;
    const std::uint32_t known = (m.flags & contact_ahead) == 0 ? m.count() : 0;  // the impulses of a blow are no warm start
    std::uint32_t ids = 0;
    float normal_impulse[2] = {0, 0}, tangent_impulse[2] = {0, 0};
    for (std::uint32_t i = 0; i < 2; ++i) {
        m.anchors[i] = {0, 0};
        m.separation[i] = 0;
        if (i >= fresh.count) continue;
        const ManifoldPoint& point = fresh.points[i];
        m.anchors[i] = rotate(stand.a, point.point - center_a);
        m.separation[i] = point.separation;
        ids |= static_cast<std::uint32_t>(point.id) << (16 * i);
        for (std::uint32_t j = 0; j < known; ++j) {
            if ((m.ids >> (16 * j) & 0xffffu) != point.id) continue;
            normal_impulse[i] = m.normal_impulse[j];
            tangent_impulse[i] = m.tangent_impulse[j];
        }
    }
    m.ids = ids;
    for (std::uint32_t i = 0; i < 2; ++i) {
        m.normal_impulse[i] = normal_impulse[i];
        m.tangent_impulse[i] = tangent_impulse[i];
    }
    m.flags = (m.flags & ~(3u << contact_count_shift | contact_ahead)) | fresh.count << contact_count_shift | contact_posed |
              (lands ? std::uint32_t{contact_ahead} : 0u);
}

// True if a body has sunk into a floor by a quarter of its half-thickness. Its way is then followed like a fast body's, even if it creeps.
ISLET_SHARED bool is_deep(const Core& core, const ContactManifold& m) {
    constexpr float share = 0.25f;
    if (!(min(m.separation[0], m.separation[1]) < -2.0f * linear_slop) || !has_floor(core.poses[m.body_a], core.poses[m.body_b])) return false;
    const std::uint32_t body = core.is_dynamic(m.body_a) ? m.body_a : m.body_b;
    return min(m.separation[0], m.separation[1]) < -share * core.bodies[body].min_extent;
}

enum class Change : std::uint8_t { none, changes, parts };

// Updates one contact and touches nothing else, so contacts may be updated in any order or in parallel. Changes to shared state are only reported.
ISLET_PART Change update(Core& core, std::uint32_t index, float dt, float fall, const LoadFollower& loads, std::uint32_t& recycled) {
    ContactManifold& m = core.manifolds[index];
    const Pose& a = core.poses[m.body_a];
    const Pose& b = core.poses[m.body_b];
#if !defined(__OPTIMIZE_SIZE__)
    if (is_settled(m, a, b)) {
        loads.follow(m);
        ++recycled;
        return is_continuous(core) && is_deep(core, m) ? Change::changes : Change::none;
    }
#endif
    if (((a.flags | b.flags) & pose_moved) != 0) {
        const Contact& c = core.contacts[index];
        const Aabb &box_a = core.boxes[c.shape_a], &box_b = core.boxes[c.shape_b];
        if (!meet(box_a, box_b) && !may_meet(core, m.body_a, box_a, m.body_b, box_b, dt)) return Change::parts;
        if (may_be_endless(box_a) && keeps_from_endless(core, c.shape_a, c.shape_b, dt)) return Change::parts;
    }
    if (has_sensors && (m.flags & contact_sensor) != 0)
        return overlaps_sensor(core, index) == ((m.flags & contact_overlap) != 0) ? Change::none : Change::changes;
    const bool one_way = has_one_way && (m.flags & contact_one_way) != 0;
    if (one_way && !decide_one_way(core, index, m.flags, dt)) {
        m.forget_points();
        m.forget_impulses();
        return (m.flags & contact_touching) != 0 ? Change::changes : Change::none;
    }
    loads.follow(m);
    if (has_sleep && (a.flags & b.flags & pose_learns) != 0) loads.learn(m, a.inv_mass + b.inv_mass);
    // Shapes that touch already, and have slipped little, do not come together fast.
    // Bodies that bounce off each other, or that shock propagation takes for lighter, do not look ahead for each other: they would gain energy.
    const bool calm = (m.flags & contact_bouncy) == 0 && !has_shock(core.state->solver);
    const bool fast = ((a.flags | b.flags) & pose_fast) != 0 && (calm || has_floor(a, b));
    Approach approach;
    if (fast && m.count() == 0) approach = approach_to(core, m, dt, fall);
    if ((m.flags & (contact_posed | contact_ahead)) == contact_posed && m.count() != 0) turn_along(core, m, a, b);
    if (!comes_fast(approach) && can_recycle(m, a, b)) {
        ++recycled;
    } else {
        if (fast && m.count() != 0) approach = approach_to(core, m, dt, 0);
        remake(core, index, approach, dt);
        if (one_way) mend_one_way(core, index);
    }
    const bool is = m.count() > 0;
    if ((m.flags & contact_untold) != 0 || (is_continuous(core) && is_deep(core, m))) return Change::changes;
    if (has_hooks && (m.flags & contact_asks) != 0 && is) return Change::changes;  // perhaps: the hook has not decided yet
    return is == ((m.flags & contact_touching) != 0) ? Change::none : Change::changes;
}

// How far apart the two shapes are now at the contact's points.
float separation_now(const Core& core, const ContactManifold& m) {
    float least = 3.0e38f;
    for (std::uint32_t i = 0; i < m.count(); ++i)
        least = min(least, m.separation[i] + dot(m.normal, slip_of(m, i, core.poses[m.body_a], core.poses[m.body_b])));
    return least;
}

void tell_touch(Core& core, std::uint32_t index) {
    const Contact& c = core.contacts[index];
    push_touch(core, core.begin_events, core.begin_count, core.sensor_begins, {core.shape_id(c.shape_a), core.shape_id(c.shape_b)});
}

void begin_touch(Core& core, std::uint32_t index, BitSet to_wake) {
    ContactManifold& m = core.manifolds[index];
    m.flags |= contact_touching;
    assign_color(core, index);
    if ((m.flags & contact_ahead) != 0 && separation_now(core, m) > speculative_distance) {
        m.flags |= contact_untold;
        core.begins.set(index);
    } else {
        note_begin(core, index);
    }
    if (core.is_dynamic(m.body_a) && !core.is_awake(m.body_a)) to_wake.set(m.body_a);
    if (core.is_dynamic(m.body_b) && !core.is_awake(m.body_b)) to_wake.set(m.body_b);
}

void end_touch(Core& core, std::uint32_t index) {
    ContactManifold& m = core.manifolds[index];
    if (is_told(m)) record_end_event(core, index);
    m.flags &= ~static_cast<std::uint32_t>(contact_touching | contact_untold);
    core.begins.clear(index);
    release_color(core, index);
}

// Applies a contact's change to shared state.
void commit(Core& core, std::uint32_t index, BitSet to_wake) {
    const ContactManifold& m = core.manifolds[index];
    if (has_sensors && (m.flags & contact_sensor) != 0) return (m.flags & contact_overlap) != 0 ? end_overlap(core, index) : begin_overlap(core, index);
    if (is_continuous(core) && is_deep(core, m)) {
        const std::uint32_t body = core.is_dynamic(m.body_a) ? m.body_a : m.body_b;
        if (core.is_awake(body)) core.poses[body].flags |= pose_deep;
    }
    // The hook's changes hold for one step, even if the hook has been taken away.
    if (has_hooks && (m.flags & contact_asks) != 0 && m.count() > 0) {
        mix_materials(core, index);
        if (core.hooks.pre_solve != nullptr) ask_pre_solve(core, index);
    }
    const bool was = (m.flags & contact_touching) != 0;
    if (was && (m.flags & contact_untold) != 0) core.begins.set(index);
    if (was == (m.count() > 0)) return;
    if (was) {
        end_touch(core, index);
    } else {
        begin_touch(core, index, to_wake);
    }
}

}  // namespace

void tell_touches(Core& core) {
    const BitSet begins = core.begins;
    begins.for_each([&](std::uint32_t i) {
        const ContactManifold& m = core.manifolds[i];
        if ((m.flags & contact_untold) != 0) return;
        begins.clear(i);
        if (has_sensors && (m.flags & contact_sensor) != 0) return tell_overlap(core, i);
        tell_touch(core, i);
    });
    core.begun = 0;
    begins.for_each([&](std::uint32_t i) {
        ContactManifold& m = core.manifolds[i];
        begins.clear(i);
        if (!(max(m.normal_impulse[0], m.normal_impulse[1]) > 0 || separation_now(core, m) <= speculative_distance)) return;
        m.flags &= ~static_cast<std::uint32_t>(contact_untold);
        if (has_room_for_begin(core)) tell_touch(core, i);
    });
}

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
    const float fall = fall_in(core, dt);
    const LoadFollower loads(*core.state, dt);
    const std::uint32_t words = core.awake_contacts.word_count;
    std::uint32_t* recycled = arena.take<std::uint32_t>(range_count(words, update_grain));
    core.report.recycled_contacts = 0;
    std::memset(recycled, 0, std::size_t{range_count(words, update_grain)} * 4);
    for_ranges(core, words, update_grain, [&](std::uint32_t first, std::uint32_t end) {
        std::uint32_t kept = 0;
        const auto update_one = [&](std::uint32_t i) ISLET_INLINED_LAMBDA {
            const Change change = update(core, i, dt, fall, loads, kept);
            if (change == Change::none) return;
            changed.set(i);
            if (change == Change::parts) parted.set(i);
        };
        core.awake_contacts.for_each_in(first, end, update_one);
        recycled[first / update_grain] = kept;
    });
    for (std::uint32_t i = 0; i < range_count(words, update_grain); ++i) core.report.recycled_contacts += recycled[i];

    // Changes to shared state are applied in index order.
    changed.for_each([&](std::uint32_t i) {
        if (parted.test(i)) {
            destroy_contact(core, i);
        } else {
            commit(core, i, to_wake);
        }
    });
    for_ranges(core, core.awake_bodies.word_count, clear_grain, [&](std::uint32_t first, std::uint32_t end) {
        core.awake_bodies.for_each_in(first, end, [&](std::uint32_t body) { core.poses[body].flags &= ~static_cast<std::uint32_t>(pose_moved); });
    });
    to_wake.for_each([&](std::uint32_t body) { wake_island(core, body, arena); });
}

}  // namespace islet::detail
