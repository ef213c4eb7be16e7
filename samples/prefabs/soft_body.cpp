#include "soft_body.hpp"

namespace islet::samples {
namespace {

/// Half a link's length, and the way from the ring's middle to a link's.
struct Ring {
    float half, apothem;
};

Ring ring_of(const SoftBodyDef& def) {
    const Rot q = make_rot(pi / static_cast<float>(def.links));
    return {def.radius * q.s, def.radius * q.c};
}

/// The area of the polygon whose sides are the links: the sum of the triangles they make with one point of the ring.
float area_inside(std::span<const Transform> links, float half) {
    const Vec2 origin = links[0].p;
    float twice = 0;
    for (const Transform& link : links) {
        const Vec2 arm = rotate(link.q, {half, 0});
        twice += cross(link.p - arm - origin, link.p + arm - origin);
    }
    return 0.5f * twice;
}

/// What the gas does to a link per metre of pressure: outwards is to its right, because the links run counter-clockwise. A skin folded over
/// has no area and gets no more than a hundred times the pressure.
float pressure_at(const SoftBodyDef& def, float area) {
    const float whole = round_area(def);
    return def.pressure * whole / max(area, 0.01f * whole);
}

std::vector<Transform> poses_of(const World& world, const Spawned& soft) {
    std::vector<Transform> poses;
    for (const BodyId link : soft.bodies) poses.push_back(world.transform(link));
    return poses;
}

std::vector<Transform> poses_of(const Engine& engine, const Placed& soft, const SoftBodyDef& def) {
    std::vector<Transform> poses;
    for (std::size_t i = 0; i < def.links; ++i) {
        const BodyState link = engine.body(soft.first_body + i);
        poses.push_back({link.position, make_rot(link.angle)});
    }
    return poses;
}

/// The forces on the links, at their middles.
std::vector<Vec2> forces_on(std::span<const Transform> links, const SoftBodyDef& def) {
    const float half = ring_of(def).half, push = 2 * half * pressure_at(def, area_inside(links, half));
    std::vector<Vec2> forces;
    for (const Transform& link : links) forces.push_back(rotate(link.q, {0, -push}));
    return forces;
}

}  // namespace

Prefab make_soft_body(const SoftBodyDef& def) {
    const Ring ring = ring_of(def);
    ShapeDef skin;
    skin.density = def.density;
    skin.friction = def.friction;
    BodyDef link;
    link.type = BodyType::dynamic;
    link.linear_damping = def.damping;
    link.angular_damping = def.damping;
    RevoluteJointDef hinge;
    hinge.base.frame_a.position = {ring.half, 0};
    hinge.base.frame_b.position = {-ring.half, 0};
    Prefab soft;
    for (std::size_t i = 0; i < def.links; ++i) {
        const float angle = 2 * pi * static_cast<float>(i) / static_cast<float>(def.links);
        link.angle = angle < pi ? angle : angle - 2 * pi;
        link.position = def.position + rotate(make_rot(link.angle), {0, -ring.apothem});
        soft.bodies.push_back({link, {{Capsule{{-ring.half, 0}, {ring.half, 0}, 0.5f * def.thickness}, skin}}});
        soft.joints.push_back({i, (i + 1) % def.links, hinge});
    }
    return soft;
}

void apply_pressure(World& world, const Spawned& soft, const SoftBodyDef& def) {
    const std::vector<Vec2> forces = forces_on(poses_of(world, soft), def);
    for (std::size_t i = 0; i < forces.size(); ++i) world.apply_force_to_center(soft.bodies[i], forces[i]);
}

void apply_pressure(Engine& engine, const Placed& soft, const SoftBodyDef& def) {
    const std::vector<Vec2> forces = forces_on(poses_of(engine, soft, def), def);
    for (std::size_t i = 0; i < forces.size(); ++i) engine.apply_force(soft.first_body + i, forces[i]);
}

float round_area(const SoftBodyDef& def) {
    const Ring ring = ring_of(def);
    return static_cast<float>(def.links) * ring.half * ring.apothem;
}

float area_of(const World& world, const Spawned& soft, const SoftBodyDef& def) {
    return area_inside(poses_of(world, soft), ring_of(def).half);
}

float area_of(const Engine& engine, const Placed& soft, const SoftBodyDef& def) {
    return area_inside(poses_of(engine, soft, def), ring_of(def).half);
}

}  // namespace islet::samples
