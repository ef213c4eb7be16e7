// A character mover: an upright capsule that walks, jumps and falls through a world by its queries. It is no body: it goes where it is told, and the world's
// forces do not push it about.
//
// It climbs slopes and steps up to a limit, keeps to the ground going down, rides what it stands on (moving, turning, dynamic, conveyors), slides along
// walls and into corners without trembling, and pushes dynamic bodies as hard as it may. Its state is a plain value of yours: keep it beside a snapshot of the
// world, and both go back together. The same calls give the same bits on every machine.
//
//     MoverState hero{.position = {0, 1}};
//     ...
//     world.step(dt);
//     step_mover(world, {}, hero, {.walk = 5 * stick, .jump = pressed ? 6.0f : 0}, dt);
//
// For bodies to feel it, give it a kinematic body of its own, that queries with MoverDef::filter do not find.
#pragma once

#include <cstdint>

#include "islet/query.hpp"
#include "islet/world.hpp"

ISLET_API_BEGIN
namespace islet {

/// Whether a surface stands in the mover's way. Movers pass one-way shapes (ShapeDef::one_way), and are held by them, without it.
/// It may read and query the world, but not change it (in_step).
using MoverFilter = bool (*)(const Surface& surface, void* context);

/// What a mover is like.
struct MoverDef {
    Capsule capsule = {{0, 0.3f}, {0, 1.5f}, 0.3f};  ///< From the mover's position; by default that is between its feet, and it is 1.8 m tall.
    Vec2 up = {0, 1};                                ///< Unit; where the ground is not.
    float gravity_scale = 1;                         ///< Of the world's gravity, while it is in the air.
    float max_slope = 0.9f;                          ///< rad, 0 to 1.5. Steeper ground cannot be walked up or stood on.
    float step_height = 0.35f;                       ///< m, >= 0. Edges up to so much above the feet are climbed, as far as there is room above.
    float snap_distance = 0.35f;                     ///< m, >= 0. Walking, the feet keep to ground that sinks away by no more than this in a step.
    float ground_acceleration = 60;                  ///< m/s^2, >= 0. To the walking speed asked for, and to a halt.
    float air_acceleration = 20;                     ///< m/s^2, >= 0. The same in the air, sideways.
    float mass = 70;             ///< kg, >= 0. Its weight on dynamic bodies, which stay awake under it, and how much of its speed it can give them.
    float max_push_force = 400;  ///< N, >= 0. With which it pushes dynamic bodies in its way: what slides or rolls more easily gives way.
    QueryFilter filter = {};
    MoverFilter collides = nullptr;  ///< Asked of each surface that the filter finds; null: all stand in the way.
    void* context = nullptr;
};

/// Where a mover is and how it moves.
struct MoverState {
    Vec2 position = {};          ///< m, world
    Vec2 velocity = {};          ///< m/s; relative to the ground while it stands on it
    BodyId ground = {};          ///< What it stands on; null in the air.
    Vec2 ground_normal = {};     ///< unit
    Vec2 ground_point = {};      ///< m, in the ground body's frame: what is carried along with it
    std::uint32_t squeezed = 0;  ///< 1: what surrounds it left no room for it in the last step
};

/// What it is to do in a step.
struct MoverInput {
    float walk = 0;  ///< m/s, along the ground, to the right seen with `up` upwards; in the air sideways
    float jump = 0;  ///< m/s, >= 0: above 0 it leaves the ground with this speed upwards, if it stands on any
};

/// How far a mover stays away from surfaces, m.
inline constexpr float mover_gap = 0.01f;

/// Moves the mover on by dt seconds, min_time_step <= dt <= 1: call it once after each step of the world, with the same dt. It changes the world only by its
/// weight (a force over the next step) and its push (an impulse on the centre of mass) on dynamic bodies. Returns false and changes nothing on an error, which
/// the world records: feature_cut where this build leaves out the mover or queries (islet/config.hpp), in_step, bad_geometry of the
/// capsule, bad_time_step, not_finite, out_of_range (a number outside the ranges above; `up` not unit; a position, or an end of the
/// capsule there, beyond max_position; a speed beyond max_speed_limit).
bool step_mover(World& world, const MoverDef& def, MoverState& state, const MoverInput& input, float dt);

}  // namespace islet
ISLET_API_END
