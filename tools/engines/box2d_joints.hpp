// The joints of a scene as Box2D 2.4 joints, known by the scene's indices.
#pragma once

#include <string>
#include <vector>

#include <box2d/box2d.h>

#include "harness/engine.hpp"

namespace islet::engines {

/// Empty, or the first thing that Box2D 2.4 lacks to make the joint.
std::string joint_lacks(const samples::SceneJoint& joint);

class Box2dJoints final : private b2DestructionListener {
public:
    /// For a new world; what was there belonged to the old one.
    void load(b2World& world);
    void make(const std::vector<b2Body*>& bodies, const samples::SceneJoint& joint);
    void change(std::size_t index, const samples::SceneJoint& joint);
    void destroy(std::size_t index);
    /// To be called before a body is destroyed: Box2D does not know that a gear depends on its joints.
    void destroy_gears_of(const b2Body& body);
    /// Destroys the joints whose force or torque over the last call of b2World::Step, of h seconds, was more than they stand.
    void break_overloaded(float h);

    bool exists(std::size_t index) const { return index < joints_.size() && joints_[index].joint != nullptr; }
    std::size_t count() const;
    float position(std::size_t index) const;
    float speed(std::size_t index) const;
    /// Over the last call of b2World::Step, of h seconds.
    float motor_force(std::size_t index, float h) const;
    Vec2 force(std::size_t index, float h) const;
    float torque(std::size_t index, float h) const;

private:
    struct Entry {
        b2Joint* joint = nullptr;  // null once destroyed
        float break_force = 0, break_torque = 0;
    };
    void SayGoodbye(b2Joint* joint) override;
    void SayGoodbye(b2Fixture*) override {}

    b2World* world_ = nullptr;
    b2Body* nothing_ = nullptr;  // a static body without shapes: what mouse joints are tied to
    std::vector<Entry> joints_;
};

}  // namespace islet::engines
