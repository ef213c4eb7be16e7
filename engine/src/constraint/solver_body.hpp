// A body as the solver sees it: gathered into contiguous scratch for one solve.
#pragma once

#include <cstdint>
#include <type_traits>

#include "../data/records.hpp"

namespace islet::detail {

/// An index in the plan of a solve: of a body, its slot, its island, or a contact. The small profile has half the room for it.
using PlanIndex = std::conditional_t<place_bytes == 2, std::uint16_t, std::uint32_t>;
inline constexpr auto no_plan_index = static_cast<PlanIndex>(null_index);
static_assert(max_bodies <= no_plan_index && max_contacts <= no_plan_index);  // so an index is less

/// The index as elsewhere: null_index if it is none.
ISLET_ALWAYS_INLINE constexpr std::uint32_t index_of(PlanIndex place) { return place != no_plan_index ? place : null_index; }

/// A body during a solve: eight words, loaded in lanes. Slot 0 stands for all static bodies.
///
/// Until the first substep has integrated the velocities, dp and dq are zero, and their memory collects what warm starting adds to the velocities.
struct SolverBody {
    Vec2 v;       // m/s
    float w = 0;  // rad/s
    float inv_mass = 0;
    union {
        Vec2 dp;      // m moved since the step began
        Vec2 warm_v;  // m/s
    };
    union {
        float dq;      // rad turned since the step began
        float warm_w;  // rad/s
    };
    float inv_inertia = 0;

    ISLET_ALWAYS_INLINE constexpr SolverBody() : dp{0, 0}, dq(0) {}
};

/// What the integration over a substep needs besides.
struct SolverMotion {
    Vec2 v_free;               // m/s, velocity after the last integration, before warm start and sweeps
    float w_free = 0;          // rad/s
    float angular_factor = 1;  // damping over a substep: w <- factor (w + alpha)
    Vec2 a;                    // m/s gained in a substep from gravity and forces
    float alpha = 0;           // rad/s gained in a substep from torque
    float linear_factor = 1;   // v <- factor (v + a)
};

/// Words of four bytes in the records that lanes load and write. A SolverMotion has as many as a SolverBody.
inline constexpr std::uint32_t slot_words = sizeof(SolverBody) / 4, pose_words = sizeof(Pose) / 4, motion_words = sizeof(Motion) / 4;

static_assert(sizeof(SolverMotion) == sizeof(SolverBody));
static_assert(sizeof(SolverBody) == solver_body_bytes && sizeof(SolverMotion) == solver_motion_bytes);

/// N s, N m s: a contact or joint with impulses this large forgets them and starts anew in the next step. No real load comes near it, but extreme numbers
/// together (the largest float here, a speck of dust there) can overflow in a solve. Bodies have limits of their own (solver.cpp).
inline constexpr float unsound_impulse = 1.0e28f;

/// Impulses grow with the substep, so those of the last step are scaled to this substep's length. Those of what is swept grow by this at most: what a short
/// substep pushed apart or stopped need not be pushed or stopped in a long one. (Where steps of 1/30 s and 1/240 s take turns, eightfold impulses throw columns
/// into the air. Where frame times jump between 1/30 s and 1/120 s, fourfold ones make three bars on strong motors flail at 57 m/s, 2.8-fold ones at 4 m/s, and
/// 2.2-fold ones move them at less than 2 m/s. With less, what motors hold sinks faster.)
inline constexpr float most_swept_warm = 2.2f;

/// Constants of one solve.
struct StepNumbers {
    float dt = 0;  // s
    float h = 0;   // s, substep
    float inv_h = 0;
    float omega = 1;       // relaxation factor
    float warm = 1;        // share of the last step's impulses to start from; 0: none
    float swept_warm = 1;  // the same of what is swept: contacts, and joints outside trees
    float restitution_threshold = 0;
    float max_speed = 0, max_turn = 0;
    float give_back = 0;             // kg m/N: see undo_overlap in contact_prepare.hpp
    Vec2 up = {};                    // against gravity, unit; zero if there is none
    float deep = 0, deep_level = 0;  // of deep overlaps, of level faces apart
    bool relaxes = false;            // relaxing sweeps follow those with bias
    bool lightens = false;           // shock propagation takes bodies for lighter than they are: a harder blow to one would add energy
};

}  // namespace islet::detail
