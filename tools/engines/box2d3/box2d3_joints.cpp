#include <stdexcept>

#include "box2d3_parts.hpp"
#include "engines/motor_or_friction.hpp"

namespace islet::engines {

using samples::JointDef;
using samples::SceneJoint;

namespace {

/// Makes each kind of joint; std::visit picks one.
struct Maker {
    b2WorldId world;
    b2BodyId a, b;

    template <class Def>
    void fill(Def& def, const JointBase& base) const {
        def.base.bodyIdA = a;
        def.base.bodyIdB = b;
        def.base.localFrameA = {to_b2(base.frame_a.position), b2MakeRot(base.frame_a.angle)};
        def.base.localFrameB = {to_b2(base.frame_b.position), b2MakeRot(base.frame_b.angle)};
        def.base.collideConnected = base.collide_connected;
    }
    template <class Def>
    static void fill_spring(Def& def, const JointSpring& spring) {
        def.enableSpring = spring.enable;
        def.hertz = spring.hertz;
        def.dampingRatio = spring.damping_ratio;
    }

    b2JointId operator()(const RevoluteJointDef& from) const {
        b2RevoluteJointDef def = b2DefaultRevoluteJointDef();
        fill(def, from.base);
        fill_spring(def, from.spring);
        def.targetAngle = from.spring.target;
        def.enableLimit = from.limit.enable;
        def.lowerAngle = from.limit.lower;
        def.upperAngle = from.limit.upper;
        const JointMotor motor = motor_or_friction(from.motor, from.friction);
        def.enableMotor = motor.enable;
        def.motorSpeed = motor.speed;
        def.maxMotorTorque = motor.max_force;
        return b2CreateRevoluteJoint(world, &def);
    }
    b2JointId operator()(const PrismaticJointDef& from) const {
        b2PrismaticJointDef def = b2DefaultPrismaticJointDef();
        fill(def, from.base);
        fill_spring(def, from.spring);
        def.targetTranslation = from.spring.target;
        def.enableLimit = from.limit.enable;
        def.lowerTranslation = from.limit.lower;
        def.upperTranslation = from.limit.upper;
        const JointMotor motor = motor_or_friction(from.motor, from.friction);
        def.enableMotor = motor.enable;
        def.motorSpeed = motor.speed;
        def.maxMotorForce = motor.max_force;
        return b2CreatePrismaticJoint(world, &def);
    }
    b2JointId operator()(const DistanceJointDef& from) const {
        b2DistanceJointDef def = b2DefaultDistanceJointDef();
        fill(def, from.base);
        fill_spring(def, from.spring);
        def.length = from.length;
        def.enableMotor = from.motor.enable;
        def.motorSpeed = from.motor.speed;
        def.maxMotorForce = from.motor.max_force;
        if (from.limit.enable) {
            def.enableLimit = true;
            def.minLength = from.limit.lower;
            def.maxLength = from.limit.upper;
            def.enableSpring = true;  // without a spring, which may have no stiffness, Box2D's rod is rigid in spite of its limit
        }
        if (from.motor.enable) def.enableSpring = true;
        if (!from.spring.enable) def.hertz = 0;
        return b2CreateDistanceJoint(world, &def);
    }
    b2JointId operator()(const WeldJointDef& from) const {
        b2WeldJointDef def = b2DefaultWeldJointDef();
        fill(def, from.base);
        def.linearHertz = from.linear_hertz;
        def.linearDampingRatio = from.linear_damping_ratio;
        def.angularHertz = from.angular_hertz;
        def.angularDampingRatio = from.angular_damping_ratio;
        return b2CreateWeldJoint(world, &def);
    }
    b2JointId operator()(const WheelJointDef& from) const {
        b2WheelJointDef def = b2DefaultWheelJointDef();
        fill(def, from.base);
        fill_spring(def, from.spring);
        def.enableLimit = from.limit.enable;
        def.lowerTranslation = from.limit.lower;
        def.upperTranslation = from.limit.upper;
        const JointMotor motor = motor_or_friction(from.motor, from.friction);
        def.enableMotor = motor.enable;
        def.motorSpeed = motor.speed;
        def.maxMotorTorque = motor.max_force;
        return b2CreateWheelJoint(world, &def);
    }
    b2JointId operator()(const MotorJointDef& from) const {
        b2MotorJointDef def = b2DefaultMotorJointDef();
        fill(def, from.base);
        if (from.linear_hertz > 0) {
            def.linearHertz = from.linear_hertz;
            def.linearDampingRatio = from.linear_damping_ratio;
            def.maxSpringForce = from.max_force;
        } else {
            def.linearVelocity = to_b2(from.linear_velocity);
            def.maxVelocityForce = from.max_force;
        }
        if (from.angular_hertz > 0) {
            def.angularHertz = from.angular_hertz;
            def.angularDampingRatio = from.angular_damping_ratio;
            def.maxSpringTorque = from.max_torque;
        } else {
            def.angularVelocity = from.angular_velocity;
            def.maxVelocityTorque = from.max_torque;
        }
        return b2CreateMotorJoint(world, &def);
    }
    /// A spring from the point of the body that is at the target to the target.
    b2JointId operator()(const MouseJointDef& from) const {
        b2MotorJointDef def = b2DefaultMotorJointDef();
        def.base.bodyIdA = a;
        def.base.bodyIdB = b;
        def.base.localFrameA.p = to_b2(from.target);
        def.base.localFrameB.p = b2Body_GetLocalPoint(b, to_b2_place(from.target));
        def.base.collideConnected = true;
        def.linearHertz = from.hertz;
        def.linearDampingRatio = from.damping_ratio;
        def.maxSpringForce = from.max_force;
        return b2CreateMotorJoint(world, &def);
    }
    template <class Def>
    b2JointId operator()(const Def&) const {
        throw std::runtime_error("Box2D 3 has no such joint");
    }
};

struct Changer {
    b2JointId id;

