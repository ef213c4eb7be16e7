#include "joint_measure.hpp"

#include <algorithm>
#include <cmath>

#include "checks.hpp"

namespace islet::samples {
namespace {

struct Point {
    double x = 0, y = 0;  // m
};

double distance_of(Point a, Point b) { return std::hypot(b.x - a.x, b.y - a.y); }
Point point_of(Vec2 v) { return {double(v.x), double(v.y)}; }

/// A joint's frame in the world.
struct Frame {
    Point at;
    double angle = 0;  // rad, up to whole turns
};

Frame world_frame(const Engine& engine, std::size_t body, const JointFrame& local) {
    const BodyState state = engine.body(body);
    const Rot q = make_rot(state.angle);
    const double x = double(local.position.x), y = double(local.position.y), c = double(q.c), s = double(q.s);
    return {{double(state.position.x) + c * x - s * y, double(state.position.y) + s * x + c * y},
            double(state.angle) + double(local.angle)};
}

/// How far a value is outside an enabled limit.
double beyond(const JointLimit& limit, double value) {
    if (!limit.enable) return 0;
    return std::max({0.0, double(limit.lower) - value, value - double(limit.upper)});
}

/// B's anchor seen from frame A.
Point in_frame(const Frame& a, Point p) {
    const double c = std::cos(a.angle), s = std::sin(a.angle), x = p.x - a.at.x, y = p.y - a.at.y;
    return {c * x + s * y, c * y - s * x};
}

double pulley_length(const Engine& engine, const SceneJoint& joint, const PulleyJointDef& def) {
    const Point a = world_frame(engine, joint.body_a, def.base.frame_a).at, b = world_frame(engine, joint.body_b, def.base.frame_b).at;
    return distance_of(a, point_of(def.ground_a)) + double(def.ratio) * distance_of(b, point_of(def.ground_b));
}

double gear_sum(const Engine& engine, const SceneJoint& joint, const GearJointDef& def) {
    return double(engine.joint_position(joint.body_a)) + double(def.ratio) * double(engine.joint_position(joint.body_b));
}

/// As JointError.
struct Off {
    double linear = 0, angular = 0;
};

/// The error of each kind of joint; std::visit picks one.
struct Measure {
    const Engine& engine;
    const SceneJoint& joint;
    std::size_t index;
    double constant;

    template <class Def>
    Frame frame_a(const Def& def) const {
        return world_frame(engine, joint.body_a, def.base.frame_a);
    }
    template <class Def>
    Frame frame_b(const Def& def) const {
        return world_frame(engine, joint.body_b, def.base.frame_b);
    }

    Off operator()(const RevoluteJointDef& def) const {
        const double angle = def.limit.enable ? double(engine.joint_position(index)) : 0;
        return {distance_of(frame_a(def).at, frame_b(def).at), beyond(def.limit, angle)};
    }
    Off operator()(const PrismaticJointDef& def) const {
        const Frame a = frame_a(def), b = frame_b(def);
        const Point way = in_frame(a, b.at);
        return {std::max(std::abs(way.y), beyond(def.limit, way.x)), std::abs(angle_difference(b.angle, a.angle))};
    }
    Off operator()(const WheelJointDef& def) const {
        const Point way = in_frame(frame_a(def), frame_b(def).at);
        return {std::max(std::abs(way.y), beyond(def.limit, way.x)), 0};
    }
    Off operator()(const DistanceJointDef& def) const {
        const double length = distance_of(frame_a(def).at, frame_b(def).at);
        const bool rod = !def.spring.enable && !def.limit.enable;
        return {rod ? std::abs(length - double(def.length)) : beyond(def.limit, length), 0};
    }
    Off operator()(const WeldJointDef& def) const {
        const Frame a = frame_a(def), b = frame_b(def);
        return {def.linear_hertz > 0 ? 0 : distance_of(a.at, b.at),
                def.angular_hertz > 0 ? 0 : std::abs(angle_difference(b.angle, a.angle))};
    }
    Off operator()(const MotorJointDef&) const { return {}; }
    Off operator()(const MouseJointDef&) const { return {}; }
    Off operator()(const PulleyJointDef& def) const { return {std::abs(pulley_length(engine, joint, def) - constant), 0}; }
    Off operator()(const GearJointDef& def) const {
        const double off = std::abs(gear_sum(engine, joint, def) - constant);
        const bool slides = std::holds_alternative<PrismaticJointDef>(engine.joint(joint.body_a).def);
        return slides ? Off{off, 0} : Off{0, off};
    }
    // Which tooth holds only the engine knows.
    Off operator()(const AngleJointDef& def) const { return {0, beyond(def.limit, double(engine.joint_position(index)))}; }
};

Vec2 to_vec(Point p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

}  // namespace

JointMemory remember_joint(const Engine& engine, const SceneJoint& joint) {
    JointMemory memory;
    if (const auto* pulley = std::get_if<PulleyJointDef>(&joint.def)) memory.constant = pulley_length(engine, joint, *pulley);
    if (const auto* gear = std::get_if<GearJointDef>(&joint.def)) memory.constant = gear_sum(engine, joint, *gear);
    if (const auto* mouse = std::get_if<MouseJointDef>(&joint.def)) {
        const BodyState body = engine.body(joint.body_b);
        memory.held = inv_transform_point({body.position, make_rot(body.angle)}, mouse->target);
    }
    return memory;
}

JointError measure_joint_error(const Engine& engine, std::size_t index) {
    const SceneJoint& joint = engine.joint(index);
    const Off off = std::visit(Measure{engine, joint, index, engine.joint_memory(index).constant}, joint.def);
    return {static_cast<float>(off.linear), static_cast<float>(off.angular)};
}

Anchors anchors_of(const Engine& engine, std::size_t index) {
    const SceneJoint& joint = engine.joint(index);
    if (const auto* mouse = std::get_if<MouseJointDef>(&joint.def))
        return {mouse->target, to_vec(world_frame(engine, joint.body_b, {engine.joint_memory(index).held, 0}).at)};
    const auto anchors = [&](const auto& def) -> Anchors {
        if constexpr (requires { def.base; }) {
            return {to_vec(world_frame(engine, joint.body_a, def.base.frame_a).at),
                    to_vec(world_frame(engine, joint.body_b, def.base.frame_b).at)};
        } else {
            return {};
        }
    };
    return std::visit(anchors, joint.def);
}

}  // namespace islet::samples
