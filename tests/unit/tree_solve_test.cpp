// Trees of hinges: the elimination against a dense solve, which hinges are chosen, and in what order they come.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/tree_solve.hpp"
#include "support/random.hpp"
#include "support/test_world.hpp"

namespace {

using namespace islet;
using namespace islet::detail;
using namespace islet::test;

using Real = double;

struct HingeTree {
    std::vector<SolverBody> bodies;  // slot 0 is static
    std::vector<TreeLink> links;     // leaves first; link k is of body k + 1
};

// A random tree: each body hangs on one that comes later, the last one on the static body, if it is not a root. Masses span `spread` decades.
HingeTree random_tree(Random& random, std::uint32_t size, float spread) {
    HingeTree tree;
    tree.bodies.resize(size + 1);
    tree.links.resize(size);
    const auto vec = [&](float most) { return Vec2{random.between(-most, most), random.between(-most, most)}; };
    for (std::uint32_t k = 0; k < size; ++k) {
        SolverBody& b = tree.bodies[k + 1];
        const float mass = std::pow(10.0f, random.between(-0.5f * spread, 0.5f * spread));
        b.inv_mass = 1 / mass;
        b.inv_inertia = random.one_in(6) ? 0 : 1 / (mass * random.between(0.05f, 0.5f));
        b.v = vec(5);
        b.w = random.between(-5, 5);
        TreeLink& l = tree.links[k];
        l.child = k + 1;
        const bool last = k + 1 == size;
        if (last && random.one_in(2)) continue;  // a root that nothing holds
        l.joint = k;
        l.sign = random.one_in(2) ? 1.0f : -1.0f;
        l.rc = vec(1);
        l.rp = vec(1);
        l.parent = last ? 0 : k + 2 + random.below(size - k - 1);
        if (l.parent != 0) l.up = l.parent - 1;
    }
    return tree;
}

// Velocities after impulses at the hinges alone have made every hinge's two points equally fast, by Gaussian elimination of J M^-1 J^T.
std::vector<Real> dense_solution(const HingeTree& tree) {
    std::vector<const TreeLink*> hinges;
    for (const TreeLink& l : tree.links)
        if (l.joint != null_index) hinges.push_back(&l);
    const std::size_t rows = 2 * hinges.size(), columns = 3 * tree.bodies.size();
    std::vector<std::vector<Real>> j(rows, std::vector<Real>(columns, 0));
    for (std::size_t k = 0; k < hinges.size(); ++k) {
        const TreeLink& l = *hinges[k];
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const auto arm = [&](Vec2 r) { return axis == 0 ? -Real(r.y) : Real(r.x); };
            j[2 * k + axis][3 * l.child + axis] = 1;
            j[2 * k + axis][3 * l.child + 2] = arm(l.rc);
            j[2 * k + axis][3 * l.parent + axis] = -1;
            j[2 * k + axis][3 * l.parent + 2] = -arm(l.rp);
        }
    }
    std::vector<Real> v(columns), inv(columns);
    for (std::size_t b = 0; b < tree.bodies.size(); ++b) {
        const SolverBody& body = tree.bodies[b];
        const Real velocity[] = {Real(body.v.x), Real(body.v.y), Real(body.w)}, inverse[] = {Real(body.inv_mass), Real(body.inv_mass), Real(body.inv_inertia)};
        std::copy_n(velocity, 3, v.begin() + static_cast<std::ptrdiff_t>(3 * b));
        std::copy_n(inverse, 3, inv.begin() + static_cast<std::ptrdiff_t>(3 * b));
    }
    std::vector<std::vector<Real>> a(rows, std::vector<Real>(rows + 1, 0));
    for (std::size_t r = 0; r < rows; ++r) {
        for (std::size_t c = 0; c < columns; ++c) {
            a[r][rows] -= j[r][c] * v[c];
            for (std::size_t s = 0; s < rows; ++s) a[r][s] += j[r][c] * inv[c] * j[s][c];
        }
    }
    for (std::size_t p = 0; p < rows; ++p) {
        std::size_t best = p;
        for (std::size_t r = p; r < rows; ++r)
            if (std::abs(a[r][p]) > std::abs(a[best][p])) best = r;
        std::swap(a[p], a[best]);
        for (std::size_t r = 0; r < rows; ++r) {
            if (r == p) continue;
            const Real factor = a[r][p] / a[p][p];
            for (std::size_t s = p; s <= rows; ++s) a[r][s] -= factor * a[p][s];
        }
    }
    for (std::size_t r = 0; r < rows; ++r)
        for (std::size_t c = 0; c < columns; ++c) v[c] += inv[c] * j[r][c] * a[r][rows] / a[r][r];
    return v;
}

