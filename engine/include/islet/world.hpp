// The world: one block of memory that holds every body, shape and contact, and steps them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "islet/joints.hpp"
#include "islet/layout.hpp"
#include "islet/query.hpp"
#include "islet/span.hpp"
#include "islet/types.hpp"

ISLET_API_BEGIN
namespace islet {

struct DebugDraw;  // debug_draw.hpp
struct DrawStyle;
struct IslandProblem;  // island.hpp

class World;

namespace detail {
ISLET_INTERNAL_BEGIN
struct Core;
ISLET_INTERNAL_END
/// Makes the world of a StaticWorld. The capacity is valid, and the block has the layout's size.
World& create_static(std::byte* block, const Capacity& capacity, const Layout& layout, const WorldDef& def, LaidOut = {});
// For interfaces of other languages, which refuse arguments themselves, and return the error of each call that changes a world.
/// Records an error and calls the error hook, as the world does, unless `world` is null. Returns the error.
Error refuse_call(const World* world, Error error);
/// Tells that no world was made, and why: `error` gets `problem`, if it is given, and the hook of `def` is called. Returns null.
World* refuse_creation(Error problem, const WorldDef& def, Error* error);
/// Before a call: no error is known, until end_call. False if `world` is null.
bool begin_call(World* world);
/// After it: its error. If it had none, the last error is again that before begin_call. If `world` is null, returns `without`.
Error end_call(World* world, Error without);
}  // namespace detail

/// A world lives at the start of the block of memory it was created in and never moves, allocates or frees. Not copyable.
///
/// Every function checks its arguments in every build. On bad input it changes nothing, returns a null or zero value, sets last_error() and
/// calls the error hook, if there is one. Units: metres, kilograms, seconds, radians.
///
/// Comments name a function's errors but for those that are the same everywhere: null_id and stale_id of an id; not_finite and out_of_range of a number;
/// feature_cut of what this build leaves out; in_step of a call that the next paragraph forbids.
///
/// Functions of yours that a world calls (hooks, the error hook, the clock, the task system, drawing functions, a mover's filter) may read its
/// bodies and shapes. They may not change the world, nor step, save, hash, validate, export or draw it: such a call fails with in_step,
/// changes nothing and is not recorded. Only visitors of queries may do these things (query.hpp).
///
/// Spans returned by a world are valid until the next call that changes it.
class World {
public:
    /// Makes a world in `block`, which must be aligned to world_alignment and hold at least world_bytes(capacity) bytes. The world then owns all of
    /// it. Returns null, and sets *error if given, if the block, the capacity or the definition breaks a rule, or if the engine was compiled in a way
    /// that changes the bits (inexact_build).
    static World* create(span<std::byte> block, const Capacity& capacity, const WorldDef& def, Error* error = nullptr);

    World(const World&) = delete;
    World& operator=(const World&) = delete;

    // -- the world ---------------------------------------------------------------------------------------------------------------

    /// Advances time by dt seconds, min_time_step <= dt <= 1. 1/60 is usual; see SolverDef for what a step consists of. Errors (nothing changes):
    /// bad_time_step; in_step; inexact_build (of a StaticWorld).
    void step(float dt);

    /// WorldDef::gravity, m/s^2, (0, -10) by default. What a body feels of it is this times its gravity_scale.
    Vec2 gravity() const;
    /// Sets it, m/s^2, from the next step on. It wakes no body: one that sleeps feels it when it is woken. A vector that is not finite is refused (not_finite).
    void set_gravity(Vec2 gravity);
    /// The solver's settings: WorldDef::solver, or what set_solver made of them.
    SolverDef solver() const;
    /// Changes the solver's settings. A value out of range is refused (out_of_range), and nothing changes.
    void set_solver(const SolverDef& solver);
    /// m/s: how far the impulses of the body's island were from a solution when the last step ended. It is the largest change of a body's velocity that solving
    /// any single contact or joint once more would cause. (A change of the angular velocity counts as the speed at the radius of gyration.) It is 0 at a
    /// solution, for bodies at rest, and without SolverDef::measure_residual. Hinges that are solved exactly, in joint trees, are not measured.
    float residual(BodyId body) const;
    /// The threads that step the world (WorldDef::tasks); none by default.
    TaskSystem tasks() const;
    /// Sets the threads that step the world. TaskSystem::workers of 0 or above max_workers is refused (out_of_range). The task system is not part of the
    /// state: hashes and snapshots do not contain it.
    void set_tasks(const TaskSystem& tasks);
    /// How long the stages of the last step took. Only programs that call this function measure it.
    const StepProfile& profile() const;
    /// Sets the clock that measures stages; null for none. The clock is not part of the state: hashes and snapshots do not contain it.
    void set_clock(Clock clock, void* context = nullptr);
    /// Figures of the world for displays, beside those of report(). They are counted when you call it.
    WorldCounters counters() const;
    /// WorldDef::enable_sleep. Turning sleep off wakes everything.
    bool sleep_enabled() const;
    void enable_sleep(bool enable);
    /// WorldDef::restitution_threshold, m/s, >= 0.
    float restitution_threshold() const;
    void set_restitution_threshold(float speed);
    /// WorldDef::max_speed, m/s, above 0 and at most max_speed_limit. A lower one slows faster bodies down in the next step.
    float max_speed() const;
    void set_max_speed(float speed);
    /// How many constraints this world solves at once, at most: 1, 4, 8 or 16 (WorldDef::lanes).
    std::uint32_t lanes() const;
    /// WorldDef::continuous.
    bool continuous() const;
    void enable_continuous(bool enable);
    /// WorldDef::seamless_floors. A change holds for each contact from when its points are found anew. Error: feature_cut.
    bool seamless_floors() const;
    void enable_seamless_floors(bool enable);

