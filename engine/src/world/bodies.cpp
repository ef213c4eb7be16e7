// The public functions on bodies.
#include "../exact.hpp"

#include "../bodies/bounds.hpp"
#include "../bodies/impulses.hpp"
#include "../bodies/jam.hpp"
#include "../bodies/joint_changes.hpp"
#include "../bodies/sleep.hpp"
#include "../broadphase/pairs.hpp"
#include "../calls/checks.hpp"
#include "../calls/recorder.hpp"
#include "../graph/contacts.hpp"
#include "../graph/joint_graph.hpp"
#include "../island/joint_trees.hpp"
#include "../math/float_mode.hpp"
#include "../step/continuous.hpp"
#include "../world/shapes.hpp"

namespace islet {

using namespace detail;

namespace {

bool check_def(const Core& core, const BodyDef& d) {
    const bool finite = all_finite(d.position.x, d.position.y, d.angle, d.linear_velocity.x, d.linear_velocity.y, d.angular_velocity, d.linear_damping,
                                   d.angular_damping, d.gravity_scale, d.sleep_threshold);
    return check_open(core) && check(core, finite, Error::not_finite) && check_position(core, d.position) &&
           check(core, d.linear_damping >= 0 && d.angular_damping >= 0 && d.sleep_threshold >= 0 && d.type <= BodyType::dynamic, Error::out_of_range) &&
           check_there(core, has_sleep || d.awake) && check_there(core, !d.bullet || has_bullets) && check_there(core, d.enabled || has_disabling);
}

// The calls that push stand in the table in this order: at a point, to the centre of mass, turning; first forces, then impulses. Those that wake no body have
// `wake` as one argument more.
constexpr bool is_force(Call push) { return push <= Call::apply_torque; }
constexpr bool is_turn(Call push) { return push == Call::apply_torque || push == Call::apply_angular_impulse; }
constexpr Call without_waking(Call push) {
    return static_cast<Call>(static_cast<std::uint32_t>(push) + static_cast<std::uint32_t>(Call::apply_force_no_wake) -
                             static_cast<std::uint32_t>(Call::apply_force));
}
template <Call call, class... Args>
constexpr bool are_pushes = __is_same(typename SignatureOf<call>::Type, Signature<BodyId, Args...>) &&
                            __is_same(typename SignatureOf<without_waking(call)>::Type, Signature<BodyId, Args..., bool>);
static_assert(are_pushes<Call::apply_force, Vec2, Vec2> && are_pushes<Call::apply_force_to_center, Vec2> && are_pushes<Call::apply_torque, float>);
static_assert(are_pushes<Call::apply_linear_impulse, Vec2, Vec2> && are_pushes<Call::apply_linear_impulse_to_center, Vec2> &&
              are_pushes<Call::apply_angular_impulse, float>);
static_assert(without_waking(Call::apply_angular_impulse) == Call::apply_angular_impulse_no_wake);

[[maybe_unused]] ISLET_NEVER_INLINE ISLET_COLD void note_push(Core& core, Call call, BodyId id, Vec2 push, float turn, const Vec2* point, bool wake) {
    const void* const pushed = is_turn(call) ? static_cast<const void*>(&turn) : &push;
    const void* const arguments[] = {&id, pushed, point != nullptr ? static_cast<const void*>(point) : &wake, &wake};
    write_call(core, wake ? call : without_waking(call), arguments);
}

// Where a heavy force pulls at a body, its hinges will bear it in the next step.
void expect_load(Core& core, std::uint32_t i) {
    const Vec2 force = core.motions[i].force;
    if (!has_exact_angles || (force.x == 0 && force.y == 0)) return;
    for_each_joint(core, i, [&](std::uint32_t joint, std::uint32_t) {
        Joint& j = core.joints[joint];
        if (!has_acting_angle(j) || (j.flags & joint_loaded) != 0 || !(load_of(core, j, force, 0) > heavy_load)) return;
        j.flags |= joint_loaded;
        core.state->trees_stale = 1;
    });
}

/// Pushes a body; no effect on a body that cannot be pushed. What turns it is `turn`, or, if a point is given, `push` at this point.
void act_on(Core& core, Call call, BodyId id, Vec2 push, float turn, const Vec2* point, bool wake) {
    if constexpr (has_recorder)
        if (core.recording != nullptr) [[unlikely]]
            note_push(core, call, id, push, turn, point, wake);
    if (!check_finite(core, push) || !check_finite(core, turn) || (point != nullptr && !check_finite(core, *point))) return;
    const std::uint32_t i = find_slot(core, id);
    if (i == null_index || !is_pushable(core, i) || !wake_if(core, i, wake)) return;
    if (point != nullptr) turn = cross(*point - core.poses[i].center, push);
    if (is_force(call)) {
        pull(core, i, push, turn);
        expect_load(core, i);
    } else {
        kick(core, i, push, turn);
    }
}

void teleport(Core& core, std::uint32_t body, const Transform& pose) {
    end_contacts(core, body);
    wake_island(core, body, core.arena());
    for_each_joint(core, body, [&](std::uint32_t joint, std::uint32_t) { core.joints[joint].flags |= joint_moved; });
    const bool at_rest = !core.is_awake(body);
    if (at_rest) unrest_shapes(core, body);
    core.bodies[body].origin = pose.p;
    core.poses[body].q = pose.q;
    core.poses[body].center = transform_point(body_transform(core, body), core.bodies[body].local_center);
    update_boxes(core, body, true);
    if (at_rest) rest_shapes(core, body);
}

}  // namespace

BodyId World::create_body(const BodyDef& def) {
    Core& c = core();
    note_call<Call::create_body>(c, def);
    const DefaultFloatMode mode;
    if (!check_def(c, def)) return {};
    const std::uint32_t i = pool_take(c.state->body_pool, c.bodies, c.capacity.bodies);
    if (i == null_index) {
        c.fail(Error::bodies_full);
        return {};
    }
    Body& b = c.bodies[i];
    clear_slot(b);
    b.origin = def.position;
    b.linear_damping = def.linear_damping;
    b.angular_damping = def.angular_damping;
    b.gravity_scale = def.gravity_scale;
    b.sleep_threshold = def.sleep_threshold;
    b.flags = static_cast<std::uint32_t>(def.type) | (def.fixed_rotation ? std::uint32_t{body_fixed_rotation} : 0u) |
              (def.enable_sleep ? std::uint32_t{body_may_sleep} : 0u) | (def.bullet ? std::uint32_t{body_bullet} : 0u) |
              (def.lock_x ? std::uint32_t{body_lock_x} : 0u) | (def.lock_y ? std::uint32_t{body_lock_y} : 0u) |
              (def.enabled ? 0u : std::uint32_t{body_disabled});
    if (b.has_locks()) ++c.state->locked_count;
    if (def.bullet) ++c.state->bullet_count;
    b.user_data = def.user_data;
    c.poses[i] = Pose{};
    c.poses[i].center = def.position;
    c.poses[i].q = make_rot(def.angle);
    c.motions[i] = Motion{};
    const bool moves = def.type != BodyType::static_body;
    if (moves) {
        c.motions[i].v = def.type == BodyType::dynamic ? unlocked(b, def.linear_velocity) : def.linear_velocity;
        c.motions[i].w = def.fixed_rotation ? 0 : def.angular_velocity;
    }
    c.awake_bodies.assign(i, moves && def.awake && def.enabled);
    c.motions[i].slack = 3.0e38f;
    if (has_tuning) c.residuals[i] = 0;
    update_mass(c, i);
    return c.body_id(i);
}

void World::destroy_body(BodyId id) {
    const auto [c, i] = begin_call<Call::destroy_body>(core(), id);
    if (i == null_index) return;
    forget_jam(c, i);
    if (c.bodies[i].joint_head != 0) remove_joints(c, i);
    end_contacts(c, i);
    while (c.bodies[i].shape_head != null_index) remove_shape(c, c.bodies[i].shape_head);
    c.awake_bodies.clear(i);
    if ((c.bodies[i].flags & body_bullet) != 0) --c.state->bullet_count;
    if (c.bodies[i].has_locks()) --c.state->locked_count;
    clear_slot(c.bodies[i]);
    c.poses[i] = Pose{};
    c.motions[i] = Motion{};
    pool_give(c.state->body_pool, c.bodies, i);
}

bool World::is_valid(BodyId id) const { return pool_holds(core().state->body_pool, core().bodies, id); }
std::uint32_t World::body_count() const { return core().state->body_pool.count; }

BodyId World::body_at(std::uint32_t slot) const {
    const Core& c = core();
    return pool_live(c.state->body_pool, c.bodies, slot) ? c.body_id(slot) : BodyId{};
}

Transform World::transform(BodyId id) const { ISLET_READ(body_transform(c, i)); }
Vec2 World::position(BodyId id) const { ISLET_READ(c.bodies[i].origin); }
float World::angle(BodyId id) const { ISLET_READ(angle_of(c.poses[i].q)); }
Vec2 World::center_of_mass(BodyId id) const { ISLET_READ(c.poses[i].center); }
Vec2 World::local_center_of_mass(BodyId id) const { ISLET_READ(c.bodies[i].local_center); }
Vec2 World::linear_velocity(BodyId id) const { ISLET_READ(c.motions[i].v); }
float World::angular_velocity(BodyId id) const { ISLET_READ(c.motions[i].w); }
BodyType World::type(BodyId id) const { ISLET_READ(c.bodies[i].type()); }
float World::mass(BodyId id) const { ISLET_READ(c.bodies[i].mass); }
float World::rotational_inertia(BodyId id) const { ISLET_READ(c.bodies[i].inertia); }
float World::linear_damping(BodyId id) const { ISLET_READ(c.bodies[i].linear_damping); }
float World::angular_damping(BodyId id) const { ISLET_READ(c.bodies[i].angular_damping); }
float World::sleep_threshold(BodyId id) const { ISLET_READ(c.bodies[i].sleep_threshold); }
float World::gravity_scale(BodyId id) const { ISLET_READ(c.bodies[i].gravity_scale); }
bool World::is_awake(BodyId id) const { ISLET_READ(c.is_awake(i)); }
bool World::sleep_enabled(BodyId id) const { ISLET_READ((c.bodies[i].flags & body_may_sleep) != 0); }
std::uint64_t World::user_data(BodyId id) const { ISLET_READ(c.bodies[i].user_data); }

Vec2 World::velocity_at(BodyId id, Vec2 point) const {
    const Core& c = core();
    const std::uint32_t i = find_slot(c, id);
    if (i == null_index || !check_finite(c, point)) return {};
    return c.motions[i].v + cross(c.motions[i].w, point - c.poses[i].center);
}

std::uint32_t World::shapes(BodyId id, span<ShapeId> out) const {
    const Core& c = core();
    const std::uint32_t i = find_slot(c, id);
    if (i == null_index) return 0;
    std::uint32_t n = 0;
    for (std::uint32_t s = c.bodies[i].shape_head; s != null_index; s = c.shapes[s].next, ++n)
        if (n < out.size()) out[n] = c.shape_id(s);
    return n;
}

ShapeId World::next_shape(BodyId id, ShapeId shape) const {
    const Core& c = core();
    const std::uint32_t i = find_slot(c, id);
    if (i == null_index) return {};
    std::uint32_t next = c.bodies[i].shape_head;
    if (shape) {
        const std::uint32_t s = find_slot(c, shape);
        if (s == null_index || !check(c, c.shapes[s].body == i, Error::out_of_range)) return {};
        next = c.shapes[s].next;
    }
    return next != null_index ? c.shape_id(next) : ShapeId{};
}

void World::set_transform(BodyId id, Vec2 position, float angle) {
    const DefaultFloatMode mode;
    const auto [c, i] = begin_call<Call::set_transform>(core(), id, position, angle);
    if (i != null_index && check_position(c, position) && check_finite(c, angle)) teleport(c, i, {position, make_rot(angle)});
}

void World::set_transform(BodyId id, const Transform& pose) {
    const DefaultFloatMode mode;
    const auto [c, i] = begin_call<Call::set_pose>(core(), id, pose);
    if (i != null_index && check_pose(c, pose)) teleport(c, i, {pose.p, normalize(pose.q)});
}

void World::set_linear_velocity(BodyId id, Vec2 velocity) {
    const auto [c, i] = begin_call<Call::set_linear_velocity>(core(), id, velocity);
    if (i == null_index || !check_finite(c, velocity) || c.bodies[i].type() == BodyType::static_body) return;
    if (velocity != Vec2{}) wake_island(c, i, c.arena());
    if (c.is_awake(i) || !detail::is_enabled(c, i)) c.motions[i].v = c.is_dynamic(i) ? unlocked(c.bodies[i], velocity) : velocity;
}

void World::set_angular_velocity(BodyId id, float velocity) {
    const auto [c, i] = begin_call<Call::set_angular_velocity>(core(), id, velocity);
    if (i == null_index || !check_finite(c, velocity) || c.bodies[i].type() == BodyType::static_body) return;
    if ((c.bodies[i].flags & body_fixed_rotation) != 0) return;
    if (velocity != 0) wake_island(c, i, c.arena());
    if (c.is_awake(i) || !detail::is_enabled(c, i)) c.motions[i].w = velocity;
}

void World::apply_force(BodyId id, Vec2 force, Vec2 point, bool wake) { act_on(core(), Call::apply_force, id, force, 0, &point, wake); }
void World::apply_force_to_center(BodyId id, Vec2 force, bool wake) { act_on(core(), Call::apply_force_to_center, id, force, 0, nullptr, wake); }
void World::apply_torque(BodyId id, float torque, bool wake) { act_on(core(), Call::apply_torque, id, {0, 0}, torque, nullptr, wake); }
void World::apply_linear_impulse(BodyId id, Vec2 impulse, Vec2 point, bool wake) { act_on(core(), Call::apply_linear_impulse, id, impulse, 0, &point, wake); }
void World::apply_linear_impulse_to_center(BodyId id, Vec2 impulse, bool wake) {
    act_on(core(), Call::apply_linear_impulse_to_center, id, impulse, 0, nullptr, wake);
}
void World::apply_angular_impulse(BodyId id, float impulse, bool wake) { act_on(core(), Call::apply_angular_impulse, id, {0, 0}, impulse, nullptr, wake); }

void World::set_type(BodyId id, BodyType type) {
    const DefaultFloatMode mode;
    const auto [c, i] = begin_call<Call::set_type>(core(), id, type);
    if (i == null_index || !check(c, type <= BodyType::dynamic, Error::out_of_range)) return;
    Body& b = c.bodies[i];
    if (b.type() == type) return;
    if (has_endless && type == BodyType::dynamic)
        for (std::uint32_t s = b.shape_head; s != null_index; s = c.shapes[s].next)
            if (!check(c, !is_endless(c.geometries[c.shapes[s].geometry]), Error::endless_shape)) return;
    forget_jam(c, i);
    // Colours depend on the types, so contacts are destroyed before the type changes, and joints get new colours after it.
    end_contacts(c, i);
    wake_island(c, i, c.arena());
    const bool joined = b.joint_head != 0;
    if (joined) release_joint_colors(c, i);
    unrest_shapes(c, i);
    c.awake_bodies.clear(i);
    b.flags = (b.flags & ~static_cast<std::uint32_t>(body_type_mask)) | static_cast<std::uint32_t>(type);
    c.motions[i].force = {0, 0};
    c.motions[i].torque = 0;
    c.motions[i].sleep_time = 0;
    if (type == BodyType::static_body) {
        c.motions[i].v = {0, 0};
        c.motions[i].w = 0;
        c.poses[i].flags = 0;
    } else {
        c.awake_bodies.assign(i, detail::is_enabled(c, i));
    }
    if (joined) hang_gears(c, i);
    if (joined) assign_joint_colors(c, i);
    update_mass(c, i);
    update_boxes(c, i, true);
    if (type == BodyType::static_body) rest_shapes(c, i);
}

void World::set_mass(BodyId id, const MassData& mass) {
    const DefaultFloatMode mode;
    const auto [c, i] = begin_call<Call::set_mass>(core(), id, mass);
    if (i == null_index || !check_range(c, mass.mass, min_mass, max_mass) || !check_position(c, mass.center)) return;
    if (mass.inertia != 0 && !check_range(c, mass.inertia, min_inertia, max_mass)) return;
    if (!c.is_dynamic(i)) return;
    wake_island(c, i, c.arena());
    apply_mass(c, i, mass);
    refit_boxes(c, i);
}

void World::reset_mass(BodyId id) {
    const DefaultFloatMode mode;
    const auto [c, i] = begin_call<Call::reset_mass>(core(), id);
    if (i == null_index) return;
    wake_island(c, i, c.arena());
    update_mass(c, i);
    refit_boxes(c, i);
}

void World::set_linear_damping(BodyId id, float damping) {
    const auto [c, i] = begin_call<Call::set_linear_damping>(core(), id, damping);
    if (i != null_index && check_range(c, damping, 0, no_limit)) c.bodies[i].linear_damping = damping;
}

void World::set_angular_damping(BodyId id, float damping) {
    const auto [c, i] = begin_call<Call::set_angular_damping>(core(), id, damping);
    if (i != null_index && check_range(c, damping, 0, no_limit)) c.bodies[i].angular_damping = damping;
}

void World::set_gravity_scale(BodyId id, float scale) {
    const auto [c, i] = begin_call<Call::set_gravity_scale>(core(), id, scale);
    if (i == null_index || !check_finite(c, scale)) return;
    c.bodies[i].gravity_scale = scale;
    wake_island(c, i, c.arena());
}

void World::enable_sleep(BodyId id, bool enable) {
    const auto [c, i] = begin_call<Call::enable_body_sleep>(core(), id, enable);
    if (i == null_index) return;
    Body& b = c.bodies[i];
    b.flags = enable ? b.flags | body_may_sleep : b.flags & ~static_cast<std::uint32_t>(body_may_sleep);
    if (!enable) wake_island(c, i, c.arena());
}

void World::set_sleep_threshold(BodyId id, float threshold) {
    const auto [c, i] = begin_call<Call::set_sleep_threshold>(core(), id, threshold);
    if (i != null_index && check_range(c, threshold, 0, no_limit)) c.bodies[i].sleep_threshold = threshold;
}

void World::wake(BodyId id) {
    const auto [c, i] = begin_call<Call::wake>(core(), id);
    if (i != null_index) wake_island(c, i, c.arena());
}

void World::sleep(BodyId id) {
    const auto [c, i] = begin_call<Call::sleep>(core(), id);
    if (i != null_index && check_there(c, has_sleep) && c.state->enable_sleep != 0) sleep_island(c, i, c.arena());
}

void World::set_user_data(BodyId id, std::uint64_t data) {
    const auto [c, i] = begin_call<Call::set_body_user_data>(core(), id, data);
    if (i != null_index) c.bodies[i].user_data = data;
}

}  // namespace islet
