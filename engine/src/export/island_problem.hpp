// The stages of World::export_island: find the island, count its rows, write them, couple them. What is needed on the way is in the world's scratch.
#pragma once

#include "../data/core.hpp"
#include "islet/island.hpp"

namespace islet::detail {

/// Who is in the island.
struct IslandMembers {
    BitSet contacts, joints;          // that touch or hold one of its bodies, by slot
    std::uint32_t* bodies = nullptr;  // ascending
    std::uint32_t body_count = 0;
    std::uint32_t* place_of = nullptr;   // of a body of the island: its place among `bodies`
    std::uint32_t constraint_count = 0;  // contacts and joints
};

/// The island of a body that can be pushed: what is connected to it by touching contacts and joints through bodies that can be pushed too.
IslandMembers find_island(const Core& core, std::uint32_t body, Arena& arena);

/// Makes rows, one after the other: writes them where it is told to, or only counts them.
struct IslandRows {
    const Core& core;
    const IslandMembers& members;
    float h;  // s
    float inv_h = 1.0f / h;
    float warm = 0, contact_warm = 0;  // by which the stored impulses of joints and of contacts are scaled

    // Where to; all null while rows are counted.
    IslandRow* rows = nullptr;
    float* lo = nullptr;
    float* hi = nullptr;
    float* impulses = nullptr;
    std::uint32_t* friction = nullptr;
    std::uint32_t count = 0;

    /// Adds an end to a row: into the entries of the same body if it is there already, and of what cannot be pushed also the motion to the bias.
    void add_end(IslandRow& row, std::uint32_t body, Vec2 linear, float angular) const;
    /// A row with J = (-e, -sa, e, sb).
    IslandRow between(std::uint32_t a, std::uint32_t b, Vec2 e, float sa, float sb) const;
    /// Entry of J M_b^-1 J^T for two rows.
    float coupling(const IslandRow& r, const IslandRow& s) const;
    /// Takes a row over with its bounds and the impulse that is stored for it; returns its number. A row that pushes nothing is left out.
    std::uint32_t add(const IslandRow& row, float low, float high, float impulse, std::uint32_t friction_of = lcp::no_row);
};

/// Velocity of any body after a substep of length h without impulses.
struct FreeVelocity {
    Vec2 v;
    float w = 0;
};
FreeVelocity free_velocity_of(const Core& core, std::uint32_t body, float h);
/// 1/(kg m^2), as the solver takes it.
float inv_inertia_of(const Core& core, std::uint32_t body);

void add_contact_rows(IslandRows& to, std::uint32_t contact);
void add_joint_rows(IslandRows& to, std::uint32_t joint);

/// Contacts and joints as the matrix sees them: rows of one constraint share its bodies, and are coupled with those of every constraint on one of these bodies.
struct IslandConstraints {
    std::uint32_t count = 0;
    std::uint32_t* first_row = nullptr;         // of each constraint, and the number of rows at the end
    std::uint32_t* first_body = nullptr;        // of each constraint, in `bodies`, and their number at the end
    std::uint32_t* bodies = nullptr;            // places; each once in a constraint
    std::uint32_t* first_constraint = nullptr;  // of each body, in `constraints`, and their number at the end
    std::uint32_t* constraints = nullptr;       // ascending for each body
};

/// Counts the rows of every constraint on the way.
IslandConstraints list_constraints(IslandRows& counter, Arena& arena);

/// Nonzero entries of the matrix, counted on until they are more than `most`.
std::uint64_t count_entries(const IslandConstraints& constraints, std::uint64_t most);

/// The matrix in compressed sparse rows.
void write_matrix(const IslandRows& made, const IslandConstraints& constraints, std::uint32_t* row_starts, std::uint32_t* columns, float* values);

}  // namespace islet::detail