void expect_dense_solution(float spread, Real tolerance) {
    Random random(7);
    for (int trial = 0; trial < 300; ++trial) {
        SCOPED_TRACE(trial);
        HingeTree tree = random_tree(random, 1 + random.below(12), spread);
        const std::vector<Real> expected = dense_solution(tree);
        JointSweep relax;
        relax.h = 1.0f / 240;
        relax.inv_h = 240;
        solve_trees(tree.bodies.data(), tree.links.data(), static_cast<std::uint32_t>(tree.links.size()), nullptr, relax);
        Real scale = 1;
        for (const Real x : expected) scale = std::max(scale, std::abs(x));
        for (std::size_t b = 0; b < tree.bodies.size(); ++b) {
            EXPECT_NEAR(Real(tree.bodies[b].v.x) / scale, expected[3 * b] / scale, tolerance);
            EXPECT_NEAR(Real(tree.bodies[b].v.y) / scale, expected[3 * b + 1] / scale, tolerance);
            EXPECT_NEAR(Real(tree.bodies[b].w) / scale, expected[3 * b + 2] / scale, tolerance);
        }
        if (testing::Test::HasFailure()) return;
    }
}

TEST(TreeSolve, FindsInOnePassWhatADenseSolveFinds) { expect_dense_solution(0, 1e-4); }

TEST(TreeSolve, BearsMassesFourDecadesApart) { expect_dense_solution(4, 2e-3); }

// A chain between two static bodies, with an arm or two. The second hold is solved as a heavy body's: it takes passes to come close, and rounding leaves up to
// 1 % of the bodies' speeds, which are up to 5 m/s.
TEST(TreeSolve, FindsForAChainHeldAtBothEndsWhatADenseSolveFinds) {
    Random random(9);
    for (int trial = 0; trial < 300; ++trial) {
        SCOPED_TRACE(trial);
        const std::uint32_t size = 4 + random.below(8);
        HingeTree tree = random_tree(random, size, 1);
        for (std::uint32_t k = 0; k < size; ++k) {
            SolverBody& b = tree.bodies[k + 1];
            TreeLink& l = tree.links[k];
            b.inv_inertia = 6 * b.inv_mass;
            l.joint = k;
            if (k + 4 >= size) l.parent = k + 1 < size ? k + 2 : 0;
            l.up = l.parent != 0 ? l.parent - 1 : null_index;
            l.rc = {random.between(-1, -0.5f), random.between(-1, 1)};
            l.rp = {random.between(0.5f, 1), random.between(-1, 1)};
        }
        TreeLink anchor = tree.links[size - 4];
        anchor.child = 0;
        anchor.parent = size - 3;
        anchor.up = size - 3;  // once it stands before the others
        anchor.joint = size;
        for (TreeLink& l : tree.links)
            if (l.up != null_index) ++l.up;
        tree.links.insert(tree.links.begin(), anchor);
        const std::vector<Real> expected = dense_solution(tree);
        JointSweep relax;
        relax.h = 1.0f / 240;
        relax.inv_h = 240;
        for (int pass = 0; pass < 12; ++pass) solve_trees(tree.bodies.data(), tree.links.data(), size + 1, nullptr, relax);
        for (std::size_t b = 0; b < tree.bodies.size(); ++b) {
            EXPECT_NEAR(Real(tree.bodies[b].v.x), expected[3 * b], 0.05);
            EXPECT_NEAR(Real(tree.bodies[b].v.y), expected[3 * b + 1], 0.05);
            EXPECT_NEAR(Real(tree.bodies[b].w), expected[3 * b + 2], 0.05);
        }
        EXPECT_EQ(tree.bodies[0].v, (Vec2{0, 0})) << "the static body was pushed";
        if (testing::Test::HasFailure()) return;
    }
}