    /// The hooks as they were last set; none by default.
    Hooks hooks() const;
    /// Sets the hooks. Two shapes in contact keep their mixed friction, and whether they bounce, until a material changes or the shapes part. How much they
    /// bounce is mixed anew in every step.
    void set_hooks(const Hooks& hooks);
    /// m/s, >= 0 (WorldDef::hit_threshold)
    float hit_threshold() const;
    void set_hit_threshold(float speed);
    /// Pushes the circles, capsules and polygons of dynamic bodies in reach away from a point. The impulse is impulse_per_length times the shape's width
    /// across the direction from the explosion to the shape's nearest point, and acts at that point. (If the explosion is inside the shape, the direction is
    /// that to the shape's middle.) Shapes do not shield each other. Sensors feel nothing. The bodies pushed wake up.
    void explode(const ExplosionDef& explosion);

    /// How many objects of each kind there is room for, as create() was told.
    const Capacity& capacity() const;
    /// What the last step did, and how many objects the world holds.
    const StepReport& report() const;
    /// The last error since creation or clear_error().
    Error last_error() const;
    /// Makes last_error() none.
    void clear_error();
    /// The error hook as it was last set (WorldDef::error_hook); null if there is none.
    ErrorHook error_hook() const;
    /// What the error hook gets as its context; null by default.
    void* error_context() const;
    /// Sets the function that receives each error; null for none. The hook is not part of the state: hashes, snapshots and recordings do not contain it.
    void set_error_hook(ErrorHook hook, void* context = nullptr);
    /// Hash of all persistent state that affects the future, and of nothing else. Worlds with equal hashes have equal futures, and their next steps report
    /// equal events, those of touches that ended since the last step included. Returns 0 on an error: in_step.
    std::uint64_t hash() const;
    /// Steps taken since creation.
    std::uint64_t step_count() const;
    /// Checks every internal invariant (lists, pools, trees, colours). Slow; for tests. Returns null or a sentence that says what is broken.
    const char* validate() const;

    // -- snapshots (snapshot.hpp) ------------------------------------------------------------------------------------------------

    /// Bytes that save() needs now.
    std::size_t snapshot_bytes() const;
    /// Writes the persistent state to `out`; returns the bytes written, or 0 if it is too small (image_too_small).
    std::size_t save(span<std::byte> out) const;
    /// Takes the world back to an image that this program made. The objects in the image must fit this world's capacity. The capacity of the saved world may
    /// have been another. Only the image's header is checked; the rest is copied as fast as memory allows. The world keeps what belongs to the host: lanes,
    /// hooks, the clock and the task system. There are no events until the next step, and the report holds only the numbers of objects. Touches that had ended
    /// since the last step, because a shape was destroyed, are part of the image: the next step reports them. Returns false and changes nothing on an error:
    /// those of read_snapshot; image_too_large; feature_cut if this build or program lacks a part that the image needs. (A program that neither makes joints
    /// nor calls load does not link joints, so it cannot restore an image with joints.)
    bool restore(span<const std::byte> image);
    /// Like restore, for an image from outside, which may be truncated, corrupt or hostile. Nothing of it is used before all of it is found sound.
    /// Further errors: image_misaligned (see snapshot_alignment); corrupt_image if the checksum does not fit the content; unsound_image.
    bool load(span<const std::byte> image);

    // -- recordings (recording.hpp) ----------------------------------------------------------------------------------------------

    /// Writes a snapshot to `buffer`, and after it every call that changes the world. The buffer must be aligned to recording_alignment; it belongs to the
    /// world until the recording stops. With `bodies`, each step also writes a hash of each awake body, four bytes long. Returns false, and records
    /// nothing, if there is no room for the snapshot (recording_full) or the buffer is misaligned (image_misaligned). If there is no more room later, the
    /// recording stops by itself (recording_full) and holds all calls before. A recording that is already running is discarded.
    bool start_recording(span<std::byte> buffer, bool bodies = true);
    /// True from start_recording until the recording stops.
    bool is_recording() const;
    /// Bytes used so far; 0 if nothing is being recorded.
    std::size_t recorded_bytes() const;
    /// Continues the recording in a larger buffer. Returns false, and changes nothing, if the buffer is smaller than recorded_bytes() (recording_full) or
    /// misaligned (image_misaligned), or if nothing is being recorded (not_a_recording).
    bool move_recording(span<std::byte> buffer);
    /// Ends the recording; returns its bytes, or 0 if nothing is being recorded (not_a_recording).
    std::size_t stop_recording();

