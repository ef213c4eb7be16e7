// The solve of one batch of islands. Only solver.cpp includes this, and the namespace without a name lets the compiler know that.
#pragma once

#include "../constraint/kernels.hpp"
#include "../data/parallel.hpp"
#include "../graph/colors.hpp"
#include "../island/contact_names.hpp"
#include "../math/lanes.hpp"
#include "../math/scalar.hpp"
#include "../solver/hits.hpp"
#include "../solver/joint_solve.hpp"
#include "../solver/ordered_sweep.hpp"
#include "../solver/solve_context.hpp"
#include "../solver/solver_bodies.hpp"
#include "../solver/sweep_residual.hpp"
#include "../solver/tree_solve.hpp"

namespace islet::detail {

namespace {

inline constexpr std::uint32_t contact_grain = 192;  // contacts of a colour, joints of a run, and bodies that are worth a task
inline constexpr std::uint32_t joint_grain = 128;
static_assert(contact_grain % (2 * max_block_lanes) == 0 && joint_grain % (2 * max_block_lanes) == 0);  // with_rows says why
inline constexpr std::uint32_t slot_grain = 512;

/// One batch. One thread solves it; a wide one is solved by all workers together, stage by stage. Constraints of one colour are independent, and so are bodies
/// while they are integrated, so no result depends on how the workers share them.
template <std::uint32_t lanes>
struct BatchSolve {
    static constexpr std::uint32_t W = lanes < max_block_lanes ? lanes : max_block_lanes;  // contacts in a block
    using K = ContactKernel<W>;
    using Rows = typename K::Rows;
    using One = LoneKernel<W>;

    Solve& s;
    Batch& batch;
    bool wide;
    Rows* first_row;  // of the batch's first block
    ContactRows<1>* overflow = s.overflow + batch.first_overflow;
    std::uint32_t overflow_count = batch.end_overflow - batch.first_overflow;
    std::uint32_t lone_colors = 0;  // bits of those with one contact, which has a row by itself: it costs less than a block that is mostly padding
    /// Of a narrow batch without joints, bits of the colours at which a piece begins: blocks that lie side by side and are solved alike, and so in one go,
    /// whatever their colours. 0: all blocks are solved colour by colour.
    std::uint32_t piece_colors = 0;
    ContactKinds has = {};                                    // contacts of these kinds
    bool bounces = false;                                     // a contact was given its rebound
    bool is_idle = false;                                     // sweeps would change nothing
    std::uint32_t landing_end[W > 1 ? color_count : 1] = {};  // of the colours' blocks with contacts that land, in landing()
    /// Two, or null: together they have all bodies, and the contacts that do not wait. The batch itself has the other constraints (island/halves.hpp).
    BatchSolve* halves = nullptr;

    bool has_halves() const { return W > 1 && detail::has_halves && halves != nullptr; }
    /// Calls work(half) for the batch's halves, if it has any.
    template <class Work>
    void over_halves(Work&& work) {
        if (!has_halves()) return;
        for_ranges(s.core, 2, 1, [&](std::uint32_t first, std::uint32_t end) {
            for (std::uint32_t i = first; i < end; ++i) work(halves[i]);
        });
    }

    PlanIndex* landing() const { return s.landing + batch.first_block[0]; }
    /// Says that something is so of the batch, which other workers may be saying, too.
    void note(bool& something, bool is_so) const {
        if (!is_so) return;
#if ISLET_THREADS
        __atomic_store_n(&something, true, __ATOMIC_RELAXED);
#else
        something = true;
#endif
    }
    void note(ContactKinds found) {
        note(has.lands, found.lands);
        note(has.bounces, found.bounces);
    }

    Rows* row(std::uint32_t block) const { return first_row + (block - batch.first_block[0]); }
    // In place of the block.
    ContactRows<1>* lone_row(std::uint32_t block) const { return reinterpret_cast<ContactRows<1>*>(row(block)); }
    bool is_lone(std::uint32_t color) const { return W > 1 && (lone_colors >> color & 1) != 0; }
    bool is_lightened() const;
    void find_lone_colors();
    void find_pieces();
    void find_landing();

