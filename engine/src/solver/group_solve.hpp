// The solve of several small worlds together, as fleets need it.
//
// A small world has one or two contacts of a colour, so most lanes of its blocks are padding. Worlds that are solved alike, substep by substep, share blocks:
// those of a colour are filled with the contacts of all of them. Lanes never mix, so each world comes to the bits that it would come to alone.
#pragma once

#include "../data/core.hpp"
#include "../island/batches.hpp"

namespace islet::detail {

/// Most worlds in a group.
inline constexpr std::uint32_t group_worlds = layout_lanes;

/// A world between the halves of its step.
struct GroupWorld {
    Core* core = nullptr;
    Plan plan;
    SolverBody* bodies = nullptr;  // by slot; solve_group fills it in
};

/// True if the worlds' solves are made with the same numbers, and ask for nothing that only a solve alone has. Lanes of both must be equal.
bool solve_alike(const Core& a, const Core& b);

/// Solves all worlds of a group, as solve() does one. They solve alike, lie in one block of memory in ascending order, at multiples of the size of a manifold
/// and of a pose, and have more than one lane. Each one's bodies are taken from `arena`.
void solve_group(GroupWorld* worlds, std::uint32_t count, Arena& arena, float dt);

}  // namespace islet::detail
