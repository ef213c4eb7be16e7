#include "prefab_scene.hpp"

#include "harness/spawn.hpp"

namespace islet::samples {
namespace {

/// The joint with its indices counted from the start of the whole scene.
SceneJoint moved(const SceneJoint& joint, const Placed& placed) {
    const std::size_t first = std::holds_alternative<GearJointDef>(joint.def) ? placed.first_joint : placed.first_body;
    return {first + joint.body_a, first + joint.body_b, joint.def};
}

Transform pose_of(const BodyState& body) { return {body.position, make_rot(body.angle)}; }

SoftBodyGas gas_of(const Engine& engine, const Placed& soft, const SoftBodyDef& def) {
    SoftBodyGas gas(def);
    for (std::size_t i = 0; i < def.links; ++i) {
        const BodyState link = engine.body(soft.first_body + i);
        gas.add(pose_of(link), link.linear_velocity);
    }
    return gas;
}

}  // namespace

PrefabIds spawn(World& world, const Prefab& prefab) {
    PrefabIds made;
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

void drive(Engine& engine, const Placed& car, const CarDef& def, float speed) {
    for (std::size_t wheel = 0; wheel < 2; ++wheel) engine.set_motor(car.first_joint + wheel, wheel_motor(def, speed));
}

void command(Engine& engine, const Placed& gripper, const GripperDef& def, const GripperCommand& command) {
    const std::array<JointMotor, 4> motors = gripper_motors(def, command);
    for (std::size_t i = 0; i < motors.size(); ++i) engine.set_motor(gripper.first_joint + i, motors[i]);
}

void apply_pressure(Engine& engine, const Placed& soft, const SoftBodyDef& def) {
    const SoftBodyGas gas = gas_of(engine, soft, def);
    for (std::size_t i = 0; i < def.links; ++i) {
        const std::size_t link = soft.first_body + i;
        engine.apply_force(link, gas.force_on(pose_of(engine.body(link))));
    }
}

float area_of(const Engine& engine, const Placed& soft, const SoftBodyDef& def) { return gas_of(engine, soft, def).area(); }

}  // namespace islet::samples
