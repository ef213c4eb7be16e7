// Scenes as JSON files: what a Scene holds, but for its scripts and its check.
//
//     {
//       "format": 1,
//       "name": "crate",
//       "steps": 120,
//       "view": [-5, -1, 5, 5],
//       "bodies": [
//         {"shapes": [{"box": [5, 0.5], "friction": 0.8}], "position": [0, -0.5]},
//         {"type": "dynamic", "position": [0, 3], "shapes": [{"box": [0.5, 0.5]}]}
//       ]
//     }
//
// "format" is the number of this format, scene_format; it may be left out. Names and units are those of the engine's definitions (islet/types.hpp, islet/geometry.hpp, islet/joints.hpp), and what is left out has their defaults.
// Vectors are [x, y]; bodies and joints are known by their place in their list, from 0. A shape has one of
//
//     "circle": {"center", "radius"}    "capsule": {"point1", "point2", "radius"}    "segment": {"point1", "point2"}
//     "box": [half width, half height]  "polygon": {"points", "radius"}              "chain": {"points", "loop"}
//
// and the fields of ShapeDef. The points of a polygon are its corners in any order. (With "normals" and "centroid" it is taken as it stands: so it is written
// where working them out anew would not give the same bits.) A joint has a "type", "body_a" and "body_b", or for a gear "joint1" and "joint2", for a mouse
// joint "body", and the fields of its definition, those of its base included.
#pragma once

#include <stdexcept>
#include <string>

#include "harness/scene.hpp"

namespace islet::samples {

/// A sentence that says where the file is wrong, and what about it.
struct SceneFileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The format of scene files that this version writes, and the only one that it reads.
inline constexpr int scene_format = 1;

/// Throws a SceneFileError if the text is no scene. What only the engine can tell, such as a friction below 0, is found when the scene is loaded.
Scene read_scene(const std::string& text);
/// read_scene reads back a scene that gives the same bits.
std::string write_scene(const Scene& scene);
/// Whether it does something that no file can hold: a script or hooks.
bool has_script(const Scene& scene);

}  // namespace islet::samples
