// What World::export_island hands out: who is in an island, what its rows and its matrix are made of, and what a call may and may not do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <vector>

#include "island/batches.hpp"
#include "support/busy_world.hpp"
#include "support/island.hpp"
#include "support/random.hpp"
#include "support/test_world.hpp"

namespace {

using namespace islet;
using islet::test::ExportedIsland;
using islet::test::Random;
using islet::test::substep;
using islet::test::TestWorld;
using islet::test::WideProblem;

constexpr double eps = 1.0 / (1 << 24);

// A heap of boxes and balls, some of them on a turning paddle, and three chains of hinged links through it.
void add_heap(TestWorld& w, Random& random, int count) {
    w.add_ground(0, 20);
    const BodyId paddle = w.add_box({0, 1}, 2, 0.1f, {}, BodyType::kinematic);
    w->set_angular_velocity(paddle, 0.5f);
    BodyId before;
    for (int i = 0; i < count; ++i) {
        const Vec2 at = {random.between(-8, 8), random.between(1, 8)};
        const BodyId body =
            random.one_in(2) ? w.add_box(at, 0.4f, random.between(0.1f, 0.5f)) : w.add_circle(at, random.between(0.2f, 0.5f));
        if (before && random.one_in(6)) w->create_joint(RevoluteJointDef{.base = test::base_at_b(*w, before, body)});
        before = body;
    }
}

std::set<std::uint32_t> members_of(const IslandProblem& p) {
    std::set<std::uint32_t> slots;
    for (const IslandBody& b : p.bodies) slots.insert(b.id.index1 - 1);
    return slots;
}

// -- who is in it -----------------------------------------------------------------------------------------------------------------------------------

TEST(ExportIsland, HoldsTheBodiesThatTheSolverPlansAsOneIsland) {
    Random random(3);
    for (int round = 0; round < 6; ++round) {
        TestWorld w(test::roomy, {.enable_sleep = false});
        add_heap(w, random, 60);
        w.step(30 * (round + 1));
        detail::Core& core = detail::Core::of(*w);
        detail::Arena arena = core.arena();
        const detail::Plan plan = detail::make_plan(core, arena);
        std::vector<std::set<std::uint32_t>> planned(plan.island_count);
        for (std::uint32_t slot = 1; slot < plan.slot_count; ++slot)
            if (plan.island_of[slot] != detail::null_index) planned[plan.island_of[slot]].insert(plan.body_of[slot]);
        ASSERT_GT(planned.size(), 1u);
        for (const std::set<std::uint32_t>& island : planned)
            for (const std::uint32_t body : island) ASSERT_EQ(members_of(*ExportedIsland(*w, w->body_at(body), substep)), island);
    }
}

TEST(ExportIsland, AGearLinksAllBodiesThatItsRowReads) {
    TestWorld w;
    const BodyId wall = w->create_body({});
    const BodyId base = w.add_box({0, 5}), left = w.add_box({-3, 5}), right = w.add_box({3, 5}), alone = w.add_box({9, 5});
    const JointId a = test::join(*w, JointType::revolute, base, left);
    const JointId b = test::join(*w, JointType::prismatic, wall, right);
    ASSERT_TRUE(w->create_joint(GearJointDef{.joint1 = a, .joint2 = b, .ratio = -2}));
    const ExportedIsland island(*w, right, substep);
    EXPECT_EQ(members_of(*island), (std::set<std::uint32_t>{base.index1 - 1, left.index1 - 1, right.index1 - 1}));
    EXPECT_EQ(ExportedIsland(*w, alone, substep)->bodies.size(), 1u);
}

TEST(ExportIsland, IsTheSameWhicheverOfItsBodiesIsNamed) {
    Random random(5);
    TestWorld w;
    add_heap(w, random, 40);
    w.step(60);
    for (const BodyId id : w.bodies()) {
        if (w->type(id) != BodyType::dynamic) continue;
        const ExportedIsland island(*w, id, substep);
        const ExportedIsland again(*w, island->bodies.front().id, substep);
        ASSERT_EQ(island.bytes(), again.bytes());
        ASSERT_TRUE(std::ranges::equal(island->lcp.q, again->lcp.q));
        ASSERT_TRUE(std::ranges::equal(island->lcp.sparse.values, again->lcp.sparse.values));
        ASSERT_TRUE(std::ranges::equal(island->impulses, again->impulses));
        ASSERT_TRUE(std::ranges::equal(island->bodies, again->bodies, {}, &IslandBody::id, &IslandBody::id));
        ASSERT_TRUE(std::ranges::is_sorted(island->bodies, {}, [](const IslandBody& b) { return b.id.index1; }));
    }
}

TEST(ExportIsland, TwoIslandsHoldEachBodyOnce) {
    TestWorld w;
    w.add_ground();
    for (int i = 0; i < 3; ++i) w.add_box({-5, 0.5f + static_cast<float>(i)});
    for (int i = 0; i < 4; ++i) w.add_box({5, 0.5f + static_cast<float>(i)});
    w.step(30);
    const ExportedIsland left(*w, w->body_at(2), substep), right(*w, w->body_at(5), substep);
    EXPECT_EQ(left->bodies.size(), 3u);
    EXPECT_EQ(right->bodies.size(), 4u);
    std::set<std::uint32_t> both = members_of(*left);
    both.merge(members_of(*right));
    EXPECT_EQ(both.size(), 7u) << "the ground is in neither, and links nothing";
    EXPECT_EQ(left->rows.size(), 3u * 4) << "two points a contact, a normal and a friction each";
    EXPECT_EQ(right->rows.size(), 4u * 4);
}

TEST(ExportIsland, ABodyAloneInTheAirHasNoRows) {
    TestWorld w;
    const BodyId ball = w.add_circle({0, 9});
    const ExportedIsland island(*w, ball, substep);
    EXPECT_GT(island.bytes(), 0u);
    ASSERT_EQ(island->bodies.size(), 1u);
    EXPECT_EQ(island->rows.size(), 0u);
    ASSERT_EQ(island->lcp.sparse.row_starts.size(), 1u);
    EXPECT_EQ(island->lcp.sparse.row_starts[0], 0u);
    EXPECT_FLOAT_EQ(island->bodies[0].v_free.y, -10 * substep);
}

TEST(ExportIsland, SleepersHaveOneToo) {
    TestWorld w;
    w.add_ground();
    const BodyId lower = w.add_box({0, 0.5f}), upper = w.add_box({0, 1.5f});
    w.step(200);
    ASSERT_FALSE(w->is_awake(lower));
    const ExportedIsland island(*w, upper, substep);
    EXPECT_EQ(island->bodies.size(), 2u);
    EXPECT_EQ(island->rows.size(), 8u);
    EXPECT_FALSE(w->is_awake(lower)) << "looking does not wake";
}

TEST(ExportIsland, FitsTheScratchOfTheSmallestWorld) {
    for (const Capacity& tiny :
         {Capacity{.bodies = 1, .shapes = 1, .contacts = 1}, Capacity{.bodies = 2, .shapes = 2, .contacts = 1, .joints = 9}}) {
        TestWorld w(tiny);
        const BodyId body = w.add_box({0, 0.5f});
        const BodyId other = w.add_box({0, 1.5f});
        while (other && test::join(*w, JointType::prismatic, body, other, true)) {}
        w.step(5);
        EXPECT_GT(ExportedIsland(*w, body, substep).bytes(), 0u);
    }
}

// -- its numbers ------------------------------------------------------------------------------------------------------------------------------------

// A tolerance for a sum of products: rounding of each term.
void expect_matrix_and_q_follow_from_the_rows(const IslandProblem& p) {
    const WideProblem wide(p);
    const auto& [starts, columns, values] = p.lcp.sparse;
    ASSERT_EQ(starts.size(), wide.n + 1);
    ASSERT_EQ(columns.size(), values.size());
    ASSERT_EQ(starts.back(), values.size());
    std::vector<double> dense(wide.n * wide.n);
    for (std::size_t i = 0; i < wide.n; ++i) {
        for (std::uint32_t k = starts[i]; k < starts[i + 1]; ++k) {
            if (k > starts[i]) { ASSERT_LT(columns[k - 1], columns[k]) << "row " << i; }
            ASSERT_LT(columns[k], wide.n);
            dense[i * wide.n + columns[k]] = double(values[k]);
        }
    }
    for (std::size_t i = 0; i < wide.n; ++i) {
        const IslandRow& row = p.rows[i];
        double speed = std::fabs(double(row.bias));
        for (std::uint32_t k = 0; k < row.end_count; ++k) {
            if (row.ends[k].body == no_body) continue;
            const IslandBody& b = p.bodies[row.ends[k].body];
            speed += std::fabs(double(row.ends[k].linear.x) * double(b.v_free.x)) +
                     std::fabs(double(row.ends[k].linear.y) * double(b.v_free.y)) +
                     std::fabs(double(row.ends[k].angular) * double(b.w_free));
        }
        ASSERT_NEAR(double(p.lcp.q[i]), wide.q[i], 16 * eps * speed) << "q of row " << i;
        for (std::size_t k = 0; k < wide.n; ++k) {
            const double bound = 32 * eps * std::sqrt(wide.m[i * wide.n + i] * wide.m[k * wide.n + k]);
            ASSERT_NEAR(dense[i * wide.n + k], wide.m[i * wide.n + k], bound) << "M of rows " << i << " and " << k;
            ASSERT_EQ(dense[i * wide.n + k], dense[k * wide.n + i]) << "not symmetric to the last bit: " << i << " and " << k;
        }
    }
}

TEST(ExportIsland, MatrixAndVectorFollowFromRowsAndBodies) {
    Random random(11);
    TestWorld w(test::roomy, {.enable_sleep = false});
    add_heap(w, random, 50);
    test::add_machine(*w, {30, 0});
    w.step(90);
    std::set<std::uint32_t> seen;
    for (const BodyId id : w.bodies()) {
        if (w->type(id) != BodyType::dynamic || seen.count(id.index1 - 1) != 0) continue;
        const ExportedIsland island(*w, id, substep);
        seen.merge(members_of(*island));
        ASSERT_EQ(test::fault_in(*island), nullptr);
        ASSERT_NO_FATAL_FAILURE(expect_matrix_and_q_follow_from_the_rows(*island));
    }
}

// A gear's row has entries for bodies that the gear does not hang on, and may have one body twice.
TEST(ExportIsland, GearsAreCoupledThroughAllTheirBodies) {
    TestWorld w;
    BodyId b[5];
    for (int i = 0; i < 5; ++i)
        b[i] = w.add_box({1.5f * static_cast<float>(i), 0.3f * static_cast<float>(i)}, 0.5f + 0.07f * static_cast<float>(i), 0.3f);
    const JointId first = test::join(*w, JointType::prismatic, b[0], b[1]);
    const JointId second = test::join(*w, JointType::prismatic, b[2], b[3]);
    const JointId shared = test::join(*w, JointType::revolute, b[1], b[4]);
    test::join(*w, JointType::weld, b[3], b[4]);
    const BodyId wall = w->create_body({});
    for (const int held : {0, 2}) test::join(*w, JointType::motor, wall, b[held]);
    for (const float ratio : {0.7f, 0.31f, -2.9f}) {
        ASSERT_TRUE(w->create_joint(GearJointDef{.joint1 = first, .joint2 = second, .ratio = ratio}));
        ASSERT_TRUE(w->create_joint(GearJointDef{.joint1 = second, .joint2 = first, .ratio = 1.3f * ratio}));
    }
    ASSERT_TRUE(w->create_joint(GearJointDef{.joint1 = first, .joint2 = shared, .ratio = 0.1f}));
    for (int i = 0; i < 5; ++i)
        w->set_transform(b[i], w->position(b[i]) + Vec2{0.01f, 0.02f * static_cast<float>(i)}, 0.1f * static_cast<float>(i));
    const ExportedIsland island(*w, b[0], substep);
    ASSERT_EQ(island->bodies.size(), 5u);
    ASSERT_EQ(test::fault_in(*island), nullptr);
    expect_matrix_and_q_follow_from_the_rows(*island);
}

// x^T M x is twice the kinetic energy that the impulses x bring, so it cannot be negative; and it is 0 only where x cancels itself.
TEST(ExportIsland, TheMatrixIsPositiveSemiDefinite) {
    Random random(12);
    TestWorld w(test::busy_capacity);
    test::fill_busy(*w);
    for (const BodyId id : w.bodies()) {
        if (w->type(id) != BodyType::dynamic) continue;
        const ExportedIsland island(*w, id, substep);
        const std::size_t n = island->rows.size();
        const auto& [starts, columns, values] = island->lcp.sparse;
        for (std::size_t i = 0; i < n; ++i) {
            const auto diagonal = std::find(columns.begin() + starts[i], columns.begin() + starts[i + 1], i) - columns.begin();
            ASSERT_GT(values[static_cast<std::size_t>(diagonal)], 0) << "row " << i << " pushes nothing";
        }
        for (int trial = 0; trial < 50; ++trial) {
            std::vector<double> x(n);
            for (double& a : x) a = double(random.between(-1, 1));
            double energy = 0, terms = 0;
            for (std::size_t i = 0; i < n; ++i) {
                for (std::uint32_t k = starts[i]; k < starts[i + 1]; ++k) {
                    energy += x[i] * double(values[k]) * x[columns[k]];
                    terms += std::fabs(x[i] * double(values[k]) * x[columns[k]]);
                }
            }
            ASSERT_GE(energy, -4 * eps * terms);
        }
    }
}

TEST(ExportIsland, RowsOfOneContactOrJointStandTogether) {
    TestWorld w(test::busy_capacity);
    test::fill_busy(*w);
    for (const BodyId id : w.bodies()) {
        if (w->type(id) != BodyType::dynamic) continue;
        const ExportedIsland island(*w, id, substep);
        std::pair<int, std::uint32_t> last = {-1, 0};
        for (const IslandRow& r : island->rows) {
            const bool contact = r.kind == RowKind::normal || r.kind == RowKind::friction || r.kind == RowKind::rolling;
            const std::pair<int, std::uint32_t> here = {contact ? 1 : 0, r.slot};
            ASSERT_LE(last, here) << "joints by slot, then contacts by slot";
            last = here;
            ContactInfo info;
            if (contact) {
                ASSERT_TRUE(w->contact_at(r.slot, info));
                ASSERT_LT(r.index, info.point_count);
            } else {
                ASSERT_TRUE(w->joint_at(r.slot));
            }
        }
    }
}

// -- rows of contacts ----------------------------------------------------------------------------------------------------------------------------------

TEST(ExportIsland, ContactRowsAreWhatTheContactSays) {
    TestWorld w;
    w.add_ground(0, 100, {.friction = 0.9f});
    const BodyId box = w.add_box({0, 0.5f}, 0.5f, 0.5f, {.friction = 0.4f});
    w->set_linear_velocity(box, {0.25f, 0});
    w.step(3);
    const ExportedIsland island(*w, box, substep);
    ASSERT_EQ(island->rows.size(), 4u);
    ContactInfo info;
    const std::uint32_t slot = island->rows[0].slot;
    ASSERT_TRUE(w->contact_at(slot, info));
    const bool box_is_b = w->body(info.shape_b) == box;
    const Vec2 v = w->linear_velocity(box), c = w->center_of_mass(box);
    for (std::uint32_t i = 0; i < 2; ++i) {
        const IslandRow& normal = island->rows[i];
        const IslandRow& friction = island->rows[2 + i];
        EXPECT_EQ(normal.kind, RowKind::normal);
        EXPECT_EQ(friction.kind, RowKind::friction);
        EXPECT_EQ(friction.slot, slot);
        EXPECT_EQ(friction.index, i);
        EXPECT_EQ(island->lcp.friction[i], lcp::no_row);
        EXPECT_EQ(island->lcp.friction[2 + i], i) << "bounded by its own normal row";
        EXPECT_FLOAT_EQ(island->lcp.hi[2 + i], 0.6f) << "sqrt(0.9 * 0.4)";
        EXPECT_EQ(island->lcp.lo[i], 0);
        EXPECT_TRUE(std::isinf(island->lcp.hi[i]));
        // q is the speed of B's material from A's at the point, gravity included: along n, and along n turned by -90 degrees.
        const Vec2 arm = info.points[i].point - c;
        const Vec2 free = v + Vec2{0, -10 * substep} + cross(w->angular_velocity(box), arm);
        const Vec2 apart = box_is_b ? free : -free;
        EXPECT_NEAR(island->lcp.q[i], dot(info.normal, apart) + std::max(info.points[i].separation, 0.0f) / substep, 1e-4f);
        EXPECT_NEAR(island->lcp.q[2 + i], dot(right_perp(info.normal), apart), 1e-4f);
        ASSERT_EQ(normal.end_count, 2u);
        const RowEnd& end = normal.ends[box_is_b ? 1 : 0];
        EXPECT_EQ(end.body, 0u);
        EXPECT_EQ(normal.ends[box_is_b ? 0 : 1].body, no_body);
        EXPECT_NEAR(end.angular, cross(arm, end.linear), 1e-2f) << "the arm is that of the moment the manifold was made";
    }
}

TEST(ExportIsland, AGapAddsTheSpeedThatClosesItWithinTheSubstep) {
    TestWorld w(test::roomy, {.gravity = {0, 0}});
    w.add_ground();
    const BodyId box = w.add_box({0, 0.5f});
    w.step();
    ASSERT_EQ(ExportedIsland(*w, box, substep)->rows.size(), 4u);
    const ExportedIsland before(*w, box, substep);
    w->set_linear_velocity(box, {0, 0.06f});
    w.step();  // 1 mm up; the manifold is kept
    w->set_linear_velocity(box, {0, 0});
    ASSERT_EQ(w.contacts().size(), 1u);
    const float gap = w.contacts()[0].points[0].separation;
    ASSERT_GT(gap, 0.5e-3f);
    for (const float step : {substep, 2 * substep, 1.0f}) EXPECT_NEAR(ExportedIsland(*w, box, step)->lcp.q[0], gap / step, 1e-4f * gap / step);
}

TEST(ExportIsland, MovingSurfacesAndKinematicBodiesGoIntoQ) {
    TestWorld w(test::roomy, {.enable_sleep = false});
    const BodyId lift = w.add_box({0, -1}, 10, 1, {.tangent_speed = 2}, BodyType::kinematic);
    w->set_linear_velocity(lift, {0.5f, 0.25f});
    const BodyId box = w.add_box({0, 0.5f}, 0.5f, 0.5f, {.tangent_speed = 0.5f});
    w.step();
    w->set_linear_velocity(box, {0, 0});
    w->set_angular_velocity(box, 0);
    const ExportedIsland island(*w, box, substep);
    ASSERT_EQ(island->rows.size(), 4u) << "no rolling resistance, no row for it";
    const ContactInfo info = w.contacts().at(0);
    const float sign = w->body(info.shape_b) == box ? 1.0f : -1.0f;
    const float gap = std::max(info.points[0].separation, 0.0f) / substep;
    // From the lift the box moves at (-0.5, -0.25 - 10 substep); the two surfaces carry by 2.5 m/s.
    EXPECT_NEAR(island->rows[0].bias, sign * dot(info.normal, {-0.5f, -0.25f}) + gap, 1e-4f);
    EXPECT_NEAR(island->lcp.q[0], sign * dot(info.normal, {-0.5f, -0.25f - 10 * substep}) + gap, 1e-4f);
    EXPECT_NEAR(island->lcp.q[2], sign * dot(right_perp(info.normal), {-0.5f, -0.25f}) - 2.5f, 1e-4f);
}

TEST(ExportIsland, RollingResistanceIsBoundByTheImpulsesThereAre) {
    TestWorld w(test::roomy, {.enable_sleep = false});
    w.add_ground();
    const BodyId ball = w.add_circle({0, 0.5f}, 0.5f, {.rolling_resistance = 0.1f});
    w.step(30);
    const ExportedIsland island(*w, ball, 2 * substep);
    ASSERT_EQ(island->rows.size(), 3u);
    EXPECT_EQ(island->rows[2].kind, RowKind::rolling);
    EXPECT_FLOAT_EQ(island->lcp.hi[2], 0.1f * 0.5f * island->impulses[0]);
    EXPECT_EQ(island->lcp.lo[2], -island->lcp.hi[2]);
    EXPECT_NEAR(island->impulses[0], w->mass(ball) * 10 * 2 * substep, 1e-3f * island->impulses[0]) << "scaled to the substep asked for";
}

// -- what the bodies do by themselves ---------------------------------------------------------------------------------------------------------------------

TEST(ExportIsland, FreeVelocitiesHaveGravityForcesDampingAndTheSpeedLimit) {
    TestWorld w(test::roomy, {.gravity = {1, -10}, .max_speed = 50});
    const BodyId box = w.add(
        make_box(0.5f, 1),
        {.type = BodyType::dynamic, .position = {0, 9}, .linear_damping = 2, .angular_damping = 3, .gravity_scale = 0.5f}, {.density = 2});
    w->set_linear_velocity(box, {3, 4});
    w->set_angular_velocity(box, 5);
    w->apply_force_to_center(box, {8, 0});
    w->apply_torque(box, 6);
    const ExportedIsland island(*w, box, substep);
    const IslandBody& b = island->bodies[0];
    EXPECT_EQ(b.id, box);
    EXPECT_FLOAT_EQ(b.inv_mass, 1.0f / 4) << "2 m^2 at 2 kg/m^2";
    EXPECT_FLOAT_EQ(b.inv_inertia, 12.0f / (4 * (1 + 4)));
    EXPECT_NEAR(b.v_free.x, (3 + substep * (0.5f + 8.0f / 4)) / (1 + 2 * substep), 1e-5f);
    EXPECT_NEAR(b.v_free.y, (4 - substep * 5) / (1 + 2 * substep), 1e-5f);
    EXPECT_NEAR(b.w_free, (5 + substep * 6 * b.inv_inertia) / (1 + 3 * substep), 1e-5f);
    w->set_linear_velocity(box, {300, 400});
    EXPECT_NEAR(length(ExportedIsland(*w, box, substep)->bodies[0].v_free), 50, 1e-4f);
}

TEST(ExportIsland, ABodyThatWouldSwingWithinASubstepHasTheInertiaTheSolverGivesIt) {
    TestWorld w(test::roomy, {.enable_sleep = false});
    const BodyId wall = w->create_body({});
    const BodyId link = w.add(make_box(0.5f, 0.05f), {.type = BodyType::dynamic, .position = {0, 0}, .angle = -0.5f * pi});
    const BodyId weight = w.add_box({0, -2}, 1, 1, {.density = 1000});
    const JointId above =
        w->create_joint(RevoluteJointDef{.base = {.body_a = wall, .body_b = link, .frame_a = {{0, 0.5f}}, .frame_b = {{-0.5f, 0}}}});
    const JointId below =
        w->create_joint(RevoluteJointDef{.base = {.body_a = link, .body_b = weight, .frame_a = {{0.5f, 0}}, .frame_b = {{0, 1.5f}}}});
    w.step(120, 1.0f / 60);
    // Pulled up at one end and down at the other, half a metre from its centre each: substep^2 times that is more than its own inertia.
    const float own = w->rotational_inertia(link), stretch = substep * substep * 0.5f * (w->joint_force(above).y + w->joint_force(below).y);
    ASSERT_GT(stretch, 1.5f * own);
    const ExportedIsland island(*w, link, substep);
    EXPECT_NEAR(1 / island->bodies[island.place_of(link)].inv_inertia, stretch, 0.02f * stretch);
}

// -- what a call may do -------------------------------------------------------------------------------------------------------------------------------------

TEST(ExportIsland, ChangesNothing) {
    TestWorld w(test::busy_capacity);
    test::fill_busy(*w);
    std::vector<std::byte> before(max_snapshot_bytes(w->capacity())), after(before.size());
    const std::uint64_t hash = w->hash();
    const std::size_t bytes = w->save(before);
    for (const BodyId id : w.bodies()) {
        if (w->type(id) == BodyType::dynamic) { ASSERT_GT(ExportedIsland(*w, id, substep).bytes(), 0u); }
    }
    EXPECT_EQ(w->hash(), hash);
    ASSERT_EQ(w->save(after), bytes);
    EXPECT_EQ(std::memcmp(before.data(), after.data(), bytes), 0);
    EXPECT_EQ(w->validate(), nullptr);
    TestWorld other(test::busy_capacity);
    ASSERT_TRUE(other->restore({before.data(), bytes}));
    w.step(20);
    other.step(20);
    EXPECT_EQ(w->hash(), other->hash()) << "the next steps are those of a world that was never looked at";
}

TEST(ExportIsland, WritesNothingIntoTooLittleMemory) {
    TestWorld w;
    w.add_ground();
    const BodyId box = w.add_box({0, 0.5f});
    w.step(10);
    IslandProblem out;
    out.impulses = {static_cast<float*>(nullptr), 0};
    const std::size_t bytes = w->export_island(box, substep, {}, out);
    ASSERT_GT(bytes, 0u);
    std::vector<std::byte> memory(bytes + 16, std::byte{0x5a});
    EXPECT_EQ(w->export_island(box, substep, {memory.data(), bytes - 1}, out), bytes);
    EXPECT_EQ(std::count(memory.begin(), memory.end(), std::byte{0x5a}), static_cast<std::ptrdiff_t>(memory.size()));
    EXPECT_TRUE(out.rows.empty() && out.bodies.empty() && out.lcp.q.empty());
    EXPECT_TRUE(w.errors.empty()) << "asking how much is no error";

    EXPECT_EQ(w->export_island(box, substep, {memory.data(), bytes}, out), bytes);
    EXPECT_EQ(out.rows.size(), 4u);
    EXPECT_TRUE(
        std::all_of(memory.begin() + static_cast<std::ptrdiff_t>(bytes), memory.end(), [](std::byte b) { return b == std::byte{0x5a}; }));
}

TEST(ExportIsland, MemoryNeedsNoAlignment) {
    TestWorld w;
    w.add_ground();
    const BodyId box = w.add_box({0, 0.5f});
    w.step(10);
    const ExportedIsland aligned(*w, box, substep);
    for (std::size_t shift = 0; shift < 8; ++shift) {
        std::vector<std::byte> memory(aligned.bytes() + 8, std::byte{0x5a});
        IslandProblem out;
        ASSERT_EQ(w->export_island(box, substep, std::span(memory).subspan(shift, aligned.bytes()), out), aligned.bytes());
        EXPECT_TRUE(std::ranges::equal(out.lcp.q, aligned->lcp.q));
        EXPECT_TRUE(std::ranges::equal(out.lcp.sparse.values, aligned->lcp.sparse.values));
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(out.rows.data()) % alignof(IslandRow), 0u);
        for (std::size_t i = 0; i < shift; ++i) EXPECT_EQ(memory[i], std::byte{0x5a});
        for (std::size_t i = shift + aligned.bytes(); i < memory.size(); ++i) EXPECT_EQ(memory[i], std::byte{0x5a});
    }
}

