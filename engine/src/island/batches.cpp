#include "../exact.hpp"

#include "../island/batches.hpp"

#include "../constraint/joint_runs.hpp"
#include "../data/parallel.hpp"
#include "../graph/colors.hpp"
#include "../island/halves.hpp"
#include "../island/height_order.hpp"
#include "../island/joint_trees.hpp"
#include "../island/union_find.hpp"
#include "../memory/place.hpp"

namespace islet::detail {

namespace {

/// Sets of connected bodies, by body. Bodies that connect nothing have the parent null_index: static and kinematic ones, and those at rest.
struct ConnectedBodies : UnionFind {
    BitSet guided;  // bodies that touch a kinematic one or are joined to one

    std::uint32_t parent_of(std::uint32_t i) const { return i != null_index ? up_from(i) : null_index; }

    static bool guides(const Core& core, std::uint32_t by) { return by != null_index && core.is_awake(by); }
    void guide(const Core& core, std::uint32_t body, std::uint32_t by) const {
        if (guides(core, by)) guided.set(body);
    }

    void connect(const Core& core, std::uint32_t a, std::uint32_t b) const {
        const std::uint32_t over_a = parent_of(a), over_b = parent_of(b);
        if (over_a == over_b) return;  // connected already, as most are; or neither connects anything
        if (over_a == null_index) return guide(core, b, a);
        if (over_b == null_index) return guide(core, a, b);
        join(root_of(over_a), root_of(over_b));
    }

#if ISLET_SHARES_WORDS
    void guide_at_once(const Core& core, std::uint32_t body, std::uint32_t by) const {
        if (guides(core, by)) set_at_once(guided, body);
    }

