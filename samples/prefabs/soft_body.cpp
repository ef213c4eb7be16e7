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

/// Where a link is and how it moves.
struct Link {
    Transform pose;
    Vec2 velocity;
};

/// The area of the polygon whose sides are the links: the sum of the triangles they make with one point of the ring.
float area_inside(std::span<const Link> links, float half) {
    const Vec2 origin = links[0].pose.p;
    float twice = 0;
    for (const Link& link : links) {
        const Vec2 arm = rotate(link.pose.q, {half, 0});
        twice += cross(link.pose.p - arm - origin, link.pose.p + arm - origin);
    }
    return 0.5f * twice;
}

/// Outwards is to a link's right, because the links run counter-clockwise.
Vec2 outwards(const Link& link) { return rotate(link.pose.q, {0, -1}); }

/// The area's rate: every link sweeps its length times its speed outwards.
float area_rate(std::span<const Link> links, float half) {
    float rate = 0;
    for (const Link& link : links) rate += 2 * half * dot(outwards(link), link.velocity);
    return rate;
}

/// The forces on the links, at their middles. A skin folded over has no area and gets no more than twenty times the pressure.
std::vector<Vec2> forces_on(std::span<const Link> links, const SoftBodyDef& def) {
    const float half = ring_of(def).half, whole = round_area(def), area = max(area_inside(links, half), 0.05f * whole);
    const float pressure = def.pressure * max(0, whole / area - def.gas_damping * area_rate(links, half) / whole);
    std::vector<Vec2> forces;
    for (const Link& link : links) forces.push_back(2 * half * pressure * outwards(link));
    return forces;
}

std::vector<Link> links_of(const World& world, const Spawned& soft) {
    std::vector<Link> links;
    for (const BodyId link : soft.bodies) links.push_back({world.transform(link), world.linear_velocity(link)});
    return links;
}

std::vector<Link> links_of(const Engine& engine, const Placed& soft, const SoftBodyDef& def) {
    std::vector<Link> links;
    for (std::size_t i = 0; i < def.links; ++i) {
        const BodyState link = engine.body(soft.first_body + i);
        links.push_back({{link.position, make_rot(link.angle)}, link.linear_velocity});
    }
    return links;
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
    const std::vector<Vec2> forces = forces_on(links_of(world, soft), def);
    for (std::size_t i = 0; i < forces.size(); ++i) world.apply_force_to_center(soft.bodies[i], forces[i]);
}

void apply_pressure(Engine& engine, const Placed& soft, const SoftBodyDef& def) {
    const std::vector<Vec2> forces = forces_on(links_of(engine, soft, def), def);
    for (std::size_t i = 0; i < forces.size(); ++i) engine.apply_force(soft.first_body + i, forces[i]);
}

float round_area(const SoftBodyDef& def) {
    const Ring ring = ring_of(def);
    return static_cast<float>(def.links) * ring.half * ring.apothem;
}

float area_of(const World& world, const Spawned& soft, const SoftBodyDef& def) {
    return area_inside(links_of(world, soft), ring_of(def).half);
}

float area_of(const Engine& engine, const Placed& soft, const SoftBodyDef& def) {
    return area_inside(links_of(engine, soft, def), ring_of(def).half);
}

}  // namespace islet::samples
