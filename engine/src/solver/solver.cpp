#include "../exact.hpp"

#include "../solver/solver.hpp"

#include "../constraint/kernels.hpp"
#include "../data/parallel.hpp"
#include "../graph/colors.hpp"
#include "../graph/mixing.hpp"
#include "../island/height_order.hpp"
#include "../math/inlining.hpp"
#include "../math/lanes.hpp"
#include "../math/scalar.hpp"
#include "../solver/free_motion.hpp"
#include "../solver/hits.hpp"
#include "../solver/joint_solve.hpp"
#include "../solver/ordered_sweep.hpp"
#include "../solver/sweep_residual.hpp"
#include "../solver/tree_solve.hpp"

namespace islet::detail {

namespace {

/// The numbers of a solve: time, warm start and limits, and how each kind of sweep treats contacts and joints.
struct SolveNumbers {
    StepNumbers step;
    SweepNumbers biased, ground, relaxed;  // `ground`: with bias, for contacts with bodies that cannot be pushed, which are stiffer
    JointSweep biased_joints, relaxed_joints;
    float tolerance = 0;  // m/s; 0: no sweep is left out
    bool is_ordered = false;
};

/// What all batches of one solve share.
struct Solve {
    Core& core;
    const Plan& plan;
    SolveNumbers numbers;
    SolverBody* bodies = nullptr;     // by slot
    SolverMotion* motions = nullptr;  // by slot
    std::byte* joint_rows = nullptr;
    TreeLink* links = nullptr;
    std::byte* blocks = nullptr;  // ContactRows of the core's lanes
    ContactRows<1>* overflow = nullptr;
    float* residuals = nullptr;  // m/s, by island; null if not wanted
    Hit* hits = nullptr;         // by contact; null if not wanted
};

SweepNumbers soft_sweep(float hertz, float damping_ratio, float push_speed, float h) {
    const Softness soft = make_soft(hertz, damping_ratio, h);
    SweepNumbers n;
    n.inv_h = 1.0f / h;
    n.bias_rate = soft.rate * soft.mass_scale;
    n.mass_scale = soft.mass_scale;
    n.impulse_scale = soft.impulse_scale;
    n.push_speed = push_speed;
    return n;
}

// Of the overlap of moving bodies under a steady load, the share that contacts undo slowly; and the shares of deep overlaps that they undo in a step.
inline constexpr float load_share = 0.8f;
inline constexpr float corner_share = 0.95f;
inline constexpr float face_share = 0.55f;

SolveNumbers choose_numbers(const State& state, float dt) {
    SolveNumbers s;
    const SolverState& def = state.solver;
    StepNumbers& n = s.step;
    n.dt = dt;
    n.h = dt / static_cast<float>(def.substeps);
    n.inv_h = 1.0f / n.h;
    n.omega = def.omega;
    // Impulses grow with the substep, so those of the last step are scaled to this substep's length. A last substep that was nothing beside this one says
    // nothing about it.
    n.warm = def.warm_start == 0 ? 0.0f : state.last_substep > 0 ? n.h / state.last_substep : 1.0f;
    if (!(n.warm <= 1.0e6f)) n.warm = 0;
    n.restitution_threshold = state.restitution_threshold;
    n.max_speed = state.max_speed;
    n.max_turn = max_turn_of(dt);
    n.lightens = has_shock(def);

    s.relaxed.inv_h = n.inv_h;
    if (is_soft(def)) {
        const float hertz = min(def.contact_hertz, 0.125f * n.inv_h);
        s.biased = soft_sweep(hertz, def.contact_damping_ratio, def.contact_push_speed, n.h);
        s.ground = soft_sweep(2.0f * hertz, def.contact_damping_ratio, def.contact_push_speed, n.h);
        if (const float undone = s.biased.bias_rate * dt; undone > 1.0e-3f) {
            n.give_back = load_share * n.omega * n.h * s.biased.impulse_scale / s.biased.bias_rate;
            n.deep_corner = max(corner_share / undone - 1.0f, 0.0f);
            n.deep_face = max(face_share / undone - 1.0f, 0.0f);
        }
        s.biased.impulse_scale *= n.omega;
        s.ground.impulse_scale *= n.omega;
        // Friction is solved in both sweeps. Solving it in the relaxing sweep alone, as Box2D 3.2 does, saves 3 % of large_pyramid's time, but the pile then
        // still holds 6.4 J after 500 steps instead of 0.07 J.
    } else {
        s.biased.inv_h = n.inv_h;
        s.biased.bias_rate = def.baumgarte * n.inv_h;
        s.biased.push_speed = def.contact_push_speed;
        s.biased.slop = linear_slop;
        s.ground = s.biased;
    }

    s.is_ordered = is_ordered(state.solver);
    s.tolerance = def.tolerance;

    s.relaxed_joints.h = n.h;
    s.relaxed_joints.inv_h = n.inv_h;
    s.relaxed_joints.omega = n.omega;
    s.biased_joints = s.relaxed_joints;
    s.biased_joints.biased = true;
    if (is_soft(def)) {
        // Joints are as stiff as Gauss-Seidel bears. At 240 substeps a second, the largest gap of joint_grid is 0.33 m at 60 Hz, 0.22 m at 75 Hz and 0.16 m
        // at 90 Hz. But from 65 Hz on, figures that stand on jointed legs no longer come to rest (3e-6 m/s at 60 Hz, 1e-3 m/s at 65 Hz, 0.1 m/s at 75 Hz),
        // and at 120 Hz nets and chains under load swing up by themselves. With a rigid bias they do so however weak it is.
        s.biased_joints.tree_rate = n.inv_h;
        s.biased_joints.soft = make_soft(min(def.joint_hertz, 0.25f * n.inv_h), def.joint_damping_ratio, n.h);
    } else {
        s.biased_joints.soft.rate = s.biased_joints.tree_rate = def.baumgarte * n.inv_h;
    }
    return s;
}

void gather_bodies(Solve& s, std::uint32_t first_slot, std::uint32_t end_slot) {
    Core& core = s.core;
    const float h = s.numbers.step.h;
    for (std::uint32_t slot = first_slot; slot < end_slot; ++slot) {
        const std::uint32_t i = s.plan.body_of[slot];
        const Pose& pose = core.poses[i];
        const Motion& motion = core.motions[i];
        SolverBody& b = s.bodies[slot];
        // Adding +0 turns -0 into +0. After that no sum in the solve is ever -0, so a lane that adds nothing changes no bit.
        b.v = {motion.v.x + 0.0f, motion.v.y + 0.0f};
        b.w = motion.w + 0.0f;
        b.inv_mass = pose.inv_mass;
        b.warm_v = {0, 0};
        b.warm_w = 0;
        const float lightness = has_tuning && s.plan.lightness != nullptr ? s.plan.lightness[i] : 1.0f;
        b.inv_mass *= lightness;
        b.inv_inertia = stiffened(lightness * pose.inv_inertia, core.bodies[i].stretch);
        gather_motion(s.motions[slot], core, i, h);
        core.bodies[i].stretch = 0;  // the joints' forces of this step give the next step's
    }
}

// v <- factor (v + a) + warm start. Within a step anchors and normals do not change. So the warm start of a later substep, M^-1 J^T lambda summed over a body's
// rows, is what the sweeps of the substep before added to the body's velocity, v - v_free: one addition a body instead of a pass over all rows.
void integrate_velocities(Solve& s, std::uint32_t first_slot, std::uint32_t end_slot, bool first) {
    const float max_speed = s.numbers.step.max_speed;
    const float max_turn = s.numbers.step.max_turn;
    for (std::uint32_t slot = first_slot; slot < end_slot; ++slot) {
        SolverBody& b = s.bodies[slot];
        SolverMotion& m = s.motions[slot];
        Vec2 dv = b.v - m.v_free;
        float dw = b.w - m.w_free;
        if (first) {
            dv = b.warm_v;
            dw = b.warm_w;
            b.dp = {0, 0};
            b.dq = 0;
        }
        const Vec2 v = free_velocity(m, b.v, max_speed);
        const float w = free_turn(m, b.w, max_turn);
        m.v_free = v;
        m.w_free = w;
        b.v = v + dv;
        b.w = w + dw;
    }
}

void integrate_positions(Solve& s, std::uint32_t first_slot, std::uint32_t end_slot) {
    const float h = s.numbers.step.h;
    const float max_speed = s.numbers.step.max_speed;
    const float max_turn = s.numbers.step.max_turn;
    for (std::uint32_t slot = first_slot; slot < end_slot; ++slot) {
        SolverBody& b = s.bodies[slot];
        if (!(dot(b.v, b.v) <= max_speed * max_speed)) b.v = limit_speed(b.v, max_speed);
        b.w = within(b.w, max_turn);
        b.dp += h * b.v;
        b.dq += h * b.w;
    }
}

// A lock is a row like any other, v . axis = 0, solved last in each sweep. (Later warm starts hold its impulses of the substeps before.)
void hold_locked(Solve& s, std::uint32_t first_slot, std::uint32_t end_slot) {
    for (std::uint32_t slot = first_slot; slot < end_slot; ++slot) {
        const Body& body = s.core.bodies[s.plan.body_of[slot]];
        if (body.type() != BodyType::dynamic) continue;
        if ((body.flags & body_lock_x) != 0) s.bodies[slot].v.x = 0;
        if ((body.flags & body_lock_y) != 0) s.bodies[slot].v.y = 0;
    }
}

void scatter_bodies(Solve& s, std::uint32_t first_slot, std::uint32_t end_slot) {
    const float max_turn = 0.5f * pi;
    for (std::uint32_t slot = first_slot; slot < end_slot; ++slot) {
        const std::uint32_t i = s.plan.body_of[slot];
        SolverBody& b = s.bodies[slot];
        b.dq = within_bounds(b.dq, max_turn);
        Pose& pose = s.core.poses[i];
        Motion& motion = s.core.motions[i];
        motion.v = limit_speed(b.v, s.numbers.step.max_speed);
        motion.w = within(b.w, s.numbers.step.max_turn);
        motion.force = {0, 0};
        motion.torque = 0;
        pose.center = max(min(pose.center + b.dp, Vec2{max_position, max_position}), Vec2{-max_position, -max_position});
        if (b.dq != 0) pose.q = integrate(pose.q, b.dq);
    }
}

// Fills in the contacts of each block, and the materials of those that are special or bouncy.
template <std::uint32_t W>
void name_contacts(Core& core, ContactRows<W>* rows, std::uint32_t count, const std::uint32_t* contacts) {
    for (std::uint32_t block = 0; block < count; ++block) {
        ContactRows<W>& r = rows[block];
        std::uint32_t any = 0;
        for (std::uint32_t i = 0; i < W; ++i) {
            const std::uint32_t c = contacts[block * W + i];
            const std::uint32_t soon = block + 1 < count ? contacts[(block + 1) * W + i] : null_index;
            if (W > 1 && soon != null_index) {  // the next block's contacts may be anywhere in memory
                __builtin_prefetch(&core.manifolds[soon].flags);
                __builtin_prefetch(&core.contacts[soon]);
            }
            set_contact(r, i, c, core.manifolds);
            if (c != null_index) any |= core.manifolds[c].flags;
        }
        if ((any & (contact_special | contact_bouncy | contact_hits)) == 0) continue;
        for (std::uint32_t i = 0; i < W; ++i) {
            // A contact's own flags decide, whatever the other contacts of the block have, and whatever its shapes would mix to now.
            const std::uint32_t c = contacts[block * W + i];
            const bool is_live = W == 1 || c != null_index;
            const std::uint32_t own = W == 1 ? any : is_live ? core.manifolds[c].flags : 0;
            const MixedSurface surface = is_live ? surface_of(core, c) : MixedSurface{};
            const bool special = W == 1 || (own & contact_special) != 0;  // a block of one contact is read only if it is special
            r.restitution[i] = (own & contact_bouncy) != 0 ? surface.restitution : 0;
            if (!has_surfaces) continue;
            r.rolling_resistance[i] = special ? surface.rolling_resistance : 0;
            r.tangent_speed[i] = special ? surface.tangent_speed : 0;
        }
    }
}

inline constexpr std::uint32_t wide_contacts = 4096;  // a batch with so many contacts and joints is solved by all workers together
inline constexpr std::uint32_t contact_grain = 192;   // contacts of a colour, joints of a run, and bodies that are worth a task
inline constexpr std::uint32_t joint_grain = 128;
inline constexpr std::uint32_t slot_grain = 512;

/// One batch. One thread solves it; a wide one is solved by all workers together, stage by stage. Constraints of one colour are independent, and so are bodies
/// while they are integrated, so no result depends on how the workers share them.
template <class K>
struct BatchSolve {
    using Rows = typename K::Rows;
    static constexpr std::uint32_t W = K::W;

