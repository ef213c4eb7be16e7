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

/// Outwards is to a link's right, because the links run counter-clockwise.
Vec2 outwards(const Transform& link) { return rotate(link.q, {0, -1}); }

SoftBodyGas gas_of(const World& world, const Spawned& soft, const SoftBodyDef& def) {
    SoftBodyGas gas(def);
    for (const BodyId link : soft.bodies) gas.add(world.transform(link), world.linear_velocity(link));
    return gas;
}

}  // namespace

void assemble(const SoftBodyDef& def, Assembler& into) {
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
    for (std::size_t i = 0; i < def.links; ++i) {
        const float angle = 2 * pi * static_cast<float>(i) / static_cast<float>(def.links);
        link.angle = angle < pi ? angle : angle - 2 * pi;
        link.position = def.position + rotate(make_rot(link.angle), {0, -ring.apothem});
        into.body(link);
        into.shape(Capsule{{-ring.half, 0}, {ring.half, 0}, 0.5f * def.thickness}, skin);
    }
    for (std::size_t i = 0; i < def.links; ++i) into.joint(i, (i + 1) % def.links, hinge);
}

SoftBodyGas::SoftBodyGas(const SoftBodyDef& def) : def_(def), half_(ring_of(def).half) {}

void SoftBodyGas::add(const Transform& link, Vec2 velocity) {
    if (empty_) origin_ = link.p;
    empty_ = false;
    // The area of the polygon whose sides are the links: the sum of the triangles they make with one point of the ring.
    const Vec2 arm = rotate(link.q, {half_, 0});
    twice_area_ += cross(link.p - arm - origin_, link.p + arm - origin_);
    // Its rate: every link sweeps its length times its speed outwards.
    rate_ += 2 * half_ * dot(outwards(link), velocity);
}

Vec2 SoftBodyGas::force_on(const Transform& link) const {
    // A skin folded over has no area and gets no more than twenty times the pressure.
    const float whole = round_area(def_), pressed = max(area(), 0.05f * whole);
    const float pressure = def_.pressure * max(0, whole / pressed - def_.gas_damping * rate_ / whole);
    return 2 * half_ * pressure * outwards(link);
}

void apply_pressure(World& world, const Spawned& soft, const SoftBodyDef& def) {
    const SoftBodyGas gas = gas_of(world, soft, def);
    for (const BodyId link : soft.bodies) world.apply_force_to_center(link, gas.force_on(world.transform(link)));
}

float round_area(const SoftBodyDef& def) {
    const Ring ring = ring_of(def);
    return static_cast<float>(def.links) * ring.half * ring.apothem;
}

float area_of(const World& world, const Spawned& soft, const SoftBodyDef& def) { return gas_of(world, soft, def).area(); }

}  // namespace islet::samples
