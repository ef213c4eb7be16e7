#include "../exact.hpp"

#include "../solver/group_solve.hpp"

#include <cstring>

#include "../constraint/kernels.hpp"
#include "../graph/colors.hpp"
#include "../graph/mixing.hpp"
#include "../island/contact_names.hpp"
#include "../math/scalar.hpp"
#include "../memory/place.hpp"
#include "../solver/joint_solve.hpp"
#include "../solver/solver_bodies.hpp"
#include "../solver/tree_solve.hpp"

namespace islet::detail {

#if ISLET_MAX_LANES > 1

namespace {

/// A world of the group while it is solved. Its slots follow each other in the group's.
struct Member {
    Solve s;
    std::uint32_t first_slot = 0;                     // of its slots, in the group's
    std::uint32_t first_contact = 0, first_body = 0;  // of its arrays, counted from the first world's
    bool has_overflow = false;                        // contacts without a colour
};

/// A block whose lanes are being filled.
template <std::uint32_t W>
struct OpenBlock {
    std::uint32_t used = 0;
    std::uint32_t flags = 0;  // of its contacts
    ContactLanes<W> lanes;
    const Member* member[W];
};

/// The group. The stages are those of BatchSolve (solver.cpp), over all batches of all worlds.
template <class K>
struct GroupSolve {
    using Rows = typename K::Rows;
    static constexpr std::uint32_t W = K::W;
    using One = LoneKernel<W>;

    Member* members;
    std::uint32_t count;
    std::uint32_t slot_count = 0;
    Rows* rows = nullptr;
    std::uint32_t first_block[color_count + 1] = {};
    std::uint32_t colors = 0;  // bits of those in use
    bool has_overflow = false, has_runs = false, has_links = false, has_locked = false;
    ContactKinds has = {};

    Solve& all() { return members[0].s; }  // its bodies and motions, from the first on, are all worlds'

    template <class Visit>
    void for_members(Visit&& visit) {
        for (std::uint32_t i = 0; i < count; ++i) visit(members[i], members[i].s);
    }
    template <class Visit>
    void for_runs(Visit&& visit) {
        if (!has_runs) return;
        for_members([&](Member&, Solve& s) {
            for (std::uint32_t i = 0; i < s.plan.run_count; ++i) visit(s, s.plan.runs[i]);
        });
    }
    template <class Visit>
    void for_links(Visit&& visit) {
        if (!has_links) return;
        for_members([&](Member&, Solve& s) {
            for (std::uint32_t i = 0; i < s.plan.batch_count; ++i)
                if (s.plan.batches[i].link_count != 0) visit(s, s.plan.batches[i]);
        });
    }
    template <class Visit>
    void for_overflow(Visit&& visit) {
        if (!has_overflow) return;
        for_members([&](Member& m, Solve& s) {
            if (m.has_overflow) visit(s, s.overflow, s.plan.overflow_count);
        });
    }

