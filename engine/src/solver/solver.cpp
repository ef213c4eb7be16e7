#include "../exact.hpp"

#include "../solver/solver.hpp"

#include "../data/parallel.hpp"
#include "../graph/joint_graph.hpp"
#include "../island/batch_shares.hpp"
#include "../island/height_order.hpp"
#include "../solver/batch_solve.hpp"

namespace islet::detail {

namespace {

inline constexpr std::uint32_t wide_rows = 1024;  // contacts and joints of a batch that all workers may solve together

// Solves wide batches one after another, each by all workers, and then the others side by side, each by one worker. Wide are those that would take longer than
// a worker's fair share.
//
// A batch needs its rows only while it is solved, so the batches that a worker solves take turns in the same memory, which stays in the core's cache. If there
// is no room for the largest batch once a worker, each batch has rows of its own.
template <std::uint32_t lanes>
struct SharedSolve {
    using Solver = BatchSolve<lanes>;
    using Rows = typename Solver::Rows;
    static constexpr std::uint32_t W = Solver::W;
    Solve& s;
    Rows* rows = reinterpret_cast<Rows*>(s.blocks);
    std::uint32_t first_batch = s.plan.batches[kinematic_batch].body_count == 0 ? kinematic_batch + 1 : kinematic_batch;
    std::uint64_t fair = 0;  // weight of all batches, divided by the workers

    static std::uint32_t blocks_of(const Batch& b) { return b.first_block[color_count] - b.first_block[0]; }
    std::uint32_t joints_of(const Batch& b) const {
        std::uint32_t blocks = 0;
        for (std::uint32_t i = b.first_run; i < b.end_run; ++i) blocks += s.plan.runs[i].blocks;
        return blocks * W;
    }
    // Lanes of the blocks with contacts that land. (Among contacts of one colour these come first.)
    std::uint32_t landing_of(const Batch& b) const {
        std::uint32_t all = 0;
        for (std::uint32_t left = s.landing != nullptr ? s.plan.colors : 0; left != 0; left &= left - 1) {
            const auto c = trailing_zeros(left);
            const std::uint32_t first = b.first_block[c] * W, end = b.first_block[c + 1] * W;
            std::uint32_t at = first;
            const auto lands = [&](PlanIndex contact) { return contact != no_plan_index && (s.core.manifolds[contact].flags & contact_ahead) != 0; };
            while (at < end && lands(s.plan.contacts[at])) ++at;
            all += range_count(at - first, lanes) * lanes;
        }
        return all;
    }
    // An estimate of how long the batch takes, in contacts: a joint counts for two, a link of a tree for ten. A lane that lands counts for five, as it is
    // solved again and again. (Measured in seven of the benchmark scenes, which say 3 to 6, on a Zen 5 with sixteen lanes.)
    PlanIndex estimate(const Batch& b) const {
        const std::uint32_t contacts = blocks_of(b) * W + 4 * landing_of(b) + 4 * (b.end_overflow - b.first_overflow);
        const std::uint32_t all = contacts + 2 * joints_of(b) + 10 * b.link_count + b.body_count / 2 + 1;
        return static_cast<PlanIndex>(all < no_plan_index ? all : no_plan_index);
    }
    bool has_halves(const Batch& b) const { return s.plan.half_count() != 0 && &b == s.plan.batches + s.plan.halved_batch; }
    bool is_wide(const Batch& b) const { return has_halves(b) || (blocks_of(b) * W + joints_of(b) >= wide_rows && b.weight > fair); }

    // Solves a batch by all workers, or by one. The rows of one that has halves, and the halves' rows, are in no other batch's memory.
    void run_one(Batch& b, bool wide) {
        Solver whole{s, b, wide, wide || has_halves(b) ? rows + b.first_block[0] : rows};
        if constexpr (W > 1 && detail::has_halves) {
            Batch* const half = s.plan.batches + s.plan.batch_count;
            if (has_halves(b)) {
                Solver halves[] = {{s, half[0], false, rows + half[0].first_block[0]}, {s, half[1], false, rows + half[1].first_block[0]}};
                whole.halves = halves;
                return whole.run();
            }
        }
        whole.run();
    }

