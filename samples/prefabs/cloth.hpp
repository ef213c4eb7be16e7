// Cloth hung up in the plane of the picture: a net of small discs, tied by rods along its threads and by springs that resist bending and shear.
//
//   ClothDef def = {.corner = {-1, 4}, .columns = 9, .rows = 9};
//   BodyId nodes[81];
//   JointId threads[398];
//   Spawned cloth = spawn(world, def, nodes, threads);
//   // Hang it up by its corners:
//   RevoluteJointDef nail;
//   nail.base = {.body_a = wall, .body_b = cloth.bodies[cloth_node(def, 0, 0)], .frame_a = {{-1, 4}}};
//   world.create_joint(nail);
#pragma once

#include "prefab.hpp"

namespace islet::samples {

struct ClothDef {
    Vec2 corner = {};                   ///< m, of its upper left node
    std::size_t columns = 8, rows = 8;  ///< nodes
    float spacing = 0.25f;              ///< m, from node to node
    float weight = 1;                   ///< kg/m^2
    float radius = 0.06f;               ///< m, of a node, where it touches other things
    float bending_hertz = 3;            ///< Hz, of the springs between every node and the next but one; 0: none
    float shear_hertz = 4;              ///< Hz, of the springs across the meshes; 0: none
    float damping_ratio = 0.3f;         ///< of both
    float damping = 0.3f;               ///< 1/s, of the air
    int group = 1;                      ///< > 0: nodes of cloths of the same group do not collide with each other
};

/// Bodies: the nodes, row by row from the top, each from left to right. Joints: the rods first, then the springs.
void assemble(const ClothDef& def, Assembler& into);
/// Index of a node among the bodies.
std::size_t cloth_node(const ClothDef& def, std::size_t column, std::size_t row);
/// How many of the joints are rods.
std::size_t cloth_rods(const ClothDef& def);

}  // namespace islet::samples
