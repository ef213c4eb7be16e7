// The rows of a joint, in the order its kernel visits them. C, J and the names are those of the joint's file in constraint/; here are the rows as they
// stand now, without the bias that mends what is rigid.
#include "../exact.hpp"

#include "../constraint/distance_joint.hpp"
#include "../constraint/gear_joint.hpp"
#include "../constraint/motor_joint.hpp"
#include "../constraint/weld_joint.hpp"
#include "../export/island_problem.hpp"

namespace islet::detail {

namespace {

constexpr float infinity = __builtin_inff();

/// A joint whose rows are being made.
struct JointRows {
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
    void add_rigid(const IslandRow& row, float impulse) { add(row, RowKind::joint, -infinity, infinity, impulse); }

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

    void motor_and_friction(const IslandRow& free);
    void spring_and_limits(const IslandRow& free, float x, float target);
    void limit(IslandRow row, float way_left, float impulse);
    void weld();
    void drive();
    void pulley();
    void gear();
};

// The engine's step ends where mass_scale K^-1 (Cdot + rate C) + impulse_scale lambda = 0, which is w = 0 with a softness of K impulse_scale / mass_scale.
void soften(IslandRow& row, const Softness& soft, float c, float k) {
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
        soften(row, make_spring(j.spring_hertz, j.spring_damping_ratio, to.h), x - within_bound(target), to.coupling(row, row));
        add(row, RowKind::spring, -infinity, infinity, j.spring_impulse);
    }
    if ((j.flags & joint_limit) == 0) return;
    limit(free, x - within_bound(j.lower), j.lower_impulse);
    IslandRow back = free;  // the upper limit pulls the other way
    for (RowEnd& end : back.ends) end = {end.body, -end.linear, -end.angular};
    back.bias = -back.bias;
    limit(back, within_bound(j.upper) - x, j.upper_impulse);
}

void JointRows::weld() {
    IslandRow rows[2] = {along({1, 0}, p.ra), along({0, 1}, p.ra)};
    const bool soft_point = j.linear_hertz > 0, soft_angle = j.angular_hertz > 0;
    const RowKind kind = soft_point ? RowKind::spring : RowKind::joint;
    if (soft_point) {
        const Softness soft = make_soft(j.linear_hertz, j.linear_damping_ratio, to.h);
        const float k = 0.5f * (to.coupling(rows[0], rows[0]) + to.coupling(rows[1], rows[1]));
        soften(rows[0], soft, gap_of(p).x, k);
        soften(rows[1], soft, gap_of(p).y, k);
    }
    add(rows[0], kind, -infinity, infinity, j.impulse.x);
    add(rows[1], kind, -infinity, infinity, j.impulse.y);
    IslandRow angle = turning();
    if (soft_angle) soften(angle, make_soft(j.angular_hertz, j.angular_damping_ratio, to.h), angle_of(p), to.coupling(angle, angle));
    add(angle, soft_angle ? RowKind::spring : RowKind::joint, -infinity, infinity, j.angular_impulse);
}

// The motor joint, and the mouse joint, which has no A and no torque. The engine's softness of the point is a multiple of its K, a matrix: along K's
// principal axes it is diagonal. A rigid drive has its first row along the impulse it gives, so that one that gives all it has is at the bound of that
// row alone, as the engine bounds the impulse's length.
void JointRows::drive() {
    if (j.body_a != null_index) {
        const Softness soft = drive_softness(j.angular_hertz, j.angular_damping_ratio, to.h);
        IslandRow row = turning();
        row.bias -= within_bound(j.motor_speed);
        soften(row, soft, angle_of(p), to.coupling(row, row));
        add_within(row, RowKind::motor, to.h * j.max_torque, j.angular_impulse);
    }
    const Softness soft = drive_softness(j.linear_hertz, j.linear_damping_ratio, to.h);
    const Vec2 velocity = rotate(p.qa, {within_bound(j.velocity.x), within_bound(j.velocity.y)});
    Vec2 e = normalize(j.impulse);
    if (j.linear_hertz > 0) {
        const IslandRow x = along({1, 0}, p.ra), y = along({0, 1}, p.ra);
        const Rot axis = make_rot(0.5f * islet::atan2(2.0f * to.coupling(x, y), to.coupling(x, x) - to.coupling(y, y)));
        e = {axis.c, axis.s};
    } else if (e == Vec2{}) {
        e = {1, 0};
    }
    for (const Vec2 axis : {e, left_perp(e)}) {
        IslandRow row = along(axis, p.ra);
        row.bias -= dot(axis, velocity);
        soften(row, soft, dot(axis, gap_of(p)), to.coupling(row, row));
        add_within(row, RowKind::motor, to.h * j.motor_max, dot(axis, j.impulse));
    }
}

void JointRows::pulley() {
    const Vec2 ua = normalize(to.core.poses[j.body_a].center + p.ra - j.ground_a);
    const Vec2 ub = normalize(to.core.poses[j.body_b].center + p.rb - j.ground_b);
    IslandRow row;
    to.add_end(row, j.body_a, -ua, -cross(p.ra, ua));
    to.add_end(row, j.body_b, -j.ratio * ub, -j.ratio * cross(p.rb, ub));
    add_rigid(row, j.impulse.x);
}

void JointRows::gear() {
    IslandRow row;
    float ratio = 1;
    for (const std::uint32_t joint : {j.joint1, j.joint2}) {
        const Joint& geared = to.core.joints[joint];
        const GearSide side = gear_side(geared, pose_of(geared, to.core.poses, to.core.bodies));
        to.add_end(row, geared.body_a, -ratio * side.u, -ratio * side.sa);
        to.add_end(row, geared.body_b, ratio * side.u, ratio * side.sb);
        ratio = j.ratio;
    }
    add_rigid(row, j.impulse.x);
}

}  // namespace

