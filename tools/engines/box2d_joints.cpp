#include "box2d_joints.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <memory>

#include "box2d_engine.hpp"
#include "motor_or_friction.hpp"

namespace islet::engines {

using samples::SceneJoint;

namespace {

b2Vec2 to_b2(Vec2 v) { return {v.x, v.y}; }
b2Vec2 to_b2(Rot q) { return {q.c, q.s}; }

/// What a joint's spring is to Box2D.
struct Stiffness {
    float stiffness = 0, damping = 0;
};

/// 1 / (what a unit impulse at `point` along `axis` changes in the body's speed there), 1/kg.
float inverse_mass_at(const b2Body& body, b2Vec2 point, b2Vec2 axis) {
    if (body.GetType() != b2_dynamicBody) return 0;
    const float inertia = body.GetInertia() - body.GetMass() * body.GetLocalCenter().LengthSquared();
    const float arm = b2Cross(point - body.GetWorldCenter(), axis);
    return 1 / body.GetMass() + (inertia > 0 ? arm * arm / inertia : 0);
}

/// A spring along an axis through the joint. b2LinearStiffness leaves out that a body gives way by turning too; with it the frequency is the one
/// asked for, which is what Islet means by it.
Stiffness spring_along(const b2JointDef& def, b2Vec2 point_a, b2Vec2 point_b, b2Vec2 axis, const JointSpring& spring) {
    if (!spring.enable) return {};
    const float mass = 1 / (inverse_mass_at(*def.bodyA, point_a, axis) + inverse_mass_at(*def.bodyB, point_b, axis));
    const float omega = 2 * pi * spring.hertz;
    return {mass * omega * omega, 2 * mass * spring.damping_ratio * omega};
}

/// The definition of each kind of joint; std::visit picks one.
struct Maker {
    b2Body *a, *b;
    b2Body* nothing;
    b2Joint *joint1, *joint2;  // of a gear

    /// Shared, because a shared pointer destroys what was made: the definitions have no virtual destructor.
    using Made = std::shared_ptr<b2JointDef>;

    template <class Def>
    void fill(Def& def, const JointBase& base) const {
        def.bodyA = a;
        def.bodyB = b;
        def.collideConnected = base.collide_connected;
        def.localAnchorA = to_b2(base.frame_a.position);
        def.localAnchorB = to_b2(base.frame_b.position);
    }
    static float reference_angle(const JointBase& base) { return base.frame_a.angle - base.frame_b.angle; }

