// Things ready made of several bodies and joints: put one into a World of your own with `spawn`, or into a scene.
//
//   Spawned bridge = spawn(world, make_bridge({.from = {-4, 3}, .to = {4, 3}}));
//   world.apply_linear_impulse_to_center(bridge.bodies[3], {2, 0});
#pragma once

#include <cstddef>
#include <vector>

#include "harness/engine.hpp"
#include "harness/scene.hpp"

namespace islet::samples {

/// Bodies, with places in the world, and joints between them: indices count in these lists.
struct Prefab {
    std::vector<SceneBody> bodies;
    std::vector<SceneJoint> joints;
};

/// What was made, in the prefab's order.
struct Spawned {
    std::vector<BodyId> bodies;
    std::vector<JointId> joints;
};

/// Makes it in a world. What finds no room is left out: the error hook or world.last_error() says so, and its id is null.
Spawned spawn(World& world, const Prefab& prefab);
/// Destroys what is left of it.
void destroy(World& world, const Spawned& spawned);

/// Where a prefab's lists begin in a scene or an engine.
struct Placed {
    std::size_t first_body = 0, first_joint = 0;
};

Placed add_prefab(Scene& scene, const Prefab& prefab);
/// For scripts, while the scene runs.
Placed create_prefab(Engine& engine, const Prefab& prefab);

}  // namespace islet::samples
