#include "chipmunk_joints.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "chipmunk_shapes.hpp"

namespace islet::engines {

using samples::Scene;
using samples::SceneJoint;

namespace {

constexpr double two_pi = 2 * std::numbers::pi;
constexpr double endless = 1e4;  // m, where a groove without limits ends
constexpr double narrow = 1e-6;  // m, length of the shortest groove: of none the direction would be lost
constexpr double lever = 100;    // m, along the axis from a strut's anchor to where its spring is fixed: it must not turn over

bool is_static(const BodyDef& def) { return def.type == BodyType::static_body; }

/// 1 / (what a unit impulse at `at` along `axis` changes in the body's speed there), 1/kg: 0 of what cannot be moved.
double inverse_mass_at(const cpBody* body, cpVect at, cpVect axis) {
    const double arm = cpvcross(cpvsub(at, cpBodyLocalToWorld(body, cpBodyGetCenterOfGravity(body))), axis);
    return 1 / cpBodyGetMass(body) + arm * arm / cpBodyGetMoment(body);
}

/// Constraints on angles divide by this, 1/(kg m^2).
double inverse_moment(const cpBody* a, const cpBody* b) { return 1 / cpBodyGetMoment(a) + 1 / cpBodyGetMoment(b); }

/// What a joint's spring is to Chipmunk. The effective mass is that of the moment in which the spring is made or set.
struct Stiffness {
    double stiffness = 0, damping = 0;

    Stiffness(const JointSpring& spring, double inverse_mass) {
        const double omega = two_pi * double(spring.hertz);
        stiffness = omega * omega / inverse_mass;
        damping = 2 * double(spring.damping_ratio) * omega / inverse_mass;
    }
};

bool pulls(const JointSpring& spring) { return spring.enable && spring.hertz > 0; }

/// The ends of a groove, m along the axis.
std::pair<double, double> ends_of(const JointLimit& limit) {
    if (!limit.enable) return {-endless, endless};
    const double middle = 0.5 * (double(limit.lower) + double(limit.upper)), half = 0.5 * (double(limit.upper) - double(limit.lower));
    return {middle - std::max(half, 0.5 * narrow), middle + std::max(half, 0.5 * narrow)};
}

void* index_as_data(std::size_t index) { return reinterpret_cast<void*>(static_cast<std::uintptr_t>(index)); }
std::size_t index_of(const cpConstraint* part) {
    return static_cast<std::size_t>(reinterpret_cast<std::uintptr_t>(cpConstraintGetUserData(part)));
}

/// The first feature missing for each kind of joint; std::visit picks one.
struct Lacks {
    const Scene& scene;
    const SceneJoint& joint;

    /// Chipmunk pushes a spring by its force at the start of a step, which diverges where the step is longer than 2 / omega.
    std::string too_fast(const JointSpring& spring) const {
        const bool diverges = pulls(spring) && two_pi * double(spring.hertz) * double(scene.dt) >= 2;
        return diverges ? "springs that swing so fast with steps so long" : "";
    }
    std::string operator()(const RevoluteJointDef& def) const { return too_fast(def.spring); }
    std::string operator()(const WheelJointDef& def) const { return too_fast(def.spring); }
    std::string operator()(const PrismaticJointDef& def) const {
        if (def.spring.enable) return "springs on sliders";
        if (def.motor.enable) return "motors on sliders";
        return def.friction > 0 ? "friction on sliders" : "";
    }
    std::string operator()(const DistanceJointDef& def) const { return def.motor.enable ? "motors on rods" : too_fast(def.spring); }
    std::string operator()(const WeldJointDef& def) const {
        return def.linear_hertz > 0 || def.angular_hertz > 0 ? "welds that give way" : "";
    }
    std::string operator()(const MouseJointDef&) const { return {}; }
    std::string operator()(const MotorJointDef&) const { return "motor joints"; }
    std::string operator()(const PulleyJointDef&) const { return "pulleys"; }
    std::string operator()(const AngleJointDef&) const { return "angle joints with all their parts"; }
    std::string operator()(const GearJointDef&) const {
        const auto turns_on_ground = [this](std::size_t index) {
            const SceneJoint& of = scene.joints.at(index);
            return std::holds_alternative<RevoluteJointDef>(of.def) && is_static(scene.bodies.at(of.body_a).def);
        };
        return turns_on_ground(joint.body_a) && turns_on_ground(joint.body_b) ? "" : "gears but between hinges on static bodies";
    }
};

}  // namespace

std::string chipmunk_joint_lacks(const Scene& scene, const SceneJoint& joint) { return std::visit(Lacks{scene, joint}, joint.def); }

/// Makes or changes the constraints of a joint so that they are what its definition says.
struct ChipmunkJoints::Setter {
    const ChipmunkJoints& joints;
    Entry& entry;

