#include "box2d3_engine.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "box2d3_parts.hpp"

namespace islet::engines {

using samples::BodyState;
using samples::EngineCounts;
using samples::Scene;
using samples::SceneBody;
using samples::SceneJoint;

namespace {

constexpr int substeps = 4;  // its own programs' number, and Islet's

b2BodyType to_b2(BodyType type) {
    if (type == BodyType::static_body) return b2_staticBody;
    return type == BodyType::kinematic ? b2_kinematicBody : b2_dynamicBody;
}

struct MadeJoint {
    b2JointId id = b2_nullJointId;
    float break_force = 0, break_torque = 0;  // 0: never breaks
    bool exists() const { return B2_IS_NON_NULL(id) && b2Joint_IsValid(id); }
};

std::vector<b2ContactData> contacts_of(b2BodyId body) {
    std::vector<b2ContactData> contacts(static_cast<std::size_t>(b2Body_GetContactCapacity(body)));
    if (contacts.empty()) return contacts;
    contacts.resize(static_cast<std::size_t>(b2Body_GetContactData(body, contacts.data(), static_cast<int>(contacts.size()))));
    return contacts;
}

}  // namespace

struct Box2d3Engine::Impl {
    b2WorldId world = b2_nullWorldId;
    b2BodyId nothing = b2_nullBodyId;  // a static body without shapes: what mouse joints are tied to
    std::vector<b2BodyId> bodies;      // null once destroyed
    std::vector<MadeJoint> joints;
    float substep = 1;  // s, of the last step

