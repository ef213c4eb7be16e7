// Ids, definitions, errors, events and reports: everything a user hands to a World or reads back from it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "islet/geometry.hpp"
#include "islet/math.hpp"
#include "islet/tasks.hpp"

ISLET_API_BEGIN
namespace islet {

/// No position may exceed this on either axis, m: there a float steps by a metre. Bodies that fly farther stop at it.
inline constexpr float max_position = 1.0e7f;
/// Coefficients of friction and rolling resistance go from 0 to this.
inline constexpr float max_coefficient = 1.0e9f;
/// Speed limits and surface speeds go up to this, m/s.
inline constexpr float max_speed_limit = 1.0e6f;
/// Steps are at least this long, s. What a shorter step adds to a speed or a position is mostly lost to rounding.
inline constexpr float min_time_step = 1.0e-6f;

/// Handle of a body. Default-constructed: null. Safe to keep: an id whose object was destroyed is stale, never wrong.
struct BodyId {
    std::uint32_t index1 = 0;      // slot + 1; 0 is null
    std::uint32_t generation = 0;  // of the slot when the id was handed out
    friend bool operator==(const BodyId&, const BodyId&) = default;
    explicit constexpr operator bool() const { return index1 != 0; }
};

/// Handle of a shape; as BodyId.
struct ShapeId {
    std::uint32_t index1 = 0;
    std::uint32_t generation = 0;
    friend bool operator==(const ShapeId&, const ShapeId&) = default;
    explicit constexpr operator bool() const { return index1 != 0; }
};

/// How many objects of each kind a world can hold. Decides the size of its memory block (world_bytes) and nothing else.
struct Capacity {
    std::uint32_t bodies = 0;
    std::uint32_t shapes = 0;
    std::uint32_t contacts = 0;  ///< Pairs of shapes whose fat boxes overlap, touching or not: 3 to 5 a body in a dense pile, 7 if it is squeezed.
    std::uint32_t joints = 0;
    std::uint32_t geometries = 0;  ///< Different geometries (equal ones are stored once); 0 means as many as shapes.
    std::uint32_t hits = 0;        ///< Hit events in one step; 0 means an eighth of contacts, at least 8.
    friend bool operator==(const Capacity&, const Capacity&) = default;
};

/// What went wrong in the last call that failed. describe(e) says it in a sentence, with the way to mend it.
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
    contacts_full,      ///< raise Capacity::contacts (the contact is retried every step)
    geometries_full,    ///< raise Capacity::geometries
    block_too_small,    ///< the memory given is smaller than world_bytes(capacity)
    block_misaligned,   ///< the memory given is not aligned to world_alignment
    bad_capacity,       ///< a capacity is zero where at least one is needed, or above max_capacity
    events_full,        ///< more contacts ended than there is room to report
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
    feature_cut,        ///< this build of the engine was made without what the call needs (islet/config.hpp), or nothing links it
    not_a_sensor,       ///< the shape is no sensor
    hits_full,          ///< raise Capacity::hits
    recording_full,     ///< the memory given for a recording is too small, or was used up: it ends before this call
    not_a_recording,    ///< the bytes are no recording, or the world is not being recorded
    corrupt_recording,  ///< the recording is not as it was made
    in_step,            ///< called from a function that the world itself calls, such as a hook or a drawing function, and not allowed there
    inexact_build,      ///< the engine was compiled with flags that change the results of IEEE floats, and so the bits: create makes no world, and a
                        ///< StaticWorld takes no step
};

/// A sentence: what was wrong and how to mend it. Never null.
const char* describe(Error e);

/// Receives each error as it happens. It may read the world's bodies and shapes. A call that would change the world is refused (in_step), and the hook is not
/// told of that error.
using ErrorHook = void (*)(Error error, void* context);

struct PreSolve;  // below

