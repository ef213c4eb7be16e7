// The rows that World::export_island makes of joints: each is the derivative of what the joint measures, found by moving its bodies a little, and its
// bounds, bias and softness are those of the joint's definition.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "support/island.hpp"
#include "support/joint_world.hpp"
#include "support/test_world.hpp"

namespace {

using namespace islet;
using islet::test::ExportedIsland;
using islet::test::substep;
using islet::test::TestWorld;

constexpr float infinity = std::numeric_limits<float>::infinity();

/// What one row of a joint must be.
struct Wanted {
    RowKind kind;
    std::function<double()> c;  // its coordinate, of the world as it stands; the row is its derivative
    float lo = -infinity, hi = infinity;
    float bias = 0;
};

// Two bodies whose centres of mass are not their origins, out of line with each other and with the joint, so that no entry is zero by chance.
struct JointedPair {
    TestWorld w{test::roomy, {.gravity = {0, 0}}};
    BodyId a = add({1, 2}, 0.3f), b = add({3, 2.5f}, -0.4f);

    BodyId add(Vec2 at, float angle) {
        const BodyId body =
            w.add(make_box(0.5f, 0.2f), {.type = BodyType::dynamic, .position = at, .angle = angle}, {.filter = {.group = -1}});
        w->create_shape(body, Circle{{0.4f, 0.3f}, 0.2f}, {.density = 3, .filter = {.group = -1}});
        return body;
    }
    JointBase base() const { return {.body_a = a, .body_b = b, .frame_a = {{0.9f, 0.3f}, 0.5f}, .frame_b = {{-0.7f, 0.2f}, 0.9f}}; }

