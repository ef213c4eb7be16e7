// What goes by height, against gravity: the order in which contacts are swept one by one, and shock propagation.
//
// A sweep passes an impulse on from contact to contact only in the direction in which it visits them. Upward, one sweep carries the ground's support to the
// top of a tower; a sweep by colours carries it one layer or two.
//
// Shock propagation keeps a body from giving way to the bodies that lie on it (Guendelman, Bridson and Fedkiw, "Nonconvex Rigid Bodies with Stacking", 2003,
// with infinite masses below). Here the solve takes each body for lighter than the bodies it lies on, by one factor a layer (as Macklin and others, "Unified
// Particle Physics for Real-Time Applications", 2014, 5.3, for particles). Gravity moves light and heavy bodies alike, so bodies at rest stay at rest, but the
// solver sees a tower that narrows upward. Measured at 4 substeps: without shock propagation, a box of 300 kg on a column of five of 1 kg falls within 2 s;
// from shock 0.5 on it stands for 60 s. (Taking the lower body of each contact for immovable in every sweep makes the impulses of its two sides differ: piles
// explode from 0.5 on.)
//
// A contact keeps the impulses of the bodies as they are: so it reports the weight above it, and a warm start is right whichever bodies lie on which. What a
// body passes on to those below it is its own weight and what the contacts above pass on to it. The solve takes each of these for smaller by a factor of its
// own, from the top of the pile downward, and the impulses of the contacts below the body are made smaller by the factor of the sum, and larger again after
// the solve.
//
// The price: blows from above are weaker than they should be, and joints report the forces of the lighter bodies. Piles of 60 loose bodies come to rest at a
// shock of 0.5 (the test Shock.PilesOfLooseBodiesComeToRest), but above that some of them throw bodies out. Hence max_shock.
#pragma once

#include "../data/core.hpp"
#include "../memory/arena.hpp"

namespace islet::detail {

/// A touching contact or a swept joint while the plan is made.
struct PlannedConstraint {
    std::uint32_t index;           // of the contact or joint
    std::uint32_t body_a, body_b;  // null_index: none
    union {                        // by the stage of the plan
        std::uint32_t color;       // as listed; of a joint with its kernel above it
        std::uint32_t height;      // while contacts are sorted by height: its sort_key
        std::uint32_t place;       // once counted: which batch, colour and kernel
    };
};

/// Puts contacts in the order of SolverDef::sweep_order, those of equal height by slot, and takes their colours away.
void put_in_order(const Core& core, PlannedConstraint* contacts, std::uint32_t count);

/// Writes by which factor, at most 10 000, the solve takes each body for lighter than it is: 1 for a body that lies on nothing that can be pushed, else
/// 1 / (1 - shock) times the factor of the body below. Makes the impulses of the contacts smaller accordingly. Expects the contacts in the order of their
/// slots, and leaves them so, with no colours: heights stand in their place.
void lighten_by_height(const Core& core, PlannedConstraint* contacts, std::uint32_t count, float* lightness, Arena temporary);

/// After the solve: makes the impulses of the awake contacts as large again as those of the bodies as they are.
void restore_impulses(const Core& core, const float* lightness, Arena temporary);

}  // namespace islet::detail
