// Joints: their ids, definitions, errors and events.
//
// A joint connects body B to body A. It has a frame on each body: a point and a direction that move with the body. Most joints leave one coordinate free, an
// angle or a length. A spring, a limit, a motor and dry friction can act on this coordinate:
//
//   joint      coordinate                                     locked
//   revolute   angle of frame B in frame A, rad               point of B on point of A
//   prismatic  position of B along A's x axis, m              across the axis, angle
//   wheel      position of B along A's x axis, m (spring,     across the axis
//              limit); angle of B, rad (motor, friction)
//   distance   distance of the two points, m                  the distance itself, unless a spring or a limit is enabled
//   weld       none                                           point and angle, both softly if asked
//   motor      none                                           nothing: drives velocity or pose, with at most a force and a torque
//   mouse      none                                           nothing: pulls a point of B to a target, with at most a force
//   pulley     none                                           length of A's side + ratio * length of B's side
//   gear       none                                           coordinate of joint 1 + ratio * coordinate of joint 2
//   angle      angle of frame B in frame A, rad               nothing; a ratchet stops it from turning back
//
// Angles are continuous: they count on past a full turn.
#pragma once

#include <cstdint>

#include "islet/config.hpp"
#include "islet/types.hpp"

ISLET_API_BEGIN
namespace islet {

/// The id of a joint. The same rules hold as for BodyId.
struct JointId {
    std::uint32_t index1 = 0;
    std::uint32_t generation = 0;
    ISLET_EQUAL_IF(JointId, a.index1 == b.index1 && a.generation == b.generation)
    friend constexpr bool operator<(JointId a, JointId b) { return a.index1 != b.index1 ? a.index1 < b.index1 : a.generation < b.generation; }
    explicit constexpr operator bool() const { return index1 != 0; }
};

/// revolute, prismatic and so on: the names in ISLET_JOINT_TYPES (islet/config.hpp), in that order.
enum class JointType : std::uint8_t {
#define ISLET_NAME(type, definition) type,
    ISLET_JOINT_TYPES(ISLET_NAME)
#undef ISLET_NAME
};
#define ISLET_ONE(...) +1
inline constexpr std::uint32_t joint_type_count = 0 ISLET_JOINT_TYPES(ISLET_ONE);
#undef ISLET_ONE

/// The largest ratio of a pulley or a gear.
inline constexpr float max_ratio = 1.0e6f;

/// A joint's place on a body, relative to the body's origin.
struct JointFrame {
    Vec2 position = {};  ///< m, within max_position
    float angle = 0;     ///< rad. The x axis of frame A is the axis of prismatic and wheel joints.
};

/// A spring that pulls the joint's coordinate to a target. Its stiffness follows from the masses it moves, so it behaves the same for heavy and
/// light bodies: hertz is the frequency it would swing with if it were the only constraint (Catto, "Soft Constraints", GDC 2011).
struct JointSpring {
    bool enable = false;
    float hertz = 0;          ///< Hz, >= 0; 0 is no spring
    float damping_ratio = 0;  ///< >= 0; 1 is critical
    float target = 0;         ///< rad or m; not used by distance joints, whose target is their length
};

/// The springs of a weld or motor joint, and the linear one of a mouse joint.
///
/// A weld swings at its frequency and decays by its damping ratio: up to 10 Hz at 240 substeps a second, the frequency is right within 0.5 % and a ratio of up
/// to 1 within 0.012. Stiffer springs are damped more: undamped ones as by a ratio of 0.05 at 13 Hz, of 0.44 at 19 Hz. So are stiff springs of a body with many
/// joints: with four joints, an undamped weld of 10 Hz decays as by 0.06. The stiffness of the point is that of the mean over its directions.
///
/// Motor and mouse joints are less stiff where their point gives way more easily. So the point sets off straight to the target, from a corner as from the
/// centre. They are damped more than asked, the more so the stiffer: at 240 substeps a second, an undamped spring of 5 Hz decays as if its ratio were 0.13, one
/// of 10 Hz as if it were 0.25, and 0.5 at 5 Hz comes out as 0.603.
struct JointSoftness {
    float linear_hertz = 0;           ///< Hz, >= 0; of a mouse joint > 0. 0: rigid, or, of a motor joint, it drives the velocity.
    float linear_damping_ratio = 1;   ///< >= 0
    float angular_hertz = 0;          ///< Hz, >= 0; the same for the angle. Of a mouse joint 0.
    float angular_damping_ratio = 1;  ///< >= 0; of a mouse joint without effect
};

/// Bounds of the joint's coordinate, rad or m: lower <= upper.
struct JointLimit {
    bool enable = false;
    float lower = 0;
    float upper = 0;
};

/// Drives the coordinate's rate to `speed` with at most `max_force`.
struct JointMotor {
    bool enable = false;
    float speed = 0;      ///< rad/s or m/s
    float max_force = 0;  ///< N m or N, >= 0
};

/// What all joints have. The bodies must be two different ones, one of them dynamic.
struct JointBase {
    BodyId body_a = {};
    BodyId body_b = {};
    JointFrame frame_a = {};
    JointFrame frame_b = {};
    bool collide_connected = false;  ///< true: the two bodies' shapes collide with each other
    float break_force = 0;           ///< N, >= 0. The joint breaks, at the end of the step, when its force exceeds this in a substep; 0: never.
    float break_torque = 0;          ///< N m, >= 0; as above
    std::uint64_t user_data = 0;
};

/// A hinge.
struct RevoluteJointDef {
    JointBase base = {};
    JointSpring spring = {};
    JointLimit limit = {};
    JointMotor motor = {};
    float friction = 0;  ///< N m, >= 0: dry friction that resists turning
};

/// A slider.
struct PrismaticJointDef {
    JointBase base = {};
    JointSpring spring = {};
    JointLimit limit = {};
    JointMotor motor = {};
    float friction = 0;  ///< N, >= 0: dry friction that resists sliding
};

/// A rod. With a limit it is a rope (lower 0) or a telescope, and with a spring it is a spring. A motor drives its length.
struct DistanceJointDef {
    JointBase base = {};
    float length = 1;  ///< m, >= 0.005: of the rod, or at which the spring rests
    JointSpring spring = {};
    JointLimit limit = {};  ///< m, lower >= 0
    JointMotor motor = {};
};

/// Holds two bodies together rigidly, or softly where a frequency is given.
struct WeldJointDef {
    JointBase base = {};
    float linear_hertz = 0;           ///< Hz, >= 0; 0 is rigid
    float linear_damping_ratio = 1;   ///< >= 0; 1 is critical
    float angular_hertz = 0;          ///< Hz, >= 0; 0 is rigid
    float angular_damping_ratio = 1;  ///< >= 0; 1 is critical
};

/// A wheel (B) on a sprung strut along A's x axis.
struct WheelJointDef {
    JointBase base = {};
    JointSpring spring = {true, 4, 0.7f};  ///< of the strut; by default 4 Hz, damping ratio 0.7
    JointLimit limit = {};                 ///< of the strut
    JointMotor motor = {};                 ///< turns the wheel
    float friction = 0;                    ///< N m, >= 0: resists the wheel's turning
};

/// Drives B relative to A: to a velocity, or, where a frequency is given, to the pose in which frame B lies on frame A. With velocity 0 it is the
/// friction of a body sliding on A, seen from above.
struct MotorJointDef {
    JointBase base = {};
    Vec2 linear_velocity = {};        ///< m/s in frame A, of B's point relative to A's
    float angular_velocity = 0;       ///< rad/s
    float max_force = 0;              ///< N, >= 0
    float max_torque = 0;             ///< N m, >= 0
    float linear_hertz = 0;           ///< Hz, >= 0; 0 drives the velocity, more the position
    float linear_damping_ratio = 1;   ///< >= 0; 1 is critical
    float angular_hertz = 0;          ///< Hz, >= 0; as above, for the angle
    float angular_damping_ratio = 1;  ///< >= 0; 1 is critical
};

/// Pulls a point of `body` to the target, which you can move: the point that is at `target` when the joint is made.
struct MouseJointDef {
    BodyId body = {};
    Vec2 target = {};            ///< m, world
    float hertz = 5;             ///< Hz, > 0
    float damping_ratio = 0.7f;  ///< >= 0; 1 is critical
    float max_force = 0;         ///< N, >= 0
    std::uint64_t user_data = 0;
};

/// A rope from A's point over two fixed points to B's point: length A + ratio * length B stays constant.
struct PulleyJointDef {
    JointBase base = {};
    Vec2 ground_a = {};  ///< m, world; must be at least 0.005 m from the bodies' points
    Vec2 ground_b = {};
    float ratio = 1;  ///< > 0, at most max_ratio
};

/// Couples the coordinates of two revolute or prismatic joints: c1 + ratio * c2 stays constant. Two hinges whose bodies
/// turn against each other have the ratio radius 2 / radius 1; a prismatic and a revolute joint make a rack and pinion. The gear is destroyed
/// with either joint.
struct GearJointDef {
    JointId joint1 = {};
    JointId joint2 = {};
    float ratio = 1;         ///< not 0, between -max_ratio and max_ratio
    float break_torque = 0;  ///< N m (N for a prismatic joint 1), >= 0; 0: never breaks
    std::uint64_t user_data = 0;
};

/// Lets an angle turn one way only. Teeth stand at phase + i step; the angle cannot go back past the last tooth that it has passed.
struct JointRatchet {
    float step = 0;   ///< rad from tooth to tooth, 0.001 to 100; negative: it turns backward only; 0: no ratchet
    float phase = 0;  ///< rad, the angle of any tooth; -10 000 to 10 000
};

/// Controls the angle between two bodies. Their positions stay free; the points of the frames only say where the joint is drawn.
struct AngleJointDef {
    JointBase base = {};
    JointSpring spring = {};
    JointLimit limit = {};
    JointMotor motor = {};
    float friction = 0;  ///< N m, >= 0: dry friction that resists turning
    JointRatchet ratchet = {};
};

/// How far a joint has come apart.
struct JointError {
    float linear = 0;   ///< m, >= 0; of a gear between prismatic joints too
    float angular = 0;  ///< rad, >= 0
};

/// A joint broke at the end of the last step and is gone.
struct JointBreakEvent {
    JointId joint = {};  ///< stale
    BodyId body_a = {};
    BodyId body_b = {};
    Vec2 force = {};   ///< N, on B, that it broke at
    float torque = 0;  ///< N m
    std::uint64_t user_data = 0;
};

}  // namespace islet
ISLET_API_END