/// The user's part in decisions that a step needs at once. All may be null; `context` is passed on to each. Hooks are no part of the state: no hash knows of
/// them and no snapshot holds them, so worlds that are to have equal futures must be given equal ones, which answer alike.
///
/// filter and pre_solve are called on the thread that steps, one after another, in an order that does not depend on the number of workers; they may read the
/// world's bodies and shapes, but not change it (in_step). mix_friction and mix_restitution are called on any worker, as often as the engine likes: they must
/// be functions of their arguments alone.
struct Hooks {
    /// May these two shapes meet, or may this sensor see that shape? (The one in the lower slot comes first.) Asked when their fat boxes begin to overlap
    /// and whenever that pair is found again, of pairs that their filters allow. A pair once made is not asked about again before it parts.
    bool (*filter)(ShapeId shape_a, ShapeId shape_b, void* context) = nullptr;
    /// May look at a contact before it is solved, and change it for this step: see PreSolve. Called in every step for every awake contact that has points
    /// and a shape with ShapeDef::pre_solve, in the order of their slots. A fast body's contact with what it may hit in the step is made ahead, and continuous
    /// collision follows what the hook says of it. A one-way shape (ShapeDef::one_way) has only those contacts asked about that it holds.
    void (*pre_solve)(PreSolve& contact, void* context) = nullptr;
    /// Coefficient of two shapes, in place of the geometric mean; `material` is SurfaceMaterial::id. Taken as 0 to max_coefficient. Asked when two shapes
    /// meet or a material changes.
    float (*mix_friction)(float friction_a, std::uint32_t material_a, float friction_b, std::uint32_t material_b, void* context) = nullptr;
    /// The same for restitution, in place of the larger. Taken as 0 to 1. Asked in steps, too.
    float (*mix_restitution)(float restitution_a, std::uint32_t material_a, float restitution_b, std::uint32_t material_b, void* context) = nullptr;
    void* context = nullptr;
    friend bool operator==(const Hooks&, const Hooks&) = default;
};

/// Reads a clock of yours, which counts on in whatever unit you like. Must not call the world; it cannot change it (in_step).
using Clock = std::uint64_t (*)(void* context);

/// The order of the numbers in a step. `soft` is the default; `classic` is one position-corrected velocity solve per step.
enum class Schedule : std::uint8_t {
    soft,     ///< substeps of: integrate, biased sweep with soft contacts, integrate positions, relax sweep
    classic,  ///< per substep: integrate, `iterations` sweeps with Baumgarte bias, integrate positions. Use with substeps = 1.
};

/// Which hinges (revolute joints) are solved exactly, all of a tree at once, instead of one by one in sweeps. What closes a loop is always swept, and so is
/// a hinge with a spring, a limit, a motor or friction.
enum class JointTrees : std::uint8_t {
    off,        ///< none
    automatic,  ///< trees in which a hinge bears much more than the bodies it joins weigh, and of which none is swept: chains with a load, long ropes
    all,        ///< all there are
};

/// The order in which a sweep visits contacts. (Joints come before them in every order, trees of joints behind.)
enum class SweepOrder : std::uint8_t {
    colored,   ///< by colours, as many at once as there are lanes: the fastest by far
    as_found,  ///< one by one, in the order of their slots
    upward,    ///< one by one, from the lowest to the highest against gravity: weight is handed down in as many sweeps as there are layers, support handed
               ///< up in one
    downward,  ///< one by one, from the highest to the lowest
};

/// The most of SolverDef::shock: with more of it piles of loose bodies gain energy.
inline constexpr float max_shock = 0.5f;