    void operator()(const RevoluteJointDef& def) const {
        const JointMotor motor = motor_or_friction(def.motor, def.friction);
        b2RevoluteJoint_SetMotorSpeed(id, motor.speed);
        b2RevoluteJoint_SetMaxMotorTorque(id, motor.max_force);
        b2RevoluteJoint_EnableMotor(id, motor.enable);
        b2RevoluteJoint_SetLimits(id, def.limit.lower, def.limit.upper);
        b2RevoluteJoint_EnableLimit(id, def.limit.enable);
        b2RevoluteJoint_SetSpringHertz(id, def.spring.hertz);
        b2RevoluteJoint_SetSpringDampingRatio(id, def.spring.damping_ratio);
        b2RevoluteJoint_SetTargetAngle(id, def.spring.target);
        b2RevoluteJoint_EnableSpring(id, def.spring.enable);
    }
    void operator()(const PrismaticJointDef& def) const {
        const JointMotor motor = motor_or_friction(def.motor, def.friction);
        b2PrismaticJoint_SetMotorSpeed(id, motor.speed);
        b2PrismaticJoint_SetMaxMotorForce(id, motor.max_force);
        b2PrismaticJoint_EnableMotor(id, motor.enable);
        b2PrismaticJoint_SetLimits(id, def.limit.lower, def.limit.upper);
        b2PrismaticJoint_EnableLimit(id, def.limit.enable);
        b2PrismaticJoint_SetSpringHertz(id, def.spring.hertz);
        b2PrismaticJoint_SetSpringDampingRatio(id, def.spring.damping_ratio);
        b2PrismaticJoint_SetTargetTranslation(id, def.spring.target);
        b2PrismaticJoint_EnableSpring(id, def.spring.enable);
    }
    void operator()(const WheelJointDef& def) const {
        const JointMotor motor = motor_or_friction(def.motor, def.friction);
        b2WheelJoint_SetMotorSpeed(id, motor.speed);
        b2WheelJoint_SetMaxMotorTorque(id, motor.max_force);
        b2WheelJoint_EnableMotor(id, motor.enable);
        b2WheelJoint_SetLimits(id, def.limit.lower, def.limit.upper);
        b2WheelJoint_EnableLimit(id, def.limit.enable);
        b2WheelJoint_SetSpringHertz(id, def.spring.hertz);
        b2WheelJoint_SetSpringDampingRatio(id, def.spring.damping_ratio);
        b2WheelJoint_EnableSpring(id, def.spring.enable);
    }
    void operator()(const DistanceJointDef& def) const {
        b2DistanceJoint_SetMotorSpeed(id, def.motor.speed);
        b2DistanceJoint_SetMaxMotorForce(id, def.motor.max_force);
        b2DistanceJoint_EnableMotor(id, def.motor.enable);
        b2DistanceJoint_EnableSpring(id, def.spring.enable || def.limit.enable || def.motor.enable);
        b2DistanceJoint_SetSpringHertz(id, def.spring.enable ? def.spring.hertz : 0);
        b2DistanceJoint_SetSpringDampingRatio(id, def.spring.damping_ratio);
        b2DistanceJoint_EnableLimit(id, def.limit.enable);
        if (def.limit.enable) b2DistanceJoint_SetLengthRange(id, def.limit.lower, def.limit.upper);
    }
    void operator()(const MouseJointDef& def) const { b2Joint_SetLocalFrameA(id, {to_b2(def.target), b2Rot_identity}); }
    template <class Def>
    void operator()(const Def&) const {}
};

/// The first feature missing for each kind of joint.
struct Lacks {
    static std::string friction(const JointMotor& motor, float force) { return motor.enable && force > 0 ? "friction beside a motor" : ""; }
    static std::string limit(const JointLimit& limit) {
        const float most = 0.99f * pi;
        return limit.enable && (limit.lower < -most || limit.upper > most) ? "limit beyond 0.99 half turns" : "";
    }
    std::string operator()(const RevoluteJointDef& def) const {
        const std::string what = limit(def.limit);
        return what.empty() ? friction(def.motor, def.friction) : what;
    }
    std::string operator()(const PrismaticJointDef& def) const { return friction(def.motor, def.friction); }
    std::string operator()(const WheelJointDef& def) const {
        return def.spring.enable && def.spring.target != 0 ? "strut that rests elsewhere than at 0" : friction(def.motor, def.friction);
    }
    std::string operator()(const PulleyJointDef&) const { return "pulley"; }
    std::string operator()(const GearJointDef&) const { return "gear"; }
    std::string operator()(const AngleJointDef&) const { return "angle joint"; }
    template <class Def>
    std::string operator()(const Def&) const {
        return {};
    }
};

/// Where the points of the two frames are, and A's x axis.
struct Points {
    b2BodyId a, b;
    Vec2 on_a, on_b, axis;