    /// The same by one of several threads.
    void connect_at_once(const Core& core, std::uint32_t a, std::uint32_t b) const {
        const SharedUnionFind shared{{parent}};
        const std::uint32_t over_a = parent_of(a), over_b = parent_of(b);
        if (over_a == over_b) return;
        if (over_a == null_index) return guide_at_once(core, b, a);
        if (over_b == null_index) return guide_at_once(core, a, b);
        shared.join(over_a, over_b);
    }
#endif
};

inline constexpr std::uint32_t word_grain = 16;   // words of 64 bodies that are worth a task
inline constexpr std::uint32_t listed_grain = 4;  // words of 64 joints

// A listed joint's colour has its kernel and two flags above it.
inline constexpr std::uint32_t listed_kernel_shift = 8;
inline constexpr std::uint32_t listed_exact = 1u << 30;
inline constexpr std::uint32_t listed_gear = 1u << 31;

// Marks the awake bodies of joint trees, by a slot that is not 0, until they are given their own. Returns whether there are any.
bool mark_trees(const Core& core, Plan& plan) {
    if (!has_joints || core.state->exact_joints == 0) return false;
    bool any = false;
    core.awake_joints.for_each([&](std::uint32_t i) {
        const Joint& j = core.joints[i];
        if ((j.flags & joint_exact) == 0) return;
        any = true;
        for (const std::uint32_t body : {j.body_a, j.body_b})
            if (is_positive(core.poses[body].inv_mass)) plan.slot_of[body] = 1;
    });
    return any;
}

// True if a constraint is swept beside a joint tree: it is solved by itself then, and softer (solve_numbers.hpp says why).
bool is_beside_tree(const Plan& plan, std::uint32_t body_a, std::uint32_t body_b) {
    return plan.slot_of[body_b] != 0 || (body_a != null_index && plan.slot_of[body_a] != 0);  // a mouse joint has no A
}

// The colour of a contact as it is listed.
std::uint32_t listed_color(const Plan& plan, const ContactManifold& m) {
    const std::uint32_t color = m.color();
    if (plan.has_trees && color >= dynamic_color_limit && is_beside_tree(plan, m.body_a, m.body_b)) return no_color;
    return color | ((m.flags & contact_ahead) != 0 && color != no_color ? listed_landing : 0);
}

// Lists the touching contacts, in the order in which they are to be solved, and connects their bodies.
ContactList list_contacts(const Core& core, Plan& plan, const ConnectedBodies& sets, Arena& temporary) {
    const BitSet awake = core.awake_contacts;
    ContactList list;
    PlannedConstraint* const contacts = list.contacts = temporary.take<PlannedConstraint>(core.state->contact_pool.count);
    list.end_word[0] = awake.word_count;
    if (has_workers(core) && !is_ordered(core.state->solver) && !has_shock(core.state->solver)) list.cut(awake, plan_parts(core.capacity));
    for_ranges(core, list.parts(), 1, [&](std::uint32_t part, std::uint32_t) {
        std::uint32_t at = list.first[part], colors = 0, any_lands = 0;
        awake.for_each_in(list.first_word(part), list.end_word[part], [&](std::uint32_t i) {
            const ContactManifold& m = core.manifolds[i];
            if ((m.flags & contact_touching) == 0) return;
            const std::uint32_t color = listed_color(plan, m);
            contacts[at++] = {i, m.body_a, m.body_b, {color}};
            colors |= 1u << (color & ~listed_landing) % color_count;
            any_lands |= color & listed_landing;
        });
        list.end[part] = at;
        list.colors[part] = colors;
        list.lands[part] = any_lands != 0;
#if ISLET_SHARES_WORDS
        if (!shares_words(core)) return;
        for (std::uint32_t k = list.first[part]; k < at; ++k) sets.connect_at_once(core, contacts[k].body_a, contacts[k].body_b);
#endif
    });
    if (!shares_words(core)) list.for_each([&](const PlannedConstraint& c) { sets.connect(core, c.body_a, c.body_b); });
    for (std::uint32_t p = 0; p < list.parts(); ++p) plan.touching_count += list.end[p] - list.first[p];
    if (has_shock(core.state->solver)) {
        lighten_by_height(core, contacts, list.end[0], plan.lightness, temporary);
        for (std::uint32_t k = 0; k < list.end[0]; ++k) contacts[k].color = listed_color(plan, core.manifolds[contacts[k].index]);
    }
    if (is_ordered(core.state->solver)) put_in_order(core, contacts, list.end[0]);
    return list;
}

// Puts the contacts in the order of batches and colours: counts them, lays out whole blocks, and places them. batch_of(contact) says which batch.
template <class BatchOf>
void plan_contacts(const Core& core, Plan& plan, const ContactList& list, BatchOf&& batch_of, Arena temporary) {
    constexpr std::uint32_t places = color_count + 1;  // per batch, the last for contacts without a colour
    const std::uint32_t lanes = core.block_lanes();
    const std::uint32_t batches = plan.batch_count + plan.half_count();
    const std::size_t part_size = std::size_t{batches} * places;
    // By part and place: how many contacts there are; once laid out, the next one's index. Those that land come before the others of their place: each part is
    // placed in two passes, and where there are several, those that land are counted apart, because those of all parts come first.
    const auto take_counts = [&] { return temporary.take<std::uint32_t>(part_size * list.parts()); };
    std::uint32_t* const next = take_counts();
    std::uint32_t* const next_landing = list.parts() > 1 && list.any_lands() ? take_counts() : next;
    for_ranges(core, list.parts(), 1, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t p = first; p < end; ++p) {
            std::uint32_t *const count = next + p * part_size, *const count_landing = next_landing + p * part_size;
            std::memset(count, 0, part_size * 4);
            if (count_landing != count) std::memset(count_landing, 0, part_size * 4);
            for (std::uint32_t k = list.first[p]; k < list.end[p]; ++k) {
                PlannedConstraint& c = list.contacts[k];
                const std::uint32_t color = c.color & 0xffu, lands = c.color & listed_landing;
                const std::uint32_t half = has_halves ? (c.color & ~listed_landing) >> listed_half_shift : 0;
                const std::uint32_t batch = half == 0 ? batch_of(c) : plan.batch_count + half - 1;
                const std::uint32_t place = batch * places + (color == no_color ? color_count : color);
                c.place = place | lands;
                ++(lands != 0 ? count_landing : count)[place];
            }
        }
    });