    // -- events of the last step -----------------------------------------------------------------------------------------------

    /// Pairs of shapes that began to touch in the last step.
    span<const TouchEvent> begin_touch_events() const;
    /// Contacts that ended in the last step, and in calls made since. This list and sensor_end_events() have room for Capacity::contacts events together. If
    /// calls need that room, they remove the events of the last step, so read these events before you make calls.
    span<const TouchEvent> end_touch_events() const;
    /// Overlaps of sensors that began, and that ended, in the same order as touches. A step reports the overlaps at the poses with which it begins. An overlap
    /// that a call ends is reported at once, and again after the next step.
    span<const SensorEvent> sensor_begin_events() const;
    span<const SensorEvent> sensor_end_events() const;
    /// Contacts of shapes with ShapeDef::hit_events whose surfaces came together faster than hit_threshold() and needed an impulse, ordered by slot.
    span<const HitEvent> hit_events() const;
    /// Bodies that the last step moved (every awake one), ordered by slot.
    span<const BodyId> moved_bodies() const;
    /// Bodies that fell asleep in the last step, ordered by slot.
    span<const BodyId> slept_bodies() const;
    /// Joints that broke at the end of the last step, ordered by slot.
    span<const JointBreakEvent> broken_joints() const;

    // -- bodies ----------------------------------------------------------------------------------------------------------------

    /// Returns null on an error: bodies_full; not_finite, out_of_range and feature_cut of a field, which find_fault names (fault.hpp).
    BodyId create_body(const BodyDef& def);
    /// Destroys the body with its shapes, contacts and joints. Wakes the bodies that touched it or were joined to it.
    void destroy_body(BodyId body);
    /// True if the id names a body that exists. No id is an error here.
    bool is_valid(BodyId body) const;
    /// Number of live bodies.
    std::uint32_t body_count() const;
    /// Id of the body in slot 0 <= slot < capacity().bodies; null if the slot is free. For walking over all bodies.
    BodyId body_at(std::uint32_t slot) const;

    /// The pose of the body's origin, m.
    Transform transform(BodyId body) const;
    /// The body's origin.
    Vec2 position(BodyId body) const;
    /// rad, in (-pi, pi]
    float angle(BodyId body) const;
    /// m, in the world
    Vec2 center_of_mass(BodyId body) const;
    /// m, from the origin, in the body's frame
    Vec2 local_center_of_mass(BodyId body) const;
    /// m/s, of the centre of mass
    Vec2 linear_velocity(BodyId body) const;
    /// rad/s
    float angular_velocity(BodyId body) const;
    /// m/s: the velocity of the point of the body that is now at world position `point`.
    Vec2 velocity_at(BodyId body, Vec2 point) const;
    /// Teleports the body to a position, m, and an angle, rad. Its contacts are found anew; it keeps its velocity. Wakes the body, and the bodies that
    /// touched it or are joined to it.
    void set_transform(BodyId body, Vec2 position, float angle);
    /// The same. pose.q must be of unit length (out_of_range).
    void set_transform(BodyId body, const Transform& pose);
    /// m/s, of the centre of mass. No effect on static bodies. Wakes the body if the velocity is not zero.
    void set_linear_velocity(BodyId body, Vec2 velocity);
    /// The same, rad/s; no effect on bodies of fixed rotation either.
    void set_angular_velocity(BodyId body, float velocity);
    /// Gives a kinematic body the velocities that take it to a pose in a step of dt seconds, except for rounding: at most max_speed, and at most a quarter
    /// turn. The body keeps the velocities after that step, so call this function before each step. No effect on other bodies. target.q must be of unit length.
    void set_target(BodyId body, const Transform& target, float dt);

    /// Forces (N) and torques (N m) act over the next step and are then cleared. Impulses (N s, N m s) act at once. All of these need a dynamic body, and
    /// wake it. With wake = false they have no effect on a body that sleeps, and do not keep a body that rests from falling asleep.
    void apply_force(BodyId body, Vec2 force, Vec2 point, bool wake = true);
    void apply_force_to_center(BodyId body, Vec2 force, bool wake = true);
    void apply_torque(BodyId body, float torque, bool wake = true);
    void apply_linear_impulse(BodyId body, Vec2 impulse, Vec2 point, bool wake = true);
    void apply_linear_impulse_to_center(BodyId body, Vec2 impulse, bool wake = true);
    void apply_angular_impulse(BodyId body, float impulse, bool wake = true);

