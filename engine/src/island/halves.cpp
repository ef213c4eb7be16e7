#include "../exact.hpp"

#include "../island/halves.hpp"

#include <cstring>

#include "../data/parallel.hpp"
#include "../math/key_sort.hpp"

#if ISLET_THREADS && ISLET_MAX_LANES > 1  // as has_halves; a build that keeps all functions does without these

namespace islet::detail {

namespace {

inline constexpr std::uint32_t halved_contacts = 2048;  // touching, in all, that make halves pay
inline constexpr std::uint32_t sampled_bodies = 64;     // whose places say where a batch is cut
inline constexpr std::uint32_t cut_grain = 16;          // words of 64 bodies that are worth a task

/// A contact with a colour.
struct ColoredContact {
    std::uint32_t body_a, body_b;
    std::uint32_t listed;  // its place in the list
};

/// The contacts of a list that have a colour, in the order of colours.
struct ColorOrder {
    ColoredContact* contacts;
    std::uint32_t end[color_count];  // of each colour

    ColorOrder(const Core& core, const ContactList& list, std::uint32_t count, Arena& temporary) : contacts(temporary.take<ColoredContact>(count)) {
        std::uint32_t next[max_plan_parts][color_count] = {};  // by part: how many there are; once laid out, the next one's place
        const auto over_list = [&](auto&& visit) {
            for_ranges(core, list.parts(), 1, [&](std::uint32_t first_part, std::uint32_t end_part) {
                for (std::uint32_t p = first_part; p < end_part; ++p) {
                    for (std::uint32_t k = list.first[p]; k < list.end[p]; ++k) {
                        const std::uint32_t color = list.contacts[k].color & ~listed_landing;
                        if (color != no_color) visit(next[p][color], k);
                    }
                }
            });
        };
        over_list([](std::uint32_t& contacts_of, std::uint32_t) { ++contacts_of; });
        std::uint32_t at = 0;
        for (std::uint32_t c = 0; c < color_count; ++c) {
            for (std::uint32_t p = 0; p < list.parts(); ++p) at = lay_out(next[p][c], at);
            end[c] = at;
        }
        over_list([&](std::uint32_t& to, std::uint32_t k) { contacts[to++] = {list.contacts[k].body_a, list.contacts[k].body_b, k}; });
    }
};

std::uint32_t largest_batch(const Plan& plan) {
    std::uint32_t largest = 0;
    for (std::uint32_t b = 1; b < plan.batch_count; ++b)
        if (plan.batches[b].body_count > plan.batches[largest].body_count) largest = b;
    return largest;
}

// Whether two workers gain by halves of the batch, and there is room for the halves and for the padding of their blocks.
bool is_worth_halves(const Core& core, const Plan& plan, std::uint32_t batch) {
    const SolverState& solver = core.state->solver;
    if (worker_count(core) != 2 || core.block_lanes() == 1 || is_ordered(solver) || has_shock(solver) || measures_residual(solver)) return false;
    const std::uint32_t bodies = plan.batches[batch].body_count;
    const std::size_t rows = std::size_t{plan.touching_count} + std::size_t{plan.batch_count + 2} * color_count * core.block_lanes();
    return bodies >= halved_bodies && 4 * bodies >= plan.slot_count && plan.touching_count >= halved_contacts && rows <= row_capacity(core.capacity);
}

}  // namespace

BodyHalves cut_in_halves(const Core& core, Plan& plan, const Islands& found, Arena& temporary) {
    const std::uint32_t batch = largest_batch(plan);
    if (!is_worth_halves(core, plan, batch)) return {};
    const auto is_in_batch = [&](std::uint32_t body) { return found.island_of[body] != null_index && found.batch_of(body) == batch; };
    const BitSet awake = core.awake_bodies;

    float along[2][sampled_bodies];
    std::uint32_t sampled = 0, to_pass = 0;
    awake.for_each([&](std::uint32_t body) {
        if (sampled == sampled_bodies || !is_in_batch(body) || to_pass-- != 0) return;
        to_pass = plan.batches[batch].body_count / sampled_bodies;
        along[0][sampled] = core.poses[body].center.x;
        along[1][sampled++] = core.poses[body].center.y;
    });
    for (float* axis : {along[0], along[1]}) sort_by_gaps(axis, sampled, [](float x, float y) { return x < y; });
    const auto spread = [&](const float* axis) { return axis[sampled - 1 - sampled / 16] - axis[sampled / 16]; };
    const bool cut_across_x = spread(along[0]) >= spread(along[1]);
    const float cut = along[cut_across_x ? 0 : 1][sampled / 2];

    const std::uint32_t bodies = core.state->body_pool.high_water;
    const BodyHalves halves{batch, temporary.take<std::uint8_t>(bodies)};
    std::memset(halves.of, BodyHalves::none, bodies);
    for_ranges(core, awake.word_count, cut_grain, [&](std::uint32_t first, std::uint32_t end) {
        awake.for_each_in(first, end, [&](std::uint32_t body) {
            const Vec2 center = core.poses[body].center;
            if (is_in_batch(body)) halves.of[body] = (cut_across_x ? center.x : center.y) < cut ? 0 : 1;
        });
    });
    plan.halved_batch = batch;
    plan.batches[plan.batch_count] = plan.batches[plan.batch_count + 1] = Batch{};
    return halves;
}

void halve_contacts(const Core& core, const Plan& plan, const BodyHalves& halves, const ContactList& list, const PlannedConstraint* joints, Arena temporary) {
    const std::uint32_t bodies = core.state->body_pool.high_water;
    std::uint8_t* const waits_from = temporary.take<std::uint8_t>(bodies);  // by body: the colour from which on its contacts wait
    std::memset(waits_from, color_count, bodies);
    const auto wait = [&](std::uint32_t body, std::uint32_t color) {
        if (waits_from[body] > color) waits_from[body] = static_cast<std::uint8_t>(color);
    };
    for (std::uint32_t k = 0; k < plan.joint_count; ++k) {
        const std::uint32_t color = joints[k].color & 0xffu;
        if (color == no_color) continue;
        if (joints[k].body_a != null_index) wait(joints[k].body_a, color);
        wait(joints[k].body_b, color);
    }
    const ColorOrder order(core, list, plan.touching_count, temporary);
    for (std::uint32_t color = 0, i = 0; color < color_count; ++color) {
        for (; i < order.end[color]; ++i) {
            const auto [body_a, body_b, listed] = order.contacts[i];
            const std::uint8_t a = halves.of[body_a], b = halves.of[body_b];
            const bool in_a = a != BodyHalves::none, in_b = b != BodyHalves::none;
            if (!in_a && !in_b) continue;
            if ((in_a && in_b && a != b) || (in_a && waits_from[body_a] <= color) || (in_b && waits_from[body_b] <= color)) {
                wait(body_a, color);
                wait(body_b, color);
            } else {
                list.contacts[listed].color |= (std::uint32_t{in_a ? a : b} + 1) << listed_half_shift;
            }
        }
    }
}

}  // namespace islet::detail

#endif