    std::uint32_t block = 0;
    std::uint32_t overflow = 0;
    std::uint32_t colors = 0;  // that contacts may have
    for (std::uint32_t p = 0; p < list.parts(); ++p) colors |= list.colors[p];
    const auto lay_out_parts = [&](std::size_t place, std::uint32_t start) {
        for (std::uint32_t p = 0; next_landing != next && p < list.parts(); ++p) start = lay_out(next_landing[p * part_size + place], start);
        for (std::uint32_t p = 0; p < list.parts(); ++p) start = lay_out(next[p * part_size + place], start);
        return start;
    };
    for (std::uint32_t b = 0; b < batches; ++b) {
        Batch& batch = plan.batches[b];
        std::uint32_t next_color = 0;
        const auto begin_up_to = [&](std::uint32_t color) {
            for (; next_color <= color; ++next_color) batch.first_block[next_color] = static_cast<PlanIndex>(block);
        };
        for (std::uint32_t left = batch.body_count != 0 || b >= plan.batch_count ? colors : 0; left != 0; left &= left - 1) {
            const auto c = trailing_zeros(left);
            begin_up_to(c);
            const std::uint32_t end = lay_out_parts(std::size_t{b} * places + c, block * lanes);
            if (end == block * lanes) continue;
            plan.colors |= 1u << c;
            block = (end + lanes - 1) / lanes;
            for (std::uint32_t i = end; i < block * lanes; ++i) plan.contacts[i] = no_plan_index;
        }
        begin_up_to(color_count);
        batch.first_overflow = static_cast<PlanIndex>(overflow);
        overflow = lay_out_parts(std::size_t{b} * places + color_count, overflow);
        batch.end_overflow = static_cast<PlanIndex>(overflow);
    }
    plan.block_count = block;
    plan.overflow_count = overflow;

    PlanIndex* const overflows = plan.contacts + std::size_t{block} * lanes;
    for_ranges(core, list.parts(), 1, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t p = first; p < end; ++p) {
            std::uint32_t *const at = next + p * part_size, *const at_landing = next_landing + p * part_size;
            for (std::uint32_t k = list.first[p]; list.lands[p] && k < list.end[p]; ++k) {
                const PlannedConstraint& c = list.contacts[k];
                if ((c.place & listed_landing) != 0) plan.contacts[at_landing[c.place & ~listed_landing]++] = static_cast<PlanIndex>(c.index);
            }
            for (std::uint32_t k = list.first[p]; k < list.end[p]; ++k) {
                const PlannedConstraint& c = list.contacts[k];
                if ((c.place & listed_landing) != 0) continue;
                (c.place % places == color_count ? overflows : plan.contacts)[at[c.place]++] = static_cast<PlanIndex>(c.index);
            }
        }
    });
}

// Puts the joints in the order of batches, colours and kernels: counts them, lays out runs of whole blocks, and places them. Joints without a colour come
// first in their batch, in blocks of one.
template <class BatchOf>
void plan_joints(const Core& core, Plan& plan, PlannedConstraint* joints, BatchOf&& batch_of, Arena temporary) {
    constexpr std::uint32_t places = (color_count + 1) * joint_kernel_count;  // per batch
    if (!has_joints || plan.joint_count == 0) return;
    std::uint32_t* next = temporary.take<std::uint32_t>(std::size_t{plan.batch_count} * places);  // by place, as in plan_contacts
    for (std::uint32_t b = 0; b < plan.batch_count; ++b)
        if (plan.batches[b].body_count != 0) std::memset(next + std::size_t{b} * places, 0, places * 4);
    std::uint32_t colors = 0;  // that joints have
    for (std::uint32_t k = 0; k < plan.joint_count; ++k) {
        PlannedConstraint& j = joints[k];
        const std::uint32_t color = j.color & 0xffu, kernel = j.color >> listed_kernel_shift & 0xffu;
        j.place = batch_of(j) * places + (color == no_color ? 0u : color + 1) * joint_kernel_count + kernel;
        ++next[j.place];
        if (color == no_color) {
            ++plan.overflow_joints;
        } else {
            colors |= 1u << color;
        }
    }
    plan.colors |= colors;
    std::uint32_t at = 0;
    for (std::uint32_t b = 0; b < plan.batch_count; ++b) {
        plan.batches[b].first_run = static_cast<PlanIndex>(plan.run_count);
        for (std::uint32_t group = 0; plan.batches[b].body_count != 0 && group <= color_count; ++group) {  // without a colour, then colour by colour
            const bool overflow = group == 0;
            if (overflow ? plan.overflow_joints == 0 : (colors >> (group - 1) & 1) == 0) continue;
            const std::uint32_t lanes = overflow ? 1 : core.block_lanes();
            for (std::uint32_t kernel = 0; kernel < joint_kernel_count; ++kernel) {
                const std::uint32_t count = lay_out(next[b * places + group * joint_kernel_count + kernel], at) - at;
                if (count == 0) continue;
                const std::uint32_t blocks = (count + lanes - 1) / lanes;
                plan.runs[plan.run_count++] = {static_cast<JointKernel>(kernel), overflow ? no_color : group - 1, at, blocks};
                for (std::uint32_t i = count; i < blocks * lanes; ++i) plan.joints[at + i] = null_index;
                at += blocks * lanes;
            }
        }
        plan.batches[b].end_run = static_cast<PlanIndex>(plan.run_count);
    }
    for (std::uint32_t k = 0; k < plan.joint_count; ++k) plan.joints[next[joints[k].place]++] = joints[k].index;
}

