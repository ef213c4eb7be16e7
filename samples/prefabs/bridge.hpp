// A bridge of planks, hinged end to end between two banks.
//
//   BodyId planks[18];
//   JointId hinges[17];
//   Spawned bridge = spawn(world, BridgeDef{.from = {-5, 3}, .to = {5, 3}}, planks, hinges);
//   // With .break_force it comes down under a heavy load: see World::broken_joints.
//
// Let the banks end a plank's thickness before the hinges. The ends of planks that hang turn into a bank that ends at them, which the hinges do not allow: so
// the bridge would tremble.
#pragma once

#include "prefab.hpp"

namespace islet::samples {

struct BridgeDef {
    Vec2 from = {}, to = {};  ///< m, of its hinges on the banks: if `to` is on the left, it starts as an arch
    float slack = 1.01f;      ///< >= 1: its length over the distance of the banks. The less, the flatter it hangs and the harder it pulls.
    std::size_t planks = 16;
    float thickness = 0.2f;  ///< m
    float density = 5;       ///< kg/m^2
    float friction = 0.6f;
    float stiffness = 0;    ///< N m of dry friction in each hinge, which calms it
    float hertz = 0;        ///< Hz, of springs in the hinges that keep it flat as a girder does; 0: none
    float break_force = 0;  ///< N, at which a hinge breaks; 0: never
};

/// Bodies: the planks from `from` to `to`, then the two static ones that hold the ends. Joint i hinges plank i to plank i + 1; the last two are
/// those on the banks.
void assemble(const BridgeDef& def, Assembler& into);

}  // namespace islet::samples
