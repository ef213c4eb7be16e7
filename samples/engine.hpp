// What a scene, the runner and the comparison need of a physics engine. One adapter per engine; Islet's is in islet_engine.cpp.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

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

struct EngineCounts {
    std::size_t bodies = 0, shapes = 0, joints = 0, contacts = 0, awake_bodies = 0, islands = 0;
};

class Engine {
public:
    virtual ~Engine() = default;
    virtual std::string name() const = 0;
    /// Builds the scene's bodies; drops what was there.
    virtual void load(const Scene& scene) = 0;
    /// Runs the scene's before_step, advances by dt, then runs after_step. Returns the milliseconds that the engine's own step took.
    double advance(const Scene& scene, int step_index, float dt);

    virtual BodyState body(std::size_t index) const = 0;
    /// False once the body was destroyed.
    virtual bool exists(std::size_t index) const = 0;
    /// Bodies ever made, which is also the next index.
    virtual std::size_t body_slots() const = 0;
    virtual EngineCounts counts() const = 0;
    /// Deepest overlap of two shapes now (m, >= 0), as the engine itself sees it.
    virtual double max_penetration() const = 0;

    virtual std::size_t create_body(const SceneBody& body) = 0;
    virtual void destroy_body(std::size_t index) = 0;
    virtual void set_velocity(std::size_t index, Vec2 linear, float angular) = 0;
    virtual void apply_force(std::size_t index, Vec2 force) = 0;
    virtual void apply_impulse(std::size_t index, Vec2 impulse) = 0;

protected:
    virtual void step(float dt) = 0;
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
    double max_penetration() const override;
    std::size_t create_body(const SceneBody& body) override;
    void destroy_body(std::size_t index) override;
    void set_velocity(std::size_t index, Vec2 linear, float angular) override;
    void apply_force(std::size_t index, Vec2 force) override;
    void apply_impulse(std::size_t index, Vec2 impulse) override;
    World& world();
    const World& world() const;
    /// Bytes of the world's block, and of the part of it that a saved state must hold.
    std::size_t world_bytes() const;
    std::size_t snapshot_bytes() const;

protected:
    void step(float dt) override;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace islet::samples
