// Calls that make, change and destroy what is in the world.
#include "fuzz/api/hosts.hpp"
#include "fuzz/api/player.hpp"

namespace islet::fuzz {

void Player::create_shape(BodyId owner) {
    const ShapeDef def = shape_def();
    switch (in.below(7)) {
    case 0: w.create_shape(owner, circle(), def); break;
    case 1: w.create_shape(owner, capsule(), def); break;
    case 2: w.create_shape(owner, segment(), def); break;
    case 3: w.create_shape(owner, chain_segment(), def); break;
    case 4: {
        Vec2 points[6];
        for (Vec2& p : points) p = in.point();
        const std::uint32_t count = in.below(7);
        const bool loop = in.flag();
        ShapeId made[2];
        const std::uint32_t n = w.create_chain(owner, {points, count}, loop, def, made);
        for (std::uint32_t i = 0; i < n && i < 2; ++i) expect(w.is_valid(made[i]) && w.body(made[i]) == owner, "a chain names shapes that it did not make");
        break;
    }
    default: w.create_shape(owner, polygon(), def);
    }
}

void Player::create_joint() {
    JointBase base;
    base.body_a = body();
    base.body_b = body();
    const std::uint32_t more = in.byte();
    if ((more & 1) != 0) base.frame_a = frame();
    if ((more & 2) != 0) base.frame_b = frame();
    base.collide_connected = (more & 4) != 0;
    if ((more & 8) != 0) base.break_force = in.size();
    if ((more & 16) != 0) base.break_torque = in.size();
    const JointSpring s = (more & 32) != 0 ? spring() : JointSpring{};
    const JointLimit l = (more & 64) != 0 ? limit() : JointLimit{};
    const JointMotor m = (more & 128) != 0 ? motor() : JointMotor{};
    switch (in.below(joint_type_count)) {
    case 0: w.create_joint(RevoluteJointDef{base, s, l, m, in.size()}); break;
    case 1: w.create_joint(PrismaticJointDef{base, s, l, m, in.size()}); break;
    case 2: w.create_joint(DistanceJointDef{base, in.size(), s, l, m}); break;
    case 3: {
        WeldJointDef d{base};
        d.linear_hertz = in.size();
        d.angular_hertz = in.size();
        w.create_joint(d);
        break;
    }
    case 4: w.create_joint(WheelJointDef{base, s, l, m, in.size()}); break;
    case 5: {
        MotorJointDef d{base};
        d.linear_velocity = in.point();
        d.max_force = in.size();
        d.max_torque = in.size();
        d.linear_hertz = in.size();
        w.create_joint(d);
        break;
    }
    case 6: {
        MouseJointDef d;
        d.body = base.body_a;
        d.target = in.point();
        d.hertz = in.size();
        d.max_force = 100 * in.size();
        w.create_joint(d);
        break;
    }
    case 7: {
        PulleyJointDef d{base};
        d.ground_a = in.point();
        d.ground_b = in.point();
        d.ratio = in.size();
        w.create_joint(d);
        break;
    }
    default: {
        const JointId first = joint(), second = joint();
        w.create_joint(GearJointDef{first, second, in.number()});
    }
    }
}

void Player::change_body() {
    const BodyId b = body();
    switch (in.below(28)) {
    case 0: {
        const Vec2 at = in.point();
        w.set_transform(b, at, in.number());
        break;
    }
    case 1: w.set_linear_velocity(b, in.point()); break;
    case 2: w.set_angular_velocity(b, in.number()); break;
    case 3: {
        const Vec2 force = in.point();
        w.apply_force(b, force, in.point());
        break;
    }
    case 4: w.apply_force_to_center(b, in.point()); break;
    case 5: w.apply_torque(b, in.number()); break;
    case 6: {
        const Vec2 impulse = in.point();
        w.apply_linear_impulse(b, impulse, in.point());
        break;
    }
    case 7: w.apply_linear_impulse_to_center(b, in.point()); break;
    case 8: w.apply_angular_impulse(b, in.number()); break;
    case 9: w.set_type(b, static_cast<BodyType>(in.below(3))); break;
    case 10: {
        const float mass = in.size();
        const Vec2 center = in.point();
        w.set_mass(b, {mass, center, in.size()});
        break;
    }
    case 11: w.reset_mass(b); break;
    case 12: w.set_linear_damping(b, in.size()); break;
    case 13: w.set_angular_damping(b, in.size()); break;
    case 14: w.set_gravity_scale(b, in.number()); break;
    case 15: w.set_fixed_rotation(b, in.flag()); break;
    case 16: w.enable_sleep(b, in.flag()); break;
    case 17: w.wake(b); break;
    case 18: w.set_user_data(b, in.byte()); break;
    case 19: w.lock_x(b, in.flag()); break;
    case 20: w.lock_y(b, in.flag()); break;
    case 21:
    case 22: w.set_enabled(b, in.below(3) != 0); break;
    case 23: w.set_bullet(b, in.flag()); break;
    case 24: w.set_sleep_threshold(b, in.size()); break;
    case 25: {
        const Vec2 at = in.point();
        const float angle = in.number();
        w.set_target(b, {at, make_rot(angle)}, in.flag() ? 1.0f / 60 : in.number());
        break;
    }
    default: dead_body = b; w.destroy_body(b);
    }
}

void Player::change_shape() {
    const ShapeId s = shape();
    switch (in.below(17)) {
    case 0: w.set_friction(s, in.size()); break;
    case 1: w.set_restitution(s, 0.25f * in.size()); break;
    case 2: w.set_rolling_resistance(s, in.size()); break;
    case 3: w.set_tangent_speed(s, in.number()); break;
    case 4: w.set_filter(s, filter()); break;
    case 5: w.set_user_data(s, in.byte()); break;
    case 6: w.set_circle(s, circle()); break;
    case 7: w.set_capsule(s, capsule()); break;
    case 8: w.set_segment(s, segment()); break;
    case 9: w.set_polygon(s, polygon()); break;
    case 10: w.set_density(s, in.size()); break;
    case 11: {
        SurfaceMaterial m = w.material(s);
        m.friction = in.size();
        m.restitution = 0.25f * in.size();
        m.id = in.byte();
        w.set_material(s, m);
        break;
    }
    case 12: w.enable_sensor_events(s, in.flag()); break;
    case 13: w.enable_hit_events(s, in.flag()); break;
    case 14:
        if (in.flag()) {
            w.enable_pre_solve(s, in.flag());
        } else {
            w.set_one_way(s, {in.number(), in.number()});
        }
        break;
    case 15: {
        WindDef wind;
        wind.velocity = in.point();
        wind.drag = in.size();
        wind.lift = in.number();
        w.apply_wind(s, wind);
        break;
    }
    default: dead_shape = s; w.destroy_shape(s);
    }
}

void Player::change_joint() {
    const JointId j = joint();
    switch (in.below(13)) {
    case 0: {
        const JointFrame a = frame();
        w.set_frames(j, a, frame());
        break;
    }
    case 1: w.set_collide_connected(j, in.flag()); break;
    case 2: {
        const float force = in.size();
        w.set_break(j, force, in.size());
        break;
    }
    case 3: w.set_user_data(j, in.byte()); break;
    case 4: w.set_spring(j, spring()); break;
    case 5: w.set_limit(j, limit()); break;
    case 6: w.set_motor(j, motor()); break;
    case 7: w.set_joint_friction(j, in.size()); break;
    case 8: w.set_joint_length(j, in.size()); break;
    case 9: {
        const Vec2 v = in.point();
        w.set_joint_velocity(j, v, in.number());
        break;
    }
    case 10: {
        const float force = in.size();
        w.set_joint_strength(j, force, in.size());
        break;
    }
    case 11: w.set_target(j, in.point()); break;
    default: dead_joint = j; w.destroy_joint(j);
    }
}

void Player::change_world() {
    switch (in.below(12)) {
    case 0: w.set_gravity(in.point()); break;
    case 1: w.enable_sleep(in.flag()); break;
    case 2: w.enable_continuous(in.flag()); break;
    case 3: w.set_hit_threshold(in.size()); break;
    case 4: {
        ExplosionDef e;
        e.position = in.point();
        e.radius = in.size();
        e.falloff = in.size();
        e.impulse_per_length = in.number();
        w.explode(e);
        break;
    }
    case 5: {
        // No part of the state: nothing may depend on it.
        const std::uint64_t hash = w.hash();
        w.set_tasks(in.below(4) == 0 ? TaskSystem{nullptr, nullptr, in.byte()} : backwards_tasks(in.below(8)));
        w.set_clock(in.flag() ? count_ticks : nullptr);
        expect(w.hash() == hash, "the clock or the workers are part of the state");
        break;
    }
    case 6: move_recording(); break;
    default: w.set_solver(solver_def(w.solver()));
    }
}

}  // namespace islet::fuzz
