// What a build of the engine has in it. All of this is for those who compile the engine; a program that uses it need not know.
//
// What a program does not call is not linked: the engine's functions stand in sections of their own, for -Wl,--gc-sections, and joints and chains as a whole
// come only with the functions that make them. What a definition can ask for is there, called or not, unless it is left out by name: by ISLET_WITHOUT in
// CMake, a list of the names below, or by -DISLET_WITHOUT_<name> for the engine's files. docs/microcontrollers.md says what each name saves.
//
// A world has the same layout, hash and snapshots with and without them. What is left out is refused with Error::feature_cut.
#pragma once

/// The widest lanes that the constraint kernels are compiled for: 1, 4 or 8. Unless given, as wide as the target's baseline has vectors (on x86-64
/// eight too, used where the processor turns out to have AVX2), and 1 where it has none. The bits are the same.
#if !defined(ISLET_MAX_LANES)
#if defined(__x86_64__) || defined(_M_X64)
#define ISLET_MAX_LANES 8
#elif defined(__i386__) || defined(_M_IX86) || (defined(__aarch64__) && defined(__ARM_NEON)) || defined(__wasm_simd128__)
// (On 32-bit x86 the engine is compiled for SSE2 whatever the user's flags are. The vectors of 32-bit ARM flush small numbers to zero.)
#define ISLET_MAX_LANES 4
#else
#define ISLET_MAX_LANES 1
#endif
#endif

/// What can be left out, a line each: FEATURE(its name, what it is nothing without). This list is the only one: the CMake option, the constants in
/// src/data/features.hpp and `tools/footprint.sh --options` come from it.
#define ISLET_FEATURES(FEATURE)                                                                                                    \
    FEATURE(polygons, engine)    /* boxes and other convex polygons */                                                             \
    FEATURE(capsules, engine)    /* capsules */                                                                                    \
    FEATURE(segments, engine)    /* segments */                                                                                    \
    FEATURE(half_spaces, engine) /* half-spaces */                                                                                 \
    FEATURE(chains, engine)      /* chains and their segments */                                                                   \
    FEATURE(restitution, engine) /* bouncing */                                                                                    \
    FEATURE(surfaces, engine)    /* rolling resistance and surfaces in motion */                                                   \
    FEATURE(sleep, engine)       /* islands falling asleep; without: as after enable_sleep(false) */                               \
    FEATURE(continuous, engine)  /* fast bodies swept along their way; without: as after enable_continuous(false) */               \
    FEATURE(bullets, continuous) /* bodies swept against what moves (BodyDef::bullet) */                                           \
    FEATURE(sensors, engine)     /* sensors */                                                                                     \
    FEATURE(hits, engine)        /* hit events */                                                                                  \
    FEATURE(hooks, engine)       /* the user's filter, pre-solve and mixing */                                                     \
    FEATURE(one_way, engine)     /* platforms that are passed from one side (ShapeDef::one_way) */                                 \
    FEATURE(disabling, engine)   /* bodies that take part in nothing (BodyDef::enabled, World::set_enabled) */                     \
    FEATURE(queries, engine)     /* ray and shape casts, overlaps, closest points in a world */                                    \
    FEATURE(mover, queries)      /* step_mover */                                                                                  \
    FEATURE(recorder, engine)    /* World::start_recording */                                                                      \
    FEATURE(tuning, engine)      /* of the solver: sweep orders, block contacts, shock propagation, residuals and the tolerance */ \
    FEATURE(profile, engine)     /* what the stages of a step took, where a program asks for it */                                 \
    FEATURE(shortcuts, engine)   /* faster paths for fast bodies: the bits stay the same, and nothing is refused without them */

/// The types of joints, a line each: JOINT(type, its definition without JointDef). Each is a feature too, <type>_joints; the name "joints" stands for all
/// of them. What there is to know of a type stands in src/constraint/<type>_joint.hpp.
#define ISLET_JOINT_TYPES(JOINT) \
    JOINT(revolute, Revolute)    \
    JOINT(prismatic, Prismatic)  \
    JOINT(distance, Distance)    \
    JOINT(weld, Weld)            \
    JOINT(wheel, Wheel)          \
    JOINT(motor, Motor)          \
    JOINT(mouse, Mouse)          \
    JOINT(pulley, Pulley)        \
    JOINT(gear, Gear)            \
    JOINT(angle, Angle)

/// Which kernels solve them, a line each: KERNEL(name, its rows, the types it is for, as has_joint(type) of each).
#define ISLET_JOINT_KERNELS(KERNEL)                                                                                             \
    KERNEL(point, PointRows, has_joint(JointType::revolute))    /* revolute joints without spring, limit, motor and friction */ \
    KERNEL(hinge, HingeRows, has_joint(JointType::revolute))    /* other revolute joints */                                     \
    KERNEL(slider, SliderRows, has_joint(JointType::prismatic)) /* prismatic joints */                                          \
    KERNEL(distance, DistanceRows, has_joint(JointType::distance))                                                              \
    KERNEL(weld, WeldRows, has_joint(JointType::weld))                                                                          \
    KERNEL(wheel, WheelRows, has_joint(JointType::wheel))                                                                       \
    KERNEL(drive, DriveRows, has_joint(JointType::motor) || has_joint(JointType::mouse)) /* motor and mouse joints */           \
    KERNEL(angle, AngleRows, has_joint(JointType::angle))                                                                       \
    KERNEL(pulley, PulleyRows, has_joint(JointType::pulley))                                                                    \
    KERNEL(gear, LoneGearRows, has_joint(JointType::gear))

/// The types of shapes, a line each, in the order of their ranks (a contact calls the shape of the higher rank A): SHAPE(name, struct, the feature it is, its
/// kind (src/shapes/shape_types.hpp), always or when_made: whether a program that makes none links what it collides by).
#define ISLET_SHAPE_TYPES(SHAPE)                                 \
    SHAPE(circle, Circle, engine, solid, always)                 \
    SHAPE(capsule, Capsule, capsules, solid, always)             \
    SHAPE(polygon, Polygon, polygons, solid, always)             \
    SHAPE(segment, Segment, segments, line, always)              \
    SHAPE(chain_segment, ChainSegment, chains, front, when_made) \
    SHAPE(half_space, HalfSpace, half_spaces, endless, always)
