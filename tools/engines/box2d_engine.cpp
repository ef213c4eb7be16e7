#include "box2d_engine.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <box2d/box2d.h>

#include "box2d_joints.hpp"
#include "box2d_nearest.hpp"
#include "box2d_shapes.hpp"

namespace islet::engines {

using samples::BodyState;
using samples::EngineCounts;
using samples::Scene;
using samples::SceneBody;
using samples::SceneShape;

namespace {

b2Vec2 to_b2(Vec2 v) { return {v.x, v.y}; }
Vec2 from_b2(const b2Vec2& v) { return {v.x, v.y}; }

b2BodyType to_b2(BodyType type) {
    switch (type) {
    case BodyType::kinematic: return b2_kinematicBody;
    case BodyType::dynamic: return b2_dynamicBody;
    default: return b2_staticBody;
    }
}

/// Deepest point of a contact (m, > 0 when the skins overlap).
float penetration(b2Contact& contact) {
    b2WorldManifold manifold;
    contact.GetWorldManifold(&manifold);
    float deepest = 0;
    for (int i = 0; i < contact.GetManifold()->pointCount; ++i) deepest = std::max(deepest, -manifold.separations[i]);
    return deepest;
}

}  // namespace

struct Box2dEngine::Impl {
    Box2dOptions options;
    float restitution_threshold = 1;
    std::unique_ptr<b2World> world;
    std::vector<b2Body*> bodies;  // null once destroyed