/// How the solver works. Change it at any time with World::set_solver.
struct SolverDef {
    Schedule schedule = Schedule::soft;
    std::uint32_t substeps = 4;           ///< 1 to 64. More: stiffer stacks and joints, cost in proportion.
    std::uint32_t iterations = 1;         ///< 1 to 256 biased sweeps per substep.
    std::uint32_t relax_iterations = 1;   ///< 0 to 256 unbiased sweeps per substep (soft schedule).
    float contact_hertz = 30.0f;          ///< Hz, > 0. Stiffness of soft contacts; capped at an eighth of the substep rate.
    float contact_damping_ratio = 10.0f;  ///< >= 0. Soft contacts are overdamped so that they do not bounce.
    float contact_push_speed = 3.0f;      ///< m/s, >= 0. Fastest that overlap is pushed apart.
    float joint_hertz = 60.0f;            ///< Hz, > 0. Stiffness with which joints mend their errors; capped at a quarter of the substep rate. A rigid
                                          ///< joint under a steady force F gives by F / (m (2 pi joint_hertz)^2), m the mass it moves. A
                                          ///< limit holds where it is set, at once, against the joint's own motor. Under a steady load
                                          ///< from elsewhere it gives as much as a rigid joint at first, and comes back: 128 steps later
                                          ///< about a third of that error is left.
    float joint_damping_ratio = 2.0f;     ///< >= 0
    float baumgarte = 0.2f;               ///< 0 to 1. Share of overlaps and joint errors mended per step (classic schedule).
    float omega = 1.0f;                   ///< 0 < omega < 2. Relaxation factor (SOR); 1 is plain PGS.
    bool warm_start = true;               ///< Start each step from the impulses of the last.
    JointTrees joint_trees = JointTrees::automatic;  ///< Which hinges are solved exactly instead of swept.
    float joint_tree_load = 10.0f;  ///< >= 1. Automatic: a tree is solved exactly if a hinge of it bears so many times the mass of the lighter of
                                    ///< the two bodies it joins. Lower: more trees. (Not for masses above 1e18 kg: their squares overflow.)
    SweepOrder sweep_order = SweepOrder::colored;  ///< With block_contacts, colored stands for as_found.
    bool block_contacts = false;                   ///< Solve the two normal impulses of a contact together, exactly.
    float shock = 0;  ///< 0 to max_shock. Shock propagation: by this share a body is taken for lighter than what it lies on. For what stands: blows
                      ///< and the forces reported are those of the lighter bodies. From 0.5 on not with joints in the pile.
    bool measure_residual = false;  ///< Measure after each step how far the impulses are from a solution: World::residual.
    float tolerance = 0;            ///< m/s, >= 0. Above 0: no more sweeps of a kind within a substep once the residual is at most this; islands that
                                    ///< are solved together (neighbours, see StepReport::batches) end together. Measuring costs two to three sweeps.
    friend bool operator==(const SolverDef&, const SolverDef&) = default;
};

/// What a new world is like.
struct WorldDef {
    Vec2 gravity = {0, -10};  ///< m/s^2
    SolverDef solver = {};
    bool enable_sleep = true;            ///< Let islands at rest fall asleep after 0.5 s.
    float restitution_threshold = 1.0f;  ///< m/s, >= 0. Slower impacts do not bounce.
    float max_speed = 400.0f;            ///< m/s, > 0, at most max_speed_limit. No body moves faster.
    float hit_threshold = 1.0f;          ///< m/s, >= 0. Hit events tell of shapes that come together faster.
    bool continuous = true;              ///< Continuous collision: dynamic bodies pass through no static shape, and bullets through no other body, however
                                         ///< fast they move and turn, and however hard they are pressed. (Bullets may still be
                                         ///< crowded into a moving body by other bullets.)
    std::uint32_t lanes = 0;             ///< 1, 4 or 8 constraints at once; 0 picks the widest the processor has. The bits are the same.
    ErrorHook error_hook = nullptr;
    void* error_context = nullptr;
    Hooks hooks = {};       ///< See World::set_hooks.
    TaskSystem tasks = {};  ///< Threads to step with; none by default. The bits are the same.
    Clock clock = nullptr;  ///< What World::profile is measured with; none by default. The bits are the same.
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
    Vec2 position = {};          ///< m, of the body's origin; within max_position
    float angle = 0;             ///< rad
    Vec2 linear_velocity = {};   ///< m/s, of the centre of mass
    float angular_velocity = 0;  ///< rad/s
    float linear_damping = 0;    ///< 1/s, >= 0
    float angular_damping = 0;   ///< 1/s, >= 0
    float gravity_scale = 1;
    float sleep_threshold = 0.05f;  ///< m/s, >= 0. Slower bodies may fall asleep.
    bool enable_sleep = true;       ///< false: keeps itself and its island awake.
    bool awake = true;              ///< false: starts asleep.
    bool fixed_rotation = false;    ///< true: infinite rotational inertia, and no angular velocity to start with.
    bool lock_x = false;            ///< true: if dynamic, the centre of mass does not move along the world's x axis, whatever pushes. The lock is solved
    bool lock_y = false;            ///< like a contact, in every sweep. The same along y.
    bool enabled = true;            ///< false: takes part in nothing; see World::set_enabled.
    bool bullet = false;            ///< true: does not pass through moving bodies either (WorldDef::continuous). For a few: each is compared with every
                                    ///< awake body.
    std::uint64_t user_data = 0;
};

/// Which shapes meet: equal positive groups always, equal negative groups never, else both masks must hold the other's category.
struct Filter {
    std::uint32_t category = 1;
    std::uint32_t mask = 0xffffffffu;
    std::int32_t group = 0;
};

