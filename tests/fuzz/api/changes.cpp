// Calls that make, change and destroy what is in the world.
#include "caller.hpp"

namespace islet::fuzz {

void Caller::create_shape(BodyId owner) {
    const ShapeDef def = shape_def();
    switch (in.below(8)) {
    case 0: all.create_shape(owner, circle(), def); break;
    case 1: all.create_shape(owner, capsule(), def); break;
    case 2: all.create_shape(owner, segment(), def); break;
    case 3: all.create_shape(owner, chain_segment(), def); break;
    case 4: {
        Vec2 points[6];
        for (Vec2& p : points) p = in.point();
        const std::uint32_t count = in.below(7);
        const bool loop = in.flag();
        ShapeId made[2];
        const std::uint32_t n = all.create_chain(owner, {points, count}, loop, def, made);
        for (std::uint32_t i = 0; i < n && i < 2; ++i) expect(w.is_valid(made[i]) && w.body(made[i]) == owner, "a chain names shapes that it did not make");
        break;
    }
    case 5: all.create_shape(owner, half_space(), def); break;
    default: all.create_shape(owner, polygon(), def);
    }
}

void Caller::create_joint() {
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
    case 0: all.create_joint(RevoluteJointDef{base, s, l, m, in.size()}); break;
    case 1: all.create_joint(PrismaticJointDef{base, s, l, m, in.size()}); break;
    case 2: all.create_joint(DistanceJointDef{base, in.size(), s, l, m}); break;
    case 3: {
        WeldJointDef d{base};
        d.linear_hertz = in.size();
        d.angular_hertz = in.size();
        all.create_joint(d);
        break;
    }
    case 4: all.create_joint(WheelJointDef{base, s, l, m, in.size()}); break;
    case 5: {
        MotorJointDef d{base};
        d.linear_velocity = in.point();
        d.max_force = in.size();
        d.max_torque = in.size();
        d.linear_hertz = in.size();
        all.create_joint(d);
        break;
    }
    case 6: {
        MouseJointDef d;
        d.body = base.body_a;
        d.target = in.place();
        d.hertz = in.size();
        d.max_force = 100 * in.size();
        all.create_joint(d);
        break;
    }
    case 7: {
        PulleyJointDef d{base};
        d.ground_a = in.place();
        d.ground_b = in.place();
        d.ratio = in.size();
        all.create_joint(d);
        break;
    }
    case 8: {
        const float friction = in.size();
        all.create_joint(AngleJointDef{base, s, l, m, friction, ratchet()});
        break;
    }
    default: {
        const JointId first = joint(), second = joint();
        all.create_joint(GearJointDef{first, second, in.number()});
    }
    }
}

void Caller::change_body() {
    const BodyId b = body();
    const auto wakes = [this] { return in.below(4) != 0; };
    switch (in.below(28)) {
    case 0: {
        const Vec2 at = in.place();
        const float angle = in.number();
        in.flag() ? all.set_transform(b, at, angle) : all.set_transform(b, Transform{at, make_rot(angle)});
        break;
    }
    case 1: all.set_linear_velocity(b, in.point()); break;
    case 2: all.set_angular_velocity(b, in.number()); break;
    case 3: {
        const Vec2 force = in.point(), at = in.place();
        all.apply_force(b, force, at, wakes());
        break;
    }
    case 4: {
        const Vec2 force = in.point();
        all.apply_force_to_center(b, force, wakes());
        break;
    }
    case 5: {
        const float torque = in.number();
        all.apply_torque(b, torque, wakes());
        break;
    }
    case 6: {
        const Vec2 impulse = in.point(), at = in.place();
        all.apply_linear_impulse(b, impulse, at, wakes());
        break;
    }
    case 7: {
        const Vec2 impulse = in.point();
        all.apply_linear_impulse_to_center(b, impulse, wakes());
        break;
    }
    case 8: {
        const float impulse = in.number();
        all.apply_angular_impulse(b, impulse, wakes());
        break;
    }
    case 9: all.set_type(b, static_cast<BodyType>(in.below(3))); break;
    case 10: {
        const float mass = in.size();
        const Vec2 center = in.point();
        all.set_mass(b, MassData{mass, center, in.size()});
        break;
    }
    case 11: all.reset_mass(b); break;
    case 12: all.set_linear_damping(b, in.size()); break;
    case 13: all.set_angular_damping(b, in.size()); break;
    case 14: all.set_gravity_scale(b, in.number()); break;
    case 15: all.set_fixed_rotation(b, in.flag()); break;
    case 16: all.enable_sleep(b, in.flag()); break;
    case 17: in.flag() ? all.wake(b) : all.sleep(b); break;
    case 18: all.set_user_data(b, std::uint64_t{in.byte()}); break;
    case 19: all.lock_x(b, in.flag()); break;
    case 20: all.lock_y(b, in.flag()); break;
    case 21:
    case 22: all.set_enabled(b, in.below(3) != 0); break;
    case 23: all.set_bullet(b, in.flag()); break;
    case 24: all.set_sleep_threshold(b, in.size()); break;
    case 25: {
        const Vec2 at = in.place();
        const float angle = in.number();
        all.set_target(b, Transform{at, make_rot(angle)}, in.flag() ? 1.0f / 60 : in.number());
        break;
    }
    default: dead_body = b; all.destroy_body(b);
    }
}

