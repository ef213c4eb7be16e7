// Contacts solved one by one, in a chosen order: for scenes on which sweeps by colours converge too slowly.
//
// A sweep passes an impulse on from contact to contact only in the direction in which it visits them (island/height_order.hpp, which puts the contacts in
// order).
//
// A block solve finds the two normal impulses of a contact together. The complementarity problem of two rows has four cases; the solve tries each.
#pragma once

#include "../constraint/contact_rows.hpp"
#include "../constraint/solver_body.hpp"
#include "../data/features.hpp"

namespace islet::detail {

/// One sweep over the rows in their order. `ground` is for contacts with bodies that cannot be pushed; `block` adds block solves.
void solve_in_order(SolverBody* bodies, ContactRows<1>* rows, std::uint32_t count, const SweepNumbers& dynamic, const SweepNumbers& ground, bool block);

}  // namespace islet::detail
