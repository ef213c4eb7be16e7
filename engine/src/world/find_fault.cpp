// Which field of a definition breaks its rules. The calls themselves check for all fields at once, which takes less code; tests hold the two together.
#include "../exact.hpp"

#include "islet/fault.hpp"

#include "../bodies/bounds.hpp"
#include "../calls/checks.hpp"
#include "../constraint/angle_joint.hpp"
#include "../data/features.hpp"
#include "../graph/hooks.hpp"
#include "islet/mover.hpp"

namespace islet {

using namespace detail;

namespace {

/// Goes through the fields and keeps the first fault.
class Finder {
public:
    FieldFault found;

    void rule(const char* field, bool good, Error error) {
        if (!good && found.field == nullptr) found = {error, field};
    }
    void there(const char* field, bool good) { rule(field, good, Error::feature_cut); }
    void finite(const char* field, float a) { rule(field, is_finite(a), Error::not_finite); }
    void finite(const char* field, Vec2 a) { rule(field, is_finite(a), Error::not_finite); }
    void range(const char* field, float a, float lo, float hi) {
        finite(field, a);
        rule(field, a >= lo && a <= hi, Error::out_of_range);
    }
    void count(const char* field, std::uint32_t n, std::uint32_t lo, std::uint32_t hi) { rule(field, n >= lo && n <= hi, Error::out_of_range); }
    void not_negative(const char* field, float a) { range(field, a, 0, no_limit); }
    void positive(const char* field, float a) {
        not_negative(field, a);
        rule(field, a > 0, Error::out_of_range);
    }
    void place(const char* field, Vec2 p) {
        range(field, p.x, -max_position, max_position);
        range(field, p.y, -max_position, max_position);
    }

    void base(const JointBase& b) {
        place("base.frame_a.position", b.frame_a.position);
        finite("base.frame_a.angle", b.frame_a.angle);
        place("base.frame_b.position", b.frame_b.position);
        finite("base.frame_b.angle", b.frame_b.angle);
        not_negative("base.break_force", b.break_force);
        not_negative("base.break_torque", b.break_torque);
    }
    void spring(const JointSpring& s) {
        not_negative("spring.hertz", s.hertz);
        not_negative("spring.damping_ratio", s.damping_ratio);
        finite("spring.target", s.target);
    }
    void limit(const JointLimit& l) {
        finite("limit.lower", l.lower);
        finite("limit.upper", l.upper);
        rule("limit.upper", l.upper >= l.lower, Error::out_of_range);
    }
    void motor(const JointMotor& m) {
        finite("motor.speed", m.speed);
        not_negative("motor.max_force", m.max_force);
    }
    void ratchet(const JointRatchet& r) {
        finite("ratchet.step", r.step);
        rule("ratchet.step", is_ratchet_step(r.step), Error::out_of_range);
        range("ratchet.phase", r.phase, -most_ratchet_phase, most_ratchet_phase);
    }
    template <class Def>
    void coordinate(const Def& d) {
        spring(d.spring);
        limit(d.limit);
        motor(d.motor);
    }
    /// A material's fields, which a ShapeDef has too.
    template <class Def>
    void surface(const Def& d) {
        range("friction", d.friction, 0, max_coefficient);
        range("restitution", d.restitution, 0, 1);
        there("restitution", has_restitution || d.restitution == 0);
        range("rolling_resistance", d.rolling_resistance, 0, max_coefficient);
        there("rolling_resistance", has_surfaces || d.rolling_resistance == 0);
        range("tangent_speed", d.tangent_speed, -max_speed_limit, max_speed_limit);
        there("tangent_speed", has_surfaces || d.tangent_speed == 0);
    }
    template <class Def>
    void softness(const Def& d) {
        not_negative("linear_hertz", d.linear_hertz);
        not_negative("linear_damping_ratio", d.linear_damping_ratio);
        not_negative("angular_hertz", d.angular_hertz);
        not_negative("angular_damping_ratio", d.angular_damping_ratio);
    }
    void solver(const SolverDef& d);

