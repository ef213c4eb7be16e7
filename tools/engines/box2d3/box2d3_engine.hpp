// Box2D 3 behind the interface of samples/harness/engine.hpp, so that it runs the same scenes as Islet. README.md says what is made equal. (Nothing here
// includes Box2D's headers, whose names those of Box2D 2.4 have, too.)
#pragma once

#include <memory>
#include <string>

#include "harness/engine.hpp"

namespace islet::engines {

/// Empty if Box2D 3 can build the scene; else a sentence that names the first feature it has not.
std::string box2d3_lacks(const samples::Scene& scene);

/// Steps with as many workers as the scene's world has, on threads of Box2D's own.
class Box2d3Engine final : public samples::Engine {
public:
    Box2d3Engine();
    ~Box2d3Engine() override;
    std::string name() const override;
    void load(const samples::Scene& scene) override;
    samples::BodyState body(std::size_t index) const override;
    bool exists(std::size_t index) const override;
    std::size_t body_slots() const override;
    samples::EngineCounts counts() const override;
    double max_penetration() const override;
    std::optional<Vec2> contact_force(std::size_t index) const override;
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
    void break_overloaded();

    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace islet::engines