    void operator()(const RevoluteJointDef& def) const {
        if (entry.parts[point] == nullptr) pivot();
        set_turning_limit(def.limit);
        set_turning_spring(def.spring);
        set_motor(def.motor, def.friction);
    }
    void operator()(const PrismaticJointDef& def) const {
        if (def.spring.enable || def.motor.enable) throw std::runtime_error("Chipmunk 7 has no springs or motors on sliders");
        set_groove(def.limit);
        if (entry.parts[angle] == nullptr) lock_angle();
    }
    void operator()(const WheelJointDef& def) const {
        set_groove(def.limit);
        set_spring(def.spring, cpvsub(entry.anchor_a, cpvmult(entry.axis, lever)), lever + double(def.spring.target));
        set_motor(def.motor, def.friction);
    }
    void operator()(const DistanceJointDef& def) const {
        if (def.motor.enable) throw std::runtime_error("Chipmunk 7 has no motors on rods");
        set_rod(!def.spring.enable && !def.limit.enable, double(def.length));
        // A spring of 0 Hz holds nothing, but the bodies know a joint by its constraints: a rope that is never taut is one.
        const bool free = def.spring.enable && !pulls(def.spring) && !def.limit.enable;
        set_rope(free ? JointLimit{true, 0, static_cast<float>(endless)} : def.limit);
        set_spring(def.spring, entry.anchor_a, double(def.length));
    }
    void operator()(const WeldJointDef& def) const {
        if (def.linear_hertz > 0 || def.angular_hertz > 0) throw std::runtime_error("Chipmunk 7 has no welds that give way");
        if (entry.parts[point] != nullptr) return;
        pivot();
        lock_angle();
    }
    void operator()(const MouseJointDef& def) const {
        if (entry.parts[point] == nullptr) pivot();
        cpConstraint* hand = entry.parts[point];
        cpPivotJointSetAnchorA(hand, to_cp(def.target));
        cpConstraintSetMaxForce(hand, double(def.max_force));
        // As fast as the critically damped spring of that frequency.
        cpConstraintSetErrorBias(hand, std::exp(-two_pi * double(def.hertz)));
    }
    void operator()(const GearJointDef&) const {}  // nothing of it can be changed
    template <class Def>
    void operator()(const Def&) const {
        throw std::runtime_error("Chipmunk 7 has no pulleys, no motor joints and no angle joints with all their parts");
    }

private:
    bool turns() const { return inverse_moment(entry.a, entry.b) > 0; }

    void pivot() const { joints.add(entry, point, cpPivotJointNew2(entry.a, entry.b, entry.anchor_a, entry.anchor_b)); }

    void lock_angle() const {
        if (turns()) joints.add(entry, angle, cpGearJointNew(entry.a, entry.b, entry.reference, 1));
    }

    void set_groove(const JointLimit& limits) const {
        const auto [lower, upper] = ends_of(limits);
        const cpVect from = cpvadd(entry.anchor_a, cpvmult(entry.axis, lower)), to = cpvadd(entry.anchor_a, cpvmult(entry.axis, upper));
        if (cpConstraint* groove = entry.parts[point]; groove != nullptr) {
            cpGrooveJointSetGrooveA(groove, from);
            cpGrooveJointSetGrooveB(groove, to);
        } else {
            joints.add(entry, point, cpGrooveJointNew(entry.a, entry.b, from, to, entry.anchor_b));
        }
    }

    void set_turning_limit(const JointLimit& limits) const {
        if (!limits.enable || !turns()) return joints.drop(entry, limit);
        const double lower = entry.reference + double(limits.lower), upper = entry.reference + double(limits.upper);
        if (cpConstraint* stop = entry.parts[limit]; stop != nullptr) {
            cpRotaryLimitJointSetMin(stop, lower);
            cpRotaryLimitJointSetMax(stop, upper);
        } else {
            joints.add(entry, limit, cpRotaryLimitJointNew(entry.a, entry.b, lower, upper));
        }
    }