    explicit Points(b2JointId id) : a(b2Joint_GetBodyA(id)), b(b2Joint_GetBodyB(id)) {
        const b2Transform frame = b2Joint_GetLocalFrameA(id);
        on_a = from_b2_place(b2Body_GetWorldPoint(a, frame.p));
        on_b = from_b2_place(b2Body_GetWorldPoint(b, b2Joint_GetLocalFrameB(id).p));
        axis = from_b2(b2Body_GetWorldVector(a, {frame.q.c, frame.q.s}));
    }
    /// m/s, of B's point past the point of A that is where `from` is.
    Vec2 velocity(Vec2 from) const {
        return from_b2(b2Body_GetWorldPointVelocity(b, to_b2_place(on_b))) - from_b2(b2Body_GetWorldPointVelocity(a, to_b2_place(from)));
    }
};

}  // namespace

std::string box2d3_joint_lacks(const SceneJoint& joint) { return std::visit(Lacks{}, joint.def); }

b2JointId make_box2d3_joint(b2WorldId world, b2BodyId a, b2BodyId b, const JointDef& joint) { return std::visit(Maker{world, a, b}, joint); }

void change_box2d3_joint(b2JointId id, const JointDef& joint) {
    b2Joint_WakeBodies(id);
    std::visit(Changer{id}, joint);
}

float box2d3_joint_position(b2JointId id) {
    switch (b2Joint_GetType(id)) {
        case b2_revoluteJoint: return b2RevoluteJoint_GetAngle(id);
        case b2_prismaticJoint: return b2PrismaticJoint_GetTranslation(id);
        case b2_distanceJoint: return b2DistanceJoint_GetCurrentLength(id);
        case b2_wheelJoint: {
            const Points points(id);
            return dot(points.on_b - points.on_a, points.axis);
        }
        default: return 0;
    }
}

float box2d3_joint_speed(b2JointId id) {
    const Points points(id);
    switch (b2Joint_GetType(id)) {
        case b2_revoluteJoint: return b2Body_GetAngularVelocity(points.b) - b2Body_GetAngularVelocity(points.a);
        case b2_prismaticJoint:
        case b2_wheelJoint: return dot(points.velocity(points.on_b), points.axis);
        case b2_distanceJoint: {
            const Vec2 d = points.on_b - points.on_a;
            const float length = islet::length(d);
            return length > 0 ? dot(points.velocity(points.on_a), d) / length : 0;
        }
        default: return 0;
    }
}

float box2d3_motor_force(b2JointId id) {
    switch (b2Joint_GetType(id)) {
        case b2_revoluteJoint: return b2RevoluteJoint_GetMotorTorque(id);
        case b2_prismaticJoint: return b2PrismaticJoint_GetMotorForce(id);
        case b2_wheelJoint: return b2WheelJoint_GetMotorTorque(id);
        case b2_distanceJoint: return b2DistanceJoint_GetMotorForce(id);
        default: return 0;
    }
}

}  // namespace islet::engines
