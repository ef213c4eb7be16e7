// What a build of the engine contains. Read this file only if you compile the engine and want to leave parts out.
//
// The linker leaves out functions that a program does not call: each function has a section of its own, for -Wl,--gc-sections. Joints and chains are linked
// only with the functions that make them. The linker cannot know which fields of a definition a program sets, so it keeps the features behind these fields. To
// leave out such a feature, name it: list names from below in the CMake option ISLET_WITHOUT, or compile the engine's files with -DISLET_WITHOUT_<name>.
// docs/microcontrollers.md says how much flash each name saves.
//
// Leaving features out by name does not change the layout, the hash or the snapshots of a world; the small profile (ISLET_SMALL) changes the layout alone.
// Calls that need a missing feature fail with Error::feature_cut.
#pragma once

/// The most SIMD lanes that the constraint kernels are compiled for: 1, 4, 8 or 16. The default is the width of the vectors that every processor of the target
/// has, or 1 if there are none. On x86-64 the default is 16: a world has 16 lanes only if the processor has AVX-512, and 8 only if it has AVX2. It is 8 for
/// Windows, where GCC aligns no stack for AVX-512; but 4 in Clang's Microsoft mode, whose headers have no AVX2 for single functions. It is 1 for
/// Microsoft's compiler, which has no vectors that it can add and compare. The number does not change results.
#if !defined(ISLET_MAX_LANES)
#if defined(__x86_64__) && !defined(_WIN32)
#define ISLET_MAX_LANES 16
#elif defined(__x86_64__) && !defined(_MSC_VER)
#define ISLET_MAX_LANES 8
#elif defined(_MSC_VER) && !defined(__clang__)
#define ISLET_MAX_LANES 1
#elif defined(__x86_64__) || defined(_M_X64) || defined(__i386__) || defined(_M_IX86) || (defined(__aarch64__) && defined(__ARM_NEON)) || \
    defined(__wasm_simd128__)
// (On 32-bit x86 the engine is compiled for SSE2 whatever the user's flags are. The vectors of 32-bit ARM flush small numbers to zero.)
#define ISLET_MAX_LANES 4
#else
#define ISLET_MAX_LANES 1
#endif
#endif

/// The fewest lanes that constraints with a colour are solved in, where the engine has as many: 1 or 4. Default 1. A world that wants fewer gets the most that
/// there are. 4 makes the engine smaller, and does not change results.
#if !defined(ISLET_MIN_LANES)
#define ISLET_MIN_LANES 1
#endif

/// 0: the engine also runs on floats that take numbers below 1.2e-38 for zero, as those in the RP2040's ROM do. Results are then only nearly always those of
/// other machines. Default 1: a world on such floats takes no step (Error::inexact_build).
#if !defined(ISLET_SUBNORMALS)
#define ISLET_SUBNORMALS 1
#endif

/// 1: the small profile, for boards with 64 kB of flash and 16 to 20 kB of memory: boxes and other polygons, balls, restitution and queries. It leaves out all
/// else (the features marked `full` below, and all joints), but for what ISLET_WITH_<name> puts back. The engine and the program must both be compiled with it:
/// a world takes less memory, and a program with a StaticWorld does not link otherwise. (In CMake, ISLET_PROFILE=small and the list ISLET_WITH.)
#if !defined(ISLET_SMALL)
#define ISLET_SMALL 0
#endif

/// The features that can be left out, one per line: FEATURE(name, the feature that it needs, the smallest profile that has it; `hinges` is the small one with
/// revolute joints). This list is the only one: the CMake options, the constants in src/data/features.hpp and `tools/footprint.sh --options` come from it.
#define ISLET_FEATURES(FEATURE)                                                                                                                 \
    FEATURE(polygons, engine, small)       /* boxes and other convex polygons */                                                                \
    FEATURE(hulls, polygons, full)         /* convex polygons but for boxes, as make_box and its like make them */                              \
    FEATURE(capsules, engine, full)        /* capsules */                                                                                       \
    FEATURE(segments, engine, full)        /* segments */                                                                                       \
    FEATURE(half_spaces, engine, full)     /* half-spaces */                                                                                    \
    FEATURE(chains, engine, full)          /* chains and their segments */                                                                      \
    FEATURE(restitution, engine, small)    /* bouncing */                                                                                       \
    FEATURE(surfaces, engine, full)        /* rolling resistance and surfaces in motion */                                                      \
    FEATURE(sleep, engine, full)           /* sleeping islands; without: as after enable_sleep(false) */                                        \
    FEATURE(continuous, engine, full)      /* continuous collision; without: as after enable_continuous(false) */                               \
    FEATURE(bullets, continuous, full)     /* bullets (BodyDef::bullet) */                                                                      \
    FEATURE(seamless_floors, engine, full) /* floors of many pieces; without: as after enable_seamless_floors(false) */                         \
    FEATURE(sensors, engine, full)         /* sensors */                                                                                        \
    FEATURE(hits, engine, full)            /* hit events */                                                                                     \
    FEATURE(hooks, engine, full)           /* the user's filter, pre-solve and mixing */                                                        \
    FEATURE(one_way, engine, full)         /* platforms that are passed from one side (ShapeDef::one_way) */                                    \
    FEATURE(disabling, engine, full)       /* disabled bodies (BodyDef::enabled, World::set_enabled) */                                         \
    FEATURE(queries, engine, small)        /* ray and shape casts, overlaps, closest points in a world */                                       \
    FEATURE(mover, queries, full)          /* step_mover */                                                                                     \
    FEATURE(recorder, engine, full)        /* World::start_recording */                                                                         \
    FEATURE(tuning, engine, full)          /* of the solver: sweep orders, block contacts, shock propagation, residuals and the tolerance */    \
    FEATURE(exact_angles, engine, hinges)  /* heavily loaded hinges with limits, motors and friction are solved exactly, too; without: swept */ \
    FEATURE(profile, engine, full)         /* World::profile: how long the stages of a step took */                                             \
    FEATURE(shortcuts, engine, full)       /* faster paths for fast bodies: the bits stay the same, and nothing is refused without them */

/// The types of joints, one per line: JOINT(type, the name of its definition without JointDef). Each type is also a feature, <type>_joints, and "joints"
/// names all of them. src/constraint/<type>_joint.hpp describes each type.
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

/// The kernels that solve joints, one per line: KERNEL(name, rows, whether this build has a type of joint that the kernel solves).
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

/// The types of shapes, one per line, from the lowest rank to the highest. (In a contact, shape A has the higher rank.) SHAPE(name, struct, feature, kind
/// (src/shapes/shape_types.hpp), linking): `always` if every program links its collision code, `when_made` if only programs that make such shapes do.
#define ISLET_SHAPE_TYPES(SHAPE)                                 \
    SHAPE(circle, Circle, engine, solid, always)                 \
    SHAPE(capsule, Capsule, capsules, solid, always)             \
    SHAPE(polygon, Polygon, polygons, solid, always)             \
    SHAPE(segment, Segment, segments, line, always)              \
    SHAPE(chain_segment, ChainSegment, chains, front, when_made) \
    SHAPE(half_space, HalfSpace, half_spaces, endless, always)