void Caller::change_shape() {
    const ShapeId s = shape();
    switch (in.below(17)) {
    case 0: all.set_friction(s, in.size()); break;
    case 1: all.set_restitution(s, 0.25f * in.size()); break;
    case 2: all.set_rolling_resistance(s, in.size()); break;
    case 3: all.set_tangent_speed(s, in.number()); break;
    case 4: all.set_filter(s, filter()); break;
    case 5: all.set_user_data(s, std::uint64_t{in.byte()}); break;
    case 6: all.set_circle(s, circle()); break;
    case 7: all.set_capsule(s, capsule()); break;
    case 8: in.flag() ? all.set_segment(s, segment()) : all.set_chain_segment(s, chain_segment()); break;
    case 9: in.flag() ? all.set_half_space(s, half_space()) : all.set_polygon(s, polygon()); break;
    case 10: all.set_density(s, in.size()); break;
    case 11: {
        SurfaceMaterial m = w.material(s);
        m.friction = in.size();
        m.restitution = 0.25f * in.size();
        m.id = in.byte();
        if ((m.id & 1) != 0) m.rolling_resistance = in.size();
        if ((m.id & 2) != 0) m.tangent_speed = in.number();
        all.set_material(s, m);
        break;
    }
    case 12:
        if (in.flag()) {
            all.enable_sensor_events(s, in.flag());
        } else {
            all.set_sensor(s, in.flag());
        }
        break;
    case 13: all.enable_hit_events(s, in.flag()); break;
    case 14:
        if (in.flag()) {
            all.enable_pre_solve(s, in.flag());
        } else {
            const float x = in.number();
            all.set_one_way(s, Vec2{x, in.number()});
        }
        break;
    case 15: {
        WindDef wind;
        wind.velocity = in.point();
        wind.drag = in.size();
        wind.lift = in.number();
        all.apply_wind(s, wind);
        break;
    }
    default: dead_shape = s; all.destroy_shape(s);
    }
}

void Caller::change_joint() {
    const JointId j = joint();
    switch (in.below(17)) {
    case 0: {
        const JointFrame a = frame();
        all.set_frames(j, a, frame());
        break;
    }
    case 1: all.set_collide_connected(j, in.flag()); break;
    case 2: {
        const float force = in.size();
        all.set_break(j, force, in.size());
        break;
    }
    case 3: all.set_user_data(j, std::uint64_t{in.byte()}); break;
    case 4: all.set_spring(j, spring()); break;
    case 5: all.set_limit(j, limit()); break;
    case 6: all.set_motor(j, motor()); break;
    case 7: all.set_joint_friction(j, in.size()); break;
    case 8: all.set_joint_length(j, in.size()); break;
    case 9: {
        const Vec2 v = in.point();
        all.set_joint_velocity(j, v, in.number());
        break;
    }
    case 10: {
        const float force = in.size();
        all.set_joint_strength(j, force, in.size());
        break;
    }
    case 11: all.set_target(j, in.place()); break;
    case 12: all.set_ratchet(j, ratchet()); break;
    case 13: {
        JointSoftness soft;
        soft.linear_hertz = in.size();
        soft.linear_damping_ratio = in.size();
        soft.angular_hertz = in.flag() ? in.size() : 0;
        soft.angular_damping_ratio = in.size();
        all.set_softness(j, soft);
        break;
    }
    case 14: {
        const Vec2 ground = in.place();
        all.set_grounds(j, ground, in.place());
        break;
    }
    case 15: all.set_joint_ratio(j, in.number()); break;
    default: dead_joint = j; all.destroy_joint(j);
    }
}

void Caller::change_world() {
    switch (in.below(15)) {
    case 0: all.set_gravity(in.point()); break;
    case 1: all.enable_sleep(in.flag()); break;
    case 2: all.enable_continuous(in.flag()); break;
    case 3: all.set_hit_threshold(in.size()); break;
    case 14: all.enable_seamless_floors(in.flag()); break;
    case 7: all.set_restitution_threshold(in.size()); break;
    case 8: all.set_max_speed(in.flag() ? 1000 * in.size() : in.size()); break;
    case 4: {
        ExplosionDef e;
        e.position = in.place();
        e.radius = in.size();
        e.falloff = in.size();
        e.impulse_per_length = in.number();
        all.explode(e);
        break;
    }
    case 5:
    case 6: {
        const std::uint32_t low = in.byte();
        set_hooks(low | in.below(2) << 8);
        break;
    }
    default: all.set_solver(solver_def(w.solver()));
    }
}

}  // namespace islet::fuzz