// Takes the plan's arrays; they are filled later.
Plan take_plan(const Core& core, Arena& arena) {
    const std::uint32_t bodies = core.state->body_pool.high_water;
    Plan plan;
    plan.slot_of = arena.take_last<PlanIndex>(bodies);
    plan.body_of = arena.take_last<PlanIndex>(bodies + 1);
    if (keeps_islands) plan.island_of = arena.take_last<PlanIndex>(bodies + 1);
    plan.batches = arena.take_last<Batch>(place_capacity(core.capacity));
    plan.contacts = arena.take_last<PlanIndex>(row_capacity(core.capacity));
    plan.joints = arena.take_last<std::uint32_t>(joint_row_capacity(core.capacity));
    plan.runs = arena.take_last<JointRun>(joint_run_capacity(core.capacity));
    plan.links = arena.take_last<PlannedLink>(tree_capacity(core.capacity));
    plan.parent_links = arena.take_last<std::uint32_t>(tree_capacity(core.capacity));
    if (has_shock(core.state->solver)) plan.lightness = arena.take_last<float>(bodies);
    return plan;
}

// Every body by itself: in slot 0, and in a set of its own if it is awake and can be pushed.
ConnectedBodies separate_bodies(const Core& core, Plan& plan, Arena& temporary) {
    const std::uint32_t bodies = core.state->body_pool.high_water;
    const auto words = static_cast<std::uint32_t>(words_for(bodies));
    const ConnectedBodies sets{{temporary.take<std::uint32_t>(bodies)}, {temporary.take<std::uint64_t>(words), words}};
    for_ranges(core, words, word_grain, [&](std::uint32_t first, std::uint32_t end) {
        const std::uint32_t begin = 64 * first;
        const std::size_t count = (64 * end < bodies ? 64 * end : bodies) - begin;
        std::memset(plan.slot_of + begin, 0, count * sizeof(PlanIndex));
        std::memset(sets.parent + begin, 0xff, count * 4);
        std::memset(sets.guided.words + first, 0, std::size_t{end - first} * 8);
        core.awake_bodies.for_each_in(first, end, [&](std::uint32_t body) {
            if (is_positive(core.poses[body].inv_mass)) sets.parent[body] = body;
        });
    });
    return sets;
}

// A gear's row reads the four bodies of its two joints. Only two of them are the gear's own.
void connect_gear(const Core& core, const ConnectedBodies& sets, const Joint& gear) {
    const std::uint32_t moving = sets.parent_of(gear.body_a) != null_index ? gear.body_a : gear.body_b;
    for (const std::uint32_t joint : {gear.joint1, gear.joint2}) {
        sets.connect(core, moving, core.joints[joint].body_a);
        sets.connect(core, moving, core.joints[joint].body_b);
    }
}

// A joint as it is listed.
PlannedConstraint listed(const Plan& plan, std::uint32_t i, const Joint& j) {
    const bool alone = plan.has_trees && is_beside_tree(plan, j.body_a, j.body_b);
    std::uint32_t word = (alone ? std::uint32_t{no_color} : j.color()) | static_cast<std::uint32_t>(kernel_of(j)) << listed_kernel_shift;
    if ((j.flags & joint_exact) != 0) word |= listed_exact;
    if (j.joint_type() == JointType::gear) word |= listed_gear;
    return {i, j.body_a, j.body_b, {word}};
}