/// What a surface is like: the first four fields as in ShapeDef, and a number of the user's, which the mixing hooks are given.
struct SurfaceMaterial {
    float friction = 0.6f;
    float restitution = 0;
    float rolling_resistance = 0;
    float tangent_speed = 0;
    std::uint32_t id = 0;
    friend bool operator==(const SurfaceMaterial&, const SurfaceMaterial&) = default;
};

/// What a new shape is like.
struct ShapeDef {
    float friction = 0.6f;         ///< Coulomb coefficient, 0 to max_coefficient. Two shapes mix by the geometric mean.
    float restitution = 0;         ///< 0 to 1. Two shapes mix by the larger.
    float rolling_resistance = 0;  ///< 0 to max_coefficient, times the larger radius: lever arm of the resisting torque. Two shapes mix by the larger.
    float tangent_speed = 0;       ///< m/s. A conveyor: what lies on the surface is carried to its right (clockwise around the shape). Two shapes add.
    float density = 1;             ///< kg/m^2, >= 0
    Filter filter = {};
    bool sensor = false;         ///< Collides with nothing, and tells which shapes overlap it: of all bodies but its own, that its filter allows and that
                                 ///< consent; but a static sensor sees no static bodies, and no sensor sees another. It has mass as its density says.
                                 ///< What passes all of it within one step is not seen.
    bool sensor_events = true;   ///< false: sensors do not see this shape. (A sensor is made on purpose, so it sees all by default. In Box2D from
                                 ///< version 3.1 on both shapes have to be told to.)
    bool hit_events = false;     ///< Tell of hits of this shape: World::hit_events.
    bool pre_solve = false;      ///< Ask the pre_solve hook about contacts of this shape.
    Vec2 one_way = {};           ///< Not zero: a one-way platform. It holds only what came from the side that this direction points to, in the body's
                                 ///< frame ({0, 1}: from above). The length does not matter; the angle is kept to 1/1000 rad. The other shape passes
                                 ///< until all of it is beyond the platform's farthest point along the direction; from then on it is held, until it
                                 ///< leaves. Bodies, fast ones too, and movers are held; queries see the platform as any other shape. What stands
                                 ///< on it drops through if the pre_solve hook disables the contact once (pre_solve of either shape), or if a
                                 ///< filter forbids the contact. Of two one-way shapes each must hold the other. Where the two were before they met is
                                 ///< told by their velocities: a body may pass if one of these is set in the very step that they meet in.
                                 ///< Errors: not_finite; feature_cut.
    std::uint32_t material = 0;  ///< SurfaceMaterial::id
    std::uint64_t user_data = 0;
};

/// Two shapes began or ceased to touch in the last step (or ceased because one was destroyed since). An id in an end event may be stale. Here and in all
/// that tells of contacts, shape_a is the shape whose type comes later in the row circle, capsule, polygon, segment, chain segment; of equal types the one
/// in the lower slot.
struct TouchEvent {
    ShapeId shape_a = {};
    ShapeId shape_b = {};
};

/// A shape began to overlap a sensor, or ceased to (or one of them was destroyed, disabled or moved). An id in an end event may be stale.
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
    float speed = 0;   ///< m/s, at which the surfaces came together along the normal, before they pushed each other
};

/// An explosion: World::explode.
struct ExplosionDef {
    Vec2 position = {};                ///< m
    float radius = 0;                  ///< m, >= 0. What is nearer feels the whole of it.
    float falloff = 0;                 ///< m, >= 0. Beyond the radius the impulse falls linearly to 0 over this distance.
    float impulse_per_length = 0;      ///< N s per metre of the shape's width as seen from there; below 0: an implosion
    std::uint32_t mask = 0xffffffffu;  ///< Shapes of these categories feel it.
};

/// Wind on a shape: World::apply_wind.
struct WindDef {
    Vec2 velocity = {};      ///< m/s, of the air; up to max_speed_limit
    float drag = 1;          ///< >= 0, coefficient of the force along the stream. Of a flat plate across it 1.2 to 2, of a disc about 1.
    float lift = 0;          ///< coefficient of the force across the stream
    float density = 1.225f;  ///< kg/m^3, >= 0, of a slice one metre deep: air
    bool wake = true;        ///< false: no effect on bodies that sleep
};

