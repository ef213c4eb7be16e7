// An island as a complementarity problem. World::export_island writes it for the matrix solvers of lcp.hpp or any others: to study it, to compare solvers, or
// to solve it in another way. islet.hpp does not include this header. A program that does not call the solvers needs only the types of lcp.hpp.
//
// One substep of length h asks for impulses x, one for each row, N s or N m s. Let J be the rows' Jacobians, M_b the bodies' masses and inertias, and v_free
// the velocities that the bodies have after forces and damping alone. The impulses turn v_free into
//
//     v = v_free + M_b^-1 J^T x
//
// and the rows then have the residual velocities w = J v + bias + softness x, m/s or rad/s; that is, w = M x + q with
//
//     M = J M_b^-1 J^T + diag(softness),   q = J v_free + bias.
//
// Each row needs lo <= x <= hi, w >= 0 where x = lo, w <= 0 where x = hi, and w = 0 between: a contact pushes or parts, a joint holds, and a motor below its
// speed gives its greatest force. This is the problem of the default schedule's relaxing sweep: rigid rows at the velocity level, without the bias that
// corrects position errors. Springs are as in the sweeps with bias. Bounces and shock propagation are not part of it. Rows that push no body of the island,
// such as the angle of a weld between bodies of fixed rotation, are left out.
#pragma once

#include <cstdint>

#include "islet/lcp.hpp"
#include "islet/span.hpp"
#include "islet/types.hpp"

ISLET_API_BEGIN
namespace islet {

/// The kind of a row, with its bounds lo, hi and its bias.
enum class RowKind : std::uint8_t {
    normal,          ///< of a point of a contact: 0, infinity; bias max(separation, 0) / h
    friction,        ///< of a point, along right_perp(normal): +-coefficient times the x of the point's normal row (Problem::friction); bias -tangent speed
    rolling,         ///< of a contact. The engine bounds it by the resistance times the sum of the contact's normal impulses. Problem::friction names only
                     ///< one row, so here the sum is that of `impulses`, frozen
    joint,           ///< a direction that a joint locks: -infinity, infinity
    spring,          ///< -infinity, infinity; softness and bias are those of the spring, or of a soft weld
    limit,           ///< 0, infinity; the row of an upper limit is turned around. bias max(way left, 0) / h
    motor,           ///< +-h times the greatest force or torque; bias -speed. The point of a motor or mouse joint makes two such rows: the engine bounds
                     ///< the length of both, here each has its own bounds. With a frequency, the rows have softness and bias
    joint_friction,  ///< +-h times the friction of the joint
};

/// RowEnd::body of an end that cannot be pushed: a static or kinematic body, or the world itself.
inline constexpr std::uint32_t no_body = 0xffffffffu;

/// The entries of a row's Jacobian for one body. The body adds dot(linear, v) + angular w to the row's velocity. The row's x gives the body the impulse x
/// linear and the angular impulse x angular.
struct RowEnd {
    std::uint32_t body = no_body;  ///< index into IslandProblem::bodies, or no_body
    Vec2 linear = {};              ///< 1; m for a row in rad
    float angular = 0;             ///< m; 1 for a row in rad
};

/// One row. The rows of one contact or joint stand together.
struct IslandRow {
    RowKind kind = RowKind::normal;
    std::uint32_t slot = 0;       ///< of the contact (World::contact_at) for normal, friction and rolling; else of the joint (World::joint_at)
    std::uint32_t index = 0;      ///< point of the contact, 0 or 1; row of the joint, from 0
    std::uint32_t end_count = 0;  ///< 1 to 4; no two ends have the same body of the island
    RowEnd ends[4] = {};
    float bias = 0;      ///< m/s or rad/s: the part of w that does not come from the island's bodies, including the motion of kinematic ends
    float softness = 0;  ///< 1/kg or 1/(kg m^2); 0: rigid
};

/// One body.
struct IslandBody {
    BodyId id = {};
    float inv_mass = 0;     ///< 1/kg, > 0
    float inv_inertia = 0;  ///< 1/(kg m^2), as in the solver, which lessens it for bodies pulled so hard that they would swing within a substep
    Vec2 v_free = {};       ///< m/s, of the centre of mass: after gravity, forces and damping over h, before any impulse
    float w_free = 0;       ///< rad/s; of a link of a joint tree, scaled with the inertia
};

/// Spans into the memory given to World::export_island.
struct IslandProblem {
    /// Sparse, symmetric and positive semi-definite, but for friction; its rows are `rows`.
    lcp::Problem<float> lcp = {};
    /// x of the last step, scaled to a substep of length h: the warm start. You may write to it.
    span<float> impulses = {};
    /// Joints by ascending slot, then contacts by ascending slot; within one, in the order the engine's sweep visits them.
    span<const IslandRow> rows = {};
    /// By ascending slot.
    span<const IslandBody> bodies = {};
};

}  // namespace islet
ISLET_API_END