// Connects the bodies of awake joints, and lists the joints to be swept. The others are solved exactly, in joint trees.
PlannedConstraint* list_joints(const Core& core, Plan& plan, const ConnectedBodies& sets, Arena& temporary) {
    if (!has_joints) return nullptr;
    PlannedConstraint* joints = temporary.take<PlannedConstraint>(core.state->joint_pool.count);
    const BitSet awake = core.awake_joints;
    const auto visit = [&](std::uint32_t first, std::uint32_t end, auto&& take) ISLET_INLINED_LAMBDA {
        awake.for_each_in(first, end, [&](std::uint32_t i) ISLET_INLINED_LAMBDA {
            const Joint& j = core.joints[i];
            if (sets.parent_of(j.body_a) == null_index && sets.parent_of(j.body_b) == null_index) return;  // both have become static or kinematic
            take(listed(plan, i, j));
        });
    };
    const auto take = [&](PlannedConstraint j) ISLET_INLINED_LAMBDA {
        ++plan.awake_joints;
        if ((j.color & listed_gear) != 0) connect_gear(core, sets, core.joints[j.index]);
        if ((j.color & listed_exact) == 0) joints[plan.joint_count++] = j;
    };
    const auto connect_and_take = [&](const PlannedConstraint& j) ISLET_INLINED_LAMBDA {
        sets.connect(core, j.body_a, j.body_b);
        take(j);
    };
    if (!has_workers(core)) {
        visit(0, awake.word_count, connect_and_take);
        return joints;
    }
    // Workers list the joints by parts, and connect their bodies; then they are taken in order.
    const RangeCut<max_plan_parts> parts(core, awake.word_count, listed_grain);
    std::uint32_t first_of[max_plan_parts] = {}, end_of[max_plan_parts] = {};
    for (std::uint32_t p = 1; p < parts.count; ++p) first_of[p] = first_of[p - 1] + awake.count_in((p - 1) * parts.grain, p * parts.grain);
    for_ranges(core, awake.word_count, parts.grain, [&](std::uint32_t first, std::uint32_t end) {
        std::uint32_t at = first_of[parts.of(first)];
        visit(first, end, [&](const PlannedConstraint& j) {
            joints[at++] = j;
#if ISLET_SHARES_WORDS
            if (shares_words(core)) sets.connect_at_once(core, j.body_a, j.body_b);
#endif
        });
        end_of[parts.of(first)] = at;
    });
    for (std::uint32_t p = 0; p < parts.count; ++p)
        for (std::uint32_t k = first_of[p]; k < end_of[p]; ++k) shares_words(core) ? take(joints[k]) : connect_and_take(joints[k]);
    return joints;
}

#if ISLET_SHARES_WORDS
// What number_islands does, by parts of the bodies: workers find each body's root and count the roots, number the roots, and give their numbers to the others.
void number_at_once(const Core& core, Plan& plan, const ConnectedBodies& sets, Islands& found, const RangeCut<max_plan_parts>& parts) {
    const BitSet awake = core.awake_bodies;
    const auto words = static_cast<std::uint32_t>(words_for(core.state->body_pool.high_water));
    std::uint32_t roots[max_plan_parts], kinematic[max_plan_parts];
    for_ranges(core, words, parts.grain, [&](std::uint32_t first, std::uint32_t end) {
        std::uint32_t root_count = 0, kinematic_count = 0;
        awake.for_each_in(first, end, [&](std::uint32_t body) {
            if (sets.up_from(body) == null_index) {
                found.island_of[body] = null_index;
                ++kinematic_count;
                return;
            }
            // Shortens no other body's path: that could undo what its own thread stores.
            std::uint32_t root = body;
            for (std::uint32_t up = sets.up_from(root); up != root; up = sets.up_from(root)) root = up;
            __atomic_store_n(sets.parent + body, root, __ATOMIC_RELAXED);
            if (root == body) ++root_count;
        });
        roots[parts.of(first)] = root_count;
        kinematic[parts.of(first)] = kinematic_count;
    });
    for (std::uint32_t p = 0; p < parts.count; ++p) {
        const std::uint32_t number = plan.island_count;
        plan.island_count += roots[p];
        roots[p] = number;  // the first of the part's
        found.kinematic_count += kinematic[p];
    }
    for_ranges(core, words, parts.grain, [&](std::uint32_t first, std::uint32_t end) {
        std::uint32_t number = roots[parts.of(first)];
        awake.for_each_in(first, end, [&](std::uint32_t body) {
            if (sets.parent[body] != body) return;
            found.islands[number] = Island{};
            found.island_of[body] = number++;
        });
    });
    for_ranges(core, words, parts.grain, [&](std::uint32_t first, std::uint32_t end) {
        // Neighbours are often of one island, which is then counted in one go.
        std::uint32_t counted = null_index, count = 0;
        const auto add = [&] {
            if (count != 0) __atomic_fetch_add(&found.islands[counted].bodies, count, __ATOMIC_RELAXED);
        };
        awake.for_each_in(first, end, [&](std::uint32_t body) {
            const std::uint32_t root = sets.parent[body];
            if (root == null_index) return;
            const std::uint32_t number = found.island_of[root];
            if (root != body) found.island_of[body] = number;
            if (number != counted) {
                add();
                counted = number;
                count = 0;
            }
            ++count;
            if (sets.guided.test(body)) __atomic_store_n(&found.islands[number].batch, std::uint32_t{kinematic_batch}, __ATOMIC_RELAXED);
        });
        add();
    });
}
#endif