    Made operator()(const RevoluteJointDef& from) const {
        auto def = std::make_unique<b2RevoluteJointDef>();
        fill(*def, from.base);
        def->referenceAngle = reference_angle(from.base);
        def->enableLimit = from.limit.enable;
        def->lowerAngle = from.limit.lower;
        def->upperAngle = from.limit.upper;
        const JointMotor motor = motor_or_friction(from.motor, from.friction);
        def->enableMotor = motor.enable;
        def->motorSpeed = motor.speed;
        def->maxMotorTorque = motor.max_force;
        return def;
    }
    Made operator()(const PrismaticJointDef& from) const {
        auto def = std::make_unique<b2PrismaticJointDef>();
        fill(*def, from.base);
        def->referenceAngle = reference_angle(from.base);
        def->localAxisA = to_b2(make_rot(from.base.frame_a.angle));
        def->enableLimit = from.limit.enable;
        def->lowerTranslation = from.limit.lower;
        def->upperTranslation = from.limit.upper;
        const JointMotor motor = motor_or_friction(from.motor, from.friction);
        def->enableMotor = motor.enable;
        def->motorSpeed = motor.speed;
        def->maxMotorForce = motor.max_force;
        return def;
    }
    Made operator()(const DistanceJointDef& from) const {
        auto def = std::make_unique<b2DistanceJointDef>();
        fill(*def, from.base);
        def->length = from.length;
        if (!from.spring.enable && !from.limit.enable) def->minLength = def->maxLength = from.length;
        if (from.limit.enable) {
            def->minLength = from.limit.lower;
            def->maxLength = from.limit.upper;
        }
        const b2Vec2 point_a = a->GetWorldPoint(def->localAnchorA), point_b = b->GetWorldPoint(def->localAnchorB);
        b2Vec2 axis = point_b - point_a;
        axis.Normalize();
        const Stiffness spring = spring_along(*def, point_a, point_b, axis, from.spring);
        def->stiffness = spring.stiffness;
        def->damping = spring.damping;
        return def;
    }
    Made operator()(const WeldJointDef& from) const {
        auto def = std::make_unique<b2WeldJointDef>();
        fill(*def, from.base);
        def->referenceAngle = reference_angle(from.base);
        if (from.angular_hertz > 0) b2AngularStiffness(def->stiffness, def->damping, from.angular_hertz, from.angular_damping_ratio, a, b);
        return def;
    }
    Made operator()(const WheelJointDef& from) const {
        auto def = std::make_unique<b2WheelJointDef>();
        fill(*def, from.base);
        def->localAxisA = to_b2(make_rot(from.base.frame_a.angle));
        def->enableLimit = from.limit.enable;
        def->lowerTranslation = from.limit.lower;
        def->upperTranslation = from.limit.upper;
        const JointMotor motor = motor_or_friction(from.motor, from.friction);
        def->enableMotor = motor.enable;
        def->motorSpeed = motor.speed;
        def->maxMotorTorque = motor.max_force;
        const b2Vec2 point = b->GetWorldPoint(def->localAnchorB);  // A feels the strut's force where B is
        const Stiffness spring = spring_along(*def, point, point, a->GetWorldVector(def->localAxisA), from.spring);
        def->stiffness = spring.stiffness;
        def->damping = spring.damping;
        return def;
    }
    Made operator()(const MotorJointDef& from) const {
        auto def = std::make_unique<b2MotorJointDef>();
        def->bodyA = a;
        def->bodyB = b;
        def->collideConnected = from.base.collide_connected;
        def->maxForce = from.max_force;
        def->maxTorque = from.max_torque;
        def->correctionFactor = 0;
        return def;
    }
    Made operator()(const MouseJointDef& from) const {
        auto def = std::make_unique<b2MouseJointDef>();
        def->bodyA = nothing;
        def->bodyB = b;
        def->collideConnected = true;
        def->target = to_b2(from.target);
        def->maxForce = from.max_force;
        b2LinearStiffness(def->stiffness, def->damping, from.hertz, from.damping_ratio, nothing, b);
        return def;
    }
    Made operator()(const PulleyJointDef& from) const {
        auto def = std::make_unique<b2PulleyJointDef>();
        fill(*def, from.base);
        def->groundAnchorA = to_b2(from.ground_a);
        def->groundAnchorB = to_b2(from.ground_b);
        def->lengthA = b2Distance(a->GetWorldPoint(def->localAnchorA), def->groundAnchorA);
        def->lengthB = b2Distance(b->GetWorldPoint(def->localAnchorB), def->groundAnchorB);
        def->ratio = from.ratio;
        return def;
    }
    Made operator()(const GearJointDef& from) const {
        auto def = std::make_unique<b2GearJointDef>();
        def->joint1 = joint1;
        def->joint2 = joint2;
        def->bodyA = joint1->GetBodyB();
        def->bodyB = joint2->GetBodyB();
        def->ratio = from.ratio;
        return def;
    }
    Made operator()(const AngleJointDef&) const { throw std::runtime_error("Box2D 2 has no angle joints"); }
};

template <class Joint>
void set_rotary(Joint& joint, const JointMotor& motor, float friction) {
    const JointMotor set = motor_or_friction(motor, friction);
    joint.SetMotorSpeed(set.speed);
    joint.SetMaxMotorTorque(set.max_force);
    joint.EnableMotor(set.enable);
}

/// Passes a definition on to a joint of its kind.
struct Changer {
    b2Joint* joint;

