// A scene: plain lists of the engine's own definitions, that any engine can load, with optional scripts and a check in numbers.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <islet/islet.hpp>

namespace islet::samples {

class Engine;

/// Points of a chain of segments; see World::create_chain.
struct Chain {
    std::vector<Vec2> points;
    bool loop = false;
};

using SceneGeometry = std::variant<Circle, Capsule, Segment, Polygon, Chain, HalfSpace>;

/// What stands for a half-space in engines that have none, and in pictures: a segment of 2 km.
inline Segment long_segment(const HalfSpace& h) {
    const Vec2 middle = h.offset * h.normal, along = 1000 * left_perp(h.normal);
    return {middle - along, middle + along};
}

struct SceneShape {
    SceneGeometry geometry;
    ShapeDef def;
};

struct SceneBody {
    BodyDef def;
    std::vector<SceneShape> shapes;
};

/// Any of the joints of islet/joints.hpp. The ids in it are filled in by the engine that makes the joint.
using JointDef = std::variant<RevoluteJointDef, PrismaticJointDef, DistanceJointDef, WeldJointDef, WheelJointDef, MotorJointDef,
                              MouseJointDef, PulleyJointDef, GearJointDef, AngleJointDef>;

/// A joint between two bodies, known by their indices. A mouse joint pulls body_b and has no body_a; of a gear they are the indices of two joints.
struct SceneJoint {
    std::size_t body_a = 0, body_b = 0;
    JointDef def;
};

/// What a user would want of a line of a check, over all starts of its scene: a row of the table of `islet steady`.
struct Wanted {
    double most = 0;      // the line's value is at most this
    bool counts = false;  // the line is 1 where a start fails, else 0: the table counts them
};

/// One line of a scene's check: what was measured, its value, and the bounds it must keep.
struct CheckLine {
    std::string what;  // a sentence with its unit, e.g. "top of the pyramid sank (m)"
    double value = 0;
    double low = 0;  // pass if low <= value <= high
    double high = 0;
    std::optional<Wanted> wanted = {};  // where the engine falls short of it, `high` is looser
    bool pass() const { return value >= low && value <= high; }
};

/// What a person may do in a scene instead of its script: a host that shows buttons and hears keys fills in `held` between steps, and the script reads it.
/// (Programs without a player leave it alone.)
struct Controls {
    struct Button {
        const char* name;
        char way;  // of the key that suits it: '<', '>', '^' or 'v'
    };
    std::vector<Button> buttons;
    std::optional<Vec2> goal;  // m, where to get to
    bool taken = false;        // a person plays: the script leaves to them what the buttons do
    bool has_won = false;      // the person has got to the goal
    std::uint32_t held = 0;    // bit i: button i

    bool holds(std::size_t button) const { return (held >> button & 1) != 0; }
};

/// Everything an engine needs to run a scene. Bodies are known by their index in `bodies` and joints by theirs in `joints`, in every engine;
/// what a script makes later gets the next indices.
struct Scene {
    std::string name;
    WorldDef world;
    float dt = 1.0f / 60.0f;  // s
    int steps = 300;          // how long `islet run` runs it, and what `check` expects
    std::vector<SceneBody> bodies;
    std::vector<SceneJoint> joints;
    std::uint32_t extra_contacts = 0;                                    // contact capacity beyond the estimate of capacity_of
    std::uint32_t extra_bodies = 0, extra_shapes = 0, extra_joints = 0;  // room for what scripts make, as many as exist at once
    Aabb view = {{-10, -1}, {10, 11}};                                   // m, what a picture shows
    std::vector<std::size_t> traced;                                     // bodies whose path a picture shows as a line
    std::function<void(Engine&, int step)> before_step;                  // scripts: push, set a velocity, create, destroy
    std::function<void(const Engine&, int step)> after_step;             // observers: what the check needs to have seen
    std::function<std::vector<CheckLine>(const Engine&)> check;          // after `steps` steps
    std::shared_ptr<Controls> controls;                                  // what a person may do; null: nothing but what any scene allows
};

/// A capacity that holds the scene.
Capacity capacity_of(const Scene& scene);

}  // namespace islet::samples