    void run() {
        for (std::uint32_t i = first_batch; i < s.plan.batch_count; ++i) fair += s.plan.batches[i].weight = estimate(s.plan.batches[i]);
        fair /= worker_count(s.core);
        std::uint32_t largest = 0, narrow = 0;
        for (std::uint32_t i = first_batch; i < s.plan.batch_count; ++i) {
            Batch& b = s.plan.batches[i];
            if (is_wide(b)) {
                run_one(b, true);
            } else {
                largest = largest > blocks_of(b) ? largest : blocks_of(b);
                ++narrow;
            }
        }
        // One share a worker: with four shares, many_pyramids takes 4.9 instead of 4.6 ms a step on two workers. Many workers get two, which even out.
        const std::uint32_t most = worker_count(s.core) * (has_many_workers(s.core) ? 2 : 1), shares = most < narrow ? most : narrow;
        const bool take_turns = std::uint64_t{shares} * largest <= s.plan.block_count;
        const auto weight_of = [&](std::uint32_t i) -> std::uint32_t { return i < first_batch || is_wide(s.plan.batches[i]) ? 0 : s.plan.batches[i].weight; };
        for_ranges(s.core, shares, 1, [&](std::uint32_t first, std::uint32_t end) {
            share_out(s.plan.batch_count, shares, weight_of, [&](std::uint32_t i, std::uint32_t share) {
                Batch& b = s.plan.batches[i];
                if (share >= first && share < end) Solver{s, b, false, rows + (take_turns ? share * largest : b.first_block[0])}.run();
            });
        });
    }
};

template <std::uint32_t lanes>
void solve_batches(Solve& s) {
    SharedSolve<lanes> shared{s};
    if (has_workers(s.core)) return shared.run();
    for (std::uint32_t i = shared.first_batch; i < s.plan.batch_count; ++i) shared.run_one(s.plan.batches[i], false);
}

// Reports to each body its island's residual; bodies that were not solved have none.
void report_residuals(Core& core, const Plan& plan, const float* residuals) {
    core.report.residual = 0;
    for (std::uint32_t i = 0; i < core.state->body_pool.high_water; ++i) core.residuals[i] = 0;
    for (std::uint32_t slot = 1; slot < plan.slot_count; ++slot) {
        if (plan.island_of[slot] == no_plan_index) continue;
        const float residual = residuals[plan.island_of[slot]];
        core.residuals[plan.body_of[slot]] = residual;
        core.report.residual = max(core.report.residual, residual);
    }
}

}  // namespace

SolverBody* solve(Core& core, const Plan& plan, Arena& arena, float dt) {
    Solve s{core, plan, choose_numbers(*core.state, dt)};
    s.bodies = arena.take_last<SolverBody>(plan.slot_count);
    Arena rows = arena;  // which are not read after the solve
    s.motions = rows.take<SolverMotion>(plan.slot_count);
    s.bodies[0] = SolverBody{};
    s.motions[0] = SolverMotion{};
    if (has_tuning && measures_residual(core.state->solver)) s.residuals = arena.take_last<float>(plan.island_count);
    if (has_hits && (core.state->asked & shape_hit_events) != 0) s.hits = arena.take_last<Hit>(core.state->contact_pool.high_water);
    rows.end = arena.end;
    s.blocks = rows.take<std::byte>(std::size_t{plan.block_count} * core.block_lanes() * row_bytes);
    s.overflow = rows.take<ContactRows<1>>(plan.overflow_count);
    s.joint_rows = place_joint_rows(plan, core.block_lanes(), rows);
    s.links = rows.take<TreeLink>(plan.link_count);
    if (core.block_lanes() > 1) s.landing = rows.take<PlanIndex>(plan.block_count);
    // A measure tries block by block.
    with_lanes<min_lanes, max_lanes>(s.residuals != nullptr ? core.block_lanes() : core.lanes, [&](auto lanes) { solve_batches<lanes>(s); });
    core.state->last_substep = s.numbers.step.h;
    if (has_shock(core.state->solver)) restore_impulses(core, plan.lightness, arena);
    core.has_residuals = s.residuals != nullptr;
    if (s.residuals != nullptr) report_residuals(core, plan, s.residuals);
    if (has_hits && s.hits != nullptr) report_hits(core, s.hits);
    return s.bodies;
}

}  // namespace islet::detail