/// What the last step did.
struct StepReport {
    std::uint32_t bodies = 0;        ///< all, of every type
    std::uint32_t awake_bodies = 0;  ///< awake dynamic and kinematic ones after the step
    std::uint32_t shapes = 0;
    std::uint32_t contacts = 0;           ///< pairs with overlapping fat boxes, touching or not, asleep or not
    std::uint32_t touching_contacts = 0;  ///< of the awake ones
    std::uint32_t recycled_contacts = 0;  ///< awake contacts whose manifold was kept
    /// Pairs that found no room this step, counted up to Capacity::contacts: their shapes pass through each other. The pairs are tried again in every step,
    /// and each such step fails with contacts_full. Raise Capacity::contacts: 3 to 5 for each moving shape of a dense pile, 7 where the pile is squeezed.
    std::uint32_t dropped_contacts = 0;
    std::uint32_t dropped_events = 0;     ///< end events that found no room since the last step began
    std::uint32_t dropped_hits = 0;       ///< hits that found no room among the hit events
    std::uint32_t islands = 0;            ///< awake islands
    std::uint32_t colors = 0;             ///< constraint colours in use
    std::uint32_t overflow_contacts = 0;  ///< contacts solved one by one: those that found no colour, or all of them in any SweepOrder but colored
    std::uint32_t batches = 0;
    std::uint32_t joints = 0;           ///< all
    std::uint32_t awake_joints = 0;     ///< those solved
    std::uint32_t overflow_joints = 0;  ///< joints solved one by one: gears, and those that found no colour
    std::uint32_t sweeps = 0;           ///< that were made; fewer than SolverDef says where a tolerance ended them, then of the batch with the most
    float residual = 0;                 ///< m/s, the largest of any island (World::residual); 0 if not measured
};

/// What the stages of the last step took, in ticks of WorldDef::clock: all 0 without one.
struct StepProfile {
    std::uint64_t pairs = 0;    ///< which fat boxes overlap
    std::uint64_t collide = 0;  ///< where and how shapes touch
    std::uint64_t islands = 0;  ///< what belongs together and in which order it is solved
    std::uint64_t solve = 0;    ///< forces, impulses and motion
    std::uint64_t finish = 0;   ///< places, boxes, sleep and events
    std::uint64_t total = 0;    ///< the whole step: the sum of these
};

/// Constraint colours there are.
inline constexpr std::uint32_t constraint_color_count = 32;

/// What a world is made of now, beside what StepReport says. For displays: it is counted when asked for.
struct WorldCounters {
    std::size_t bytes = 0;                              ///< of the world's block: world_bytes(capacity)
    std::size_t snapshot_bytes = 0;                     ///< of it that save() needs now
    std::uint32_t geometries = 0;                       ///< different ones
    std::uint32_t tree_shapes = 0;                      ///< shapes at rest, which a tree of boxes holds; the others are found by sorting
    std::uint32_t tree_height = 0;                      ///< boxes on the way from the tree's root to its farthest leaf; 0 if it is empty
    std::uint32_t colors[constraint_color_count] = {};  ///< touching contacts and joints by constraint colour, awake or not
    std::uint32_t uncolored = 0;                        ///< those that found no colour, which are solved one by one
};

/// One touching point of a contact, in world coordinates. A force over a substep of h seconds, h = dt / substeps, is impulse / h newtons: what stands still
/// bears normal_impulse / h.
struct ContactPoint {
    Vec2 point = {};            ///< m, midway between the surfaces
    float separation = 0;       ///< m, negative when overlapping
    float normal_impulse = 0;   ///< N s over the last substep
    float tangent_impulse = 0;  ///< N s over the last substep
    std::uint32_t feature = 0;  ///< which features of the two shapes made the point
};

/// A contact as the user sees it.
struct ContactInfo {
    ShapeId shape_a = {};
    ShapeId shape_b = {};
    Vec2 normal = {};  ///< unit, from a to b
    ContactPoint points[2];
    std::uint32_t point_count = 0;
    float friction = 0;
    float restitution = 0;
};

/// What the pre_solve hook sees of a contact, and may change for this one step.
struct PreSolve {
    ContactInfo contact = {};  ///< as it is before the step, with the impulses of the last one; changing it has no effect
    bool enabled = true;       ///< false: the two shapes do not touch in this step, and so nothing tells of it
    float friction = 0;        ///< Coulomb coefficient, 0 to max_coefficient
    float tangent_speed = 0;   ///< m/s, as in ShapeDef, of both together
};

}  // namespace islet
ISLET_API_END
