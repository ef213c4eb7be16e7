// A character mover: an upright capsule that walks, jumps and falls through a world by means of queries. It is not a body: it goes where you tell it to, and
// the world's forces do not push it.
//
// A mover climbs slopes and steps up to a limit, keeps to the ground on its way down, rides the bodies and conveyors that it stands on, slides along walls and
// into corners without trembling, and pushes dynamic bodies up to a force. Its state is a plain value: keep it beside a snapshot of the world to roll back
// both. The same calls give the same bits on every machine.
//
//     MoverState hero{.position = {0, 1}};
//     ...
//     world.step(dt);
//     step_mover(world, {}, hero, {.walk = 5 * stick, .jump = pressed ? 6.0f : 0}, dt);
//
// If bodies should collide with the mover, give it a kinematic body that queries with MoverDef::filter do not find.
#pragma once

#include <cstdint>

#include "islet/query.hpp"
#include "islet/world.hpp"

ISLET_API_BEGIN
namespace islet {

/// Returns whether a surface stands in the mover's way. It need not handle one-way shapes (ShapeDef::one_way), because the mover does that
/// itself. It may read and query the world, but not change it (in_step).
using MoverFilter = bool (*)(const Surface& surface, void* context);

/// The properties of a mover.
struct MoverDef {
    Capsule capsule = {{0, 0.3f}, {0, 1.5f}, 0.3f};  ///< Relative to the position: by default, that is between the feet of a mover 1.8 m tall.
    Vec2 up = {0, 1};                                ///< Unit; points away from the ground.
    float gravity_scale = 1;                         ///< Share of the world's gravity that acts on it in the air.
    float max_slope = 0.9f;                          ///< rad, 0 to 1.5. Steeper ground cannot be walked up or stood on.
    float step_height = 0.35f;                       ///< m, >= 0. It climbs edges up to this height above the feet, if there is room above them.
    float snap_distance = 0.35f;                     ///< m, >= 0. On a walk, the feet keep to ground that falls away by no more than this in a step.
    float ground_acceleration = 60;                  ///< m/s^2, >= 0. How fast it reaches its walking speed, and stops.
    float air_acceleration = 20;                     ///< m/s^2, >= 0. The same sideways in the air.
    float mass = 70;             ///< kg, >= 0. Decides its weight on dynamic bodies, which stay awake under it, and how much of its speed it gives them.
    float max_push_force = 400;  ///< N, >= 0. The largest force with which it pushes dynamic bodies out of its way.
    QueryFilter filter = {};
    MoverFilter collides = nullptr;  ///< Called for each surface that the filter finds; null: all stand in the way.
    void* context = nullptr;
};

/// The state of a mover.
struct MoverState {
    Vec2 position = {};          ///< m, world
    Vec2 velocity = {};          ///< m/s; while it stands, relative to the ground
    BodyId ground = {};          ///< The body it stands on; null in the air.
    Vec2 ground_normal = {};     ///< unit
    Vec2 ground_point = {};      ///< m, in the ground body's frame: the point that the ground carries along
    std::uint32_t squeezed = 0;  ///< 1: the surfaces around it left no room in the last step, or it is still leaving one that overlaps it
};

/// What a mover should do in a step.
struct MoverInput {
    float walk = 0;  ///< m/s, along the ground, in the air sideways; to the right if `up` points up
    float jump = 0;  ///< m/s, >= 0. If above 0, a mover that stands on ground leaves it with this speed upwards.
};

/// The distance that a mover keeps from surfaces, m.
inline constexpr float mover_gap = 0.01f;

/// Moves the mover by dt seconds, min_time_step <= dt <= 1. Call it once after each step of the world, with the same dt. It changes the world only by the
/// mover's weight (a force over the next step) and inertia (an impulse no larger than that force gives in a step) on the dynamic body that carries it, and by
/// its push (an impulse on the centre of mass) on others. The weight is at most 10 times the body's own, and what gives the place below the feet, if nothing
/// else holds the body, 25 times the acceleration of gravity: so a body of a tenth of `mass` bears all of it near its middle, and one of a sixth anywhere on a
/// plank. A mover leaves what overlaps it with 3 m/s besides that one's own speed. On an error it returns false and changes nothing;
/// the world records the error: feature_cut if this build leaves out the mover or queries (islet/config.hpp); in_step; bad_geometry of the capsule;
/// bad_time_step; not_finite; out_of_range (a number outside the ranges above; `up` not unit; a position, or an end of the capsule there, beyond max_position;
/// a speed beyond max_speed_limit).
bool step_mover(World& world, const MoverDef& def, MoverState& state, const MoverInput& input, float dt);

}  // namespace islet
ISLET_API_END
