// The records in the world's block: fixed-width fields, explicit padding, indices instead of pointers. Hot and cold data are apart.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "../data/features.hpp"
#include "../math/inlining.hpp"
#include "../math/scalar.hpp"
#include "../memory/pool.hpp"
#include "islet/geometry.hpp"
#include "islet/joints.hpp"
#include "islet/layout.hpp"
#include "islet/types.hpp"

namespace islet::detail {

enum PoseFlags : std::uint32_t {
    pose_fast = 1u,     // may move so far in this step that its contacts look further ahead
    pose_leaves = 8u,   // within a step: may leave its fat boxes
    pose_far = 32u,     // within a step: may come farther than its surroundings
    pose_deep = 16u,    // within a step: has sunk so deep into what does not give way that it might be pressed through, however slowly
    pose_moved = 2u,    // a fat box of it changed since contacts were last updated
    pose_learns = 64u,  // its island has just come to rest: in the next step its contacts learn their loads
    pose_alone = 4u,    // within a step: nothing at rest is in its surroundings (broadphase/pairs.hpp)
};

/// Where a body is and how heavy: eight words, loaded at once by the narrow phase and the solver.
struct Pose {
    Vec2 center;  // m, centre of mass in the world
    Rot q;
    float inv_mass = 0;       // 1/kg, 0 unless dynamic
    float inv_inertia = 0;    // 1/(kg m^2)
    float max_extent = 0;     // m, from the centre of mass to the farthest point of the body's shapes
    std::uint32_t flags = 0;  // PoseFlags
};

/// How a body moves.
struct Motion {
    Vec2 v;                // m/s, of the centre of mass
    float w = 0;           // rad/s
    float slack = 0;       // m the body may still move before one of its shapes could leave its fat box
    Vec2 force;            // N, for the next step
    float torque = 0;      // N m
    float sleep_time = 0;  // s at rest
};

enum BodyFlags : std::uint32_t {
    body_type_mask = 3u,  // BodyType
    body_fixed_rotation = 4u,
    body_may_sleep = 8u,
    body_bullet = 16u,    // does not pass through moving bodies either
    body_disabled = 32u,  // takes part in nothing
    body_lock_x = 64u,    // its centre of mass does not move along the axis
    body_lock_y = 128u,
    body_all_flags = 255u,
};

struct Body {
    Vec2 origin;        // m, of the body frame in the world
    Vec2 local_center;  // m
    float linear_damping = 0, angular_damping = 0, gravity_scale = 1, sleep_threshold = 0;
    float mass = 0, inertia = 0;  // kg, kg m^2 about the centre of mass
    float min_extent = 0;         // m, smallest half-thickness of its shapes
    std::uint32_t flags = 0;
    std::uint32_t shape_head = null_index;
    std::uint32_t contact_head = 0;  // contact key: contact * 2 + side + 1; 0 ends the list
    std::uint32_t shape_count = 0;
    std::uint32_t contact_count = 0;
    std::uint32_t colors = 0;  // bit i: one of its constraints has colour i
    std::uint32_t generation = 0;
    std::uint64_t user_data = 0;
    std::uint32_t next_free = null_index;
    std::uint32_t joint_head = 0;  // joint key, as contact_head
    std::uint32_t joint_count = 0;
    float stretch = 0;  // kg m^2: h^2 times the geometric stiffness of the joints that pull at it (free_motion.hpp)

