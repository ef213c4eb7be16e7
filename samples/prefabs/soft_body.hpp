// A soft body: a ring of links that cannot stretch, filled with gas.
//
//   SoftBodyDef def = {.position = {0, 3}};
//   BodyId links[20];
//   JointId hinges[20];
//   Spawned ball = spawn(world, def, links, hinges);
//   for (;;) {
//       apply_pressure(world, ball, def);  // before every step: a body's forces act for one step
//       world.step(1.0f / 60);
//   }
//
// The gas is of constant temperature, with a vacuum around it: pressure times area stays what it is. The skin is as long as it is, so the area is
// largest, and the pressure lowest, when the body is round: that is `pressure`. What lies on a body of pressure p rests on a patch of width
// weight / p. The gas damps itself a little: forces that are given once a step would otherwise let a
// load bounce on it for ever.
//
// A skin of many light links gives: 8 substeps and a joint_hertz of 120 in SolverDef make it stiffer.
#pragma once

#include "prefab.hpp"

namespace islet::samples {

struct SoftBodyDef {
    Vec2 position = {};   ///< m, of its middle
    float radius = 0.5f;  ///< m, to the middle of its skin
    std::size_t links = 20;
    float thickness = 0.08f;   ///< m, of the skin: less than the length of a link
    float density = 5;         ///< kg/m^2, of the skin
    float pressure = 60;       ///< N/m, when it is round
    float damping = 0.5f;      ///< 1/s: calms the waves that run around the skin
    float gas_damping = 0.1f;  ///< s: the pressure falls by `pressure` times this times the rate, per round area, at which the area grows
    float friction = 0.6f;
};

/// Bodies: the links, counter-clockwise. Joint i hinges link i to the next one.
void assemble(const SoftBodyDef& def, Assembler& into);
/// Pushes the skin outwards, over the next step, with the pressure that the gas has at its present area.
void apply_pressure(World& world, const Spawned& soft, const SoftBodyDef& def);
/// The area inside the ring of hinges, m^2; when it is round, and now.
float round_area(const SoftBodyDef& def);
float area_of(const World& world, const Spawned& soft, const SoftBodyDef& def);

/// The gas, for those who keep the links in another way: give it all links in their order, then it tells the force on each.
class SoftBodyGas {
public:
    explicit SoftBodyGas(const SoftBodyDef& def);
    /// Where the next link is, and its velocity, m/s.
    void add(const Transform& link, Vec2 velocity);
    /// Inside the ring of hinges, m^2.
    float area() const { return 0.5f * twice_area_; }
    /// N, at the link's middle, outwards.
    Vec2 force_on(const Transform& link) const;

private:
    SoftBodyDef def_;
    float half_;  // m, of a link's length
    bool empty_ = true;
    Vec2 origin_;
    float twice_area_ = 0, rate_ = 0;  // m^2, m^2/s
};

}  // namespace islet::samples