    void operator()(const RevoluteJointDef& def) const {
        auto& revolute = static_cast<b2RevoluteJoint&>(*joint);
        set_rotary(revolute, def.motor, def.friction);
        revolute.SetLimits(def.limit.lower, def.limit.upper);
        revolute.EnableLimit(def.limit.enable);
    }
    void operator()(const PrismaticJointDef& def) const {
        auto& slider = static_cast<b2PrismaticJoint&>(*joint);
        const JointMotor motor = motor_or_friction(def.motor, def.friction);
        slider.SetMotorSpeed(motor.speed);
        slider.SetMaxMotorForce(motor.max_force);
        slider.EnableMotor(motor.enable);
        slider.SetLimits(def.limit.lower, def.limit.upper);
        slider.EnableLimit(def.limit.enable);
    }
    void operator()(const WheelJointDef& def) const {
        auto& wheel = static_cast<b2WheelJoint&>(*joint);
        set_rotary(wheel, def.motor, def.friction);
        wheel.SetLimits(def.limit.lower, def.limit.upper);
        wheel.EnableLimit(def.limit.enable);
    }
    void operator()(const DistanceJointDef& def) const {
        auto& rod = static_cast<b2DistanceJoint&>(*joint);
        if (!def.limit.enable) return;
        rod.SetMaxLength(def.limit.upper);
        rod.SetMinLength(def.limit.lower);
    }
    void operator()(const MouseJointDef& def) const { static_cast<b2MouseJoint&>(*joint).SetTarget(to_b2(def.target)); }
    template <class Def>
    void operator()(const Def&) const {}
};

/// The first feature missing for each kind of joint.
struct Lacks {
    std::string operator()(const RevoluteJointDef& def) const {
        if (def.spring.enable) return "spring on a hinge";
        return def.motor.enable && def.friction > 0 ? "friction beside a motor" : "";
    }
    std::string operator()(const PrismaticJointDef& def) const {
        if (def.spring.enable) return "spring on a slider";
        return def.motor.enable && def.friction > 0 ? "friction beside a motor" : "";
    }
    std::string operator()(const WheelJointDef& def) const {
        if (def.spring.enable && def.spring.target != 0) return "strut that rests elsewhere than at 0";
        return def.motor.enable && def.friction > 0 ? "friction beside a motor" : "";
    }
    std::string operator()(const DistanceJointDef& def) const { return def.motor.enable ? "motor on a rod" : ""; }
    std::string operator()(const WeldJointDef& def) const { return def.linear_hertz > 0 ? "weld that gives way sideways" : ""; }
    std::string operator()(const MotorJointDef& def) const {
        if (def.linear_hertz > 0 || def.angular_hertz > 0) return "motor joint with a frequency";
        const bool moves = def.linear_velocity.x != 0 || def.linear_velocity.y != 0 || def.angular_velocity != 0;
        return moves ? "motor joint that drives a velocity" : "";
    }
    std::string operator()(const AngleJointDef&) const { return "angle joint"; }
    template <class Def>
    std::string operator()(const Def&) const {
        return {};
    }
};

}  // namespace

std::string joint_lacks(const SceneJoint& joint) { return std::visit(Lacks{}, joint.def); }

void Box2dJoints::load(b2World& world) {
    world_ = &world;
    world_->SetDestructionListener(this);
    joints_.clear();
    const b2BodyDef nothing;
    nothing_ = world_->CreateBody(&nothing);
}

void Box2dJoints::make(const std::vector<b2Body*>& bodies, const SceneJoint& joint) {
    const bool gear = std::holds_alternative<GearJointDef>(joint.def);
    Maker maker{nullptr, nullptr, nothing_, nullptr, nullptr};
    if (gear) {
        maker.joint1 = joints_.at(joint.body_a).joint;
        maker.joint2 = joints_.at(joint.body_b).joint;
    } else {
        maker.a = bodies.at(joint.body_a);
        maker.b = bodies.at(joint.body_b);
    }
    const auto def = std::visit(maker, joint.def);
    def->userData.pointer = joints_.size();

    Entry entry{world_->CreateJoint(def.get())};
    const auto strength = [&entry](const auto& from) {
        if constexpr (requires { from.base; }) {
            entry.break_force = from.base.break_force;
            entry.break_torque = from.base.break_torque;
        } else if constexpr (requires { from.break_torque; }) {
            entry.break_torque = from.break_torque;
        }
    };
    std::visit(strength, joint.def);
    joints_.push_back(entry);
}

void Box2dJoints::change(std::size_t index, const SceneJoint& joint) { std::visit(Changer{joints_.at(index).joint}, joint.def); }

void Box2dJoints::destroy(std::size_t index) {
    b2Joint* joint = joints_.at(index).joint;
    for (Entry& entry : joints_) {
        if (entry.joint == nullptr || entry.joint->GetType() != e_gearJoint) continue;
        auto& gear = static_cast<b2GearJoint&>(*entry.joint);
        if (gear.GetJoint1() != joint && gear.GetJoint2() != joint) continue;
        world_->DestroyJoint(entry.joint);
        entry.joint = nullptr;
    }
    world_->DestroyJoint(joint);
    joints_[index].joint = nullptr;
}

void Box2dJoints::destroy_gears_of(const b2Body& body) {
    const auto uses = [&body](const b2Joint* joint) {
        auto* j = const_cast<b2Joint*>(joint);
        return j->GetBodyA() == &body || j->GetBodyB() == &body;
    };
    for (Entry& entry : joints_) {
        if (entry.joint == nullptr || entry.joint->GetType() != e_gearJoint) continue;
        auto& gear = static_cast<b2GearJoint&>(*entry.joint);
        if (!uses(gear.GetJoint1()) && !uses(gear.GetJoint2())) continue;
        world_->DestroyJoint(entry.joint);
        entry.joint = nullptr;
    }
}

void Box2dJoints::break_overloaded(float h) {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const Entry& entry = joints_[i];
        if (entry.joint == nullptr) continue;
        const bool pulled = entry.break_force > 0 && entry.joint->GetReactionForce(1 / h).Length() > entry.break_force;
        const bool twisted = entry.break_torque > 0 && std::abs(entry.joint->GetReactionTorque(1 / h)) > entry.break_torque;
        if (pulled || twisted) destroy(i);
    }
}

