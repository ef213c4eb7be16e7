// Settings of the solver beyond the default: the order of sweeps, contacts solved as blocks, shock propagation, the residual and the tolerance, each against
// what it claims: closed forms where there are any, and otherwise what stands and what falls.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "harness/checks.hpp"
#include "harness/engine.hpp"
#include "measure.hpp"
#include "scenes/catalogue.hpp"

namespace islet::test {
namespace {

// One plain Gauss-Seidel sweep a step, from nothing.
WorldDef single_sweep() {
    WorldDef def = sleepless();
    def.solver.schedule = Schedule::classic;
    def.solver.substeps = def.solver.iterations = 1;
    def.solver.warm_start = false;
    return def;
}

// Boxes of 1 m and `density` kg/m^2 on a floor, and one of `top` kg/m^2 on them.
std::vector<BodyId> add_tower(TestWorld& w, float x, int count, float top = 1) {
    std::vector<BodyId> tower;
    for (int i = 0; i < count; ++i) tower.push_back(w.add_box({x, 0.5f + static_cast<float>(i)}, 0.5f, 0.5f, dense(i + 1 == count ? top : 1)));
    return tower;
}

// The sum of the normal impulses under each body of the tower, N s, from the bottom.
std::vector<double> supports(const TestWorld& w, const std::vector<BodyId>& tower) {
    std::vector<double> sums(tower.size());
    for (const ContactInfo& c : w.contacts()) {
        const double y = std::max(double(w->position(w->body(c.shape_a)).y), double(w->position(w->body(c.shape_b)).y));
        for (std::uint32_t i = 0; i < c.point_count; ++i) sums[static_cast<std::size_t>(y)] += double(c.points[i].normal_impulse);
    }
    return sums;
}

// -- sweep order -----------------------------------------------------------------------------------------------------------------

// Balls that fall side by side push each other only once one of them is held up. So the first upward sweep reaches all of a tower: the floor stops the lowest
// with m g h, and each contact above meets half the speed that the one below did. The first downward sweep reaches the lowest ball alone.
TEST(SweepOrders, UpwardASweepHandsSupportThroughATowerAndDownwardItDoesNot) {
    for (const SweepOrder order : {SweepOrder::upward, SweepOrder::downward}) {
        WorldDef def = single_sweep();
        def.solver.sweep_order = order;
        TestWorld w(roomy, def);
        w.add_ground();
        // Made from the top down, so that the order of slots is neither.
        std::vector<BodyId> tower;
        for (int i = 9; i >= 0; --i) tower.push_back(w.add_circle({0, 0.5f + static_cast<float>(i)}, 0.5f, dense(1 / (0.25f * pi))));
        std::reverse(tower.begin(), tower.end());
        w->step(step_time);
        const std::vector<double> sums = supports(w, tower);
        for (std::size_t i = 0; i < tower.size(); ++i) {
            const double expected = order == SweepOrder::upward ? std::pow(0.5, double(i)) : i == 0 ? 1 : 0;
            EXPECT_NEAR(sums[i], expected * g / 60, 1e-4 * g / 60) << "ball " << i;
        }
    }
}

TEST(SweepOrders, EveryOrderHoldsUpWhatTheOthersDo) {
    for (const SweepOrder order : {SweepOrder::colored, SweepOrder::as_found, SweepOrder::upward, SweepOrder::downward}) {
        WorldDef def = sleepless();
        def.solver.sweep_order = order;
        TestWorld w(roomy, def);
        w.add_ground();
        const std::vector<BodyId> tower = add_tower(w, 0, 6);
        for (int i = 0; i < 600; ++i) w->step(step_time);
        const std::vector<double> sums = supports(w, tower);
        for (std::size_t i = 0; i < tower.size(); ++i)
            EXPECT_NEAR(sums[i], (6.0 - double(i)) * g / 240, 0.02 * g / 240) << "box " << i << ", order " << static_cast<int>(order);
        EXPECT_EQ(w->report().overflow_contacts, order == SweepOrder::colored ? 0u : 6u) << "contacts solved one by one";
    }
}

// -- blocks ----------------------------------------------------------------------------------------------------------------------

// A box whose mass is off its middle rests on both corners: statics gives the two impulses, by the lever arms. One sweep that knows one point at a time does
// not find them, one that solves both together does.
TEST(BlockContacts, OneSweepFindsBothImpulsesUnderABoxWhoseWeightIsOffTheMiddle) {
    for (const bool block : {false, true}) {
        WorldDef def = single_sweep();
        def.solver.block_contacts = block;
        TestWorld w(roomy, def);
        w.add_ground(0, 100, rough(0));
        const BodyId box = w.add_box({0, 0.5f}, 0.5f, 0.5f, rough(0));
        w->set_mass(box, {.mass = 1, .center = {0.25f, 0}, .inertia = 1});
        w->step(step_time);
        const std::vector<ContactInfo> contacts = w.contacts();
        ASSERT_EQ(contacts.size(), 1u);
        ASSERT_EQ(contacts[0].point_count, 2u);
        const double weight = g / 60;
        for (const ContactPoint& p : contacts[0].points) {
            const double expected = p.point.x < 0 ? 0.25 * weight : 0.75 * weight;
            if (block)
                EXPECT_NEAR(double(p.normal_impulse), expected, 1e-3 * weight);
            else
                EXPECT_GT(std::abs(double(p.normal_impulse) - expected), 0.02 * weight) << "sweeps point by point do as well: this test shows nothing";
        }
        EXPECT_EQ(w->report().residual, 0) << "nobody asked for it";
    }
}

// Where one of the two points would have to pull, the other carries alone: here a box tips about its right corner.
TEST(BlockContacts, APointThatWouldHaveToPullLetsGo) {
    WorldDef def = single_sweep();
    def.solver.block_contacts = true;
    TestWorld w(roomy, def);
    w.add_ground(0, 100, rough(0));
    const BodyId box = w.add(make_box(0.5f, 0.5f), Vec2{0, 0.5f}, rough(0));
    w->set_mass(box, {.mass = 1, .center = {0.9f, 0}, .inertia = 0.1f});
    w->step(step_time);
    const ContactInfo contact = w.contacts().at(0);
    // One row at the arm r = -0.4 m from the centre: lambda = g h / (1/m + r^2 / I).
    const double alone = g / 60 / (1 + 0.4 * 0.4 / 0.1);
    for (const ContactPoint& p : contact.points) EXPECT_NEAR(double(p.normal_impulse), p.point.x < 0 ? 0 : alone, 1e-3 * alone);
}

TEST(BlockContacts, ATowerOfSixtyBoxesStandsStraight) {
    const auto sway = [](bool block) {
        WorldDef def = sleepless();
        def.solver.block_contacts = block;
        TestWorld w(roomy, def);
        w.add_ground();
        const std::vector<BodyId> tower = add_tower(w, 0, 60);
        double most = 0;
        for (int i = 0; i < 3600; ++i) {
            w->step(step_time);
            for (const BodyId id : tower) most = std::max(most, std::abs(double(w->position(id).x)));
        }
        return most;
    };
    // 60 m high, for 60 s; a hundredth of a box is what nobody sees.
    EXPECT_LT(sway(false), 0.01);
    EXPECT_LT(sway(true), 0.01);
}

// -- hard cases at the default ---------------------------------------------------------------------------------------------------

// A slab of 300 kg on three columns of two boxes of 1 kg, and a pyramid whose top box weighs 300 kg.
TEST(HardCases, ThreeHundredToOneStandsForAMinute) {
    samples::Scene scene = samples::find_scene("mass_ratio")->make();
    samples::IsletEngine engine;
    engine.load(scene);
    const samples::Drift before = samples::drift_from(samples::places_of(scene, 1, scene.bodies.size()), engine, 1);
    EXPECT_EQ(before.sideways, 0);
    for (int step = 0; step < (slow_build ? 600 : 3600); ++step) engine.advance(scene, step, step_time);
    const samples::Drift drift = samples::drift_from(samples::places_of(scene, 1, scene.bodies.size()), engine, 1);
    EXPECT_LT(drift.sideways, 0.05);
    EXPECT_LT(drift.turn, 0.05);
    EXPECT_LT(drift.sink, 0.2) << "contacts are soft and give way under the load, but nothing falls";
    EXPECT_LT(samples::max_speed(engine), 0.02);
}

// -- shock propagation -----------------------------------------------------------------------------------------------------------

// 3000 kg on a column of five boxes of 1 kg. Soft contacts, solved with the masses as they are, let the column buckle.
TEST(Shock, KeepsAColumnFromBucklingUnderThreeThousandTimesItsBoxes) {
    const auto sideways = [](float shock) {
        WorldDef def = sleepless();
        def.solver.shock = shock;
        TestWorld w(roomy, def);
        w.add_ground();
        const std::vector<BodyId> tower = add_tower(w, 0, 6, 3000);
        double most = 0;
        for (int i = 0; i < (slow_build ? 600 : 3600); ++i) {
            w->step(step_time);
            for (const BodyId id : tower) most = std::max(most, std::abs(double(w->position(id).x)));
        }
        return most;
    };
    EXPECT_GT(sideways(0), 1) << "it stands without: this test shows nothing";
    EXPECT_LT(sideways(max_shock), 0.05);
}

TEST(Shock, LeavesAloneWhatLiesOnTheGround) {
    const auto fall = [](float shock) {
        WorldDef def = sleepless();
        def.solver.shock = shock;
        TestWorld w(roomy, def);
        w.add_ground();
        const BodyId box = w.add_box({0, 3});
        std::vector<float> heights;
        for (int i = 0; i < 120; ++i) {
            w->step(step_time);
            heights.push_back(w->position(box).y);
        }
        return heights;
    };
    EXPECT_EQ(fall(0), fall(max_shock));
}

// A contact tells the weight of what lies above it, m g h in a substep, though the solve takes those bodies for lighter.
TEST(Shock, ContactsReportTheWeightAboveThem) {
    for (const float shock : {0.1f, 0.3f, max_shock}) {
        WorldDef def = sleepless();
        def.solver.shock = shock;
        TestWorld w(roomy, def);
        w.add_ground();
        const std::vector<BodyId> tower = add_tower(w, 0, 8, 20);
        for (int i = 0; i < 1200; ++i) w->step(step_time);
        const std::vector<double> sums = supports(w, tower);
        for (std::size_t i = 0; i < tower.size(); ++i) {
            const double above = double(tower.size() - i - 1) + 20;
            EXPECT_NEAR(sums[i], above * g / 240, 0.01 * above * g / 240) << "box " << i << ", shock " << shock;
        }
    }
}

// In a pyramid each box lies on two others, and the ground bears it all, whether gravity points down or to the side.
TEST(Shock, TheGroundReportsTheWeightOfAPyramid) {
    for (const float shock : {0.1f, max_shock}) {
        for (const float angle : {0.0f, 0.5f * pi}) {
            WorldDef def = sleepless();
            def.solver.shock = shock;
            const Rot turn = make_rot(angle);
            def.gravity = rotate(turn, Vec2{0, -float(g)});
            TestWorld w(roomy, def);
            const auto add_box = [&](BodyType type, Vec2 half, Vec2 center) {
                return w.add(make_box(half.x, half.y), BodyDef{.type = type, .position = rotate(turn, center), .angle = angle});
            };
            const BodyId ground = add_box(BodyType::static_body, {20, 1}, {0, -1});
            int boxes = 0;
            for (int row = 0; row < 8; ++row)
                for (int i = 0; i < 8 - row; ++i, ++boxes)
                    add_box(BodyType::dynamic, {0.5f, 0.5f}, {1.05f * (static_cast<float>(i) + 0.5f * static_cast<float>(row)), 0.5f + static_cast<float>(row)});
            for (int i = 0; i < 1200; ++i) w->step(step_time);
            double told = 0;
            for (const ContactInfo& c : w.contacts())
                if (w->body(c.shape_a) == ground || w->body(c.shape_b) == ground)
                    for (std::uint32_t i = 0; i < c.point_count; ++i) told += double(c.points[i].normal_impulse);
            EXPECT_NEAR(told, boxes * g / 240, 0.01 * boxes * g / 240) << "shock " << shock << ", turned by " << angle;
        }
    }
}

TEST(Shock, TheMostOfItAndNoGravityAreBorne) {
    for (const Vec2 gravity : {Vec2{0, 0}, Vec2{0, -10}, Vec2{3, 4}}) {
        WorldDef def = sleepless();
        def.gravity = gravity;
        def.solver.shock = max_shock;
        TestWorld w(roomy, def);
        w.add_ground();
        const std::vector<BodyId> tower = add_tower(w, 0, 5);
        for (int i = 0; i < 300; ++i) w->step(step_time);
        EXPECT_EQ(w->validate(), nullptr);
        for (const BodyId id : tower) EXPECT_LT(std::abs(w->position(id).x), 3000);
    }
}

// Two wheels on a bar, solved exactly, that lie on a box: taken for lighter they must not spin up by themselves.
TEST(Shock, HingesSolvedExactlyDoNotSpinUp) {
    for (const float shock : {0.2f, 0.5f}) {
        WorldDef def = sleepless();
        def.solver.shock = shock;
        def.solver.joint_trees = JointTrees::all;
        TestWorld w(roomy, def);
        w.add_ground();
        w.add_box({0, 0.5f}, 2, 0.5f);
        const BodyId bar = w.add(make_box(1, 0.1f), Vec2{0, 1.4f}, {.filter = {.group = -1}});
        for (const float x : {-0.8f, 0.8f}) {
            const BodyId wheel = w.add(Circle{{}, 0.4f}, Vec2{x, 1.4f}, {.filter = {.group = -1}});
            RevoluteJointDef hinge;
            hinge.base.body_a = bar;
            hinge.base.body_b = wheel;
            hinge.base.frame_a.position = {x, 0};
            EXPECT_TRUE(w->create_joint(hinge));
            w->set_angular_velocity(wheel, 0.01f);
        }
        for (int i = 0; i < 60; ++i) w->step(step_time);
        for (const BodyId id : w.bodies()) EXPECT_LT(std::abs(w->angular_velocity(id)), 0.02f);
    }
}

// Bodies that tumble change what they lie on in every step, and with it how light they are taken for: no energy may come of it.
TEST(Shock, PilesOfLooseBodiesComeToRest) {
    for (int start = 0; start < 20; ++start) {
        const float shift = 0.003f * static_cast<float>(start);
        WorldDef def = sleepless();
        def.solver.shock = max_shock;
        TestWorld w(roomy, def);
        w.add_ground();
        for (const float x : {-4.5f, 4.5f}) w.add(make_box(0.5f, 20), Vec2{x, 20}, {}, BodyType::static_body);
        for (int i = 0; i < 60; ++i) {
            const Vec2 at = {-3.0f + 1.5f * static_cast<float>(i % 5) + 0.1f * static_cast<float>(i % 3) + shift, 1.0f + 1.2f * static_cast<float>(i / 5) + shift};
            if (i % 2 == 0)
                w.add_box(at, 0.4f, 0.5f);
            else
                w.add_circle(at, 0.45f, {.rolling_resistance = 0.1f});
        }
        for (int i = 0; i < 900; ++i) w->step(step_time);
        for (const BodyId id : w.bodies()) {
            EXPECT_LT(length(w->linear_velocity(id)), 1) << "start " << start;
            EXPECT_LE(w->position(id).y, 20) << "above the walls, start " << start;
        }
    }
}

// -- residual and tolerance ------------------------------------------------------------------------------------------------------

// The first step of two balls on each other, one sweep from the bottom up: the floor holds the lower one up with m g h, then the upper pushes it down with
// m g h / 2 and keeps half the speed it had. Solving the floor again would bring the lower ball to rest: g h / 2; solving the upper contact again changes
// nothing. So the residual is g h / 2.
TEST(Residual, IsTheVelocityThatAConstraintByItselfWouldStillChange) {
    WorldDef def = single_sweep();
    def.solver.sweep_order = SweepOrder::upward;
    def.solver.measure_residual = true;
    TestWorld w(roomy, def);
    w.add_ground(0, 100, rough(0));
    const BodyId lower = w.add_circle({0, 0.5f}), upper = w.add_circle({0, 1.5f});
    const BodyId far = w.add_circle({50, 100});
    EXPECT_EQ(w->residual(lower), 0) << "before the first step";
    w->step(step_time);
    EXPECT_NEAR(double(w->residual(lower)), g / 60 / 2, 1e-4);
    EXPECT_EQ(w->residual(lower), w->residual(upper)) << "they are one island";
    EXPECT_EQ(w->residual(lower), w->report().residual);
    EXPECT_EQ(w->residual(far), 0) << "an island of its own, with nothing to solve";
    w->residual({});
    EXPECT_EQ(w->last_error(), Error::null_id);
}

TEST(Residual, FallsWithSweepsAndIsTheSameWhetherItIsLookedAtOrNot) {
    samples::Scene scene = samples::find_scene("ragdoll")->make();
    scene.world.enable_sleep = false;
    double before = 1e30;
    std::uint64_t hash = 0;
    for (const std::uint32_t sweeps : {1u, 16u, 256u}) {
        samples::IsletEngine engine;
        scene.world.solver = {};
        engine.load(scene);
        for (int i = 0; i < 10; ++i) engine.world().step(step_time);
        SolverDef def = engine.world().solver();
        def.relax_iterations = sweeps;
        engine.world().set_solver(def);
        engine.world().step(step_time);
        hash = engine.world().hash();
        EXPECT_EQ(engine.world().report().residual, 0);

        samples::IsletEngine measured;
        measured.load(scene);
        for (int i = 0; i < 10; ++i) measured.world().step(step_time);
        def.measure_residual = true;
        measured.world().set_solver(def);
        measured.world().step(step_time);
        EXPECT_EQ(measured.world().hash(), hash) << "measuring changed something";
        const double residual = double(measured.world().report().residual);
        EXPECT_GT(residual, 0);
        EXPECT_LT(residual, 0.5 * before) << sweeps << " sweeps";
        before = residual;
    }
}

TEST(Tolerance, EndsSweepsOnceItIsReachedAndNotBefore) {
    const auto play = [](float tolerance, std::uint32_t most) {
        WorldDef def = sleepless();
        def.solver.schedule = Schedule::classic;
        def.solver.substeps = 1;
        def.solver.iterations = most;
        def.solver.tolerance = tolerance;
        TestWorld w(roomy, def);
        w.add_ground();
        add_tower(w, 0, 5);
        for (int i = 0; i < 60; ++i) w->step(step_time);
        return std::pair{w->report().sweeps, double(w->report().residual)};
    };
    const auto [sweeps, residual] = play(1e-3f, 256);
    EXPECT_LT(sweeps, 256u);
    EXPECT_LE(residual, 1e-3);
    const auto [finer_sweeps, finer] = play(1e-5f, 256);
    EXPECT_GE(finer_sweeps, sweeps);
    EXPECT_LE(finer, 1e-5);
    const auto [few_sweeps, coarse] = play(1e-9f, 2);
    EXPECT_EQ(few_sweeps, 2u) << "the number of sweeps is the most there are";
    EXPECT_GT(coarse, 1e-9);
}

// A residual of one island says nothing of another's, also when the two are solved together.
TEST(Residual, IsOfEachIslandItsOwn) {
    WorldDef def = single_sweep();
    def.solver.measure_residual = true;
    TestWorld w(roomy, def);
    w.add_ground();
    const BodyId alone = w.add_circle({-20, 0.5f}, 0.5f, rough(0));
    const std::vector<BodyId> tower = add_tower(w, 0, 8);
    w->step(step_time);
    EXPECT_LT(w->residual(alone), 1e-6f) << "one contact is solved by solving it";
    EXPECT_GT(w->residual(tower[0]), 0.01f);
}

}  // namespace
}  // namespace islet::test