    void attach(b2Body& body, const SceneShape& shape) const {
        b2FixtureDef def;
        def.density = shape.def.density;
        def.isSensor = shape.def.sensor;
        def.friction = shape.def.friction;
        def.restitution = shape.def.restitution;
        def.restitutionThreshold = restitution_threshold;
        def.filter.categoryBits = static_cast<uint16>(shape.def.filter.category);
        def.filter.maskBits = static_cast<uint16>(shape.def.filter.mask);
        def.filter.groupIndex = static_cast<int16>(shape.def.filter.group);
        const auto geometry = make_box2d_shape(shape.geometry, options.skin);
        def.shape = geometry.get();
        body.CreateFixture(&def);
    }
};

Box2dEngine::Box2dEngine(const Box2dOptions& options) : joints_(std::make_unique<Box2dJoints>()), impl_(std::make_unique<Impl>()) {
    impl_->options = options;
}
Box2dEngine::~Box2dEngine() = default;

// The package's version: 2.4.1 still calls itself 2.4.0 in b2_version.
std::string Box2dEngine::name() const { return "Box2D " ISLET_BOX2D_VERSION; }

void Box2dEngine::load(const Scene& scene) {
    Impl& m = *impl_;
    m.bodies.clear();
    m.world = std::make_unique<b2World>(to_b2(scene.world.gravity));
    m.world->SetAllowSleeping(scene.world.enable_sleep);
    m.world->SetContinuousPhysics(m.options.continuous);
    m.world->SetAutoClearForces(false);  // a force acts over the whole step, all substeps of it
    m.restitution_threshold = scene.world.restitution_threshold;
    for (const SceneBody& body : scene.bodies) create_body(body);
    forget_joints();
    joints_->load(*m.world);
    for (const samples::SceneJoint& joint : scene.joints) create_joint(joint);
}

void Box2dEngine::make_joint(const samples::SceneJoint& joint) {
    joints_->make(impl_->bodies, impl_->options.nearest ? box2d_nearest(joint) : joint);
}

std::size_t Box2dEngine::create_body(const SceneBody& wanted) {
    Impl& m = *impl_;
    const SceneBody body = m.options.nearest ? box2d_nearest(wanted) : wanted;
    b2BodyDef def;
    def.type = to_b2(body.def.type);
    def.position = to_b2(body.def.position);
    def.angle = body.def.angle;
    def.linearVelocity = to_b2(body.def.linear_velocity);
    def.angularVelocity = body.def.angular_velocity;
    def.linearDamping = body.def.linear_damping;
    def.angularDamping = body.def.angular_damping;
    def.gravityScale = body.def.gravity_scale;
    def.allowSleep = body.def.enable_sleep;
    def.fixedRotation = body.def.fixed_rotation;
    def.bullet = body.def.bullet;
    b2Body* made = m.world->CreateBody(&def);
    for (const SceneShape& shape : body.shapes) m.attach(*made, shape);

    if (def.type == b2_dynamicBody) {
        const b2MassData mass = box2d_mass(body);  // of the sizes the scene asks for, whatever the skin did to the fixtures
        if (mass.mass > 0) made->SetMassData(&mass);
    }
    if (!body.def.awake) made->SetAwake(false);
    m.bodies.push_back(made);
    return m.bodies.size() - 1;
}

void Box2dEngine::destroy_body(std::size_t index) {
    joints_->destroy_gears_of(*impl_->bodies.at(index));
    impl_->world->DestroyBody(impl_->bodies.at(index));
    impl_->bodies[index] = nullptr;
}

void Box2dEngine::step(float dt) {
    const Box2dOptions& o = impl_->options;
    const float h = dt / static_cast<float>(o.substeps);
    for (int i = 0; i < o.substeps; ++i) impl_->world->Step(h, o.velocity_iterations, o.position_iterations);
    impl_->world->ClearForces();
    substep_ = h;
    joints_->break_overloaded(h);
}

BodyState Box2dEngine::body(std::size_t index) const {
    const b2Body& body = *impl_->bodies.at(index);
    BodyState state;
    state.position = from_b2(body.GetPosition());
    state.angle = body.GetAngle();
    state.linear_velocity = from_b2(body.GetLinearVelocity());
    state.angular_velocity = body.GetAngularVelocity();
    state.center = from_b2(body.GetWorldCenter());
    state.awake = body.IsAwake();
    if (body.GetType() == b2_dynamicBody) {
        state.mass = body.GetMass();
        // Box2D tells the inertia about the body's origin.
        state.inertia = body.GetInertia() - body.GetMass() * body.GetLocalCenter().LengthSquared();
    }
    return state;
}

bool Box2dEngine::exists(std::size_t index) const { return index < impl_->bodies.size() && impl_->bodies[index] != nullptr; }
std::size_t Box2dEngine::body_slots() const { return impl_->bodies.size(); }

EngineCounts Box2dEngine::counts() const {
    EngineCounts counts;
    for (b2Body* body : impl_->bodies) {
        if (body == nullptr) continue;
        ++counts.bodies;
        if (body->GetType() != b2_staticBody && body->IsAwake()) ++counts.awake_bodies;
        for (b2Fixture* f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
            counts.shapes += static_cast<std::size_t>(f->GetShape()->GetChildCount());
        }
    }
    counts.joints = joints_->count();
    counts.contacts = static_cast<std::size_t>(impl_->world->GetContactCount());
    return counts;
}

double Box2dEngine::max_penetration() const {
    float deepest = 0;
    for (b2Contact* c = impl_->world->GetContactList(); c != nullptr; c = c->GetNext()) {
        if (c->IsTouching()) deepest = std::max(deepest, penetration(*c));
    }
    return double(deepest);
}

std::optional<Vec2> Box2dEngine::contact_force(std::size_t index) const {
    b2Body* const body = impl_->bodies.at(index);
    Vec2 force = {0, 0};
    for (const b2ContactEdge* edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
        b2Contact& contact = *edge->contact;
        if (!contact.IsTouching()) continue;
        b2WorldManifold manifold;
        contact.GetWorldManifold(&manifold);
        const float side = contact.GetFixtureA()->GetBody() == body ? -1.0f : 1.0f;
        for (int i = 0; i < contact.GetManifold()->pointCount; ++i)
            force += (side * contact.GetManifold()->points[i].normalImpulse / substep_) * from_b2(manifold.normal);
    }
    return force;
}

void Box2dEngine::set_velocity(std::size_t index, Vec2 linear, float angular) {
    b2Body& body = *impl_->bodies.at(index);
    body.SetLinearVelocity(to_b2(linear));
    body.SetAngularVelocity(angular);
}

void Box2dEngine::apply_force(std::size_t index, Vec2 force) { impl_->bodies.at(index)->ApplyForceToCenter(to_b2(force), true); }

void Box2dEngine::apply_force_at(std::size_t index, Vec2 force, Vec2 point) {
    impl_->bodies.at(index)->ApplyForce(to_b2(force), to_b2(point), true);
}

void Box2dEngine::apply_torque(std::size_t index, float torque) { impl_->bodies.at(index)->ApplyTorque(torque, true); }

void Box2dEngine::apply_impulse(std::size_t index, Vec2 impulse) {
    impl_->bodies.at(index)->ApplyLinearImpulseToCenter(to_b2(impulse), true);
}

}  // namespace islet::engines