    Solve& s;
    Batch& batch;
    bool wide;
    Rows* first_row;  // of the batch's first block
    ContactRows<1>* overflow = s.overflow + batch.first_overflow;
    std::uint32_t overflow_count = batch.end_overflow - batch.first_overflow;

    Rows* row(std::uint32_t block) const { return first_row + (block - batch.first_block[0]); }

    template <class Work>
    void over(std::uint32_t count, std::uint32_t grain, Work&& work) {
        if (has_threads && wide) {
            for_ranges(s.core, count, grain, work);
        } else if (count > 0) {
            work(0u, count);
        }
    }

    /// Calls work(first, end) for the slots of the batch's bodies.
    template <class Work>
    void over_bodies(Work&& work) {
        over(batch.body_count, slot_grain, [&](std::uint32_t first, std::uint32_t end) { work(batch.first_slot + first, batch.first_slot + end); });
    }

    /// Calls work(first block, end block, colour), colour by colour: contacts of one colour share no body that can be pushed.
    template <class Work>
    void over_colors(Work&& work) {
        for (std::uint32_t left = s.plan.colors; left != 0; left &= left - 1) {
            const auto c = static_cast<std::uint32_t>(__builtin_ctz(left));
            const std::uint32_t begin = batch.first_block[c];
            over(batch.first_block[c + 1] - begin, contact_grain / W, [&](std::uint32_t first, std::uint32_t end) { work(begin + first, begin + end, c); });
        }
    }