    /// Static, kinematic or dynamic.
    BodyType type(BodyId body) const;
    /// Changes the type. Contacts are found anew, and the body gets the mass of its shapes again. Wakes the bodies that touched it or are joined to it. A body
    /// that becomes static loses its velocity.
    void set_type(BodyId body, BodyType type);
    /// kg; 0 for a body that is not dynamic
    float mass(BodyId body) const;
    /// kg m^2, about the centre of mass
    float rotational_inertia(BodyId body) const;
    /// Replaces the mass, centre and inertia that follow from the shapes, until a shape is added or removed, the type changes or reset_mass is called. mass:
    /// 1e-12 to 1e30 kg; inertia: 1e-15 to 1e30 kg m^2, or 0 for a body that does not turn; centre: within max_position.
    void set_mass(BodyId body, const MassData& mass);
    /// Takes mass, centre and inertia from the shapes' densities again.
    void reset_mass(BodyId body);
    /// 1/s, >= 0 (BodyDef::linear_damping)
    float linear_damping(BodyId body) const;
    void set_linear_damping(BodyId body, float damping);
    /// 1/s, >= 0
    float angular_damping(BodyId body) const;
    void set_angular_damping(BodyId body, float damping);
    /// Multiple of the gravity that the body feels.
    float gravity_scale(BodyId body) const;
    void set_gravity_scale(BodyId body, float scale);
    /// BodyDef::fixed_rotation. Fixing it makes the angular velocity 0. A change wakes the body.
    bool is_rotation_fixed(BodyId body) const;
    void set_fixed_rotation(BodyId body, bool fixed);
    /// BodyDef::lock_x and lock_y.
    bool is_x_locked(BodyId body) const;
    bool is_y_locked(BodyId body) const;
    void lock_x(BodyId body, bool lock);
    void lock_y(BodyId body, bool lock);
    /// BodyDef::enabled.
    bool is_enabled(BodyId body) const;
    /// A disabled body keeps its shapes, joints and velocity, but takes part in nothing: its contacts and overlaps end, its joints hold no body, it does not
    /// move, and no query finds it. Disabling and enabling wake the bodies that touched it or are joined to it.
    void set_enabled(BodyId body, bool enabled);
    /// BodyDef::bullet. No effect unless the body is dynamic.
    bool is_bullet(BodyId body) const;
    void set_bullet(BodyId body, bool bullet);
    /// BodyDef::enable_sleep.
    bool sleep_enabled(BodyId body) const;
    void enable_sleep(BodyId body, bool enable);
    /// m/s, >= 0 (BodyDef::sleep_threshold)
    float sleep_threshold(BodyId body) const;
    void set_sleep_threshold(BodyId body, float threshold);
    /// False for a body that sleeps.
    bool is_awake(BodyId body) const;
    /// Wakes the body and its island.
    void wake(BodyId body);
    /// Puts a dynamic body and its island to sleep at once; their velocities and forces become 0. No effect on other bodies, if the island touches or is joined
    /// to a kinematic body that is awake, or if the world does not sleep (WorldDef::enable_sleep).
    void sleep(BodyId body);
    /// BodyDef::user_data: a number of yours, 0 by default. The engine only keeps it.
    std::uint64_t user_data(BodyId body) const;
    void set_user_data(BodyId body, std::uint64_t data);
    /// Writes the body's touching contacts, newest first, as far as they fit; returns how many there are.
    std::uint32_t contacts(BodyId body, span<ContactInfo> out) const;
    /// Writes the ids of the body's shapes, newest first, as far as they fit; returns how many there are.
    std::uint32_t shapes(BodyId body, span<ShapeId> out) const;
    /// For walking over a body's shapes without memory (ranges.hpp): the next one in the order of shapes(), the first one after null. Returns null after the
    /// last one, and on an error: out_of_range if `shape` is not the body's.
    ShapeId next_shape(BodyId body, ShapeId shape = {}) const;
    /// The same for its touching contacts, in the order of contacts(). `contact` is 0 at first, and then what the last call returned: slot + 1 of the contact
    /// that it wrote to `out`, or 0 after the last one and on an error: out_of_range if `contact` is none of the body's.
    std::uint32_t next_contact(BodyId body, std::uint32_t contact, ContactInfo& out) const;

    // -- shapes ----------------------------------------------------------------------------------------------------------------

