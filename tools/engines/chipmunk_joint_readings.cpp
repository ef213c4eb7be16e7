// What the joints of Chipmunk are doing.
#include "chipmunk_joints.hpp"

#include <chipmunk/chipmunk_structs.h>

#include "chipmunk_engine.hpp"
#include "chipmunk_shapes.hpp"

namespace islet::engines {

namespace {

/// The constraint as what it is: Chipmunk's functions tell of one only how large its impulse is.
template <class Constraint>
const Constraint& as(const cpConstraint* constraint) {
    return *reinterpret_cast<const Constraint*>(constraint);
}

}  // namespace

float ChipmunkJoints::position(std::size_t index) const {
    const Entry& e = joints_.at(index);
    const cpVect d = cpvsub(cpBodyLocalToWorld(e.b, e.anchor_b), cpBodyLocalToWorld(e.a, e.anchor_a));
    switch (e.coordinate) {
    case Coordinate::angle: return static_cast<float>(cpBodyGetAngle(e.b) - cpBodyGetAngle(e.a) - e.reference);
    case Coordinate::way: return static_cast<float>(cpvdot(d, cpvrotate(e.axis, cpBodyGetRotation(e.a))));
    case Coordinate::length: return static_cast<float>(cpvlength(d));
    default: return 0;
    }
}

float ChipmunkJoints::speed(std::size_t index) const {
    const Entry& e = joints_.at(index);
    if (e.coordinate == Coordinate::none) return 0;
    if (e.coordinate == Coordinate::angle) return static_cast<float>(cpBodyGetAngularVelocity(e.b) - cpBodyGetAngularVelocity(e.a));
    const cpVect at = cpBodyLocalToWorld(e.b, e.anchor_b), from = cpBodyLocalToWorld(e.a, e.anchor_a);
    // As A's axis turns it sweeps over B as if it reached there; a length does not care.
    const bool way = e.coordinate == Coordinate::way;
    const cpVect along = way ? cpvrotate(e.axis, cpBodyGetRotation(e.a)) : cpvnormalize(cpvsub(at, from));
    const cpVect v = cpvsub(cpBodyGetVelocityAtWorldPoint(e.b, at), cpBodyGetVelocityAtWorldPoint(e.a, way ? at : from));
    return static_cast<float>(cpvdot(v, along));
}

float ChipmunkJoints::motor_force(std::size_t index, double h) const {
    const cpConstraint* drive = joints_.at(index).parts[motor];
    return drive != nullptr && h > 0 ? static_cast<float>(as<cpSimpleMotor>(drive).jAcc / h) : 0;
}

/// What the joint did to B in the last step, N s.
cpVect ChipmunkJoints::impulse(const Entry& entry) {
    cpVect sum = cpvzero;
    if (const cpConstraint* c = entry.parts[point]; c != nullptr) {
        if (cpConstraintIsPivotJoint(c)) sum = as<cpPivotJoint>(c).jAcc;
        if (cpConstraintIsGrooveJoint(c)) sum = as<cpGrooveJoint>(c).jAcc;
        if (cpConstraintIsPinJoint(c)) sum = cpvmult(as<cpPinJoint>(c).n, as<cpPinJoint>(c).jnAcc);
    }
    if (const cpConstraint* c = entry.parts[limit]; c != nullptr && cpConstraintIsSlideJoint(c))
        sum = cpvadd(sum, cpvmult(as<cpSlideJoint>(c).n, as<cpSlideJoint>(c).jnAcc));
    if (const cpConstraint* c = entry.parts[spring]; c != nullptr && cpConstraintIsDampedSpring(c))
        sum = cpvadd(sum, cpvmult(as<cpDampedSpring>(c).n, as<cpDampedSpring>(c).jAcc));
    return sum;
}

/// The same for angles, N m s; of a gear to joint 1's B.
double ChipmunkJoints::twist(const Entry& entry, double h) {
    double sum = 0;
    if (const cpConstraint* c = entry.parts[angle]; c != nullptr) {
        const auto& gear = as<cpGearJoint>(c);
        sum += entry.parts[point] != nullptr ? gear.jAcc : -gear.jAcc * gear.ratio_inv;
    }
    if (const cpConstraint* c = entry.parts[limit]; c != nullptr && cpConstraintIsRotaryLimitJoint(c))
        sum += as<cpRotaryLimitJoint>(c).jAcc;
    if (const cpConstraint* c = entry.parts[spring]; c != nullptr && cpConstraintIsDampedRotarySpring(c)) {
        // Chipmunk's sum takes the damping's part with the wrong sign: it is what is missing to the spring's own part.
        const auto& coil = as<cpDampedRotarySpring>(c);
        const double elastic = (cpBodyGetAngle(entry.a) - cpBodyGetAngle(entry.b) - coil.restAngle) * coil.stiffness * h;
        sum += 2 * elastic - coil.jAcc;
    }
    for (const Part part : {motor, friction}) {
        if (entry.parts[part] != nullptr) sum += as<cpSimpleMotor>(entry.parts[part]).jAcc;
    }
    return sum;
}

Vec2 ChipmunkJoints::force(std::size_t index, double h) const {
    return h > 0 ? from_cp(cpvmult(impulse(joints_.at(index)), 1 / h)) : Vec2{};
}

float ChipmunkJoints::torque(std::size_t index, double h) const {
    return h > 0 ? static_cast<float>(twist(joints_.at(index), h) / h) : 0;
}

// -- the engine's own functions about joints -----------------------------------------------------------------------------------------

void ChipmunkEngine::change_joint(std::size_t index) { joints_->change(index, joint(index)); }
void ChipmunkEngine::destroy_joint(std::size_t index) { joints_->destroy(index); }
bool ChipmunkEngine::joint_exists(std::size_t index) const { return joints_->exists(index); }
float ChipmunkEngine::joint_position(std::size_t index) const { return joints_->position(index); }
float ChipmunkEngine::joint_speed(std::size_t index) const { return joints_->speed(index); }
float ChipmunkEngine::motor_force(std::size_t index) const { return joints_->motor_force(index, last_step_); }
Vec2 ChipmunkEngine::joint_force(std::size_t index) const { return joints_->force(index, last_step_); }
float ChipmunkEngine::joint_torque(std::size_t index) const { return joints_->torque(index, last_step_); }

}  // namespace islet::engines