    void set_turning_spring(const JointSpring& of) const {
        if (!pulls(of) || !turns()) return joints.drop(entry, spring);
        const Stiffness s(of, inverse_moment(entry.a, entry.b));
        const double rest = -(entry.reference + double(of.target));  // Chipmunk counts the angle of A less that of B
        if (cpConstraint* coil = entry.parts[spring]; coil != nullptr) {
            cpDampedRotarySpringSetRestAngle(coil, rest);
            cpDampedRotarySpringSetStiffness(coil, s.stiffness);
            cpDampedRotarySpringSetDamping(coil, s.damping);
        } else {
            joints.add(entry, spring, cpDampedRotarySpringNew(entry.a, entry.b, rest, s.stiffness, s.damping));
        }
    }

    /// From `fixed` on A to the anchor on B.
    void set_spring(const JointSpring& of, cpVect fixed, double rest) const {
        if (!pulls(of)) return joints.drop(entry, spring);
        const cpVect from = cpBodyLocalToWorld(entry.a, fixed), to = cpBodyLocalToWorld(entry.b, entry.anchor_b);
        const cpVect along = cpvnormalize(cpvsub(to, from));
        const Stiffness s(of, inverse_mass_at(entry.a, from, along) + inverse_mass_at(entry.b, to, along));
        if (cpConstraint* coil = entry.parts[spring]; coil != nullptr) {
            cpDampedSpringSetRestLength(coil, rest);
            cpDampedSpringSetStiffness(coil, s.stiffness);
            cpDampedSpringSetDamping(coil, s.damping);
        } else {
            joints.add(entry, spring, cpDampedSpringNew(entry.a, entry.b, fixed, entry.anchor_b, rest, s.stiffness, s.damping));
        }
    }

    void set_rod(bool rigid, double length) const {
        if (!rigid) return joints.drop(entry, point);
        if (entry.parts[point] == nullptr) joints.add(entry, point, cpPinJointNew(entry.a, entry.b, entry.anchor_a, entry.anchor_b));
        cpPinJointSetDist(entry.parts[point], length);
    }

    void set_rope(const JointLimit& limits) const {
        if (!limits.enable) return joints.drop(entry, limit);
        const double lower = double(limits.lower), upper = double(limits.upper);
        if (cpConstraint* rope = entry.parts[limit]; rope != nullptr) {
            cpSlideJointSetMin(rope, lower);
            cpSlideJointSetMax(rope, upper);
        } else {
            joints.add(entry, limit, cpSlideJointNew(entry.a, entry.b, entry.anchor_a, entry.anchor_b, lower, upper));
        }
    }

