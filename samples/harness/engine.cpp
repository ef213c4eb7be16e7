#include "engine.hpp"

#include <algorithm>
#include <chrono>

#include "joint_measure.hpp"

namespace islet::samples {

double Engine::advance(const Scene& scene, int step_index, float dt) {
    using Clock = std::chrono::steady_clock;
    if (scene.before_step) scene.before_step(*this, step_index);
    const Clock::time_point start = Clock::now();
    step(dt);
    const std::chrono::duration<double, std::milli> spent = Clock::now() - start;
    if (scene.after_step) scene.after_step(*this, step_index);
    return spent.count();
}

std::size_t Engine::create_joint(const SceneJoint& joint) {
    make_joint(joint);
    joints_.push_back({joint, remember_joint(*this, joint)});
    return joints_.size() - 1;
}

void Engine::set_motor(std::size_t index, const JointMotor& motor) {
    std::visit(
        [&](auto& def) {
            if constexpr (requires { def.motor; }) def.motor = motor;
        },
        joints_[index].made.def);
    change_joint(index);
}

void Engine::set_spring(std::size_t index, const JointSpring& spring) {
    std::visit(
        [&](auto& def) {
            if constexpr (requires { def.spring; }) def.spring = spring;
        },
        joints_[index].made.def);
    change_joint(index);
}

void Engine::set_limit(std::size_t index, const JointLimit& limit) {
    std::visit(
        [&](auto& def) {
            if constexpr (requires { def.limit; }) def.limit = limit;
        },
        joints_[index].made.def);
    change_joint(index);
}

void Engine::set_target(std::size_t index, Vec2 target) {
    std::visit(
        [&](auto& def) {
            if constexpr (requires { def.target; }) def.target = target;
        },
        joints_[index].made.def);
    change_joint(index);
}

JointError Engine::joint_error(std::size_t index) const { return measure_joint_error(*this, index); }

JointError Engine::max_joint_error() const {
    JointError most;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        if (!joint_exists(i)) continue;
        const JointError error = joint_error(i);
        most.linear = std::max(most.linear, error.linear);
        most.angular = std::max(most.angular, error.angular);
    }
    return most;
}

}  // namespace islet::samples
