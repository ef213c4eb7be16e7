// An island as a complementarity problem: what World::export_island writes, for the matrix solvers of lcp.hpp or any others, to be looked at, judged
// against, or solved in another way. islet.hpp does not include this header, and who uses it needs of lcp.hpp only the types, unless it solves.
//
// One substep of length h asks for impulses x, one a row, N s or N m s. With J the rows' Jacobians and M_b the bodies' masses and inertias they make the
// velocities v_free, which the bodies have after forces and damping alone, into
//
//     v = v_free + M_b^-1 J^T x
//
// and what the rows then see is w = J v + bias + softness x, m/s or rad/s; that is, w = M x + q with
//
//     M = J M_b^-1 J^T + diag(softness),   q = J v_free + bias.
//
// Each row wants lo <= x <= hi, w >= 0 where x = lo, w <= 0 where x = hi, and w = 0 between: a contact pushes or parts, a joint holds, a motor that has
// not reached its speed gives all it has. It is the problem that the relaxing sweep of the default schedule works on: rigid rows at the velocity level,
// without the bias that mends errors of position; and the springs, as the sweeps with bias have them. The bounce of contacts is not part of it, nor is
// shock propagation. A row that could push no body of the island, such as the angle of a weld between bodies of fixed rotation, is left out.
#pragma once

#include <cstdint>
#include <span>

#include "islet/lcp.hpp"
#include "islet/types.hpp"

ISLET_API_BEGIN
namespace islet {

/// What a row is for; of the bounds lo, hi and of the bias.
enum class RowKind : std::uint8_t {
    normal,          ///< of a point of a contact: 0, infinity; bias max(separation, 0) / h
    friction,        ///< of a point, along right_perp(normal): +-coefficient times the x of the point's normal row (Problem::friction); bias -tangent speed
    rolling,         ///< of a contact. The engine bounds it by the resistance times the sum of the contact's normal impulses, which Problem::friction,
                     ///< that names one row, cannot say: here the sum is that of `impulses`, frozen
    joint,           ///< what a joint locks: -infinity, infinity
    spring,          ///< -infinity, infinity; softness and bias are those of the spring, or of a soft weld
    limit,           ///< 0, infinity; the row of an upper limit is turned around. bias max(way left, 0) / h
    motor,           ///< +-h times the greatest force or torque; bias -speed. The point of motor and mouse joints makes two such rows: the engine bounds
                     ///< their length together, here each is bounded by itself. softness and bias if they have a frequency
    joint_friction,  ///< +-h times the friction of the joint
};

/// RowEnd::body of what cannot be pushed: static and kinematic bodies, and the world itself.
inline constexpr std::uint32_t no_body = 0xffffffffu;

/// The entries of a row's Jacobian for one body: the row sees dot(linear, v) + angular w of it, and x pushes it by x linear and turns it by x angular.
struct RowEnd {
    std::uint32_t body = no_body;  ///< index into IslandProblem::bodies, or no_body
    Vec2 linear = {};              ///< 1; m for a row in rad
    float angular = 0;             ///< m; 1 for a row in rad
};

/// One row. Those of one contact or joint stand together.
struct IslandRow {
    RowKind kind = RowKind::normal;
    std::uint32_t slot = 0;       ///< of the contact (World::contact_at) for normal, friction and rolling; else of the joint (World::joint_at)
    std::uint32_t index = 0;      ///< point of the contact, 0 or 1; row of the joint, from 0
    std::uint32_t end_count = 0;  ///< 1 to 4; no two ends are of the same body of the island
    RowEnd ends[4] = {};
    float bias = 0;      ///< m/s or rad/s: all of w that is not of the island's bodies, the motion of kinematic ends included
    float softness = 0;  ///< 1/kg or 1/(kg m^2); 0: rigid
};

/// One body.
struct IslandBody {
    BodyId id = {};
    float inv_mass = 0;     ///< 1/kg, > 0
    float inv_inertia = 0;  ///< 1/(kg m^2), as the solver takes it: of bodies pulled so hard that they would swing within a substep it is made less
    Vec2 v_free = {};       ///< m/s, of the centre of mass: after gravity, forces and damping over h, before any impulse
    float w_free = 0;       ///< rad/s; of a body in a tree of hinges that is solved exactly, scaled with the inertia
};

/// Spans into the memory given to World::export_island.
struct IslandProblem {
    /// Sparse, symmetric and positive semi-definite, but for friction; its rows are `rows`.
    lcp::Problem<float> lcp = {};
    /// x as the last step left it, scaled to a substep of length h: the warm start. To be written to.
    std::span<float> impulses = {};
    /// Joints by ascending slot, then contacts by ascending slot; within one, in the order the engine's sweep visits them.
    std::span<const IslandRow> rows = {};
    /// By ascending slot.
    std::span<const IslandBody> bodies = {};
};

}  // namespace islet
ISLET_API_END