    BodyType type() const { return static_cast<BodyType>(flags & body_type_mask); }
    bool has_locks() const { return (flags & (body_lock_x | body_lock_y)) != 0; }
};

enum ShapeFlags : std::uint32_t {
    shape_sensor = 1u,  // reports overlaps, collides with nothing
    shape_unseen = 2u,  // sensors do not see it
    shape_hit_events = 4u,
    shape_pre_solve = 8u,        // the pre-solve hook is asked about its contacts
    shape_single_bits = 15u,     // those above
    asked_one_way = 16u,         // in State::asked alone: some shape was one-way
    asked_breaks = 32u,          // there, too: some joint could break
    asked_sharing = 64u,         // two bodies touched in several contacts with nearly the same normal
    shape_one_way_bits = ~255u,  // ShapeDef::one_way, x and y of 12 bits each (flags_of_direction); 0: no one-way shape
};

struct Shape {
    std::uint32_t geometry = 0;
    std::uint32_t body = 0;
    std::uint32_t next = null_index, prev = null_index;  // among the body's shapes
    std::uint32_t tree_node = null_index;                // leaf in the tree of resting shapes, or null while the body is awake
    float friction = 0, restitution = 0, rolling_resistance = 0, tangent_speed = 0, density = 0;
    Filter filter;
    std::uint32_t generation = 0;
    float margin = 0;  // m, by which the fat box exceeds the tight one
    std::uint32_t next_free = null_index;
    std::uint64_t user_data = 0;
    std::uint32_t flags = 0;     // ShapeFlags
    std::uint32_t material = 0;  // the user's id
};

/// What State::asked keeps of a shape's flags.
inline std::uint32_t asked_of(std::uint32_t flags) {
    return (flags & shape_single_bits) | ((flags & shape_one_way_bits) != 0 ? std::uint32_t{asked_one_way} : 0u);
}

/// Packs the direction of a one-way shape into its flags, to 1/1000 rad, exactly if it is along an axis; and unpacks it, unit or zero.
inline std::uint32_t flags_of_direction(Vec2 unit) {
    const auto bits = [](float a) { return static_cast<std::uint32_t>(static_cast<std::int32_t>(1024.0f * a + (a < 0 ? -0.5f : 0.5f))); };
    return (bits(unit.x) & 0xfffu) << 8 | bits(unit.y) << 20;
}
inline Vec2 direction_of_flags(std::uint32_t flags) {
    return normalize(Vec2{static_cast<float>(static_cast<std::int32_t>(flags << 12) >> 20), static_cast<float>(static_cast<std::int32_t>(flags) >> 20)});
}

/// A geometry, stored once however many shapes share it.
struct Geometry {
    std::uint32_t type = 0;  // ShapeType
    std::uint32_t references = 0;
    std::uint32_t hash = 0;
    std::uint32_t next = null_index;  // in its bucket; in the free list while unused
    union {
#define ISLET_MEMBER(name, Type, ...) Type name;
        ISLET_SHAPE_TYPES(ISLET_MEMBER)
#undef ISLET_MEMBER
        std::uint32_t words[36];
    };
    Geometry() : words{} {}

    ShapeType shape_type() const { return known(static_cast<ShapeType>(type)); }
};

enum ContactFlags : std::uint32_t {
    contact_touching = 1u,
    contact_posed = 2u,          // the manifold was made once: it may be recycled
    contact_special = 4u,        // has rolling resistance or a tangent speed
    contact_bouncy = 8u,         // has restitution
    contact_count_shift = 4,     // 2 bits: manifold points
    contact_sensor = 64u,        // one of the shapes is a sensor: no points, never solved
    contact_overlap = 128u,      // the sensor and the other shape overlap
    contact_color_shift = 8,     // 8 bits: colour, or no_color
    contact_hits = 1u << 16,     // tells of hits
    contact_asks = 1u << 17,     // the pre_solve hook is asked
    contact_one_way = 1u << 18,  // one of the shapes is a one-way shape
    contact_passes = 1u << 19,   // it lets the other shape pass
    contact_dropped = 1u << 20,  // it lets the other shape pass because the hook said so
    contact_ahead = 1u << 21,    // the shapes come together fast: solved harder
    contact_untold = 1u << 22,   // made so far ahead that it is not said to touch before it does
    contact_sharers_shift = 23,  // 2 bits: in how many other contacts with nearly its normal its two moving bodies touch, at most 3
    contact_rolls = 1u << 25,    // a round shape rolls: the manifold was made for the middle of the step, and is not recycled
};
inline constexpr std::uint32_t no_color = 0xff;

/// An index in a contact: half as wide in the small profile. Images have 32 bits for it everywhere (state/image_records.hpp).
using ContactIndex = std::conditional_t<index_bytes == 2, std::uint16_t, std::uint32_t>;
static_assert(index_bytes == sizeof(ContactIndex) && (index_bytes == 4 || (ISLET_SMALL && max_lanes == 1)), "ISLET_INDEX_BITS");

/// Two shapes whose fat boxes overlap, and the place of their contact in the lists of both bodies.
template <class Index>
struct ContactWith {
    using Key = Index;

    Index shape_a = static_cast<Index>(null_index), shape_b = static_cast<Index>(null_index);
    Key next[2] = {0, 0}, prev[2] = {0, 0};  // contact keys, in the lists of the two bodies
    std::uint32_t generation = 0;
    union {
        std::uint32_t next_free = null_index;  // of a free slot
        std::uint32_t own_speed_bits;          // of a contact: the tangent speed (m/s) that the pre_solve hook gave it, or no_own_speed
    };
    static constexpr std::uint32_t no_own_speed = 0xffffffffu;  // the bits of no finite number