// Random trees with dry friction, a motor or limits that are reached at all hinges. The solution is known by what holds at each: the points move together, and
// the angle's impulse and speed lie on the graph of its law (the hinge stays at a speed only with an impulse within the range that it has there).
TEST(TreeSolve, FindsImpulsesOfFrictionMotorsAndLimitsThatTheirLawsAllow) {
    Random random(21);
    for (int trial = 0; trial < 500; ++trial) {
        SCOPED_TRACE(trial);
        const std::uint32_t size = 1 + random.below(12);
        HingeTree tree = random_tree(random, size, 1);
        std::vector<Joint> joints(size);
        for (std::uint32_t k = 0; k < size; ++k) {
            tree.bodies[k + 1].inv_inertia = random.between(3, 10) * tree.bodies[k + 1].inv_mass;
            TreeLink& l = tree.links[k];
            if (l.joint == null_index) continue;
            l.acts = true;
            Joint& j = joints[k];
            if (random.one_in(2)) j.friction = 240 * random.between(0, 0.5f);
            if (random.one_in(3)) {
                j.flags |= joint_motor;
                j.motor_speed = random.between(-3, 3);
                j.motor_max = 240 * random.between(0, 2);
            }
            if (random.one_in(2)) {  // both are reached: the angle is 0
                j.flags |= joint_limit;
                if (random.one_in(2)) j.lower = -0.01f;
                if (random.one_in(2)) j.upper = 0.01f;
            }
        }
        JointSweep relax;
        relax.h = 1.0f / 240;
        relax.inv_h = 240;
        relax.max_turn = 1e6f;
        solve_trees(tree.bodies.data(), tree.links.data(), size, joints.data(), relax);
        for (const TreeLink& l : tree.links) {
            if (l.joint == null_index) continue;
            const SolverBody &c = tree.bodies[l.child], &p = tree.bodies[l.parent];
            const Vec2 apart = c.v + cross(c.w, l.rc) - p.v - cross(p.w, l.rp);
            EXPECT_LT(Real(length(apart)), 1e-3);
            const Joint& j = joints[l.joint];
            const Real w = Real(l.sign * (c.w - p.w)), impulse = Real(l.sign * l.lambda.turning), friction = Real(j.friction) / 240;
            const Real motor = (j.flags & joint_motor) != 0 ? Real(j.motor_max) / 240 : 0, speed = Real(j.motor_speed), close = 1e-3;
            const bool limited = (j.flags & joint_limit) != 0;
            Real least = 0, most = 0;
            const auto step_at = [&](Real at, Real size_of_step) {
                least += w < at - close ? size_of_step : -size_of_step;
                most += w > at + close ? -size_of_step : size_of_step;
            };
            step_at(0, friction);
            step_at(speed, motor);
            if (limited) {
                EXPECT_GE(w, 240 * Real(j.lower) - close);
                EXPECT_LE(w, 240 * Real(j.upper) + close);
                if (w < 240 * Real(j.lower) + close) most = 1e9;
                if (w > 240 * Real(j.upper) - close) least = -1e9;
            }
            EXPECT_GE(impulse, least - close);
            EXPECT_LE(impulse, most + close);
        }
        if (testing::Test::HasFailure()) return;
    }
}

