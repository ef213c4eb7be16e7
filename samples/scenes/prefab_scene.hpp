// Prefabs in scenes: as lists of bodies and joints, and driven through the interface that every engine has.
#pragma once

#include <cstddef>
#include <vector>

#include "harness/engine.hpp"
#include "harness/scene.hpp"
#include "prefabs/car.hpp"
#include "prefabs/gripper.hpp"
#include "prefabs/prefab.hpp"
#include "prefabs/soft_body.hpp"

namespace islet::samples {

/// Bodies, with places in the world, and joints between them: indices count in these lists.
struct Prefab {
    std::vector<SceneBody> bodies;
    std::vector<SceneJoint> joints;

    void body(const BodyDef& def) { bodies.push_back({def, {}}); }
    void shape(const SceneGeometry& geometry, const ShapeDef& def) { bodies.back().shapes.push_back({geometry, def}); }
    void joint(std::size_t a, std::size_t b, const JointDef& def) { joints.push_back({a, b, def}); }
};

/// The prefab that a definition describes.
template <class Def>
Prefab prefab_of(const Def& def) {
    Prefab prefab;
    AssembleInto into(prefab);
    assemble(def, into);
    return prefab;
}

/// What was made in a world, in the prefab's order.
struct PrefabIds {
    std::vector<BodyId> bodies;
    std::vector<JointId> joints;
    operator Spawned() const { return {bodies, joints}; }
};

/// Makes it in a world. What finds no room is left out: the error hook or world.last_error() says so, and its id is null.
PrefabIds spawn(World& world, const Prefab& prefab);

/// Where a prefab's lists begin in a scene or an engine.
struct Placed {
    std::size_t first_body = 0, first_joint = 0;
};

Placed add_prefab(Scene& scene, const Prefab& prefab);
/// For scripts, while the scene runs.
Placed create_prefab(Engine& engine, const Prefab& prefab);

// As the prefabs' own functions of these names, in any engine.
void drive(Engine& engine, const Placed& car, const CarDef& def, float speed);
void command(Engine& engine, const Placed& gripper, const GripperDef& def, const GripperCommand& command);
void apply_pressure(Engine& engine, const Placed& soft, const SoftBodyDef& def);
float area_of(const Engine& engine, const Placed& soft, const SoftBodyDef& def);

}  // namespace islet::samples
