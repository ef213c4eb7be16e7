#include "chipmunk_engine.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include <chipmunk/chipmunk_structs.h>

#include "chipmunk_joints.hpp"
#include "chipmunk_shapes.hpp"

namespace islet::engines {

using samples::BodyState;
using samples::EngineCounts;
using samples::Scene;
using samples::SceneBody;
using samples::SceneShape;

namespace {

// Lengths, speeds and times that a user of Chipmunk chooses for the size of their world. The defaults suit pixels.
constexpr double slop = 0.005;     // m of overlap left alone
constexpr double idle_time = 0.5;  // s that it takes a slow body to fall asleep

/// What a body has beyond Chipmunk's own; a body without needs none of it.
struct Extras {
    double linear_damping = 0, angular_damping = 0;  // 1/s
    double gravity_scale = 1;
    bool stays_awake = false;
};

struct Body {
    cpBody* body = nullptr;  // null once destroyed
    std::vector<cpShape*> shapes;
    std::unique_ptr<Extras> extras;
};

/// A new space. The first one of a process greets on standard output where Chipmunk was built with its asserts (Debian's is), which must not
/// get between our results.
cpSpace* make_space() {
    std::fflush(stdout);
    const int kept = dup(STDOUT_FILENO), nowhere = open("/dev/null", O_WRONLY);
    if (kept >= 0 && nowhere >= 0) dup2(nowhere, STDOUT_FILENO);
    cpSpace* space = cpSpaceNew();
    std::fflush(stdout);
    if (kept >= 0) dup2(kept, STDOUT_FILENO);
    for (const int file : {kept, nowhere}) {
        if (file >= 0) close(file);
    }
    return space;
}

/// Damps as Islet does, v / (1 + d dt) with a rate for each kind of motion; Chipmunk's own is one factor for a whole space. It also knows no
/// single bodies that never sleep: those are never idle for long.
void update_velocity(cpBody* body, cpVect gravity, cpFloat damping, cpFloat dt) {
    const Extras& extras = *static_cast<const Extras*>(cpBodyGetUserData(body));
    cpBodyUpdateVelocity(body, cpvmult(gravity, extras.gravity_scale), damping, dt);
    // Not by cpBodySetVelocity, which would keep the body from falling asleep.
    body->v = cpvmult(body->v, 1 / (1 + dt * extras.linear_damping));
    body->w /= 1 + dt * extras.angular_damping;
    if (extras.stays_awake) body->sleeping.idleTime = 0;
}

/// Fastest approach of two touching shapes at their contact points, m/s.
double approach_speed(const cpArbiter* contact) {
    cpBody *a = nullptr, *b = nullptr;
    cpArbiterGetBodies(contact, &a, &b);
    const cpVect normal = cpArbiterGetNormal(contact);
    double fastest = 0;
    for (int i = 0; i < cpArbiterGetCount(contact); ++i) {
        const cpVect va = cpBodyGetVelocityAtWorldPoint(a, cpArbiterGetPointA(contact, i));
        const cpVect vb = cpBodyGetVelocityAtWorldPoint(b, cpArbiterGetPointB(contact, i));
        fastest = std::max(fastest, cpvdot(cpvsub(va, vb), normal));
    }
    return fastest;
}

/// Before a contact is solved: the larger restitution of the two, and none for slow impacts. Chipmunk would multiply them at any speed.
cpBool mix_restitution(cpArbiter* contact, cpSpace*, cpDataPointer threshold) {
    cpShape *a = nullptr, *b = nullptr;
    cpArbiterGetShapes(contact, &a, &b);
    const double larger = std::max(cpShapeGetElasticity(a), cpShapeGetElasticity(b));
    const bool bounces = larger > 0 && approach_speed(contact) >= *static_cast<const double*>(threshold);
    cpArbiterSetRestitution(contact, bounces ? larger : 0);
    return cpTrue;
}

bool anything_bounces(const SceneBody& body) {
    return std::any_of(body.shapes.begin(), body.shapes.end(), [](const SceneShape& shape) { return shape.def.restitution > 0; });
}

cpBody* new_body(const SceneBody& body) {
    if (body.def.type == BodyType::static_body) return cpBodyNewStatic();
    if (body.def.type == BodyType::kinematic) return cpBodyNewKinematic();
    const MassData mass = chipmunk_mass(body);
    constexpr double never_turns = std::numeric_limits<double>::infinity();
    if (!(mass.mass > 0)) return cpBodyNew(1, never_turns);  // as in Islet
    cpBody* made = cpBodyNew(double(mass.mass), body.def.fixed_rotation ? never_turns : double(mass.inertia));
    cpBodySetCenterOfGravity(made, to_cp(mass.center));
    return made;
}

/// From a body's origin to its centre of mass, turned as the body is.
cpVect center_from_origin(const cpBody* body) { return cpvrotate(cpBodyGetCenterOfGravity(body), cpBodyGetRotation(body)); }

cpVect center_of(const cpBody* body) { return cpBodyLocalToWorld(body, cpBodyGetCenterOfGravity(body)); }

/// Calls visit(contact) for every touching pair: twice, once from each of the two bodies.
template <class Visit>
void each_contact_twice(const std::vector<Body>& bodies, Visit visit) {
    const auto call = [](cpBody*, cpArbiter* contact, void* data) { (*static_cast<Visit*>(data))(contact); };
    for (const Body& body : bodies) {
        if (body.body != nullptr) cpBodyEachArbiter(body.body, call, &visit);
    }
}

}  // namespace

struct ChipmunkEngine::Impl {
    cpSpace* space = nullptr;
    std::vector<Body> bodies;
    bool sleeps = false;
    bool bounces = false;              // some shape ever did, so contacts are asked about it
    double restitution_threshold = 1;  // m/s

