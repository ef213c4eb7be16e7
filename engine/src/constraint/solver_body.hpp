// A body as the solver sees it: gathered into contiguous scratch for one solve.
#pragma once

#include <cstdint>

#include "../data/records.hpp"

namespace islet::detail {

/// A body during a solve: eight words, loaded in lanes. Slot 0 stands for all static bodies.
struct SolverBody {
    Vec2 v;       // m/s
    float w = 0;  // rad/s
    float inv_mass = 0;
    Vec2 dp;       // m moved since the step began. Before the first substep: the velocity that warm starting adds
    float dq = 0;  // rad turned since the step began
    float inv_inertia = 0;
};

/// What a substep's integration needs besides.
struct SolverMotion {
    Vec2 v_free;               // m/s, velocity after the last integration, before warm start and sweeps
    float w_free = 0;          // rad/s
    float angular_factor = 1;  // damping over a substep: v <- factor (v + a)
    Vec2 a;                    // m/s gained in a substep from gravity and forces
    float alpha = 0;           // rad/s gained in a substep from torque
    float linear_factor = 1;
};

static_assert(sizeof(SolverBody) == solver_body_bytes && sizeof(SolverMotion) == solver_motion_bytes);

/// N s, N m s: a contact or joint whose impulses are this large forgets them and starts anew in the next step; no real load comes near it. Extreme numbers
/// together (the largest float here, a speck of dust there) can overflow in a solve. The bodies are held within their limits besides (solver.cpp).
inline constexpr float unsound_impulse = 1.0e28f;

/// Constants of one solve.
struct StepNumbers {
    float dt = 0;  // s
    float h = 0;   // s, substep
    float inv_h = 0;
    float omega = 1;  // relaxation factor
    float warm = 1;   // share of the last step's impulses to start from; 0: none
    float restitution_threshold = 0;
    float max_speed = 0, max_turn = 0;
};

}  // namespace islet::detail