    bool has_own_speed() const { return own_speed_bits != no_own_speed; }
    float own_speed() const { return __builtin_bit_cast(float, own_speed_bits); }
    void set_own_speed(float speed) { own_speed_bits = __builtin_bit_cast(std::uint32_t, speed); }
    void forget_own_speed() { own_speed_bits = no_own_speed; }
};
using Contact = ContactWith<ContactIndex>;

/// What the narrow phase found and the solver keeps. Directions are the world's at the moment the manifold was made; the two rotations and the offset
/// say how the bodies stood then, so that a later step can work out how far each point has slipped since. Groups of eight and four words are
/// loaded in lanes.
template <class Index>
struct ManifoldWith {
    Index body_a = 0, body_b = 0;
    std::uint32_t flags = 0;  // ContactFlags
    std::uint32_t ids = 0;    // feature ids of the two points, 16 bits each

    Vec2 normal;  // unit, from A to B
    Vec2 offset;  // m, from A's centre to B's
    Rot rotation_a, rotation_b;

    Vec2 anchors[2];  // m, contact points relative to A's centre
    float normal_impulse[2] = {0, 0};
    float tangent_impulse[2] = {0, 0};

    union {
        float rolling_impulse = 0;  // N m s, of a special contact
        float load;                 // N, of any other: what it has carried lately
    };
    float separation[2] = {0, 0};  // m, when the manifold was made
    float friction = 0;

    ISLET_INLINE std::uint32_t count() const { return flags >> contact_count_shift & 3u; }
    ISLET_INLINE std::uint32_t color() const { return flags >> contact_color_shift & 0xffu; }
    ISLET_INLINE std::uint32_t sharers() const { return 1 + (flags >> contact_sharers_shift & 3u); }
    void set_color(std::uint32_t color) { flags = (flags & ~(0xffu << contact_color_shift)) | color << contact_color_shift; }
    void set_sharers(std::uint32_t count) {
        const std::uint32_t others = count == 0 ? 0 : count < 4 ? count - 1 : 3;
        flags = (flags & ~(3u << contact_sharers_shift)) | others << contact_sharers_shift;
    }
    void forget_points() {  // and made anew in the next step
        flags &= ~(std::uint32_t{3} << contact_count_shift | contact_posed | contact_ahead | contact_rolls);
        separation[0] = separation[1] = 0;
    }
    void forget_impulses() { normal_impulse[0] = normal_impulse[1] = tangent_impulse[0] = tangent_impulse[1] = rolling_impulse = 0; }
};
using ContactManifold = ManifoldWith<ContactIndex>;

/// The user knows that the two shapes touch.
inline bool is_told(const ContactManifold& m) { return (m.flags & (contact_touching | contact_untold)) == contact_touching; }

enum JointFlags : std::uint32_t {
    joint_spring = 1u,
    joint_limit = 2u,
    joint_motor = 4u,
    joint_collide = 8u,     // the two bodies' shapes collide with each other
    joint_exact = 16u,      // solved exactly, in a tree of hinges
    joint_anchor = 32u,     // of these, one that holds a tree at a static or kinematic body which another one holds already
    joint_loaded = 64u,     // a hinge with a limit, a motor or friction that bears so much that its tree is solved exactly
    joint_color_shift = 8,  // 8 bits: colour, or no_color
    joint_calm = 1u << 16,  // times 0 to 15: for so many steps on end a loaded hinge has borne little
    joint_calm_bits = 15 * joint_calm,
    joint_torn = 1u << 20,   // bore too much in a substep; broken at the end of the step
    joint_moved = 1u << 21,  // a call has put its bodies apart, and they have not come together yet
};

/// A joint. Which fields mean something depends on its type.
struct Joint {
    using Key = std::uint32_t;

    std::uint32_t type = 0;                                  // JointType
    std::uint32_t flags = 0;                                 // JointFlags
    std::uint32_t body_a = null_index, body_b = null_index;  // a mouse joint has no A
    Key next[2] = {0, 0}, prev[2] = {0, 0};                  // joint keys (joint * 2 + side + 1), in the lists of the two bodies
    std::uint32_t generation = 0;
    std::uint32_t next_free = null_index;
    std::uint32_t joint1 = null_index, joint2 = null_index;  // gear

