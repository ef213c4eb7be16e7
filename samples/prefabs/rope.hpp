// A rope: thin capsules, hinged end to end.
//
//   RopeDef def = {.from = {0, 6}, .to = {0, 3}, .hold_from = true};
//   BodyId links[17];
//   JointId hinges[17];
//   Spawned rope = spawn(world, def, links, hinges);
//   // A crate on its lower end: the hinge goes where the rope ends.
//   RevoluteJointDef knot;
//   knot.base = {.body_a = rope.bodies[def.links - 1], .body_b = crate, .frame_a = rope_end(def), .frame_b = {{0, 0.5f}}};
//   world.create_joint(knot);
#pragma once

#include "prefab.hpp"

namespace islet::samples {

struct RopeDef {
    Vec2 from = {}, to = {};  ///< m
    float slack = 1;          ///< >= 1: its length over the distance of its ends; with slack it starts on an arc to the right of the way
    std::size_t links = 16;
    float radius = 0.03f;    ///< m, half its thickness
    float density = 15;      ///< kg/m^2: about 1 kg a metre for the thickness above
    float stiffness = 0;     ///< N m of dry friction in each hinge
    float damping = 0.1f;    ///< 1/s, of the air
    int group = 0;           ///< > 0: links of ropes of the same group do not collide with each other
    bool hold_from = false;  ///< a static body holds this end
    bool hold_to = false;    ///< and this one
};

/// Bodies: the links from `from` to `to`, then what holds the ends. Joint i hinges link i to link i + 1. The last joint keeps the ends within
/// 1.01 times the rope's length, so that a heavy load does not stretch it.
void assemble(const RopeDef& def, Assembler& into);
/// Where the rope begins and ends on its first and its last link.
JointFrame rope_start(const RopeDef& def);
JointFrame rope_end(const RopeDef& def);

}  // namespace islet::samples