// Trees beside each other, with as many links as they like: each comes to the bits to which it comes alone, whatever the others need.
TEST(TreeSolve, SolvesEachTreeAsIfItWereAlone) {
    Random random(17);
    JointSweep relax;
    relax.h = 1.0f / 240;
    relax.inv_h = 240;
    for (int trial = 0; trial < 200; ++trial) {
        SCOPED_TRACE(trial);
        HingeTree all;
        all.bodies.resize(1);
        std::vector<HingeTree> trees;
        for (std::uint32_t i = 0; i < 1 + random.below(4); ++i) {
            trees.push_back(random_tree(random, 1 + random.below(8), 2));
            const auto before = static_cast<std::uint32_t>(all.links.size());
            all.bodies.insert(all.bodies.end(), trees.back().bodies.begin() + 1, trees.back().bodies.end());
            for (TreeLink link : trees.back().links) {
                link.child += before;
                if (link.parent != 0) link.parent += before;
                all.links.push_back(link);
            }
        }
        solve_trees(all.bodies.data(), all.links.data(), static_cast<std::uint32_t>(all.links.size()), nullptr, relax);
        std::size_t slot = 1;
        for (HingeTree& tree : trees) {
            solve_trees(tree.bodies.data(), tree.links.data(), static_cast<std::uint32_t>(tree.links.size()), nullptr, relax);
            for (std::size_t b = 1; b < tree.bodies.size(); ++b, ++slot) {
                ASSERT_EQ(all.bodies[slot].v, tree.bodies[b].v);
                ASSERT_EQ(all.bodies[slot].w, tree.bodies[b].w);
            }
        }
    }
}

TEST(TreeSolve, SolvedAgainChangesNothing) {
    Random random(3);
    HingeTree tree = random_tree(random, 12, 1);
    JointSweep relax;
    relax.h = 1.0f / 240;
    relax.inv_h = 240;
    const auto count = static_cast<std::uint32_t>(tree.links.size());
    solve_trees(tree.bodies.data(), tree.links.data(), count, nullptr, relax);
    const std::vector<SolverBody> once = tree.bodies;
    solve_trees(tree.bodies.data(), tree.links.data(), count, nullptr, relax);
    for (std::size_t b = 0; b < once.size(); ++b) {
        EXPECT_NEAR(tree.bodies[b].v.x, once[b].v.x, 1e-4);
        EXPECT_NEAR(tree.bodies[b].v.y, once[b].v.y, 1e-4);
        EXPECT_NEAR(tree.bodies[b].w, once[b].w, 1e-3);
    }
}

TEST(TreeSolve, LeavesThingsFiniteWhoseMassesAreAbsurd) {
    Random random(5);
    for (int trial = 0; trial < 200; ++trial) {
        HingeTree tree = random_tree(random, 6, 60);
        JointSweep relax;
        relax.h = 1.0f / 240;
        relax.inv_h = 240;
        solve_trees(tree.bodies.data(), tree.links.data(), 6, nullptr, relax);
        EXPECT_EQ(tree.bodies[0].v, (Vec2{0, 0})) << "the static body was pushed";
        EXPECT_EQ(tree.bodies[0].w, 0);
    }
}

// -- which hinges are chosen -------------------------------------------------------------------------------------------------------

const Capacity room_for_trees{.bodies = 64, .shapes = 64, .contacts = 64, .joints = 64};

WorldDef with(JointTrees trees) {
    WorldDef def;
    def.solver.joint_tree_load = 10;
    def.solver.joint_trees = trees;
    return def;
}

// A row of boxes of 1 m, held at the left end, each hinged to the next; the last weighs `load` times as much.
struct Row {
    TestWorld world;
    std::vector<BodyId> bodies;
    std::vector<JointId> joints;

    explicit Row(int links, float load, WorldDef def = with(JointTrees::automatic)) : world(room_for_trees, def) {
        bodies.push_back(world->create_body({}));
        for (int i = 0; i < links; ++i) {
            const float density = i + 1 == links ? load : 1;
            bodies.push_back(world.add(make_box(0.5f, 0.1f), {static_cast<float>(i) + 0.5f, 0}, {.density = density, .filter = {.group = -1}}));
            joints.push_back(hinge(bodies[static_cast<std::size_t>(i)], bodies.back(), {static_cast<float>(i), 0}));
        }
    }
    JointId hinge(BodyId a, BodyId b, Vec2 at) {
        RevoluteJointDef def;
        def.base.body_a = a;
        def.base.body_b = b;
        def.base.frame_a.position = at - world->position(a);
        def.base.frame_b.position = at - world->position(b);
        return world->create_joint(def);
    }
    std::uint32_t exact_after_a_step() {
        world.step();
        EXPECT_EQ(world->validate(), nullptr);
        return Core::of(*world).state->exact_joints;
    }
};

TEST(JointTrees, ByDefaultEveryTreeIsSolvedExactly) { EXPECT_EQ(Row(2, 0.1f, {}).exact_after_a_step(), 2u); }

