#include "engine.hpp"

#include <chrono>

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

}  // namespace islet::samples