void add_joint_rows(IslandRows& to, std::uint32_t joint) {
    const Joint& j = to.core.joints[joint];
    JointRows rows{to, j, joint, {}};
    const JointType type = j.joint_type();
    if (type == JointType::gear) return rows.gear();
    rows.p = pose_of(j, to.core.poses, to.core.bodies);
    const JointPose& p = rows.p;
    const Vec2 u = {p.qa.c, p.qa.s};
    switch (type) {
        case JointType::revolute: {
            const IslandRow free = rows.turning();
            rows.motor_and_friction(free);
            rows.spring_and_limits(free, coordinate_of(j, p), j.target);
            return rows.point();
        }
        case JointType::prismatic: {
            const IslandRow free = rows.along_line(u);
            rows.motor_and_friction(free);
            rows.spring_and_limits(free, coordinate_of(j, p), j.target);
            rows.add_rigid(rows.along_line(left_perp(u)), j.impulse.x);
            return rows.add_rigid(rows.turning(), j.angular_impulse);
        }
        case JointType::distance: {
            const Vec2 d = gap_of(p);
            const float x = length(d);
            if (!(x > least_distance)) return;  // no direction
            const IslandRow free = rows.along({d.x / x, d.y / x}, p.ra);
            rows.motor_and_friction(free);
            rows.spring_and_limits(free, x, j.length);
            if (is_rod(j)) rows.add_rigid(free, j.impulse.x);
            return;
        }
        case JointType::weld: return rows.weld();
        case JointType::wheel:
            rows.motor_and_friction(rows.turning());
            rows.spring_and_limits(rows.along_line(u), coordinate_of(j, p), j.target);
            return rows.add_rigid(rows.along_line(left_perp(u)), j.impulse.x);
        case JointType::motor:
        case JointType::mouse: return rows.drive();
        case JointType::pulley: return rows.pulley();
        case JointType::gear: return;
    }
}

}  // namespace islet::detail
