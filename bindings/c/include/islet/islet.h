// Islet for C, C11 or later: a 2D rigid-body physics engine in one fixed block of memory. docs/c.md is an introduction.
//
// Made by bindings/c/generate.py from the headers of the C++ interface; do not edit.
//
// Units are metres, kilograms, seconds and radians. Names follow C++: islet::BodyDef is IsletBodyDef, World::position(BodyId) is islet_body_position.
//
// Errors. A function that changes a world returns an IsletError. All others return their result, or a null or zero value on an error, which is then
// islet_world_last_error. On an error nothing has changed. Comments name errors in small letters: stale_id is ISLET_ERROR_STALE_ID. Three errors are of C
// alone: null_pointer (a pointer that must not be null is, the world's among them), struct_size and not_a_fleet.
//
// Structs that begin with struct_size may get further fields in later versions. Start from their default (islet_default_body_def), which sets the size. Of a
// wrong size they are refused: struct_size. Where such a struct holds another, it points to it; null stands for the default, or for a result that is not wanted.
// A null pointer also stands for the default where a comment says that it may be null.
//
// Memory. No function allocates. What a pointer or a span returned points to lives until the next call that changes the world.
#ifndef ISLET_ISLET_H
#define ISLET_ISLET_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#if defined(ISLET_SHARED_LIBRARY) && defined(__GNUC__)  // while the library itself is compiled
#define ISLET_C_API __attribute__((visibility("default")))
#else
#define ISLET_C_API
#endif