    Vec2 local_a, local_b;  // m from the bodies' origins; a mouse joint's A: the target, world
    Rot frame_a, frame_b;
    float break_force = 0, break_torque = 0;  // 0: never
    float spring_hertz = 0, spring_damping_ratio = 0, target = 0;
    float lower = 0, upper = 0;
    float motor_speed = 0, motor_max = 0;  // of a motor joint: angular velocity, greatest force
    float friction = 0;
    float length = 0;      // distance: of the rod; pulley, gear: the constant; angle: the ratchet's step
    union {                // by type
        float ratio = 0;   // pulley, gear
        float limit_load;  // of joints with a limit: N s or N m s over a substep, without the joint's own motor (constraint/coordinate.hpp)
    };
    float linear_hertz = 0, linear_damping_ratio = 0, angular_hertz = 0, angular_damping_ratio = 0;  // weld, motor, mouse
    Vec2 velocity;            // motor; angle: the ratchet's phase, and the angle at which it holds (constraint/angle_joint.hpp)
    float max_torque = 0;     // motor
    Vec2 ground_a, ground_b;  // pulley

    float coordinate = 0;          // rad, revolute: near its angle after the last step, past full turns
    std::uint32_t gear_count = 0;  // gears that use it

    // Accumulated impulses of the last substep, which the next step starts from; constraint/ says what each joint keeps where.
    Vec2 impulse;
    float angular_impulse = 0;
    float spring_impulse = 0, motor_impulse = 0, friction_impulse = 0, lower_impulse = 0, upper_impulse = 0;
    Vec2 force_impulse;        // N s on B, for readers
    float torque_impulse = 0;  // N m s on B about its anchor
    std::uint64_t user_data = 0;