    /// Calls work(kernel, its rows, how many, first block) for some of a colour's blocks. Sixteen lanes solve them two by two, and one that is left over by
    /// itself; so the parts of a colour must begin at even blocks of it, as they do where workers share it.
    template <class Work>
    void with_rows(std::uint32_t color, std::uint32_t first, std::uint32_t end, Work&& work) {
        if constexpr (W > 1)
            if (is_lone(color)) return work(One{}, lone_row(first), 1u, first);
        if constexpr (lanes > W) {
            using Wide = ContactKernel<lanes>;
            const std::uint32_t pairs = (end - first) / 2;
            if (pairs != 0) work(Wide{}, reinterpret_cast<typename Wide::Rows*>(row(first)), pairs, first);
            first += 2 * pairs;
            if (first == end) return;
        }
        work(K{}, row(first), end - first, first);
    }

    /// Blocks that one call of with_rows solves at once, and where those of a colour end that begin with `block`.
    static constexpr std::uint32_t step_of_blocks = lanes > W ? 2 : 1;
    std::uint32_t end_of_step(std::uint32_t color, std::uint32_t block) const {
        const std::uint32_t end = batch.first_block[color + 1];
        return end - block < step_of_blocks ? end : block + step_of_blocks;
    }
    /// Calls work(first, end) for ranges of `count` items: of blocks, which stay together two by two (with_rows says why), or of what `unit` says.
    template <class Work>
    void over(std::uint32_t count, std::uint32_t grain, Work&& work, std::uint32_t unit = lanes > W ? 2 : 1) {
        if (has_threads && wide) {
            if (has_many_workers(s.core)) grain = range_count(grain, 2);
            for_ranges(s.core, count, count > grain ? fair_grain(s.core, count, grain, unit) : grain, work);
        } else if (count > 0) {
            work(0u, count);
        }
    }

    /// Calls work(first, end) for the slots of the batch's bodies.
    template <class Work>
    void over_bodies(Work&& work) {
        if (has_halves()) return over_halves([&](BatchSolve& half) { work(half.batch.first_slot, half.batch.end_slot()); });
        over(
            batch.body_count, slot_grain, [&](std::uint32_t first, std::uint32_t end) { work(batch.first_slot + first, batch.first_slot + end); },
            layout_lanes);
    }

    /// Calls work(first block, end block, colour), colour by colour: contacts of one colour share no body that can be pushed.
    template <class Work>
    void over_colors(Work&& work) {
        for (std::uint32_t left = s.plan.colors; left != 0; left &= left - 1) {
            const auto c = trailing_zeros(left);
            const std::uint32_t begin = batch.first_block[c];
            over(batch.first_block[c + 1] - begin, contact_grain / W, [&](std::uint32_t first, std::uint32_t end) { work(begin + first, begin + end, c); });
        }
    }

    /// Whether the colour is one block: then it can be part of a longer piece. Of several blocks, two are solved at a time; a lone contact has another kernel.
    bool is_plain(std::uint32_t color) const { return !is_lone(color) && batch.first_block[color + 1] - batch.first_block[color] == 1; }

    /// Calls work(kernel, its rows, how many, first block, colour) piece by piece.
    template <class Work>
    void over_pieces(Work&& work) {
        for (std::uint32_t left = piece_colors; left != 0;) {
            const auto c = trailing_zeros(left);
            left &= left - 1;
            const std::uint32_t first = batch.first_block[c], end = batch.first_block[left != 0 ? trailing_zeros(left) : color_count];
            if (is_plain(c)) {
                work(K{}, row(first), end - first, first, c);
            } else {
                with_rows(c, first, end, [&](auto kernel, auto* rows, std::uint32_t count, std::uint32_t block) { work(kernel, rows, count, block, c); });
            }
        }
    }

