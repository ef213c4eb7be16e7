// Chipmunk 7 behind the interface of samples/harness/engine.hpp, so that it runs the same scenes as Islet. README.md says what is made equal.
#pragma once

#include <memory>
#include <string>

#include "harness/engine.hpp"

namespace islet::engines {

/// Empty if Chipmunk 7 can build the scene; else a sentence that names the first feature it has not.
std::string chipmunk_lacks(const samples::Scene& scene);

class ChipmunkJoints;

class ChipmunkEngine final : public samples::Engine {
public:
    ChipmunkEngine();
    ~ChipmunkEngine() override;
    std::string name() const override;
    void load(const samples::Scene& scene) override;
    samples::BodyState body(std::size_t index) const override;
    bool exists(std::size_t index) const override;
    std::size_t body_slots() const override;
    samples::EngineCounts counts() const override;
    double max_penetration() const override;
    std::size_t create_body(const samples::SceneBody& body) override;
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

protected:
    void step(float dt) override;
    void make_joint(const samples::SceneJoint& joint) override;
    void change_joint(std::size_t index) override;

private:
    void clear();

    std::unique_ptr<ChipmunkJoints> joints_;
    double last_step_ = 0;  // s, 0 before the first

    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace islet::engines