    /// The space goes before its bodies: taking bodies out of it one by one looks through all contacts for each. Before that, what sleeps is
    /// woken: the space frees the contacts of sleepers by waking them, and would forget some.
    void free_space() {
        for (Body& body : bodies) cpBodyActivate(body.body);
        if (space != nullptr) cpSpaceFree(space);
        space = nullptr;
    }

    void free_bodies() {
        for (Body& body : bodies) free_body(body);
        bodies.clear();
    }

    void remove(Body& body) const {
        for (cpShape* shape : body.shapes) cpSpaceRemoveShape(space, shape);
        cpSpaceRemoveBody(space, body.body);
        free_body(body);
    }

    static void free_body(Body& body) {
        for (cpShape* shape : body.shapes) cpShapeFree(shape);
        cpBodyFree(body.body);
        body = {};
    }

    /// A call per contact and step costs time: only scenes in which something bounces pay it.
    void ask_for_restitution() {
        if (bounces) return;
        bounces = true;
        cpCollisionHandler* handler = cpSpaceAddDefaultCollisionHandler(space);
        handler->preSolveFunc = mix_restitution;
        handler->userData = &restitution_threshold;
    }
};

ChipmunkEngine::ChipmunkEngine() : joints_(std::make_unique<ChipmunkJoints>()), impl_(std::make_unique<Impl>()) {}
ChipmunkEngine::~ChipmunkEngine() { clear(); }

void ChipmunkEngine::clear() {
    impl_->free_space();
    joints_->clear();
    impl_->free_bodies();
}

std::string ChipmunkEngine::name() const { return std::string("Chipmunk ") + cpVersionString; }

void ChipmunkEngine::load(const Scene& scene) {
    clear();
    Impl& m = *impl_;
    m.space = make_space();
    cpSpaceSetGravity(m.space, to_cp(scene.world.gravity));
    cpSpaceSetCollisionSlop(m.space, slop);
    m.sleeps = scene.world.enable_sleep;
    if (m.sleeps) {
        cpSpaceSetSleepTimeThreshold(m.space, idle_time);
        cpSpaceSetIdleSpeedThreshold(m.space, chipmunk_idle_speed(scene));
    }
    m.bounces = false;
    m.restitution_threshold = double(scene.world.restitution_threshold);
    m.bodies.reserve(scene.bodies.size());
    for (const SceneBody& body : scene.bodies) create_body(body);
    forget_joints();
    joints_->load(m.space);
    last_step_ = 0;
    for (const samples::SceneJoint& joint : scene.joints) create_joint(joint);
}

void ChipmunkEngine::make_joint(const samples::SceneJoint& joint) {
    const bool gear = std::holds_alternative<GearJointDef>(joint.def), mouse = std::holds_alternative<MouseJointDef>(joint.def);
    joints_->make(joint, gear || mouse ? nullptr : impl_->bodies.at(joint.body_a).body, gear ? nullptr : impl_->bodies.at(joint.body_b).body);
}

std::size_t ChipmunkEngine::create_body(const SceneBody& body) {
    Impl& m = *impl_;
    const BodyDef& def = body.def;
    Body made;
    made.body = cpSpaceAddBody(m.space, new_body(body));
    // The angle first: the position goes to the centre of mass by way of it.
    cpBodySetAngle(made.body, double(def.angle));
    cpBodySetPosition(made.body, to_cp(def.position));
    if (def.type != BodyType::static_body) {
        // A scene's velocity is that of the origin as the body is made, before shapes move its centre of mass.
        const double spin = def.fixed_rotation ? 0 : double(def.angular_velocity);
        cpBodySetVelocity(made.body, cpvadd(to_cp(def.linear_velocity), cpvmult(cpvperp(center_from_origin(made.body)), spin)));
        cpBodySetAngularVelocity(made.body, spin);
    }
    const bool stays_awake = m.sleeps && !def.enable_sleep;
    const bool damped = def.linear_damping > 0 || def.angular_damping > 0;
    if (def.type == BodyType::dynamic && (damped || def.gravity_scale != 1 || stays_awake)) {
        made.extras = std::make_unique<Extras>(
            Extras{double(def.linear_damping), double(def.angular_damping), double(def.gravity_scale), stays_awake});
        cpBodySetUserData(made.body, made.extras.get());
        cpBodySetVelocityUpdateFunc(made.body, update_velocity);
    }
    for (const SceneShape& shape : body.shapes) {
        for (cpShape* part : make_chipmunk_shapes(made.body, shape)) made.shapes.push_back(cpSpaceAddShape(m.space, part));
    }
    if (anything_bounces(body)) m.ask_for_restitution();
    if (!def.awake && m.sleeps && def.type == BodyType::dynamic) cpBodySleep(made.body);
    m.bodies.push_back(std::move(made));
    return m.bodies.size() - 1;
}

void ChipmunkEngine::destroy_body(std::size_t index) {
    joints_->destroy_joints_of(impl_->bodies.at(index).body);
    impl_->remove(impl_->bodies[index]);
}

void ChipmunkEngine::step(float dt) {
    last_step_ = double(dt);
    cpSpaceStep(impl_->space, last_step_);
    joints_->break_overloaded(last_step_);
}

BodyState ChipmunkEngine::body(std::size_t index) const {
    cpBody* body = impl_->bodies.at(index).body;
    BodyState state;
    state.position = from_cp(cpBodyGetPosition(body));
    state.angle = static_cast<float>(cpBodyGetAngle(body));
    state.linear_velocity = from_cp(cpBodyGetVelocity(body));
    state.angular_velocity = static_cast<float>(cpBodyGetAngularVelocity(body));
    state.center = from_cp(center_of(body));
    state.awake = cpBodyIsSleeping(body) == cpFalse;
    if (cpBodyGetType(body) == CP_BODY_TYPE_DYNAMIC) {
        state.mass = static_cast<float>(cpBodyGetMass(body));
        const double inertia = cpBodyGetMoment(body);
        state.inertia = std::isinf(inertia) ? 0.0f : static_cast<float>(inertia);  // a body that never turns has no use for one
    }
    return state;
}

bool ChipmunkEngine::exists(std::size_t index) const { return index < impl_->bodies.size() && impl_->bodies[index].body != nullptr; }
std::size_t ChipmunkEngine::body_slots() const { return impl_->bodies.size(); }

EngineCounts ChipmunkEngine::counts() const {
    EngineCounts counts;
    for (const Body& body : impl_->bodies) {
        if (body.body == nullptr) continue;
        ++counts.bodies;
        counts.shapes += body.shapes.size();
        if (cpBodyGetType(body.body) != CP_BODY_TYPE_STATIC && cpBodyIsSleeping(body.body) == cpFalse) ++counts.awake_bodies;
    }
    counts.joints = joints_->count();
    std::size_t seen = 0;
    each_contact_twice(impl_->bodies, [&seen](cpArbiter*) { ++seen; });
    counts.contacts = seen / 2;
    return counts;
}

double ChipmunkEngine::max_penetration() const {
    double deepest = 0;
    each_contact_twice(impl_->bodies, [&deepest](cpArbiter* contact) {
        for (int i = 0; i < cpArbiterGetCount(contact); ++i) deepest = std::max(deepest, -cpArbiterGetDepth(contact, i));
    });
    return deepest;
}

void ChipmunkEngine::set_velocity(std::size_t index, Vec2 linear, float angular) {
    cpBody* body = impl_->bodies.at(index).body;
    cpBodySetVelocity(body, to_cp(linear));
    cpBodySetAngularVelocity(body, double(angular));
}

void ChipmunkEngine::apply_force(std::size_t index, Vec2 force) {
    cpBody* body = impl_->bodies.at(index).body;
    cpBodyApplyForceAtWorldPoint(body, to_cp(force), center_of(body));
}

void ChipmunkEngine::apply_force_at(std::size_t index, Vec2 force, Vec2 point) {
    cpBodyApplyForceAtWorldPoint(impl_->bodies.at(index).body, to_cp(force), to_cp(point));
}

void ChipmunkEngine::apply_torque(std::size_t index, float torque) {
    cpBody* body = impl_->bodies.at(index).body;
    cpBodySetTorque(body, cpBodyGetTorque(body) + double(torque));
}

void ChipmunkEngine::apply_impulse(std::size_t index, Vec2 impulse) {
    cpBody* body = impl_->bodies.at(index).body;
    cpBodyApplyImpulseAtWorldPoint(body, to_cp(impulse), center_of(body));
}

}  // namespace islet::engines
