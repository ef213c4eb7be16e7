// The contact update: keeps manifolds or makes them anew, and lets touches begin and end.
#include "../exact.hpp"

#include "../step/contact_update.hpp"

#include "../bodies/sleep.hpp"
#include "../broadphase/pairs.hpp"
#include "../constraint/kernels.hpp"
#include "../data/parallel.hpp"
#include "../graph/colors.hpp"
#include "../graph/contact_batches.hpp"
#include "../graph/contact_parts.hpp"
#include "../graph/contacts.hpp"
#include "../graph/hooks.hpp"
#include "../graph/sensors.hpp"
#include "../math/boxes.hpp"
#include "../math/inlining.hpp"
#include "../math/scalar.hpp"
#include "../shapes/manifolds.hpp"
#include "../shapes/shape_types.hpp"
#include "../step/clearance.hpp"
#include "../step/continuous.hpp"
#include "../step/inner_edges.hpp"
#include "../step/lane_update.hpp"
#include "../step/one_way.hpp"
#include "../step/recycling.hpp"

namespace islet::detail {

namespace {

inline constexpr std::uint32_t update_grain = 4;  // words of 64 contacts that are worth a task
inline constexpr std::uint32_t clear_grain = 16;  // words of 64 bodies that are worth a task

bool comes_fast(const Approach& approach) { return approach.most() > 2.0f * fast_way; }

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

// m that points may be apart which meet in the rest of a step. (It lasts at most a second, and no body moves faster, whatever velocity it was given.)
float margin_ahead(const Approach& approach, float rest = 1) { return speculative_distance + 2.0f * rest * min(approach.most(), max_speed_limit); }

// Makes the manifold with which two shapes will touch in this step. If they are about to meet, it is made as they will stand at the time of impact; the motion
// until then is treated as slip. (A plane through the points that are nearest now would throw back a shape that is about to pass.) After the first point has
// met, another one comes down up to twice as fast, as the body turns about the first.
Manifold manifold_ahead(const Core& core, const Contact& c, const ContactManifold& m, const Approach& approach, float dt, Stand& stand, float& margin,
                        Transform& b_in_a) {
    const Manifold now = manifold_at(core, c, m, stand, margin, b_in_a);
    // Where the body is now, a chain segment may leave the contact to its neighbour although the body will come to that segment.
    const bool to_link = is_link(core, c);
    if (now.count == 0 && !to_link) return now;
    if (now.count != 0) {
        const float apart = least_separation(now);
        if (apart <= speculative_distance) return now;
        // They may end the step as near as those that touch, and a little nearer by rounding.
        if (!to_link && apart + dot(rotate(stand.a, now.normal), approach.way) > approach.turn + 1.1f * touch_gap) return {};
    }
    const bool held = !has_floor(core.poses[m.body_a], core.poses[m.body_b]);
    const BodyPath a = path_ahead(core, m.body_a, dt, held), b = path_ahead(core, m.body_b, dt, held);
    const float t = time_to_touch(core, c.shape_a, a, c.shape_b, b);
    if (!(t > 0 && t < 1)) return {};
    stand = {center_at(b, t) - center_at(a, t), rotation_at(a, t), rotation_at(b, t)};
    margin = margin_ahead(approach, 1.0f - t);
    return manifold_at(core, c, m, stand, margin, b_in_a);
}

// True if a round shape rolls at the contact, and moves the contact point of a body along that body's surface, or about its centre. The contact of a ball does
// not move about the centre of the ball. Between moving bodies that others are at, too, the manifold is kept: heaps rest the better for it, and heavy balls lie
// on capsules. (Where shock propagation takes bodies for lighter than they are, piles of balls and boxes would not rest.)
ISLET_APART bool rolls(const Core& core, const Contact& c, const ContactManifold& m, float dt) {
    const float wa = core.motions[m.body_a].w, wb = core.motions[m.body_b].w, spin = abs(wb - wa);
    if (m.count() != 1 || !(spin > roll_rate && spin * dt < most_roll && abs(wa) * dt < 1) || m.separation[0] > speculative_distance) return false;
    if (has_shock(core.state->solver) || (!has_floor(core.poses[m.body_a], core.poses[m.body_b]) && is_between_others(core.bodies, m))) return false;
    bool round = false, moves_about = false;
    for (const bool is_a : {true, false}) {
        const std::uint32_t body = is_a ? m.body_a : m.body_b;
        const Geometry& g = core.geometries[core.shapes[is_a ? c.shape_a : c.shape_b].geometry];
        const bool is_circle = g.shape_type() == ShapeType::circle;
        const bool is_ball = is_circle && distance_squared(g.circle.center, core.bodies[body].local_center) < linear_slop * linear_slop;
        round = round || is_circle || g.shape_type() == ShapeType::capsule;
        moves_about = moves_about || (core.is_dynamic(body) && !is_ball);
    }
    return round && moves_about;
}

// How the two bodies of a contact will stand in the middle of the step, if the shapes come no nearer at the contact point.
Stand stand_midway(const Core& core, const ContactManifold& m, float dt) {
    const Stand now = stand_now(core, m.body_a, m.body_b);
    const Motion &of_a = core.motions[m.body_a], &of_b = core.motions[m.body_b];
    const float half = 0.5f * dt;
    const Vec2 way = of_b.v - of_a.v, arm = m.anchors[0];
    const float nearer = dot(m.normal, way + cross(of_b.w, arm - m.offset) - cross(of_a.w, arm));
    return {now.offset + half * (way - nearer * m.normal), integrate(now.a, half * of_a.w), integrate(now.b, half * of_b.w)};
}

// A manifold, and what it was made for.
struct MadeFor {
    Manifold fresh;
    Transform b_in_a;
    float margin;  // m
    bool rolling;  // for a round shape that rolls
};

// Where a round shape rolls, the contact point moves. One that stood where it was when the step began, or when a kept manifold was made, would lag, and push
// what rocks the way that it goes: a roly-poly swung itself up until it fell over, and a board on a ball until it fell off. So the manifold is made for the
// middle of the step, and in each step anew. If there is none then, as at the end of a piece of floor, it is made for now. The contact notes how the bodies
// stand in it.
ISLET_APART MadeFor make_manifold(const Core& core, std::uint32_t index, const Approach& approach, float dt) {
    const Contact& c = core.contacts[index];
    ContactManifold& m = core.manifolds[index];
    const bool fast = is_continuous(core) && comes_fast(approach);
    MadeFor made;
    made.margin = fast ? margin_ahead(approach) : speculative_distance;
    made.rolling = rolls(core, c, m, dt);
    Stand stand = made.rolling ? stand_midway(core, m, dt) : stand_now(core, m.body_a, m.body_b);
    if (made.rolling) {
        made.fresh = manifold_at(core, c, m, stand, made.margin, made.b_in_a);
        made.rolling = made.fresh.count > 0;
        if (!made.rolling) stand = stand_now(core, m.body_a, m.body_b);
    }
    if (!made.rolling)
        made.fresh =
            fast ? manifold_ahead(core, c, m, approach, dt, stand, made.margin, made.b_in_a) : manifold_at(core, c, m, stand, made.margin, made.b_in_a);
    m.offset = stand.offset;
    m.rotation_a = stand.a;
    m.rotation_b = stand.b;
    return made;
}

// True if two shapes are farther apart than points of a manifold may be, so that `remake` would find none: by their clearance, or by the circles around their
// bodies, of which many pass each other. (What comes fast to a link is looked at again where it may touch. Builds for one lane, which may be small, do
// without.) Notes how far.
[[maybe_unused]] ISLET_SHARED bool are_far_apart(Core& core, std::uint32_t index, const Pose& a, const Pose& b, const Approach& approach) {
    const ContactManifold& m = core.manifolds[index];
    const float inexact = inexact_by(core, m, a, b), margin = margin_ahead(approach) + inexact, most = margin + a.max_extent + b.max_extent;
    float clearance = 0;
    if (!(length_squared(b.center - a.center) > most * most)) {
        clearance = clearance_now(core, index, a, b, margin);
        if (!(clearance > 0)) return false;
    }
    if (comes_fast(approach) && is_link(core, core.contacts[index])) return false;
    core.clearances[index] = clearance;
    return true;
}

// Makes the manifold anew. Points whose features the old manifold had keep their impulses.
ISLET_SHARED void remake(Core& core, std::uint32_t index, const Approach& approach, float dt) {
    const Contact& c = core.contacts[index];
    ContactManifold& m = core.manifolds[index];
    const Vec2 center_a = core.bodies[m.body_a].local_center;
    MadeFor made = make_manifold(core, index, approach, dt);
    Manifold& fresh = made.fresh;
    const bool has_pieces = (core.bodies[m.body_a].shape_count | core.bodies[m.body_b].shape_count) > 1;
    if (fresh.count > 0 && has_seamless(core) && (has_pieces || has_floor(core.poses[m.body_a], core.poses[m.body_b])))
        mend_inner_edges(core, c, made.b_in_a, made.margin, fresh);
    note_clearance(core, index, fresh);

    m.normal = rotate(m.rotation_a, fresh.normal);
    const bool lands = fresh.count > 0 && approach.turn - dot(m.normal, approach.way) > 2.0f * speculative_distance;
    if (fresh.count == 0) m.rolling_impulse = 0;
    const std::uint32_t known = (m.flags & contact_ahead) == 0 ? m.count() : 0;  // the impulses of a blow are no warm start
    std::uint32_t ids = 0;
    float normal_impulse[2] = {0, 0}, tangent_impulse[2] = {0, 0};
    for (std::uint32_t i = 0; i < 2; ++i) {
        m.anchors[i] = {0, 0};
        m.separation[i] = 0;
        if (i >= fresh.count) continue;
        const ManifoldPoint& point = fresh.points[i];
        m.anchors[i] = rotate(m.rotation_a, point.point - center_a);
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
    m.flags = (m.flags & ~(3u << contact_count_shift | contact_ahead | contact_rolls)) | fresh.count << contact_count_shift | contact_posed |
              (lands ? std::uint32_t{contact_ahead} : 0u) | (made.rolling ? std::uint32_t{contact_rolls} : 0u);
}

// True if a body has sunk into a floor by more than contacts commonly do. (Lanes leave those to be looked at one by one.)
ISLET_PART bool has_sunk(const Core& core, const ContactManifold& m) {
    return min(m.separation[0], m.separation[1]) < sunk_from && has_floor(core.poses[m.body_a], core.poses[m.body_b]);
}

// True if it has sunk by a quarter of its half-thickness. Its way is then followed like a fast body's, even if it creeps.
ISLET_SHARED bool is_deep(const Core& core, const ContactManifold& m) {
    constexpr float share = 0.25f;
    if (!has_sunk(core, m)) return false;
    const std::uint32_t body = core.is_dynamic(m.body_a) ? m.body_a : m.body_b;
    return min(m.separation[0], m.separation[1]) < -share * core.bodies[body].min_extent;
}

enum class Change : std::uint8_t { none, changes, parts };

// Updates one contact and touches nothing else, so contacts may be updated in any order or in parallel. Changes to shared state are only reported.
ISLET_PART Change update(Core& core, std::uint32_t index, float dt, float fall, const LoadFollower& loads, UpdateCount& count) {
    ContactManifold& m = core.manifolds[index];
    const bool touches = m.count() != 0;
    const bool is_new = !(touches ? core.kept.keeps_in_lanes : core.kept.parts_in_lanes);  // to this step: lanes have not looked at it
    [[maybe_unused]] LaneShare& share = touches ? count.touching : count.apart;
    [[maybe_unused]] const std::uint32_t in_lanes = is_new && (touches ? lanes_keep(m.flags) : lanes_tell_apart(m.flags)) ? 1 : 0;
    if constexpr (max_lanes > 1) share.all += in_lanes;
    const Pose& a = core.poses[m.body_a];
    const Pose& b = core.poses[m.body_b];
    if (!short_loops && is_new && ((a.flags | b.flags) & pose_moved) == 0 && is_settled(core.motions, m, a, b)) {
        loads.follow(m);
        ++count.kept;
        const bool sunk = is_continuous(core) && has_sunk(core, m);
        if (max_lanes > 1 && !sunk) share.done += in_lanes;
        return sunk && is_deep(core, m) ? Change::changes : Change::none;
    }
    if (((a.flags | b.flags) & pose_moved) != 0) {
        const Contact& c = core.contacts[index];
        const Aabb &box_a = core.boxes[c.shape_a], &box_b = core.boxes[c.shape_b];
        if (!meet(box_a, box_b) && !may_meet(core, m.body_a, box_a, m.body_b, box_b, dt)) {
            if constexpr (max_lanes > 1) share.done += touches ? 0 : in_lanes;
            return Change::parts;
        }
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
    if (may_recycle(m) && m.count() != 0) turn_along(core, m, a, b);
    if (!comes_fast(approach) && can_recycle(core, m, a, b)) {
        ++count.kept;
        if constexpr (max_lanes > 1) share.done += in_lanes;
    } else if (max_lanes > 1 && m.count() == 0 && !one_way && are_far_apart(core, index, a, b, approach)) {
        note_apart(m, a, b);
        share.done += in_lanes;
    } else {
        if (fast && m.count() != 0) approach = approach_to(core, m, dt, 0);
        if constexpr (max_lanes > 1) share.done += has_floor(a, b) ? 0 : in_lanes;  // which lanes make anew
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

// `count`: of the begin events so far.
void tell_touch(Core& core, std::uint32_t index, std::uint32_t& count) {
    const Contact& c = core.contacts[index];
    push_touch(core, core.begin_events, count, core.sensor_begins, {core.shape_id(c.shape_a), core.shape_id(c.shape_b)});
}

inline constexpr std::uint32_t least_told = 128;  // touches that make workers pay
inline constexpr std::uint32_t tell_grain = 4;    // words of 64 contacts that are worth a task

// Tells of the touches in `begins` but of those that are untold, in order. False if there are not enough of them for several workers.
bool tell_at_once(Core& core, BitSet begins) {
    if (!has_many_workers(core) || core.begun < least_told || (core.state->asked & shape_sensor) != 0) return false;
    using Cut = RangeCut<64>;
    const Cut cut(core, begins.word_count, tell_grain);
    std::uint32_t next[Cut::room];  // by range: how many it tells of; then the place of the next one
    const auto over_told = [&](auto&& visit) {
        for_ranges(core, begins.word_count, cut.grain, [&](std::uint32_t first, std::uint32_t end) {
            begins.for_each_in(first, end, [&](std::uint32_t i) {
                if ((core.manifolds[i].flags & contact_untold) == 0) visit(i, next[cut.of(first)]);
            });
        });
    };
    for (std::uint32_t range = 0; range < cut.count; ++range) next[range] = 0;
    over_told([](std::uint32_t, std::uint32_t& count) { ++count; });
    std::uint32_t at = core.begin_count;
    for (std::uint32_t range = 0; range < cut.count; ++range) at = lay_out(next[range], at);
    core.begin_count = at;
    over_told([&](std::uint32_t i, std::uint32_t& to) {
        begins.clear(i);
        tell_touch(core, i, to);
    });
    return true;
}

void begin_touch(Core& core, std::uint32_t index, BitSet to_wake) {
    ContactManifold& m = core.manifolds[index];
    m.flags |= contact_touching;
    core.forget_plan();
    count_sharers(core, index);
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
    count_sharers(core, index);
    core.begins.clear(index);
    core.forget_plan();
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

// Applies all contacts' changes to shared state, in the order of their slots. Those that parted, and of which nobody else knows, are in `sets.parted` alone.
void commit_all(Core& core, UpdateSets sets, BitSet to_wake, [[maybe_unused]] Arena arena) {
    BitSet changed = sets.changed;
    const BitSet parted = sets.parted;
#if ISLET_THREADS
    const std::uint32_t parts = has_many_workers(core) ? parted.count() : 0;
    if (in_batches(core, parts) && arena.room() >= sizeof(std::uint32_t) * parts + line_bytes) {
        std::uint32_t* const ended = arena.take<std::uint32_t>(parts);
        std::uint32_t count = 0;
        changed.for_each([&](std::uint32_t i) { parted.test(i) ? leave_contact(core, i) : commit(core, i, to_wake); });
        parted.for_each([&](std::uint32_t i) { ended[count++] = i; });
        return remove_contacts(core, {ended, count});
    }
    for (std::uint32_t w = 0; w < changed.word_count; ++w) changed.words[w] |= parted.words[w];
#endif
    changed.for_each([&](std::uint32_t i) {
        if (parted.test(i)) {
            destroy_contact(core, i);
        } else {
            commit(core, i, to_wake);
        }
    });
}

}  // namespace

void tell_touches(Core& core) {
    const BitSet begins = core.begins;
    if (!tell_at_once(core, begins)) {
        begins.for_each([&](std::uint32_t i) {
            const ContactManifold& m = core.manifolds[i];
            if ((m.flags & contact_untold) != 0) return;
            begins.clear(i);
            if (has_sensors && (m.flags & contact_sensor) != 0) return tell_overlap(core, i);
            tell_touch(core, i, core.begin_count);
        });
    }
    core.begun = 0;
    begins.for_each([&](std::uint32_t i) {
        ContactManifold& m = core.manifolds[i];
        begins.clear(i);
        if (!(max(m.normal_impulse[0], m.normal_impulse[1]) > 0 || separation_now(core, m) <= speculative_distance)) return;
        m.flags &= ~static_cast<std::uint32_t>(contact_untold);
        if (has_room_for_begin(core)) tell_touch(core, i, core.begin_count);
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
    UpdateSets sets{take_bits(core.capacity.contacts), take_bits(core.capacity.contacts)};
    const BitSet to_wake = take_bits(core.capacity.bodies);

    // Word by word of the set of awake contacts, each range with its own count. (for_ranges makes one range where there are no workers.)
    const float fall = fall_in(core, dt);
    const LoadFollower loads(*core.state, dt);
    const std::uint32_t words = core.awake_contacts.word_count;
    const std::uint32_t grain = fine_grain(core, update_grain), ranges = has_workers(core) && words > grain ? range_count(words, grain) : 1;
    UpdateCount* const counts = arena.take<UpdateCount>(ranges);
    counts[0] = {};  // for a world without room for contacts, which has no range
    const bool uses_lanes = max_lanes > 1 && core.lanes > 1 && (core.kept.keeps_in_lanes || core.kept.parts_in_lanes);
    const BitSet open = uses_lanes ? take_bits(core.capacity.contacts) : core.awake_contacts;  // to be looked at one by one
    ContactsInLanes in_lanes;
    if constexpr (max_lanes > 1) in_lanes = contacts_in_lanes(core, loads.rate, dt, fall);
    for_ranges(core, words, grain, [&](std::uint32_t first, std::uint32_t end) {
        UpdateCount count;
        if constexpr (max_lanes > 1)
            if (uses_lanes) update_in_lanes(core, in_lanes, first, end, open, sets, count);
        open.for_each_in(first, end, [&](std::uint32_t i) ISLET_INLINED_LAMBDA {
            const Change change = update(core, i, dt, fall, loads, count);
            if (change == Change::parts) sets.part(core.manifolds, i);
            if (change == Change::changes) sets.changed.set(i);
        });
        counts[first / grain] = count;
    });
    UpdateCount& count = counts[0];
    for (std::uint32_t i = 1; i < ranges; ++i) {
        count.kept += counts[i].kept;
        count.add(counts[i]);
    }
    core.report.recycled_contacts = count.kept;
    if constexpr (max_lanes > 1) core.kept.note_lanes(core.lanes > 1 && count.touching.pays(), core.lanes > 1 && count.apart.pays());

    commit_all(core, sets, to_wake, arena);
    for_ranges(core, core.awake_bodies.word_count, clear_grain, [&](std::uint32_t first, std::uint32_t end) {
        core.awake_bodies.for_each_in(first, end, [&](std::uint32_t body) { core.poses[body].flags &= ~static_cast<std::uint32_t>(pose_moved); });
    });
    to_wake.for_each([&](std::uint32_t body) { wake_island(core, body, arena); });
}

}  // namespace islet::detail
