// What a scene, and whoever runs it, needs of a physics engine. One adapter per engine; Islet's is in islet_engine.cpp.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene.hpp"

namespace islet::samples {

/// Where a body is and how it moves; centre of mass for velocities, origin for position.
struct BodyState {
    Vec2 position;               // m
    float angle = 0;             // rad
    Vec2 linear_velocity;        // m/s
    float angular_velocity = 0;  // rad/s
    float mass = 0;              // kg, 0 unless dynamic
    float inertia = 0;           // kg m^2 about the centre of mass
    Vec2 center;                 // m, centre of mass in the world
    bool awake = true;
};

/// What a joint keeps of the moment it was made in.
struct JointMemory {
    double constant = 0;  // of a pulley length A + ratio * length B (m), of a gear c1 + ratio * c2
    Vec2 held;            // m, the point that a mouse joint pulls, from its body's origin and in its axes
};

struct EngineCounts {
    std::size_t bodies = 0, shapes = 0, joints = 0, contacts = 0, awake_bodies = 0, islands = 0;
};

class Engine {
public:
    virtual ~Engine() = default;
    virtual std::string name() const = 0;
    /// Builds the scene's bodies and joints; drops what was there.
    virtual void load(const Scene& scene) = 0;
    /// Runs the scene's before_step, advances by dt, then runs after_step. Returns the milliseconds that the engine's own step took.
    double advance(const Scene& scene, int step_index, float dt);

    virtual BodyState body(std::size_t index) const = 0;
    /// False once the body was destroyed.
    virtual bool exists(std::size_t index) const = 0;
    /// Bodies ever made, which is also the next index.
    virtual std::size_t body_slots() const = 0;
    virtual EngineCounts counts() const = 0;
    /// What the stages of the last step took, in ticks of the clock of the scene's world; none if the engine does not say.
    virtual std::optional<StepProfile> profile() const { return std::nullopt; }
    /// Deepest overlap of two shapes now (m, >= 0), as the engine itself sees it.
    virtual double max_penetration() const = 0;
    /// What contacts press on the body with, N: along their normals, in the last substep. None if the engine does not say.
    virtual std::optional<Vec2> contact_force(std::size_t) const { return std::nullopt; }

    virtual std::size_t create_body(const SceneBody& body) = 0;
    virtual void destroy_body(std::size_t index) = 0;
    virtual void set_velocity(std::size_t index, Vec2 linear, float angular) = 0;
    /// Forces and torques act over the next step; `point` is in the world.
    virtual void apply_force(std::size_t index, Vec2 force) = 0;
    virtual void apply_force_at(std::size_t index, Vec2 force, Vec2 point) = 0;
    virtual void apply_torque(std::size_t index, float torque) = 0;
    virtual void apply_impulse(std::size_t index, Vec2 impulse) = 0;

    std::size_t create_joint(const SceneJoint& joint);
    virtual void destroy_joint(std::size_t index) = 0;
    /// False once the joint was destroyed, broke, or lost one of its bodies.
    virtual bool joint_exists(std::size_t index) const = 0;
    /// Joints ever made, which is also the next index.
    std::size_t joint_slots() const { return joints_.size(); }
    /// As it was made, but for what was set since.
    const SceneJoint& joint(std::size_t index) const { return joints_[index].made; }
    const JointMemory& joint_memory(std::size_t index) const { return joints_[index].memory; }

    void set_motor(std::size_t index, const JointMotor& motor);
    void set_spring(std::size_t index, const JointSpring& spring);
    void set_limit(std::size_t index, const JointLimit& limit);
    void set_target(std::size_t index, Vec2 target);

    /// As in World: the joint's coordinate and its rate, the motor's force or torque, and what the joint does to body B.
    virtual float joint_position(std::size_t index) const = 0;
    virtual float joint_speed(std::size_t index) const = 0;
    virtual float motor_force(std::size_t index) const = 0;
    virtual Vec2 joint_force(std::size_t index) const = 0;
    virtual float joint_torque(std::size_t index) const = 0;
    /// How far the joint is from what it locks and limits, by the same formulas for every engine: see joint_measure.hpp.
    JointError joint_error(std::size_t index) const;
    /// The largest of all joints, linear and angular each for itself.
    JointError max_joint_error() const;

protected:
    virtual void step(float dt) = 0;
    /// Makes the joint with index joint_slots().
    virtual void make_joint(const SceneJoint& joint) = 0;
    /// Passes on what joint(index) says now of its motor, spring, limit or target.
    virtual void change_joint(std::size_t index) = 0;
    void forget_joints() { joints_.clear(); }

private:
    struct Joint {
        SceneJoint made;
        JointMemory memory;
    };
    std::vector<Joint> joints_;
};

/// Islet itself. `lanes` as in WorldDef.
class IsletEngine final : public Engine {
public:
    IsletEngine();
    ~IsletEngine() override;
    std::string name() const override;
    void load(const Scene& scene) override;
    BodyState body(std::size_t index) const override;
    bool exists(std::size_t index) const override;
    std::size_t body_slots() const override;
    EngineCounts counts() const override;
    std::optional<StepProfile> profile() const override;
    double max_penetration() const override;
    std::optional<Vec2> contact_force(std::size_t index) const override;
    std::size_t create_body(const SceneBody& body) override;
    void destroy_body(std::size_t index) override;
    void set_velocity(std::size_t index, Vec2 linear, float angular) override;
    void apply_force(std::size_t index, Vec2 force) override;
    void apply_force_at(std::size_t index, Vec2 force, Vec2 point) override;
    void apply_torque(std::size_t index, float torque) override;
    void apply_impulse(std::size_t index, Vec2 impulse) override;
    void destroy_joint(std::size_t index) override;
    bool joint_exists(std::size_t index) const override;
    float joint_position(std::size_t index) const override;
    float joint_speed(std::size_t index) const override;
    float motor_force(std::size_t index) const override;
    Vec2 joint_force(std::size_t index) const override;
    float joint_torque(std::size_t index) const override;
    World& world();
    const World& world() const;
    /// Bytes of the world's block, and of the part of it that a saved state must hold.
    std::size_t world_bytes() const;
    std::size_t snapshot_bytes() const;

protected:
    void step(float dt) override;
    void make_joint(const SceneJoint& joint) override;
    void change_joint(std::size_t index) override;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace islet::samples