#ifdef __cplusplus
#define ISLET_ZERO {}
extern "C" {
#else
#define ISLET_ZERO {0}
#endif

#define ISLET_VERSION_MAJOR 0
#define ISLET_VERSION_MINOR 2
#define ISLET_VERSION_PATCH 0
#define ISLET_VERSION (ISLET_VERSION_MAJOR * 10000 + ISLET_VERSION_MINOR * 100 + ISLET_VERSION_PATCH)
#define ISLET_VERSION_STRING "0.2.0"

// -- constants -------------------------------------------------------------------------------------------------------------------------

#define ISLET_PI 3.14159265358979f
/// Most corners a convex polygon can have.
#define ISLET_MAX_POLYGON_VERTICES 8u
#define ISLET_DRAW_COLOR_STATIC_BODY 0xd8dce3u
#define ISLET_DRAW_COLOR_KINEMATIC 0xcdbfe9u
#define ISLET_DRAW_COLOR_AWAKE 0xf7bd6du
#define ISLET_DRAW_COLOR_ASLEEP 0xb4d2ebu
#define ISLET_DRAW_COLOR_BULLET 0xf08a5du
#define ISLET_DRAW_COLOR_DISABLED 0xeceae4u
#define ISLET_DRAW_COLOR_SENSOR 0x7fc8a9u
#define ISLET_DRAW_COLOR_JOINT 0x2f7d6bu
#define ISLET_DRAW_COLOR_IDLE_JOINT 0xb9c2ccu
#define ISLET_DRAW_COLOR_LIMIT 0xb5651du
#define ISLET_DRAW_COLOR_PRESSING 0xc4314bu
#define ISLET_DRAW_COLOR_TOUCHING 0xe59aa8u
#define ISLET_DRAW_COLOR_SPECULATIVE 0xb9c2ccu
#define ISLET_DRAW_COLOR_NORMAL 0xc4314bu
#define ISLET_DRAW_COLOR_NORMAL_IMPULSE 0x7a1fa2u
#define ISLET_DRAW_COLOR_FRICTION_IMPULSE 0x1565c0u
#define ISLET_DRAW_COLOR_BOX 0x5b8c5au
#define ISLET_DRAW_COLOR_FAT_BOX 0xa8b820u
#define ISLET_DRAW_COLOR_TREE_BOX 0x8d99a6u
#define ISLET_DRAW_COLOR_CENTER 0x2c3440u
#define ISLET_DRAW_COLOR_X_AXIS 0xd1352bu
#define ISLET_DRAW_COLOR_Y_AXIS 0x2e8b3du
#define ISLET_DRAW_COLOR_NAME 0x2c3440u
#define ISLET_DRAW_COLOR_OVERFLOW 0x111111u
/// The most workers that a task system may have.
#define ISLET_MAX_WORKERS 64u
/// No position may exceed this on either axis, m: beyond it, neighbouring floats are a metre apart. Bodies that fly farther stop there.
#define ISLET_MAX_POSITION 1.0e7f
/// The largest coefficient of friction or rolling resistance.
#define ISLET_MAX_COEFFICIENT 1.0e9f
/// The largest speed limit and surface speed, m/s.
#define ISLET_MAX_SPEED_LIMIT 1.0e6f
/// The shortest time step, s. Rounding would lose most of what a shorter step adds to a speed or a position.
#define ISLET_MIN_TIME_STEP 1.0e-6f
/// The largest IsletSolverDef.shock. Above it, piles of loose bodies gain energy.
#define ISLET_MAX_SHOCK 0.5f
/// The number of constraint colours.
#define ISLET_CONSTRAINT_COLOR_COUNT 32u
#define ISLET_JOINT_TYPE_COUNT 10u
/// The largest ratio of a pulley or a gear.
#define ISLET_MAX_RATIO 1.0e6f
/// Alignment that islet_create_world demands of its block.
#define ISLET_WORLD_ALIGNMENT 64u
/// No capacity may exceed this.
#define ISLET_MAX_CAPACITY (sizeof(void*) >= 8 ? 1u << 22 : 1u << 18)
/// The farthest that a ray or a cast may go along either axis, m.
#define ISLET_MAX_TRANSLATION (2.0f * ISLET_MAX_POSITION)
/// The formats that this version writes, and the only ones it reads. A format number goes up when the meaning of the bytes changes.
#define ISLET_SNAPSHOT_FORMAT 4u
#define ISLET_DELTA_FORMAT 4u
#define ISLET_RECORDING_FORMAT 2u
/// IsletRowEnd.body of an end that cannot be pushed: a static or kinematic body, or the world itself.
#define ISLET_NO_BODY 4294967295u
/// The distance that a mover keeps from surfaces, m.
#define ISLET_MOVER_GAP 0.01f
/// Alignment of the memory that holds a recording, bytes.
#define ISLET_RECORDING_ALIGNMENT 8u
/// Alignment that islet_world_load demands of an image, bytes. The other functions take any.
#define ISLET_SNAPSHOT_ALIGNMENT 8u

// -- enumerations, all one byte wide ---------------------------------------------------------------------------------------------------

typedef uint8_t IsletShapeType;
enum {
    ISLET_SHAPE_TYPE_CIRCLE = 0,
    ISLET_SHAPE_TYPE_CAPSULE = 1,
    ISLET_SHAPE_TYPE_SEGMENT = 2,
    ISLET_SHAPE_TYPE_POLYGON = 3,
    ISLET_SHAPE_TYPE_CHAIN_SEGMENT = 4,
    ISLET_SHAPE_TYPE_HALF_SPACE = 5,
};

/// The kind of a drawn thing, and whose slot IsletDrawStyle.slot is.
typedef uint8_t IsletDrawPart;
enum {
    /// IsletDrawStyle.slot is that of the body (islet_world_body_at)
    ISLET_DRAW_PART_SHAPE = 0,
    /// of the shape
    ISLET_DRAW_PART_BOX = 1,
    /// of the shape
    ISLET_DRAW_PART_FAT_BOX = 2,
    /// of the node of the tree
    ISLET_DRAW_PART_TREE_BOX = 3,
    /// of the joint (islet_world_joint_at)
    ISLET_DRAW_PART_JOINT = 4,
    /// of the contact (islet_world_contact_at)
    ISLET_DRAW_PART_CONTACT = 5,
    /// of the contact
    ISLET_DRAW_PART_NORMAL = 6,
    /// of the contact
    ISLET_DRAW_PART_IMPULSE = 7,
    /// of the body
    ISLET_DRAW_PART_CENTER = 8,
    /// of the body, or of the joint that the name is of
    ISLET_DRAW_PART_NAME = 9,
};

/// The colour of a dynamic body's shapes. Shapes of other bodies, sensors and disabled bodies keep their own colours.
typedef uint8_t IsletBodyColors;
enum {
    /// that of draw_color
    ISLET_BODY_COLORS_STATE = 0,
    /// distinct_color of the lowest slot of a body in its island, awake or not. Islands are found while drawing, from contacts and joints.
    ISLET_BODY_COLORS_ISLAND = 1,
};

/// What went wrong in a call. describe(e) returns a sentence that says what was wrong and how to fix it.
typedef uint8_t IsletError;
enum {
    ISLET_ERROR_NONE = 0,
    /// the id is null
    ISLET_ERROR_NULL_ID = 1,
    /// the object was destroyed, or the id belongs to another world
    ISLET_ERROR_STALE_ID = 2,
    /// an argument is NaN or infinite
    ISLET_ERROR_NOT_FINITE = 3,
    /// a number is outside the range its comment states
    ISLET_ERROR_OUT_OF_RANGE = 4,
    /// dt is not from min_time_step to 1 s
    ISLET_ERROR_BAD_TIME_STEP = 5,
    /// the geometry breaks its own rules
    ISLET_ERROR_BAD_GEOMETRY = 6,
    /// fewer than 2 points (3 for a loop), or neighbours closer than 0.005 m
    ISLET_ERROR_BAD_CHAIN = 7,
    /// raise IsletCapacity.bodies
    ISLET_ERROR_BODIES_FULL = 8,
    /// raise IsletCapacity.shapes
    ISLET_ERROR_SHAPES_FULL = 9,
    /// raise IsletCapacity.contacts, to 3 to 7 for each moving shape (the contact is retried every step)
    ISLET_ERROR_CONTACTS_FULL = 10,
    /// raise IsletCapacity.geometries
    ISLET_ERROR_GEOMETRIES_FULL = 11,
    /// the memory given is smaller than world_bytes(capacity)
    ISLET_ERROR_BLOCK_TOO_SMALL = 12,
    /// the memory given is not aligned to world_alignment
    ISLET_ERROR_BLOCK_MISALIGNED = 13,
    /// a capacity is zero where at least one is needed, or above max_capacity
    ISLET_ERROR_BAD_CAPACITY = 14,
    /// more contacts began or ended than there is room to report: raise IsletCapacity.events
    ISLET_ERROR_EVENTS_FULL = 15,
    /// raise IsletCapacity.joints
    ISLET_ERROR_JOINTS_FULL = 16,
    /// a joint needs two different bodies
    ISLET_ERROR_SAME_BODY = 17,
    /// a joint needs at least one dynamic body, and so does an island
    ISLET_ERROR_NO_DYNAMIC_BODY = 18,
    /// joints of this type have no such property, or cannot be geared
    ISLET_ERROR_WRONG_JOINT_TYPE = 19,
    /// the memory given for a snapshot or a delta is too small
    ISLET_ERROR_IMAGE_TOO_SMALL = 20,
    /// the image is not aligned to snapshot_alignment
    ISLET_ERROR_IMAGE_MISALIGNED = 21,
    /// the bytes are no snapshot (or no delta)
    ISLET_ERROR_NOT_AN_IMAGE = 22,
    /// the image comes from a machine of the other byte order
    ISLET_ERROR_OTHER_BYTE_ORDER = 23,
    /// another version of Islet wrote the image or recording: see read_format
    ISLET_ERROR_OTHER_VERSION = 24,
    /// the image is shorter or longer than it says
    ISLET_ERROR_TRUNCATED_IMAGE = 25,
    /// the image's bytes are not those that were saved
    ISLET_ERROR_CORRUPT_IMAGE = 26,
    /// the image's checksum is right, but what it holds is no world
    ISLET_ERROR_UNSOUND_IMAGE = 27,
    /// the world has less capacity than the image uses
    ISLET_ERROR_IMAGE_TOO_LARGE = 28,
    /// the delta does not start from the image given
    ISLET_ERROR_WRONG_DELTA = 29,
    /// this build of the engine lacks a part that the call needs (islet/config.hpp), or the program does not link it
    ISLET_ERROR_FEATURE_CUT = 30,
    /// the shape is no sensor
    ISLET_ERROR_NOT_A_SENSOR = 31,
    /// raise IsletCapacity.hits
    ISLET_ERROR_HITS_FULL = 32,
    /// the memory given for a recording is too small, or is used up: the recording ends before this call
    ISLET_ERROR_RECORDING_FULL = 33,
    /// the bytes are no recording, or the world is not being recorded
    ISLET_ERROR_NOT_A_RECORDING = 34,
    /// the recording is not as it was made
    ISLET_ERROR_CORRUPT_RECORDING = 35,
    /// called from a function that the world itself calls, such as a hook or a drawing function, and not allowed there
    ISLET_ERROR_IN_STEP = 36,
    /// the engine was compiled with flags that change the results of floats: islet_create_world returns null, and a StaticWorld does not step
    ISLET_ERROR_INEXACT_BUILD = 37,
    /// a dynamic body cannot have a half-space
    ISLET_ERROR_ENDLESS_SHAPE = 38,
    /// What a pointer to a fleet points to is none, or has been moved.
    ISLET_ERROR_NOT_A_FLEET = 253,
    /// A pointer that must not be null is null.
    ISLET_ERROR_NULL_POINTER = 254,
    /// A struct has a struct_size that no version of Islet up to this one gives it: start from its default.
    ISLET_ERROR_STRUCT_SIZE = 255,
};

/// What a step consists of. `soft` is the default; `classic` is one velocity solve per step, with position correction.
typedef uint8_t IsletSchedule;
enum {
    /// substeps of: integrate, biased sweep with soft contacts, integrate positions, relax sweep
    ISLET_SCHEDULE_SOFT = 0,
    /// per substep: integrate, `iterations` sweeps with Baumgarte bias, integrate positions. Use with substeps = 1.
    ISLET_SCHEDULE_CLASSIC = 1,
};

/// Which hinges (revolute joints) are solved exactly, all of a joint tree together, instead of one by one in sweeps. Hinges that close a loop of moving
/// bodies are always swept, and so are hinges with a spring.
typedef uint8_t IsletJointTrees;
enum {
    /// none
    ISLET_JOINT_TREES_OFF = 0,
    /// those of trees in which a hinge carries at least IsletSolverDef.joint_tree_load times the mass of one of its bodies, and no hinge must be swept. A
    /// tree that static or kinematic bodies hold in several places is swept if one of its hinges can break. A tree with a limit, a motor or friction is
    /// solved exactly only while one of these hinges bears more than 2500 m/s^2 times the mass of its lighter body (or its limits bear a torque that gives
    /// that body 10 000 m/s^2 at its radius of gyration), and until it has borne less than a quarter of that for 16 steps on end; held in several places, it
    /// is swept.
    ISLET_JOINT_TREES_AUTOMATIC = 1,
    /// all that can be. An angle that is beyond a limit of a hinge solved exactly, as set or swept there, returns by at most 0.25 rad/s.
    ISLET_JOINT_TREES_ALL = 2,
};

/// The order in which a sweep visits contacts. (In every order, joints come before the contacts and joint trees after them.)
typedef uint8_t IsletSweepOrder;
enum {
    /// by colours, as many at once as there are lanes: the fastest by far
    ISLET_SWEEP_ORDER_COLORED = 0,
    /// one by one, in the order of their slots
    ISLET_SWEEP_ORDER_AS_FOUND = 1,
    /// one by one, from the lowest to the highest against gravity: one sweep passes support up through all layers, but weight down by only one layer
    ISLET_SWEEP_ORDER_UPWARD = 2,
    /// one by one, from the highest to the lowest
    ISLET_SWEEP_ORDER_DOWNWARD = 3,
};

typedef uint8_t IsletBodyType;
enum {
    /// Never moves, infinite mass.
    ISLET_BODY_TYPE_STATIC_BODY = 0,
    /// Moves by its velocity only, infinite mass.
    ISLET_BODY_TYPE_KINEMATIC = 1,
    /// Moves by forces and contacts.
    ISLET_BODY_TYPE_DYNAMIC = 2,
};

/// revolute, prismatic and so on: the names in ISLET_JOINT_TYPES (islet/config.hpp), in that order.
typedef uint8_t IsletJointType;
enum {
    ISLET_JOINT_TYPE_REVOLUTE = 0,
    ISLET_JOINT_TYPE_PRISMATIC = 1,
    ISLET_JOINT_TYPE_DISTANCE = 2,
    ISLET_JOINT_TYPE_WELD = 3,
    ISLET_JOINT_TYPE_WHEEL = 4,
    ISLET_JOINT_TYPE_MOTOR = 5,
    ISLET_JOINT_TYPE_MOUSE = 6,
    ISLET_JOINT_TYPE_PULLEY = 7,
    ISLET_JOINT_TYPE_GEAR = 8,
    ISLET_JOINT_TYPE_ANGLE = 9,
};

/// What an action does to a world before a step.
typedef uint8_t IsletDriveKind;
enum {
    /// N on the body's centre of mass, along the world's x, during the next step
    ISLET_DRIVE_KIND_FORCE_X = 0,
    /// the same along y
    ISLET_DRIVE_KIND_FORCE_Y = 1,
    /// N m on the body, during the next step
    ISLET_DRIVE_KIND_TORQUE = 2,
    /// N m on body_b of the joint, and its opposite on body_a, during the next step
    ISLET_DRIVE_KIND_JOINT_TORQUE = 3,
    /// the speed of the joint's motor, rad/s or m/s, until it is changed again
    ISLET_DRIVE_KIND_MOTOR_SPEED = 4,
    /// the greatest force of the joint's motor, N m or N: of the action's absolute value
    ISLET_DRIVE_KIND_MOTOR_FORCE = 5,
    /// the target of a mouse joint, m in the world
    ISLET_DRIVE_KIND_TARGET_X = 6,
    /// the same for y
    ISLET_DRIVE_KIND_TARGET_Y = 7,
};

/// What an observation tells of a world after a step.
typedef uint8_t IsletSenseKind;
enum {
    /// 2 columns: of the body's origin in the world, m
    ISLET_SENSE_KIND_POSITION = 0,
    /// 2 columns: cosine and sine of the body's angle
    ISLET_SENSE_KIND_ROTATION = 1,
    /// 2 columns: of the body's centre of mass, m/s
    ISLET_SENSE_KIND_VELOCITY = 2,
    /// 1 column, rad/s
    ISLET_SENSE_KIND_ANGULAR_VELOCITY = 3,
    /// 2 columns: the joint's position (rad or m) and speed
    ISLET_SENSE_KIND_JOINT = 4,
    /// 1 column: 1 if a shape of the body touches another, else 0
    ISLET_SENSE_KIND_TOUCHING = 5,
    /// 1 column: the fraction of a ray, fixed to the body, at which it meets a shape of another body; 1 if it meets none
    ISLET_SENSE_KIND_RAY = 6,
};

/// What some bytes are, by how they begin.
typedef uint8_t IsletFormatKind;
enum {
    /// nothing of Islet's
    ISLET_FORMAT_KIND_UNKNOWN = 0,
    /// from islet_world_save
    ISLET_FORMAT_KIND_SNAPSHOT = 1,
    /// from delta()
    ISLET_FORMAT_KIND_DELTA = 2,
    /// from islet_world_start_recording
    ISLET_FORMAT_KIND_RECORDING = 3,
};

/// The kind of a row, with its bounds lo, hi and its bias.
typedef uint8_t IsletRowKind;
enum {
    /// of a point of a contact: 0, infinity; bias max(separation, 0) / h
    ISLET_ROW_KIND_NORMAL = 0,
    /// of a point, along right_perp(normal): +-coefficient times the x of the point's normal row (Problem::friction); bias -tangent speed
    ISLET_ROW_KIND_FRICTION = 1,
    /// of a contact. The engine bounds it by the resistance times the sum of the contact's normal impulses. Problem::friction names only one row, so here the
    /// sum is that of `impulses`, frozen
    ISLET_ROW_KIND_ROLLING = 2,
    /// a direction that a joint locks: -infinity, infinity
    ISLET_ROW_KIND_JOINT = 3,
    /// -infinity, infinity; softness and bias are those of the spring, or of a soft weld
    ISLET_ROW_KIND_SPRING = 4,
    /// 0, infinity; the row of an upper limit is turned around. bias max(way left, 0) / h
    ISLET_ROW_KIND_LIMIT = 5,
    /// +-h times the greatest force or torque; bias -speed. The point of a motor or mouse joint makes two such rows: the engine bounds the length of both,
    /// here each has its own bounds. With a frequency, the rows have softness and bias
    ISLET_ROW_KIND_MOTOR = 6,
    /// +-h times the friction of the joint
    ISLET_ROW_KIND_JOINT_FRICTION = 7,
};

/// How a replay ended.
typedef uint8_t IsletReplayEnd;
enum {
    /// everything was replayed, and each hash was the recorded one
    ISLET_REPLAY_END_COMPLETE = 0,
    /// the replay has made as many steps as you asked for
    ISLET_REPLAY_END_STOPPED = 1,
    /// a step came out differently
    ISLET_REPLAY_END_DIFFERS = 2,
    /// the recording is not sound; `error` says why
    ISLET_REPLAY_END_REFUSED = 3,
};


// -- types -----------------------------------------------------------------------------------------------------------------------------

/// A world. It lives in memory of yours (islet_create_world).
typedef struct IsletWorld IsletWorld;

/// 0xrrggbb.
typedef uint32_t IsletDrawColor;

/// Receives each error as it happens. The hook may read the world's bodies and shapes. Calls from the hook that would change the world are refused (in_step),
/// and the hook does not receive those errors.
typedef void (*IsletErrorHook)(IsletError error, void* context);

/// Reads a clock of yours, which counts up in any unit you like. It must not call the world.
typedef uint64_t (*IsletClock)(void* context);

typedef struct IsletPreSolve IsletPreSolve;

/// A point or direction, metres unless said otherwise.
typedef struct IsletVec2 {
    float x;
    float y;
} IsletVec2;

/// A rotation as cosine and sine of its angle; by default the angle is 0. Invariant: c^2 + s^2 = 1 but for rounding.
typedef struct IsletRot {
    float c;
    float s;
} IsletRot;

/// A pose: rotate by q, then move by p (metres).
typedef struct IsletTransform {
    IsletVec2 p;
    IsletRot q;
} IsletTransform;

/// An axis-aligned box, m. Valid when lower <= upper on both axes.
typedef struct IsletAabb {
    IsletVec2 lower;
    IsletVec2 upper;
} IsletAabb;

/// A solid disc. radius > 0, metres.
typedef struct IsletCircle {
    IsletVec2 center;
    float radius;
} IsletCircle;

/// All points within `radius` of the segment point1-point2. radius > 0; the points must be more than 0.005 m apart.
typedef struct IsletCapsule {
    IsletVec2 point1;
    IsletVec2 point2;
    float radius;
} IsletCapsule;

/// A line segment that collides on both sides and has no mass. The points must be more than 0.005 m apart.
typedef struct IsletSegment {
    IsletVec2 point1;
    IsletVec2 point2;
} IsletSegment;

/// One segment of a chain. It collides only on the right of point1 -> point2: its outward normal is right_perp(point2 - point1). So a floor runs from right
/// to left. The ghost points are the far ends of the neighbouring segments. They tell the engine which corners are inner corners, so that bodies do not catch
/// on them. A ghost point may lie beyond max_position, up to 4e7 m from the origin, so that the last segment of a chain can continue straight on.
typedef struct IsletChainSegment {
    IsletVec2 ghost1;
    IsletSegment segment;
    IsletVec2 ghost2;
} IsletChainSegment;

/// Everything on the inner side of an infinite line: the ground of a small world. Only static and kinematic bodies can have one, and it has no mass. It
/// collides with circles, capsules and polygons. Its bounding box ends at 8e7 m.
typedef struct IsletHalfSpace {
    /// unit, outward
    IsletVec2 normal;
    /// m, from the body's origin to the surface along the normal; 1e7 m at most
    float offset;
} IsletHalfSpace;

/// The corners of a convex polygon, m, counter-clockwise. count = 0 means that no hull could be made.
typedef struct IsletHull {
    IsletVec2 points[8];
    uint32_t count;
} IsletHull;

/// A solid convex polygon, counter-clockwise, with outward unit normals (normal i belongs to the edge from vertex i to i + 1), rounded by `radius` (metres,
/// >= 0) around its corners. Make one with make_polygon or make_box. If you fill one in by hand, it is checked when you use it.
typedef struct IsletPolygon {
    IsletVec2 vertices[8];
    IsletVec2 normals[8];
    IsletVec2 centroid;
    float radius;
    uint32_t count;
} IsletPolygon;

/// Mass (kg), centre of mass (m, local) and rotational inertia about that centre (kg m^2).
typedef struct IsletMassData {
    float mass;
    IsletVec2 center;
    float inertia;
} IsletMassData;

/// How to draw a thing, and what it belongs to. A plain picture needs only the colour.
typedef struct IsletDrawStyle {
    IsletDrawColor color;
    IsletDrawPart part;
    /// Polygons, circles and capsules are filled. True for shapes but sensors; false for boxes and the marks of joints.
    bool solid;
    /// of what the thing belongs to
    uint32_t slot;
} IsletDrawStyle;

/// The functions that draw, and the parts of the world to draw. Functions may be null, and may not change the world (in_step). The pointers that they get are
/// valid only during the call.
typedef struct IsletDebugDraw {
    uint32_t struct_size;  ///< sizeof(IsletDebugDraw)
    uint32_t reserved;     ///< 0
    /// A convex polygon, counter-clockwise, rounded by `radius` (>= 0) around its corners. The first edge is always the same edge of the shape, so a mark on
    /// it shows how the shape turns.
    void (*polygon)(const IsletVec2* corners, size_t corners_count, float radius, const IsletDrawStyle* style, void* context);
    /// `axis` is a unit vector that turns with the circle.
    void (*circle)(IsletVec2 center, float radius, IsletVec2 axis, const IsletDrawStyle* style, void* context);
    /// All points within `radius` of a line.
    void (*capsule)(IsletVec2 point1, IsletVec2 point2, float radius, const IsletDrawStyle* style, void* context);
    void (*segment)(IsletVec2 point1, IsletVec2 point2, const IsletDrawStyle* style, void* context);
    /// A dot, as large as you like.
    void (*point)(IsletVec2 point, const IsletDrawStyle* style, void* context);
    /// Plain ASCII, ended by a zero.
    void (*text)(IsletVec2 point, const char* text, const IsletDrawStyle* style, void* context);
    /// passed on to all of them
    void* context;
    /// m. Things outside are left out. By default all are drawn.
    IsletAabb view;
    /// m, > 0: of the marks of joints and of normals and axes
    float size;
    /// m for each N s, >= 0
    float impulse_scale;
    bool shapes;
    bool joints;
    /// a point for each point of each contact
    bool contacts;
    /// of contacts, from A to B
    bool normals;
    /// of contacts over the last substep, on B: along the normal, and of friction along the surface
    bool impulses;
    /// the tight box of each shape
    bool boxes;
    /// the fat box of each shape, with which pairs are found; the shape keeps it until it leaves it
    bool fat_boxes;
    /// the boxes of the tree of resting shapes; its leaves, which are fat boxes, are left out
    bool tree;
    /// the centre of mass and the axes of each body that is not static
    bool centers;
    /// the slot of each body that is not static at its centre, the type of each joint at its place
    bool names;
    IsletBodyColors body_colors;
    /// joints, contact points and normals in distinct_color of the constraint colour (0 to 31) they are solved with
    bool constraint_colors;
    /// Null, or where to draw the shapes instead of where they are: a pose for each slot of a body, capacity().bodies of them. For pictures between two
    /// steps: keep each body's transform before the step, and lerp to the one after it.
    const IsletTransform* poses;
} IsletDebugDraw;

/// Runs the parts of a stage of a step on threads of yours: a pool, OpenMP, TBB, or one after another. The number of threads and the order of the parts never
/// change a bit of a result. samples/workers/thread_pool.hpp is an example; samples/workers/workers.cpp uses it.
typedef struct IsletTaskSystem {
    uint32_t struct_size;  ///< sizeof(IsletTaskSystem)
    uint32_t reserved;     ///< 0
    /// Calls task(data, index) once for each 0 <= index < count, in any order and on any threads, and returns when all calls have returned. The caller must
    /// then see what they wrote. islet_world_step calls this function on its own thread, tens to hundreds of times a step, so it should be cheap. Tasks never
    /// call it. Null: the world steps on the calling thread alone.
    void (*parallel_for)(void* context, uint32_t count, void (*task)(void* data, uint32_t index), void* data);
    /// passed on to parallel_for
    void* context;
    /// Threads that run tasks, including the calling one, 1 to max_workers. With 1, parallel_for is never called.
    uint32_t workers;
    /// How many of the workers run tasks at the moment, 1 to `workers`, including the calling thread. (0 counts as 1, more than `workers` as `workers`.)
    /// islet_world_step asks once, at its beginning, and steps with so many. So a pool can say that threads of it have lost their cores to another program,
    /// and the step is not cut into parts for them, which costs a few per cent. Null: all of them.
    uint32_t (*ready_workers)(void* context);
} IsletTaskSystem;

/// The id of a body; null by default. Ids are safe to keep: when its body is destroyed, an id becomes stale, and it never refers to another body. Ids compare
/// by slot, then by generation; IdHash (hash.hpp) makes them keys of unordered containers.
typedef struct IsletBodyId {
    uint32_t index1;
    uint32_t generation;
} IsletBodyId;

/// The id of a shape. The same rules hold as for BodyId.
typedef struct IsletShapeId {
    uint32_t index1;
    uint32_t generation;
} IsletShapeId;

/// How many objects of each kind a world can hold. The capacity decides the size of the memory block (world_bytes) and nothing else.
typedef struct IsletCapacity {
    uint32_t struct_size;  ///< sizeof(IsletCapacity)
    uint32_t bodies;
    uint32_t shapes;
    /// Pairs of shapes whose fat boxes overlap, touching or not: 3 to 5 a body in a dense pile, 7 if it is squeezed.
    uint32_t contacts;
    uint32_t joints;
    /// Different geometries (equal ones are stored once); 0 means as many as shapes.
    uint32_t geometries;
    /// Hit events in one step; 0 means an eighth of the contacts, at least 8.
    uint32_t hits;
    /// Touches that begin in one step, and as many that end, those of sensors included; 0 means as many as contacts, which are always enough. More are
    /// dropped and counted (IsletStepReport.dropped_events, ISLET_ERROR_EVENTS_FULL).
    uint32_t events;
} IsletCapacity;

/// Functions of yours that a step calls, to let you decide something. Each may be null and gets `context`. Hooks are not part of the state: hashes and
/// snapshots do not contain them. Worlds that are to have equal futures need hooks that give equal answers. The world calls filter and pre_solve on the
/// thread that steps, one after another, in an order that does not depend on the number of workers. They may read the world's bodies and shapes, but not
/// change the world (in_step). The world calls mix_friction and mix_restitution on any worker, as often as it likes, so their answers must depend on their
/// arguments alone.
typedef struct IsletHooks {
    uint32_t struct_size;  ///< sizeof(IsletHooks)
    uint32_t reserved;     ///< 0
    /// Returns whether two shapes may meet, or a sensor may see a shape. shape_a is the one in the lower slot. The world asks about pairs that their filters
    /// allow, when their fat boxes begin to overlap. After a no it asks again when it finds the pair again. After a yes it asks again only after the fat
    /// boxes have parted.
    bool (*filter)(IsletShapeId shape_a, IsletShapeId shape_b, void* context);
    /// Sees a contact before it is solved, and may change it for this step (PreSolve). Each step calls the hook for every awake contact that has points and a
    /// shape with IsletShapeDef.pre_solve, in the order of their slots. A fast body has a contact with each shape that it may hit during the step, and
    /// continuous collision obeys the hook's decision. If a one-way shape (IsletShapeDef.one_way) lets the other shape pass, the hook is not called.
    void (*pre_solve)(IsletPreSolve* contact, void* context);
    /// Returns the friction coefficient of two shapes, in place of the geometric mean; `material` is IsletSurfaceMaterial.id. The result is limited to 0 to
    /// max_coefficient. Called when the fat boxes of two shapes begin to overlap, and when a material changes.
    float (*mix_friction)(float friction_a, uint32_t material_a, float friction_b, uint32_t material_b, void* context);
    /// Returns the restitution of two shapes, in place of the larger of both. The result is limited to 0 to 1. Called in steps, too.
    float (*mix_restitution)(float restitution_a, uint32_t material_a, float restitution_b, uint32_t material_b, void* context);
    void* context;
} IsletHooks;

/// How the solver works. Change it at any time with islet_world_set_solver.
typedef struct IsletSolverDef {
    uint32_t struct_size;  ///< sizeof(IsletSolverDef)
    IsletSchedule schedule;
    /// 1 to 64. More: stiffer stacks and joints, cost in proportion.
    uint32_t substeps;
    /// 1 to 256 biased sweeps per substep.
    uint32_t iterations;
    /// 0 to 256 unbiased sweeps per substep (soft schedule).
    uint32_t relax_iterations;
    /// Hz, > 0. Stiffness of soft contacts; capped at an eighth of the substep rate.
    float contact_hertz;
    /// >= 0. Soft contacts are overdamped so that they do not bounce.
    float contact_damping_ratio;
    /// m/s, >= 0. The fastest that overlapping shapes are pushed apart.
    float contact_push_speed;
    /// Hz, > 0. Stiffness with which joints correct their errors; capped at a quarter of the substep rate, and at a fifth where a body of the joint belongs
    /// to a joint tree that is solved exactly. A rigid joint that is swept gives way by F / (m (2 pi joint_hertz)^2) under a steady force F, where m is the
    /// mass that it moves. A limit does not give way to the joint's own motor. To any other steady load it first gives way as much as a rigid joint does; 128
    /// steps of 1/60 s later, about a third of that error is left. (A load that would give the lighter body more than 100 m/s^2 is taken up more slowly, in
    /// inverse proportion.)
    float joint_hertz;
    /// >= 0
    float joint_damping_ratio;
    /// 0 to 1. Share of overlaps and joint errors corrected per step (classic schedule).
    float baumgarte;
    /// 0 < omega < 2. Relaxation factor (SOR); 1 is plain PGS.
    float omega;
    /// Start each step from the impulses of the last.
    bool warm_start;
    /// Which hinges are solved exactly instead of swept.
    IsletJointTrees joint_trees;
    /// >= 1. With ISLET_JOINT_TREES_AUTOMATIC, a tree is solved exactly if one of its hinges bears at least so many times the mass of the lighter body that
    /// it joins. Lower values: more trees. (Not for masses above 1e18 kg, whose squares overflow.)
    float joint_tree_load;
    /// With block_contacts, colored stands for as_found.
    IsletSweepOrder sweep_order;
    /// Solve the two normal impulses of a contact together, exactly.
    bool block_contacts;
    /// 0 to max_shock. Shock propagation: the solver treats each body as lighter, by this share, than the body it lies on. Use it for stacks at rest:
    /// impacts, and the forces that joints report, are those of the lighter bodies. (Contacts report the weight of what lies on them.) Do not use 0.5 with
    /// joints in the pile.
    float shock;
    /// Measure after each step how far the impulses are from a solution: islet_body_residual.
    bool measure_residual;
    /// m/s, >= 0. Above 0, a substep ends its biased sweeps, and then its relaxing sweeps, as soon as the residual is at most this. The islands of one batch
    /// (IsletStepReport.batches) end together. Each measurement costs two to three sweeps.
    float tolerance;
} IsletSolverDef;

/// What a new world is like.
typedef struct IsletWorldDef {
    uint32_t struct_size;  ///< sizeof(IsletWorldDef)
    uint32_t reserved;     ///< 0
    /// m/s^2
    IsletVec2 gravity;
    const IsletSolverDef* solver;
    /// Let islands at rest fall asleep after 0.5 s.
    bool enable_sleep;
    /// m/s, >= 0. Slower impacts do not bounce.
    float restitution_threshold;
    /// m/s, > 0, at most max_speed_limit. No body moves faster.
    float max_speed;
    /// m/s, >= 0. Hit events report shapes that come together faster.
    float hit_threshold;
    /// Continuous collision: however fast bodies move and turn, and however hard they are pressed, dynamic ones do not pass through static shapes, and
    /// bullets pass through no other body. (Other bullets may still crowd a bullet into a moving body.)
    bool continuous;
    /// What slides over shapes that lie side by side does not catch at the edges between them: where one covers the edge of the next, that makes no contact.
    /// (In chains, segments know their neighbours without this.)
    bool seamless_floors;
    /// How many constraints are solved at once: at most 1, 4, 8 or 16; 0: as many as can be. The bits are the same.
    uint32_t lanes;
    IsletErrorHook error_hook;
    void* error_context;
    /// See islet_world_set_hooks.
    const IsletHooks* hooks;
    /// Threads to step with; none by default. The bits are the same.
    const IsletTaskSystem* tasks;
    /// Measures islet_world_profile; none by default. The bits are the same.
    IsletClock clock;
    void* clock_context;
} IsletWorldDef;

/// What a new body is like.
typedef struct IsletBodyDef {
    uint32_t struct_size;  ///< sizeof(IsletBodyDef)
    uint32_t reserved;     ///< 0
    IsletBodyType type;
    /// m, of the body's origin; within max_position
    IsletVec2 position;
    /// rad
    float angle;
    /// m/s, of the centre of mass
    IsletVec2 linear_velocity;
    /// rad/s
    float angular_velocity;
    /// 1/s, >= 0
    float linear_damping;
    /// 1/s, >= 0
    float angular_damping;
    /// multiple of the gravity that the body feels
    float gravity_scale;
    /// m/s, >= 0. Slower bodies may fall asleep, unless a motor or a belt keeps them going.
    float sleep_threshold;
    /// false: the body keeps itself and its island awake.
    bool enable_sleep;
    /// false: the body starts asleep.
    bool awake;
    /// true: the body has infinite rotational inertia, and starts with no angular velocity.
    bool fixed_rotation;
    /// true: the centre of mass of a dynamic body does not move along the world's x axis, whatever pushes it. The lock
    bool lock_x;
    /// is solved like a contact, in every sweep. lock_y does the same along y.
    bool lock_y;
    /// false: the body takes part in nothing (islet_body_set_enabled).
    bool enabled;
    /// true: the body does not pass through moving bodies either (IsletWorldDef.continuous). Use it for few bodies: each is compared with every awake body.
    bool bullet;
    uint64_t user_data;
} IsletBodyDef;

/// Decides which shapes meet. Shapes of the same positive group always meet; those of the same negative group never do. Otherwise each mask must contain the
/// other shape's category.
typedef struct IsletFilter {
    uint32_t category;
    uint32_t mask;
    int32_t group;
} IsletFilter;

/// The material of a surface: four fields as in ShapeDef (IsletShapeDef.friction and so on, with their units), and a number of yours, which the mixing hooks
/// get.
typedef struct IsletSurfaceMaterial {
    float friction;
    float restitution;
    float rolling_resistance;
    float tangent_speed;
    uint32_t id;
} IsletSurfaceMaterial;

/// What a new shape is like.
typedef struct IsletShapeDef {
    uint32_t struct_size;  ///< sizeof(IsletShapeDef)
    uint32_t reserved;     ///< 0
    /// Coulomb coefficient, 0 to max_coefficient. Two shapes have the geometric mean of both.
    float friction;
    /// 0 to 1. Two shapes have the larger of both.
    float restitution;
    /// 0 to max_coefficient. Times the larger radius, it is the lever arm of the resisting torque. Two shapes have the larger.
    float rolling_resistance;
    /// m/s. A conveyor: it carries what lies on the surface to its right (clockwise around the shape). Two shapes add up.
    float tangent_speed;
    /// kg/m^2, >= 0
    float density;
    IsletFilter filter;
    /// The shape collides with nothing, and reports the shapes that overlap it. It sees shapes of all other bodies that its filter allows and whose
    /// sensor_events is true. But a static sensor does not see static bodies, no sensor sees another one, and a shape that passes all of it within one step
    /// is not seen. A sensor has mass, by its density.
    bool sensor;
    /// false: sensors do not see this shape. (In Box2D from version 3.1 on, the default is false.)
    bool sensor_events;
    /// true: report hits of this shape (islet_world_hit_events).
    bool hit_events;
    /// true: call the pre_solve hook for contacts of this shape.
    bool pre_solve;
    /// Not zero: the shape is a one-way platform. It holds only shapes that come from the side to which this direction points, in the body's frame ({0, 1}:
    /// from above). The length does not matter; the angle is kept to 1/1000 rad. Another shape passes until all of it is beyond the platform's farthest point
    /// along the direction. Then the platform holds it until it leaves. The platform holds bodies, also fast ones, and movers; queries see it like any other
    /// shape. A body on the platform drops through if the pre_solve hook disables the contact once (pre_solve of either shape), or if a filter forbids the
    /// contact. Two one-way shapes collide only if each holds the other. The engine works out from the velocities where two shapes were before they met, so a
    /// body may pass if you set its velocity in the very step in which they meet. Errors: not_finite; feature_cut.
    IsletVec2 one_way;
    /// IsletSurfaceMaterial.id
    uint32_t material;
    uint64_t user_data;
} IsletShapeDef;

/// Two shapes began or ceased to touch in the last step, or ceased because one was destroyed since. An id in an end event may be stale. Here and wherever two
/// shapes of a contact are named, shape_a has the later type in the order circle, capsule, polygon, segment, chain segment, half-space. If both types are
/// equal, shape_a is the shape in the lower slot.
typedef struct IsletTouchEvent {
    IsletShapeId shape_a;
    IsletShapeId shape_b;
} IsletTouchEvent;

/// A shape began or ceased to overlap a sensor, or ceased because one of them was destroyed, disabled or moved. An id in an end event may be stale.
typedef struct IsletSensorEvent {
    IsletShapeId sensor;
    IsletShapeId visitor;
} IsletSensorEvent;

/// Two shapes came together fast.
typedef struct IsletHitEvent {
    IsletShapeId shape_a;
    IsletShapeId shape_b;
    /// m, midway between the surfaces, where they came together the fastest
    IsletVec2 point;
    /// unit, from a to b
    IsletVec2 normal;
    /// m/s, with which the surfaces came together along the normal, before they pushed each other
    float speed;
} IsletHitEvent;

/// An explosion (islet_world_explode).
typedef struct IsletExplosionDef {
    uint32_t struct_size;  ///< sizeof(IsletExplosionDef)
    /// m
    IsletVec2 position;
    /// m, >= 0. Shapes that are nearer feel all of it.
    float radius;
    /// m, >= 0. Beyond the radius the impulse falls linearly to 0 over this distance.
    float falloff;
    /// N s per metre of the shape's width as seen from there; below 0: an implosion
    float impulse_per_length;
    /// Shapes of these categories feel it.
    uint32_t mask;
} IsletExplosionDef;

/// Wind on a shape (islet_shape_apply_wind).
typedef struct IsletWindDef {
    uint32_t struct_size;  ///< sizeof(IsletWindDef)
    /// m/s, of the air; up to max_speed_limit
    IsletVec2 velocity;
    /// >= 0, coefficient of the force along the stream: 1.2 to 2 for a flat plate across it, about 1 for a disc
    float drag;
    /// coefficient of the force across the stream
    float lift;
    /// kg/m^3, >= 0, of a slice one metre deep: air
    float density;
    /// false: no effect on bodies that sleep, and bodies that rest may fall asleep in the wind
    bool wake;
} IsletWindDef;

/// What the last step did.
typedef struct IsletStepReport {
    uint32_t struct_size;  ///< sizeof(IsletStepReport)
    /// all, of every type
    uint32_t bodies;
    /// awake dynamic and kinematic ones after the step
    uint32_t awake_bodies;
    uint32_t shapes;
    /// pairs with overlapping fat boxes, touching or not, asleep or not
    uint32_t contacts;
    /// awake contacts that touch
    uint32_t touching_contacts;
    /// awake contacts whose manifold was kept
    uint32_t recycled_contacts;
    /// Pairs that found no room in this step, counted up to IsletCapacity.contacts. Their shapes pass through each other. Each step tries them again, and
    /// fails with contacts_full while there is no room. Raise IsletCapacity.contacts: 3 to 5 for each moving shape of a dense pile, 7 where the pile is
    /// squeezed.
    uint32_t dropped_contacts;
    /// begin and end events that found no room since the last step began
    uint32_t dropped_events;
    /// hits that found no room among the hit events
    uint32_t dropped_hits;
    /// awake islands
    uint32_t islands;
    /// constraint colours in use
    uint32_t colors;
    /// contacts solved one by one: those without a colour, or all if the SweepOrder is not colored
    uint32_t overflow_contacts;
    uint32_t batches;
    /// all
    uint32_t joints;
    /// those solved
    uint32_t awake_joints;
    /// joints solved one by one: gears, and those without a colour
    uint32_t overflow_joints;
    /// of the batch with the most sweeps; fewer than SolverDef asks for if the tolerance ended them
    uint32_t sweeps;
    /// m/s, the largest of all islands (islet_body_residual); 0 if not measured
    float residual;
} IsletStepReport;

/// How long the stages of the last step took, in ticks of IsletWorldDef.clock; all 0 without a clock.
typedef struct IsletStepProfile {
    uint32_t struct_size;  ///< sizeof(IsletStepProfile)
    uint32_t reserved;     ///< 0
    /// which fat boxes overlap
    uint64_t pairs;
    /// where and how shapes touch
    uint64_t collide;
    /// which constraints are solved together, and in which order
    uint64_t islands;
    /// forces, impulses and motion
    uint64_t solve;
    /// poses, boxes, sleep and events
    uint64_t finish;
    /// the whole step: the sum of these
    uint64_t total;
} IsletStepProfile;

/// Figures of a world for displays, beside those of StepReport. islet_world_counters counts them when you call it.
typedef struct IsletWorldCounters {
    uint32_t struct_size;  ///< sizeof(IsletWorldCounters)
    uint32_t reserved;     ///< 0
    /// of the world's block: world_bytes(capacity)
    size_t bytes;
    /// bytes that save() needs now
    size_t snapshot_bytes;
    /// different ones
    uint32_t geometries;
    /// shapes at rest, in the tree of boxes; the others are sorted
    uint32_t tree_shapes;
    /// boxes on the way from the tree's root to its farthest leaf; 0 if it is empty
    uint32_t tree_height;
    /// touching contacts and joints by constraint colour, awake or not
    uint32_t colors[32];
    /// touching contacts and joints without a colour, which are solved one by one
    uint32_t uncolored;
} IsletWorldCounters;

/// One touching point of a contact, in world coordinates. The force over a substep of h = dt / substeps seconds is impulse / h newtons, so a body that stands
/// still bears normal_impulse / h.
typedef struct IsletContactPoint {
    /// m, midway between the surfaces
    IsletVec2 point;
    /// m, negative when overlapping
    float separation;
    /// N s over the last substep
    float normal_impulse;
    /// N s over the last substep
    float tangent_impulse;
    /// names the features (corners, sides) of the two shapes that made the point
    uint32_t feature;
} IsletContactPoint;

/// A contact of two shapes that touch.
typedef struct IsletContactInfo {
    IsletShapeId shape_a;
    IsletShapeId shape_b;
    /// unit, from a to b
    IsletVec2 normal;
    IsletContactPoint points[2];
    uint32_t point_count;
    /// Coulomb coefficient of the two surfaces
    float friction;
    /// 0 to 1
    float restitution;
} IsletContactInfo;

/// A contact as the pre_solve hook sees it, and what the hook may change for this one step.
struct IsletPreSolve {
    /// as it is before the step, with the impulses of the last one; changing it has no effect
    IsletContactInfo contact;
    /// false: the two shapes do not touch in this step, and no event says that they do
    bool enabled;
    /// Coulomb coefficient, 0 to max_coefficient
    float friction;
    /// m/s, the sum of both shapes' IsletShapeDef.tangent_speed
    float tangent_speed;
};

/// The id of a joint. The same rules hold as for BodyId.
typedef struct IsletJointId {
    uint32_t index1;
    uint32_t generation;
} IsletJointId;

/// A joint's place on a body, relative to the body's origin.
typedef struct IsletJointFrame {
    /// m, within max_position
    IsletVec2 position;
    /// rad. The x axis of frame A is the axis of prismatic and wheel joints.
    float angle;
} IsletJointFrame;

/// A spring that pulls the joint's coordinate to a target. Its stiffness follows from the masses it moves, so it behaves the same for heavy and light bodies:
/// hertz is the frequency it would swing with if it were the only constraint (Catto, "Soft Constraints", GDC 2011).
typedef struct IsletJointSpring {
    bool enable;
    /// Hz, >= 0; 0 is no spring
    float hertz;
    /// >= 0; 1 is critical
    float damping_ratio;
    /// rad or m; not used by distance joints, whose target is their length
    float target;
} IsletJointSpring;

/// The springs of a weld or motor joint, and the linear one of a mouse joint. A weld swings at its frequency and decays by its damping ratio: up to 10 Hz at
/// 240 substeps a second, the frequency is right within 0.5 % and a ratio of up to 1 within 0.012. Stiffer springs are damped more: undamped ones as by a
/// ratio of 0.05 at 13 Hz, of 0.44 at 19 Hz. So are stiff springs of a body with many joints: with four joints, an undamped weld of 10 Hz decays as by 0.06.
/// The stiffness of the point is that of the mean over its directions. Motor and mouse joints are less stiff where their point gives way more easily. So the
/// point sets off straight to the target, from a corner as from the centre. They are damped more than asked, the more so the stiffer: at 240 substeps a
/// second, an undamped spring of 5 Hz decays as if its ratio were 0.13, one of 10 Hz as if it were 0.25, and 0.5 at 5 Hz comes out as 0.603.
typedef struct IsletJointSoftness {
    /// Hz, >= 0; of a mouse joint > 0. 0: rigid, or, of a motor joint, it drives the velocity.
    float linear_hertz;
    /// >= 0
    float linear_damping_ratio;
    /// Hz, >= 0; the same for the angle. Of a mouse joint 0.
    float angular_hertz;
    /// >= 0; of a mouse joint without effect
    float angular_damping_ratio;
} IsletJointSoftness;

/// Bounds of the joint's coordinate, rad or m: lower <= upper.
typedef struct IsletJointLimit {
    bool enable;
    float lower;
    float upper;
} IsletJointLimit;

/// Drives the coordinate's rate to `speed` with at most `max_force`.
typedef struct IsletJointMotor {
    bool enable;
    /// rad/s or m/s
    float speed;
    /// N m or N, >= 0
    float max_force;
} IsletJointMotor;

/// What all joints have. The bodies must be two different ones, one of them dynamic.
typedef struct IsletJointBase {
    IsletBodyId body_a;
    IsletBodyId body_b;
    IsletJointFrame frame_a;
    IsletJointFrame frame_b;
    /// true: the two bodies' shapes collide with each other
    bool collide_connected;
    /// N, >= 0. The joint breaks, at the end of the step, when its force exceeds this in a substep; 0: never.
    float break_force;
    /// N m, >= 0; as above
    float break_torque;
    uint64_t user_data;
} IsletJointBase;

/// A hinge.
typedef struct IsletRevoluteJointDef {
    uint32_t struct_size;  ///< sizeof(IsletRevoluteJointDef)
    uint32_t reserved;     ///< 0
    IsletJointBase base;
    IsletJointSpring spring;
    IsletJointLimit limit;
    IsletJointMotor motor;
    /// N m, >= 0: dry friction that resists turning
    float friction;
} IsletRevoluteJointDef;

/// A slider.
typedef struct IsletPrismaticJointDef {
    uint32_t struct_size;  ///< sizeof(IsletPrismaticJointDef)
    uint32_t reserved;     ///< 0
    IsletJointBase base;
    IsletJointSpring spring;
    IsletJointLimit limit;
    IsletJointMotor motor;
    /// N, >= 0: dry friction that resists sliding
    float friction;
} IsletPrismaticJointDef;

/// A rod. With a limit it is a rope (lower 0) or a telescope, and with a spring it is a spring. A motor drives its length.
typedef struct IsletDistanceJointDef {
    uint32_t struct_size;  ///< sizeof(IsletDistanceJointDef)
    uint32_t reserved;     ///< 0
    IsletJointBase base;
    /// m, >= 0.005: of the rod, or at which the spring rests
    float length;
    IsletJointSpring spring;
    /// m, lower >= 0
    IsletJointLimit limit;
    IsletJointMotor motor;
} IsletDistanceJointDef;

/// Holds two bodies together rigidly, or softly where a frequency is given.
typedef struct IsletWeldJointDef {
    uint32_t struct_size;  ///< sizeof(IsletWeldJointDef)
    uint32_t reserved;     ///< 0
    IsletJointBase base;
    /// Hz, >= 0; 0 is rigid
    float linear_hertz;
    /// >= 0; 1 is critical
    float linear_damping_ratio;
    /// Hz, >= 0; 0 is rigid
    float angular_hertz;
    /// >= 0; 1 is critical
    float angular_damping_ratio;
} IsletWeldJointDef;

/// A wheel (B) on a sprung strut along A's x axis.
typedef struct IsletWheelJointDef {
    uint32_t struct_size;  ///< sizeof(IsletWheelJointDef)
    uint32_t reserved;     ///< 0
    IsletJointBase base;
    /// of the strut; by default 4 Hz, damping ratio 0.7
    IsletJointSpring spring;
    /// of the strut
    IsletJointLimit limit;
    /// turns the wheel
    IsletJointMotor motor;
    /// N m, >= 0: resists the wheel's turning
    float friction;
} IsletWheelJointDef;

/// Drives B relative to A: to a velocity, or, where a frequency is given, to the pose in which frame B lies on frame A. With velocity 0 it is the friction of
/// a body sliding on A, seen from above.
typedef struct IsletMotorJointDef {
    uint32_t struct_size;  ///< sizeof(IsletMotorJointDef)
    uint32_t reserved;     ///< 0
    IsletJointBase base;
    /// m/s in frame A, of B's point relative to A's
    IsletVec2 linear_velocity;
    /// rad/s
    float angular_velocity;
    /// N, >= 0
    float max_force;
    /// N m, >= 0
    float max_torque;
    /// Hz, >= 0; 0 drives the velocity, more the position
    float linear_hertz;
    /// >= 0; 1 is critical
    float linear_damping_ratio;
    /// Hz, >= 0; as above, for the angle
    float angular_hertz;
    /// >= 0; 1 is critical
    float angular_damping_ratio;
} IsletMotorJointDef;

/// Pulls a point of `body` to the target, which you can move: the point that is at `target` when the joint is made.
typedef struct IsletMouseJointDef {
    uint32_t struct_size;  ///< sizeof(IsletMouseJointDef)
    uint32_t reserved;     ///< 0
    IsletBodyId body;
    /// m, world
    IsletVec2 target;
    /// Hz, > 0
    float hertz;
    /// >= 0; 1 is critical
    float damping_ratio;
    /// N, >= 0
    float max_force;
    uint64_t user_data;
} IsletMouseJointDef;

/// A rope from A's point over two fixed points to B's point: length A + ratio * length B stays constant.
typedef struct IsletPulleyJointDef {
    uint32_t struct_size;  ///< sizeof(IsletPulleyJointDef)
    uint32_t reserved;     ///< 0
    IsletJointBase base;
    /// m, world; must be at least 0.005 m from the bodies' points
    IsletVec2 ground_a;
    IsletVec2 ground_b;
    /// > 0, at most max_ratio
    float ratio;
} IsletPulleyJointDef;

/// Couples the coordinates of two revolute or prismatic joints: c1 + ratio * c2 stays constant. Two hinges whose bodies turn against each other have the
/// ratio radius 2 / radius 1; a prismatic and a revolute joint make a rack and pinion. The gear is destroyed with either joint.
typedef struct IsletGearJointDef {
    uint32_t struct_size;  ///< sizeof(IsletGearJointDef)
    uint32_t reserved;     ///< 0
    IsletJointId joint1;
    IsletJointId joint2;
    /// not 0, between -max_ratio and max_ratio
    float ratio;
    /// N m (N for a prismatic joint 1), >= 0; 0: never breaks
    float break_torque;
    uint64_t user_data;
} IsletGearJointDef;

/// Lets an angle turn one way only. Teeth stand at phase + i step; the angle cannot go back past the last tooth that it has passed.
typedef struct IsletJointRatchet {
    /// rad from tooth to tooth, 0.001 to 100; negative: it turns backward only; 0: no ratchet
    float step;
    /// rad, the angle of any tooth; -10 000 to 10 000
    float phase;
} IsletJointRatchet;

/// Controls the angle between two bodies. Their positions stay free; the points of the frames only say where the joint is drawn.
typedef struct IsletAngleJointDef {
    uint32_t struct_size;  ///< sizeof(IsletAngleJointDef)
    uint32_t reserved;     ///< 0
    IsletJointBase base;
    IsletJointSpring spring;
    IsletJointLimit limit;
    IsletJointMotor motor;
    /// N m, >= 0: dry friction that resists turning
    float friction;
    IsletJointRatchet ratchet;
} IsletAngleJointDef;

/// How far a joint has come apart.
typedef struct IsletJointError {
    /// m, >= 0; of a gear between prismatic joints too
    float linear;
    /// rad, >= 0
    float angular;
} IsletJointError;

/// A joint broke at the end of the last step and is gone.
typedef struct IsletJointBreakEvent {
    /// stale
    IsletJointId joint;
    IsletBodyId body_a;
    IsletBodyId body_b;
    /// N, on B, that it broke at
    IsletVec2 force;
    /// N m
    float torque;
    uint64_t user_data;
} IsletJointBreakEvent;

/// A field that breaks its rules.
typedef struct IsletFieldFault {
    /// not_finite, out_of_range, feature_cut, bad_capacity or bad_geometry; none if all fields keep their rules
    IsletError error;
    /// its name, after those of the structs that hold it: "limit.lower", "solver.substeps"; null if there is none
    const char* field;
} IsletFieldFault;

/// A convex shape of any type: the hull of 1 to 8 points, counter-clockwise, grown by `radius` (m, 0 to 1e7). count 0: no shape.
typedef struct IsletShapeProxy {
    IsletVec2 points[8];
    uint32_t count;
    float radius;
    /// Of two points: rays and casts meet the shape only from the right of points[0] -> points[1], as a ChainSegment.
    bool one_sided;
} IsletShapeProxy;

/// Where a moving point or shape first meets another.
typedef struct IsletCastHit {
    bool hit;
    /// of the translation, 0 to 1
    float fraction;
    /// m, on the surface that is met
    IsletVec2 point;
    /// unit, of the surface that is met, towards the moving point or shape
    IsletVec2 normal;
    /// m, 0; if they overlapped at the start, minus the depth
    float separation;
} IsletCastHit;

/// How two shapes stand to each other.
typedef struct IsletSeparation {
    /// m; for shapes that overlap, minus the length of the shortest way that parts them
    float distance;
    /// m, the closest points of the surfaces; of overlapping shapes the deepest
    IsletVec2 point_a;
    /// m
    IsletVec2 point_b;
    /// unit, from a to b. For coinciding points (0, -1), on a line across it.
    IsletVec2 normal;
} IsletSeparation;

/// Which shapes a query finds: those whose filter has a category in `mask` and a mask that contains `category`. The default finds all shapes but sensors and
/// shapes whose mask is 0. Shapes of disabled bodies are never found.
typedef struct IsletQueryFilter {
    uint32_t category;
    uint32_t mask;
    /// Find sensors too.
    bool sensors;
} IsletQueryFilter;

/// A shape that a ray or a cast meets, with the fields of CastHit. Null if there is none.
typedef struct IsletQueryHit {
    IsletShapeId shape;
    /// m, world
    IsletVec2 point;
    /// unit, world
    IsletVec2 normal;
    /// 0 to 1, of the translation
    float fraction;
    /// m, 0; for shapes that overlapped at the start, minus the depth
    float separation;
} IsletQueryHit;

/// The shape closest to a point. Null if there is none.
typedef struct IsletClosestHit {
    IsletShapeId shape;
    /// m, the shape's closest point; the given point if it is inside
    IsletVec2 point;
    /// unit, towards the given point; if that is inside, along the shortest way out
    IsletVec2 normal;
    /// m, 0 inside
    float distance;
} IsletClosestHit;

/// A surface near a shape: the plane that bounds it there.
typedef struct IsletSurface {
    IsletShapeId shape;
    /// m, the surface's closest point; of an overlapping shape the deepest
    IsletVec2 point;
    /// unit, towards the given shape; along the shortest way out of an overlap
    IsletVec2 normal;
    /// m; for shapes that overlap, minus the depth
    float separation;
} IsletSurface;

/// One column of the actions.
typedef struct IsletDrive {
    IsletDriveKind kind;
    IsletBodyId body;
    IsletJointId joint;
    /// Dimensionless factor of the action. Finite.
    float scale;
} IsletDrive;

/// One to two columns of the observations (SenseKind).
typedef struct IsletSense {
    IsletSenseKind kind;
    IsletBodyId body;
    IsletJointId joint;
    /// m, where a ray starts, in the body's frame
    IsletVec2 origin;
    /// m, from there to its end, in the body's frame
    IsletVec2 translation;
    /// what a ray can meet
    IsletQueryFilter filter;
} IsletSense;

/// A random change of one body, so that starts differ. Each number is half the width of a range around 0, >= 0.
typedef struct IsletVariation {
    IsletBodyId body;
    /// m
    IsletVec2 position;
    /// rad
    float angle;
    /// m/s
    IsletVec2 velocity;
    /// rad/s
    float angular_velocity;
} IsletVariation;

/// What read_format finds.
typedef struct IsletFormatInfo {
    uint32_t struct_size;  ///< sizeof(IsletFormatInfo)
    IsletFormatKind kind;
    /// of the bytes; 0 if unknown
    uint32_t format;
    /// the format of this kind that this version reads; 0 if unknown
    uint32_t readable;
    /// true: the snapshot at the start of a recording. The format of the recording is readable, that of the snapshot is not
    bool in_recording;
    /// written by a machine of the other byte order
    bool other_byte_order;
} IsletFormatInfo;

/// The entries of a row's Jacobian for one body. The body adds dot(linear, v) + angular w to the row's velocity. The row's x gives the body the impulse x
/// linear and the angular impulse x angular.
typedef struct IsletRowEnd {
    /// index into IslandProblem::bodies, or no_body
    uint32_t body;
    /// 1; m for a row in rad
    IsletVec2 linear;
    /// m; 1 for a row in rad
    float angular;
} IsletRowEnd;

/// One row. The rows of one contact or joint stand together.
typedef struct IsletIslandRow {
    IsletRowKind kind;
    /// of the contact (islet_world_contact_at) for normal, friction and rolling; else of the joint (islet_world_joint_at)
    uint32_t slot;
    /// point of the contact, 0 or 1; row of the joint, from 0
    uint32_t index;
    /// 1 to 4; no two ends have the same body of the island
    uint32_t end_count;
    IsletRowEnd ends[4];
    /// m/s or rad/s: the part of w that does not come from the island's bodies, including the motion of kinematic ends
    float bias;
    /// 1/kg or 1/(kg m^2); 0: rigid
    float softness;
} IsletIslandRow;

/// One body.
typedef struct IsletIslandBody {
    IsletBodyId id;
    /// 1/kg, > 0
    float inv_mass;
    /// 1/(kg m^2), as in the solver, which lessens it for bodies pulled so hard that they would swing within a substep
    float inv_inertia;
    /// m/s, of the centre of mass: after gravity, forces and damping over h, before any impulse
    IsletVec2 v_free;
    /// rad/s; of a link of a joint tree, scaled with the inertia
    float w_free;
} IsletIslandBody;

/// Returns whether a surface stands in the mover's way. It need not handle one-way shapes (IsletShapeDef.one_way), because the mover does that itself. It may
/// read and query the world, but not change it (in_step).
typedef bool (*IsletMoverFilter)(const IsletSurface* surface, void* context);

/// The properties of a mover.
typedef struct IsletMoverDef {
    uint32_t struct_size;  ///< sizeof(IsletMoverDef)
    uint32_t reserved;     ///< 0
    /// Relative to the position: by default, that is between the feet of a mover 1.8 m tall.
    IsletCapsule capsule;
    /// Unit; points away from the ground.
    IsletVec2 up;
    /// Share of the world's gravity that acts on it in the air.
    float gravity_scale;
    /// rad, 0 to 1.5. Steeper ground cannot be walked up or stood on.
    float max_slope;
    /// m, >= 0. It climbs edges up to this height above the feet, if there is room above them.
    float step_height;
    /// m, >= 0. On a walk, the feet keep to ground that falls away by no more than this in a step.
    float snap_distance;
    /// m/s^2, >= 0. How fast it reaches its walking speed, and stops.
    float ground_acceleration;
    /// m/s^2, >= 0. The same sideways in the air.
    float air_acceleration;
    /// kg, >= 0. Decides its weight on dynamic bodies, which stay awake under it, and how much of its speed it gives them.
    float mass;
    /// N, >= 0. The largest force with which it pushes dynamic bodies out of its way.
    float max_push_force;
    IsletQueryFilter filter;
    /// Called for each surface that the filter finds; null: all stand in the way.
    IsletMoverFilter collides;
    void* context;
} IsletMoverDef;

/// The state of a mover.
typedef struct IsletMoverState {
    /// m, world
    IsletVec2 position;
    /// m/s; while it stands, relative to the ground
    IsletVec2 velocity;
    /// The body it stands on; null in the air.
    IsletBodyId ground;
    /// unit
    IsletVec2 ground_normal;
    /// m, in the ground body's frame: the point that the ground carries along
    IsletVec2 ground_point;
    /// 1: the surfaces around it left no room in the last step, or it is still leaving one that overlaps it
    uint32_t squeezed;
} IsletMoverState;

/// What a mover should do in a step.
typedef struct IsletMoverInput {
    uint32_t struct_size;  ///< sizeof(IsletMoverInput)
    /// m/s, along the ground, in the air sideways; to the right if `up` points up
    float walk;
    /// m/s, >= 0. If above 0, a mover that stands on ground leaves it with this speed upwards.
    float jump;
} IsletMoverInput;

/// What a recording says about itself.
typedef struct IsletRecordingInfo {
    uint32_t struct_size;  ///< sizeof(IsletRecordingInfo)
    uint32_t reserved;     ///< 0
    /// of the recorded world, as the recording claims; a forged recording may claim any capacity
    IsletCapacity* capacity;
    /// what a world needs for a replay with the same results: the capacity claimed, but no more than the recording's snapshots and calls could fill. (That is
    /// at most one shape for each byte of the recording, and the square of the shapes in contacts.)
    IsletCapacity* needed;
    /// of the whole recording
    uint64_t bytes;
    /// whether each step has a hash of each awake body
    bool bodies;
} IsletRecordingInfo;

typedef struct IsletReplayResult {
    uint32_t struct_size;  ///< sizeof(IsletReplayResult)
    uint32_t reserved;     ///< 0
    IsletReplayEnd end;
    /// refused: an error of read_recording or islet_world_load, or corrupt_recording
    IsletError error;
    /// steps replayed, including the one that differs
    uint64_t steps;
    /// differs: after that step
    uint64_t recorded_hash;
    /// differs: after that step
    uint64_t hash;
    /// differs: the first body, by slot, that came out differently, if the recording has hashes of bodies; null if so far only a contact or a joint differs
    IsletBodyId body;
} IsletReplayResult;

/// What an image says about itself.
typedef struct IsletSnapshotInfo {
    uint32_t struct_size;  ///< sizeof(IsletSnapshotInfo)
    uint32_t reserved;     ///< 0
    /// of the whole image
    uint64_t bytes;
    /// of the saved world, as the image claims; a forged image may claim any that holds its records
    IsletCapacity* capacity;
    /// the least capacity that can hold the image: as many records as it has
    IsletCapacity* used;
} IsletSnapshotInfo;

/// Called for each hit, from the first on the way to the last; hits of equal fractions come in the order of their slots. The result decides how the cast goes
/// on. 0 stops it. A fraction above 0 ends the way there: only hits up to that fraction follow (1 ends nothing; hit.fraction leaves only hits as near as this
/// one). A negative number ignores the hit. A visitor may call any function of the world. It may change the world, too, if no other thread uses the world
/// meanwhile. Up to seven hits after a change may have been found before it: their ids may be stale (islet_body_is_valid) and their places old. The hits
/// after them are of the changed world.
typedef float (*IsletCastVisitor)(const IsletQueryHit* hit, void* context);

/// Called for each shape found, in the order of their slots; false stops the query. It may change the world as a CastVisitor may.
typedef bool (*IsletOverlapVisitor)(IsletShapeId shape, void* context);

typedef struct IsletTouchEventSpan {
    const IsletTouchEvent* data;
    size_t count;
} IsletTouchEventSpan;

typedef struct IsletSensorEventSpan {
    const IsletSensorEvent* data;
    size_t count;
} IsletSensorEventSpan;

typedef struct IsletHitEventSpan {
    const IsletHitEvent* data;
    size_t count;
} IsletHitEventSpan;

typedef struct IsletBodyIdSpan {
    const IsletBodyId* data;
    size_t count;
} IsletBodyIdSpan;

typedef struct IsletJointBreakEventSpan {
    const IsletJointBreakEvent* data;
    size_t count;
} IsletJointBreakEventSpan;


// -- defaults --------------------------------------------------------------------------------------------------------------------------

#ifndef __cplusplus  // GCC makes a value without a name in its place, but copies a variable

static inline IsletRot islet_default_rot(void) {
    return (IsletRot){.c = 1.0f};
}

static inline IsletTransform islet_default_transform(void) {
    return (IsletTransform){.q.c = 1.0f};
}

static inline IsletCircle islet_default_circle(void) {
    return (IsletCircle){.radius = 0.5f};
}

static inline IsletCapsule islet_default_capsule(void) {
    return (IsletCapsule){.radius = 0.5f};
}

static inline IsletHalfSpace islet_default_half_space(void) {
    return (IsletHalfSpace){.normal.y = 1.0f};
}

static inline IsletDrawStyle islet_default_draw_style(void) {
    return (IsletDrawStyle){.solid = true};
}

static inline IsletDebugDraw islet_default_debug_draw(void) {
    return (IsletDebugDraw){.struct_size = sizeof(IsletDebugDraw), .view.lower.x = -1.0e30f, .view.lower.y = -1.0e30f, .view.upper.x = 1.0e30f,
        .view.upper.y = 1.0e30f, .size = 0.25f, .impulse_scale = 1.0f, .shapes = true, .joints = true};
}

static inline IsletTaskSystem islet_default_task_system(void) {
    return (IsletTaskSystem){.struct_size = sizeof(IsletTaskSystem), .workers = 1u};
}

static inline IsletCapacity islet_default_capacity(void) {
    return (IsletCapacity){.struct_size = sizeof(IsletCapacity)};
}

static inline IsletHooks islet_default_hooks(void) {
    return (IsletHooks){.struct_size = sizeof(IsletHooks)};
}

static inline IsletSolverDef islet_default_solver_def(void) {
    return (IsletSolverDef){.struct_size = sizeof(IsletSolverDef), .substeps = 4u, .iterations = 1u, .relax_iterations = 1u, .contact_hertz = 30.0f,
        .contact_damping_ratio = 10.0f, .contact_push_speed = 3.0f, .joint_hertz = 60.0f, .joint_damping_ratio = 2.0f, .baumgarte = 0.2f, .omega = 1.0f,
        .warm_start = true, .joint_trees = ISLET_JOINT_TREES_AUTOMATIC, .joint_tree_load = 1.0f};
}

static inline IsletWorldDef islet_default_world_def(void) {
    return (IsletWorldDef){.struct_size = sizeof(IsletWorldDef), .gravity.y = -10.0f, .enable_sleep = true, .restitution_threshold = 1.0f,
        .max_speed = 400.0f, .hit_threshold = 1.0f, .continuous = true, .seamless_floors = true};
}

static inline IsletBodyDef islet_default_body_def(void) {
    return (IsletBodyDef){.struct_size = sizeof(IsletBodyDef), .gravity_scale = 1.0f, .sleep_threshold = 0.05f, .enable_sleep = true, .awake = true,
        .enabled = true};
}

static inline IsletFilter islet_default_filter(void) {
    return (IsletFilter){.category = 1u, .mask = 4294967295u};
}

static inline IsletSurfaceMaterial islet_default_surface_material(void) {
    return (IsletSurfaceMaterial){.friction = 0.6f};
}

static inline IsletShapeDef islet_default_shape_def(void) {
    return (IsletShapeDef){.struct_size = sizeof(IsletShapeDef), .friction = 0.6f, .density = 1.0f, .filter.category = 1u, .filter.mask = 4294967295u,
        .sensor_events = true};
}

static inline IsletExplosionDef islet_default_explosion_def(void) {
    return (IsletExplosionDef){.struct_size = sizeof(IsletExplosionDef), .mask = 4294967295u};
}

static inline IsletWindDef islet_default_wind_def(void) {
    return (IsletWindDef){.struct_size = sizeof(IsletWindDef), .drag = 1.0f, .density = 1.225f, .wake = true};
}

static inline IsletStepReport islet_default_step_report(void) {
    return (IsletStepReport){.struct_size = sizeof(IsletStepReport)};
}

static inline IsletStepProfile islet_default_step_profile(void) {
    return (IsletStepProfile){.struct_size = sizeof(IsletStepProfile)};
}

static inline IsletWorldCounters islet_default_world_counters(void) {
    return (IsletWorldCounters){.struct_size = sizeof(IsletWorldCounters)};
}

static inline IsletPreSolve islet_default_pre_solve(void) {
    return (IsletPreSolve){.enabled = true};
}

static inline IsletJointSoftness islet_default_joint_softness(void) {
    return (IsletJointSoftness){.linear_damping_ratio = 1.0f, .angular_damping_ratio = 1.0f};
}

static inline IsletRevoluteJointDef islet_default_revolute_joint_def(void) {
    return (IsletRevoluteJointDef){.struct_size = sizeof(IsletRevoluteJointDef)};
}

static inline IsletPrismaticJointDef islet_default_prismatic_joint_def(void) {
    return (IsletPrismaticJointDef){.struct_size = sizeof(IsletPrismaticJointDef)};
}

static inline IsletDistanceJointDef islet_default_distance_joint_def(void) {
    return (IsletDistanceJointDef){.struct_size = sizeof(IsletDistanceJointDef), .length = 1.0f};
}

static inline IsletWeldJointDef islet_default_weld_joint_def(void) {
    return (IsletWeldJointDef){.struct_size = sizeof(IsletWeldJointDef), .linear_damping_ratio = 1.0f, .angular_damping_ratio = 1.0f};
}

static inline IsletWheelJointDef islet_default_wheel_joint_def(void) {
    return (IsletWheelJointDef){.struct_size = sizeof(IsletWheelJointDef), .spring.enable = true, .spring.hertz = 4.0f, .spring.damping_ratio = 0.7f};
}

static inline IsletMotorJointDef islet_default_motor_joint_def(void) {
    return (IsletMotorJointDef){.struct_size = sizeof(IsletMotorJointDef), .linear_damping_ratio = 1.0f, .angular_damping_ratio = 1.0f};
}

static inline IsletMouseJointDef islet_default_mouse_joint_def(void) {
    return (IsletMouseJointDef){.struct_size = sizeof(IsletMouseJointDef), .hertz = 5.0f, .damping_ratio = 0.7f};
}

static inline IsletPulleyJointDef islet_default_pulley_joint_def(void) {
    return (IsletPulleyJointDef){.struct_size = sizeof(IsletPulleyJointDef), .ratio = 1.0f};
}

static inline IsletGearJointDef islet_default_gear_joint_def(void) {
    return (IsletGearJointDef){.struct_size = sizeof(IsletGearJointDef), .ratio = 1.0f};
}

static inline IsletAngleJointDef islet_default_angle_joint_def(void) {
    return (IsletAngleJointDef){.struct_size = sizeof(IsletAngleJointDef)};
}

static inline IsletQueryFilter islet_default_query_filter(void) {
    return (IsletQueryFilter){.category = 4294967295u, .mask = 4294967295u};
}

static inline IsletDrive islet_default_drive(void) {
    return (IsletDrive){.scale = 1.0f};
}

static inline IsletSense islet_default_sense(void) {
    return (IsletSense){.filter.category = 4294967295u, .filter.mask = 4294967295u};
}

static inline IsletFormatInfo islet_default_format_info(void) {
    return (IsletFormatInfo){.struct_size = sizeof(IsletFormatInfo)};
}

static inline IsletRowEnd islet_default_row_end(void) {
    return (IsletRowEnd){.body = ISLET_NO_BODY};
}

static inline IsletMoverDef islet_default_mover_def(void) {
    return (IsletMoverDef){.struct_size = sizeof(IsletMoverDef), .capsule.point1.y = 0.3f, .capsule.point2.y = 1.5f, .capsule.radius = 0.3f, .up.y = 1.0f,
        .gravity_scale = 1.0f, .max_slope = 0.9f, .step_height = 0.35f, .snap_distance = 0.35f, .ground_acceleration = 60.0f, .air_acceleration = 20.0f,
        .mass = 70.0f, .max_push_force = 400.0f, .filter.category = 4294967295u, .filter.mask = 4294967295u};
}

static inline IsletMoverInput islet_default_mover_input(void) {
    return (IsletMoverInput){.struct_size = sizeof(IsletMoverInput)};
}

static inline IsletRecordingInfo islet_default_recording_info(void) {
    return (IsletRecordingInfo){.struct_size = sizeof(IsletRecordingInfo)};
}

static inline IsletReplayResult islet_default_replay_result(void) {
    return (IsletReplayResult){.struct_size = sizeof(IsletReplayResult)};
}

static inline IsletSnapshotInfo islet_default_snapshot_info(void) {
    return (IsletSnapshotInfo){.struct_size = sizeof(IsletSnapshotInfo)};
}

#else

static inline IsletRot islet_default_rot(void) {
    IsletRot def = ISLET_ZERO;
    def.c = 1.0f;
    return def;
}

static inline IsletTransform islet_default_transform(void) {
    IsletTransform def = ISLET_ZERO;
    def.q.c = 1.0f;
    return def;
}

static inline IsletCircle islet_default_circle(void) {
    IsletCircle def = ISLET_ZERO;
    def.radius = 0.5f;
    return def;
}

static inline IsletCapsule islet_default_capsule(void) {
    IsletCapsule def = ISLET_ZERO;
    def.radius = 0.5f;
    return def;
}

static inline IsletHalfSpace islet_default_half_space(void) {
    IsletHalfSpace def = ISLET_ZERO;
    def.normal.y = 1.0f;
    return def;
}

static inline IsletDrawStyle islet_default_draw_style(void) {
    IsletDrawStyle def = ISLET_ZERO;
    def.solid = true;
    return def;
}

static inline IsletDebugDraw islet_default_debug_draw(void) {
    IsletDebugDraw def = ISLET_ZERO;
    def.struct_size = sizeof def;
    def.view.lower.x = -1.0e30f;
    def.view.lower.y = -1.0e30f;
    def.view.upper.x = 1.0e30f;
    def.view.upper.y = 1.0e30f;
    def.size = 0.25f;
    def.impulse_scale = 1.0f;
    def.shapes = true;
    def.joints = true;
    return def;
}

static inline IsletTaskSystem islet_default_task_system(void) {
    IsletTaskSystem def = ISLET_ZERO;
    def.struct_size = sizeof def;
    def.workers = 1u;
    return def;
}

static inline IsletCapacity islet_default_capacity(void) {
    IsletCapacity def = ISLET_ZERO;
    def.struct_size = sizeof def;
    return def;
}

static inline IsletHooks islet_default_hooks(void) {
    IsletHooks def = ISLET_ZERO;
    def.struct_size = sizeof def;
    return def;
}

static inline IsletSolverDef islet_default_solver_def(void) {
    IsletSolverDef def = ISLET_ZERO;
    def.struct_size = sizeof def;
    def.substeps = 4u;
    def.iterations = 1u;
    def.relax_iterations = 1u;
    def.contact_hertz = 30.0f;
    def.contact_damping_ratio = 10.0f;
    def.contact_push_speed = 3.0f;
    def.joint_hertz = 60.0f;
    def.joint_damping_ratio = 2.0f;
    def.baumgarte = 0.2f;
    def.omega = 1.0f;
    def.warm_start = true;
    def.joint_trees = ISLET_JOINT_TREES_AUTOMATIC;
    def.joint_tree_load = 1.0f;
    return def;
}

static inline IsletWorldDef islet_default_world_def(void) {
    IsletWorldDef def = ISLET_ZERO;
    def.struct_size = sizeof def;
    def.gravity.y = -10.0f;
    def.enable_sleep = true;
    def.restitution_threshold = 1.0f;
    def.max_speed = 400.0f;
    def.hit_threshold = 1.0f;
    def.continuous = true;
    def.seamless_floors = true;
    return def;
}

static inline IsletBodyDef islet_default_body_def(void) {
    IsletBodyDef def = ISLET_ZERO;
    def.struct_size = sizeof def;
    def.gravity_scale = 1.0f;
    def.sleep_threshold = 0.05f;
    def.enable_sleep = true;
    def.awake = true;
    def.enabled = true;
    return def;
}

static inline IsletFilter islet_default_filter(void) {
    IsletFilter def = ISLET_ZERO;
    def.category = 1u;
    def.mask = 4294967295u;
    return def;
}

static inline IsletSurfaceMaterial islet_default_surface_material(void) {
    IsletSurfaceMaterial def = ISLET_ZERO;
    def.friction = 0.6f;
    return def;
}

static inline IsletShapeDef islet_default_shape_def(void) {
    IsletShapeDef def = ISLET_ZERO;
    def.struct_size = sizeof def;
    def.friction = 0.6f;
    def.density = 1.0f;
    def.filter.category = 1u;
    def.filter.mask = 4294967295u;
    def.sensor_events = true;
    return def;
}

static inline IsletExplosionDef islet_default_explosion_def(void) {
    IsletExplosionDef def = ISLET_ZERO;
    def.struct_size = sizeof def;
    def.mask = 4294967295u;
    return def;
}

static inline IsletWindDef islet_default_wind_def(void) {
    IsletWindDef def = ISLET_ZERO;
    def.struct_size = sizeof def;
    def.drag = 1.0f;
    def.density = 1.225f;
    def.wake = true;
    return def;
}

static inline IsletStepReport islet_default_step_report(void) {
    IsletStepReport def = ISLET_ZERO;
    def.struct_size = sizeof def;
    return def;
}

static inline IsletStepProfile islet_default_step_profile(void) {
    IsletStepProfile def = ISLET_ZERO;
    def.struct_size = sizeof def;
    return def;
}

static inline IsletWorldCounters islet_default_world_counters(void) {
    IsletWorldCounters def = ISLET_ZERO;
    def.struct_size = sizeof def;
    return def;
}

static inline IsletPreSolve islet_default_pre_solve(void) {
    IsletPreSolve def = ISLET_ZERO;
    def.enabled = true;
    return def;
}

static inline IsletJointSoftness islet_default_joint_softness(void) {
    IsletJointSoftness def = ISLET_ZERO;
    def.linear_damping_ratio = 1.0f;
    def.angular_damping_ratio = 1.0f;
    return def;
}

static inline IsletRevoluteJointDef islet_default_revolute_joint_def(void) {
    IsletRevoluteJointDef def = ISLET_ZERO;
    def.struct_size = sizeof def;
    return def;
}

static inline IsletPrismaticJointDef islet_default_prismatic_joint_def(void) {
    IsletPrismaticJointDef def = ISLET_ZERO;
    def.struct_size = sizeof def;
    return def;
}

static inline IsletDistanceJointDef islet_default_distance_joint_def(void) {
    IsletDistanceJointDef def = ISLET_ZERO;
    def.struct_size = sizeof def;
    def.length = 1.0f;
    return def;
}

static inline IsletWeldJointDef islet_default_weld_joint_def(void) {
    IsletWeldJointDef def = ISLET_ZERO;
    def.struct_size = sizeof def;
    def.linear_damping_ratio = 1.0f;
    def.angular_damping_ratio = 1.0f;
    return def;
}

static inline IsletWheelJointDef islet_default_wheel_joint_def(void) {
    IsletWheelJointDef def = ISLET_ZERO;
    def.struct_size = sizeof def;
    def.spring.enable = true;
    def.spring.hertz = 4.0f;
    def.spring.damping_ratio = 0.7f;
    return def;
}

static inline IsletMotorJointDef islet_default_motor_joint_def(void) {
    IsletMotorJointDef def = ISLET_ZERO;
    def.struct_size = sizeof def;
    def.linear_damping_ratio = 1.0f;
    def.angular_damping_ratio = 1.0f;
    return def;
}

static inline IsletMouseJointDef islet_default_mouse_joint_def(void) {
    IsletMouseJointDef def = ISLET_ZERO;
    def.struct_size = sizeof def;
    def.hertz = 5.0f;
    def.damping_ratio = 0.7f;
    return def;
}

static inline IsletPulleyJointDef islet_default_pulley_joint_def(void) {
    IsletPulleyJointDef def = ISLET_ZERO;
    def.struct_size = sizeof def;
    def.ratio = 1.0f;
    return def;
}

static inline IsletGearJointDef islet_default_gear_joint_def(void) {
    IsletGearJointDef def = ISLET_ZERO;
    def.struct_size = sizeof def;
    def.ratio = 1.0f;
    return def;
}

static inline IsletAngleJointDef islet_default_angle_joint_def(void) {
    IsletAngleJointDef def = ISLET_ZERO;
    def.struct_size = sizeof def;
    return def;
}

static inline IsletQueryFilter islet_default_query_filter(void) {
    IsletQueryFilter def = ISLET_ZERO;
    def.category = 4294967295u;
    def.mask = 4294967295u;
    return def;
}

static inline IsletDrive islet_default_drive(void) {
    IsletDrive def = ISLET_ZERO;
    def.scale = 1.0f;
    return def;
}

static inline IsletSense islet_default_sense(void) {
    IsletSense def = ISLET_ZERO;
    def.filter.category = 4294967295u;
    def.filter.mask = 4294967295u;
    return def;
}

static inline IsletFormatInfo islet_default_format_info(void) {
    IsletFormatInfo def = ISLET_ZERO;
    def.struct_size = sizeof def;
    return def;
}

static inline IsletRowEnd islet_default_row_end(void) {
    IsletRowEnd def = ISLET_ZERO;
    def.body = ISLET_NO_BODY;
    return def;
}

static inline IsletMoverDef islet_default_mover_def(void) {
    IsletMoverDef def = ISLET_ZERO;
    def.struct_size = sizeof def;
    def.capsule.point1.y = 0.3f;
    def.capsule.point2.y = 1.5f;
    def.capsule.radius = 0.3f;
    def.up.y = 1.0f;
    def.gravity_scale = 1.0f;
    def.max_slope = 0.9f;
    def.step_height = 0.35f;
    def.snap_distance = 0.35f;
    def.ground_acceleration = 60.0f;
    def.air_acceleration = 20.0f;
    def.mass = 70.0f;
    def.max_push_force = 400.0f;
    def.filter.category = 4294967295u;
    def.filter.mask = 4294967295u;
    return def;
}

static inline IsletMoverInput islet_default_mover_input(void) {
    IsletMoverInput def = ISLET_ZERO;
    def.struct_size = sizeof def;
    return def;
}

static inline IsletRecordingInfo islet_default_recording_info(void) {
    IsletRecordingInfo def = ISLET_ZERO;
    def.struct_size = sizeof def;
    return def;
}

static inline IsletReplayResult islet_default_replay_result(void) {
    IsletReplayResult def = ISLET_ZERO;
    def.struct_size = sizeof def;
    return def;
}

static inline IsletSnapshotInfo islet_default_snapshot_info(void) {
    IsletSnapshotInfo def = ISLET_ZERO;
    def.struct_size = sizeof def;
    return def;
}

#endif


// -- functions -------------------------------------------------------------------------------------------------------------------------

/// Makes a world in `block`, which must be aligned to ISLET_WORLD_ALIGNMENT and hold at least islet_world_bytes(capacity) bytes. The world then owns all of it.
/// Returns null, and sets *error if given, if the block, the capacity or the definition breaks a rule, or if the engine was compiled in a way that changes the
/// bits (inexact_build). def may be null. There is nothing to destroy: the block is yours again when you no longer use the world.
ISLET_C_API IsletWorld* islet_create_world(void* block, size_t block_bytes, const IsletCapacity* capacity, const IsletWorldDef* def, IsletError* error);

/// The error of the last call that failed, since creation or islet_world_clear_error; null_pointer if `world` is null.
ISLET_C_API IsletError islet_world_last_error(const IsletWorld* world);
ISLET_C_API IsletError islet_world_clear_error(IsletWorld* world);
/// A sentence: what was wrong and how to mend it. Never null.
ISLET_C_API const char* islet_describe(IsletError error);

/// The first field for whose sake islet_create_world refuses the definition, as the functions for other definitions do. If def is null, null_pointer; if a struct
/// has a wrong size, struct_size.
ISLET_C_API IsletFieldFault islet_find_world_def_fault(const IsletWorldDef* def);

/// Distance and closest points of two shapes in one frame. Of shapes that are not valid, or null: distance 3.4e38, no normal.
ISLET_C_API IsletSeparation islet_separation(const IsletShapeProxy* a, const IsletShapeProxy* b);

/// Reads the header of an image, and nothing else. Errors: not_an_image; other_byte_order; other_version; truncated_image; corrupt_image if the header
/// contradicts itself. Then `out` stays as it was.
ISLET_C_API IsletError islet_read_snapshot(const void* image, size_t image_bytes, IsletSnapshotInfo* out);
/// Copies a world into another block, for example into a larger one when it has grown full. The new world has the same state, ids, settings, hooks, tasks and
/// clock, but no recording; the old one stays as it is. `image` is memory that is used during the call only, at least islet_world_snapshot_bytes(from) bytes.
/// Returns null with *error set, if given: the errors of islet_create_world for the block and the capacity; image_too_small; image_too_large if the capacity
/// cannot hold what the world holds; in_step.
ISLET_C_API IsletWorld* islet_copy_world(const IsletWorld* from, void* block, size_t block_bytes, const IsletCapacity* capacity, void* image, size_t image_bytes,
                                         IsletError* error);
/// Reads the header of a recording, and goes through its calls without making them. On an error `out` stays as it was: image_misaligned; not_a_recording;
/// other_version; truncated_image; corrupt_recording if the header contradicts itself; and the errors of islet_read_snapshot for the recording's first snapshot.
ISLET_C_API IsletError islet_read_recording(const void* recording, size_t recording_bytes, IsletRecordingInfo* out);
/// Whether this version reads bytes of this format. They may be damaged nevertheless.
ISLET_C_API bool islet_format_is_readable(const IsletFormatInfo* info);

/// An island as a complementarity problem: x >= lo, x <= hi and w = M x + q, where w >= 0 if x = lo, w <= 0 if x = hi, and w = 0 between. The pointers are into
/// the memory given to islet_body_export_island. engine/include/islet/island.hpp says what the numbers mean.
typedef struct IsletIslandProblem {
    uint32_t struct_size;  ///< sizeof(IsletIslandProblem)
    uint32_t row_count;
    uint32_t body_count;
    uint32_t entry_count;        ///< of M
    const uint32_t* row_starts;  ///< row_count + 1 of them: row i of M has the entries row_starts[i] <= k < row_starts[i + 1]
    const uint32_t* columns;     ///< of each entry
    const float* values;         ///< of each entry
    const float* q;              ///< row_count of them, as of all that follow but bodies
    const float* lo;
    const float* hi;            ///< for a row with friction: its coefficient
    const uint32_t* friction;   ///< the row of whose x the bounds are multiples, or 0xffffffff
    float* impulses;            ///< x of the last step, scaled to a substep of length h: the warm start. You may write to it.
    const IsletIslandRow* rows;
    const IsletIslandBody* bodies;  ///< body_count of them
} IsletIslandProblem;

static inline IsletIslandProblem islet_default_island_problem(void) {
    IsletIslandProblem def = ISLET_ZERO;
    def.struct_size = sizeof def;
    return def;
}

/// Writes to `memory` the complementarity problem of a dynamic body's island as it stands now, for a substep of h seconds, and points `out` to it. Returns the
/// bytes needed; if `memory` has fewer, writes neither to it nor to `out`. `memory` needs no alignment, and may be null if memory_bytes is 0. Returns 0 on an
/// error: null_id; stale_id; no_dynamic_body; bad_time_step of h; in_step; out_of_range if the problem is too large.
ISLET_C_API size_t islet_body_export_island(const IsletWorld* world, IsletBodyId body, float h, void* memory, size_t memory_bytes, IsletIslandProblem* out);

/// A fleet: many worlds of one capacity, which start as copies of one world and step together. It lives in memory of yours (islet_create_fleet). Errors of a
/// fleet are returned, and no hook is told of them. not_a_fleet: the pointer points to something else, or the fleet was moved.
typedef struct IsletFleet IsletFleet;

/// What islet_fleet_step does. A count of 0 stands for nothing to do; all arrays are read and written during the call only.
typedef struct IsletFleetStep {
    uint32_t struct_size;  ///< sizeof(IsletFleetStep)
    float dt;              ///< s, ISLET_MIN_TIME_STEP to 1
    uint32_t repeat;       ///< Steps of each world, 1 to 1000; each repeats the actions.
    uint32_t reserved;     ///< 0
    const uint8_t* mask;   ///< islet_fleet_size() numbers: where one is 0, that world stays as it is. None: all step.
    size_t mask_count;
    const IsletDrive* drives;
    size_t drives_count;
    const float* actions;  ///< islet_fleet_size() rows of drives_count numbers. Finite.
    size_t actions_count;
    const IsletSense* senses;
    size_t senses_count;
    float* observations;  ///< islet_fleet_size() rows of islet_sense_columns() numbers. Rows of worlds that did not step stay as they are.
    size_t observations_count;
} IsletFleetStep;

static inline IsletFleetStep islet_default_fleet_step(void) {
    IsletFleetStep what = ISLET_ZERO;
    what.struct_size = sizeof what;
    what.dt = 1.0f / 60;
    what.repeat = 1;
    return what;
}

/// Bytes of memory that a fleet needs; 0 if the capacity is not valid or null, or there is no world or no worker, or more than 2^20 worlds or
/// ISLET_MAX_WORKERS.
ISLET_C_API size_t islet_fleet_bytes(uint32_t worlds, const IsletCapacity* capacity, uint32_t workers);
/// Makes a fleet of `worlds` copies of `prototype` in `block`, which must be aligned to ISLET_WORLD_ALIGNMENT and hold at least
/// islet_fleet_bytes(worlds, the prototype's capacity, tasks->workers) bytes. The worlds have the prototype's state, settings and hooks, but no recording and
/// no clock; each steps on one thread, and `tasks` steps many at a time. Hooks are then called on several threads at once. tasks may be null: one thread.
/// There is nothing to destroy. Returns null with *error set, if given: block_too_small; block_misaligned; out_of_range (of worlds or workers); in_step (of the
/// prototype); null_pointer; struct_size.
ISLET_C_API IsletFleet* islet_create_fleet(void* block, size_t block_bytes, const IsletWorld* prototype, uint32_t worlds, const IsletTaskSystem* tasks,
                                           IsletError* error);
/// How many worlds there are.
ISLET_C_API uint32_t islet_fleet_size(const IsletFleet* fleet);
/// World k, 0 <= k < islet_fleet_size(). It can be read and changed like any other. Null if there is none.
ISLET_C_API IsletWorld* islet_fleet_world(IsletFleet* fleet, uint32_t k);
/// In each world that the mask names: applies the actions and steps, `repeat` times, then observes. An action or a sense whose body or joint is gone from a
/// world, or is of the wrong type, does nothing there, or reads 0. Errors: bad_time_step; out_of_range (repeat, an unknown kind, arrays of other sizes);
/// not_finite (an action, a scale or a ray).
ISLET_C_API IsletError islet_fleet_step(IsletFleet* fleet, const IsletFleetStep* what);
/// Observes without a step. Errors as in islet_fleet_step.
ISLET_C_API IsletError islet_fleet_observe(IsletFleet* fleet, const IsletSense* senses, size_t senses_count, float* observations, size_t observations_count,
                                           const uint8_t* mask, size_t mask_count);
/// Takes world k back to an image made by this program (islet_world_save of a world of no greater capacity), and changes bodies at random: the same seed gives
/// the same changes. Errors: out_of_range (k, or a negative width); not_finite; those of islet_world_restore. A body that the image does not hold is left out.
ISLET_C_API IsletError islet_fleet_reset(IsletFleet* fleet, uint32_t k, const void* image, size_t image_bytes, uint64_t seed,
                                         const IsletVariation* variations, size_t variations_count);
/// Makes world `to` a copy of world `from`; a recording of `to` ends. Errors: out_of_range.
ISLET_C_API IsletError islet_fleet_copy(IsletFleet* fleet, uint32_t from, uint32_t to);
/// Makes each world k a copy of world parents[k], at once, to go on with the best futures of a search. A parent stays as it is: parents[parents[k]] is
/// parents[k], and so does a recording of it. Errors: out_of_range (a parent that is not so, or not islet_fleet_size() of them).
ISLET_C_API IsletError islet_fleet_fork(IsletFleet* fleet, const uint32_t* parents, size_t parents_count);
ISLET_C_API IsletVec2 islet_vec2_add(IsletVec2 a, IsletVec2 b);
ISLET_C_API IsletVec2 islet_vec2_subtract(IsletVec2 a, IsletVec2 b);
ISLET_C_API IsletVec2 islet_vec2_negate(IsletVec2 a);
ISLET_C_API IsletVec2 islet_vec2_scale(float s, IsletVec2 a);

/// The scalar product, |a| |b| times the cosine of the angle between them, in the product of their units.
ISLET_C_API float islet_vec2_dot(IsletVec2 a, IsletVec2 b);

/// z of the three-dimensional cross product a x b, in the product of their units.
ISLET_C_API float islet_vec2_cross(IsletVec2 a, IsletVec2 b);

/// w (rad/s, about z) crossed with r: the velocity of a point at r on a body turning at w.
ISLET_C_API IsletVec2 islet_vec2_cross_rate(float w, IsletVec2 r);

/// a turned by +90 degrees.
ISLET_C_API IsletVec2 islet_vec2_left_perp(IsletVec2 a);

/// a turned by -90 degrees.
ISLET_C_API IsletVec2 islet_vec2_right_perp(IsletVec2 a);

/// |a|^2, in the square of its unit.
ISLET_C_API float islet_vec2_length_squared(IsletVec2 a);

/// |b - a|^2, m^2.
ISLET_C_API float islet_vec2_distance_squared(IsletVec2 a, IsletVec2 b);

/// The point at the fraction t of the way from a to b; t may be outside 0 to 1.
ISLET_C_API IsletVec2 islet_vec2_lerp(IsletVec2 a, IsletVec2 b, float t);

/// The smaller of each coordinate.
ISLET_C_API IsletVec2 islet_vec2_min(IsletVec2 a, IsletVec2 b);

/// The larger of each coordinate.
ISLET_C_API IsletVec2 islet_vec2_max(IsletVec2 a, IsletVec2 b);

/// v turned by q.
ISLET_C_API IsletVec2 islet_rot_rotate(IsletRot q, IsletVec2 v);

/// v turned by the inverse of q.
ISLET_C_API IsletVec2 islet_rot_inv_rotate(IsletRot q, IsletVec2 v);

/// First r, then q.
ISLET_C_API IsletRot islet_rot_multiply(IsletRot q, IsletRot r);

/// The same turn the other way.
ISLET_C_API IsletRot islet_rot_inverse(IsletRot q);

/// inverse(q) * r: the rotation that leads from q to r.
ISLET_C_API IsletRot islet_rot_inv_mul(IsletRot q, IsletRot r);

/// The point v of a body with the pose t, seen from the world, m.
ISLET_C_API IsletVec2 islet_transform_point(IsletTransform t, IsletVec2 v);

/// The point v of the world, seen from a body with the pose t, m.
ISLET_C_API IsletVec2 islet_inv_transform_point(IsletTransform t, IsletVec2 v);

/// The pose of b seen from a: inverse(a) * b.
ISLET_C_API IsletTransform islet_transform_inv_mul(IsletTransform a, IsletTransform b);

/// Whether two boxes share a point; boxes that touch do.
ISLET_C_API bool islet_aabb_overlaps(IsletAabb a, IsletAabb b);

/// Whether no point of inner is outside outer.
ISLET_C_API bool islet_aabb_contains(IsletAabb outer, IsletAabb inner);

/// The smallest box that contains both.
ISLET_C_API IsletAabb islet_aabb_merge(IsletAabb a, IsletAabb b);

/// The box with each side moved outward by margin, m.
ISLET_C_API IsletAabb islet_aabb_expand(IsletAabb a, float margin);

/// The sum of the four sides, m.
ISLET_C_API float islet_aabb_perimeter(IsletAabb a);
ISLET_C_API bool islet_vec2_is_finite(IsletVec2 a);

/// Euclidean length, in the unit of a; correctly rounded square root, the same bits everywhere.
ISLET_C_API float islet_vec2_length(IsletVec2 a);

/// length(b - a), m.
ISLET_C_API float islet_vec2_distance(IsletVec2 a, IsletVec2 b);

/// a / |a|, or the zero vector if |a| is below 1e-18 m, above 1e19 m (its square overflows) or not finite.
ISLET_C_API IsletVec2 islet_vec2_normalize(IsletVec2 a);

/// Sine and cosine of any finite angle in radians, the same bits on every machine. The error is stated and tested in math/trig.cpp. Huge angles are reduced
/// exactly, but are themselves rounded (0.004 rad at 1e5); a non-finite angle gives the identity rotation.
ISLET_C_API IsletRot islet_make_rot(float radians);

/// Angle of q in (-pi, pi], radians.
ISLET_C_API float islet_rot_angle(IsletRot q);

/// Angle of the vector (x, y) in (-pi, pi], radians; 0 for the zero vector or a non-finite one. The same bits everywhere.
ISLET_C_API float islet_atan2(float y, float x);

/// q scaled back to unit length; the identity if q is degenerate.
ISLET_C_API IsletRot islet_rot_normalize(IsletRot q);

/// Between two rotations by the fraction t, the short way: q at t = 0, r at t = 1, with nearly steady speed. For turns of less than half a circle.
ISLET_C_API IsletRot islet_rot_lerp(IsletRot q, IsletRot r, float t);

/// Between two poses by the fraction t, for drawing between two steps.
ISLET_C_API IsletTransform islet_transform_lerp(IsletTransform a, IsletTransform b, float t);

/// q turned further by an angle d (radians) and normalised: the integration of an angular velocity over a step. Within 1e-7 rad for |d| <= 0.5 and 1e-3 rad
/// for |d| <= pi/2; larger turns are cut to pi/2, and a NaN turns nothing.
ISLET_C_API IsletRot islet_rot_integrate(IsletRot q, float delta_radians);

/// The convex hull of up to max_polygon_vertices points in any order. It begins with the leftmost point (if there are several, the lowest). Duplicates
/// (closer than 0.005 m) and collinear points (standing out by less than 0.0005 m) are dropped. The result depends on the set of points, not on their order.
/// Returns count 0 if fewer than 3 points remain, if there are more than 8 points given, or if a coordinate is not finite or above 1e7 m.
ISLET_C_API IsletHull islet_compute_hull(const IsletVec2* points, size_t points_count);

/// Polygon from a hull; count 0 if the hull has fewer than 3 points or is not convex, or if radius (m) is negative or not finite.
ISLET_C_API IsletPolygon islet_make_polygon(const IsletHull* hull, float radius);

/// Axis-aligned box of half-width hx and half-height hy (metres, > 0; count 0 otherwise), centred on the body's origin.
ISLET_C_API IsletPolygon islet_make_box(float hx, float hy);

/// Box with rounded corners: the total half extents are hx + radius and hy + radius, m.
ISLET_C_API IsletPolygon islet_make_rounded_box(float hx, float hy, float radius);

/// Box with its centre at pose.p, turned by pose.q; half extents and radius in m.
ISLET_C_API IsletPolygon islet_make_offset_box(float hx, float hy, IsletTransform pose, float radius);

/// p moved by t; count 0 if the result is not valid (t not finite, or so far away that rounding destroys the shape).
ISLET_C_API IsletPolygon islet_transform_polygon(IsletTransform t, const IsletPolygon* p);

/// True if the geometry obeys its own rules above (finite, sizes positive, convex, counter-clockwise, unit normals).
ISLET_C_API bool islet_circle_is_valid(const IsletCircle* c);
ISLET_C_API bool islet_capsule_is_valid(const IsletCapsule* c);
ISLET_C_API bool islet_segment_is_valid(const IsletSegment* s);
ISLET_C_API bool islet_chain_segment_is_valid(const IsletChainSegment* s);
ISLET_C_API bool islet_half_space_is_valid(const IsletHalfSpace* h);
ISLET_C_API bool islet_polygon_is_valid(const IsletPolygon* p);

/// Mass properties at a density in kg/m^2 (>= 0); all zero if the shape or the density is not valid. Segments have none. A rounded polygon is, exactly, the
/// Minkowski sum of the polygon and a disc.
ISLET_C_API IsletMassData islet_circle_compute_mass(const IsletCircle* c, float density);
ISLET_C_API IsletMassData islet_capsule_compute_mass(const IsletCapsule* c, float density);
ISLET_C_API IsletMassData islet_polygon_compute_mass(const IsletPolygon* p, float density);

/// The tight bounding box of a shape that is moved by t.
ISLET_C_API IsletAabb islet_circle_compute_aabb(const IsletCircle* c, IsletTransform t);
ISLET_C_API IsletAabb islet_capsule_compute_aabb(const IsletCapsule* c, IsletTransform t);
ISLET_C_API IsletAabb islet_segment_compute_aabb(const IsletSegment* s, IsletTransform t);
ISLET_C_API IsletAabb islet_polygon_compute_aabb(const IsletPolygon* p, IsletTransform t);

/// Colour number n of an endless series in which neighbours are easy to tell apart. Islands and constraint colours are drawn in these.
ISLET_C_API IsletDrawColor islet_distinct_color(uint32_t n);

/// Draws a geometry as islet_world_draw draws a shape whose body is at `pose`. The options and the view have no effect.
ISLET_C_API void islet_draw_circle(const IsletDebugDraw* draw, const IsletCircle* circle, IsletTransform pose, const IsletDrawStyle* style);
ISLET_C_API void islet_draw_capsule(const IsletDebugDraw* draw, const IsletCapsule* capsule, IsletTransform pose, const IsletDrawStyle* style);
ISLET_C_API void islet_draw_segment(const IsletDebugDraw* draw, const IsletSegment* segment, IsletTransform pose, const IsletDrawStyle* style);

/// Nothing is drawn of a polygon with a count above max_polygon_vertices.
ISLET_C_API void islet_draw_polygon(const IsletDebugDraw* draw, const IsletPolygon* polygon, IsletTransform pose, const IsletDrawStyle* style);
ISLET_C_API IsletFieldFault islet_find_solver_def_fault(const IsletSolverDef* def);
ISLET_C_API IsletFieldFault islet_find_body_def_fault(const IsletBodyDef* def);
ISLET_C_API IsletFieldFault islet_find_shape_def_fault(const IsletShapeDef* def);
ISLET_C_API IsletFieldFault islet_find_explosion_def_fault(const IsletExplosionDef* def);
ISLET_C_API IsletFieldFault islet_find_wind_def_fault(const IsletWindDef* def);
ISLET_C_API IsletFieldFault islet_find_revolute_joint_def_fault(const IsletRevoluteJointDef* def);
ISLET_C_API IsletFieldFault islet_find_prismatic_joint_def_fault(const IsletPrismaticJointDef* def);
ISLET_C_API IsletFieldFault islet_find_distance_joint_def_fault(const IsletDistanceJointDef* def);
ISLET_C_API IsletFieldFault islet_find_weld_joint_def_fault(const IsletWeldJointDef* def);
ISLET_C_API IsletFieldFault islet_find_wheel_joint_def_fault(const IsletWheelJointDef* def);
ISLET_C_API IsletFieldFault islet_find_motor_joint_def_fault(const IsletMotorJointDef* def);
ISLET_C_API IsletFieldFault islet_find_mouse_joint_def_fault(const IsletMouseJointDef* def);
ISLET_C_API IsletFieldFault islet_find_pulley_joint_def_fault(const IsletPulleyJointDef* def);
ISLET_C_API IsletFieldFault islet_find_gear_joint_def_fault(const IsletGearJointDef* def);
ISLET_C_API IsletFieldFault islet_find_angle_joint_def_fault(const IsletAngleJointDef* def);

/// The same for what islet_create_world, the setters of bodies, shapes and joints, and step_mover refuse. Rules that only some joints have are not checked:
/// the limit of a distance joint begins at 0 or above, and a mouse joint has a linear frequency above 0 and no angular one.
ISLET_C_API IsletFieldFault islet_find_capacity_fault(const IsletCapacity* capacity);
ISLET_C_API IsletFieldFault islet_find_mass_data_fault(const IsletMassData* mass);
ISLET_C_API IsletFieldFault islet_find_surface_material_fault(const IsletSurfaceMaterial* material);
ISLET_C_API IsletFieldFault islet_find_joint_frame_fault(const IsletJointFrame* frame);
ISLET_C_API IsletFieldFault islet_find_joint_spring_fault(const IsletJointSpring* spring);
ISLET_C_API IsletFieldFault islet_find_joint_softness_fault(const IsletJointSoftness* softness);
ISLET_C_API IsletFieldFault islet_find_joint_limit_fault(const IsletJointLimit* limit);
ISLET_C_API IsletFieldFault islet_find_joint_motor_fault(const IsletJointMotor* motor);
ISLET_C_API IsletFieldFault islet_find_joint_ratchet_fault(const IsletJointRatchet* ratchet);
ISLET_C_API IsletFieldFault islet_find_mover_def_fault(const IsletMoverDef* def);

/// Whether islet_create_world accepts the capacity. (In the small profile a world has at most 65 535 bodies, as many shapes, and 32 767 contacts.)
ISLET_C_API bool islet_capacity_is_valid(const IsletCapacity* c);

/// Bytes of memory a world of this capacity needs, everything included; 0 if the capacity is not valid.
ISLET_C_API size_t islet_world_bytes(const IsletCapacity* capacity);

/// The proxy of a shape; count 0 if the shape is not valid.
ISLET_C_API IsletShapeProxy islet_make_circle_proxy(const IsletCircle* circle);
ISLET_C_API IsletShapeProxy islet_make_capsule_proxy(const IsletCapsule* capsule);
ISLET_C_API IsletShapeProxy islet_make_segment_proxy(const IsletSegment* segment);
ISLET_C_API IsletShapeProxy islet_make_polygon_proxy(const IsletPolygon* polygon);
ISLET_C_API IsletShapeProxy islet_make_chain_segment_proxy(const IsletChainSegment* segment);

/// The hull of up to 8 points (one and two are taken as they are, more by compute_hull), grown by radius (m); count 0 if there is none.
ISLET_C_API IsletShapeProxy islet_make_proxy(const IsletVec2* points, size_t points_count, float radius);

/// An upright box; count 0 unless lower < upper on both axes.
ISLET_C_API IsletShapeProxy islet_make_box_proxy(IsletAabb box);

/// p moved by t; count 0 if the result is not valid.
ISLET_C_API IsletShapeProxy islet_transform_proxy(IsletTransform t, const IsletShapeProxy* p);

/// 1 to 8 points within 4e7 m, 3 and more of them strictly convex and counter-clockwise; a radius of 0 to 1e7 m.
ISLET_C_API bool islet_proxy_is_valid(const IsletShapeProxy* p);

/// The first point of `target` on the way from `origin` to `origin + translation`. A ray that starts inside hits at fraction 0, in any direction. Its normal
/// points along the shortest way out, `point` is the end of that way, and separation is minus its length. A ray that starts on the surface hits only if it
/// leads inwards. A ray that runs along a segment or an edge does not hit it. At a corner that two segments share, a ray hits at least one of them. A
/// translation shorter than 1e-10 m hits only the shape in which it starts. No hit if an argument is not valid: target, origin within 4e7 m, translation
/// within max_translation.
ISLET_C_API IsletCastHit islet_cast_ray(const IsletShapeProxy* target, IsletVec2 origin, IsletVec2 translation);

/// The same for a moving shape. Shapes that overlap at the start hit at fraction 0; shapes that only touch do if the way leads inwards. A shape meets a
/// one-sided target only if it moves against the target's normal and the mean of its corners starts in front of the target.
ISLET_C_API IsletCastHit islet_cast_shape(const IsletShapeProxy* moving, IsletVec2 translation, const IsletShapeProxy* target);

/// True if they share a point.
ISLET_C_API bool islet_proxy_overlaps(const IsletShapeProxy* a, const IsletShapeProxy* b);

/// True if the point is in the shape or on its surface; segments contain no point.
ISLET_C_API bool islet_proxy_contains(const IsletShapeProxy* shape, IsletVec2 point);

/// Advances time by dt seconds, min_time_step <= dt <= 1. 1/60 is usual; see SolverDef for what a step consists of. Errors (nothing changes): bad_time_step;
/// in_step; inexact_build (of a StaticWorld).
ISLET_C_API IsletError islet_world_step(IsletWorld* world, float dt);

/// IsletWorldDef.gravity, m/s^2, (0, -10) by default. What a body feels of it is this times its gravity_scale.
ISLET_C_API IsletVec2 islet_world_gravity(const IsletWorld* world);

/// Sets it, m/s^2, from the next step on. It wakes no body: one that sleeps feels it when it is woken. A vector that is not finite is refused (not_finite).
ISLET_C_API IsletError islet_world_set_gravity(IsletWorld* world, IsletVec2 gravity);

/// The solver's settings: IsletWorldDef.solver, or what set_solver made of them.
ISLET_C_API IsletError islet_world_solver(const IsletWorld* world, IsletSolverDef* out);

/// Changes the solver's settings. A value out of range is refused (out_of_range), and nothing changes.
ISLET_C_API IsletError islet_world_set_solver(IsletWorld* world, const IsletSolverDef* solver);

/// m/s: how far the impulses of the body's island were from a solution when the last step ended. It is the largest change of a body's velocity that solving
/// any single contact or joint once more would cause. (A change of the angular velocity counts as the speed at the radius of gyration.) It is 0 at a
/// solution, for bodies at rest, and without IsletSolverDef.measure_residual. Hinges that are solved exactly, in joint trees, are not measured.
ISLET_C_API float islet_body_residual(const IsletWorld* world, IsletBodyId body);

/// The threads that step the world (IsletWorldDef.tasks); none by default.
ISLET_C_API IsletError islet_world_tasks(const IsletWorld* world, IsletTaskSystem* out);

/// Sets the threads that step the world. IsletTaskSystem.workers of 0 or above max_workers is refused (out_of_range). The task system is not part of the
/// state: hashes and snapshots do not contain it.
ISLET_C_API IsletError islet_world_set_tasks(IsletWorld* world, const IsletTaskSystem* tasks);

/// How long the stages of the last step took. Only programs that call this function measure it.
ISLET_C_API IsletError islet_world_profile(const IsletWorld* world, IsletStepProfile* out);

/// Sets the clock that measures stages; null for none. The clock is not part of the state: hashes and snapshots do not contain it.
ISLET_C_API IsletError islet_world_set_clock(IsletWorld* world, IsletClock clock, void* context);

/// Figures of the world for displays, beside those of report(). They are counted when you call it.
ISLET_C_API IsletError islet_world_counters(const IsletWorld* world, IsletWorldCounters* out);

/// IsletWorldDef.enable_sleep. Turning sleep off wakes everything.
ISLET_C_API bool islet_world_sleep_enabled(const IsletWorld* world);
ISLET_C_API IsletError islet_world_enable_sleep(IsletWorld* world, bool enable);

/// IsletWorldDef.restitution_threshold, m/s, >= 0.
ISLET_C_API float islet_world_restitution_threshold(const IsletWorld* world);
ISLET_C_API IsletError islet_world_set_restitution_threshold(IsletWorld* world, float speed);

/// IsletWorldDef.max_speed, m/s, above 0 and at most max_speed_limit. A lower one slows faster bodies down in the next step.
ISLET_C_API float islet_world_max_speed(const IsletWorld* world);
ISLET_C_API IsletError islet_world_set_max_speed(IsletWorld* world, float speed);

/// How many constraints this world solves at once, at most: 1, 4, 8 or 16 (IsletWorldDef.lanes).
ISLET_C_API uint32_t islet_world_lanes(const IsletWorld* world);

/// IsletWorldDef.continuous.
ISLET_C_API bool islet_world_continuous(const IsletWorld* world);
ISLET_C_API IsletError islet_world_enable_continuous(IsletWorld* world, bool enable);

/// IsletWorldDef.seamless_floors. A change holds for each contact from when its points are found anew. Error: feature_cut.
ISLET_C_API bool islet_world_seamless_floors(const IsletWorld* world);
ISLET_C_API IsletError islet_world_enable_seamless_floors(IsletWorld* world, bool enable);

/// The hooks as they were last set; none by default.
ISLET_C_API IsletError islet_world_hooks(const IsletWorld* world, IsletHooks* out);

/// Sets the hooks. Two shapes in contact keep their mixed friction, and whether they bounce, until a material changes or the shapes part. How much they
/// bounce is mixed anew in every step.
ISLET_C_API IsletError islet_world_set_hooks(IsletWorld* world, const IsletHooks* hooks);

/// m/s, >= 0 (IsletWorldDef.hit_threshold)
ISLET_C_API float islet_world_hit_threshold(const IsletWorld* world);
ISLET_C_API IsletError islet_world_set_hit_threshold(IsletWorld* world, float speed);

/// Pushes the circles, capsules and polygons of dynamic bodies in reach away from a point. The impulse is impulse_per_length times the shape's width across
/// the direction from the explosion to the shape's nearest point, and acts at that point. (If the explosion is inside the shape, the direction is that to the
/// shape's middle.) Shapes do not shield each other. Sensors feel nothing. The bodies pushed wake up.
ISLET_C_API IsletError islet_world_explode(IsletWorld* world, const IsletExplosionDef* explosion);

/// How many objects of each kind there is room for, as create() was told.
ISLET_C_API IsletError islet_world_capacity(const IsletWorld* world, IsletCapacity* out);

/// What the last step did, and how many objects the world holds.
ISLET_C_API IsletError islet_world_report(const IsletWorld* world, IsletStepReport* out);

/// The error hook as it was last set (IsletWorldDef.error_hook); null if there is none.
ISLET_C_API IsletErrorHook islet_world_error_hook(const IsletWorld* world);

/// What the error hook gets as its context; null by default.
ISLET_C_API void* islet_world_error_context(const IsletWorld* world);

/// Sets the function that receives each error; null for none. The hook is not part of the state: hashes, snapshots and recordings do not contain it.
ISLET_C_API IsletError islet_world_set_error_hook(IsletWorld* world, IsletErrorHook hook, void* context);

/// Hash of all persistent state that affects the future, and of nothing else. Worlds with equal hashes have equal futures, and their next steps report equal
/// events, those of touches that ended since the last step included. Returns 0 on an error: in_step.
ISLET_C_API uint64_t islet_world_hash(const IsletWorld* world);

/// Steps taken since creation.
ISLET_C_API uint64_t islet_world_step_count(const IsletWorld* world);

/// Checks every internal invariant (lists, pools, trees, colours). Slow; for tests. Returns null or a sentence that says what is broken.
ISLET_C_API const char* islet_world_validate(const IsletWorld* world);

/// Bytes that save() needs now.
ISLET_C_API size_t islet_world_snapshot_bytes(const IsletWorld* world);

/// Writes the persistent state to `out`; returns the bytes written, or 0 if it is too small (image_too_small).
ISLET_C_API size_t islet_world_save(const IsletWorld* world, void* out, size_t out_bytes);

/// Takes the world back to an image that this program made. The objects in the image must fit this world's capacity. The capacity of the saved world may have
/// been another. Only the image's header is checked; the rest is copied as fast as memory allows. The world keeps what belongs to the host: lanes, hooks, the
/// clock and the task system. There are no events until the next step, and the report holds only the numbers of objects. Touches that had ended since the
/// last step, because a shape was destroyed, are part of the image: the next step reports them. Returns false and changes nothing on an error: those of
/// read_snapshot; image_too_large; feature_cut if this build or program lacks a part that the image needs. (A program that neither makes joints nor calls
/// load does not link joints, so it cannot restore an image with joints.)
ISLET_C_API bool islet_world_restore(IsletWorld* world, const void* image, size_t image_bytes);

/// Like restore, for an image from outside, which may be truncated, corrupt or hostile. Nothing of it is used before all of it is found sound. Further
/// errors: image_misaligned (see snapshot_alignment); corrupt_image if the checksum does not fit the content; unsound_image.
ISLET_C_API bool islet_world_load(IsletWorld* world, const void* image, size_t image_bytes);

/// Writes a snapshot to `buffer`, and after it every call that changes the world. The buffer must be aligned to recording_alignment; it belongs to the world
/// until the recording stops. With `bodies`, each step also writes a hash of each awake body, four bytes long. Returns false, and records nothing, if there
/// is no room for the snapshot (recording_full) or the buffer is misaligned (image_misaligned). If there is no more room later, the recording stops by itself
/// (recording_full) and holds all calls before. A recording that is already running is discarded.
ISLET_C_API bool islet_world_start_recording(IsletWorld* world, void* buffer, size_t buffer_bytes, bool bodies);

/// True from start_recording until the recording stops.
ISLET_C_API bool islet_world_is_recording(const IsletWorld* world);

/// Bytes used so far; 0 if nothing is being recorded.
ISLET_C_API size_t islet_world_recorded_bytes(const IsletWorld* world);

/// Continues the recording in a larger buffer. Returns false, and changes nothing, if the buffer is smaller than recorded_bytes() (recording_full) or
/// misaligned (image_misaligned), or if nothing is being recorded (not_a_recording).
ISLET_C_API bool islet_world_move_recording(IsletWorld* world, void* buffer, size_t buffer_bytes);

/// Ends the recording; returns its bytes, or 0 if nothing is being recorded (not_a_recording).
ISLET_C_API size_t islet_world_stop_recording(IsletWorld* world);

/// Pairs of shapes that began to touch in the last step.
ISLET_C_API IsletTouchEventSpan islet_world_begin_touch_events(const IsletWorld* world);

/// Contacts that ended in the last step, and in calls made since. This list and sensor_end_events() have room for IsletCapacity.contacts events together. If
/// calls need that room, they remove the events of the last step, so read these events before you make calls.
ISLET_C_API IsletTouchEventSpan islet_world_end_touch_events(const IsletWorld* world);

/// Overlaps of sensors that began, and that ended, in the same order as touches. A step reports the overlaps at the poses with which it begins. An overlap
/// that a call ends is reported at once, and again after the next step.
ISLET_C_API IsletSensorEventSpan islet_world_sensor_begin_events(const IsletWorld* world);
ISLET_C_API IsletSensorEventSpan islet_world_sensor_end_events(const IsletWorld* world);

/// Contacts of shapes with IsletShapeDef.hit_events whose surfaces came together faster than hit_threshold() and needed an impulse, ordered by slot.
ISLET_C_API IsletHitEventSpan islet_world_hit_events(const IsletWorld* world);

/// Bodies that the last step moved (every awake one), ordered by slot.
ISLET_C_API IsletBodyIdSpan islet_world_moved_bodies(const IsletWorld* world);

/// Bodies that fell asleep in the last step, ordered by slot.
ISLET_C_API IsletBodyIdSpan islet_world_slept_bodies(const IsletWorld* world);

/// Joints that broke at the end of the last step, ordered by slot.
ISLET_C_API IsletJointBreakEventSpan islet_world_broken_joints(const IsletWorld* world);

/// Returns null on an error: bodies_full; not_finite, out_of_range and feature_cut of a field, which find_fault names (fault.hpp).
ISLET_C_API IsletBodyId islet_create_body(IsletWorld* world, const IsletBodyDef* def);

/// Destroys the body with its shapes, contacts and joints. Wakes the bodies that touched it or were joined to it.
ISLET_C_API IsletError islet_destroy_body(IsletWorld* world, IsletBodyId body);

/// True if the id names a body that exists. No id is an error here.
ISLET_C_API bool islet_body_is_valid(const IsletWorld* world, IsletBodyId body);

/// Number of live bodies.
ISLET_C_API uint32_t islet_world_body_count(const IsletWorld* world);

/// Id of the body in slot 0 <= slot < capacity().bodies; null if the slot is free. For walking over all bodies.
ISLET_C_API IsletBodyId islet_world_body_at(const IsletWorld* world, uint32_t slot);

/// The pose of the body's origin, m.
ISLET_C_API IsletTransform islet_body_transform(const IsletWorld* world, IsletBodyId body);

/// The body's origin.
ISLET_C_API IsletVec2 islet_body_position(const IsletWorld* world, IsletBodyId body);

/// rad, in (-pi, pi]
ISLET_C_API float islet_body_angle(const IsletWorld* world, IsletBodyId body);

/// m, in the world
ISLET_C_API IsletVec2 islet_body_center_of_mass(const IsletWorld* world, IsletBodyId body);

/// m, from the origin, in the body's frame
ISLET_C_API IsletVec2 islet_body_local_center_of_mass(const IsletWorld* world, IsletBodyId body);

/// m/s, of the centre of mass
ISLET_C_API IsletVec2 islet_body_linear_velocity(const IsletWorld* world, IsletBodyId body);

/// rad/s
ISLET_C_API float islet_body_angular_velocity(const IsletWorld* world, IsletBodyId body);

/// m/s: the velocity of the point of the body that is now at world position `point`.
ISLET_C_API IsletVec2 islet_body_velocity_at(const IsletWorld* world, IsletBodyId body, IsletVec2 point);

/// Teleports the body to a position, m, and an angle, rad. Its contacts are found anew; it keeps its velocity. Wakes the body, and the bodies that touched it
/// or are joined to it.
ISLET_C_API IsletError islet_body_set_transform(IsletWorld* world, IsletBodyId body, IsletVec2 position, float angle);

/// The same. pose.q must be of unit length (out_of_range).
ISLET_C_API IsletError islet_body_set_pose(IsletWorld* world, IsletBodyId body, IsletTransform pose);

/// m/s, of the centre of mass. No effect on static bodies. Wakes the body if the velocity is not zero.
ISLET_C_API IsletError islet_body_set_linear_velocity(IsletWorld* world, IsletBodyId body, IsletVec2 velocity);

/// The same, rad/s; no effect on bodies of fixed rotation either.
ISLET_C_API IsletError islet_body_set_angular_velocity(IsletWorld* world, IsletBodyId body, float velocity);

/// Gives a kinematic body the velocities that take it to a pose in a step of dt seconds, except for rounding: at most max_speed, and at most a quarter turn.
/// The body keeps the velocities after that step, so call this function before each step. No effect on other bodies. target.q must be of unit length.
ISLET_C_API IsletError islet_body_set_target(IsletWorld* world, IsletBodyId body, IsletTransform target, float dt);

/// Forces (N) and torques (N m) act over the next step and are then cleared. Impulses (N s, N m s) act at once. All of these need a dynamic body, and wake
/// it. With wake = false they have no effect on a body that sleeps, and do not keep a body that rests from falling asleep.
ISLET_C_API IsletError islet_body_apply_force(IsletWorld* world, IsletBodyId body, IsletVec2 force, IsletVec2 point, bool wake);
ISLET_C_API IsletError islet_body_apply_force_to_center(IsletWorld* world, IsletBodyId body, IsletVec2 force, bool wake);
ISLET_C_API IsletError islet_body_apply_torque(IsletWorld* world, IsletBodyId body, float torque, bool wake);
ISLET_C_API IsletError islet_body_apply_linear_impulse(IsletWorld* world, IsletBodyId body, IsletVec2 impulse, IsletVec2 point, bool wake);
ISLET_C_API IsletError islet_body_apply_linear_impulse_to_center(IsletWorld* world, IsletBodyId body, IsletVec2 impulse, bool wake);
ISLET_C_API IsletError islet_body_apply_angular_impulse(IsletWorld* world, IsletBodyId body, float impulse, bool wake);

/// Static, kinematic or dynamic.
ISLET_C_API IsletBodyType islet_body_type(const IsletWorld* world, IsletBodyId body);

/// Changes the type. Contacts are found anew, and the body gets the mass of its shapes again. Wakes the bodies that touched it or are joined to it. A body
/// that becomes static loses its velocity.
ISLET_C_API IsletError islet_body_set_type(IsletWorld* world, IsletBodyId body, IsletBodyType type);

/// kg; 0 for a body that is not dynamic
ISLET_C_API float islet_body_mass(const IsletWorld* world, IsletBodyId body);

/// kg m^2, about the centre of mass
ISLET_C_API float islet_body_rotational_inertia(const IsletWorld* world, IsletBodyId body);

/// Replaces the mass, centre and inertia that follow from the shapes, until a shape is added or removed, the type changes or reset_mass is called. mass:
/// 1e-12 to 1e30 kg; inertia: 1e-15 to 1e30 kg m^2, or 0 for a body that does not turn; centre: within max_position.
ISLET_C_API IsletError islet_body_set_mass(IsletWorld* world, IsletBodyId body, const IsletMassData* mass);

/// Takes mass, centre and inertia from the shapes' densities again.
ISLET_C_API IsletError islet_body_reset_mass(IsletWorld* world, IsletBodyId body);

/// 1/s, >= 0 (IsletBodyDef.linear_damping)
ISLET_C_API float islet_body_linear_damping(const IsletWorld* world, IsletBodyId body);
ISLET_C_API IsletError islet_body_set_linear_damping(IsletWorld* world, IsletBodyId body, float damping);

/// 1/s, >= 0
ISLET_C_API float islet_body_angular_damping(const IsletWorld* world, IsletBodyId body);
ISLET_C_API IsletError islet_body_set_angular_damping(IsletWorld* world, IsletBodyId body, float damping);

/// Multiple of the gravity that the body feels.
ISLET_C_API float islet_body_gravity_scale(const IsletWorld* world, IsletBodyId body);
ISLET_C_API IsletError islet_body_set_gravity_scale(IsletWorld* world, IsletBodyId body, float scale);

/// IsletBodyDef.fixed_rotation. Fixing it makes the angular velocity 0. A change wakes the body.
ISLET_C_API bool islet_body_is_rotation_fixed(const IsletWorld* world, IsletBodyId body);
ISLET_C_API IsletError islet_body_set_fixed_rotation(IsletWorld* world, IsletBodyId body, bool fixed);

/// IsletBodyDef.lock_x and lock_y.
ISLET_C_API bool islet_body_is_x_locked(const IsletWorld* world, IsletBodyId body);
ISLET_C_API bool islet_body_is_y_locked(const IsletWorld* world, IsletBodyId body);
ISLET_C_API IsletError islet_body_lock_x(IsletWorld* world, IsletBodyId body, bool lock);
ISLET_C_API IsletError islet_body_lock_y(IsletWorld* world, IsletBodyId body, bool lock);

/// IsletBodyDef.enabled.
ISLET_C_API bool islet_body_is_enabled(const IsletWorld* world, IsletBodyId body);

/// A disabled body keeps its shapes, joints and velocity, but takes part in nothing: its contacts and overlaps end, its joints hold no body, it does not
/// move, and no query finds it. Disabling and enabling wake the bodies that touched it or are joined to it.
ISLET_C_API IsletError islet_body_set_enabled(IsletWorld* world, IsletBodyId body, bool enabled);

/// IsletBodyDef.bullet. No effect unless the body is dynamic.
ISLET_C_API bool islet_body_is_bullet(const IsletWorld* world, IsletBodyId body);
ISLET_C_API IsletError islet_body_set_bullet(IsletWorld* world, IsletBodyId body, bool bullet);

/// IsletBodyDef.enable_sleep.
ISLET_C_API bool islet_body_sleep_enabled(const IsletWorld* world, IsletBodyId body);
ISLET_C_API IsletError islet_body_enable_sleep(IsletWorld* world, IsletBodyId body, bool enable);

/// m/s, >= 0 (IsletBodyDef.sleep_threshold)
ISLET_C_API float islet_body_sleep_threshold(const IsletWorld* world, IsletBodyId body);
ISLET_C_API IsletError islet_body_set_sleep_threshold(IsletWorld* world, IsletBodyId body, float threshold);

/// False for a body that sleeps.
ISLET_C_API bool islet_body_is_awake(const IsletWorld* world, IsletBodyId body);

/// Wakes the body and its island.
ISLET_C_API IsletError islet_body_wake(IsletWorld* world, IsletBodyId body);

/// Puts a dynamic body and its island to sleep at once; their velocities and forces become 0. No effect on other bodies, if the island touches or is joined
/// to a kinematic body that is awake, or if the world does not sleep (IsletWorldDef.enable_sleep).
ISLET_C_API IsletError islet_body_sleep(IsletWorld* world, IsletBodyId body);

/// IsletBodyDef.user_data: a number of yours, 0 by default. The engine only keeps it.
ISLET_C_API uint64_t islet_body_user_data(const IsletWorld* world, IsletBodyId body);
ISLET_C_API IsletError islet_body_set_user_data(IsletWorld* world, IsletBodyId body, uint64_t data);

/// Writes the body's touching contacts, newest first, as far as they fit; returns how many there are.
ISLET_C_API uint32_t islet_body_contacts(const IsletWorld* world, IsletBodyId body, IsletContactInfo* out, size_t out_count);

/// Writes the ids of the body's shapes, newest first, as far as they fit; returns how many there are.
ISLET_C_API uint32_t islet_body_shapes(const IsletWorld* world, IsletBodyId body, IsletShapeId* out, size_t out_count);

/// For walking over a body's shapes without memory (ranges.hpp): the next one in the order of shapes(), the first one after null. Returns null after the last
/// one, and on an error: out_of_range if `shape` is not the body's.
ISLET_C_API IsletShapeId islet_body_next_shape(const IsletWorld* world, IsletBodyId body, IsletShapeId shape);

/// The same for its touching contacts, in the order of contacts(). `contact` is 0 at first, and then what the last call returned: slot + 1 of the contact
/// that it wrote to `out`, or 0 after the last one and on an error: out_of_range if `contact` is none of the body's.
ISLET_C_API uint32_t islet_body_next_contact(const IsletWorld* world, IsletBodyId body, uint32_t contact, IsletContactInfo* out);

/// Returns null on an error: shapes_full; geometries_full; bad_geometry; not_finite, out_of_range and feature_cut of a field, which find_fault names
/// (fault.hpp). def may be null.
ISLET_C_API IsletShapeId islet_create_circle(IsletWorld* world, IsletBodyId body, const IsletCircle* circle, const IsletShapeDef* def);
/// def may be null.
ISLET_C_API IsletShapeId islet_create_capsule(IsletWorld* world, IsletBodyId body, const IsletCapsule* capsule, const IsletShapeDef* def);
/// def may be null.
ISLET_C_API IsletShapeId islet_create_segment(IsletWorld* world, IsletBodyId body, const IsletSegment* segment, const IsletShapeDef* def);
/// def may be null.
ISLET_C_API IsletShapeId islet_create_polygon(IsletWorld* world, IsletBodyId body, const IsletPolygon* polygon, const IsletShapeDef* def);
/// def may be null.
ISLET_C_API IsletShapeId islet_create_chain_segment(IsletWorld* world, IsletBodyId body, const IsletChainSegment* segment, const IsletShapeDef* def);

/// Static and kinematic bodies only (ISLET_ERROR_ENDLESS_SHAPE). def may be null.
ISLET_C_API IsletShapeId islet_create_half_space(IsletWorld* world, IsletBodyId body, const IsletHalfSpace* half_space, const IsletShapeDef* def);

/// A chain of ChainSegments through `points` (2 or more; 3 for a loop), which collides on the right of its direction and does not catch at its inner corners.
/// All or nothing. Returns the number of segments made, and their ids in `out` as far as they fit; 0 on an error: bad_chain; shapes_full; geometries_full;
/// endless_shape; those of a ShapeDef. def may be null.
ISLET_C_API uint32_t islet_create_chain(IsletWorld* world, IsletBodyId body, const IsletVec2* points, size_t points_count, bool loop,
    const IsletShapeDef* def, IsletShapeId* out, size_t out_count);

/// Destroys the shape and its contacts, and computes the body's mass again.
ISLET_C_API IsletError islet_destroy_shape(IsletWorld* world, IsletShapeId shape);

/// True if the id names a shape that exists. No id is an error here.
ISLET_C_API bool islet_shape_is_valid(const IsletWorld* world, IsletShapeId shape);

/// Number of live shapes.
ISLET_C_API uint32_t islet_world_shape_count(const IsletWorld* world);

/// Id of the shape in slot 0 <= slot < capacity().shapes; null if the slot is free.
ISLET_C_API IsletShapeId islet_world_shape_at(const IsletWorld* world, uint32_t slot);

/// Writes the shape's touching contacts, newest first, as far as they fit; returns how many there are.
ISLET_C_API uint32_t islet_shape_contacts(const IsletWorld* world, IsletShapeId shape, IsletContactInfo* out, size_t out_count);

/// The next of these, as next_contact of a body: out_of_range if `contact` is none of the shape's body.
ISLET_C_API uint32_t islet_shape_next_contact(const IsletWorld* world, IsletShapeId shape, uint32_t contact, IsletContactInfo* out);

/// The body that the shape belongs to.
ISLET_C_API IsletBodyId islet_shape_body(const IsletWorld* world, IsletShapeId shape);

/// Which kind of geometry the shape has.
ISLET_C_API IsletShapeType islet_shape_type(const IsletWorld* world, IsletShapeId shape);

/// The geometry; null if the shape is of another type (which is no error), or if the id is invalid (which is one).
ISLET_C_API const IsletCircle* islet_shape_circle(const IsletWorld* world, IsletShapeId shape);
ISLET_C_API const IsletCapsule* islet_shape_capsule(const IsletWorld* world, IsletShapeId shape);
ISLET_C_API const IsletSegment* islet_shape_segment(const IsletWorld* world, IsletShapeId shape);
ISLET_C_API const IsletPolygon* islet_shape_polygon(const IsletWorld* world, IsletShapeId shape);
ISLET_C_API const IsletChainSegment* islet_shape_chain_segment(const IsletWorld* world, IsletShapeId shape);
ISLET_C_API const IsletHalfSpace* islet_shape_half_space(const IsletWorld* world, IsletShapeId shape);

/// Gives the shape another geometry, of any type. Its contacts and overlaps end; the next step finds those of the new geometry. The body's mass is computed
/// again. Wakes the body and the bodies that touched the shape. Errors: bad_geometry; geometries_full; endless_shape.
ISLET_C_API IsletError islet_shape_set_circle(IsletWorld* world, IsletShapeId shape, const IsletCircle* circle);
ISLET_C_API IsletError islet_shape_set_capsule(IsletWorld* world, IsletShapeId shape, const IsletCapsule* capsule);
ISLET_C_API IsletError islet_shape_set_segment(IsletWorld* world, IsletShapeId shape, const IsletSegment* segment);
ISLET_C_API IsletError islet_shape_set_polygon(IsletWorld* world, IsletShapeId shape, const IsletPolygon* polygon);
ISLET_C_API IsletError islet_shape_set_half_space(IsletWorld* world, IsletShapeId shape, const IsletHalfSpace* half_space);
ISLET_C_API IsletError islet_shape_set_chain_segment(IsletWorld* world, IsletShapeId shape, const IsletChainSegment* segment);

/// kg/m^2, >= 0. Setting it computes the body's mass again.
ISLET_C_API float islet_shape_density(const IsletWorld* world, IsletShapeId shape);
ISLET_C_API IsletError islet_shape_set_density(IsletWorld* world, IsletShapeId shape, float density);

/// The tight box around the shape, world coordinates.
ISLET_C_API IsletAabb islet_shape_aabb(const IsletWorld* world, IsletShapeId shape);

/// IsletShapeDef.friction and the three that follow, with their ranges. Setting one of these wakes the body and the bodies that touch the shape.
ISLET_C_API float islet_shape_friction(const IsletWorld* world, IsletShapeId shape);
ISLET_C_API IsletError islet_shape_set_friction(IsletWorld* world, IsletShapeId shape, float friction);
ISLET_C_API float islet_shape_restitution(const IsletWorld* world, IsletShapeId shape);
ISLET_C_API IsletError islet_shape_set_restitution(IsletWorld* world, IsletShapeId shape, float restitution);
ISLET_C_API float islet_shape_rolling_resistance(const IsletWorld* world, IsletShapeId shape);
ISLET_C_API IsletError islet_shape_set_rolling_resistance(IsletWorld* world, IsletShapeId shape, float resistance);
ISLET_C_API float islet_shape_tangent_speed(const IsletWorld* world, IsletShapeId shape);
ISLET_C_API IsletError islet_shape_set_tangent_speed(IsletWorld* world, IsletShapeId shape, float speed);

/// All of these at once, and the number of yours (IsletSurfaceMaterial.id).
ISLET_C_API IsletSurfaceMaterial islet_shape_material(const IsletWorld* world, IsletShapeId shape);
ISLET_C_API IsletError islet_shape_set_material(IsletWorld* world, IsletShapeId shape, const IsletSurfaceMaterial* material);

/// IsletShapeDef.sensor. Changing it ends the shape's contacts and overlaps, and wakes the bodies that touched it; the next step finds new ones.
ISLET_C_API bool islet_shape_is_sensor(const IsletWorld* world, IsletShapeId shape);
ISLET_C_API IsletError islet_shape_set_sensor(IsletWorld* world, IsletShapeId shape, bool sensor);

/// Writes the shapes that overlap the sensor, as far as they fit; the shape that came near last comes first. Returns how many there are. Error: not_a_sensor.
ISLET_C_API uint32_t islet_shape_sensor_overlaps(const IsletWorld* world, IsletShapeId sensor, IsletShapeId* out, size_t out_count);

/// IsletShapeDef.sensor_events, hit_events and pre_solve.
ISLET_C_API bool islet_shape_sensor_events_enabled(const IsletWorld* world, IsletShapeId shape);
ISLET_C_API IsletError islet_shape_enable_sensor_events(IsletWorld* world, IsletShapeId shape, bool enable);
ISLET_C_API bool islet_shape_hit_events_enabled(const IsletWorld* world, IsletShapeId shape);
ISLET_C_API IsletError islet_shape_enable_hit_events(IsletWorld* world, IsletShapeId shape, bool enable);
ISLET_C_API bool islet_shape_pre_solve_enabled(const IsletWorld* world, IsletShapeId shape);
ISLET_C_API IsletError islet_shape_enable_pre_solve(IsletWorld* world, IsletShapeId shape, bool enable);

/// IsletShapeDef.one_way; the direction returned is a unit vector, or zero. Setting it wakes the body and the bodies that touch the shape. A body that stands
/// on the shape goes on standing if it is above in the new direction, too. Errors: those of the id; not_finite; feature_cut.
ISLET_C_API IsletVec2 islet_shape_one_way(const IsletWorld* world, IsletShapeId shape);
ISLET_C_API IsletError islet_shape_set_one_way(IsletWorld* world, IsletShapeId shape, IsletVec2 direction);

/// Adds the force of a wind on the part of the shape's outline that faces it. Like apply_force, it acts over the next step. The force is rho u^2 / 2 times
/// width times coefficient, where u is the air's velocity past the shape's middle, the shape's own motion included. It pushes each face of a polygon at the
/// face's middle; only flat faces have lift. No effect on segments and on bodies that are not dynamic. Shapes do not shield each other.
ISLET_C_API IsletError islet_shape_apply_wind(IsletWorld* world, IsletShapeId shape, const IsletWindDef* wind);

/// IsletShapeDef.filter.
ISLET_C_API IsletFilter islet_shape_filter(const IsletWorld* world, IsletShapeId shape);

/// Contacts that the new filter forbids end; new ones are found in the next step.
ISLET_C_API IsletError islet_shape_set_filter(IsletWorld* world, IsletShapeId shape, const IsletFilter* filter);

/// IsletShapeDef.user_data.
ISLET_C_API uint64_t islet_shape_user_data(const IsletWorld* world, IsletShapeId shape);
ISLET_C_API IsletError islet_shape_set_user_data(IsletWorld* world, IsletShapeId shape, uint64_t data);

/// Pairs of shapes with overlapping fat boxes, touching or not.
ISLET_C_API uint32_t islet_world_contact_count(const IsletWorld* world);

/// Reads the contact in slot 0 <= slot < capacity().contacts. False if the slot is free or the shapes do not touch.
ISLET_C_API bool islet_world_contact_at(const IsletWorld* world, uint32_t slot, IsletContactInfo* out);

/// Returns null on an error: joints_full; same_body; no_dynamic_body; wrong_joint_type (gears); not_finite and out_of_range of a field, which find_fault
/// names (fault.hpp).
ISLET_C_API IsletJointId islet_create_revolute_joint(IsletWorld* world, const IsletRevoluteJointDef* def);
ISLET_C_API IsletJointId islet_create_prismatic_joint(IsletWorld* world, const IsletPrismaticJointDef* def);
ISLET_C_API IsletJointId islet_create_distance_joint(IsletWorld* world, const IsletDistanceJointDef* def);
ISLET_C_API IsletJointId islet_create_weld_joint(IsletWorld* world, const IsletWeldJointDef* def);
ISLET_C_API IsletJointId islet_create_wheel_joint(IsletWorld* world, const IsletWheelJointDef* def);
ISLET_C_API IsletJointId islet_create_motor_joint(IsletWorld* world, const IsletMotorJointDef* def);
ISLET_C_API IsletJointId islet_create_mouse_joint(IsletWorld* world, const IsletMouseJointDef* def);
ISLET_C_API IsletJointId islet_create_pulley_joint(IsletWorld* world, const IsletPulleyJointDef* def);
ISLET_C_API IsletJointId islet_create_gear_joint(IsletWorld* world, const IsletGearJointDef* def);
ISLET_C_API IsletJointId islet_create_angle_joint(IsletWorld* world, const IsletAngleJointDef* def);

/// Destroys the joint, and the gears that use it.
ISLET_C_API IsletError islet_destroy_joint(IsletWorld* world, IsletJointId joint);
ISLET_C_API bool islet_joint_is_valid(const IsletWorld* world, IsletJointId joint);
ISLET_C_API uint32_t islet_world_joint_count(const IsletWorld* world);

/// Id of the joint in slot 0 <= slot < capacity().joints; null if the slot is free.
ISLET_C_API IsletJointId islet_world_joint_at(const IsletWorld* world, uint32_t slot);

/// Writes the ids of the body's joints, newest first, as far as they fit; returns how many there are.
ISLET_C_API uint32_t islet_body_joints(const IsletWorld* world, IsletBodyId body, IsletJointId* out, size_t out_count);

/// The next one in this order, the first one after null. Returns null after the last one, and on an error: out_of_range if `joint` does not hang on the body.
ISLET_C_API IsletJointId islet_body_next_joint(const IsletWorld* world, IsletBodyId body, IsletJointId joint);

/// Which kind of joint it is.
ISLET_C_API IsletJointType islet_joint_type(const IsletWorld* world, IsletJointId joint);

/// Null for mouse joints.
ISLET_C_API IsletBodyId islet_joint_body_a(const IsletWorld* world, IsletJointId joint);
ISLET_C_API IsletBodyId islet_joint_body_b(const IsletWorld* world, IsletJointId joint);
ISLET_C_API IsletJointFrame islet_joint_frame_a(const IsletWorld* world, IsletJointId joint);
ISLET_C_API IsletJointFrame islet_joint_frame_b(const IsletWorld* world, IsletJointId joint);

/// Moves the joint on its bodies. Not for mouse, pulley and gear joints.
ISLET_C_API IsletError islet_joint_set_frames(IsletWorld* world, IsletJointId joint, const IsletJointFrame* frame_a, const IsletJointFrame* frame_b);

/// m: the frames' points in the world; of a mouse joint the target and the point pulled to it.
ISLET_C_API IsletVec2 islet_joint_anchor_a(const IsletWorld* world, IsletJointId joint);
ISLET_C_API IsletVec2 islet_joint_anchor_b(const IsletWorld* world, IsletJointId joint);
ISLET_C_API bool islet_joint_collide_connected(const IsletWorld* world, IsletJointId joint);

/// Not for mouse and gear joints, which forbid nothing.
ISLET_C_API IsletError islet_joint_set_collide_connected(IsletWorld* world, IsletJointId joint, bool collide);

/// As in JointBase, N and N m; 0: never breaks. A gear has a torque only.
ISLET_C_API float islet_joint_break_force(const IsletWorld* world, IsletJointId joint);
ISLET_C_API float islet_joint_break_torque(const IsletWorld* world, IsletJointId joint);
ISLET_C_API IsletError islet_joint_set_break(IsletWorld* world, IsletJointId joint, float force, float torque);

/// The number of yours that the joint was made with.
ISLET_C_API uint64_t islet_joint_user_data(const IsletWorld* world, IsletJointId joint);
ISLET_C_API IsletError islet_joint_set_user_data(IsletWorld* world, IsletJointId joint, uint64_t data);

/// The coordinate (joints.hpp): rad of revolute and angle joints, continuous past a full turn; m of the others that have one.
ISLET_C_API float islet_joint_position(const IsletWorld* world, IsletJointId joint);

/// Its rate, rad/s or m/s; of a wheel joint the strut's.
ISLET_C_API float islet_joint_speed(const IsletWorld* world, IsletJointId joint);

/// Revolute, prismatic, distance, wheel and angle joints.
ISLET_C_API IsletJointSpring islet_joint_spring(const IsletWorld* world, IsletJointId joint);
ISLET_C_API IsletError islet_joint_set_spring(IsletWorld* world, IsletJointId joint, const IsletJointSpring* spring);
ISLET_C_API IsletJointLimit islet_joint_limit(const IsletWorld* world, IsletJointId joint);
ISLET_C_API IsletError islet_joint_set_limit(IsletWorld* world, IsletJointId joint, const IsletJointLimit* limit);
ISLET_C_API IsletJointMotor islet_joint_motor(const IsletWorld* world, IsletJointId joint);
ISLET_C_API IsletError islet_joint_set_motor(IsletWorld* world, IsletJointId joint, const IsletJointMotor* motor);

/// Revolute, prismatic, wheel and angle joints. N m or N.
ISLET_C_API float islet_joint_friction(const IsletWorld* world, IsletJointId joint);
ISLET_C_API IsletError islet_joint_set_friction(IsletWorld* world, IsletJointId joint, float friction);

/// Force (N) or torque (N m) of the motor over the last substep.
ISLET_C_API float islet_joint_motor_force(const IsletWorld* world, IsletJointId joint);

/// Of an angle joint. Setting it forgets the tooth that held. The next one to hold is the last tooth that the angle has passed.
ISLET_C_API IsletJointRatchet islet_joint_ratchet(const IsletWorld* world, IsletJointId joint);
ISLET_C_API IsletError islet_joint_set_ratchet(IsletWorld* world, IsletJointId joint, const IsletJointRatchet* ratchet);

/// Of a distance joint, m.
ISLET_C_API float islet_joint_length(const IsletWorld* world, IsletJointId joint);
ISLET_C_API IsletError islet_joint_set_length(IsletWorld* world, IsletJointId joint, float length);

/// Of weld, motor and mouse joints.
ISLET_C_API IsletJointSoftness islet_joint_softness(const IsletWorld* world, IsletJointId joint);
ISLET_C_API IsletError islet_joint_set_softness(IsletWorld* world, IsletJointId joint, const IsletJointSoftness* softness);

/// Of a motor joint, m/s and rad/s.
ISLET_C_API IsletVec2 islet_joint_linear_velocity(const IsletWorld* world, IsletJointId joint);
ISLET_C_API float islet_joint_angular_velocity(const IsletWorld* world, IsletJointId joint);
ISLET_C_API IsletError islet_joint_set_velocity(IsletWorld* world, IsletJointId joint, IsletVec2 linear, float angular);

/// Of motor and mouse joints, N and N m. A mouse joint has a force only.
ISLET_C_API float islet_joint_max_force(const IsletWorld* world, IsletJointId joint);
ISLET_C_API float islet_joint_max_torque(const IsletWorld* world, IsletJointId joint);
ISLET_C_API IsletError islet_joint_set_strength(IsletWorld* world, IsletJointId joint, float max_force, float max_torque);

/// Of a mouse joint, m in the world.
ISLET_C_API IsletVec2 islet_joint_target(const IsletWorld* world, IsletJointId joint);
ISLET_C_API IsletError islet_joint_set_target(IsletWorld* world, IsletJointId joint, IsletVec2 target);

/// The fixed points of a pulley, m in the world. Setting them measures the rope anew, so it fits the bodies' places now.
ISLET_C_API IsletVec2 islet_joint_ground_a(const IsletWorld* world, IsletJointId joint);
ISLET_C_API IsletVec2 islet_joint_ground_b(const IsletWorld* world, IsletJointId joint);
ISLET_C_API IsletError islet_joint_set_grounds(IsletWorld* world, IsletJointId joint, IsletVec2 ground_a, IsletVec2 ground_b);

/// Of a pulley or a gear, in the range of its definition. Setting it measures the rope, or the gear's angle, anew.
ISLET_C_API float islet_joint_ratio(const IsletWorld* world, IsletJointId joint);
ISLET_C_API IsletError islet_joint_set_ratio(IsletWorld* world, IsletJointId joint, float ratio);

/// The two joints of a gear.
ISLET_C_API IsletJointId islet_gear_joint1(const IsletWorld* world, IsletJointId gear);
ISLET_C_API IsletJointId islet_gear_joint2(const IsletWorld* world, IsletJointId gear);

/// What the joint did to body B over the last substep: force in N, torque about B's anchor in N m. A gets the opposite (a pulley's A is pulled along its own
/// rope). A gear has no force, and its torque is that on body B of joint 1 (N along the axis if joint 1 is prismatic); body B of joint 2 gets ratio times as
/// much.
ISLET_C_API IsletVec2 islet_joint_force(const IsletWorld* world, IsletJointId joint);
ISLET_C_API float islet_joint_torque(const IsletWorld* world, IsletJointId joint);

/// How far apart the joint has been pulled now.
ISLET_C_API IsletJointError islet_joint_error(const IsletWorld* world, IsletJointId joint);

/// The first shape that a ray from `origin` to `origin + translation` (m) meets. A ray that starts inside a shape meets it at fraction 0 (islet_cast_ray).
/// filter may be null.
ISLET_C_API IsletQueryHit islet_world_cast_ray(const IsletWorld* world, IsletVec2 origin, IsletVec2 translation, const IsletQueryFilter* filter);

/// Whether the ray (m) meets any shape. Faster than the first shape where many are in the way. filter may be null.
ISLET_C_API bool islet_world_cast_ray_any(const IsletWorld* world, IsletVec2 origin, IsletVec2 translation, const IsletQueryFilter* filter);

/// Writes the hits of the ray, as far as they fit, first ones first; returns how many there are. filter may be null.
ISLET_C_API uint32_t islet_world_cast_ray_all(const IsletWorld* world, IsletVec2 origin, IsletVec2 translation, IsletQueryHit* out, size_t out_count,
    const IsletQueryFilter* filter);

/// Calls `visit`, unless null, for each hit of the ray (m) until `visit` stops the cast (CastVisitor). filter may be null.
ISLET_C_API void islet_world_cast_ray_each(const IsletWorld* world, IsletVec2 origin, IsletVec2 translation, const IsletQueryFilter* filter,
    IsletCastVisitor visit, void* context);

/// The same for a shape that starts where its proxy stands in the world, and moves by `translation` (m) without turning (islet_cast_shape). filter may be
/// null.
ISLET_C_API IsletQueryHit islet_world_cast_shape(const IsletWorld* world, const IsletShapeProxy* shape, IsletVec2 translation,
    const IsletQueryFilter* filter);
/// filter may be null.
ISLET_C_API bool islet_world_cast_shape_any(const IsletWorld* world, const IsletShapeProxy* shape, IsletVec2 translation, const IsletQueryFilter* filter);
/// filter may be null.
ISLET_C_API uint32_t islet_world_cast_shape_all(const IsletWorld* world, const IsletShapeProxy* shape, IsletVec2 translation, IsletQueryHit* out,
    size_t out_count, const IsletQueryFilter* filter);
/// filter may be null.
ISLET_C_API void islet_world_cast_shape_each(const IsletWorld* world, const IsletShapeProxy* shape, IsletVec2 translation, const IsletQueryFilter* filter,
    IsletCastVisitor visit, void* context);

/// Writes the shapes whose tight box (aabb) overlaps `box`, as far as they fit; returns how many there are. bad_geometry unless lower <= upper. filter may be
/// null.
ISLET_C_API uint32_t islet_world_overlap_box(const IsletWorld* world, IsletAabb box, IsletShapeId* out, size_t out_count, const IsletQueryFilter* filter);

/// The same for shapes that share a point with `shape`, which stands in the world. filter may be null.
ISLET_C_API uint32_t islet_world_overlap_shape(const IsletWorld* world, const IsletShapeProxy* shape, IsletShapeId* out, size_t out_count,
    const IsletQueryFilter* filter);

/// The same for shapes that contain the point (m); segments contain none. filter may be null.
ISLET_C_API uint32_t islet_world_overlap_point(const IsletWorld* world, IsletVec2 point, IsletShapeId* out, size_t out_count, const IsletQueryFilter* filter);

/// Call `visit`, unless null, for each such shape until it returns false. Boxes, shapes and points in m. filter may be null.
ISLET_C_API void islet_world_overlap_box_each(const IsletWorld* world, IsletAabb box, const IsletQueryFilter* filter, IsletOverlapVisitor visit,
    void* context);
/// filter may be null.
ISLET_C_API void islet_world_overlap_shape_each(const IsletWorld* world, const IsletShapeProxy* shape, const IsletQueryFilter* filter,
    IsletOverlapVisitor visit, void* context);
/// filter may be null.
ISLET_C_API void islet_world_overlap_point_each(const IsletWorld* world, IsletVec2 point, const IsletQueryFilter* filter, IsletOverlapVisitor visit,
    void* context);

/// The shape closest to `point`, no farther than max_distance (m, 0 to max_translation). Of equally close ones it is the one in the lowest slot. filter may
/// be null.
ISLET_C_API IsletClosestHit islet_world_closest(const IsletWorld* world, IsletVec2 point, float max_distance, const IsletQueryFilter* filter);

/// Writes the surfaces no farther than `within` (m, 0 to max_translation) from a shape in the world, as far as they fit, and returns how many there are. The
/// closest come first, beginning with the deepest overlap; equally close ones come in the order of their slots. A chain segment has a surface only on its
/// outer side. It is left out if the shape is on its inner side, by the mean of the shape's corners or by the direction to the shape's closest point. filter
/// may be null.
ISLET_C_API uint32_t islet_world_surfaces_near(const IsletWorld* world, const IsletShapeProxy* shape, float within, IsletSurface* out, size_t out_count,
    const IsletQueryFilter* filter);

/// Draws the parts of the world that `draw` asks for with draw's functions. On an error it calls none of them: not_finite or out_of_range of draw's view,
/// size or scale; in_step. No other drawing of the world may run at the same time. ISLET_BODY_COLORS_ISLAND uses the world's scratch memory: with it, no
/// other call to the world may run at the same time.
ISLET_C_API void islet_world_draw(const IsletWorld* world, const IsletDebugDraw* draw);

/// Draws one shape with draw's functions, as if its body were at `pose`. The other settings of `draw` have no effect.
ISLET_C_API void islet_world_draw_shape(const IsletWorld* world, const IsletDebugDraw* draw, IsletShapeId shape, IsletTransform pose,
    const IsletDrawStyle* style);

/// Columns that these senses fill; 0 for a sense of an unknown kind.
ISLET_C_API uint32_t islet_sense_columns(const IsletSense* senses, size_t senses_count);

/// Tells the kind and format of a snapshot, a delta or a recording from its first bytes, whatever version wrote it: 8 bytes are enough for the first two, 64
/// for a recording. Takes any bytes, at any alignment, and has no errors.
ISLET_C_API IsletError islet_read_format(const void* bytes, size_t bytes_bytes, IsletFormatInfo* out);

/// Writes a sentence that names the kind, its format, and the version and format that would read it, such as "This is a snapshot of format 3; Islet 0.2.0
/// reads format 4." `out` gets as much as there is room for, with a zero at its end. Returns the length of the whole sentence without the zero, at most 120.
ISLET_C_API size_t islet_describe_format(const IsletFormatInfo* info, char* out, size_t out_bytes);

/// Moves the mover by dt seconds, min_time_step <= dt <= 1. Call it once after each step of the world, with the same dt. It changes the world only by the
/// mover's weight (a force over the next step) and inertia (an impulse no larger than that force gives in a step) on the dynamic body that carries it, and by
/// its push (an impulse on the centre of mass) on others. The weight is at most 10 times the body's own, and what gives the place below the feet, if nothing
/// else holds the body, 25 times the acceleration of gravity: so a body of a tenth of `mass` bears all of it near its middle, and one of a sixth anywhere on
/// a plank. A mover leaves what overlaps it with 3 m/s besides that one's own speed. On an error it returns false and changes nothing; the world records the
/// error: feature_cut if this build leaves out the mover or queries (islet/config.hpp); in_step; bad_geometry of the capsule; bad_time_step; not_finite;
/// out_of_range (a number outside the ranges above; `up` not unit; a position, or an end of the capsule there, beyond max_position; a speed beyond
/// max_speed_limit).
ISLET_C_API bool islet_step_mover(IsletWorld* world, const IsletMoverDef* def, IsletMoverState* state, const IsletMoverInput* input, float dt);

/// Puts the world into the recording's first state and makes its calls again, up to and including `steps` steps. The world's capacity should be
/// IsletRecordingInfo.needed, or the recorded one. A recording may be hostile: nothing of it is used unchecked. After each step, a sum shows whether the
/// calls before it were the recorded ones.
ISLET_C_API IsletError islet_replay(IsletWorld* world, const void* recording, size_t recording_bytes, uint64_t steps, IsletReplayResult* out);

/// The most bytes that a snapshot of a world of this capacity can need. islet_world_snapshot_bytes says how many it needs now.
ISLET_C_API size_t islet_max_snapshot_bytes(const IsletCapacity* capacity);

/// The most bytes that delta() can need to lead to an image of this size, whatever image it starts from.
ISLET_C_API size_t islet_max_delta_bytes(size_t to_bytes);

/// Packs what changed between two images, for sending or for long histories: apply(from, delta) gives `to` again. Returns the bytes written to `out`, or 0
/// with *error set, if given: the errors of read_snapshot for either image; image_too_small if `out` is too small. `out` must not overlap the images.
ISLET_C_API size_t islet_delta(const void* from, size_t from_bytes, const void* to, size_t to_bytes, void* out, size_t out_bytes, IsletError* error);

/// Writes to `out` the image to which `delta` leads from the image `from`. Returns the bytes written, or 0 with *error set, if given: the errors of
/// read_snapshot, for the image and in the same sense for the delta; corrupt_image also if the delta is hostile; wrong_delta if it starts from another image
/// than `from`; image_too_small if `out` is too small. After an error `out` holds nothing of use. The result can be trusted no more than the delta: use
/// islet_world_load for it, unless this program made both. `out` must not overlap `from` or `delta`.
ISLET_C_API size_t islet_apply(const void* from, size_t from_bytes, const void* delta, size_t delta_bytes, void* out, size_t out_bytes, IsletError* error);

#ifdef __cplusplus
}
#endif

#endif
