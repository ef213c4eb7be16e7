#include "islands.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace islet::lab {
namespace {

/// A row's Jacobian for one body.
struct Entry {
    std::uint32_t row;
    double x, y, angular;
};

bool of_contact(RowKind kind) { return kind == RowKind::normal || kind == RowKind::friction || kind == RowKind::rolling; }

/// Whether two rows stand for the same contact or joint.
bool together(const IslandRow& a, const IslandRow& b) { return of_contact(a.kind) == of_contact(b.kind) && a.slot == b.slot; }

/// M = J M_b^-1 J^T + softness, row by row: rows meet in the bodies that both see.
void fill_matrix(const IslandProblem& exported, Problem& problem) {
    std::vector<std::vector<Entry>> of_body(exported.bodies.size());
    for (std::uint32_t i = 0; i < exported.rows.size(); ++i) {
        for (const RowEnd& end : std::span(exported.rows[i].ends).first(exported.rows[i].end_count)) {
            if (end.body != no_body) of_body[end.body].push_back({i, double(end.linear.x), double(end.linear.y), double(end.angular)});
        }
    }
    for (std::uint32_t i = 0; i < exported.rows.size(); ++i) {
        const IslandRow& row = exported.rows[i];
        std::map<std::uint32_t, double> sums;
        sums[i] = double(row.softness);
        for (const RowEnd& end : std::span(row.ends).first(row.end_count)) {
            if (end.body == no_body) continue;
            const IslandBody& body = exported.bodies[end.body];
            const double x = double(end.linear.x), y = double(end.linear.y), angular = double(end.angular);
            for (const Entry& other : of_body[end.body])
                sums[other.row] += double(body.inv_mass) * (x * other.x + y * other.y) + double(body.inv_inertia) * angular * other.angular;
        }
        for (const auto& [column, value] : sums) {
            problem.columns.push_back(column);
            problem.values.push_back(value);
        }
        problem.row_starts.push_back(static_cast<std::uint32_t>(problem.values.size()));
    }
}

/// q = J v_free + bias.
double free_motion(const IslandProblem& exported, const IslandRow& row) {
    double sum = double(row.bias);
    for (const RowEnd& end : std::span(row.ends).first(row.end_count)) {
        if (end.body == no_body) continue;
        const IslandBody& body = exported.bodies[end.body];
        sum += double(end.linear.x) * double(body.v_free.x) + double(end.linear.y) * double(body.v_free.y) +
               double(end.angular) * double(body.w_free);
    }
    return sum;
}

}  // namespace

Problem problem_of(const IslandProblem& exported) {
    Problem problem;
    fill_matrix(exported, problem);
    for (const IslandRow& row : exported.rows) problem.q.push_back(free_motion(exported, row));
    problem.lo.assign(exported.lcp.lo.begin(), exported.lcp.lo.end());
    problem.hi.assign(exported.lcp.hi.begin(), exported.lcp.hi.end());
    problem.friction.assign(exported.lcp.friction.begin(), exported.lcp.friction.end());
    if (problem.friction.empty()) problem.friction.assign(problem.rows(), lcp::no_row);
    problem.warm.assign(exported.impulses.begin(), exported.impulses.end());
    for (std::uint32_t i = 0; i < exported.rows.size(); ++i) {
        const bool begins = i == 0 || !together(exported.rows[i - 1], exported.rows[i]) || i - problem.blocks.back() == lcp::max_block_rows;
        if (begins) problem.blocks.push_back(i);
    }
    return problem;
}

std::vector<Island> islands_of(const World& world, float h) {
    std::vector<Island> islands;
    std::vector<bool> seen(world.capacity().bodies, false);
    std::vector<std::byte> memory;
    for (std::uint32_t slot = 0; slot < world.capacity().bodies; ++slot) {
        const BodyId body = world.body_at(slot);
        if (!body || seen[slot] || world.type(body) != BodyType::dynamic) continue;
        IslandProblem exported;
        const std::size_t needed = world.export_island(body, h, memory, exported);
        if (needed > memory.size()) {
            memory.resize(needed);
            world.export_island(body, h, memory, exported);
        }
        for (const IslandBody& member : exported.bodies) seen[member.id.index1 - 1] = true;
        if (exported.rows.empty()) continue;
        Island island;
        island.h = double(h);
        island.bodies = exported.bodies.size();
        island.problem = problem_of(exported);
        for (std::size_t i = 0; i < exported.rows.size(); ++i) {
            if (i > 0 && together(exported.rows[i - 1], exported.rows[i])) continue;
            ++(of_contact(exported.rows[i].kind) ? island.contacts : island.joints);
        }
        islands.push_back(std::move(island));
    }
    std::stable_sort(islands.begin(), islands.end(), [](const Island& a, const Island& b) { return a.problem.rows() > b.problem.rows(); });
    for (std::size_t i = 0; i < islands.size(); ++i) islands[i].index = i;
    return islands;
}

}  // namespace islet::lab