    /// Returns null on an error: shapes_full; geometries_full; bad_geometry; not_finite, out_of_range and feature_cut of a field, which find_fault names
    /// (fault.hpp).
    ShapeId create_shape(BodyId body, const Circle& circle, const ShapeDef& def = {});
    ShapeId create_shape(BodyId body, const Capsule& capsule, const ShapeDef& def = {});
    ShapeId create_shape(BodyId body, const Segment& segment, const ShapeDef& def = {});
    ShapeId create_shape(BodyId body, const Polygon& polygon, const ShapeDef& def = {});
    ShapeId create_shape(BodyId body, const ChainSegment& segment, const ShapeDef& def = {});
    /// Static and kinematic bodies only (Error::endless_shape).
    ShapeId create_shape(BodyId body, const HalfSpace& half_space, const ShapeDef& def = {});
    /// A chain of ChainSegments through `points` (2 or more; 3 for a loop), which collides on the right of its direction and does not catch at
    /// its inner corners. All or nothing. Returns the number of segments made, and their ids in `out` as far as they fit;
    /// 0 on an error: bad_chain; shapes_full; geometries_full; endless_shape; those of a ShapeDef.
    std::uint32_t create_chain(BodyId body, span<const Vec2> points, bool loop, const ShapeDef& def = {}, span<ShapeId> out = {});
    /// Destroys the shape and its contacts, and computes the body's mass again.
    void destroy_shape(ShapeId shape);
    /// True if the id names a shape that exists. No id is an error here.
    bool is_valid(ShapeId shape) const;
    /// Number of live shapes.
    std::uint32_t shape_count() const;
    /// Id of the shape in slot 0 <= slot < capacity().shapes; null if the slot is free.
    ShapeId shape_at(std::uint32_t slot) const;
    /// Writes the shape's touching contacts, newest first, as far as they fit; returns how many there are.
    std::uint32_t contacts(ShapeId shape, span<ContactInfo> out) const;
    /// The next of these, as next_contact of a body: out_of_range if `contact` is none of the shape's body.
    std::uint32_t next_contact(ShapeId shape, std::uint32_t contact, ContactInfo& out) const;

    /// The body that the shape belongs to.
    BodyId body(ShapeId shape) const;
    /// Which kind of geometry the shape has.
    ShapeType shape_type(ShapeId shape) const;
    /// The geometry; null if the shape is of another type (which is no error), or if the id is invalid (which is one).
    const Circle* circle(ShapeId shape) const;
    const Capsule* capsule(ShapeId shape) const;
    const Segment* segment(ShapeId shape) const;
    const Polygon* polygon(ShapeId shape) const;
    const ChainSegment* chain_segment(ShapeId shape) const;
    const HalfSpace* half_space(ShapeId shape) const;
    /// Gives the shape another geometry, of any type. Its contacts and overlaps end; the next step finds those of the new geometry. The body's mass is computed
    /// again. Wakes the body and the bodies that touched the shape. Errors: bad_geometry; geometries_full; endless_shape.
    void set_circle(ShapeId shape, const Circle& circle);
    void set_capsule(ShapeId shape, const Capsule& capsule);
    void set_segment(ShapeId shape, const Segment& segment);
    void set_polygon(ShapeId shape, const Polygon& polygon);
    void set_half_space(ShapeId shape, const HalfSpace& half_space);
    void set_chain_segment(ShapeId shape, const ChainSegment& segment);
    /// kg/m^2, >= 0. Setting it computes the body's mass again.
    float density(ShapeId shape) const;
    void set_density(ShapeId shape, float density);
    /// The tight box around the shape, world coordinates.
    Aabb aabb(ShapeId shape) const;
    /// ShapeDef::friction and the three that follow, with their ranges. Setting one of these wakes the body and the bodies that touch the shape.
    float friction(ShapeId shape) const;
    void set_friction(ShapeId shape, float friction);
    float restitution(ShapeId shape) const;
    void set_restitution(ShapeId shape, float restitution);
    float rolling_resistance(ShapeId shape) const;
    void set_rolling_resistance(ShapeId shape, float resistance);
    float tangent_speed(ShapeId shape) const;
    void set_tangent_speed(ShapeId shape, float speed);
    /// All of these at once, and the number of yours (SurfaceMaterial::id).
    SurfaceMaterial material(ShapeId shape) const;
    void set_material(ShapeId shape, const SurfaceMaterial& material);
    /// ShapeDef::sensor. Changing it ends the shape's contacts and overlaps, and wakes the bodies that touched it; the next step finds new ones.
    bool is_sensor(ShapeId shape) const;
    void set_sensor(ShapeId shape, bool sensor);
    /// Writes the shapes that overlap the sensor, as far as they fit; the shape that came near last comes first. Returns how many there are. Error:
    /// not_a_sensor.
    std::uint32_t sensor_overlaps(ShapeId sensor, span<ShapeId> out) const;
    /// ShapeDef::sensor_events, hit_events and pre_solve.
    bool sensor_events_enabled(ShapeId shape) const;
    void enable_sensor_events(ShapeId shape, bool enable);
    bool hit_events_enabled(ShapeId shape) const;
    void enable_hit_events(ShapeId shape, bool enable);
    bool pre_solve_enabled(ShapeId shape) const;
    void enable_pre_solve(ShapeId shape, bool enable);
    /// ShapeDef::one_way; the direction returned is a unit vector, or zero. Setting it wakes the body and the bodies that touch the shape. A body that stands
    /// on the shape goes on standing if it is above in the new direction, too. Errors: those of the id; not_finite; feature_cut.
    Vec2 one_way(ShapeId shape) const;
    void set_one_way(ShapeId shape, Vec2 direction);
    /// Adds the force of a wind on the part of the shape's outline that faces it. Like apply_force, it acts over the next step. The force is rho u^2 / 2 times
    /// width times coefficient, where u is the air's velocity past the shape's middle, the shape's own motion included. It pushes each face of a polygon at
    /// the face's middle; only flat faces have lift. No effect on segments and on bodies that are not dynamic. Shapes do not shield each other.
    void apply_wind(ShapeId shape, const WindDef& wind);
    /// ShapeDef::filter.
    Filter filter(ShapeId shape) const;
    /// Contacts that the new filter forbids end; new ones are found in the next step.
    void set_filter(ShapeId shape, const Filter& filter);
    /// ShapeDef::user_data.
    std::uint64_t user_data(ShapeId shape) const;
    void set_user_data(ShapeId shape, std::uint64_t data);

