// World::export_island: the island that a body is in, as a complementarity problem in the caller's memory.
#include "../exact.hpp"

#include "islet/island.hpp"

#include "../calls/checks.hpp"
#include "../constraint/solver_body.hpp"
#include "../export/island_problem.hpp"
#include "../math/float_mode.hpp"
#include "../math/scalar.hpp"

namespace islet {

using namespace detail;

namespace {

// Everything that is written is words of 4 bytes.
static_assert(alignof(IslandRow) == 4 && sizeof(IslandRow) % 4 == 0 && alignof(IslandBody) == 4 && sizeof(IslandBody) % 4 == 0);

struct Sizes {
    std::uint32_t bodies, rows;
    std::uint64_t entries;

    std::uint64_t bytes() const {
        const std::uint64_t a_row = sizeof(IslandRow) + 6 * 4;  // q, lo, hi, impulse, friction, where it starts
        return 3 + bodies * std::uint64_t{sizeof(IslandBody)} + rows * a_row + 4 + entries * 8;
    }
};

// The caller's memory, handed out piece by piece from its first word on.
struct Pieces {
    std::byte* at;

    explicit Pieces(std::byte* memory) : at(memory + (4 - reinterpret_cast<std::uintptr_t>(memory) % 4) % 4) {}

    template <class T>
    span<T> take(std::size_t n) {
        T* const first = reinterpret_cast<T*>(at);
        at += n * sizeof(T);
        return {first, n};
    }
};

float q_of(const IslandRow& row, span<const IslandBody> bodies) {
    float q = row.bias;
    for (std::uint32_t i = 0; i < row.end_count; ++i) {
        const RowEnd& end = row.ends[i];
        if (end.body != no_body) q += dot(end.linear, bodies[end.body].v_free) + end.angular * bodies[end.body].w_free;
    }
    return q;
}

// By which impulses that the last substep left are scaled to one of length h. From one that was nothing beside this one they say nothing.
float warm_factor(const State& state, float h) {
    const float factor = state.last_substep > 0 ? h / state.last_substep : 1.0f;
    return factor <= 1.0e6f ? factor : 0.0f;
}

void write_problem(IslandRows& rows, const IslandConstraints& constraints, const Sizes& sizes, std::byte* memory, IslandProblem& out) {
    Pieces pieces(memory);
    const auto bodies = pieces.take<IslandBody>(sizes.bodies);
    const auto made = pieces.take<IslandRow>(sizes.rows);
    const auto q = pieces.take<float>(sizes.rows), lo = pieces.take<float>(sizes.rows), hi = pieces.take<float>(sizes.rows);
    const auto impulses = pieces.take<float>(sizes.rows);
    const auto friction = pieces.take<std::uint32_t>(sizes.rows), starts = pieces.take<std::uint32_t>(std::size_t{sizes.rows} + 1);
    const auto entries = static_cast<std::size_t>(sizes.entries);
    const auto columns = pieces.take<std::uint32_t>(entries);
    const auto values = pieces.take<float>(entries);

    const Core& core = rows.core;
    for (std::uint32_t i = 0; i < sizes.bodies; ++i) {
        const std::uint32_t body = rows.members.bodies[i];
        const FreeVelocity free = free_velocity_of(core, body, rows.h);
        bodies[i] = {core.body_id(body), core.poses[body].inv_mass, inv_inertia_of(core, body), free.v, free.w};
    }
    rows.rows = made.data();
    rows.lo = lo.data();
    rows.hi = hi.data();
    rows.impulses = impulses.data();
    rows.friction = friction.data();
    rows.count = 0;
    rows.members.joints.for_each([&](std::uint32_t i) { add_joint_rows(rows, i); });
    rows.members.contacts.for_each([&](std::uint32_t i) { add_contact_rows(rows, i); });
    for (std::uint32_t i = 0; i < sizes.rows; ++i) q[i] = q_of(made[i], bodies);
    write_matrix(rows, constraints, starts.data(), columns.data(), values.data());

    out.lcp = {{}, {starts, columns, values}, q, lo, hi, friction};
    out.impulses = impulses;
    out.rows = made;
    out.bodies = bodies;
}

}  // namespace

std::size_t World::export_island(BodyId id, float h, span<std::byte> memory, IslandProblem& out) const {
    const Core& c = core();
    const DefaultFloatMode mode;
    const std::uint32_t body = check_open(c) ? find_slot(c, id) : null_index;
    if (body == null_index || !check(c, c.is_dynamic(body), Error::no_dynamic_body)) return 0;
    if (!check(c, h >= min_time_step / 64 && h <= 1.0f, Error::bad_time_step)) return 0;

    Arena arena = c.arena();
    const IslandMembers members = find_island(c, body, arena);
    IslandRows rows{c, members, h};
    rows.warm = warm_factor(*c.state, h);
    rows.contact_warm = min(rows.warm, most_swept_warm);
    const IslandConstraints constraints = list_constraints(rows, arena);
    constexpr std::uint64_t most = 0xffffffffu;
    const Sizes sizes{members.body_count, rows.count, count_entries(constraints, most)};
    const bool fits = sizes.rows <= lcp::max_rows && sizes.entries <= most && sizes.bytes() <= static_cast<std::size_t>(-1);
    if (!check(c, fits, Error::out_of_range)) return 0;

    const auto bytes = static_cast<std::size_t>(sizes.bytes());
    if (memory.size() >= bytes) write_problem(rows, constraints, sizes, memory.data(), out);
    return bytes;
}

}  // namespace islet
