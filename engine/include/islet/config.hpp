// What a build of the engine has in it. All of this is for those who compile the engine (in CMake: ISLET_WITHOUT, a list of names); a program that uses
// it need not know.
//
// First of all, what a program does not call it need not link: the engine's functions stand in sections of their own, for -Wl,--gc-sections, and
// joints and chains as a whole come only with the functions that make them. The switches below leave out what a program that does call these, or
// steps at all, would still link and never use. docs/microcontrollers.md says what each saves.
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

/// 1: sensors, hit events, hooks, one-way shapes, disabled bodies, bullets, and sweeps that go contact by contact (SolverDef::sweep_order, block_contacts,
/// shock) come only with the functions of World that are theirs, as joints and chains always do: a firmware that never calls these does not link them, and is
/// refused what would need them (feature_cut). 0: they are there.
#if !defined(ISLET_LEAN)
#define ISLET_LEAN 0
#endif

/// 1: there, 0: left out.
#if !defined(ISLET_POLYGONS)
#define ISLET_POLYGONS 1  // boxes and other convex polygons
#endif
#if !defined(ISLET_CAPSULES)
#define ISLET_CAPSULES 1  // capsules
#endif
#if !defined(ISLET_SEGMENTS)
#define ISLET_SEGMENTS 1  // segments
#endif
#if !defined(ISLET_CHAINS)
#define ISLET_CHAINS 1  // chains and their segments
#endif
#if !defined(ISLET_RESTITUTION)
#define ISLET_RESTITUTION 1  // bouncing
#endif
#if !defined(ISLET_SURFACES)
#define ISLET_SURFACES 1  // rolling resistance and surfaces in motion
#endif
#if !defined(ISLET_SLEEP)
#define ISLET_SLEEP 1  // islands falling asleep: without it a world is as after enable_sleep(false)
#endif
#if !defined(ISLET_PROFILE)
#define ISLET_PROFILE 1  // what the stages of a step took, where a program asks for it
#endif
#if !defined(ISLET_CONTINUOUS)
#define ISLET_CONTINUOUS 1  // fast bodies swept along their way: without it a world is as after enable_continuous(false)
#endif
#if !defined(ISLET_SENSORS)
#define ISLET_SENSORS 1  // sensors
#endif
#if !defined(ISLET_HITS)
#define ISLET_HITS 1  // hit events
#endif
#if !defined(ISLET_HOOKS)
#define ISLET_HOOKS 1  // the user's filter, pre-solve and mixing
#endif
#if !defined(ISLET_ONE_WAY)
#define ISLET_ONE_WAY 1  // platforms that are passed from one side (ShapeDef::one_way)
#endif
#if !defined(ISLET_QUERIES)
#define ISLET_QUERIES 1  // ray and shape casts, overlaps, closest points in a world
#endif
#if !defined(ISLET_MOVER)
#define ISLET_MOVER ISLET_QUERIES  // step_mover, which needs queries
#endif
#if !defined(ISLET_RECORDER)
#define ISLET_RECORDER 1  // World::start_recording
#endif
#if !defined(ISLET_TUNING)
#define ISLET_TUNING 1  // of the solver: sweep orders, block contacts, shock propagation, residuals and the tolerance
#endif

/// Joints of each type; ISLET_JOINTS is the default of all.
#if !defined(ISLET_JOINTS)
#define ISLET_JOINTS 1
#endif
#if !defined(ISLET_REVOLUTE_JOINTS)
#define ISLET_REVOLUTE_JOINTS ISLET_JOINTS
#endif
#if !defined(ISLET_PRISMATIC_JOINTS)
#define ISLET_PRISMATIC_JOINTS ISLET_JOINTS
#endif
#if !defined(ISLET_DISTANCE_JOINTS)
#define ISLET_DISTANCE_JOINTS ISLET_JOINTS
#endif
#if !defined(ISLET_WELD_JOINTS)
#define ISLET_WELD_JOINTS ISLET_JOINTS
#endif
#if !defined(ISLET_WHEEL_JOINTS)
#define ISLET_WHEEL_JOINTS ISLET_JOINTS
#endif
#if !defined(ISLET_MOTOR_JOINTS)
#define ISLET_MOTOR_JOINTS ISLET_JOINTS
#endif
#if !defined(ISLET_MOUSE_JOINTS)
#define ISLET_MOUSE_JOINTS ISLET_JOINTS
#endif
#if !defined(ISLET_PULLEY_JOINTS)
#define ISLET_PULLEY_JOINTS ISLET_JOINTS
#endif
#if !defined(ISLET_GEAR_JOINTS)
#define ISLET_GEAR_JOINTS ISLET_JOINTS
#endif

/// The types of shapes, a line each, in the order of their ranks (a contact calls the shape of the higher rank A): SHAPE(name, struct, the feature it is, its
/// kind (src/shapes/shape_types.hpp), always or when_made: whether a program that makes none links what it collides by).
#define ISLET_SHAPE_TYPES(SHAPE)                     \
    SHAPE(circle, Circle, engine, solid, always)     \
    SHAPE(capsule, Capsule, capsules, solid, always) \
    SHAPE(polygon, Polygon, polygons, solid, always) \
    SHAPE(segment, Segment, segments, line, always)  \
    SHAPE(chain_segment, ChainSegment, chains, front, when_made)
