// What goes by height, against gravity: the order in which contacts are swept one by one, and shock propagation.
//
// A sweep hands support on from contact to contact only in the direction it goes. Upward, the ground's support travels up a whole tower in one sweep; by
// colours it gets one layer or two farther.
//
// Shock propagation keeps what lies below from giving way to what lies on it (Guendelman, Bridson and Fedkiw, "Nonconvex Rigid Bodies with Stacking", 2003,
// with infinite masses below). Here the solve takes each body for lighter than those it lies on, by one factor a layer (as Macklin and others, "Unified
// Particle Physics for Real-Time Applications", 2014, 5.3, for particles): gravity moves light and heavy alike, so what rests still rests, and what the
// solver sees is a tower that narrows upward. Measured at 4 substeps: a box of 300 kg on a column of five of 1 kg falls within 2 s without it, and stands
// for 60 s from shock 0.5 on. (Taking the lower body of each contact for immovable instead, in every sweep, makes the impulses of its two sides differ: piles
// explode from 0.5 on.) The price: blows from above are weaker than they should be, and so are the forces that contacts and joints report. And impulses
// are warm started from a step in which a body may have lain on something else: piles of 60 loose bodies come to rest
// at a shock of 0.5 (the test Shock.PilesOfLooseBodiesComeToRest); with more of it some of them throw bodies out. Hence max_shock.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// A touching contact or a joint, as far as the plan is concerned: its bodies (null_index: none) and its colour, in place of which comes its place.
struct Edge {
    std::uint32_t constraint, a, b, place;
};

/// Contacts in the order of SolverDef::sweep_order, equal ones by slot; none has a colour any more.
void put_in_order(const Core& core, Edge* contacts, std::uint32_t count);

/// How many times lighter than it is the solve takes each body for, at most 10 000 times: 1 what lies on nothing that can be pushed,
/// 1 / (1 - shock) times what it lies on any other. Sorts the contacts by slot again when done.
void lighten_by_height(const Core& core, Edge* contacts, std::uint32_t count, float* lightness);

}  // namespace islet::detail