// Numbers the islands by their roots and counts their bodies. A root is the smallest body of its island, so one pass in order is enough.
Islands number_islands(const Core& core, Plan& plan, const ConnectedBodies& sets, Arena& temporary) {
    const std::uint32_t bodies = core.state->body_pool.high_water;
    Islands found{temporary.take<Island>(bodies), temporary.take<std::uint32_t>(bodies), 0};
#if ISLET_SHARES_WORDS
    const RangeCut<max_plan_parts> parts(core, static_cast<std::uint32_t>(words_for(bodies)), word_grain);
    if (parts.count > 1 && shares_words(core)) {
        number_at_once(core, plan, sets, found, parts);
        return found;
    }
#endif
    core.awake_bodies.for_each([&](std::uint32_t body) {
        if (sets.parent[body] == null_index) {
            found.island_of[body] = null_index;
            ++found.kinematic_count;
            return;
        }
        const std::uint32_t root = sets.root_of(body);
        if (root == body) {
            found.islands[plan.island_count] = Island{};
            found.island_of[body] = plan.island_count++;
        }
        const std::uint32_t number = found.island_of[body] = found.island_of[root];
        Island& island = found.islands[number];
        ++island.bodies;
        if (sets.guided.test(body)) island.batch = kinematic_batch;
    });
    return found;
}

// Puts the islands into batches, in order, and decides which slots each batch has. No two batches share a moving body (kinematic_batch says how). The
// number of workers has no say: residuals are measured batch by batch.
void fill_batches(Plan& plan, const Islands& found) {
    plan.batches[kinematic_batch] = plan.batches[1] = Batch{};
    plan.batches[kinematic_batch].body_count = static_cast<PlanIndex>(found.kinematic_count);
    std::uint32_t batch = 1;
    for (std::uint32_t i = 0; i < plan.island_count; ++i) {
        Island& island = found.islands[i];
        if (island.batch != kinematic_batch) island.batch = batch;
        PlanIndex& count = plan.batches[island.batch].body_count;
        count = static_cast<PlanIndex>(count + island.bodies);
        if (plan.batches[batch].body_count >= batch_bodies) plan.batches[++batch] = Batch{};
    }
    plan.batch_count = batch + 1;
    plan.slot_count = 1;
    for (std::uint32_t b = 0; b < plan.batch_count; ++b) {
        plan.batches[b].first_slot = static_cast<PlanIndex>(plan.slot_count);
        plan.slot_count += plan.batches[b].body_count;
    }
}

