// Box2D 2.4 behind the interface of samples/harness/engine.hpp, so that it runs the same scenes as Islet.
#pragma once

#include <memory>
#include <string>

#include "harness/engine.hpp"

namespace islet::engines {

/// Box2D 2.4 wraps polygons and segments in a skin of 1 cm, which is what touches: a unit box is 1.02 m to its neighbours.
enum class Skin {
    inside,   ///< polygons are made smaller by the skin, so that skin and all they have the size the scene asks for; segments have none
    outside,  ///< shapes as a user of Box2D makes them
};

struct Box2dOptions {
    Skin skin = Skin::inside;
    int substeps = 1;             ///< calls of b2World::Step per step, each of dt / substeps
    int velocity_iterations = 8;  ///< per call
    int position_iterations = 3;  ///< per call
    bool continuous = true;       ///< stop fast bodies at static ones between steps
    bool nearest = false;         ///< build the nearest thing Box2D has of what it has not (box2d_nearest.hpp)
};

/// Empty if Box2D 2.4 has every feature the scene uses; else a sentence that names the first one missing.
std::string box2d_lacks(const samples::Scene& scene);
/// The same when it may build the nearest thing it has.
std::string box2d_lacks_even_nearest(const samples::Scene& scene);

class Box2dJoints;

class Box2dEngine final : public samples::Engine {
public:
    explicit Box2dEngine(const Box2dOptions& options = {});
    ~Box2dEngine() override;
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
    std::unique_ptr<Box2dJoints> joints_;
    float substep_ = 1;  // s, length of the last call of b2World::Step

    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace islet::engines