TEST(ExportIsland, RefusesWhatHasNone) {
    TestWorld w;
    const BodyId ground = w.add_ground();
    const BodyId lift = w.add_box({5, 5}, 1, 1, {}, BodyType::kinematic);
    const BodyId box = w.add_box({0, 0.5f}), gone = w.add_box({0, 9});
    w->destroy_body(gone);
    w.step(5);
    std::vector<std::byte> memory(1 << 16);
    const auto refused = [&](BodyId body, float step) {
        IslandProblem out;
        w.errors.clear();
        EXPECT_EQ(w->export_island(body, step, memory, out), 0u);
        EXPECT_TRUE(out.rows.empty() && out.bodies.empty());
        return w.errors.size() == 1 ? w.errors[0] : Error::none;
    };
    const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(refused({}, substep), Error::null_id);
    EXPECT_EQ(refused(gone, substep), Error::stale_id);
    EXPECT_EQ(refused(ground, substep), Error::no_dynamic_body);
    EXPECT_EQ(refused(lift, substep), Error::no_dynamic_body);
    for (const float bad : {0.0f, 1.0e-8f, -substep, 1.5f, inf, nan}) EXPECT_EQ(refused(box, bad), Error::bad_time_step) << bad;
    IslandProblem out;
    EXPECT_GT(w->export_island(box, 1, memory, out), 0u);
}

}  // namespace