    // -- contacts --------------------------------------------------------------------------------------------------------------

    /// Pairs of shapes with overlapping fat boxes, touching or not.
    std::uint32_t contact_count() const;
    /// Reads the contact in slot 0 <= slot < capacity().contacts. False if the slot is free or the shapes do not touch.
    bool contact_at(std::uint32_t slot, ContactInfo& out) const;

    // -- joints ----------------------------------------------------------------------------------------------------------------
    //
    // Changing a joint wakes its bodies. A function that does not apply to the type of the joint fails with wrong_joint_type.

    /// Returns null on an error: joints_full; same_body; no_dynamic_body; wrong_joint_type (gears); not_finite and out_of_range of a field, which find_fault
    /// names (fault.hpp).
    JointId create_joint(const RevoluteJointDef& def);
    JointId create_joint(const PrismaticJointDef& def);
    JointId create_joint(const DistanceJointDef& def);
    JointId create_joint(const WeldJointDef& def);
    JointId create_joint(const WheelJointDef& def);
    JointId create_joint(const MotorJointDef& def);
    JointId create_joint(const MouseJointDef& def);
    JointId create_joint(const PulleyJointDef& def);
    JointId create_joint(const GearJointDef& def);
    JointId create_joint(const AngleJointDef& def);
    /// Destroys the joint, and the gears that use it.
    void destroy_joint(JointId joint);
    bool is_valid(JointId joint) const;
    std::uint32_t joint_count() const;
    /// Id of the joint in slot 0 <= slot < capacity().joints; null if the slot is free.
    JointId joint_at(std::uint32_t slot) const;
    /// Writes the ids of the body's joints, newest first, as far as they fit; returns how many there are.
    std::uint32_t joints(BodyId body, span<JointId> out) const;
    /// The next one in this order, the first one after null. Returns null after the last one, and on an error: out_of_range if `joint` does not hang on the
    /// body.
    JointId next_joint(BodyId body, JointId joint = {}) const;

    /// Which kind of joint it is.
    JointType joint_type(JointId joint) const;
    /// Null for mouse joints.
    BodyId body_a(JointId joint) const;
    BodyId body_b(JointId joint) const;
    JointFrame frame_a(JointId joint) const;
    JointFrame frame_b(JointId joint) const;
    /// Moves the joint on its bodies. Not for mouse, pulley and gear joints.
    void set_frames(JointId joint, const JointFrame& frame_a, const JointFrame& frame_b);
    /// m: the frames' points in the world; of a mouse joint the target and the point pulled to it.
    Vec2 anchor_a(JointId joint) const;
    Vec2 anchor_b(JointId joint) const;
    bool collide_connected(JointId joint) const;
    /// Not for mouse and gear joints, which forbid nothing.
    void set_collide_connected(JointId joint, bool collide);
    /// As in JointBase, N and N m; 0: never breaks. A gear has a torque only.
    float break_force(JointId joint) const;
    float break_torque(JointId joint) const;
    void set_break(JointId joint, float force, float torque);
    /// The number of yours that the joint was made with.
    std::uint64_t user_data(JointId joint) const;
    void set_user_data(JointId joint, std::uint64_t data);

    /// The coordinate (joints.hpp): rad of revolute and angle joints, continuous past a full turn; m of the others that have one.
    float joint_position(JointId joint) const;
    /// Its rate, rad/s or m/s; of a wheel joint the strut's.
    float joint_speed(JointId joint) const;
    /// Revolute, prismatic, distance, wheel and angle joints.
    JointSpring spring(JointId joint) const;
    void set_spring(JointId joint, const JointSpring& spring);
    JointLimit limit(JointId joint) const;
    void set_limit(JointId joint, const JointLimit& limit);
    JointMotor motor(JointId joint) const;
    void set_motor(JointId joint, const JointMotor& motor);
    /// Revolute, prismatic, wheel and angle joints. N m or N.
    float joint_friction(JointId joint) const;
    void set_joint_friction(JointId joint, float friction);
    /// Force (N) or torque (N m) of the motor over the last substep.
    float motor_force(JointId joint) const;
    /// Of an angle joint. Setting it forgets the tooth that held. The next one to hold is the last tooth that the angle has passed.
    JointRatchet ratchet(JointId joint) const;
    void set_ratchet(JointId joint, const JointRatchet& ratchet);
    /// Of a distance joint, m.
    float joint_length(JointId joint) const;
    void set_joint_length(JointId joint, float length);
    /// Of weld, motor and mouse joints.
    JointSoftness softness(JointId joint) const;
    void set_softness(JointId joint, const JointSoftness& softness);
    /// Of a motor joint, m/s and rad/s.
    Vec2 joint_linear_velocity(JointId joint) const;
    float joint_angular_velocity(JointId joint) const;
    void set_joint_velocity(JointId joint, Vec2 linear, float angular);
    /// Of motor and mouse joints, N and N m. A mouse joint has a force only.
    float joint_max_force(JointId joint) const;
    float joint_max_torque(JointId joint) const;
    void set_joint_strength(JointId joint, float max_force, float max_torque);
    /// Of a mouse joint, m in the world.
    Vec2 target(JointId joint) const;
    void set_target(JointId joint, Vec2 target);

