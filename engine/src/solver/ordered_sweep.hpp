// Contacts solved one by one, in an order chosen: for what sweeps by colours converge too slowly on.
//
// A sweep hands an impulse on from contact to contact only in the direction it goes. Upward, the ground's support
// reaches the top of a tower in one sweep (island/height_order.hpp puts the contacts in order); by colours it gets one layer or two farther.
//
// A block solve finds the two normal impulses of a contact together: the complementarity problem of two rows has four cases, and they are tried.
#pragma once

#include "../constraint/contact_rows.hpp"
#include "../constraint/solver_body.hpp"
#include "../data/features.hpp"

namespace islet::detail {

/// One sweep over the rows in their order. `ground`: for contacts of bodies that cannot be pushed.
void solve_in_order(SolverBody* bodies, ContactRows<1>* rows, std::uint32_t count, const SweepNumbers& dynamic, const SweepNumbers& ground, bool block);

}  // namespace islet::detail
