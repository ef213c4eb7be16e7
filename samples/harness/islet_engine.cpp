// Islet behind the interface that scenes are written against.
#include <algorithm>
#include <new>
#include <stdexcept>
#include <vector>

#include "engine.hpp"
#include "faulty_field.hpp"
#include "spawn.hpp"

namespace islet::samples {
namespace {

/// Memory for a world, aligned as it needs.
class Block {
public:
    explicit Block(std::size_t size)
        : data_(static_cast<std::byte*>(::operator new (size, std::align_val_t{world_alignment}))), size_(size) {}
    ~Block() { ::operator delete (data_, std::align_val_t{world_alignment}); }
    Block(const Block&) = delete;
    Block& operator=(const Block&) = delete;
    std::span<std::byte> span() { return {data_, size_}; }

private:
    std::byte* data_;
    std::size_t size_;
};

/// Of dynamic and kinematic ones, as StepReport counts them.
std::size_t awake_bodies(const World& world, const std::vector<BodyId>& bodies) {
    return static_cast<std::size_t>(std::count_if(bodies.begin(), bodies.end(), [&world](BodyId id) {
        return world.is_valid(id) && world.type(id) != BodyType::static_body && world.is_enabled(id) && world.is_awake(id);
    }));
}

}  // namespace

struct IsletEngine::Impl {
    std::unique_ptr<Block> block;
    World* world = nullptr;
    Capacity capacity;
    float substep = 1;  // s, of the last step
    std::vector<BodyId> bodies;  // by scene index; so are the joints
    std::vector<JointId> joints;
};

IsletEngine::IsletEngine() : impl_(std::make_unique<Impl>()) {}
IsletEngine::~IsletEngine() = default;

std::string IsletEngine::name() const { return "islet"; }

void IsletEngine::load(const Scene& scene) {
    impl_->capacity = capacity_of(scene);
    impl_->block = std::make_unique<Block>(islet::world_bytes(impl_->capacity));
    Error error = Error::none;
    impl_->world = World::create(impl_->block->span(), impl_->capacity, scene.world, &error);
    if (impl_->world == nullptr) {
        const std::string field = faulty_field(scene.world, [this](const WorldDef& def) { return World::create(impl_->block->span(), impl_->capacity, def) != nullptr; });
        throw std::runtime_error((field.empty() ? "cannot make the world" : "world." + field) + ": " + describe(error));
    }
    impl_->bodies.clear();
    impl_->bodies.reserve(scene.bodies.size());
    for (const SceneBody& body : scene.bodies) create_body(body);
    forget_joints();
    impl_->joints.clear();
    for (const SceneJoint& joint : scene.joints) create_joint(joint);
}

std::size_t IsletEngine::create_body(const SceneBody& body) {
    World& w = world();
    w.clear_error();
    const BodyId id = spawn(w, body);
    if (const Error error = w.last_error(); error != Error::none) {
        if (id) w.destroy_body(id);
        const std::string field = faulty_field(w, body);
        throw std::runtime_error("bodies[" + std::to_string(impl_->bodies.size()) + "]" + (field.empty() ? "" : ".") + field + ": " + describe(error));
    }
    impl_->bodies.push_back(id);
    return impl_->bodies.size() - 1;
}

void IsletEngine::destroy_body(std::size_t index) { world().destroy_body(impl_->bodies[index]); }

BodyState IsletEngine::body(std::size_t index) const {
    const World& w = world();
    const BodyId id = impl_->bodies[index];
    BodyState state;
    state.position = w.position(id);
    state.angle = w.angle(id);
    state.linear_velocity = w.linear_velocity(id);
    state.angular_velocity = w.angular_velocity(id);
    if (w.type(id) == BodyType::dynamic) {
        state.mass = w.mass(id);
        state.inertia = w.rotational_inertia(id);
    }
    state.center = w.center_of_mass(id);
    state.awake = w.is_awake(id);
    return state;
}

bool IsletEngine::exists(std::size_t index) const { return index < impl_->bodies.size() && world().is_valid(impl_->bodies[index]); }

std::size_t IsletEngine::body_slots() const { return impl_->bodies.size(); }

EngineCounts IsletEngine::counts() const {
    const World& w = world();
    EngineCounts counts;
    counts.bodies = w.body_count();
    counts.shapes = w.shape_count();
    counts.joints = w.joint_count();
    counts.contacts = w.contact_count();
    // Before its first step a world has nothing to report.
    counts.awake_bodies = w.step_count() > 0 ? w.report().awake_bodies : awake_bodies(w, impl_->bodies);
    counts.islands = w.report().islands;
    return counts;
}

std::optional<StepProfile> IsletEngine::profile() const { return world().profile(); }

double IsletEngine::max_penetration() const {
    double deepest = 0;
    ContactInfo contact;
    for (std::uint32_t slot = 0; slot < impl_->capacity.contacts; ++slot) {
        if (!world().contact_at(slot, contact)) continue;
        for (std::uint32_t i = 0; i < contact.point_count; ++i) deepest = std::max(deepest, -double(contact.points[i].separation));
    }
    return deepest;
}

std::optional<Vec2> IsletEngine::contact_force(std::size_t index) const {
    const World& w = world();
    const BodyId body = impl_->bodies[index];
    std::vector<ContactInfo> contacts(w.contacts(body, {}));
    w.contacts(body, contacts);
    Vec2 force = {0, 0};
    for (const ContactInfo& contact : contacts) {
        const float side = w.body(contact.shape_a) == body ? -1.0f : 1.0f;
        for (std::uint32_t i = 0; i < contact.point_count; ++i) force += (side * contact.points[i].normal_impulse / impl_->substep) * contact.normal;
    }
    return force;
}

void IsletEngine::set_velocity(std::size_t index, Vec2 linear, float angular) {
    world().set_linear_velocity(impl_->bodies[index], linear);
    world().set_angular_velocity(impl_->bodies[index], angular);
}

void IsletEngine::apply_force(std::size_t index, Vec2 force) { world().apply_force_to_center(impl_->bodies[index], force); }

void IsletEngine::apply_force_at(std::size_t index, Vec2 force, Vec2 point) { world().apply_force(impl_->bodies[index], force, point); }

void IsletEngine::apply_torque(std::size_t index, float torque) { world().apply_torque(impl_->bodies[index], torque); }

void IsletEngine::apply_impulse(std::size_t index, Vec2 impulse) { world().apply_linear_impulse_to_center(impl_->bodies[index], impulse); }

void IsletEngine::make_joint(const SceneJoint& joint) {
    World& w = world();
    w.clear_error();
    const JointId id = spawn(w, joint, impl_->bodies, impl_->joints);
    if (const Error error = w.last_error(); error != Error::none) {
        const std::string field = faulty_field(w, joint, impl_->bodies, impl_->joints);
        throw std::runtime_error("joints[" + std::to_string(impl_->joints.size()) + "]" + (field.empty() ? "" : ".") + field + ": " + describe(error));
    }
    impl_->joints.push_back(id);
}

void IsletEngine::change_joint(std::size_t index) {
    const JointId id = impl_->joints[index];
    const auto pass_on = [&w = world(), id](const auto& def) {
        if constexpr (requires { def.motor; }) w.set_motor(id, def.motor);
        if constexpr (requires { def.spring; }) w.set_spring(id, def.spring);
        if constexpr (requires { def.limit; }) w.set_limit(id, def.limit);
        if constexpr (requires { def.target; }) w.set_target(id, def.target);
    };
    std::visit(pass_on, joint(index).def);
}

void IsletEngine::destroy_joint(std::size_t index) { world().destroy_joint(impl_->joints[index]); }

bool IsletEngine::joint_exists(std::size_t index) const { return index < impl_->joints.size() && world().is_valid(impl_->joints[index]); }

float IsletEngine::joint_position(std::size_t index) const { return world().joint_position(impl_->joints[index]); }

float IsletEngine::joint_speed(std::size_t index) const { return world().joint_speed(impl_->joints[index]); }

float IsletEngine::motor_force(std::size_t index) const { return world().motor_force(impl_->joints[index]); }

Vec2 IsletEngine::joint_force(std::size_t index) const { return world().joint_force(impl_->joints[index]); }

float IsletEngine::joint_torque(std::size_t index) const { return world().joint_torque(impl_->joints[index]); }

World& IsletEngine::world() { return *impl_->world; }

const World& IsletEngine::world() const { return *impl_->world; }

std::size_t IsletEngine::world_bytes() const { return islet::world_bytes(impl_->capacity); }

std::size_t IsletEngine::snapshot_bytes() const {
    return world().snapshot_bytes();
}

void IsletEngine::step(float dt) {
    world().step(dt);
    impl_->substep = dt / static_cast<float>(world().solver().substeps);
}

}  // namespace islet::samples