    /// The fixed points of a pulley, m in the world. Setting them measures the rope anew, so it fits the bodies' places now.
    Vec2 ground_a(JointId joint) const;
    Vec2 ground_b(JointId joint) const;
    void set_grounds(JointId joint, Vec2 ground_a, Vec2 ground_b);
    /// Of a pulley or a gear, in the range of its definition. Setting it measures the rope, or the gear's angle, anew.
    float joint_ratio(JointId joint) const;
    void set_joint_ratio(JointId joint, float ratio);
    /// The two joints of a gear.
    JointId joint1(JointId gear) const;
    JointId joint2(JointId gear) const;

    /// What the joint did to body B over the last substep: force in N, torque about B's anchor in N m. A gets the opposite (a pulley's A is pulled
    /// along its own rope). A gear has no force, and its torque is that on body B of joint 1 (N along the axis if joint 1 is prismatic); body B of joint 2
    /// gets ratio times as much.
    Vec2 joint_force(JointId joint) const;
    float joint_torque(JointId joint) const;
    /// How far apart the joint has been pulled now.
    JointError joint_error(JointId joint) const;

    // -- queries (query.hpp) -----------------------------------------------------------------------------------------------------
    //
    // Queries see the poses of the last step, and those set since. They change nothing and need no memory. The order in which shapes were made and moved does
    // not matter: hits come in the order of their fractions, those of equal fractions in the order of their shapes' slots, and overlaps in the order of their
    // slots. With good arguments, any number of threads may query at once, as long as none changes the world. On an error a query finds nothing: feature_cut;
    // bad_geometry of a proxy; not_finite; out_of_range for points and corners beyond max_position, and translations beyond max_translation.
    //
    // Rays and casts meet chain segments from their outer side only. To overlap and distance queries, chain segments are thin lines.

    /// The first shape that a ray from `origin` to `origin + translation` (m) meets. A ray that starts inside a shape meets it at fraction 0 (islet::cast_ray).
    QueryHit cast_ray(Vec2 origin, Vec2 translation, const QueryFilter& filter = {}) const;
    /// Whether the ray (m) meets any shape. Faster than the first shape where many are in the way.
    bool cast_ray_any(Vec2 origin, Vec2 translation, const QueryFilter& filter = {}) const;
    /// Writes the hits of the ray, as far as they fit, first ones first; returns how many there are.
    std::uint32_t cast_ray_all(Vec2 origin, Vec2 translation, span<QueryHit> out, const QueryFilter& filter = {}) const;
    /// Calls `visit`, unless null, for each hit of the ray (m) until `visit` stops the cast (CastVisitor).
    void cast_ray_each(Vec2 origin, Vec2 translation, const QueryFilter& filter, CastVisitor visit, void* context) const;
    /// The same for a shape that starts where its proxy stands in the world, and moves by `translation` (m) without turning (islet::cast_shape).
    QueryHit cast_shape(const ShapeProxy& shape, Vec2 translation, const QueryFilter& filter = {}) const;
    bool cast_shape_any(const ShapeProxy& shape, Vec2 translation, const QueryFilter& filter = {}) const;
    std::uint32_t cast_shape_all(const ShapeProxy& shape, Vec2 translation, span<QueryHit> out, const QueryFilter& filter = {}) const;
    void cast_shape_each(const ShapeProxy& shape, Vec2 translation, const QueryFilter& filter, CastVisitor visit, void* context) const;

    /// Writes the shapes whose tight box (aabb) overlaps `box`, as far as they fit; returns how many there are. bad_geometry unless lower <= upper.
    std::uint32_t overlap_box(const Aabb& box, span<ShapeId> out, const QueryFilter& filter = {}) const;
    /// The same for shapes that share a point with `shape`, which stands in the world.
    std::uint32_t overlap_shape(const ShapeProxy& shape, span<ShapeId> out, const QueryFilter& filter = {}) const;
    /// The same for shapes that contain the point (m); segments contain none.
    std::uint32_t overlap_point(Vec2 point, span<ShapeId> out, const QueryFilter& filter = {}) const;
    /// Call `visit`, unless null, for each such shape until it returns false. Boxes, shapes and points in m.
    void overlap_box_each(const Aabb& box, const QueryFilter& filter, OverlapVisitor visit, void* context) const;
    void overlap_shape_each(const ShapeProxy& shape, const QueryFilter& filter, OverlapVisitor visit, void* context) const;
    void overlap_point_each(Vec2 point, const QueryFilter& filter, OverlapVisitor visit, void* context) const;