    /// The fault of a struct by itself, whose fields were named as those of a definition that holds it, after so many characters.
    FieldFault without_prefix(std::uint32_t length) const { return found.field != nullptr ? FieldFault{found.error, found.field + length} : found; }
};

/// The characters of a prefix.
template <std::uint32_t N>
constexpr std::uint32_t length_of(const char (&)[N]) {
    return N - 1;
}

void Finder::solver(const SolverDef& d) {
    rule("solver.schedule", d.schedule <= Schedule::classic, Error::out_of_range);
    count("solver.substeps", d.substeps, 1, 64);
    count("solver.iterations", d.iterations, 1, 256);
    count("solver.relax_iterations", d.relax_iterations, 0, 256);
    positive("solver.contact_hertz", d.contact_hertz);
    not_negative("solver.contact_damping_ratio", d.contact_damping_ratio);
    not_negative("solver.contact_push_speed", d.contact_push_speed);
    positive("solver.joint_hertz", d.joint_hertz);
    not_negative("solver.joint_damping_ratio", d.joint_damping_ratio);
    range("solver.baumgarte", d.baumgarte, 0, 1);
    positive("solver.omega", d.omega);
    rule("solver.omega", d.omega < 2, Error::out_of_range);
    rule("solver.joint_trees", d.joint_trees <= JointTrees::all, Error::out_of_range);
    range("solver.joint_tree_load", d.joint_tree_load, 1, no_limit);
    rule("solver.sweep_order", d.sweep_order <= SweepOrder::downward, Error::out_of_range);
    there("solver.sweep_order", has_tuning || d.sweep_order == SweepOrder::colored);
    there("solver.block_contacts", has_tuning || !d.block_contacts);
    range("solver.shock", d.shock, 0, max_shock);
    there("solver.shock", has_tuning || d.shock == 0);
    there("solver.measure_residual", has_tuning || !d.measure_residual);
    not_negative("solver.tolerance", d.tolerance);
    there("solver.tolerance", has_tuning || d.tolerance == 0);
}

/// A joint's definition with a base and a coordinate.
template <class Def>
Finder along_coordinate(const Def& d) {
    Finder f;
    f.base(d.base);
    f.coordinate(d);
    return f;
}

template <class Def>
FieldFault along_with_friction(const Def& d) {
    Finder f = along_coordinate(d);
    f.not_negative("friction", d.friction);
    return f.found;
}

}  // namespace

FieldFault find_fault(const SolverDef& d) {
    Finder f;
    f.solver(d);
    return f.without_prefix(length_of("solver."));
}

FieldFault find_fault(const WorldDef& d) {
    Finder f;
    f.finite("gravity", d.gravity);
    f.solver(d.solver);
    f.not_negative("restitution_threshold", d.restitution_threshold);
    f.range("max_speed", d.max_speed, 0, max_speed_limit);
    f.positive("max_speed", d.max_speed);
    f.not_negative("hit_threshold", d.hit_threshold);
    f.rule("lanes", d.lanes == 0 || d.lanes == 1 || d.lanes == 4 || d.lanes == 8 || d.lanes == 16, Error::out_of_range);
    f.there("hooks", are_there(d.hooks));
    f.count("tasks.workers", d.tasks.workers, 1, max_workers);
    f.there("clock", has_profile || d.clock == nullptr);
    return f.found;
}

FieldFault find_fault(const BodyDef& d) {
    Finder f;
    f.rule("type", d.type <= BodyType::dynamic, Error::out_of_range);
    f.place("position", d.position);
    f.finite("angle", d.angle);
    f.finite("linear_velocity", d.linear_velocity);
    f.finite("angular_velocity", d.angular_velocity);
    f.not_negative("linear_damping", d.linear_damping);
    f.not_negative("angular_damping", d.angular_damping);
    f.finite("gravity_scale", d.gravity_scale);
    f.not_negative("sleep_threshold", d.sleep_threshold);
    f.there("awake", has_sleep || d.awake);
    f.there("enabled", has_disabling || d.enabled);
    f.there("bullet", has_bullets || !d.bullet);
    return f.found;
}

FieldFault find_fault(const ShapeDef& d) {
    Finder f;
    f.surface(d);
    f.not_negative("density", d.density);
    f.there("sensor", has_sensors || !d.sensor);
    f.there("hit_events", has_hits || !d.hit_events);
    f.there("pre_solve", has_hooks || !d.pre_solve);
    f.finite("one_way", d.one_way);
    f.there("one_way", has_one_way || d.one_way == Vec2{});
    return f.found;
}

FieldFault find_fault(const ExplosionDef& d) {
    Finder f;
    f.place("position", d.position);
    f.range("radius", d.radius, 0, max_position);
    f.range("falloff", d.falloff, 0, max_position);
    f.finite("impulse_per_length", d.impulse_per_length);
    return f.found;
}

FieldFault find_fault(const WindDef& d) {
    Finder f;
    f.finite("velocity", d.velocity);
    f.rule("velocity", length_squared(d.velocity) <= max_speed_limit * max_speed_limit, Error::out_of_range);
    f.not_negative("drag", d.drag);
    f.finite("lift", d.lift);
    f.not_negative("density", d.density);
    return f.found;
}

FieldFault find_fault(const RevoluteJointDef& d) { return along_with_friction(d); }
FieldFault find_fault(const PrismaticJointDef& d) { return along_with_friction(d); }
FieldFault find_fault(const WheelJointDef& d) { return along_with_friction(d); }

FieldFault find_fault(const DistanceJointDef& d) {
    Finder f;
    f.base(d.base);
    f.range("length", d.length, linear_slop, max_position);
    f.coordinate(d);
    f.rule("limit.lower", !d.limit.enable || d.limit.lower >= 0, Error::out_of_range);
    return f.found;
}

FieldFault find_fault(const WeldJointDef& d) {
    Finder f;
    f.base(d.base);
    f.softness(d);
    return f.found;
}

FieldFault find_fault(const MotorJointDef& d) {
    Finder f;
    f.base(d.base);
    f.finite("linear_velocity", d.linear_velocity);
    f.finite("angular_velocity", d.angular_velocity);
    f.not_negative("max_force", d.max_force);
    f.not_negative("max_torque", d.max_torque);
    f.softness(d);
    return f.found;
}

FieldFault find_fault(const MouseJointDef& d) {
    Finder f;
    f.place("target", d.target);
    f.positive("hertz", d.hertz);
    f.not_negative("damping_ratio", d.damping_ratio);
    f.not_negative("max_force", d.max_force);
    return f.found;
}

FieldFault find_fault(const PulleyJointDef& d) {
    Finder f;
    f.base(d.base);
    f.place("ground_a", d.ground_a);
    f.place("ground_b", d.ground_b);
    f.range("ratio", d.ratio, 0, max_ratio);
    f.positive("ratio", d.ratio);
    return f.found;
}

FieldFault find_fault(const GearJointDef& d) {
    Finder f;
    f.range("ratio", d.ratio, -max_ratio, max_ratio);
    f.rule("ratio", d.ratio != 0, Error::out_of_range);
    f.not_negative("break_torque", d.break_torque);
    return f.found;
}

FieldFault find_fault(const AngleJointDef& d) {
    Finder f = along_coordinate(d);
    f.not_negative("friction", d.friction);
    f.ratchet(d.ratchet);
    return f.found;
}

FieldFault find_fault(const JointSpring& spring) {
    Finder f;
    f.spring(spring);
    return f.without_prefix(length_of("spring."));
}

FieldFault find_fault(const JointLimit& limit) {
    Finder f;
    f.limit(limit);
    return f.without_prefix(length_of("limit."));
}

FieldFault find_fault(const JointMotor& motor) {
    Finder f;
    f.motor(motor);
    return f.without_prefix(length_of("motor."));
}

FieldFault find_fault(const JointRatchet& ratchet) {
    Finder f;
    f.ratchet(ratchet);
    return f.without_prefix(length_of("ratchet."));
}

FieldFault find_fault(const JointSoftness& softness) {
    Finder f;
    f.softness(softness);
    return f.found;
}

FieldFault find_fault(const JointFrame& frame) {
    Finder f;
    f.place("position", frame.position);
    f.finite("angle", frame.angle);
    return f.found;
}

FieldFault find_fault(const SurfaceMaterial& material) {
    Finder f;
    f.surface(material);
    return f.found;
}

FieldFault find_fault(const MassData& mass) {
    Finder f;
    f.range("mass", mass.mass, min_mass, max_mass);
    f.place("center", mass.center);
    f.finite("inertia", mass.inertia);
    f.rule("inertia", mass.inertia == 0 || (mass.inertia >= min_inertia && mass.inertia <= max_mass), Error::out_of_range);
    return f.found;
}

FieldFault find_fault(const Capacity& capacity) {
    Finder f;
    const auto count = [&f](const char* field, std::uint32_t n, std::uint32_t least, std::uint32_t most = max_capacity) {
        f.rule(field, n >= least && n <= most, Error::bad_capacity);
    };
    count("bodies", capacity.bodies, 1, detail::max_bodies);
    count("shapes", capacity.shapes, 1, detail::max_shapes);
    count("contacts", capacity.contacts, 1, detail::max_contacts);
    count("joints", capacity.joints, 0);
    count("geometries", capacity.geometries, 0);
    count("hits", capacity.hits, 0);
    count("events", capacity.events, 0);
    return f.found;
}

FieldFault find_fault(const MoverDef& d) {
    Finder f;
    f.rule("capsule", islet::is_valid(d.capsule), Error::bad_geometry);
    f.finite("up", d.up);
    f.rule("up", abs(length(d.up) - 1) <= 1e-3f, Error::out_of_range);
    f.range("gravity_scale", d.gravity_scale, -max_coefficient, max_coefficient);
    f.range("max_slope", d.max_slope, 0, 1.5f);
    f.range("step_height", d.step_height, 0, max_position);
    f.range("snap_distance", d.snap_distance, 0, max_position);
    f.not_negative("ground_acceleration", d.ground_acceleration);
    f.not_negative("air_acceleration", d.air_acceleration);
    f.not_negative("mass", d.mass);
    f.not_negative("max_push_force", d.max_push_force);
    return f.found;
}

}  // namespace islet
