// Which field of a scene it is that the engine refuses: the engine says what is wrong with a call, and a file's author wants to know where.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "scene.hpp"

namespace islet::samples {

/// The place below the body, such as "shapes[1].friction"; empty if no part of it is at fault alone. Makes bodies in the world to find out, and destroys them.
std::string faulty_field(World& world, const SceneBody& body);
/// The same of a joint, whose fields are its definition's: "motor.max_force".
std::string faulty_field(World& world, const SceneJoint& joint, std::span<const BodyId> bodies, std::span<const JointId> joints);
/// The same of a world's definition; `is_good` tries one.
std::string faulty_field(const WorldDef& def, const std::function<bool(const WorldDef&)>& is_good);

}  // namespace islet::samples
