// The numbers of one solve, made from the step and the solver's settings.
#pragma once

#include "../constraint/contact_rows.hpp"
#include "../constraint/joint_rows.hpp"
#include "../constraint/softness.hpp"
#include "../constraint/solver_body.hpp"
#include "../data/core.hpp"
#include "../math/inlining.hpp"
#include "../math/scalar.hpp"
#include "../solver/free_motion.hpp"

namespace islet::detail {

/// Time, warm start and limits, and how each kind of sweep treats contacts and joints.
struct SolveNumbers {
    StepNumbers step;
    SweepNumbers biased, ground, relaxed;  // `ground`: with bias, for contacts with bodies that cannot be pushed, which are stiffer
    SweepNumbers ground_alone;             // the same of those without a colour, such as those beside joint trees
    JointSweep biased_joints, relaxed_joints;
    float tolerance = 0;  // m/s; 0: no sweep is left out
    bool is_ordered = false;
};

/// A sweep over contacts that are springs: `hertz` and `damping_ratio` as in SolverDef, push_speed in m/s, h in s.
inline SweepNumbers soft_sweep(float hertz, float damping_ratio, float push_speed, float h) {
    const Softness soft = make_soft(hertz, damping_ratio, h);
    SweepNumbers n;
    n.inv_h = 1.0f / h;
    n.bias_rate = soft.rate * soft.mass_scale;
    n.mass_scale = soft.mass_scale;
    n.impulse_scale = soft.impulse_scale;
    n.push_speed = push_speed;
    return n;
}

// Of the overlap of moving bodies under a steady load, the share that contacts undo slowly; and the shares of deep overlaps that they undo in a step.
inline constexpr float load_share = 0.8f;
inline constexpr float deep_share = 0.95f;
inline constexpr float level_share = 0.55f;

// A body of a joint tree moves as its hinges let it, whereas a row knows the body's own mass and inertia alone. With M for what really moves, m for what the
// row knows, and x the error, in each of k sweeps a substep, one of which has a bias, the row's impulse p changes by
//     -m (dx/dt + rate x) - impulse_scale p  with bias,     -m dx/dt  without,
// and M d2x/dt2 = p / h. Where M is much larger than m, x comes to rest, by Routh's criterion, if k impulse_scale > h rate (mass_scale = 1 - impulse_scale).
// With two sweeps and a damping ratio of 2 that holds up to 0.208 / h; up to here it holds with a tenth to spare. (At 0.25 / h, a drawbridge that a rod held
// near its hinge whirled round, and a boom threw 60 kg that hung on it about at 15 m/s.) Contacts with the ground, whose damping ratio is 10, are steady
// up to 0.22 / h, but other rows take part in what they bear: a lever on a block of the ground, with 50 kg on its other end, shook at 0.2 / h and 0.167 / h.
inline constexpr float steady_hertz = 0.2f, steady_ground = 0.15f;

ISLET_PART SolveNumbers choose_numbers(const State& state, float dt) {
    SolveNumbers s;
    const SolverState& def = state.solver;
    StepNumbers& n = s.step;
    n.dt = dt;
    n.h = dt / static_cast<float>(def.substeps);
    n.inv_h = 1.0f / n.h;
    n.omega = def.omega;
    // A last substep that was nothing beside this one says nothing about it.
    n.warm = def.warm_start == 0 ? 0.0f : is_positive(state.last_substep) ? n.h / state.last_substep : 1.0f;
    if (!(n.warm <= 1.0e6f)) n.warm = 0;
    n.swept_warm = min(n.warm, most_swept_warm);
    n.restitution_threshold = state.restitution_threshold;
    n.max_speed = state.max_speed;
    n.max_turn = max_turn_of(dt);
    n.relaxes = is_soft(def) && def.relax_iterations > 0;
    n.lightens = has_shock(def);

    s.relaxed.inv_h = n.inv_h;
    if (is_soft(def)) {
        const float hertz = min(def.contact_hertz, 0.125f * n.inv_h);
        s.biased = soft_sweep(hertz, def.contact_damping_ratio, def.contact_push_speed, n.h);
        s.ground = soft_sweep(2.0f * hertz, def.contact_damping_ratio, def.contact_push_speed, n.h);
        if (const float undone = s.biased.bias_rate * dt; undone > 1.0e-3f) {
            n.give_back = load_share * n.omega * n.h * s.biased.impulse_scale / s.biased.bias_rate;
            n.up = up_of(state);
            n.deep = max(deep_share / undone - 1.0f, 0.0f);
            n.deep_level = max(level_share / undone - 1.0f, 0.0f);
        }
        s.biased.impulse_scale *= n.omega;
        s.biased.shares = (state.asked & asked_sharing) != 0;
        s.ground.impulse_scale *= n.omega;
        s.ground_alone = soft_sweep(min(2.0f * hertz, steady_ground * n.inv_h), def.contact_damping_ratio, def.contact_push_speed, n.h);
        s.ground_alone.impulse_scale *= n.omega;
        // Friction is solved in both sweeps. Solving it in the relaxing sweep alone, as Box2D 3.2 does, saves 3 % of large_pyramid's time, but the pile then
        // still holds 6.4 J after 500 steps instead of 0.07 J.
    } else {
        s.biased.inv_h = n.inv_h;
        s.biased.bias_rate = def.baumgarte * n.inv_h;
        s.biased.push_speed = def.contact_push_speed;
        s.biased.slop = linear_slop;
        s.ground = s.ground_alone = s.biased;
    }

    s.is_ordered = is_ordered(state.solver);
    s.tolerance = def.tolerance;

    s.relaxed_joints.h = n.h;
    s.relaxed_joints.inv_h = n.inv_h;
    s.relaxed_joints.omega = n.omega;
    s.relaxed_joints.max_turn = n.max_turn;
    s.biased_joints = s.relaxed_joints;
    s.biased_joints.biased = true;
    if (is_soft(def)) {
        // Joints are as stiff as Gauss-Seidel bears. At 240 substeps a second, the largest gap of joint_grid is 0.33 m at 60 Hz, 0.22 m at 75 Hz and 0.16 m
        // at 90 Hz. But from 65 Hz on, figures that stand on jointed legs no longer come to rest (3e-6 m/s at 60 Hz, 1e-3 m/s at 65 Hz, 0.1 m/s at 75 Hz),
        // and at 120 Hz nets and chains under load swing up by themselves. With a rigid bias they do so however weak it is.
        s.biased_joints.tree_rate = n.inv_h;
        s.biased_joints.soft = make_soft(min(def.joint_hertz, 0.25f * n.inv_h), def.joint_damping_ratio, n.h);
        s.biased_joints.soft_alone = make_soft(min(def.joint_hertz, steady_hertz * n.inv_h), def.joint_damping_ratio, n.h);
    } else {
        s.biased_joints.soft.rate = s.biased_joints.soft_alone.rate = s.biased_joints.tree_rate = def.baumgarte * n.inv_h;
    }
    return s;
}

}  // namespace islet::detail
