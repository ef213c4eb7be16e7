// A chain of steel links, seen flat and on edge by turns.
//
//   ChainDef def = {.from = {0, 6}, .to = {2, 6}, .links = 12, .hold_from = true};
//   BodyId links[13];
//   JointId hinges[12];
//   Spawned chain = spawn(world, def, links, hinges);
//   // A ball on its end, as for a rope:
//   RevoluteJointDef shackle;
//   shackle.base = {.body_a = chain.bodies[11], .body_b = ball, .frame_a = chain_end(def)};
#pragma once

#include "prefab.hpp"

namespace islet::samples {

struct ChainDef {
    Vec2 from = {}, to = {};  ///< m
    float slack = 1;          ///< >= 1: its length over the distance of its ends
    std::size_t links = 12;
    float thickness = 0.06f;  ///< m, of the wire the links are bent from
    float density = 40;       ///< kg/m^2
    float break_force = 0;    ///< N, at which a link parts from the next; 0: never
    int group = 0;            ///< > 0: links of chains of the same group do not collide with each other
    bool hold_from = false;   ///< a static body holds this end
    bool hold_to = false;     ///< and this one
};

/// Bodies: the links from `from` to `to`, then what holds the ends. Joint i hinges link i to link i + 1.
void assemble(const ChainDef& def, Assembler& into);
/// Where the chain begins and ends on its first and its last link.
JointFrame chain_start(const ChainDef& def);
JointFrame chain_end(const ChainDef& def);

}  // namespace islet::samples