    /// Friction is a motor that holds still as well as it can.
    void set_motor(const JointMotor& of, float dry) const {
        set_motor_part(motor, of.enable, double(of.speed), double(of.max_force));
        set_motor_part(friction, dry > 0, 0, double(dry));
    }
    void set_motor_part(Part part, bool wanted, double speed, double max_force) const {
        if (!wanted || !turns()) return joints.drop(entry, part);
        cpConstraint*& drive = entry.parts[part];
        if (drive == nullptr) joints.add(entry, part, cpSimpleMotorNew(entry.a, entry.b, 0));
        cpSimpleMotorSetRate(drive, -speed);  // Chipmunk counts the rate of A less that of B
        cpConstraintSetMaxForce(drive, max_force);
    }
};

void ChipmunkJoints::clear() {
    for (Entry& entry : joints_) {
        for (cpConstraint* part : entry.parts) cpConstraintFree(part);
    }
    joints_.clear();
    gears_.clear();
    space_ = nullptr;
}

/// Where the joint is on its bodies.
void ChipmunkJoints::place(Entry& entry, const JointBase& base) const {
    entry.anchor_a = to_cp(base.frame_a.position);
    entry.anchor_b = to_cp(base.frame_b.position);
    entry.axis = cpvforangle(double(base.frame_a.angle));
    entry.collide = base.collide_connected;
    entry.break_force = base.break_force;
    entry.break_torque = base.break_torque;
    // Bodies count full turns; a joint begins within half a turn of 0.
    const double first = double(base.frame_a.angle) - double(base.frame_b.angle);
    const double turned = cpBodyGetAngle(entry.b) - cpBodyGetAngle(entry.a) - first;
    entry.reference = first + two_pi * std::round(turned / two_pi);
}

cpConstraint*& ChipmunkJoints::add(Entry& entry, Part part, cpConstraint* made) const {
    cpConstraintSetCollideBodies(made, entry.collide ? cpTrue : cpFalse);
    cpConstraintSetUserData(made, index_as_data(static_cast<std::size_t>(&entry - joints_.data())));
    return entry.parts[part] = cpSpaceAddConstraint(space_, made);
}

void ChipmunkJoints::drop(Entry& entry, Part part) const {
    if (entry.parts[part] == nullptr) return;
    cpSpaceRemoveConstraint(space_, entry.parts[part]);
    cpConstraintFree(entry.parts[part]);
    entry.parts[part] = nullptr;
}

void ChipmunkJoints::make(const SceneJoint& joint, cpBody* a, cpBody* b) {
    const std::size_t index = joints_.size();
    Entry& entry = joints_.emplace_back();
    entry.a = a;
    entry.b = b;
    const auto kind_of = [](const auto& def) {
        using Def = std::decay_t<decltype(def)>;
        if (std::is_same_v<Def, RevoluteJointDef>) return Coordinate::angle;
        if (std::is_same_v<Def, DistanceJointDef>) return Coordinate::length;
        return std::is_same_v<Def, PrismaticJointDef> || std::is_same_v<Def, WheelJointDef> ? Coordinate::way : Coordinate::none;
    };
    entry.coordinate = std::visit(kind_of, joint.def);
    if (const auto* gear = std::get_if<GearJointDef>(&joint.def)) {
        entry.break_torque = gear->break_torque;
        mesh(entry, joint, double(gear->ratio));
        gears_.push_back(index);
    } else if (const auto* mouse = std::get_if<MouseJointDef>(&joint.def)) {
        entry.a = cpSpaceGetStaticBody(space_);
        entry.anchor_a = to_cp(mouse->target);
        entry.anchor_b = cpBodyWorldToLocal(b, entry.anchor_a);
        entry.collide = true;
    } else {
        const auto place_it = [this, &entry](const auto& def) {
            if constexpr (requires { def.base; }) place(entry, def.base);
        };
        std::visit(place_it, joint.def);
    }
    std::visit(Setter{*this, entry}, joint.def);
}

/// angle 1 + ratio * angle 2 stays what it is: to Chipmunk, angle b * ratio' - angle a = phase.
void ChipmunkJoints::mesh(Entry& gear, const SceneJoint& joint, double ratio) const {
    const Entry &first = joints_.at(joint.body_a), &second = joints_.at(joint.body_b);
    const auto turns_on_ground = [](const Entry& of) {
        return of.coordinate == Coordinate::angle && cpBodyGetType(of.a) == CP_BODY_TYPE_STATIC;
    };
    if (!turns_on_ground(first) || !turns_on_ground(second)) {
        throw std::runtime_error("Chipmunk 7 has no gears but between hinges on static bodies");
    }
    gear.a = first.b;
    gear.b = second.b;
    gear.joint1 = joint.body_a;
    gear.joint2 = joint.body_b;
    gear.collide = true;
    const double kept = cpBodyGetAngle(gear.a) + ratio * cpBodyGetAngle(gear.b);
    if (inverse_moment(gear.a, gear.b) > 0) add(gear, angle, cpGearJointNew(gear.a, gear.b, -kept, -ratio));
}

void ChipmunkJoints::change(std::size_t index, const SceneJoint& joint) { std::visit(Setter{*this, joints_.at(index)}, joint.def); }

void ChipmunkJoints::destroy(std::size_t index) {
    Entry& entry = joints_.at(index);
    for (std::size_t part = 0; part < part_count; ++part) drop(entry, static_cast<Part>(part));
    entry = {};
    for (const std::size_t gear : gears_) {
        if (exists(gear) && (joints_[gear].joint1 == index || joints_[gear].joint2 == index)) destroy(gear);
    }
}

void ChipmunkJoints::destroy_joints_of(cpBody* body) {
    std::vector<std::size_t> found;  // a joint as often as it has constraints
    const auto note = [](cpBody*, cpConstraint* part, void* list) {
        static_cast<std::vector<std::size_t>*>(list)->push_back(index_of(part));
    };
    cpBodyEachConstraint(body, note, &found);
    for (const std::size_t index : found) {
        if (exists(index)) destroy(index);
    }
}

void ChipmunkJoints::break_overloaded(double h) {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const Entry& entry = joints_[i];
        if (entry.b == nullptr) continue;
        const bool pulled = entry.break_force > 0 && length(force(i, h)) > entry.break_force;
        const bool twisted = entry.break_torque > 0 && std::abs(torque(i, h)) > entry.break_torque;
        if (pulled || twisted) destroy(i);
    }
}

std::size_t ChipmunkJoints::count() const {
    return static_cast<std::size_t>(std::count_if(joints_.begin(), joints_.end(), [](const Entry& e) { return e.b != nullptr; }));
}

}  // namespace islet::engines
