// The rows of a joint, in the order its kernel visits them. C, J and the names are those of the joint's file in constraint/; here are the rows as they
// stand now, without the bias that mends what is rigid.
#include "../exact.hpp"

#include "../constraint/joint_kinds.hpp"
#include "../export/island_problem.hpp"

namespace islet::detail {

namespace {

constexpr float infinity = __builtin_huge_valf();

/// A joint whose rows are being made: what JointKind::add_rows of every type writes them with.
struct JointRows {
    static constexpr RowKind joint_row = RowKind::joint, spring_row = RowKind::spring, motor_row = RowKind::motor;

    IslandRows& to;
    const Joint& j;
    std::uint32_t slot;
    JointPose p;
    std::uint32_t index = 0;

    void add(IslandRow row, RowKind kind, float lo, float hi, float impulse) {
        row.kind = kind;
        row.slot = slot;
        row.index = index++;
        to.add(row, lo, hi, impulse);
    }
    void add_within(const IslandRow& row, RowKind kind, float bound, float impulse) { add(row, kind, -bound, bound, impulse); }
    void add_unbounded(const IslandRow& row, RowKind kind, float impulse) { add(row, kind, -infinity, infinity, impulse); }
    void add_rigid(const IslandRow& row, float impulse) { add_unbounded(row, RowKind::joint, impulse); }

    /// A row without ends.
    static IslandRow none() { return IslandRow{}; }

    /// J = (-e, -arm x e, e, rb x e): B's point along e. A mouse joint's A is the world.
    IslandRow along(Vec2 e, Vec2 arm) const {
        if (j.body_a != null_index) return to.between(j.body_a, j.body_b, e, cross(arm, e), cross(p.rb, e));
        IslandRow row;
        to.add_end(row, j.body_b, e, cross(p.rb, e));
        return row;
    }
    IslandRow along_line(Vec2 e) const { return along(e, gap_of(p) + p.ra); }  // a line fixed in A
    IslandRow turning() const { return to.between(j.body_a, j.body_b, {0, 0}, 1, 1); }

    /// Both rows of a rigid point.
    void point() {
        add_rigid(along({1, 0}, p.ra), j.impulse.x);
        add_rigid(along({0, 1}, p.ra), j.impulse.y);
    }

    void soften(IslandRow& row, const Softness& soft, float c, float k) const;
    void motor_and_friction(const IslandRow& free);
    void spring_and_limits(const IslandRow& free, float x, float target);
    void limit(IslandRow row, float way_left, float impulse);
};

// The engine's step ends where mass_scale K^-1 (Cdot + rate C) + impulse_scale lambda = 0, which is w = 0 with a softness of K impulse_scale / mass_scale.
void JointRows::soften(IslandRow& row, const Softness& soft, float c, float k) const {
    row.bias += soft.rate * c;
    row.softness = give_of(soft) * k;
}

void JointRows::motor_and_friction(const IslandRow& free) {
    if (j.friction > 0) add_within(free, RowKind::joint_friction, to.h * j.friction, j.friction_impulse);
    if ((j.flags & joint_motor) == 0) return;
    IslandRow row = free;
    row.bias -= within_bound(j.motor_speed);
    add_within(row, RowKind::motor, to.h * j.motor_max, j.motor_impulse);
}

void JointRows::limit(IslandRow row, float way_left, float impulse) {
    row.bias += max(way_left, 0.0f) * to.inv_h;
    add(row, RowKind::limit, 0, infinity, impulse);
}

void JointRows::spring_and_limits(const IslandRow& free, float x, float target) {
    if ((j.flags & joint_spring) != 0) {
        IslandRow row = free;
        const float crowd = crowd_of(j, to.core.poses, to.core.bodies);
        const SplitSpring spring = split_spring(j.spring_hertz, j.spring_damping_ratio, crowd, to.h, false);
        soften(row, softness_of(spring), x - within_bound(target), to.coupling(row, row));
        add_unbounded(row, RowKind::spring, j.spring_impulse);
    }
    if ((j.flags & joint_limit) == 0) return;
    limit(free, x - within_bound(j.lower), j.lower_impulse);
    IslandRow back = free;  // the upper limit pulls the other way
    for (RowEnd& end : back.ends) end = {end.body, -end.linear, -end.angular};
    back.bias = -back.bias;
    limit(back, within_bound(j.upper) - x, j.upper_impulse);
}

}  // namespace

void add_joint_rows(IslandRows& to, std::uint32_t joint) {
    const Joint& j = to.core.joints[joint];
    JointRows rows{to, j, joint, pose_of(j, to.core.poses, to.core.bodies)};
    with_kind(j.joint_type(), [&](auto kind) { kind.add_rows(rows); });
}

}  // namespace islet::detail
