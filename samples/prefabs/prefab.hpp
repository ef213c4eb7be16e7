// Things ready made of several bodies and joints, for a World of your own. The files of this folder need the engine alone, and no heap: copy this
// one and those of the prefab you want; bridges, chains and ropes need span.hpp and span.cpp, too. A definition
// describes a prefab, and `spawn` makes it; its ids go into arrays of yours.
//
//   BodyId planks[18];
//   JointId hinges[17];
//   Spawned bridge = spawn(world, BridgeDef{.from = {-4, 3}, .to = {4, 3}}, planks, hinges);
//   world.apply_linear_impulse_to_center(bridge.bodies[3], {2, 0});
#pragma once

#include <cstddef>
#include <span>

#include <islet/islet.hpp>

namespace islet::samples {

/// Takes a prefab's parts, one after the other: its bodies, each followed by its shapes, then its joints. A joint's bodies, and a gear's joints, are
/// numbers: their places in that order, from 0.
class Assembler {
public:
    virtual void body(const BodyDef&) {}
    virtual void shape(const Circle&, const ShapeDef&) {}
    virtual void shape(const Capsule&, const ShapeDef&) {}
    virtual void shape(const Polygon&, const ShapeDef&) {}
    virtual void joint(std::size_t /*body_a*/, std::size_t /*body_b*/, const RevoluteJointDef&) {}
    virtual void joint(std::size_t /*body_a*/, std::size_t /*body_b*/, const PrismaticJointDef&) {}
    virtual void joint(std::size_t /*body_a*/, std::size_t /*body_b*/, const DistanceJointDef&) {}
    virtual void joint(std::size_t /*body_a*/, std::size_t /*body_b*/, const WheelJointDef&) {}
    virtual void joint(std::size_t /*joint1*/, std::size_t /*joint2*/, const GearJointDef&) {}

protected:
    ~Assembler() = default;
};

/// Hands all parts on to `target`, whose functions may be templates.
template <class Target>
class AssembleInto final : public Assembler {
public:
    explicit AssembleInto(Target& target) : target_(target) {}
    void body(const BodyDef& def) override { target_.body(def); }
    void shape(const Circle& circle, const ShapeDef& def) override { target_.shape(circle, def); }
    void shape(const Capsule& capsule, const ShapeDef& def) override { target_.shape(capsule, def); }
    void shape(const Polygon& polygon, const ShapeDef& def) override { target_.shape(polygon, def); }
    void joint(std::size_t a, std::size_t b, const RevoluteJointDef& def) override { target_.joint(a, b, def); }
    void joint(std::size_t a, std::size_t b, const PrismaticJointDef& def) override { target_.joint(a, b, def); }
    void joint(std::size_t a, std::size_t b, const DistanceJointDef& def) override { target_.joint(a, b, def); }
    void joint(std::size_t a, std::size_t b, const WheelJointDef& def) override { target_.joint(a, b, def); }
    void joint(std::size_t a, std::size_t b, const GearJointDef& def) override { target_.joint(a, b, def); }

private:
    Target& target_;
};

/// What a prefab takes of a world's capacity.
struct PrefabSize {
    std::size_t bodies = 0, shapes = 0, joints = 0;
};

/// What was made, in the prefab's order: in the arrays given to `spawn`.
struct Spawned {
    std::span<const BodyId> bodies;
    std::span<const JointId> joints;
};

/// Makes the parts in a world. What finds no room is left out, and so is a joint of something that was left out; its id is null.
class WorldAssembly {
public:
    WorldAssembly(World& world, std::span<BodyId> bodies, std::span<JointId> joints) : world_(world), bodies_(bodies), joints_(joints) {}

    void body(const BodyDef& def) { bodies_[body_count_++] = world_.create_body(def); }
    template <class Geometry>
    void shape(const Geometry& geometry, const ShapeDef& def) {
        // Without the body nothing is tried: last_error() keeps saying why there is none.
        if (const BodyId body = bodies_[body_count_ - 1]) world_.create_shape(body, geometry, def);
    }
    void joint(std::size_t a, std::size_t b, GearJointDef def) {
        def.joint1 = joints_[a];
        def.joint2 = joints_[b];
        joints_[joint_count_++] = def.joint1 && def.joint2 ? world_.create_joint(def) : JointId{};
    }
    template <class Def>
    void joint(std::size_t a, std::size_t b, Def def) {
        def.base.body_a = bodies_[a];
        def.base.body_b = bodies_[b];
        joints_[joint_count_++] = def.base.body_a && def.base.body_b ? world_.create_joint(def) : JointId{};
    }

private:
    World& world_;
    std::span<BodyId> bodies_;
    std::span<JointId> joints_;
    std::size_t body_count_ = 0, joint_count_ = 0;
};

/// Counts the parts.
struct PartCount {
    PrefabSize size;
    void body(const BodyDef&) { ++size.bodies; }
    void shape(const auto&, const ShapeDef&) { ++size.shapes; }
    void joint(std::size_t, std::size_t, const auto&) { ++size.joints; }
};

/// How many bodies, shapes and joints a prefab has.
template <class Def>
PrefabSize size_of(const Def& def) {
    PartCount count;
    AssembleInto into(count);
    assemble(def, into);
    return count.size;
}

/// Makes a prefab in a world and writes its ids into the arrays. Arrays shorter than size_of says: nothing is made, and the result is empty. A part that
/// finds no room in the world is left out: the error hook or world.last_error() says so, and its id is null.
template <class Def>
Spawned spawn(World& world, const Def& def, std::span<BodyId> bodies, std::span<JointId> joints) {
    const PrefabSize size = size_of(def);
    if (size.bodies > bodies.size() || size.joints > joints.size()) return {};
    WorldAssembly assembly(world, bodies, joints);
    AssembleInto into(assembly);
    assemble(def, into);
    return {bodies.first(size.bodies), joints.first(size.joints)};
}

/// Destroys what is left of it.
inline void destroy(World& world, const Spawned& spawned) {
    for (const BodyId body : spawned.bodies) {
        if (world.is_valid(body)) world.destroy_body(body);
    }
}

}  // namespace islet::samples