    /// Calls work(kernel, its rows, how many, first block) for all blocks.
    template <class Work>
    void over_rows(Work&& work) {
        if constexpr (W > 1)
            if (piece_colors != 0)
                return over_pieces([&](auto kernel, auto* rows, std::uint32_t count, std::uint32_t block, std::uint32_t) { work(kernel, rows, count, block); });
        over_colors([&](std::uint32_t first, std::uint32_t end, std::uint32_t c) { with_rows(c, first, end, work); });
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
    bool has_run(std::uint32_t run) const { return has_joints && run < batch.end_run; }
    bool has_nothing_to_sweep() const {
        const std::uint32_t blocks = batch.first_block[color_count] - batch.first_block[0], runs = batch.end_run - batch.first_run;
        return (blocks | overflow_count | runs | link_count()) == 0 && !has_halves() && !is_positive(s.numbers.tolerance);
    }

    void run();
    void prepare();
    void prepare_contacts();
    void sweep(const SweepNumbers& dynamic, const SweepNumbers& ground, const JointSweep& joints);
    void sweep_colors(const SweepNumbers& dynamic, const SweepNumbers& ground, const JointSweep& joints);
    void land(const SweepNumbers& dynamic, const SweepNumbers& ground);
    void land_colors(const SweepNumbers& dynamic, const SweepNumbers& ground);
    void restitute(float threshold);
    void sweeps(std::uint32_t most, const SweepNumbers& dynamic, const SweepNumbers& ground, const JointSweep& joints);
    float measure(const SweepNumbers& dynamic, const SweepNumbers& ground, const JointSweep& joints);
    void try_joints(const JointRun& r, const JointSweep& joints);
    void hold() {
        if (s.core.state->locked_count != 0) over_bodies([&](std::uint32_t first, std::uint32_t end) { hold_locked(s, first, end); });
    }
    void store();
    void store_contacts();
    void store_joints(bool ends);
};

template <std::uint32_t lanes>
void BatchSolve<lanes>::find_lone_colors() {
    if (W == 1 || s.residuals != nullptr) return;  // a measure tries whole blocks
    for (std::uint32_t left = s.plan.colors; left != 0; left &= left - 1) {
        const auto c = trailing_zeros(left);
        const std::uint32_t begin = batch.first_block[c];
        if (batch.first_block[c + 1] - begin == 1 && s.plan.contacts[std::size_t{begin} * W + 1] == no_plan_index) lone_colors |= 1u << c;
    }
}

// A piece ends where the kernel or its numbers change: contacts with static bodies have others.
template <std::uint32_t lanes>
void BatchSolve<lanes>::find_pieces() {
    if (W == 1 || wide || has_run(batch.first_run)) return;
    bool goes_on = false;
    for (std::uint32_t left = s.plan.colors; left != 0; left &= left - 1) {
        const auto c = trailing_zeros(left);
        if (batch.first_block[c] == batch.first_block[c + 1]) continue;
        const bool first_of_ground = c >= dynamic_color_limit && (piece_colors >> dynamic_color_limit) == 0;
        const bool plain = is_plain(c);
        if (!goes_on || !plain || first_of_ground) piece_colors |= 1u << c;
        goes_on = plain;
    }
}

// Whether shock propagation takes any of the batch's bodies for lighter than it is. What lands among these has no sweeps of its own: it would gain energy.
template <std::uint32_t lanes>
bool BatchSolve<lanes>::is_lightened() const {
    if (!has_shock(s.core.state->solver)) return false;
    for (std::uint32_t slot = batch.first_slot; slot < batch.end_slot(); ++slot)
        if (s.plan.body_of[slot] != no_plan_index && s.plan.lightness[s.plan.body_of[slot]] != 1) return true;
    return false;
}

// Lists the blocks with contacts that land, colour by colour. (Contacts that are solved one by one are looked through instead, which takes no memory.)
template <std::uint32_t lanes>
ISLET_NEVER_INLINE void BatchSolve<lanes>::find_landing() {
    if constexpr (W > 1) {
        std::uint32_t count = 0;
        for (std::uint32_t c = 0; c < color_count; ++c) {
            for (std::uint32_t block = batch.first_block[c]; block < batch.first_block[c + 1]; block += step_of_blocks) {
                with_rows(c, block, end_of_step(c, block), [&](auto, auto* rows, std::uint32_t, std::uint32_t) {
                    if (any_lands(*rows)) landing()[count++] = static_cast<PlanIndex>(block);
                });
            }
            landing_end[c] = count;
        }
    }
}

// Sweeps over the contacts that land, alone.
template <std::uint32_t lanes>
ISLET_NEVER_INLINE void BatchSolve<lanes>::land(const SweepNumbers& dynamic, const SweepNumbers& ground) {
    for (std::uint32_t sweep = 0; sweep < landing_sweeps; ++sweep) {
        for (std::uint32_t i = 0; i < overflow_count; ++i) One::land_again(s.bodies, overflow + i, 1, numbers_alone(s, overflow[i], dynamic, ground));
        over_halves([&](BatchSolve& half) {
            if (half.has.lands) half.land_colors(dynamic, ground);
        });
        land_colors(dynamic, ground);
    }
}

// One sweep over those with a colour.
template <std::uint32_t lanes>
void BatchSolve<lanes>::land_colors(const SweepNumbers& dynamic, const SweepNumbers& ground) {
    for (std::uint32_t left = s.plan.colors; left != 0; left &= left - 1) {
        const auto c = trailing_zeros(left);
        const SweepNumbers& numbers = c < dynamic_color_limit ? dynamic : ground;
        if constexpr (W == 1) {
            const std::uint32_t begin = batch.first_block[c];
            over(batch.first_block[c + 1] - begin, contact_grain,
                 [&](std::uint32_t first, std::uint32_t end) { K::land_again(s.bodies, row(begin + first), end - first, numbers); });
        } else {
            const std::uint32_t begin = c == 0 ? 0 : landing_end[c - 1];
            over(landing_end[c] - begin, contact_grain / W, [&](std::uint32_t first, std::uint32_t end) {
                for (std::uint32_t k = begin + first; k < begin + end; ++k)
                    with_rows(c, landing()[k], end_of_step(c, landing()[k]), [&](auto kernel, auto* rows, std::uint32_t count, std::uint32_t) {
                        decltype(kernel)::land_again(s.bodies, rows, count, numbers);
                    });
            });
        }
    }
}

// Makes the rows of contacts; all bodies of the batch must be gathered.
template <std::uint32_t lanes>
void BatchSolve<lanes>::prepare_contacts() {
    const PrepareInput in = s.input();
    find_lone_colors();
    find_pieces();
    over_rows([&](auto kernel, auto* rows, std::uint32_t count, std::uint32_t block) {
        name_contacts(s.core, rows, count, s.plan.contacts + std::size_t{block} * W);
        note(decltype(kernel)::prepare(in, rows, count));
    });
    if (overflow_count != 0) {
        name_contacts(s.core, overflow, overflow_count, s.plan.contacts + std::size_t{s.plan.block_count} * W + batch.first_overflow);
        note(One::prepare(in, overflow, overflow_count));
    }
    has.lands = has.lands && !is_lightened();
    if (has.lands) find_landing();
}

template <std::uint32_t lanes>
void BatchSolve<lanes>::prepare() {
    over_bodies([&](std::uint32_t first, std::uint32_t end) { gather_bodies(s, first, end); });
    over_halves([&](BatchSolve& half) { half.prepare_contacts(); });
    prepare_contacts();
    for (std::uint32_t i = 0; has_halves() && i < 2; ++i) note(halves[i].has);

    const JointInput joints{s.core.joints, s.core.poses, s.core.bodies, s.plan.slot_of, s.bodies, s.numbers.step};
    if (link_count() != 0) prepare_trees(s.plan, batch, s.links, joints, s.motions);
    for (std::uint32_t i = batch.first_run; has_run(i); ++i) {
        const JointRun& r = s.plan.runs[i];
        over_run(r, [&](const JointRun& part, std::byte* blocks) { prepare_joint_run(part, lanes, blocks, s.plan.joints + part.first, joints); });
    }
}

// One sweep: first the constraints without a colour, then the colours in order, in each joints before contacts. The colours of contacts with static bodies come
// last, and joint trees after them, so that their hinges hold when positions are integrated. (A ball of 100 link masses that falls on a stack with its chain
// tears the hinges apart by 121 mm if trees come before the contacts, and by 6 mm if they come after.)
template <std::uint32_t lanes>
void BatchSolve<lanes>::sweep(const SweepNumbers& dynamic, const SweepNumbers& ground, const JointSweep& joints) {
    std::uint32_t run = batch.first_run;
    for (; has_run(run) && s.plan.runs[run].color == no_color; ++run) {
        const JointRun& r = s.plan.runs[run];
        solve_joint_run(r, 1, s.bodies, s.joint_rows + r.offset, joints);
    }
    if (!s.numbers.is_ordered) solve_alone<One>(s, overflow, overflow_count, dynamic, ground);
    over_halves([&](BatchSolve& half) { half.sweep_colors(dynamic, ground, joints); });
    sweep_colors(dynamic, ground, joints);
    if (has_tuning && s.numbers.is_ordered) solve_in_order(s.bodies, overflow, overflow_count, dynamic, ground, s.core.state->solver.block_contacts != 0);
    if (has.lands) land(dynamic, ground);
    if (link_count() != 0) solve_trees(s.bodies, s.links + batch.first_link, link_count(), s.core.joints, joints);
    hold();
}

// The colours of a sweep.
template <std::uint32_t lanes>
void BatchSolve<lanes>::sweep_colors(const SweepNumbers& dynamic, const SweepNumbers& ground, const JointSweep& joints) {
    std::uint32_t run = batch.first_run;
    while (has_run(run) && s.plan.runs[run].color == no_color) ++run;
    if constexpr (W > 1) {
        over_pieces([&](auto kernel, auto* rows, std::uint32_t count, std::uint32_t, std::uint32_t c) {
            const SweepNumbers& numbers = c < dynamic_color_limit ? dynamic : ground;
            if (is_plain(c)) {
                decltype(kernel)::solve(s.bodies, rows, count, numbers);
            } else {
                solve_color<decltype(kernel)>(s.bodies, rows, count, numbers);
            }
        });
    }
    for (std::uint32_t left = piece_colors == 0 ? s.plan.colors : 0; left != 0; left &= left - 1) {
        const auto c = trailing_zeros(left);
        for (; has_run(run) && s.plan.runs[run].color == c; ++run) {
            const JointRun& r = s.plan.runs[run];
            over_run(r, [&](const JointRun& part, std::byte* blocks) { solve_joint_run(part, lanes, s.bodies, blocks, joints); });
        }
        const std::uint32_t begin = batch.first_block[c];
        const std::uint32_t count = batch.first_block[c + 1] - begin;
        if (count == 0) continue;
        const SweepNumbers& numbers = c < dynamic_color_limit ? dynamic : ground;
        over(count, contact_grain / W, [&](std::uint32_t first, std::uint32_t end) {
            with_rows(c, begin + first, begin + end,
                      [&](auto kernel, auto* rows, std::uint32_t blocks, std::uint32_t) { solve_color<decltype(kernel)>(s.bodies, rows, blocks, numbers); });
        });
    }
}

// The largest residual of the batch's islands. (Joint trees leave none: they are solved last, and exactly.)
template <std::uint32_t lanes>
float BatchSolve<lanes>::measure(const SweepNumbers& dynamic, const SweepNumbers& ground, const JointSweep& joints) {
    const PlanIndex* const island_of = s.plan.island_of;
    for (std::uint32_t slot = batch.first_slot; slot < batch.end_slot(); ++slot)
        if (island_of[slot] != no_plan_index) s.residuals[island_of[slot]] = 0;
    const auto try_contacts = [&](auto kernel, auto& r, const SweepNumbers& numbers) {
        Trial trial(reinterpret_cast<std::byte*>(&r), sizeof r);
        constexpr std::uint32_t width = decltype(kernel)::W;
        for (std::uint32_t i = 0; i < width; ++i) {
            trial.add(r.body_a[i] / slot_scale<width>);
            trial.add(r.body_b[i] / slot_scale<width>);
        }
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
        try_contacts(One{}, r, numbers_alone(s, r, dynamic, ground));
    }
    for (std::uint32_t c = 0; c < color_count; ++c)
        for (std::uint32_t block = batch.first_block[c]; block < batch.first_block[c + 1]; ++block)
            try_contacts(K{}, *row(block), c < dynamic_color_limit ? dynamic : ground);
    for (std::uint32_t i = batch.first_run; has_run(i); ++i) try_joints(s.plan.runs[i], joints);

    float largest = 0;
    for (std::uint32_t slot = batch.first_slot; slot < batch.end_slot(); ++slot)
        if (island_of[slot] != no_plan_index) largest = max(largest, s.residuals[island_of[slot]]);
    return largest;
}

template <std::uint32_t lanes>
void BatchSolve<lanes>::try_joints(const JointRun& r, const JointSweep& joints) {
    const std::uint32_t width = r.color == no_color ? 1 : W;
    JointRun block = r;
    block.blocks = 1;
    const std::size_t block_bytes = joint_run_bytes_of(block, width);
    for (std::uint32_t i = 0; i < r.blocks; ++i) {
        Trial trial(s.joint_rows + r.offset + i * block_bytes, block_bytes);
        for (std::uint32_t lane = 0; lane < width; ++lane) {
            const std::uint32_t joint = s.plan.joints[r.first + i * width + lane];
            if (joint == null_index) continue;
            for (const std::uint32_t body : bodies_of(s.core, s.core.joints[joint]).body)
                if (body != null_index) trial.add(s.plan.slot_of[body]);
        }
        begin_trial(trial, s.bodies);
        solve_joint_run(block, width, s.bodies, trial.rows, joints);
        end_trial(trial, s.bodies, s.plan.island_of, s.residuals);
    }
}

// Makes so many sweeps, or fewer if the tolerance is reached before.
template <std::uint32_t lanes>
void BatchSolve<lanes>::sweeps(std::uint32_t most, const SweepNumbers& dynamic, const SweepNumbers& ground, const JointSweep& joints) {
    if (is_idle) {
        batch.sweeps += most;
        return;
    }
    for (std::uint32_t i = 0; i < most; ++i) {
        sweep(dynamic, ground, joints);
        ++batch.sweeps;
        if (has_tuning && is_positive(s.numbers.tolerance) && measure(dynamic, ground, joints) <= s.numbers.tolerance) return;
    }
}

template <std::uint32_t lanes>
void BatchSolve<lanes>::store_contacts() {
    const auto store_rows = [&](auto kernel, auto* rows, std::uint32_t count, std::uint32_t) ISLET_INLINED_LAMBDA {
        decltype(kernel)::store(s.core.manifolds, rows, count);
        if (has_hits && s.hits != nullptr) note_hits(s.core.manifolds, rows, count, s.hits);
    };
    const std::uint32_t begin = batch.first_block[0];
    if (lanes == W && lone_colors == 0) {
        over(batch.first_block[color_count] - begin, 4 * contact_grain / W,
             [&](std::uint32_t first, std::uint32_t end) { store_rows(K{}, row(begin + first), end - first, begin + first); });
    } else {
        over_rows(store_rows);
    }
    if (overflow_count != 0) One::store(s.core.manifolds, overflow, overflow_count);
    if (has_hits && s.hits != nullptr) note_hits(s.core.manifolds, overflow, overflow_count, s.hits);
}

template <std::uint32_t lanes>
void BatchSolve<lanes>::store() {
    over_halves([&](BatchSolve& half) { half.store_contacts(); });
    store_contacts();
    over_bodies([&](std::uint32_t first, std::uint32_t end) { scatter_bodies(s, first, end); });
    store_joints(true);
}

// Writes back what joints bear at the end of the step, or notes which tear in a substep before.
template <std::uint32_t lanes>
void BatchSolve<lanes>::store_joints(bool ends) {
    const JointOutput out{s.core.joints, s.core.poses, s.core.bodies, s.bodies, s.numbers.step.dt, s.numbers.step.h, s.numbers.step.warm, ends};
    if (link_count() != 0) store_trees(s.links + batch.first_link, link_count(), out);
    for (std::uint32_t i = batch.first_run; has_run(i); ++i) {
        const JointRun& r = s.plan.runs[i];
        over_run(r, [&](const JointRun& part, std::byte* blocks) { store_joint_run(part, lanes, blocks, out); });
    }
}

template <std::uint32_t lanes>
void BatchSolve<lanes>::restitute(float threshold) {
    over_rows(
        [&](auto kernel, auto* rows, std::uint32_t count, std::uint32_t) { note(bounces, decltype(kernel)::restitute(s.bodies, rows, count, threshold)); });
}

template <std::uint32_t lanes>
void BatchSolve<lanes>::run() {
    const SolverState& def = s.core.state->solver;
    const bool tears = has_joints && (s.core.state->asked & asked_breaks) != 0;
    prepare();
    is_idle = has_nothing_to_sweep();
    for (std::uint32_t substep = 0; substep < def.substeps; ++substep) {
        over_bodies([&](std::uint32_t first, std::uint32_t end) { integrate_velocities(s, first, end, substep == 0); });
        hold();
        const bool relaxes = s.numbers.step.relaxes;
        const bool measures = has_tuning && s.residuals != nullptr && substep + 1 == def.substeps;
        sweeps(def.iterations, s.numbers.biased, s.numbers.ground, s.numbers.biased_joints);
        if (measures && !relaxes) measure(s.numbers.biased, s.numbers.ground, s.numbers.biased_joints);
        over_bodies([&](std::uint32_t first, std::uint32_t end) { integrate_positions(s, first, end); });
        if (relaxes) sweeps(def.relax_iterations, s.numbers.relaxed, s.numbers.relaxed, s.numbers.relaxed_joints);
        if (tears && substep + 1 < def.substeps) store_joints(false);
        if (relaxes && measures) measure(s.numbers.relaxed, s.numbers.relaxed, s.numbers.relaxed_joints);
    }
    const float threshold = s.numbers.step.restitution_threshold;
    for (std::uint32_t sweep = 0; sweep < restitution_sweeps && (sweep == 0 ? has.bounces : bounces); ++sweep) {
        if (overflow_count != 0) note(bounces, One::restitute(s.bodies, overflow, overflow_count, threshold));
        over_halves([&](BatchSolve& half) {
            half.restitute(threshold);
            note(bounces, half.bounces);
        });
        restitute(threshold);
    }
    hold();
    store();
}

}  // namespace

}  // namespace islet::detail