    /// The shape closest to `point`, no farther than max_distance (m, 0 to max_translation). Of equally close ones it is the one in the lowest slot.
    ClosestHit closest(Vec2 point, float max_distance, const QueryFilter& filter = {}) const;
    /// Writes the surfaces no farther than `within` (m, 0 to max_translation) from a shape in the world, as far as they fit, and returns how many there are.
    /// The closest come first, beginning with the deepest overlap; equally close ones come in the order of their slots. A chain segment has a surface only on
    /// its outer side. It is left out if the shape is on its inner side, by the mean of the shape's corners or by the direction to the shape's closest point.
    std::uint32_t surfaces_near(const ShapeProxy& shape, float within, span<Surface> out, const QueryFilter& filter = {}) const;

    // -- islands (island.hpp) ----------------------------------------------------------------------------------------------------

    /// Writes to `memory` the complementarity problem of a dynamic body's island as it stands now, for a substep of h seconds, min_time_step / 64 <= h <= 1,
    /// and points `out` to it. Returns the bytes needed; if `memory` has fewer, writes neither to it nor to `out`. `memory` needs no alignment.
    ///
    /// Every body of the island gives the same problem, asleep or awake. Contacts have the normals and arms that the last step found, even if a centre of mass
    /// has moved since. Motion locks are left out. The problem is not part of the state: hashes do not contain it, and solving it changes no body. The function
    /// uses the world's scratch memory, so no other call to the world may run at the same time. Extreme masses may give numbers that overflow; lcp::solve then
    /// says not_finite. Returns 0 on an error: null_id; stale_id; no_dynamic_body; bad_time_step of h; in_step; out_of_range if there are more than
    /// lcp::max_rows rows or 2^32 - 1 entries.
    std::size_t export_island(BodyId body, float h, span<std::byte> memory, IslandProblem& out) const;

    // -- drawing (debug_draw.hpp) ------------------------------------------------------------------------------------------------

    /// Draws the parts of the world that `draw` asks for with draw's functions. On an error it calls none of them: not_finite or out_of_range of draw's view,
    /// size or scale; in_step. No other drawing of the world may run at the same time. BodyColors::island uses the world's scratch memory: with it, no other
    /// call to the world may run at the same time.
    void draw(const DebugDraw& draw) const;
    /// Draws one shape with draw's functions, as if its body were at `pose`. The other settings of `draw` have no effect.
    void draw_shape(const DebugDraw& draw, ShapeId shape, const Transform& pose, const DrawStyle& style) const;

private:
    friend struct detail::Core;
    friend World& detail::create_static(std::byte* block, const Capacity& capacity, const detail::Layout& layout, const WorldDef& def, detail::LaidOut);
    World() = default;
    ~World() = default;
    detail::Core& core();
    const detail::Core& core() const;

    alignas(2 * sizeof(void*)) std::byte core_[detail::core_bytes];
};

static_assert(sizeof(World) <= detail::host_bytes);

/// A world with its memory inside: for static storage, the stack or a member. There is no world before create() is called. The numbers are those of Capacity.
template <std::uint32_t bodies, std::uint32_t shapes, std::uint32_t contacts, std::uint32_t joints = 0, std::uint32_t geometries = 0, std::uint32_t hits = 0,
          std::uint32_t events = 0>
class StaticWorldOf {
    static constexpr Capacity capacity = {bodies, shapes, contacts, joints, geometries, hits, events};
    static_assert(is_valid(capacity), "bodies, shapes and contacts must be above 0, and nothing above max_capacity");

public:
    StaticWorldOf() = default;
    StaticWorldOf(const StaticWorldOf&) = delete;
    StaticWorldOf& operator=(const StaticWorldOf&) = delete;

    /// Creates the world. An earlier world in this memory is lost. If the definition breaks a rule, the world gets the default one, and World::last_error says
    /// what was wrong. If the engine was compiled in a way that changes the bits (inexact_build), the world takes no step.
    World& create(const WorldDef& def = {}) { return detail::create_static(block_, capacity, layout, def); }
    /// The world that create() has made. Before that there is none.
    World& get() { return *__builtin_launder(reinterpret_cast<World*>(block_)); }
    const World& get() const { return *__builtin_launder(reinterpret_cast<const World*>(block_)); }
    static constexpr std::size_t bytes = world_bytes(capacity);

private:
    static constexpr detail::Layout layout = detail::layout_of(capacity);
    alignas(world_alignment) std::byte block_[bytes];
};

#if ISLET_CPP20
/// The same with the numbers by name: StaticWorld<Capacity{.bodies = 64, .shapes = 64, .contacts = 256}>. Needs C++20.
template <Capacity C>
class StaticWorld : public StaticWorldOf<C.bodies, C.shapes, C.contacts, C.joints, C.geometries, C.hits, C.events> {};
#endif

}  // namespace islet
ISLET_API_END