    /// Calls work(part of the run, its rows). A run without a colour is one part.
    template <class Work>
    void over_run(const JointRun& r, Work&& work) {
        if (!has_threads || !wide || r.color == no_color) return work(r, s.joint_rows + r.offset);
        JointRun block = r;
        block.blocks = 1;
        const std::size_t block_bytes = joint_run_bytes_of(block, W);
        over(r.blocks, joint_grain / W, [&](std::uint32_t first, std::uint32_t end) {
            JointRun part = r;
            part.first += first * W;
            part.blocks = end - first;
            work(part, s.joint_rows + r.offset + first * block_bytes);
        });
    }

    std::uint32_t link_count() const { return has_joints ? batch.link_count : 0; }
    /// Sweeps would change nothing.
    bool is_idle() const {
        const std::uint32_t blocks = batch.first_block[color_count] - batch.first_block[0], runs = batch.end_run - batch.first_run;
        return (blocks | overflow_count | runs | link_count()) == 0 && !(s.numbers.tolerance > 0);
    }

    void run();
    void prepare();
    void sweep(const SweepNumbers& dynamic, const SweepNumbers& ground, const JointSweep& joints);
    void sweeps(std::uint32_t most, const SweepNumbers& dynamic, const SweepNumbers& ground, const JointSweep& joints);
    float measure(const SweepNumbers& dynamic, const SweepNumbers& ground, const JointSweep& joints);
    void try_joints(const JointRun& r, const JointSweep& joints);
    void hold() {
        if (s.core.state->locked_count != 0) over_bodies([&](std::uint32_t first, std::uint32_t end) { hold_locked(s, first, end); });
    }
    void store();
};

template <class K>
void BatchSolve<K>::prepare() {
    over_bodies([&](std::uint32_t first, std::uint32_t end) { gather_bodies(s, first, end); });
    const PrepareInput in{s.core.manifolds, s.core.poses, s.plan.slot_of, s.bodies, s.motions, s.numbers.step};
    over_colors([&](std::uint32_t first, std::uint32_t end, std::uint32_t) {
        name_contacts(s.core, row(first), end - first, s.plan.contacts + std::size_t{first} * W);
        K::prepare(in, row(first), end - first);
    });
    name_contacts(s.core, overflow, overflow_count, s.plan.contacts + std::size_t{s.plan.block_count} * W + batch.first_overflow);
    ContactKernel<1>::prepare(in, overflow, overflow_count);

    const JointInput joints{s.core.joints, s.core.poses, s.core.bodies, s.plan.slot_of, s.bodies, s.numbers.step};
    if (link_count() != 0) prepare_trees(s.plan, batch, s.links, joints, s.motions);
    for (std::uint32_t i = batch.first_run; i < batch.end_run; ++i) {
        const JointRun& r = s.plan.runs[i];
        over_run(r, [&](const JointRun& part, std::byte* blocks) { prepare_joint_run(part, W, blocks, s.plan.joints + part.first, joints); });
    }
}

// One sweep: first the constraints without a colour, then the colours in order, in each joints before contacts. The colours of contacts with static bodies come
// last, and joint trees after them, so that their hinges hold when positions are integrated. (A ball of 100 link masses that falls on a stack with its chain
// tears the hinges apart by 121 mm if trees come before the contacts, and by 6 mm if they come after.)
template <class K>
void BatchSolve<K>::sweep(const SweepNumbers& dynamic, const SweepNumbers& ground, const JointSweep& joints) {
    std::uint32_t run = batch.first_run;
    for (; run < batch.end_run && s.plan.runs[run].color == no_color; ++run) {
        const JointRun& r = s.plan.runs[run];
        solve_joint_run(r, 1, s.bodies, s.joint_rows + r.offset, joints);
    }
    if (!s.numbers.is_ordered && overflow_count != 0) ContactKernel<1>::solve(s.bodies, overflow, overflow_count, dynamic);
    for (std::uint32_t left = s.plan.colors; left != 0; left &= left - 1) {
        const auto c = static_cast<std::uint32_t>(__builtin_ctz(left));
        for (; run < batch.end_run && s.plan.runs[run].color == c; ++run) {
            const JointRun& r = s.plan.runs[run];
            over_run(r, [&](const JointRun& part, std::byte* blocks) { solve_joint_run(part, W, s.bodies, blocks, joints); });
        }
        const std::uint32_t begin = batch.first_block[c];
        const std::uint32_t count = batch.first_block[c + 1] - begin;
        if (count == 0) continue;
        const SweepNumbers& numbers = c < dynamic_color_limit ? dynamic : ground;
        over(count, contact_grain / W, [&](std::uint32_t first, std::uint32_t end) { K::solve(s.bodies, row(begin + first), end - first, numbers); });
    }
    if (has_tuning && s.numbers.is_ordered) solve_in_order(s.bodies, overflow, overflow_count, dynamic, ground, s.core.state->solver.block_contacts != 0);
    if (link_count() != 0) solve_trees(s.bodies, s.links + batch.first_link, link_count(), joints);
    hold();
}

// The largest residual of the batch's islands. (Joint trees leave none: they are solved last, and exactly.)
template <class K>
float BatchSolve<K>::measure(const SweepNumbers& dynamic, const SweepNumbers& ground, const JointSweep& joints) {
    const std::uint32_t* const island_of = s.plan.island_of;
    for (std::uint32_t slot = batch.first_slot; slot < batch.end_slot(); ++slot)
        if (island_of[slot] != null_index) s.residuals[island_of[slot]] = 0;
    const auto try_contacts = [&](auto kernel, auto& r, const SweepNumbers& numbers) {
        Trial trial(reinterpret_cast<std::byte*>(&r), sizeof r);
        for (const std::uint32_t slot : r.body_a) trial.add(slot);
        for (const std::uint32_t slot : r.body_b) trial.add(slot);
        begin_trial(trial, s.bodies);
        if constexpr (decltype(kernel)::W == 1) {
            const ContactManifold before = *r.manifold;  // has the impulses
            decltype(kernel)::solve(s.bodies, &r, 1, numbers);
            *r.manifold = before;
        } else {
            decltype(kernel)::solve(s.bodies, &r, 1, numbers);
        }
        end_trial(trial, s.bodies, island_of, s.residuals);
    };
    for (std::uint32_t i = 0; i < overflow_count; ++i) {
        ContactRows<1>& r = overflow[i];
        const bool both_move = s.bodies[r.body_a[0]].inv_mass > 0 && s.bodies[r.body_b[0]].inv_mass > 0;
        try_contacts(ContactKernel<1>{}, r, s.numbers.is_ordered && !both_move ? ground : dynamic);
    }
    for (std::uint32_t c = 0; c < color_count; ++c)
        for (std::uint32_t block = batch.first_block[c]; block < batch.first_block[c + 1]; ++block)
            try_contacts(K{}, *row(block), c < dynamic_color_limit ? dynamic : ground);
    for (std::uint32_t i = batch.first_run; i < batch.end_run; ++i) try_joints(s.plan.runs[i], joints);

    float largest = 0;
    for (std::uint32_t slot = batch.first_slot; slot < batch.end_slot(); ++slot)
        if (island_of[slot] != null_index) largest = max(largest, s.residuals[island_of[slot]]);
    return largest;
}

template <class K>
void BatchSolve<K>::try_joints(const JointRun& r, const JointSweep& joints) {
    const std::uint32_t lanes = r.color == no_color ? 1 : W;
    JointRun block = r;
    block.blocks = 1;
    const std::size_t block_bytes = joint_run_bytes_of(block, lanes);
    for (std::uint32_t i = 0; i < r.blocks; ++i) {
        Trial trial(s.joint_rows + r.offset + i * block_bytes, block_bytes);
        const auto add = [&](const Joint& j) {
            trial.add(j.body_a == null_index ? 0 : s.plan.slot_of[j.body_a]);
            trial.add(s.plan.slot_of[j.body_b]);
        };
        for (std::uint32_t lane = 0; lane < lanes; ++lane) {
            const std::uint32_t joint = s.plan.joints[r.first + i * lanes + lane];
            if (joint == null_index) continue;
            const Joint& j = s.core.joints[joint];
            if (r.kernel == JointKernel::gear) {
                add(s.core.joints[j.joint1]);
                add(s.core.joints[j.joint2]);
            } else {
                add(j);
            }
        }
        begin_trial(trial, s.bodies);
        solve_joint_run(block, lanes, s.bodies, trial.rows, joints);
        end_trial(trial, s.bodies, s.plan.island_of, s.residuals);
    }
}

// Makes so many sweeps, or fewer if the tolerance is reached before.
template <class K>
void BatchSolve<K>::sweeps(std::uint32_t most, const SweepNumbers& dynamic, const SweepNumbers& ground, const JointSweep& joints) {
    if (is_idle()) {
        batch.sweeps += most;
        return;
    }
    for (std::uint32_t i = 0; i < most; ++i) {
        sweep(dynamic, ground, joints);
        ++batch.sweeps;
        if (has_tuning && s.numbers.tolerance > 0 && measure(dynamic, ground, joints) <= s.numbers.tolerance) return;
    }
}

template <class K>
void BatchSolve<K>::store() {
    const std::uint32_t begin = batch.first_block[0];
    over(batch.first_block[color_count] - begin, 4 * contact_grain / W, [&](std::uint32_t first, std::uint32_t end) {
        K::store(s.core.manifolds, row(begin + first), end - first);
        if (has_hits && s.hits != nullptr) note_hits(s.core.manifolds, row(begin + first), end - first, s.hits);
    });
    ContactKernel<1>::store(s.core.manifolds, overflow, overflow_count);
    if (has_hits && s.hits != nullptr) note_hits(s.core.manifolds, overflow, overflow_count, s.hits);
    over_bodies([&](std::uint32_t first, std::uint32_t end) { scatter_bodies(s, first, end); });
    const JointOutput out{s.core.joints, s.core.bodies, s.bodies, s.numbers.step.dt, s.numbers.step.h, s.numbers.step.warm};
    if (link_count() != 0) store_trees(s.links + batch.first_link, link_count(), out);
    for (std::uint32_t i = batch.first_run; i < batch.end_run; ++i) {
        const JointRun& r = s.plan.runs[i];
        over_run(r, [&](const JointRun& part, std::byte* blocks) { store_joint_run(part, W, blocks, out); });
    }
}

template <class K>
void BatchSolve<K>::run() {
    const SolverState& def = s.core.state->solver;
    prepare();
    for (std::uint32_t substep = 0; substep < def.substeps; ++substep) {
        over_bodies([&](std::uint32_t first, std::uint32_t end) { integrate_velocities(s, first, end, substep == 0); });
        hold();
        const bool relaxes = is_soft(def) && def.relax_iterations > 0;
        const bool measures = has_tuning && s.residuals != nullptr && substep + 1 == def.substeps;
        sweeps(def.iterations, s.numbers.biased, s.numbers.ground, s.numbers.biased_joints);
        if (measures && !relaxes) measure(s.numbers.biased, s.numbers.ground, s.numbers.biased_joints);
        over_bodies([&](std::uint32_t first, std::uint32_t end) { integrate_positions(s, first, end); });
        if (!relaxes) continue;
        sweeps(def.relax_iterations, s.numbers.relaxed, s.numbers.relaxed, s.numbers.relaxed_joints);
        if (measures) measure(s.numbers.relaxed, s.numbers.relaxed, s.numbers.relaxed_joints);
    }
    const float threshold = s.numbers.step.restitution_threshold;
    ContactKernel<1>::restitute(s.bodies, overflow, overflow_count, threshold);
    over_colors([&](std::uint32_t first, std::uint32_t end, std::uint32_t) { K::restitute(s.bodies, row(first), end - first, threshold); });
    hold();
    store();
}

// Solves wide batches one after another, each by all workers, and then the others side by side, each by one worker.
//
// Neighbouring batches form a share, one for each worker, with about the same number of rows each. A batch needs its rows only while it is solved, so the
// batches of a share take turns in the same memory, which stays in the core's cache. If there is no room for the largest batch once a share, each batch has
// rows of its own.
template <class K>
void solve_batches(Solve& s) {
    using Rows = typename K::Rows;
    auto* const rows = reinterpret_cast<Rows*>(s.blocks);
    const auto blocks_of = [](const Batch& b) { return b.first_block[color_count] - b.first_block[0]; };
    const auto is_wide = [&](const Batch& b) {
        if (!has_workers(s.core)) return false;
        std::uint32_t weight = blocks_of(b) * K::W;
        for (std::uint32_t i = b.first_run; i < b.end_run; ++i) weight += s.plan.runs[i].blocks * K::W;
        return weight >= wide_contacts;
    };
    std::uint32_t largest = 0, narrow = 0;
    std::uint32_t total = 0;  // of blocks: times the number of shares it still is a 32-bit number
    const std::uint32_t first_batch = s.plan.batches[kinematic_batch].body_count == 0 ? kinematic_batch + 1 : kinematic_batch;
    for (std::uint32_t i = first_batch; i < s.plan.batch_count; ++i) {
        Batch& b = s.plan.batches[i];
        if (is_wide(b)) {
            BatchSolve<K>{s, b, true, rows + b.first_block[0]}.run();
        } else {
            largest = largest > blocks_of(b) ? largest : blocks_of(b);
            total += blocks_of(b) + 1;
            ++narrow;
        }
    }
    // One share a worker: with four shares, many_pyramids takes 4.9 instead of 4.6 ms a step on two workers.
    const std::uint32_t shares = worker_count(s.core) < narrow ? worker_count(s.core) : narrow;
    const bool take_turns = std::uint64_t{shares} * largest <= s.plan.block_count;
    for_ranges(s.core, shares, 1, [&](std::uint32_t first, std::uint32_t end) {
        std::uint32_t before = 0;
        for (std::uint32_t i = first_batch; i < s.plan.batch_count; ++i) {
            Batch& b = s.plan.batches[i];
            if (is_wide(b)) continue;
            const std::uint32_t share = before * shares / total;
            before += blocks_of(b) + 1;
            if (share >= first && share < end) BatchSolve<K>{s, b, false, rows + (take_turns ? share * largest : b.first_block[0])}.run();
        }
    });
}

// Takes room for the rows of every run of joints, and notes where each run's begin.
std::byte* place_joint_rows(const Plan& plan, std::uint32_t lanes, Arena& arena) {
    std::size_t bytes = 0;
    for (std::uint32_t i = 0; i < plan.run_count; ++i) {
        JointRun& r = plan.runs[i];
        r.offset = bytes;
        bytes += joint_run_bytes_of(r, lanes);
        bytes = (bytes + 63) / 64 * 64;
    }
    return arena.take<std::byte>(bytes);
}

// Reports to each body its island's residual; bodies that were not solved have none.
void report_residuals(Core& core, const Plan& plan, const float* residuals) {
    core.report.residual = 0;
    for (std::uint32_t i = 0; i < core.state->body_pool.high_water; ++i) core.residuals[i] = 0;
    for (std::uint32_t slot = 1; slot < plan.slot_count; ++slot) {
        if (plan.island_of[slot] == null_index) continue;
        const float residual = residuals[plan.island_of[slot]];
        core.residuals[plan.body_of[slot]] = residual;
        core.report.residual = max(core.report.residual, residual);
    }
}

}  // namespace

SolverMotion* take_motions(Core& core, Arena& arena) {
    const std::uint32_t count = core.state->body_pool.high_water + 1;
    auto* const late = reinterpret_cast<std::byte*>(core.hit_events);
    // A fleet lends its worlds scratch that lies elsewhere.
    if (reinterpret_cast<std::byte*>(core.residuals) + align_up(core.capacity.bodies * sizeof(float)) != core.scratch) return arena.take<SolverMotion>(count);
    const std::size_t bytes = count * sizeof(SolverMotion), room = static_cast<std::size_t>(core.scratch - late);
    if (bytes > room) arena.take<std::byte>(bytes - room);
    return reinterpret_cast<SolverMotion*>(late);
}

SolverBody* solve(Core& core, const Plan& plan, SolverMotion* motions, Arena& arena, float dt) {
    Solve s{core, plan, choose_numbers(*core.state, dt)};
    s.bodies = arena.take<SolverBody>(plan.slot_count);
    s.motions = motions;
    s.bodies[0] = SolverBody{};
    s.motions[0] = SolverMotion{};
    if (has_tuning && measures_residual(core.state->solver)) s.residuals = arena.take<float>(plan.island_count);
    if (has_hits && (core.state->asked & shape_hit_events) != 0) s.hits = arena.take<Hit>(core.state->contact_pool.high_water);
    Arena rows = arena;  // the rows are not read after the solve
    s.blocks = rows.take<std::byte>(std::size_t{plan.block_count} * core.lanes * row_bytes);
    s.overflow = rows.take<ContactRows<1>>(plan.overflow_count);
    s.joint_rows = place_joint_rows(plan, core.lanes, rows);
    s.links = rows.take<TreeLink>(plan.link_count);
    with_lanes(core.lanes, [&](auto lanes) { solve_batches<ContactKernel<lanes>>(s); });
    core.state->last_substep = s.numbers.step.h;
    if (has_shock(core.state->solver)) restore_impulses(core, plan.lightness, arena);
    core.has_residuals = s.residuals != nullptr;
    if (s.residuals != nullptr) report_residuals(core, plan, s.residuals);
    if (has_hits && s.hits != nullptr) report_hits(core, s.hits);
    return s.bodies;
}

}  // namespace islet::detail
