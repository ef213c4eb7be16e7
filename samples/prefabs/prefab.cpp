#include "prefab.hpp"

#include "harness/spawn.hpp"

namespace islet::samples {
namespace {

/// The joint with its indices counted from the start of the whole scene.
SceneJoint moved(const SceneJoint& joint, const Placed& placed) {
    const std::size_t first = std::holds_alternative<GearJointDef>(joint.def) ? placed.first_joint : placed.first_body;
    return {first + joint.body_a, first + joint.body_b, joint.def};
}

}  // namespace

Spawned spawn(World& world, const Prefab& prefab) {
    Spawned made;
    for (const SceneBody& body : prefab.bodies) made.bodies.push_back(spawn(world, body));
    for (const SceneJoint& joint : prefab.joints) {
        // A joint of something that was left out is left out without an error of its own: last_error() keeps saying why.
        const bool gear = std::holds_alternative<GearJointDef>(joint.def);
        const bool whole =
            gear ? made.joints[joint.body_a] && made.joints[joint.body_b] : made.bodies[joint.body_a] && made.bodies[joint.body_b];
        made.joints.push_back(whole ? spawn(world, joint, made.bodies, made.joints) : JointId{});
    }
    return made;
}

void destroy(World& world, const Spawned& spawned) {
    for (const BodyId body : spawned.bodies) {
        if (world.is_valid(body)) world.destroy_body(body);
    }
}

Placed add_prefab(Scene& scene, const Prefab& prefab) {
    const Placed placed = {scene.bodies.size(), scene.joints.size()};
    scene.bodies.insert(scene.bodies.end(), prefab.bodies.begin(), prefab.bodies.end());
    for (const SceneJoint& joint : prefab.joints) scene.joints.push_back(moved(joint, placed));
    return placed;
}

Placed create_prefab(Engine& engine, const Prefab& prefab) {
    const Placed placed = {engine.body_slots(), engine.joint_slots()};
    for (const SceneBody& body : prefab.bodies) engine.create_body(body);
    for (const SceneJoint& joint : prefab.joints) engine.create_joint(moved(joint, placed));
    return placed;
}

}  // namespace islet::samples
