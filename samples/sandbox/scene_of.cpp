// From a world back to a scene, so that it can be saved as a file.
#include <algorithm>
#include <map>
#include <optional>

#include "sandbox.hpp"

namespace islet::sandbox {
namespace {

using namespace samples;

ShapeDef shape_def_of(const World& w, ShapeId shape) {
    ShapeDef def;
    def.friction = w.friction(shape);
    def.restitution = w.restitution(shape);
    def.rolling_resistance = w.rolling_resistance(shape);
    def.tangent_speed = w.tangent_speed(shape);
    def.density = w.density(shape);
    def.filter = w.filter(shape);
    def.sensor = w.is_sensor(shape);
    def.sensor_events = w.sensor_events_enabled(shape);
    def.hit_events = w.hit_events_enabled(shape);
    def.pre_solve = w.pre_solve_enabled(shape);
    def.one_way = w.one_way(shape);
    def.material = w.material(shape).id;
    def.user_data = w.user_data(shape);
    return def;
}

/// The geometry, but for segments of a chain.
std::optional<SceneGeometry> geometry_of(const World& w, ShapeId shape) {
    if (const auto* g = w.circle(shape)) return *g;
    if (const auto* g = w.capsule(shape)) return *g;
    if (const auto* g = w.segment(shape)) return *g;
    if (const auto* g = w.polygon(shape)) return *g;
    if (const auto* g = w.half_space(shape)) return *g;
    return {};
}

bool same(Vec2 a, Vec2 b) { return a.x == b.x && a.y == b.y; }

/// Whether a chain goes on from one segment to the other.
bool goes_on(const ChainSegment& a, const ChainSegment& b) {
    return same(a.segment.point2, b.segment.point1) && same(a.ghost2, b.segment.point2) && same(b.ghost1, a.segment.point1);
}

/// The chain of the segments from `first` on, as they were made; returns how many those are.
std::size_t chain_at(const World& w, std::span<const ShapeId> shapes, std::size_t first, Chain& chain) {
    const ChainSegment* const start = w.chain_segment(shapes[first]);
    const ChainSegment* last = start;
    chain.points = {start->segment.point1, start->segment.point2};
    std::size_t i = first + 1;
    for (; i < shapes.size(); ++i) {
        const ChainSegment* const next = w.chain_segment(shapes[i]);
        if (next == nullptr || !goes_on(*last, *next)) break;
        chain.points.push_back(next->segment.point2);
        last = next;
    }
    chain.loop = chain.points.size() > 3 && goes_on(*last, *start);
    if (chain.loop) chain.points.pop_back();
    return i - first;
}

SceneBody body_of(const World& w, BodyId body) {
    SceneBody made;
    BodyDef& def = made.def;
    def.type = w.type(body);
    def.position = w.position(body);
    def.angle = w.angle(body);
    def.linear_velocity = w.linear_velocity(body);
    def.angular_velocity = w.angular_velocity(body);
    def.linear_damping = w.linear_damping(body);
    def.angular_damping = w.angular_damping(body);
    def.gravity_scale = w.gravity_scale(body);
    def.sleep_threshold = w.sleep_threshold(body);
    def.enable_sleep = w.sleep_enabled(body);
    def.enabled = w.is_enabled(body);
    def.awake = !def.enabled || def.type == BodyType::static_body || w.is_awake(body);
    def.fixed_rotation = w.is_rotation_fixed(body);
    def.lock_x = w.is_x_locked(body);
    def.lock_y = w.is_y_locked(body);
    def.bullet = w.is_bullet(body);
    def.user_data = w.user_data(body);
    std::vector<ShapeId> shapes(w.shapes(body, {}));
    w.shapes(body, shapes);
    std::sort(shapes.begin(), shapes.end(), [](ShapeId a, ShapeId b) { return a.index1 < b.index1; });
    for (std::size_t i = 0; i < shapes.size();) {
        const ShapeDef shape = shape_def_of(w, shapes[i]);
        if (const std::optional<SceneGeometry> geometry = geometry_of(w, shapes[i])) {
            made.shapes.push_back({*geometry, shape});
            ++i;
        } else {
            Chain chain;
            i += chain_at(w, shapes, i, chain);
            made.shapes.push_back({chain, shape});
        }
    }
    return made;
}

/// Fills in what a joint's definition has of what the world tells.
template <class Def>
JointDef joint_of(const World& w, JointId joint, Def def = {}) {
    if constexpr (requires { def.base; })
        def.base = {{}, {}, w.frame_a(joint), w.frame_b(joint), w.collide_connected(joint), w.break_force(joint), w.break_torque(joint), w.user_data(joint)};
    if constexpr (requires { def.spring; }) def.spring = w.spring(joint);
    if constexpr (requires { def.limit; }) def.limit = w.limit(joint);
    if constexpr (requires { def.motor; }) def.motor = w.motor(joint);
    if constexpr (requires { def.friction; }) def.friction = w.joint_friction(joint);
    if constexpr (requires { def.ratchet; }) def.ratchet = w.ratchet(joint);
    if constexpr (requires { def.length; }) def.length = w.joint_length(joint);
    if constexpr (requires { def.linear_hertz; }) {
        const JointSoftness s = w.softness(joint);
        def.linear_hertz = s.linear_hertz;
        def.linear_damping_ratio = s.linear_damping_ratio;
        def.angular_hertz = s.angular_hertz;
        def.angular_damping_ratio = s.angular_damping_ratio;
    }
    if constexpr (requires { def.linear_velocity; }) {
        def.linear_velocity = w.joint_linear_velocity(joint);
        def.angular_velocity = w.joint_angular_velocity(joint);
        def.max_torque = w.joint_max_torque(joint);
    }
    if constexpr (requires { def.target; }) {
        const JointSoftness s = w.softness(joint);
        def.target = w.target(joint);
        def.hertz = s.linear_hertz;
        def.damping_ratio = s.linear_damping_ratio;
        def.user_data = w.user_data(joint);
    }
    if constexpr (requires { def.max_force; }) def.max_force = w.joint_max_force(joint);
    if constexpr (requires { def.ground_a; }) {
        def.ground_a = w.ground_a(joint);
        def.ground_b = w.ground_b(joint);
    }
    if constexpr (requires { def.ratio; }) def.ratio = w.joint_ratio(joint);
    if constexpr (std::is_same_v<Def, GearJointDef>) {
        def.break_torque = w.break_torque(joint);
        def.user_data = w.user_data(joint);
    }
    return def;
}

JointDef joint_def_of(const World& w, JointId joint) {
    switch (w.joint_type(joint)) {
        case JointType::revolute: return joint_of<RevoluteJointDef>(w, joint);
        case JointType::prismatic: return joint_of<PrismaticJointDef>(w, joint);
        case JointType::distance: return joint_of<DistanceJointDef>(w, joint);
        case JointType::weld: return joint_of<WeldJointDef>(w, joint);
        case JointType::wheel: return joint_of<WheelJointDef>(w, joint);
        case JointType::motor: return joint_of<MotorJointDef>(w, joint);
        case JointType::mouse: return joint_of<MouseJointDef>(w, joint);
        case JointType::pulley: return joint_of<PulleyJointDef>(w, joint);
        case JointType::gear: return joint_of<GearJointDef>(w, joint);
        case JointType::angle: return joint_of<AngleJointDef>(w, joint);
    }
    return {};
}

void put_joints(Scene& scene, const World& w, const std::map<BodyId, std::size_t>& bodies, std::uint64_t leave_out) {
    std::map<JointId, std::size_t> places;
    // A gear comes after its joints, in whatever slot it is.
    for (const bool gears : {false, true}) {
        for (std::uint32_t slot = 0; slot < w.capacity().joints; ++slot) {
            const JointId joint = w.joint_at(slot);
            if (!joint || (w.joint_type(joint) == JointType::gear) != gears || w.user_data(joint) == leave_out) continue;
            SceneJoint made;
            made.def = joint_def_of(w, joint);
            if (gears) {
                made.body_a = places.at(w.joint1(joint));
                made.body_b = places.at(w.joint2(joint));
            } else {
                if (w.joint_type(joint) != JointType::mouse) made.body_a = bodies.at(w.body_a(joint));
                made.body_b = bodies.at(w.body_b(joint));
            }
            places[joint] = scene.joints.size();
            scene.joints.push_back(made);
        }
    }
}

}  // namespace

Scene scene_of(const Running& running, std::uint64_t leave_out) {
    const World& w = running.engine.world();
    Scene scene;
    scene.name = running.scene.name;
    scene.steps = running.scene.steps;
    scene.dt = running.scene.dt;
    scene.view = running.scene.view;
    scene.world.gravity = w.gravity();
    scene.world.solver = w.solver();
    scene.world.enable_sleep = w.sleep_enabled();
    scene.world.restitution_threshold = w.restitution_threshold();
    scene.world.max_speed = w.max_speed();
    scene.world.hit_threshold = w.hit_threshold();
    scene.world.continuous = w.continuous();
    std::map<BodyId, std::size_t> bodies;
    for (std::uint32_t slot = 0; slot < w.capacity().bodies; ++slot) {
        const BodyId body = w.body_at(slot);
        if (!body) continue;
        bodies[body] = scene.bodies.size();
        scene.bodies.push_back(body_of(w, body));
    }
    put_joints(scene, w, bodies, leave_out);
    return scene;
}

}  // namespace islet::sandbox