// Gives the batches' slots to their bodies, in the order of the bodies.
void give_slots(const Core& core, Plan& plan, const Islands& found, const BodyHalves& halves, Arena temporary) {
    const BitSet awake = core.awake_bodies;
    const auto words = static_cast<std::uint32_t>(words_for(core.state->body_pool.high_water));
    const RangeCut<max_plan_parts> parts(core, words, word_grain);
    const std::uint32_t batches = plan.batch_count + plan.half_count();
    std::uint32_t* next = temporary.take<std::uint32_t>(std::size_t{batches} * parts.count);  // slot, by part and batch, or half
    const auto batch_of = [&](std::uint32_t body) {
        const std::uint32_t island = found.island_of[body], batch = island != null_index ? found.islands[island].batch : kinematic_batch;
        return has_halves && batch == halves.batch ? halves.place_of(plan, body) : batch;
    };
    if (parts.count > 1 || plan.half_count() != 0) {
        for_ranges(core, words, parts.grain, [&](std::uint32_t first, std::uint32_t end) {
            std::uint32_t* const count = next + parts.of(first) * batches;
            std::memset(count, 0, batches * 4);
            awake.for_each_in(first, end, [&](std::uint32_t body) { ++count[batch_of(body)]; });
        });
        const auto lay_out_parts = [&](std::uint32_t b, std::uint32_t slot) {
            for (std::uint32_t p = 0; p < parts.count; ++p) slot = lay_out(next[p * batches + b], slot);
            return slot;
        };
        for (std::uint32_t b = 0; b < plan.batch_count; ++b) {
            std::uint32_t slot = plan.batches[b].first_slot;
            if (!has_halves || b != halves.batch) {
                lay_out_parts(b, slot);
                continue;
            }
            for (std::uint32_t place = plan.batch_count; place < batches; ++place) {
                Batch& half = plan.batches[place];
                half.first_slot = static_cast<PlanIndex>(slot);
                slot = lay_out_parts(place, slot);
                half.body_count = static_cast<PlanIndex>(slot - half.first_slot);
            }
        }
    } else {
        for (std::uint32_t b = 0; b < plan.batch_count; ++b) next[b] = plan.batches[b].first_slot;
    }
    plan.body_of[0] = no_plan_index;
    for_ranges(core, words, parts.grain, [&](std::uint32_t first, std::uint32_t end) {
        std::uint32_t* const at = next + parts.of(first) * batches;
        awake.for_each_in(first, end, [&](std::uint32_t body) {
            const std::uint32_t island = found.island_of[body], slot = at[batch_of(body)]++;
            plan.body_of[slot] = static_cast<PlanIndex>(body);
            if (keeps_islands) plan.island_of[slot] = static_cast<PlanIndex>(island);
            plan.slot_of[body] = static_cast<PlanIndex>(slot);
        });
    });
}

}  // namespace

Plan make_plan(const Core& core, Arena& arena) {
    Plan plan = take_plan(core, arena);
    Arena temporary = arena;  // what is taken from it serves this function alone: the solve takes the same scratch again

    const ConnectedBodies sets = separate_bodies(core, plan, temporary);
    plan.has_trees = mark_trees(core, plan);
    const ContactList contacts = list_contacts(core, plan, sets, temporary);
    PlannedConstraint* const joints = list_joints(core, plan, sets, temporary);

    const Islands islands = number_islands(core, plan, sets, temporary);
    fill_batches(plan, islands);
    BodyHalves halves;
    if constexpr (has_halves) halves = cut_in_halves(core, plan, islands, temporary);
    give_slots(core, plan, islands, halves, temporary);

    // At least one body of a constraint can be pushed; its batch is the constraint's.
    const bool one_batch = plan.batch_count == kinematic_batch + 2 && plan.batches[kinematic_batch].body_count == 0;
    const auto batch_of = [&](const PlannedConstraint& c) {
        return one_batch ? kinematic_batch + 1 : islands.batch_of(sets.parent_of(c.body_a) != null_index ? c.body_a : c.body_b);
    };
    if constexpr (has_halves)
        if (plan.half_count() != 0) halve_contacts(core, plan, halves, contacts, joints, temporary);
    plan_contacts(core, plan, contacts, batch_of, temporary);
    plan_joints(core, plan, joints, batch_of, temporary);
    if (plan.has_trees) plan_links(core, plan, islands, temporary);
    return plan;
}

Plan kept_or_new_plan(Core& core, Arena& arena) {
    if (Plan* const kept = core.kept.plan) {
        for (std::uint32_t b = 0; b < kept->batch_count; ++b) kept->batches[b].sweeps = 0;
        return *kept;
    }
    const Plan plan = make_plan(core, arena);
    if (keeps_plan && core.owns_scratch() && !is_ordered(core.state->solver) && !has_shock(core.state->solver))
        core.kept.keep(new (arena.take_last<Plan>(1), IsletPlace{}) Plan(plan));
    return plan;
}

}  // namespace islet::detail
