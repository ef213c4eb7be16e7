// The joints of a scene as constraints of Chipmunk 7, known by the scene's indices. One joint is several constraints: README.md has the list.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <chipmunk/chipmunk.h>

#include "harness/engine.hpp"

namespace islet::engines {

/// Empty, or the first thing that Chipmunk 7 lacks to make the scene's joint.
std::string chipmunk_joint_lacks(const samples::Scene& scene, const samples::SceneJoint& joint);

class ChipmunkJoints {
public:
    ChipmunkJoints() = default;
    ChipmunkJoints(const ChipmunkJoints&) = delete;
    ChipmunkJoints& operator=(const ChipmunkJoints&) = delete;
    ~ChipmunkJoints() { clear(); }
    /// Frees all joints. Their space must be gone, or never have been.
    void clear();
    /// For a new space, after clear().
    void load(cpSpace* space) { space_ = space; }
    /// Of a mouse joint `a` is not read, of a gear neither body is. Throws std::runtime_error if Chipmunk lacks what the joint needs.
    void make(const samples::SceneJoint& joint, cpBody* a, cpBody* b);
    void change(std::size_t index, const samples::SceneJoint& joint);
    /// The gears on the joint too.
    void destroy(std::size_t index);
    /// To be called before a body is destroyed.
    void destroy_joints_of(cpBody* body);
    /// Destroys the joints whose force or torque over the last step, of h seconds, was more than they stand.
    void break_overloaded(double h);

    bool exists(std::size_t index) const { return index < joints_.size() && joints_[index].b != nullptr; }
    std::size_t count() const;
    float position(std::size_t index) const;
    float speed(std::size_t index) const;
    /// Over the last step, of h seconds; 0 before the first.
    float motor_force(std::size_t index, double h) const;
    Vec2 force(std::size_t index, double h) const;
    float torque(std::size_t index, double h) const;

private:
    /// What a joint's constraints do in it.
    enum Part : std::size_t { point, angle, limit, spring, motor, friction, part_count };
    enum class Coordinate { none, angle, way, length };

    struct Entry {
        cpBody *a = nullptr, *b = nullptr;  // null once destroyed
        std::array<cpConstraint*, part_count> parts = {};
        Coordinate coordinate = Coordinate::none;
        cpVect anchor_a = {}, anchor_b = {};  // m, on the bodies
        cpVect axis = {};                     // on body A
        double reference = 0;                 // rad, the angle of B less that of A where the joint's own is 0
        bool collide = false;                 // the bodies may
        float break_force = 0, break_torque = 0;
        std::size_t joint1 = 0, joint2 = 0;  // of a gear
    };
    struct Setter;

    void place(Entry& entry, const JointBase& base) const;
    cpConstraint*& add(Entry& entry, Part part, cpConstraint* made) const;
    void drop(Entry& entry, Part part) const;
    void mesh(Entry& gear, const samples::SceneJoint& joint, double ratio) const;
    static cpVect impulse(const Entry& entry);
    static double twist(const Entry& entry, double h);

    cpSpace* space_ = nullptr;
    std::vector<Entry> joints_;
    std::vector<std::size_t> gears_;
};

}  // namespace islet::engines