    ~Impl() { clear(); }
    void clear() {
        if (B2_IS_NON_NULL(world)) b2DestroyWorld(world);
        world = b2_nullWorldId;
        bodies.clear();
        joints.clear();
    }
};

std::string box2d3_lacks(const Scene& scene) {
    const auto sentence = [](const std::string& what) { return "Box2D 3 has no " + what; };
    for (const SceneBody& body : scene.bodies) {
        for (const samples::SceneShape& shape : body.shapes)
            if (const std::string what = box2d3_shape_lacks(shape); !what.empty()) return sentence(what);
    }
    for (const SceneJoint& joint : scene.joints)
        if (const std::string what = box2d3_joint_lacks(joint); !what.empty()) return sentence(what);
    return {};
}

Box2d3Engine::Box2d3Engine() : impl_(std::make_unique<Impl>()) {}
Box2d3Engine::~Box2d3Engine() = default;

std::string Box2d3Engine::name() const {
    const b2Version version = b2GetVersion();
    return "Box2D " + std::to_string(version.major) + "." + std::to_string(version.minor) + "." + std::to_string(version.revision);
}

void Box2d3Engine::load(const Scene& scene) {
    Impl& m = *impl_;
    m.clear();
    b2WorldDef def = b2DefaultWorldDef();
    def.gravity = engines::to_b2(scene.world.gravity);
    def.restitutionThreshold = scene.world.restitution_threshold;
    def.maximumLinearSpeed = scene.world.max_speed;
    def.enableSleep = scene.world.enable_sleep;
    def.enableContinuous = scene.world.continuous;
    def.workerCount = static_cast<int>(scene.world.tasks.workers);
    m.world = b2CreateWorld(&def);
    const b2BodyDef nothing = b2DefaultBodyDef();
    m.nothing = b2CreateBody(m.world, &nothing);
    for (const SceneBody& body : scene.bodies) create_body(body);
    forget_joints();
    for (const SceneJoint& joint : scene.joints) create_joint(joint);
}

std::size_t Box2d3Engine::create_body(const SceneBody& body) {
    Impl& m = *impl_;
    const BodyDef& from = body.def;
    b2BodyDef def = b2DefaultBodyDef();
    def.type = to_b2(from.type);
    def.position = to_b2_place(from.position);
    def.rotation = b2MakeRot(from.angle);
    def.linearVelocity = engines::to_b2(from.linear_velocity);
    def.angularVelocity = from.angular_velocity;
    def.linearDamping = from.linear_damping;
    def.angularDamping = from.angular_damping;
    def.gravityScale = from.gravity_scale;
    def.sleepThreshold = from.sleep_threshold;
    def.enableSleep = from.enable_sleep;
    def.isAwake = from.awake;
    def.motionLocks = {from.lock_x, from.lock_y, from.fixed_rotation};
    def.isEnabled = from.enabled;
    def.isBullet = from.bullet;
    const b2BodyId made = b2CreateBody(m.world, &def);
    for (const samples::SceneShape& shape : body.shapes) add_box2d3_shape(made, shape);
    m.bodies.push_back(made);
    return m.bodies.size() - 1;
}

void Box2d3Engine::destroy_body(std::size_t index) {
    b2DestroyBody(impl_->bodies.at(index));
    impl_->bodies[index] = b2_nullBodyId;
}

void Box2d3Engine::step(float dt) {
    impl_->substep = dt / static_cast<float>(substeps);
    b2World_Step(impl_->world, dt, substeps);
    break_overloaded();
}

BodyState Box2d3Engine::body(std::size_t index) const {
    const b2BodyId body = impl_->bodies.at(index);
    BodyState state;
    state.position = from_b2_place(b2Body_GetPosition(body));
    state.angle = b2Rot_GetAngle(b2Body_GetRotation(body));
    state.linear_velocity = from_b2(b2Body_GetLinearVelocity(body));
    state.angular_velocity = b2Body_GetAngularVelocity(body);
    state.center = from_b2_place(b2Body_GetWorldCenter(body));
    state.awake = b2Body_IsAwake(body);
    if (b2Body_GetType(body) == b2_dynamicBody) {
        state.mass = b2Body_GetMass(body);
        state.inertia = b2Body_GetRotationalInertia(body);
    }
    return state;
}

bool Box2d3Engine::exists(std::size_t index) const { return index < impl_->bodies.size() && B2_IS_NON_NULL(impl_->bodies[index]); }
std::size_t Box2d3Engine::body_slots() const { return impl_->bodies.size(); }

EngineCounts Box2d3Engine::counts() const {
    const b2Counters counters = b2World_GetCounters(impl_->world);
    EngineCounts counts;
    counts.bodies = static_cast<std::size_t>(counters.bodyCount) - 1;  // without the body that mouse joints are tied to
    counts.shapes = static_cast<std::size_t>(counters.shapeCount);
    counts.joints = static_cast<std::size_t>(counters.jointCount);
    counts.contacts = static_cast<std::size_t>(counters.contactCount);
    counts.islands = static_cast<std::size_t>(counters.islandCount);
    counts.awake_bodies = static_cast<std::size_t>(b2World_GetAwakeBodyCount(impl_->world));
    return counts;
}

double Box2d3Engine::max_penetration() const {
    float deepest = 0;
    for (std::size_t i = 0; i < impl_->bodies.size(); ++i) {
        if (!exists(i)) continue;
        for (const b2ContactData& contact : contacts_of(impl_->bodies[i]))
            for (int k = 0; k < contact.manifold.pointCount; ++k) deepest = std::max(deepest, -contact.manifold.points[k].separation);
    }
    return double(deepest);
}

std::optional<Vec2> Box2d3Engine::contact_force(std::size_t index) const {
    const b2BodyId body = impl_->bodies.at(index);
    Vec2 force = {0, 0};
    for (const b2ContactData& contact : contacts_of(body)) {
        const float side = B2_ID_EQUALS(b2Shape_GetBody(contact.shapeIdA), body) ? -1.0f : 1.0f;
        for (int k = 0; k < contact.manifold.pointCount; ++k)
            force += (side * contact.manifold.points[k].normalImpulse / impl_->substep) * from_b2(contact.manifold.normal);
    }
    return force;
}

void Box2d3Engine::set_velocity(std::size_t index, Vec2 linear, float angular) {
    b2Body_SetLinearVelocity(impl_->bodies.at(index), engines::to_b2(linear));
    b2Body_SetAngularVelocity(impl_->bodies.at(index), angular);
}

void Box2d3Engine::apply_force(std::size_t index, Vec2 force) { b2Body_ApplyForceToCenter(impl_->bodies.at(index), engines::to_b2(force), true); }

void Box2d3Engine::apply_force_at(std::size_t index, Vec2 force, Vec2 point) {
    b2Body_ApplyForce(impl_->bodies.at(index), engines::to_b2(force), to_b2_place(point), true);
}

void Box2d3Engine::apply_torque(std::size_t index, float torque) { b2Body_ApplyTorque(impl_->bodies.at(index), torque, true); }

void Box2d3Engine::apply_impulse(std::size_t index, Vec2 impulse) { b2Body_ApplyLinearImpulseToCenter(impl_->bodies.at(index), engines::to_b2(impulse), true); }

// -- joints --------------------------------------------------------------------------------------------------------------------------

void Box2d3Engine::make_joint(const SceneJoint& joint) {
    Impl& m = *impl_;
    MadeJoint made;
    const auto strength = [&made](const auto& def) {
        if constexpr (requires { def.base; }) {
            made.break_force = def.base.break_force;
            made.break_torque = def.base.break_torque;
        }
    };
    std::visit(strength, joint.def);
    const bool mouse = std::holds_alternative<MouseJointDef>(joint.def);
    made.id = make_box2d3_joint(m.world, mouse ? m.nothing : m.bodies.at(joint.body_a), m.bodies.at(joint.body_b), joint.def);
    m.joints.push_back(made);
}

void Box2d3Engine::break_overloaded() {
    for (MadeJoint& joint : impl_->joints) {
        if ((joint.break_force <= 0 && joint.break_torque <= 0) || !joint.exists()) continue;
        const bool pulled = joint.break_force > 0 && b2Length(b2Joint_GetConstraintForce(joint.id)) > joint.break_force;
        const bool twisted = joint.break_torque > 0 && std::abs(b2Joint_GetConstraintTorque(joint.id)) > joint.break_torque;
        if (pulled || twisted) b2DestroyJoint(joint.id);
    }
}

void Box2d3Engine::change_joint(std::size_t index) { change_box2d3_joint(impl_->joints.at(index).id, joint(index).def); }
void Box2d3Engine::destroy_joint(std::size_t index) { b2DestroyJoint(impl_->joints.at(index).id); }
bool Box2d3Engine::joint_exists(std::size_t index) const { return index < impl_->joints.size() && impl_->joints[index].exists(); }
float Box2d3Engine::joint_position(std::size_t index) const { return box2d3_joint_position(impl_->joints.at(index).id); }
float Box2d3Engine::joint_speed(std::size_t index) const { return box2d3_joint_speed(impl_->joints.at(index).id); }
float Box2d3Engine::motor_force(std::size_t index) const { return box2d3_motor_force(impl_->joints.at(index).id); }
Vec2 Box2d3Engine::joint_force(std::size_t index) const { return from_b2(b2Joint_GetConstraintForce(impl_->joints.at(index).id)); }
float Box2d3Engine::joint_torque(std::size_t index) const { return b2Joint_GetConstraintTorque(impl_->joints.at(index).id); }

}  // namespace islet::engines