    void run();
    void prepare();
    void name_contacts_of_color(std::uint32_t color, std::uint32_t& block);
    void name_lane(OpenBlock<W>& open, Rows& r, const Member& m, std::uint32_t contact);
    void close_block(OpenBlock<W>& open, Rows& r);
    void sweep(const SweepNumbers& dynamic, const SweepNumbers& ground, const JointSweep& joints);
    void sweeps(std::uint32_t most, const SweepNumbers& dynamic, const SweepNumbers& ground, const JointSweep& joints);
    void restitute();
    void store();
    void store_joints(bool ends);
    void hold() {
        if (!has_locked) return;
        for_members([&](Member&, Solve& s) {
            if (s.core.state->locked_count != 0) hold_locked(s, 1, s.plan.slot_count);
        });
    }
};

template <class K>
void GroupSolve<K>::name_lane(OpenBlock<W>& open, Rows& r, const Member& member, std::uint32_t contact) {
    const std::uint32_t i = open.used++;
    const Solve& s = member.s;
    const ContactManifold& m = s.core.manifolds[contact];
    r.contact[i] = open.lanes.contact[i] = member.first_contact + contact;
    open.lanes.body_a[i] = member.first_body + m.body_a;
    open.lanes.body_b[i] = member.first_body + m.body_b;
    open.lanes.has_point[0][i] = 1;
    open.lanes.has_point[1][i] = (m.flags & two_point_flag) != 0 ? 1.0f : 0.0f;
    open.flags |= m.flags;
    open.member[i] = &member;
    r.body_a[i] = slot_scale<W> * (member.first_slot + s.plan.slot_of[m.body_a]);
    r.body_b[i] = slot_scale<W> * (member.first_slot + s.plan.slot_of[m.body_b]);
    r.extra_passes[i] = (m.flags & contact_ahead) != 0 ? landing_passes : std::uint8_t{0};
    r.sharers[i] = static_cast<std::uint8_t>(m.sharers());
}

template <class K>
void GroupSolve<K>::close_block(OpenBlock<W>& open, Rows& r) {
    const std::uint32_t used = open.used;
    for (std::uint32_t i = used; i < W; ++i) {
        r.contact[i] = null_index;
        r.body_a[i] = r.body_b[i] = 0;
        r.extra_passes[i] = 0;
        r.sharers[i] = 1;
        open.lanes.contact[i] = open.lanes.contact[0];
        open.lanes.body_a[i] = open.lanes.body_a[0];
        open.lanes.body_b[i] = open.lanes.body_b[0];
        open.lanes.has_point[0][i] = open.lanes.has_point[1][i] = 0;
    }
    r.shared = (open.flags >> contact_sharers_shift & 3u) != 0;
    r.two_points = (open.flags & two_point_flag) != 0 ? 1 : 0;
    r.special = (open.flags & contact_special) != 0;
    r.bouncy = r.rebounds = (open.flags & bouncy_flags) != 0;
    for (std::uint32_t i = 0; (r.special || r.bouncy) && i < W; ++i) {
        const std::uint32_t c = i < used ? r.contact[i] - open.member[i]->first_contact : null_index;
        const Core* core = i < used ? &open.member[i]->s.core : nullptr;
        set_surface(r, i, c != null_index ? core->manifolds[c].flags : 0, c != null_index ? surface_of(*core, c) : MixedSurface{});
    }
    const Solve& s = all();
    has.note(r);
    K::prepare_named({s.core.manifolds, s.core.poses, nullptr, s.bodies, s.motions, s.numbers.step}, open.lanes, r);
    open.used = open.flags = 0;
}

// Fills blocks with the contacts of one colour, world by world, and prepares them.
template <class K>
void GroupSolve<K>::name_contacts_of_color(std::uint32_t color, std::uint32_t& block) {
    OpenBlock<W> open;
    for_members([&](Member& m, Solve& s) {
        if ((s.plan.colors >> color & 1) == 0) return;
        for (std::uint32_t b = 0; b < s.plan.batch_count; ++b) {
            const Batch& batch = s.plan.batches[b];
            for (std::uint32_t i = batch.first_block[color] * W; i < batch.first_block[color + 1] * W && s.plan.contacts[i] != no_plan_index; ++i) {
                name_lane(open, rows[block], m, s.plan.contacts[i]);
                if (open.used == W) close_block(open, rows[block++]);
            }
        }
    });
    if (open.used != 0) close_block(open, rows[block++]);
}

template <class K>
void GroupSolve<K>::prepare() {
    for_members([&](Member& m, Solve& s) {
        gather_bodies(s, 1, s.plan.slot_count);
        colors |= s.plan.colors;
        m.has_overflow = s.plan.overflow_count != 0;
        has_overflow = has_overflow || m.has_overflow;
        has_runs = has_joints && (has_runs || s.plan.run_count != 0);
        has_links = has_joints && (has_links || s.plan.link_count != 0);
        has_locked = has_locked || s.core.state->locked_count != 0;
    });
    std::uint32_t block = 0;
    for (std::uint32_t c = 0; c < color_count; ++c) {
        first_block[c] = block;
        if ((colors >> c & 1) != 0) name_contacts_of_color(c, block);
    }
    first_block[color_count] = block;
    for_overflow([&](Solve& s, ContactRows<1>* overflow, std::uint32_t overflow_count) {
        name_contacts(s.core, overflow, overflow_count, s.plan.contacts + std::size_t{s.plan.block_count} * W);
        has.note(One::prepare(s.input(), overflow, overflow_count));
    });
    const auto input_of = [](const Solve& s) { return JointInput{s.core.joints, s.core.poses, s.core.bodies, s.plan.slot_of, s.bodies, s.numbers.step}; };
    for_links([&](Solve& s, const Batch& batch) { prepare_trees(s.plan, batch, s.links, input_of(s), s.motions); });
    for_runs([&](Solve& s, const JointRun& r) { prepare_joint_run(r, W, s.joint_rows + r.offset, s.plan.joints + r.first, input_of(s)); });
}

template <class K>
void GroupSolve<K>::sweep(const SweepNumbers& dynamic, const SweepNumbers& ground, const JointSweep& joints) {
    for_runs([&](Solve& s, const JointRun& r) {
        if (r.color == no_color) solve_joint_run(r, 1, s.bodies, s.joint_rows + r.offset, joints);
    });
    for_overflow([&](Solve& s, ContactRows<1>* overflow, std::uint32_t n) { solve_alone<One>(s, overflow, n, dynamic, ground); });
    for (std::uint32_t left = colors; left != 0; left &= left - 1) {
        const auto c = trailing_zeros(left);
        for_runs([&](Solve& s, const JointRun& r) {
            if (r.color == c) solve_joint_run(r, W, s.bodies, s.joint_rows + r.offset, joints);
        });
        const std::uint32_t blocks = first_block[c + 1] - first_block[c];
        if (blocks != 0) solve_color<K>(all().bodies, rows + first_block[c], blocks, c < dynamic_color_limit ? dynamic : ground);
    }
    for (std::uint32_t i = 0; has.lands && i < landing_sweeps; ++i) {
        for_overflow([&](Solve& s, ContactRows<1>* overflow, std::uint32_t n) {
            for (std::uint32_t k = 0; k < n; ++k) One::land_again(s.bodies, overflow + k, 1, numbers_alone(s, overflow[k], dynamic, ground));
        });
        for (std::uint32_t c = 0; c < color_count; ++c)
            K::land_again(all().bodies, rows + first_block[c], first_block[c + 1] - first_block[c], c < dynamic_color_limit ? dynamic : ground);
    }
    for_links([&](Solve& s, const Batch& batch) { solve_trees(s.bodies, s.links + batch.first_link, batch.link_count, s.core.joints, joints); });
    hold();
}

template <class K>
void GroupSolve<K>::sweeps(std::uint32_t most, const SweepNumbers& dynamic, const SweepNumbers& ground, const JointSweep& joints) {
    for (std::uint32_t i = 0; i < most; ++i) sweep(dynamic, ground, joints);
}

template <class K>
void GroupSolve<K>::restitute() {
    const float threshold = all().numbers.step.restitution_threshold;
    bool bounces = has.bounces;
    for (std::uint32_t i = 0; bounces && i < restitution_sweeps; ++i) {
        bounces = false;
        for_overflow([&](Solve& s, ContactRows<1>* overflow, std::uint32_t n) { bounces = One::restitute(s.bodies, overflow, n, threshold) || bounces; });
        bounces = K::restitute(all().bodies, rows, first_block[color_count], threshold) || bounces;
    }
    hold();
}

template <class K>
void GroupSolve<K>::store() {
    K::store(all().core.manifolds, rows, first_block[color_count]);
    for_overflow([&](Solve& s, ContactRows<1>* overflow, std::uint32_t n) { One::store(s.core.manifolds, overflow, n); });
    for_members([&](Member&, Solve& s) { scatter_bodies(s, 1, s.plan.slot_count); });
    store_joints(true);
}

// As BatchSolve::store_joints.
template <class K>
void GroupSolve<K>::store_joints(bool ends) {
    const auto output_of = [ends](const Solve& s) {
        return JointOutput{s.core.joints, s.core.poses, s.core.bodies, s.bodies, s.numbers.step.dt, s.numbers.step.h, s.numbers.step.warm, ends};
    };
    for_links([&](Solve& s, const Batch& batch) { store_trees(s.links + batch.first_link, batch.link_count, output_of(s)); });
    for_runs([&](Solve& s, const JointRun& r) { store_joint_run(r, W, s.joint_rows + r.offset, output_of(s)); });
}

template <class K>
void GroupSolve<K>::run() {
    prepare();
    Solve& s = all();
    const SolverState& def = s.core.state->solver;
    const SolveNumbers& n = s.numbers;
    const bool relaxes = is_soft(def) && def.relax_iterations > 0;
    const std::uint32_t relaxing = relaxes ? def.relax_iterations : 0;
    bool tears = false;
    for_members([&](Member&, Solve& one) { tears = tears || (has_joints && (one.core.state->asked & asked_breaks) != 0); });
    // The static bodies' slots go along: what they have is zero, and stays so.
    for (std::uint32_t substep = 0; substep < def.substeps; ++substep) {
        integrate_velocities(s, 0, slot_count, substep == 0);
        hold();
        sweeps(def.iterations, n.biased, n.ground, n.biased_joints);
        integrate_positions(s, 0, slot_count);
        sweeps(relaxing, n.relaxed, n.relaxed, n.relaxed_joints);
        if (tears && substep + 1 < def.substeps) store_joints(false);
    }
    restitute();
    store();
    for_members([&](Member&, Solve& one) {
        const std::uint32_t first = one.plan.batches[kinematic_batch].body_count == 0 ? kinematic_batch + 1 : kinematic_batch;
        for (std::uint32_t b = first; b < one.plan.batch_count; ++b) one.plan.batches[b].sweeps = def.substeps * (def.iterations + relaxing);
    });
}

}  // namespace

bool solve_alike(const Core& a, const Core& b) {
    const State& s = *a.state;
    const State& t = *b.state;
    if (has_tuning && (is_ordered(s.solver) || has_shock(s.solver) || measures_residual(s.solver))) return false;
    if (has_hits && ((s.asked | t.asked) & shape_hit_events) != 0) return false;
    return std::memcmp(&s.solver, &t.solver, sizeof s.solver) == 0 && s.last_substep == t.last_substep && s.restitution_threshold == t.restitution_threshold &&
           s.max_speed == t.max_speed && s.gravity.x == t.gravity.x && s.gravity.y == t.gravity.y;
}

void solve_group(GroupWorld* worlds, std::uint32_t count, Arena& arena, float dt) {
    alignas(Member) std::byte room[group_worlds * sizeof(Member)];
    auto* const members = reinterpret_cast<Member*>(room);
    const Core& first = *worlds[0].core;
    SolveNumbers numbers = choose_numbers(*first.state, dt);
    std::uint32_t slots = 0, blocks = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        slots += worlds[i].plan.slot_count;
        blocks += worlds[i].plan.block_count;
        numbers.biased.shares = numbers.biased.shares || (worlds[i].core->state->asked & asked_sharing) != 0;
    }
    auto* const bodies = arena.take<SolverBody>(slots);
    Arena rows = arena;  // neither these nor the motions are read after the solve
    auto* const motions = rows.take<SolverMotion>(slots);
    auto* const block_rows = rows.take<std::byte>(std::size_t{blocks} * first.block_lanes() * row_bytes);
    std::uint32_t slot = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        GroupWorld& world = worlds[i];
        Solve& s = (new (members + i, IsletPlace{}) Member{{*world.core, world.plan, numbers}})->s;
        s.bodies = world.bodies = bodies + slot;
        s.motions = motions + slot;
        s.bodies[0] = SolverBody{};
        s.motions[0] = SolverMotion{};
        s.overflow = rows.take<ContactRows<1>>(world.plan.overflow_count);
        s.joint_rows = place_joint_rows(world.plan, first.block_lanes(), rows);
        s.links = rows.take<TreeLink>(world.plan.link_count);
        members[i].first_slot = slot;
        members[i].first_contact = static_cast<std::uint32_t>(world.core->manifolds - first.manifolds);
        members[i].first_body = static_cast<std::uint32_t>(world.core->poses - first.poses);
        slot += world.plan.slot_count;
    }
    with_lanes(first.block_lanes(), [&](auto lanes) {
        if constexpr (lanes > 1) GroupSolve<ContactKernel<lanes>>{members, count, slots, reinterpret_cast<ContactRows<lanes>*>(block_rows)}.run();
    });
    for (std::uint32_t i = 0; i < count; ++i) {
        worlds[i].core->state->last_substep = numbers.step.h;
        worlds[i].core->has_residuals = false;
    }
}

#endif

}  // namespace islet::detail
