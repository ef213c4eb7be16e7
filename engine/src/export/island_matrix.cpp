// M = J M_b^-1 J^T of an exported island. A body of n rows couples them all with each other, so the work and the entries grow with n^2; what is short is
// the list of constraints on a body, of which a row's columns are merged.
#include "../exact.hpp"

#include "../export/island_problem.hpp"
#include "../graph/joint_graph.hpp"

namespace islet::detail {

namespace {

// Lists the bodies of the island that a constraint's rows can have entries for, each once.
std::uint32_t bodies_of_constraint(const IslandRows& rows, const std::uint32_t (&ends)[4], std::uint32_t* out) {
    std::uint32_t n = 0;
    for (const std::uint32_t body : ends) {
        if (body == null_index || !(rows.core.poses[body].inv_mass > 0)) continue;
        const std::uint32_t place = rows.members.place_of[body];
        bool known = false;
        for (std::uint32_t i = 0; i < n; ++i) known = known || out[i] == place;
        if (!known) out[n++] = place;
    }
    return n;
}

// Calls visit(constraint) for each constraint that shares a body with this one, itself included, in ascending order.
template <class Visit>
void for_each_neighbor(const IslandConstraints& l, std::uint32_t constraint, Visit&& visit) {
    std::uint32_t at[4] = {}, end[4] = {};
    const std::uint32_t first = l.first_body[constraint], lists = l.first_body[constraint + 1] - first;
    for (std::uint32_t i = 0; i < lists; ++i) {
        at[i] = l.first_constraint[l.bodies[first + i]];
        end[i] = l.first_constraint[l.bodies[first + i] + 1];
    }
    for (;;) {
        std::uint32_t lowest = null_index;
        for (std::uint32_t i = 0; i < lists; ++i)
            if (at[i] < end[i] && l.constraints[at[i]] < lowest) lowest = l.constraints[at[i]];
        if (lowest == null_index) return;
        for (std::uint32_t i = 0; i < lists; ++i)
            if (at[i] < end[i] && l.constraints[at[i]] == lowest) ++at[i];
        visit(lowest);
    }
}

// The constraints of each body, from the bodies of each constraint: count, sum up, place.
void list_by_body(IslandConstraints& l, std::uint32_t bodies) {
    std::memset(l.first_constraint, 0, (std::size_t{bodies} + 2) * 4);
    std::uint32_t* const next = l.first_constraint + 1;  // while placing, where the body's next constraint goes
    for (std::uint32_t k = 0; k < l.first_body[l.count]; ++k) ++next[l.bodies[k] + 1];
    for (std::uint32_t b = 0; b < bodies; ++b) next[b + 1] += next[b];
    for (std::uint32_t constraint = 0; constraint < l.count; ++constraint)
        for (std::uint32_t k = l.first_body[constraint]; k < l.first_body[constraint + 1]; ++k) l.constraints[next[l.bodies[k]]++] = constraint;
}

}  // namespace

IslandConstraints list_constraints(IslandRows& counter, Arena& arena) {
    const Core& core = counter.core;
    const IslandMembers& members = counter.members;
    IslandConstraints l;
    l.first_row = arena.take<std::uint32_t>(std::size_t{members.constraint_count} + 1);
    l.first_body = arena.take<std::uint32_t>(std::size_t{members.constraint_count} + 1);
    const std::size_t ends = std::size_t{members.contacts.count()} * 2 + std::size_t{members.joints.count()} * 4;
    l.bodies = arena.take<std::uint32_t>(ends);
    l.constraints = arena.take<std::uint32_t>(ends);
    l.first_constraint = arena.take<std::uint32_t>(std::size_t{members.body_count} + 2);

    l.first_body[0] = 0;
    const auto add = [&](std::uint32_t first_row, const std::uint32_t(&of)[4]) {
        l.first_row[l.count] = first_row;
        l.first_body[l.count + 1] = l.first_body[l.count] + bodies_of_constraint(counter, of, l.bodies + l.first_body[l.count]);
        ++l.count;
    };
    members.joints.for_each([&](std::uint32_t i) {
        const std::uint32_t first_row = counter.count;
        add_joint_rows(counter, i);
        add(first_row, bodies_of(core, core.joints[i]).body);
    });
    members.contacts.for_each([&](std::uint32_t i) {
        const std::uint32_t first_row = counter.count;
        add_contact_rows(counter, i);
        add(first_row, {core.manifolds[i].body_a, core.manifolds[i].body_b, null_index, null_index});
    });
    l.first_row[l.count] = counter.count;
    list_by_body(l, members.body_count);
    return l;
}

std::uint64_t count_entries(const IslandConstraints& l, std::uint64_t most) {
    std::uint64_t entries = 0;
    for (std::uint32_t constraint = 0; constraint < l.count && entries <= most; ++constraint) {
        std::uint64_t width = 0;
        for_each_neighbor(l, constraint, [&](std::uint32_t other) { width += l.first_row[other + 1] - l.first_row[other]; });
        entries += (l.first_row[constraint + 1] - l.first_row[constraint]) * width;
    }
    return entries;
}

void write_matrix(const IslandRows& made, const IslandConstraints& l, std::uint32_t* row_starts, std::uint32_t* columns, float* values) {
    std::uint32_t at = 0;
    for (std::uint32_t constraint = 0; constraint < l.count; ++constraint) {
        for (std::uint32_t i = l.first_row[constraint]; i < l.first_row[constraint + 1]; ++i) {
            row_starts[i] = at;
            for_each_neighbor(l, constraint, [&](std::uint32_t other) {
                for (std::uint32_t k = l.first_row[other]; k < l.first_row[other + 1]; ++k, ++at) {
                    // Always of the lower row and the higher, in this order: symmetric to the last bit.
                    columns[at] = k;
                    values[at] = made.coupling(made.rows[i < k ? i : k], made.rows[i < k ? k : i]) + (i == k ? made.rows[i].softness : 0);
                }
            });
        }
    }
    row_starts[made.count] = at;
}

}  // namespace islet::detail
