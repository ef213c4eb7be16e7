// Ids, definitions, errors, events and reports: everything that you pass to a World or read from it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "islet/geometry.hpp"
#include "islet/math.hpp"
#include "islet/span.hpp"
#include "islet/tasks.hpp"

ISLET_API_BEGIN
namespace islet {

/// No position may exceed this on either axis, m: beyond it, neighbouring floats are a metre apart. Bodies that fly farther stop there.
inline constexpr float max_position = 1.0e7f;
/// The largest coefficient of friction or rolling resistance.
inline constexpr float max_coefficient = 1.0e9f;
/// The largest speed limit and surface speed, m/s.
inline constexpr float max_speed_limit = 1.0e6f;
/// The shortest time step, s. Rounding would lose most of what a shorter step adds to a speed or a position.
inline constexpr float min_time_step = 1.0e-6f;

/// The id of a body; null by default. Ids are safe to keep: when its body is destroyed, an id becomes stale, and it never refers to another body.
/// Ids compare by slot, then by generation; IdHash (hash.hpp) makes them keys of unordered containers.
struct BodyId {
    std::uint32_t index1 = 0;      // slot + 1; 0 is null
    std::uint32_t generation = 0;  // of the slot when the id was handed out
    ISLET_EQUAL_IF(BodyId, a.index1 == b.index1 && a.generation == b.generation)
    friend constexpr bool operator<(BodyId a, BodyId b) { return a.index1 != b.index1 ? a.index1 < b.index1 : a.generation < b.generation; }
    explicit constexpr operator bool() const { return index1 != 0; }
};

/// The id of a shape. The same rules hold as for BodyId.
struct ShapeId {
    std::uint32_t index1 = 0;
    std::uint32_t generation = 0;
    ISLET_EQUAL_IF(ShapeId, a.index1 == b.index1 && a.generation == b.generation)
    friend constexpr bool operator<(ShapeId a, ShapeId b) { return a.index1 != b.index1 ? a.index1 < b.index1 : a.generation < b.generation; }
    explicit constexpr operator bool() const { return index1 != 0; }
};

/// How many objects of each kind a world can hold. The capacity decides the size of the memory block (world_bytes) and nothing else.
struct Capacity {
    std::uint32_t bodies = 0;
    std::uint32_t shapes = 0;
    std::uint32_t contacts = 0;  ///< Pairs of shapes whose fat boxes overlap, touching or not: 3 to 5 a body in a dense pile, 7 if it is squeezed.
    std::uint32_t joints = 0;
    std::uint32_t geometries = 0;  ///< Different geometries (equal ones are stored once); 0 means as many as shapes.
    std::uint32_t hits = 0;        ///< Hit events in one step; 0 means an eighth of the contacts, at least 8.
    std::uint32_t events = 0;      ///< Touches that begin in one step, and as many that end, those of sensors included; 0 means as many as contacts, which are
                                   ///< always enough. More are dropped and counted (StepReport::dropped_events, Error::events_full).
    ISLET_EQUAL_IF(Capacity, a.bodies == b.bodies && a.shapes == b.shapes && a.contacts == b.contacts && a.joints == b.joints && a.geometries == b.geometries &&
                                 a.hits == b.hits && a.events == b.events)
};

/// What went wrong in a call. describe(e) returns a sentence that says what was wrong and how to fix it.
enum class Error : std::uint8_t {
    none,
    null_id,            ///< the id is null
    stale_id,           ///< the object was destroyed, or the id belongs to another world
    not_finite,         ///< an argument is NaN or infinite
    out_of_range,       ///< a number is outside the range its comment states
    bad_time_step,      ///< dt is not from min_time_step to 1 s
    bad_geometry,       ///< the geometry breaks its own rules
    bad_chain,          ///< fewer than 2 points (3 for a loop), or neighbours closer than 0.005 m
    bodies_full,        ///< raise Capacity::bodies
    shapes_full,        ///< raise Capacity::shapes
    contacts_full,      ///< raise Capacity::contacts, to 3 to 7 for each moving shape (the contact is retried every step)
    geometries_full,    ///< raise Capacity::geometries
    block_too_small,    ///< the memory given is smaller than world_bytes(capacity)
    block_misaligned,   ///< the memory given is not aligned to world_alignment
    bad_capacity,       ///< a capacity is zero where at least one is needed, or above max_capacity
    events_full,        ///< more contacts began or ended than there is room to report: raise Capacity::events
    joints_full,        ///< raise Capacity::joints
    same_body,          ///< a joint needs two different bodies
    no_dynamic_body,    ///< a joint needs at least one dynamic body, and so does an island
    wrong_joint_type,   ///< joints of this type have no such property, or cannot be geared
    image_too_small,    ///< the memory given for a snapshot or a delta is too small
    image_misaligned,   ///< the image is not aligned to snapshot_alignment
    not_an_image,       ///< the bytes are no snapshot (or no delta)
    other_byte_order,   ///< the image comes from a machine of the other byte order
    other_version,      ///< another version of Islet wrote the image or recording: see read_format
    truncated_image,    ///< the image is shorter or longer than it says
    corrupt_image,      ///< the image's bytes are not those that were saved
    unsound_image,      ///< the image's checksum is right, but what it holds is no world
    image_too_large,    ///< the world has less capacity than the image uses
    wrong_delta,        ///< the delta does not start from the image given
    feature_cut,        ///< this build of the engine lacks a part that the call needs (islet/config.hpp), or the program does not link it
    not_a_sensor,       ///< the shape is no sensor
    hits_full,          ///< raise Capacity::hits
    recording_full,     ///< the memory given for a recording is too small, or is used up: the recording ends before this call
    not_a_recording,    ///< the bytes are no recording, or the world is not being recorded
    corrupt_recording,  ///< the recording is not as it was made
    in_step,            ///< called from a function that the world itself calls, such as a hook or a drawing function, and not allowed there
    inexact_build,      ///< the engine was compiled with flags that change the results of floats: World::create returns null, and a StaticWorld does
                        ///< not step
    endless_shape,      ///< a dynamic body cannot have a half-space
};

/// A sentence that says what was wrong and how to fix it. Never null.
const char* describe(Error e);

/// Receives each error as it happens. The hook may read the world's bodies and shapes. Calls from the hook that would change the world are refused (in_step),
/// and the hook does not receive those errors.
using ErrorHook = void (*)(Error error, void* context);

struct PreSolve;  // below

/// Functions of yours that a step calls, to let you decide something. Each may be null and gets `context`. Hooks are not part of the state: hashes and
/// snapshots do not contain them. Worlds that are to have equal futures need hooks that give equal answers.
///
/// The world calls filter and pre_solve on the thread that steps, one after another, in an order that does not depend on the number of workers. They may read
/// the world's bodies and shapes, but not change the world (in_step). The world calls mix_friction and mix_restitution on any worker, as often as it likes, so
/// their answers must depend on their arguments alone.
struct Hooks {
    /// Returns whether two shapes may meet, or a sensor may see a shape. shape_a is the one in the lower slot. The world asks about pairs that their filters
    /// allow, when their fat boxes begin to overlap. After a no it asks again when it finds the pair again. After a yes it asks again only after the fat boxes
    /// have parted.
    bool (*filter)(ShapeId shape_a, ShapeId shape_b, void* context) = nullptr;
    /// Sees a contact before it is solved, and may change it for this step (PreSolve). Each step calls the hook for every awake contact that has points and a
    /// shape with ShapeDef::pre_solve, in the order of their slots. A fast body has a contact with each shape that it may hit during the step, and
    /// continuous collision obeys the hook's decision. If a one-way shape (ShapeDef::one_way) lets the other shape pass, the hook is not called.
    void (*pre_solve)(PreSolve& contact, void* context) = nullptr;
    /// Returns the friction coefficient of two shapes, in place of the geometric mean; `material` is SurfaceMaterial::id. The result is limited to 0 to
    /// max_coefficient. Called when the fat boxes of two shapes begin to overlap, and when a material changes.
    float (*mix_friction)(float friction_a, std::uint32_t material_a, float friction_b, std::uint32_t material_b, void* context) = nullptr;
    /// Returns the restitution of two shapes, in place of the larger of both. The result is limited to 0 to 1. Called in steps, too.
    float (*mix_restitution)(float restitution_a, std::uint32_t material_a, float restitution_b, std::uint32_t material_b, void* context) = nullptr;
    void* context = nullptr;
    ISLET_EQUAL_IF(Hooks, a.filter == b.filter && a.pre_solve == b.pre_solve && a.mix_friction == b.mix_friction && a.mix_restitution == b.mix_restitution &&
                              a.context == b.context)
};

/// Reads a clock of yours, which counts up in any unit you like. It must not call the world.
using Clock = std::uint64_t (*)(void* context);

/// What a step consists of. `soft` is the default; `classic` is one velocity solve per step, with position correction.
enum class Schedule : std::uint8_t {
    soft,     ///< substeps of: integrate, biased sweep with soft contacts, integrate positions, relax sweep
    classic,  ///< per substep: integrate, `iterations` sweeps with Baumgarte bias, integrate positions. Use with substeps = 1.
};

/// Which hinges (revolute joints) are solved exactly, all of a joint tree together, instead of one by one in sweeps. Hinges that close a loop of moving
/// bodies are always swept, and so are hinges with a spring.
enum class JointTrees : std::uint8_t {
    off,        ///< none
    automatic,  ///< those of trees in which a hinge carries at least SolverDef::joint_tree_load times the mass of one of its bodies, and no hinge must be
                ///< swept. A tree that static or kinematic bodies hold in several places is swept if one of its hinges can break. A tree with a limit, a
                ///< motor or friction is solved exactly only while one of these hinges bears more than 2500 m/s^2 times the mass of its lighter body
                ///< (or its limits bear a torque that gives that body 10 000 m/s^2 at its radius of gyration), and until it has borne less than a
                ///< quarter of that for 16 steps on end; held in several places, it is swept.
    all,        ///< all that can be. An angle that is beyond a limit of a hinge solved exactly, as set or swept there, returns by at most 0.25 rad/s.
};

/// The order in which a sweep visits contacts. (In every order, joints come before the contacts and joint trees after them.)
enum class SweepOrder : std::uint8_t {
    colored,   ///< by colours, as many at once as there are lanes: the fastest by far
    as_found,  ///< one by one, in the order of their slots
    upward,    ///< one by one, from the lowest to the highest against gravity: one sweep passes support up through all layers, but weight down by only
               ///< one layer
    downward,  ///< one by one, from the highest to the lowest
};

/// The largest SolverDef::shock. Above it, piles of loose bodies gain energy.
inline constexpr float max_shock = 0.5f;

/// How the solver works. Change it at any time with World::set_solver.
struct SolverDef {
    Schedule schedule = Schedule::soft;
    std::uint32_t substeps = 4;           ///< 1 to 64. More: stiffer stacks and joints, cost in proportion.
    std::uint32_t iterations = 1;         ///< 1 to 256 biased sweeps per substep.
    std::uint32_t relax_iterations = 1;   ///< 0 to 256 unbiased sweeps per substep (soft schedule).
    float contact_hertz = 30.0f;          ///< Hz, > 0. Stiffness of soft contacts; capped at an eighth of the substep rate.
    float contact_damping_ratio = 10.0f;  ///< >= 0. Soft contacts are overdamped so that they do not bounce.
    float contact_push_speed = 3.0f;      ///< m/s, >= 0. The fastest that overlapping shapes are pushed apart.
    float joint_hertz = 60.0f;            ///< Hz, > 0. Stiffness with which joints correct their errors; capped at a quarter of the substep rate,
                                          ///< and at a fifth where a body of the joint belongs to a joint tree that is solved exactly.
                                          ///< A rigid joint that is swept gives way by F / (m (2 pi joint_hertz)^2) under a steady force F, where m is the
                                          ///< mass that it moves. A limit does not give way to the joint's own motor. To any other steady load it first gives
                                          ///< way as much as a rigid joint does; 128 steps of 1/60 s later, about a third of that error is left. (A load
                                          ///< that would give the lighter body more than 100 m/s^2 is taken up more slowly, in inverse proportion.)
    float joint_damping_ratio = 2.0f;     ///< >= 0
    float baumgarte = 0.2f;               ///< 0 to 1. Share of overlaps and joint errors corrected per step (classic schedule).
    float omega = 1.0f;                   ///< 0 < omega < 2. Relaxation factor (SOR); 1 is plain PGS.
    bool warm_start = true;               ///< Start each step from the impulses of the last.
    JointTrees joint_trees = JointTrees::automatic;  ///< Which hinges are solved exactly instead of swept.
    float joint_tree_load = 1.0f;  ///< >= 1. With JointTrees::automatic, a tree is solved exactly if one of its hinges bears at least so many times
                                   ///< the mass of the lighter body that it joins. Lower values: more trees. (Not for masses above 1e18 kg, whose
                                   ///< squares overflow.)
    SweepOrder sweep_order = SweepOrder::colored;  ///< With block_contacts, colored stands for as_found.
    bool block_contacts = false;                   ///< Solve the two normal impulses of a contact together, exactly.
    float shock = 0;  ///< 0 to max_shock. Shock propagation: the solver treats each body as lighter, by this share, than the body it lies on. Use it
                      ///< for stacks at rest: impacts, and the forces that joints report, are those of the lighter bodies. (Contacts report the
                      ///< weight of what lies on them.) Do not use 0.5 with joints in the pile.
    bool measure_residual = false;  ///< Measure after each step how far the impulses are from a solution: World::residual.
    float tolerance = 0;            ///< m/s, >= 0. Above 0, a substep ends its biased sweeps, and then its relaxing sweeps, as soon as the residual is at
                                    ///< most this. The islands of one batch (StepReport::batches) end together. Each measurement costs two to three
                                    ///< sweeps.
    ISLET_EQUAL_IF(SolverDef, a.schedule == b.schedule && a.substeps == b.substeps && a.iterations == b.iterations &&
                                  a.relax_iterations == b.relax_iterations && a.contact_hertz == b.contact_hertz &&
                                  a.contact_damping_ratio == b.contact_damping_ratio && a.contact_push_speed == b.contact_push_speed &&
                                  a.joint_hertz == b.joint_hertz && a.joint_damping_ratio == b.joint_damping_ratio && a.baumgarte == b.baumgarte &&
                                  a.omega == b.omega && a.warm_start == b.warm_start && a.joint_trees == b.joint_trees &&
                                  a.joint_tree_load == b.joint_tree_load && a.sweep_order == b.sweep_order && a.block_contacts == b.block_contacts &&
                                  a.shock == b.shock && a.measure_residual == b.measure_residual && a.tolerance == b.tolerance)
};

/// What a new world is like.
struct WorldDef {
    Vec2 gravity = {0, -10};  ///< m/s^2
    SolverDef solver = {};
    bool enable_sleep = true;            ///< Let islands at rest fall asleep after 0.5 s.
    float restitution_threshold = 1.0f;  ///< m/s, >= 0. Slower impacts do not bounce.
    float max_speed = 400.0f;            ///< m/s, > 0, at most max_speed_limit. No body moves faster.
    float hit_threshold = 1.0f;          ///< m/s, >= 0. Hit events report shapes that come together faster.
    bool continuous = true;              ///< Continuous collision: however fast bodies move and turn, and however hard they are pressed, dynamic ones do not
                                         ///< pass through static shapes, and bullets pass through no other body. (Other bullets may still crowd a bullet
                                         ///< into a moving body.)
    bool seamless_floors = true;         ///< What slides over shapes that lie side by side does not catch at the edges between them: where one covers the
                                         ///< edge of the next, that makes no contact. (In chains, segments know their neighbours without this.)
    std::uint32_t lanes = 0;             ///< How many constraints are solved at once: at most 1, 4, 8 or 16; 0: as many as can be. The bits are the same.
    ErrorHook error_hook = nullptr;
    void* error_context = nullptr;
    Hooks hooks = {};       ///< See World::set_hooks.
    TaskSystem tasks = {};  ///< Threads to step with; none by default. The bits are the same.
    Clock clock = nullptr;  ///< Measures World::profile; none by default. The bits are the same.
    void* clock_context = nullptr;
};

enum class BodyType : std::uint8_t {
    static_body,  ///< Never moves, infinite mass.
    kinematic,    ///< Moves by its velocity only, infinite mass.
    dynamic,      ///< Moves by forces and contacts.
};

/// What a new body is like.
struct BodyDef {
    BodyType type = BodyType::static_body;
    Vec2 position = {};             ///< m, of the body's origin; within max_position
    float angle = 0;                ///< rad
    Vec2 linear_velocity = {};      ///< m/s, of the centre of mass
    float angular_velocity = 0;     ///< rad/s
    float linear_damping = 0;       ///< 1/s, >= 0
    float angular_damping = 0;      ///< 1/s, >= 0
    float gravity_scale = 1;        ///< multiple of the gravity that the body feels
    float sleep_threshold = 0.05f;  ///< m/s, >= 0. Slower bodies may fall asleep, unless a motor or a belt keeps them going.
    bool enable_sleep = true;       ///< false: the body keeps itself and its island awake.
    bool awake = true;              ///< false: the body starts asleep.
    bool fixed_rotation = false;    ///< true: the body has infinite rotational inertia, and starts with no angular velocity.
    bool lock_x = false;            ///< true: the centre of mass of a dynamic body does not move along the world's x axis, whatever pushes it. The lock
    bool lock_y = false;            ///< is solved like a contact, in every sweep. lock_y does the same along y.
    bool enabled = true;            ///< false: the body takes part in nothing (World::set_enabled).
    bool bullet = false;            ///< true: the body does not pass through moving bodies either (WorldDef::continuous). Use it for few bodies: each is
                                    ///< compared with every awake body.
    std::uint64_t user_data = 0;
};

/// Decides which shapes meet. Shapes of the same positive group always meet; those of the same negative group never do. Otherwise each mask must contain the
/// other shape's category.
struct Filter {
    std::uint32_t category = 1;
    std::uint32_t mask = 0xffffffffu;
    std::int32_t group = 0;
};

/// The material of a surface: four fields as in ShapeDef (ShapeDef::friction and so on, with their units), and a number of yours, which the mixing hooks get.
struct SurfaceMaterial {
    float friction = 0.6f;
    float restitution = 0;
    float rolling_resistance = 0;
    float tangent_speed = 0;
    std::uint32_t id = 0;
    ISLET_EQUAL_IF(SurfaceMaterial, a.friction == b.friction && a.restitution == b.restitution && a.rolling_resistance == b.rolling_resistance &&
                                        a.tangent_speed == b.tangent_speed && a.id == b.id)
};

/// What a new shape is like.
struct ShapeDef {
    float friction = 0.6f;         ///< Coulomb coefficient, 0 to max_coefficient. Two shapes have the geometric mean of both.
    float restitution = 0;         ///< 0 to 1. Two shapes have the larger of both.
    float rolling_resistance = 0;  ///< 0 to max_coefficient. Times the larger radius, it is the lever arm of the resisting torque. Two shapes have the larger.
    float tangent_speed = 0;       ///< m/s. A conveyor: it carries what lies on the surface to its right (clockwise around the shape). Two shapes add up.
    float density = 1;             ///< kg/m^2, >= 0
    Filter filter = {};
    bool sensor = false;         ///< The shape collides with nothing, and reports the shapes that overlap it. It sees shapes of all other bodies that its
                                 ///< filter allows and whose sensor_events is true. But a static sensor does not see static bodies, no sensor sees another
                                 ///< one, and a shape that passes all of it within one step is not seen. A sensor has mass, by its density.
    bool sensor_events = true;   ///< false: sensors do not see this shape. (In Box2D from version 3.1 on, the default is false.)
    bool hit_events = false;     ///< true: report hits of this shape (World::hit_events).
    bool pre_solve = false;      ///< true: call the pre_solve hook for contacts of this shape.
    Vec2 one_way = {};           ///< Not zero: the shape is a one-way platform. It holds only shapes that come from the side to which this direction
                                 ///< points, in the body's frame ({0, 1}: from above). The length does not matter; the angle is kept to 1/1000 rad.
                                 ///< Another shape passes until all of it is beyond the platform's farthest point along the direction. Then the platform
                                 ///< holds it until it leaves. The platform holds bodies, also fast ones, and movers; queries see it like any other shape.
                                 ///< A body on the platform drops through if the pre_solve hook disables the contact once (pre_solve of either shape), or
                                 ///< if a filter forbids the contact. Two one-way shapes collide only if each holds the other. The engine works out from
                                 ///< the velocities where two shapes were before they met, so a body may pass if you set its velocity in the very step in
                                 ///< which they meet. Errors: not_finite; feature_cut.
    std::uint32_t material = 0;  ///< SurfaceMaterial::id
    std::uint64_t user_data = 0;
};

/// Two shapes began or ceased to touch in the last step, or ceased because one was destroyed since. An id in an end event may be stale. Here and wherever two
/// shapes of a contact are named, shape_a has the later type in the order circle, capsule, polygon, segment, chain segment, half-space. If both types are
/// equal, shape_a is the shape in the lower slot.
struct TouchEvent {
    ShapeId shape_a = {};
    ShapeId shape_b = {};
};

/// A shape began or ceased to overlap a sensor, or ceased because one of them was destroyed, disabled or moved. An id in an end event may be stale.
struct SensorEvent {
    ShapeId sensor = {};
    ShapeId visitor = {};
};

/// Two shapes came together fast.
struct HitEvent {
    ShapeId shape_a = {};
    ShapeId shape_b = {};
    Vec2 point = {};   ///< m, midway between the surfaces, where they came together the fastest
    Vec2 normal = {};  ///< unit, from a to b
    float speed = 0;   ///< m/s, with which the surfaces came together along the normal, before they pushed each other
};

/// An explosion (World::explode).
struct ExplosionDef {
    Vec2 position = {};                ///< m
    float radius = 0;                  ///< m, >= 0. Shapes that are nearer feel all of it.
    float falloff = 0;                 ///< m, >= 0. Beyond the radius the impulse falls linearly to 0 over this distance.
    float impulse_per_length = 0;      ///< N s per metre of the shape's width as seen from there; below 0: an implosion
    std::uint32_t mask = 0xffffffffu;  ///< Shapes of these categories feel it.
};

/// Wind on a shape (World::apply_wind).
struct WindDef {
    Vec2 velocity = {};      ///< m/s, of the air; up to max_speed_limit
    float drag = 1;          ///< >= 0, coefficient of the force along the stream: 1.2 to 2 for a flat plate across it, about 1 for a disc
    float lift = 0;          ///< coefficient of the force across the stream
    float density = 1.225f;  ///< kg/m^3, >= 0, of a slice one metre deep: air
    bool wake = true;        ///< false: no effect on bodies that sleep, and bodies that rest may fall asleep in the wind
};

/// What the last step did.
struct StepReport {
    std::uint32_t bodies = 0;        ///< all, of every type
    std::uint32_t awake_bodies = 0;  ///< awake dynamic and kinematic ones after the step
    std::uint32_t shapes = 0;
    std::uint32_t contacts = 0;           ///< pairs with overlapping fat boxes, touching or not, asleep or not
    std::uint32_t touching_contacts = 0;  ///< awake contacts that touch
    std::uint32_t recycled_contacts = 0;  ///< awake contacts whose manifold was kept
    /// Pairs that found no room in this step, counted up to Capacity::contacts. Their shapes pass through each other. Each step tries them again, and fails
    /// with contacts_full while there is no room. Raise Capacity::contacts: 3 to 5 for each moving shape of a dense pile, 7 where the pile is squeezed.
    std::uint32_t dropped_contacts = 0;
    std::uint32_t dropped_events = 0;     ///< begin and end events that found no room since the last step began
    std::uint32_t dropped_hits = 0;       ///< hits that found no room among the hit events
    std::uint32_t islands = 0;            ///< awake islands
    std::uint32_t colors = 0;             ///< constraint colours in use
    std::uint32_t overflow_contacts = 0;  ///< contacts solved one by one: those without a colour, or all if the SweepOrder is not colored
    std::uint32_t batches = 0;
    std::uint32_t joints = 0;           ///< all
    std::uint32_t awake_joints = 0;     ///< those solved
    std::uint32_t overflow_joints = 0;  ///< joints solved one by one: gears, and those without a colour
    std::uint32_t sweeps = 0;           ///< of the batch with the most sweeps; fewer than SolverDef asks for if the tolerance ended them
    float residual = 0;                 ///< m/s, the largest of all islands (World::residual); 0 if not measured
};

/// How long the stages of the last step took, in ticks of WorldDef::clock; all 0 without a clock.
struct StepProfile {
    std::uint64_t pairs = 0;    ///< which fat boxes overlap
    std::uint64_t collide = 0;  ///< where and how shapes touch
    std::uint64_t islands = 0;  ///< which constraints are solved together, and in which order
    std::uint64_t solve = 0;    ///< forces, impulses and motion
    std::uint64_t finish = 0;   ///< poses, boxes, sleep and events
    std::uint64_t total = 0;    ///< the whole step: the sum of these
};

/// The number of constraint colours.
inline constexpr std::uint32_t constraint_color_count = 32;

/// Figures of a world for displays, beside those of StepReport. World::counters counts them when you call it.
struct WorldCounters {
    std::size_t bytes = 0;                              ///< of the world's block: world_bytes(capacity)
    std::size_t snapshot_bytes = 0;                     ///< bytes that save() needs now
    std::uint32_t geometries = 0;                       ///< different ones
    std::uint32_t tree_shapes = 0;                      ///< shapes at rest, in the tree of boxes; the others are sorted
    std::uint32_t tree_height = 0;                      ///< boxes on the way from the tree's root to its farthest leaf; 0 if it is empty
    std::uint32_t colors[constraint_color_count] = {};  ///< touching contacts and joints by constraint colour, awake or not
    std::uint32_t uncolored = 0;                        ///< touching contacts and joints without a colour, which are solved one by one
};

/// One touching point of a contact, in world coordinates. The force over a substep of h = dt / substeps seconds is impulse / h newtons, so a body that stands
/// still bears normal_impulse / h.
struct ContactPoint {
    Vec2 point = {};            ///< m, midway between the surfaces
    float separation = 0;       ///< m, negative when overlapping
    float normal_impulse = 0;   ///< N s over the last substep
    float tangent_impulse = 0;  ///< N s over the last substep
    std::uint32_t feature = 0;  ///< names the features (corners, sides) of the two shapes that made the point
};

/// A contact of two shapes that touch.
struct ContactInfo {
    ShapeId shape_a = {};
    ShapeId shape_b = {};
    Vec2 normal = {};  ///< unit, from a to b
    ContactPoint points[2];
    std::uint32_t point_count = 0;
    float friction = 0;     ///< Coulomb coefficient of the two surfaces
    float restitution = 0;  ///< 0 to 1
};

/// A contact as the pre_solve hook sees it, and what the hook may change for this one step.
struct PreSolve {
    ContactInfo contact = {};  ///< as it is before the step, with the impulses of the last one; changing it has no effect
    bool enabled = true;       ///< false: the two shapes do not touch in this step, and no event says that they do
    float friction = 0;        ///< Coulomb coefficient, 0 to max_coefficient
    float tangent_speed = 0;   ///< m/s, the sum of both shapes' ShapeDef::tangent_speed
};

}  // namespace islet
ISLET_API_END