    // What a joint measures, by reading bodies and anchors.
    double gap(JointId j, Vec2 e) const {
        const Vec2 p = w->anchor_a(j), q = w->anchor_b(j);
        return double(e.x) * (double(q.x) - double(p.x)) + double(e.y) * (double(q.y) - double(p.y));
    }
    double across(JointId j) const { return gap(j, left_perp(axis(j))); }
    double turned() const { return double(w->angle(b)) - double(w->angle(a)); }
    double position(JointId j) const { return double(w->joint_position(j)); }
    Vec2 axis(JointId j) const {
        const Rot q = make_rot(w->angle(w->body_a(j)) + w->frame_a(j).angle);
        return {q.c, q.s};
    }
};

// Moves the body's centre of mass to `center`, turned to `angle`.
void place(World& w, BodyId body, Vec2 center, float angle) {
    w.set_transform(body, center - rotate(make_rot(angle), w.local_center_of_mass(body)), angle);
}

double derivative(World& w, BodyId body, Vec2 along, float turn, const std::function<double()>& c) {
    constexpr float step = 2e-3f;
    const Vec2 center = w.center_of_mass(body), origin = w.position(body);
    const float angle = w.angle(body);
    place(w, body, center + step * along, angle + step * turn);
    const double after = c();
    place(w, body, center - step * along, angle - step * turn);
    const double before = c();
    w.set_transform(body, origin, angle);
    return (after - before) / (2 * double(step));
}

// Rows of the joint `slot`, those of others left aside.
void expect_rows(TestWorld& w, JointId joint, const std::vector<Wanted>& wanted) {
    const ExportedIsland island(*w, w->body_b(joint), substep);
    const std::uint32_t slot = joint.index1 - 1;
    std::size_t at = 0;
    for (std::size_t i = 0; i < island->rows.size(); ++i) {
        const IslandRow& row = island->rows[i];
        if (row.slot != slot) continue;
        SCOPED_TRACE("row " + std::to_string(at));
        ASSERT_LT(at, wanted.size());
        const Wanted& want = wanted[at];
        EXPECT_EQ(row.kind, want.kind);
        EXPECT_EQ(row.index, at++);
        EXPECT_EQ(island->lcp.lo[i], want.lo);
        EXPECT_EQ(island->lcp.hi[i], want.hi);
        EXPECT_EQ(island->lcp.friction[i], lcp::no_row);
        if (row.softness == 0) { EXPECT_NEAR(row.bias, want.bias, 1e-4f * (1 + std::fabs(want.bias))); }
        for (std::uint32_t k = 0; k < island->bodies.size(); ++k) {
            RowEnd entries;
            std::uint32_t ends = 0;
            for (std::uint32_t e = 0; e < row.end_count; ++e) {
                if (row.ends[e].body != k) continue;
                entries = row.ends[e];
                ++ends;
            }
            EXPECT_LE(ends, 1u) << "a body stands in a row once";
            const BodyId body = island->bodies[k].id;
            EXPECT_NEAR(double(entries.linear.x), derivative(*w, body, {1, 0}, 0, want.c), 1e-3) << "body " << k;
            EXPECT_NEAR(double(entries.linear.y), derivative(*w, body, {0, 1}, 0, want.c), 1e-3) << "body " << k;
            EXPECT_NEAR(double(entries.angular), derivative(*w, body, {0, 0}, 1, want.c), 2e-3) << "body " << k;
        }
    }
    EXPECT_EQ(at, wanted.size());
}

constexpr JointSpring spring = {.enable = true, .hertz = 3, .damping_ratio = 0.4f, .target = 0.1f};
constexpr JointMotor motor = {.enable = true, .speed = 1.5f, .max_force = 7};

// Friction, motor, spring and both limits of one coordinate; `x` is its value now.
std::vector<Wanted> all_parts(const std::function<double()>& c, float lower, float upper, float friction) {
    const auto x = static_cast<float>(c());
    std::vector<Wanted> rows;
    if (friction > 0) rows.push_back({RowKind::joint_friction, c, -substep * friction, substep * friction});
    rows.push_back({RowKind::motor, c, -substep * 7, substep * 7, -1.5f});
    rows.push_back({RowKind::spring, c});
    rows.push_back({RowKind::limit, c, 0, infinity, std::max(x - lower, 0.0f) / substep});
    rows.push_back({RowKind::limit, [=] { return -c(); }, 0, infinity, std::max(upper - x, 0.0f) / substep});
    return rows;
}

TEST(ExportJoints, RevoluteRows) {
    JointedPair p;
    const JointId j = p.w->create_joint(RevoluteJointDef{
        .base = p.base(), .spring = spring, .limit = {.enable = true, .lower = -3, .upper = -0.35f}, .motor = motor, .friction = 2});
    std::vector<Wanted> rows = all_parts([&] { return p.position(j); }, -3, -0.35f, 2);
    rows.push_back({RowKind::joint, [&] { return p.gap(j, {1, 0}); }});
    rows.push_back({RowKind::joint, [&] { return p.gap(j, {0, 1}); }});
    expect_rows(p.w, j, rows);
}

TEST(ExportJoints, PrismaticRows) {
    JointedPair p;
    const JointId j = p.w->create_joint(PrismaticJointDef{
        .base = p.base(), .spring = spring, .limit = {.enable = true, .lower = -1, .upper = 2}, .motor = motor, .friction = 2});
    std::vector<Wanted> rows = all_parts([&] { return p.position(j); }, -1, 2, 2);
    rows.push_back({RowKind::joint, [&] { return p.across(j); }});
    rows.push_back({RowKind::joint, [&] { return p.turned(); }});
    expect_rows(p.w, j, rows);
}

TEST(ExportJoints, AngleRows) {
    JointedPair p;
    const JointId j = p.w->create_joint(AngleJointDef{
        .base = p.base(), .spring = spring, .limit = {.enable = true, .lower = -3, .upper = 2}, .motor = motor, .friction = 2});
    expect_rows(p.w, j, all_parts([&] { return p.position(j); }, -3, 2, 2));
}

// The last tooth that the angle is past is a lower limit.
TEST(ExportJoints, RatchetRows) {
    JointedPair p;
    const JointId j = p.w->create_joint(AngleJointDef{.base = p.base(), .ratchet = {.step = 0.3f, .phase = 0.1f}});
    const auto turned = [&] { return p.turned(); };
    const float x = p.w->joint_position(j), tooth = 0.1f + 0.3f * std::floor((x - 0.1f) / 0.3f);
    expect_rows(p.w, j, {{RowKind::limit, turned, 0, infinity, (x - tooth) / substep},
                         {RowKind::limit, [&] { return -turned(); }, 0, infinity, 1.0e12f / substep}});
}

TEST(ExportJoints, WheelRows) {
    JointedPair p;
    const JointId j = p.w->create_joint(WheelJointDef{
        .base = p.base(), .spring = spring, .limit = {.enable = true, .lower = -1, .upper = 2}, .motor = motor, .friction = 2});
    const auto turned = [&] { return p.turned(); };
    const auto strut = [&] { return p.position(j); };
    const float x = p.w->joint_position(j);
    expect_rows(p.w, j,
                {{RowKind::joint_friction, turned, -substep * 2, substep * 2},
                 {RowKind::motor, turned, -substep * 7, substep * 7, -1.5f},
                 {RowKind::spring, strut},
                 {RowKind::limit, strut, 0, infinity, (x + 1) / substep},
                 {RowKind::limit, [&] { return -strut(); }, 0, infinity, (2 - x) / substep},
                 {RowKind::joint, [&] { return p.across(j); }}});
}

TEST(ExportJoints, DistanceRows) {
    JointedPair p;
    const JointId rod = p.w->create_joint(DistanceJointDef{.base = p.base(), .length = 0.5f});
    expect_rows(p.w, rod, {{RowKind::joint, [&] { return p.position(rod); }}});
    p.w->destroy_joint(rod);
    const JointId rope = p.w->create_joint(
        DistanceJointDef{.base = p.base(), .spring = spring, .limit = {.enable = true, .lower = 0.1f, .upper = 3}, .motor = motor});
    expect_rows(p.w, rope, all_parts([&] { return p.position(rope); }, 0.1f, 3, 0));
}

TEST(ExportJoints, WeldRows) {
    for (const bool soft_point : {false, true}) {
        for (const bool soft_angle : {false, true}) {
            JointedPair p;
            const JointId j = p.w->create_joint(
                WeldJointDef{.base = p.base(), .linear_hertz = soft_point ? 4.0f : 0.0f, .angular_hertz = soft_angle ? 5.0f : 0.0f});
            const RowKind point = soft_point ? RowKind::spring : RowKind::joint, angle = soft_angle ? RowKind::spring : RowKind::joint;
            expect_rows(p.w, j,
                        {{point,
                          [&] {
                              return p.gap(j, {1, 0});
                          }},
                         {point,
                          [&] {
                              return p.gap(j, {0, 1});
                          }},
                         {angle, [&] { return p.turned(); }}});
            const ExportedIsland island(*p.w, p.a, substep);
            EXPECT_EQ(island->rows[0].softness > 0, soft_point);
            EXPECT_EQ(island->rows[2].softness > 0, soft_angle);
        }
    }
}

TEST(ExportJoints, MotorRows) {
    JointedPair p;
    MotorJointDef def{.base = p.base(), .linear_velocity = {2, 1}, .angular_velocity = 3, .max_force = 20, .max_torque = 4};
    const JointId j = p.w->create_joint(def);
    const Rot frame = make_rot(p.w->angle(p.a) + 0.5f);
    const Vec2 velocity = rotate(frame, {2, 1});
    expect_rows(p.w, j,
                {{RowKind::motor, [&] { return p.turned(); }, -substep * 4, substep * 4, -3},
                 {RowKind::motor,
                  [&] {
                      return p.gap(j, {1, 0});
                  },
                  -substep * 20, substep * 20, -velocity.x},
                 {RowKind::motor,
                  [&] {
                      return p.gap(j, {0, 1});
                  },
                  -substep * 20, substep * 20, -velocity.y}});
}

// Once it gives an impulse the first of its two rows goes along that.
TEST(ExportJoints, ARigidDriveThatGivesAllItHasIsAtTheBoundOfOneRowAlone) {
    JointedPair p;
    p.w->create_joint(MotorJointDef{.base = p.base(), .linear_velocity = {20, 10}, .max_force = 6});
    p.w.step();
    const ExportedIsland island(*p.w, p.a, substep);
    ASSERT_EQ(island->rows.size(), 3u);
    EXPECT_NEAR(island->impulses[1], substep * 6, 1e-5f * substep);
    EXPECT_NEAR(island->impulses[2], 0, 1e-5f * substep);
    EXPECT_NEAR(length(island->rows[1].ends[1].linear), 1, 1e-6f);
    EXPECT_NEAR(dot(island->rows[1].ends[1].linear, island->rows[2].ends[1].linear), 0, 1e-6f);
}

TEST(ExportJoints, MouseRows) {
    JointedPair p;
    const JointId j = p.w->create_joint(MouseJointDef{.body = p.b, .target = {3.2f, 2.9f}, .hertz = 4, .max_force = 30});
    p.w->set_target(j, {4, 3});
    const ExportedIsland island(*p.w, p.b, substep);
    ASSERT_EQ(island->rows.size(), 2u);
    const Vec2 e = island->rows[0].ends[0].linear, f = island->rows[1].ends[0].linear;
    EXPECT_NEAR(length(e), 1, 1e-6f);
    EXPECT_NEAR(dot(e, f), 0, 1e-6f);
    expect_rows(
        p.w, j,
        {{RowKind::motor, [&] { return p.gap(j, e); }, -substep * 30, substep * 30}, {RowKind::motor, [&] { return p.gap(j, f); }, -substep * 30, substep * 30}});
    // The engine's softness is a multiple of K: along these axes K is diagonal, so each row's softness is the same multiple of its own entry.
    const auto entry = [&](std::size_t r, std::size_t s) {
        double sum = 0;
        for (const RowEnd& a : {island->rows[r].ends[0]})
            for (const RowEnd& b : {island->rows[s].ends[0]})
                sum += double(island->bodies[0].inv_mass) * double(dot(a.linear, b.linear)) +
                       double(island->bodies[0].inv_inertia) * double(a.angular * b.angular);
        return sum;
    };
    EXPECT_NEAR(entry(0, 1), 0, 1e-5 * entry(0, 0));
    EXPECT_NEAR(double(island->rows[0].softness) / entry(0, 0), double(island->rows[1].softness) / entry(1, 1),
                1e-5 * double(island->rows[0].softness) / entry(0, 0));
}

TEST(ExportJoints, PulleyRows) {
    JointedPair p;
    const JointId j = p.w->create_joint(PulleyJointDef{.base = p.base(), .ground_a = {0, 5}, .ground_b = {4, 6}, .ratio = 1.5f});
    const auto length_to = [](Vec2 at, Vec2 from) { return std::hypot(double(at.x) - double(from.x), double(at.y) - double(from.y)); };
    expect_rows(p.w, j, {{RowKind::joint, [&] {
                              return -length_to(p.w->anchor_a(j), {0, 5}) - 1.5 * length_to(p.w->anchor_b(j), {4, 6});
                          }}});
}

TEST(ExportJoints, GearRowsOfFourBodiesAndOfThree) {
    JointedPair p;
    const BodyId c = p.add({5, 2}, 0.2f), d = p.add({5, 5}, 0.7f);
    const JointId hinge = p.w->create_joint(RevoluteJointDef{.base = p.base()});
    JointBase base = p.base();
    base.body_a = c;
    base.body_b = d;
    const JointId rail = p.w->create_joint(PrismaticJointDef{.base = base});
    base.body_a = p.b;  // shared with the hinge
    base.body_b = c;
    const JointId other = p.w->create_joint(PrismaticJointDef{.base = base});
    for (const JointId second : {rail, other}) {
        const JointId gear = p.w->create_joint(GearJointDef{.joint1 = hinge, .joint2 = second, .ratio = -0.75f});
        ASSERT_TRUE(gear);
        expect_rows(p.w, gear, {{RowKind::joint, [&] { return p.position(hinge) - 0.75 * p.position(second); }}});
        p.w->destroy_joint(gear);
    }
}

// A spring at rest pulls by stiffness times stretch: where nothing moves, w = 0 means x = -bias / softness. The stiffness is K^-1 (2 pi f)^2, the damping
// K^-1 2 z (2 pi f), K^-1 being the mass that the spring moves.
TEST(ExportJoints, ASpringPullsByItsStiffnessAndBrakesByItsDamping) {
    JointedPair p;
    const JointId j = p.w->create_joint(PrismaticJointDef{.base = p.base(), .spring = spring});
    for (const float step : {substep, substep / 4, 2 * substep}) {
        const ExportedIsland island(*p.w, p.a, step);
        const IslandRow& row = island->rows[0];
        ASSERT_EQ(row.kind, RowKind::spring);
        double k = 0;
        for (std::uint32_t e = 0; e < 2; ++e)
            k += double(island->bodies[row.ends[e].body].inv_mass) +
                 double(island->bodies[row.ends[e].body].inv_inertia) * double(row.ends[e].angular) * double(row.ends[e].angular);
        const double swing = 2 * 3.14159265358979 * 3, stretch = p.position(j) - double(spring.target);
        const double stiffness = swing * swing / k, damping = 2 * 0.4 * swing / k;
        const double impulse = -double(row.bias) / double(row.softness);
        EXPECT_NEAR(impulse, -double(step) * stiffness * stretch, 1e-4 * std::fabs(impulse));
        EXPECT_NEAR(1 / double(row.softness), double(step) * damping, 0.02 * double(step) * damping);
    }
}

// The impulses that solve the problem, given to the bodies, leave the joint's points moving together and its angle still.
TEST(ExportJoints, SolvedImpulsesMakeTheBodiesMoveAsTheJointsAllow) {
    TestWorld w(test::roomy, {.enable_sleep = false});
    const test::Machine m = test::add_machine(*w, {0, 0});
    for (int i = 0; i < 20; ++i) {
        w.step();
        for (const BodyId id : {m.arm, m.slider, m.cart, m.left}) {
            const ExportedIsland island(*w, id, substep);
            const test::WideSolution s = test::solve(island, lcp::Method::newton);
            ASSERT_EQ(s.result.status, lcp::Status::converged) << lcp::describe(s.result.status) << " " << s.result.residuals.natural;
            const std::vector<test::WideVelocity> v = test::velocities_after(*island, s.x);
            TestWorld after(test::roomy);
            std::vector<std::byte> image(w->snapshot_bytes());
            ASSERT_EQ(w->save(image), image.size());
            ASSERT_TRUE(after->restore(image));
            for (std::size_t k = 0; k < v.size(); ++k) {
                after->set_linear_velocity(island->bodies[k].id, {static_cast<float>(v[k].vx), static_cast<float>(v[k].vy)});
                after->set_angular_velocity(island->bodies[k].id, static_cast<float>(v[k].w));
            }
            const auto apart = [&](JointId j) {
                return after->velocity_at(after->body_b(j), after->anchor_b(j)) - after->velocity_at(after->body_a(j), after->anchor_b(j));
            };
            const auto spin = [&](JointId j) {
                return after->angular_velocity(after->body_b(j)) - after->angular_velocity(after->body_a(j));
            };
            const auto sideways = [&](JointId j) {
                const Rot q = make_rot(after->angle(after->body_a(j)) + after->frame_a(j).angle);
                return dot(apart(j), left_perp({q.c, q.s}));
            };
            if (id == m.arm) {
                // The hinge's points are a joint error apart, so the velocity is that of each body's own point.
                const JointId j = m[JointType::revolute];
                EXPECT_LT(length(after->velocity_at(m.arm, after->anchor_b(j)) - after->velocity_at(m.frame, after->anchor_a(j))), 1e-4f);
                EXPECT_NEAR(after->joint_speed(j) + 0.5f * after->joint_speed(m[JointType::prismatic]), 0, 1e-4f) << "the gear";
            }
            if (id == m.slider) {
                EXPECT_NEAR(sideways(m[JointType::prismatic]), 0, 1e-4f);
                EXPECT_NEAR(spin(m[JointType::prismatic]), 0, 1e-4f);
            }
            if (id == m.cart) { EXPECT_NEAR(sideways(m[JointType::wheel]), 0, 1e-4f); }
            if (id == m.left) {
                const JointId j = m[JointType::pulley];
                const Vec2 ua = normalize(after->anchor_a(j) - after->ground_a(j)), ub = normalize(after->anchor_b(j) - after->ground_b(j));
                const float rope = dot(ua, after->velocity_at(m.left, after->anchor_a(j))) +
                                   1.5f * dot(ub, after->velocity_at(m.right, after->anchor_b(j)));
                EXPECT_NEAR(rope, 0, 1e-4f);
            }
        }
    }
}

// What the engine stored is scaled to the substep asked for, row by row: the sums over a joint are what it tells its readers.
TEST(ExportJoints, ImpulsesAreThoseTheEngineLeft) {
    TestWorld w(test::roomy, {.enable_sleep = false});
    const test::Machine m = test::add_machine(*w, {0, 0});
    w.step(30);
    for (const float step : {substep, 3 * substep}) {
        const ExportedIsland island(*w, m.arm, step);
        Vec2 force;
        float torque = 0, motor_impulse = 0;
        for (std::size_t i = 0; i < island->rows.size(); ++i) {
            const IslandRow& r = island->rows[i];
            if (r.slot != m[JointType::revolute].index1 - 1) continue;
            const RowEnd& end = r.ends[r.end_count - 1];  // the arm's
            force += island->impulses[i] * end.linear;
            if (r.kind != RowKind::joint) torque += island->impulses[i] * end.angular;
            if (r.kind == RowKind::motor) motor_impulse = island->impulses[i];
        }
        const Vec2 told = w->joint_force(m[JointType::revolute]);
        EXPECT_NEAR(force.x / step, told.x, 1e-4f * length(told));
        EXPECT_NEAR(force.y / step, told.y, 1e-4f * length(told));
        EXPECT_NEAR(torque / step, w->joint_torque(m[JointType::revolute]), 1e-4f * (1 + std::fabs(torque / step)));
        EXPECT_NEAR(motor_impulse / step, w->motor_force(m[JointType::revolute]), 1e-4f * std::fabs(motor_impulse / step));
        EXPECT_NE(motor_impulse, 0);
    }
}

TEST(ExportJoints, RowsThatPushNothingAreLeftOut) {
    TestWorld w;
    const BodyId wall = w->create_body({});
    const BodyId box = w.add(make_box(0.5f, 0.5f), {.type = BodyType::dynamic, .position = {1, 0}, .fixed_rotation = true});
    test::join(*w, JointType::weld, wall, box);
    const ExportedIsland island(*w, box, substep);
    ASSERT_EQ(island->rows.size(), 2u) << "neither end can turn";
    for (const IslandRow& r : island->rows) EXPECT_EQ(r.ends[0].body, no_body);

    const BodyId bob = w.add_box({5, 5}), hook = w->create_body({.position = {5, 5}});
    w->create_joint(DistanceJointDef{.base = {.body_a = hook, .body_b = bob}, .length = 1});
    EXPECT_EQ(ExportedIsland(*w, bob, substep)->rows.size(), 0u) << "points that coincide have no direction";
}

TEST(ExportJoints, AKinematicEndDrives) {
    TestWorld w(test::roomy, {.gravity = {0, 0}});
    const BodyId crank = w->create_body({.type = BodyType::kinematic, .linear_velocity = {1, 2}, .angular_velocity = 3});
    const BodyId box = w.add_box({2, 0});
    RevoluteJointDef hinge{.base = test::base_at_b(*w, crank, box)};
    hinge.limit = {.enable = true, .lower = -1, .upper = 0.5f};
    w->create_joint(hinge);
    const ExportedIsland island(*w, box, substep);
    ASSERT_EQ(island->rows.size(), 4u);
    EXPECT_EQ(island->bodies.size(), 1u);
    // From the crank the box turns back at 3 rad/s: towards the lower limit, away from the upper one.
    EXPECT_NEAR(island->lcp.q[0], -3 + 1 / substep, 1e-4f);
    EXPECT_NEAR(island->lcp.q[1], 3 + 0.5f / substep, 1e-4f);
    // Its point at (2, 0) moves at (1, 2 + 3 * 2), the box does not.
    EXPECT_NEAR(island->lcp.q[2], -1, 1e-5f);
    EXPECT_NEAR(island->lcp.q[3], -8, 1e-5f);
}

}  // namespace
