// Calls that only look: whatever is asked for, of whatever ids, the world stays as it was; and what it tells of itself fits together.
#include "player.hpp"

namespace islet::fuzz {

namespace {

/// Reading for reading's sake, which no compiler may leave out.
template <class... Values>
void look(const Values&... values) {
    const auto one = [](const auto& value) { asm volatile("" : : "r"(&value) : "memory"); };
    (one(values), ...);
}

}  // namespace

void Player::read() {
    const std::uint64_t hash = w.hash();
    read_world();
    const BodyId b = body();
    read_body(b);
    read_contacts(b);
    read_shape(shape());
    read_joint(joint());
    switch (in.below(6)) {
        case 0: draw(); break;
        case 1: solve_island(b); break;
        case 2: solve_matrix(); break;
        case 3: try_geometry(); break;
        case 4:
            try_math();
            try_create();
            break;
        default: ask();
    }
    expect(w.hash() == hash, "reading changed the world");
}

void Player::read_world() {
    std::uint32_t bodies = 0, joints = 0, touching = 0;
    for (std::uint32_t slot = 0; slot < capacity.bodies; ++slot) bodies += w.is_valid(w.body_at(slot)) ? 1 : 0;
    for (std::uint32_t slot = 0; slot < capacity.joints; ++slot) joints += w.is_valid(w.joint_at(slot)) ? 1 : 0;
    ContactInfo contact;
    for (std::uint32_t slot = 0; slot < capacity.contacts; ++slot) touching += w.contact_at(slot, contact) ? 1 : 0;
    w.contact_at(in.byte(), contact);
    w.body_at(in.byte());
    w.joint_at(in.byte());
    expect(bodies == w.body_count() && joints == w.joint_count(), "there are more or fewer bodies or joints than there are");
    expect(touching <= w.contact_count() && w.shape_count() <= capacity.shapes, "there are more contacts or shapes than there are");
    expect(w.capacity() == capacity, "the capacity is another");
    expect(w.tasks().workers >= 1 && w.hit_threshold() >= 0, "the world has settings that it refuses");

    const StepProfile& p = w.profile();
    expect(p.total == p.pairs + p.collide + p.islands + p.solve + p.finish, "the stages are not the step");
    look(w.continuous(), w.hooks(), w.report(), w.step_count(), w.counters(), w.recorded_bytes(), w.gravity(), w.solver());
    // Until the next call that changes the world the ids of these live; those of end events need not.
    for (const BodyId b : w.moved_bodies()) look(w.position(b));
    for (const BodyId b : w.slept_bodies()) look(w.position(b));
    for (const TouchEvent& e : w.begin_touch_events()) look(w.body(e.shape_a), w.body(e.shape_b));
    for (const TouchEvent& e : w.end_touch_events()) look(w.is_valid(e.shape_a), w.is_valid(e.shape_b));
    for (const SensorEvent& e : w.sensor_begin_events()) look(w.body(e.sensor), w.body(e.visitor));
    for (const SensorEvent& e : w.sensor_end_events()) look(w.is_valid(e.sensor), w.is_valid(e.visitor));
    for (const HitEvent& e : w.hit_events()) expect(is_finite(e.point) && is_finite(e.normal) && e.speed >= 0, "a hit is nowhere");
    for (const JointBreakEvent& e : w.broken_joints()) look(e);
}

void Player::read_body(BodyId b) {
    look(w.position(b), w.transform(b), w.angle(b), w.center_of_mass(b), w.local_center_of_mass(b), w.linear_velocity(b), w.angular_velocity(b));
    look(w.velocity_at(b, in.point()), w.type(b), w.mass(b), w.rotational_inertia(b), w.linear_damping(b), w.angular_damping(b), w.gravity_scale(b));
    look(w.is_rotation_fixed(b), w.is_x_locked(b), w.is_y_locked(b), w.is_enabled(b), w.is_bullet(b), w.sleep_threshold(b), w.sleep_enabled(b), w.is_awake(b));
    look(w.user_data(b), w.residual(b));
    ShapeId shapes[capacity.shapes];
    const std::uint32_t shape_count = w.shapes(b, shapes);
    for (std::uint32_t i = 0; i < shape_count; ++i) expect(w.body(shapes[i]) == b, "a body has the shape of another");
    JointId joints[capacity.joints];
    const std::uint32_t joint_count = w.joints(b, joints);
    for (std::uint32_t i = 0; i < joint_count; ++i) look(w.joint_type(joints[i]));
    // With room for none of them.
    expect(w.shapes(b, {}) == shape_count && w.joints(b, {}) == joint_count, "how many there are depends on the room for them");
}

void Player::read_contacts(BodyId b) {
    ContactInfo touching[capacity.contacts];
    const std::uint32_t n = w.contacts(b, {touching, in.below(capacity.contacts + 1)});
    expect(n <= capacity.contacts, "a body has more contacts than there can be");
    ContactInfo all[capacity.contacts];
    w.contacts(b, all);
    for (std::uint32_t i = 0; i < n; ++i) {
        expect(w.body(all[i].shape_a) == b || w.body(all[i].shape_b) == b, "a body has the contact of others");
        for (std::uint32_t k = 0; k < all[i].point_count; ++k) expect(is_finite(all[i].points[k].point), "a contact is nowhere");
    }
}

void Player::read_shape(ShapeId s) {
    const bool one[] = {w.circle(s) != nullptr,  w.capsule(s) != nullptr,       w.segment(s) != nullptr,
                        w.polygon(s) != nullptr, w.chain_segment(s) != nullptr, w.half_space(s) != nullptr};
    int types = 0;
    for (const bool is : one) types += is ? 1 : 0;
    expect(types == (w.is_valid(s) ? 1 : 0), "a shape is of no type, or of two");
    expect(types == 0 || one[static_cast<int>(w.shape_type(s))], "a shape is of another type");
    look(w.body(s), w.aabb(s), w.density(s), w.friction(s), w.restitution(s), w.rolling_resistance(s), w.tangent_speed(s), w.material(s));
    look(w.is_sensor(s), w.sensor_events_enabled(s), w.hit_events_enabled(s), w.pre_solve_enabled(s), w.one_way(s), w.filter(s), w.user_data(s));
    ShapeId seen[capacity.shapes];
    const std::uint32_t n = w.sensor_overlaps(s, {seen, in.below(capacity.shapes + 1)});
    expect(n <= capacity.shapes, "a sensor sees more shapes than there can be");
    ContactInfo touching[capacity.contacts];
    const std::uint32_t touches = w.contacts(s, touching);
    for (std::uint32_t i = 0; i < touches; ++i) expect(touching[i].shape_a == s || touching[i].shape_b == s, "a shape has the contact of others");
}

void Player::read_joint(JointId j) {
    look(w.joint_type(j), w.body_a(j), w.body_b(j), w.frame_a(j), w.frame_b(j), w.anchor_a(j), w.anchor_b(j), w.collide_connected(j), w.user_data(j));
    look(w.joint_position(j), w.joint_speed(j), w.spring(j), w.limit(j), w.motor(j), w.joint_friction(j), w.motor_force(j), w.joint_length(j));
    look(w.target(j), w.ground_a(j), w.ground_b(j), w.joint_force(j), w.joint_torque(j), w.joint_error(j));
    look(w.softness(j), w.joint_ratio(j), w.joint1(j), w.joint2(j), w.break_force(j), w.break_torque(j));
    look(w.joint_linear_velocity(j), w.joint_angular_velocity(j), w.joint_max_force(j), w.joint_max_torque(j));
}

}  // namespace islet::fuzz