std::size_t Box2dJoints::count() const {
    return static_cast<std::size_t>(std::count_if(joints_.begin(), joints_.end(), [](const Entry& e) { return e.joint != nullptr; }));
}

float Box2dJoints::position(std::size_t index) const {
    b2Joint* joint = joints_.at(index).joint;
    switch (joint->GetType()) {
    case e_revoluteJoint: return static_cast<b2RevoluteJoint*>(joint)->GetJointAngle();
    case e_prismaticJoint: return static_cast<b2PrismaticJoint*>(joint)->GetJointTranslation();
    case e_wheelJoint: return static_cast<b2WheelJoint*>(joint)->GetJointTranslation();
    case e_distanceJoint: return static_cast<b2DistanceJoint*>(joint)->GetCurrentLength();
    default: return 0;
    }
}

float Box2dJoints::speed(std::size_t index) const {
    b2Joint* joint = joints_.at(index).joint;
    switch (joint->GetType()) {
    case e_revoluteJoint: return static_cast<b2RevoluteJoint*>(joint)->GetJointSpeed();
    case e_prismaticJoint: return static_cast<b2PrismaticJoint*>(joint)->GetJointSpeed();
    case e_wheelJoint: return static_cast<b2WheelJoint*>(joint)->GetJointLinearSpeed();
    case e_distanceJoint: {
        b2Vec2 along = joint->GetAnchorB() - joint->GetAnchorA();
        along.Normalize();
        return b2Dot(along, joint->GetBodyB()->GetLinearVelocityFromWorldPoint(joint->GetAnchorB()) -
                                joint->GetBodyA()->GetLinearVelocityFromWorldPoint(joint->GetAnchorA()));
    }
    default: return 0;
    }
}

float Box2dJoints::motor_force(std::size_t index, float h) const {
    b2Joint* joint = joints_.at(index).joint;
    switch (joint->GetType()) {
    case e_revoluteJoint: return static_cast<b2RevoluteJoint*>(joint)->GetMotorTorque(1 / h);
    case e_prismaticJoint: return static_cast<b2PrismaticJoint*>(joint)->GetMotorForce(1 / h);
    case e_wheelJoint: return static_cast<b2WheelJoint*>(joint)->GetMotorTorque(1 / h);
    default: return 0;
    }
}

Vec2 Box2dJoints::force(std::size_t index, float h) const {
    b2Joint* joint = joints_.at(index).joint;
    b2Vec2 force = joint->GetReactionForce(1 / h);
    // Of a pulley Box2D tells the pull on A's side, along the rope away from the pulley.
    if (joint->GetType() == e_pulleyJoint) force = -static_cast<b2PulleyJoint*>(joint)->GetRatio() * force;
    return {force.x, force.y};
}

float Box2dJoints::torque(std::size_t index, float h) const { return joints_.at(index).joint->GetReactionTorque(1 / h); }

void Box2dJoints::SayGoodbye(b2Joint* joint) { joints_[joint->GetUserData().pointer].joint = nullptr; }

// -- the engine's own functions about joints -----------------------------------------------------------------------------------------

void Box2dEngine::change_joint(std::size_t index) { joints_->change(index, joint(index)); }
void Box2dEngine::destroy_joint(std::size_t index) { joints_->destroy(index); }
bool Box2dEngine::joint_exists(std::size_t index) const { return joints_->exists(index); }
float Box2dEngine::joint_position(std::size_t index) const { return joints_->position(index); }
float Box2dEngine::joint_speed(std::size_t index) const { return joints_->speed(index); }
float Box2dEngine::motor_force(std::size_t index) const { return joints_->motor_force(index, substep_); }
Vec2 Box2dEngine::joint_force(std::size_t index) const { return joints_->force(index, substep_); }
float Box2dEngine::joint_torque(std::size_t index) const { return joints_->torque(index, substep_); }

}  // namespace islet::engines
