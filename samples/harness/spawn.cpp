#include "spawn.hpp"

namespace islet::samples {
namespace {

/// Attaches shapes of whatever kind to a body.
struct ShapeMaker {
    World& world;
    BodyId body;
    const ShapeDef& def;

    void operator()(const Chain& chain) const { world.create_chain(body, chain.points, chain.loop, def); }
    template <class Geometry>
    void operator()(const Geometry& geometry) const {
        world.create_shape(body, geometry, def);
    }
};

/// Makes joints of whatever kind, with the ids that belong to the indices.
struct JointMaker {
    World& world;
    std::span<const BodyId> bodies;
    std::span<const JointId> joints;
    std::size_t a, b;

    JointId operator()(MouseJointDef def) const {
        def.body = bodies[b];
        return world.create_joint(def);
    }
    JointId operator()(GearJointDef def) const {
        def.joint1 = joints[a];
        def.joint2 = joints[b];
        return world.create_joint(def);
    }
    template <class Def>
    JointId operator()(Def def) const {
        def.base.body_a = bodies[a];
        def.base.body_b = bodies[b];
        return world.create_joint(def);
    }
};

}  // namespace

BodyId spawn(World& world, const SceneBody& body) {
    const BodyId id = world.create_body(body.def);
    if (!id) return id;  // the error stays the one that says why
    for (const SceneShape& shape : body.shapes) std::visit(ShapeMaker{world, id, shape.def}, shape.geometry);
    return id;
}

JointId spawn(World& world, const SceneJoint& joint, std::span<const BodyId> bodies, std::span<const JointId> joints) {
    return std::visit(JointMaker{world, bodies, joints, joint.body_a, joint.body_b}, joint.def);
}

}  // namespace islet::samples