TEST(JointTrees, WithALoadOfTenAChainMustBearTenTimesALink) {
    EXPECT_EQ(Row(3, 5).exact_after_a_step(), 0u);    // bears 7 links
    EXPECT_EQ(Row(3, 8).exact_after_a_step(), 3u);    // 10 links
    EXPECT_EQ(Row(12, 1).exact_after_a_step(), 12u);  // its own weight is enough
}

TEST(JointTrees, TheSettingTurnsThemOffAndOnAtAnyTime) {
    Row row(3, 1, with(JointTrees::off));
    EXPECT_EQ(row.exact_after_a_step(), 0u);
    SolverDef solver = row.world->solver();
    solver.joint_trees = JointTrees::all;
    row.world->set_solver(solver);
    EXPECT_EQ(row.exact_after_a_step(), 3u);
    solver.joint_trees = JointTrees::automatic;
    row.world->set_solver(solver);
    EXPECT_EQ(row.exact_after_a_step(), 0u);
    solver.joint_tree_load = 2;
    row.world->set_solver(solver);
    EXPECT_EQ(row.exact_after_a_step(), 3u);
    solver.joint_tree_load = 0.5f;
    row.world->set_solver(solver);
    EXPECT_EQ(row.world->last_error(), Error::out_of_range);
}

TEST(JointTrees, AChainHeldAtBothEndsAndInTheMiddleIsATree) {
    Row row(12, 1, with(JointTrees::all));
    for (const int i : {12, 6}) {
        const Vec2 at = {static_cast<float>(i), 0};
        row.hinge(row.bodies[static_cast<std::size_t>(i)], row.world->create_body({.position = at}), at);
    }
    EXPECT_EQ(row.exact_after_a_step(), 14u);
    row.world->set_type(row.bodies[3], BodyType::kinematic);  // two trees: held at both ends, and in three places
    EXPECT_EQ(row.exact_after_a_step(), 14u);
    row.world->set_type(row.bodies[3], BodyType::dynamic);
    EXPECT_EQ(row.exact_after_a_step(), 14u);
}

TEST(JointTrees, HeldTwiceATreeIsSweptIfAHingeCanBreak) {
    Row row(12, 1);
    const JointId holds = row.hinge(row.bodies.back(), row.world->create_body({.position = {12, 0}}), {12, 0});
    EXPECT_EQ(row.exact_after_a_step(), 13u);
    row.world->destroy_joint(holds);
    RevoluteJointDef def;
    def.base = {.body_a = row.bodies.back(), .body_b = row.bodies.front(), .frame_a = {{0.5f, 0}}, .frame_b = {{12, 0}}, .break_force = 1e4f};
    const JointId weak = row.world->create_joint(def);
    EXPECT_EQ(row.exact_after_a_step(), 0u);
    row.world->destroy_joint(weak);
    EXPECT_EQ(row.exact_after_a_step(), 12u);
}

TEST(JointTrees, ALoopIsSweptUntilItIsCut) {
    Row row(12, 1);
    const JointId closes = row.hinge(row.bodies[2], row.bodies[4], {2.5f, 0});  // a loop of three bodies
    EXPECT_EQ(row.exact_after_a_step(), 0u);
    row.world->destroy_joint(closes);
    EXPECT_EQ(row.exact_after_a_step(), 12u);
}

TEST(JointTrees, EvenWhereAllAreWantedWhatClosesALoopIsSwept) {
    Row row(12, 1, with(JointTrees::all));
    row.hinge(row.bodies[2], row.bodies[4], {2.5f, 0});
    EXPECT_EQ(row.exact_after_a_step(), 12u);
}

TEST(JointTrees, MassesAndTypesThatChangeAreLookedAtAgain) {
    Row row(3, 1);
    EXPECT_EQ(row.exact_after_a_step(), 0u);
    row.world->set_mass(row.bodies.back(), {.mass = 100, .center = {0, 0}, .inertia = 10});
    EXPECT_EQ(row.exact_after_a_step(), 3u);
    row.world->set_type(row.bodies[2], BodyType::kinematic);  // now two trees, of which one bears much and one nothing
    EXPECT_EQ(row.exact_after_a_step(), 0u);
    row.world->set_type(row.bodies[2], BodyType::dynamic);
    EXPECT_EQ(row.exact_after_a_step(), 3u);
    row.world->destroy_body(row.bodies.back());
    EXPECT_EQ(row.exact_after_a_step(), 0u);
}