    void forget_impulses() {
        impulse = force_impulse = {0, 0};
        angular_impulse = spring_impulse = motor_impulse = friction_impulse = lower_impulse = upper_impulse = torque_impulse = 0;
        if ((flags & joint_limit) != 0) limit_load = 0;
    }
    ISLET_INLINE bool can_break() const { return break_force > 0 || break_torque > 0; }
    JointType joint_type() const { return known(static_cast<JointType>(type)); }
    ISLET_INLINE std::uint32_t color() const { return flags >> joint_color_shift & 0xffu; }
    void set_color(std::uint32_t color) { flags = (flags & ~(0xffu << joint_color_shift)) | color << joint_color_shift; }
};

/// A node of a bounding-box tree; see broadphase/tree.hpp.
struct TreeNode {
    Aabb box;
    std::uint32_t parent = null_index;
    std::uint32_t child1 = null_index;  // a leaf has none
    std::uint32_t child2 = null_index;  // a leaf keeps its shape here
    std::uint32_t height = 0;
};

struct TreeState {
    std::uint32_t root = null_index;
    std::uint32_t free_head = null_index;
    std::uint32_t high_water = 0;
    std::uint32_t leaf_count = 0;
};

/// SolverDef in words of fixed width, without padding.
struct SolverState {
    std::uint32_t schedule = 0;  // Schedule
    std::uint32_t substeps = 0, iterations = 0, relax_iterations = 0;
    float contact_hertz = 0, contact_damping_ratio = 0, contact_push_speed = 0;
    float joint_hertz = 0, joint_damping_ratio = 0;
    float baumgarte = 0, omega = 0;
    std::uint32_t warm_start = 0;
    std::uint32_t joint_trees = 0;  // JointTrees
    float joint_tree_load = 0;
    std::uint32_t sweep_order = 0;  // SweepOrder
    std::uint32_t block_contacts = 0;
    float shock = 0;
    std::uint32_t measure_residual = 0;
    float tolerance = 0;
};

// clang-format off
ISLET_SHARED SolverState pack(const SolverDef& d) {
    return {static_cast<std::uint32_t>(d.schedule), d.substeps, d.iterations, d.relax_iterations,
            d.contact_hertz, d.contact_damping_ratio, d.contact_push_speed, d.joint_hertz, d.joint_damping_ratio,
            d.baumgarte, d.omega, d.warm_start ? 1u : 0u, static_cast<std::uint32_t>(d.joint_trees), d.joint_tree_load,
            static_cast<std::uint32_t>(d.sweep_order), d.block_contacts ? 1u : 0u, d.shock, d.measure_residual ? 1u : 0u, d.tolerance};
}

inline SolverDef unpack(const SolverState& s) {
    return {static_cast<Schedule>(s.schedule), s.substeps, s.iterations, s.relax_iterations,
            s.contact_hertz, s.contact_damping_ratio, s.contact_push_speed, s.joint_hertz, s.joint_damping_ratio,
            s.baumgarte, s.omega, s.warm_start != 0, static_cast<JointTrees>(s.joint_trees), s.joint_tree_load,
            static_cast<SweepOrder>(s.sweep_order), s.block_contacts != 0, s.shock, s.measure_residual != 0, s.tolerance};
}
// clang-format on

inline bool is_soft(const SolverState& s) { return static_cast<Schedule>(s.schedule) == Schedule::soft; }
/// What only some programs ask for: feature `tuning` (islet/config.hpp).
inline bool is_ordered(const SolverState& s) {  // contacts are solved one by one, and not by colours
    return has_tuning && (static_cast<SweepOrder>(s.sweep_order) != SweepOrder::colored || s.block_contacts != 0);
}
inline bool has_shock(const SolverState& s) { return has_tuning && is_positive(s.shock); }
inline bool measures_residual(const SolverState& s) { return has_tuning && (s.measure_residual != 0 || is_positive(s.tolerance)); }
inline bool needs_ordering(const SolverDef& d) { return d.sweep_order != SweepOrder::colored || d.block_contacts || d.shock > 0; }
inline bool needs_tuning(const SolverDef& d) { return needs_ordering(d) || d.measure_residual || d.tolerance > 0; }

/// Everything persistent that is not in an array.
struct State {
    PoolState body_pool, shape_pool, contact_pool, geometry_pool, joint_pool;  // 60
    TreeState tree;                                                            // 16
    Vec2 gravity;
    float restitution_threshold = 1;
    float max_speed = 400;  // 16
    SolverState solver;     // 76
    std::uint32_t enable_sleep = 1;
    std::uint32_t moved_count = 0;  // shapes whose fat box changed since pairs were last found
    std::uint64_t steps = 0;
    float last_substep = 0;             // s; impulses kept for warm starting belong to a substep of this length
    std::uint32_t trees_stale = 0;      // 1: something that decides which joints are solved exactly has changed
    std::uint32_t exact_joints = 0;     // how many are
    std::uint32_t continuous = 1;       // 1: fast bodies are followed
    std::uint32_t bullet_count = 0;     // bodies that are bullets
    float hit_threshold = 1;            // m/s
    std::uint32_t locked_count = 0;     // bodies with a lock
    std::uint32_t asked = 0;            // asked_of the flags that any shape ever had, asked_breaks, asked_sharing
    std::uint32_t catching_floors = 0;  // 1: bodies may catch at the edges between the pieces of a floor
    std::uint32_t pad[9] = {};
};

// The block is the same on every processor. On 32-bit x86 a struct aligns a 64-bit member to 4 bytes only, elsewhere to 8: each stands at a multiple
// of 8 by the fields before it, and each struct ends at one, so that no compiler adds padding of its own. Counted in words of 4 bytes.
static_assert(offsetof(Body, user_data) == 4 * 18 && sizeof(Body) == 4 * 24);
static_assert(offsetof(Shape, user_data) == 4 * 16 && sizeof(Shape) == 4 * 20);
static_assert(offsetof(Joint, user_data) == 4 * 56 && sizeof(Joint) == 4 * 58);
static_assert(offsetof(State, steps) == 4 * 44 && sizeof(State) == 4 * 64);

// The other records have words of 4 bytes alone; where their parts stand.
static_assert(offsetof(Pose, inv_mass) == 4 * 4 && offsetof(Pose, flags) == 4 * 7 && sizeof(Pose) == 4 * 8);
static_assert(offsetof(Motion, force) == 4 * 4 && offsetof(Motion, sleep_time) == 4 * 7 && sizeof(Motion) == 4 * 8);
static_assert(offsetof(Geometry, words) == 4 * 4 && sizeof(Geometry) == 4 * 40);
using ImageContact = ContactWith<std::uint32_t>;
using ImageManifold = ManifoldWith<std::uint32_t>;
static_assert(offsetof(ImageContact, generation) == 4 * 6 && sizeof(ImageContact) == 4 * 8);
static_assert(offsetof(ImageManifold, normal) == 4 * 4 && offsetof(ImageManifold, anchors) == 4 * 12 && sizeof(ImageManifold) == 4 * 24);
static_assert(offsetof(TreeNode, parent) == 4 * 4 && sizeof(TreeNode) == 4 * 8);
static_assert(offsetof(State, tree) == 4 * 15 && offsetof(State, solver) == 4 * 23 && offsetof(State, moved_count) == 4 * 43);

}  // namespace islet::detail