TEST(JointTrees, AMotorOrFrictionHasItsTreeSwept) {
    Row row(12, 1);
    EXPECT_EQ(row.exact_after_a_step(), 12u);
    row.world->set_motor(row.joints[5], {.enable = true, .speed = 1, .max_force = 10});
    EXPECT_EQ(row.exact_after_a_step(), 0u);
    row.world->set_motor(row.joints[5], {});
    EXPECT_EQ(row.exact_after_a_step(), 12u);
    row.world->set_joint_friction(row.joints[5], 0.1f);
    EXPECT_EQ(row.exact_after_a_step(), 0u);
}

TEST(JointTrees, WhereAHeavyForcePullsATreeWithAMotorIsSolvedExactlyUntilItStops) {
    Row row(12, 1);
    row.world->set_motor(row.joints[5], {.enable = true, .speed = 1, .max_force = 10});
    const float mass = row.world->mass(row.bodies[6]);
    row.world->apply_force_to_center(row.bodies[6], {20 * mass, 0});  // light
    EXPECT_EQ(row.exact_after_a_step(), 0u);
    for (int step = 0; step < 3; ++step) {
        row.world->apply_force_to_center(row.bodies[6], {5000 * mass, 0});
        EXPECT_EQ(row.exact_after_a_step(), 12u) << step;
    }
    for (int step = 0; step < 60; ++step) row.world.step();
    EXPECT_EQ(row.exact_after_a_step(), 0u);
}

TEST(JointTrees, ASpringHasItsTreeSweptUnderAnyForce) {
    Row row(12, 1);
    row.world->set_spring(row.joints[5], {.enable = true, .hertz = 1, .damping_ratio = 1});
    row.world->apply_force_to_center(row.bodies[6], {5000 * row.world->mass(row.bodies[6]), 0});
    EXPECT_EQ(row.exact_after_a_step(), 0u);
}

TEST(JointTrees, ATreeThatNothingHoldsIsSolvedToo) {
    Row row(12, 1, with(JointTrees::all));
    row.world->destroy_joint(row.joints.front());
    EXPECT_EQ(row.exact_after_a_step(), 11u);
    EXPECT_EQ(row.world->report().awake_joints, 11u);
}

TEST(JointTrees, LeavesComeBeforeTheirParents) {
    Random random(11);
    for (int trial = 0; trial < 50; ++trial) {
        SCOPED_TRACE(trial);
        Row row(1, 1, with(JointTrees::all));
        // Bodies hung on random ones before, in a random order of slots.
        for (int i = 0; i < 30; ++i) {
            const BodyId on = row.bodies[random.below(static_cast<std::uint32_t>(row.bodies.size()))];
            if (random.one_in(4)) row.world->destroy_body(row.world.add_circle({50, 50}, 1));
            row.bodies.push_back(row.world.add(make_box(0.5f, 0.1f), {static_cast<float>(i), 3}, {.filter = {.group = -1}}));
            row.hinge(random.one_in(2) ? on : row.bodies.back(), on == row.bodies.back() ? on : random.one_in(2) ? row.bodies.back() : on, {0, 0});
        }
        row.world.step();
        Core& core = Core::of(*row.world);
        std::vector<PlannedLink> order(64);
        order.resize(order_links(core, true, order.data(), core.arena()));
        std::vector<bool> seen(64, false);
        std::uint32_t joints = 0;
        for (const PlannedLink& b : order) {
            EXPECT_FALSE(seen[b.body]);
            seen[b.body] = true;
            if (b.joint == null_index) continue;
            ++joints;
            const Joint& j = core.joints[b.joint];
            const std::uint32_t parent = j.body_a == b.body ? j.body_b : j.body_a;
            EXPECT_FALSE(seen[parent]) << "a parent came before its child";
        }
        EXPECT_EQ(joints, core.state->exact_joints);
    }
}

}  // namespace
