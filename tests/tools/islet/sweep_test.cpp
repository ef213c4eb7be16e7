// Sweeps: parameters reach the world, which then does what formulas say; shards put together are the whole, whatever the number of threads; and what is wrong
// is said in a sentence.
#include "islet/sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "harness/checks.hpp"
#include "scenes/catalogue.hpp"

namespace {

using namespace islet;
using namespace islet::samples;
using namespace islet::tools;

constexpr double start_speed = 4;  // m/s

/// A box that slides on a floor until friction stops it.
Scene make_sliding(std::optional<int>) {
    Scene scene;
    scene.name = "sliding";
    scene.steps = 400;
    SceneBody floor, box;
    floor.shapes.push_back({HalfSpace{{0, 1}, 0}, {}});
    box.def.type = BodyType::dynamic;
    box.def.position = {0, 0.5f};
    box.def.linear_velocity = {static_cast<float>(start_speed), 0};
    box.shapes.push_back({make_box(1, 0.5f), {}});
    scene.bodies = {floor, box};
    return scene;
}

/// A body that falls for a second.
Scene make_falling(std::optional<int>) {
    Scene scene;
    scene.name = "falling";
    scene.steps = 60;
    SceneBody ball;
    ball.def.type = BodyType::dynamic;
    ball.shapes.push_back({Circle{{0, 0}, 0.5f}, {}});
    scene.bodies = {ball};
    return scene;
}

SceneMaker scene_of_catalogue(const char* name) {
    return [name](std::optional<int>) { return find_scene(name)->make(); };
}

Sweep sweep_of(const std::vector<std::string>& axes, std::uint64_t seeds = 1) {
    Sweep sweep;
    sweep.scene = "test";
    sweep.seeds = seeds;
    for (const std::string& axis : axes) sweep.axes.push_back(read_axis(axis));
    return sweep;
}

SweepPart part_of(Sweep sweep, const SceneMaker& make, std::uint32_t jobs = 2, std::uint64_t shard = 0, std::uint64_t shards = 1) {
    prepare(sweep, make, 2'000'000'000);
    SweepPart part{sweep, {}};
    part.runs = run_sweep(sweep, make, jobs, shard, shards, [](int) {});
    return part;
}

double value(const SweepRun& run, Measure measure) { return run.values[static_cast<std::size_t>(measure)]; }

/// What a call says is wrong.
template <class Call>
std::string complaint(Call&& call) {
    try {
        call();
    } catch (const SweepError& error) { return error.what(); }
    return "nothing";
}
#define EXPECT_SAYS(words, call) EXPECT_NE(complaint([&] { call; }).find(words), std::string::npos) << complaint([&] { call; })

TEST(Sweep, RangesAndListsOfValues) {
    const SweepAxis friction = read_axis("friction=0.1:0.9:9");
    ASSERT_EQ(friction.values.size(), 9u);
    for (int i = 0; i < 9; ++i) EXPECT_NEAR(friction.values[static_cast<std::size_t>(i)], 0.1 * (i + 1), 1e-12);
    EXPECT_EQ(friction.values.back(), 0.9);
    EXPECT_EQ(read_axis("substeps=1,2,8").values, (std::vector<double>{1, 2, 8}));
    EXPECT_EQ(read_axis("gravity=5:9:1").values, std::vector<double>{5});
}

TEST(Sweep, AxesThatAreNoneAreRefusedWithASentence) {
    EXPECT_SAYS("NAME=FIRST:LAST:COUNT", read_axis("friction"));
    EXPECT_SAYS("near names: friction", read_axis("frictoin=1"));
    EXPECT_SAYS("'x' is no number", read_axis("friction=x"));
    EXPECT_SAYS("is no number", read_axis("friction="));
    EXPECT_SAYS("is no number", read_axis("friction=1,,2"));
    EXPECT_SAYS("'nan' is no number", read_axis("friction=nan"));
    EXPECT_SAYS("a range is FIRST:LAST:COUNT", read_axis("friction=1:2"));
    EXPECT_SAYS("the count must be 1 to 10000", read_axis("friction=1:2:0"));
    EXPECT_SAYS("the count must be 1 to 10000", read_axis("friction=1:2:2.5"));
    EXPECT_SAYS("substeps is a whole number, not 1.5", part_of(sweep_of({"substeps=1.5"}), make_falling));
    EXPECT_SAYS("warm_start is 0 or 1, not 2", part_of(sweep_of({"warm_start=2"}), make_falling));
    EXPECT_SAYS("friction=-1: bodies[0].shapes[0].friction: A number is outside its range", part_of(sweep_of({"friction=1,-1"}), make_sliding));
    EXPECT_SAYS("omega=2: world.solver.omega", part_of(sweep_of({"omega=2"}), make_falling));
    EXPECT_SAYS("dt=2: a time step", part_of(sweep_of({"dt=2"}), make_falling));
    EXPECT_SAYS("friction is varied twice", part_of(sweep_of({"friction=1", "friction=2"}), make_falling));
    EXPECT_SAYS("more than 10000000 runs", part_of(sweep_of({"friction=0:1:10000", "density=1:2:10000"}), make_falling));
}

// From v the box slides v^2 / (2 mu g). A step ends up to v dt from there, and the box comes to rest within one.
TEST(Sweep, ABoxSlidesAsFarAsFrictionAndGravitySay) {
    const SweepPart part = part_of(sweep_of({"friction=0.2:0.8:4", "gravity=5,10"}), make_sliding);
    ASSERT_EQ(part.runs.size(), 8u);
    for (const SweepRun& run : part.runs) {
        const auto places = part.sweep.places(run.index);
        const double friction = part.sweep.axes[0].values[places[0]], gravity = part.sweep.axes[1].values[places[1]];
        // Two surfaces of the same friction have that one.
        EXPECT_NEAR(value(run, Measure::drift), start_speed * start_speed / (2 * friction * gravity), start_speed / 60) << friction << ", " << gravity;
        EXPECT_NEAR(value(run, Measure::kinetic_energy), 0, 1e-6);
    }
}

// Of the symplectic Euler rule with n substeps of h: x = g h^2 n (n + 1) / 2, v = g h n.
TEST(Sweep, ABodyFallsAsGravityAndDensitySay) {
    const SweepPart part = part_of(sweep_of({"gravity=4,8", "density=1,3", "substeps=2,4"}), make_falling);
    for (const SweepRun& run : part.runs) {
        const auto places = part.sweep.places(run.index);
        const double gravity = part.sweep.axes[0].values[places[0]], density = part.sweep.axes[1].values[places[1]];
        const double n = 60 * part.sweep.axes[2].values[places[2]], h = 1 / n;
        EXPECT_NEAR(value(run, Measure::drift), gravity * h * h * n * (n + 1) / 2, 1e-4);
        const double mass = density * 3.14159265358979 * 0.25;
        EXPECT_NEAR(value(run, Measure::kinetic_energy), mass * gravity * gravity / 2, 1e-3);
        EXPECT_TRUE(std::isnan(value(run, Measure::sleep_time))) << "it never sleeps";
    }
}

TEST(Sweep, EveryParameterChangesTheScene) {
    for (const std::string& name : parameter_names()) {
        const bool is_flag = name == "enable_sleep" || name == "continuous" || name == "warm_start" || name == "block_contacts" || name == "measure_residual";
        std::uint64_t hashes[2];
        for (int i = 0; i < 2; ++i) {
            const char* const* const names = value_names(name);
            const Sweep sweep = sweep_of({name + "=" + (names != nullptr ? names[i] : is_flag ? std::to_string(i) : i == 0 ? "1" : "2")});
            const Scene scene = scene_of(sweep, make_sliding, 0);
            // All numbers that a parameter may have changed.
            const SolverDef& s = scene.world.solver;
            const WorldDef& w = scene.world;
            const BodyDef& b = scene.bodies[1].def;
            const ShapeDef& d = scene.bodies[1].shapes[0].def;
            const float numbers[] = {w.gravity.x,
                                     w.gravity.y,
                                     float(w.enable_sleep),
                                     w.restitution_threshold,
                                     w.max_speed,
                                     w.hit_threshold,
                                     float(w.continuous),
                                     scene.dt,
                                     float(s.substeps),
                                     float(s.iterations),
                                     float(s.relax_iterations),
                                     s.contact_hertz,
                                     s.contact_damping_ratio,
                                     s.contact_push_speed,
                                     s.joint_hertz,
                                     s.joint_damping_ratio,
                                     s.baumgarte,
                                     s.omega,
                                     float(s.warm_start),
                                     s.joint_tree_load,
                                     float(s.block_contacts),
                                     s.shock,
                                     float(s.measure_residual),
                                     s.tolerance,
                                     float(s.schedule),
                                     float(s.joint_trees),
                                     float(s.sweep_order),
                                     b.linear_damping,
                                     b.angular_damping,
                                     b.gravity_scale,
                                     d.friction,
                                     d.restitution,
                                     d.rolling_resistance,
                                     d.density};
            hashes[i] = std::hash<std::string_view>()({reinterpret_cast<const char*>(numbers), sizeof numbers});
        }
        EXPECT_NE(hashes[0], hashes[1]) << name;
    }
}

TEST(Sweep, ChoicesGoByTheirNames) {
    const Sweep sweep = sweep_of({"gravity=5,10", "schedule=classic,soft"}, 1);
    EXPECT_EQ(scene_of(sweep, make_sliding, 0).world.solver.schedule, Schedule::classic);
    EXPECT_EQ(scene_of(sweep, make_sliding, 1).world.solver.schedule, Schedule::soft);
    const SweepPart part = part_of(sweep, make_sliding);
    const SweepTable table = tabulate(part);
    EXPECT_NE(table_of(sweep, table).find("classic"), std::string::npos);
    EXPECT_NE(json_of(sweep, table).find("\"schedule\": \"classic\""), std::string::npos);
    EXPECT_NE(csv_of(part).find("\n0,5,classic,0,"), std::string::npos);
    EXPECT_NE(plot_of(sweep, table).find(">schedule classic</text>"), std::string::npos);
    EXPECT_EQ(manifest_of(read_manifest(manifest_of(part))), manifest_of(part));

    EXPECT_SAYS("schedule is one of soft, classic, not 'hard'", read_axis("schedule=soft,hard"));
    EXPECT_SAYS("schedule is one of soft, classic, not '0'", read_axis("schedule=0,1"));
    EXPECT_SAYS("schedule is one of soft, classic, not '0:1:2'", read_axis("schedule=0:1:2"));
    EXPECT_SAYS("a plot goes along numbers", plot_of(sweep_of({"schedule=soft"}), table));
}

TEST(Sweep, SeedZeroIsTheSceneAndOthersNudgeIt) {
    const Sweep sweep = sweep_of({}, 5);
    const Scene plain = find_scene("pyramid")->make();
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        const Scene scene = scene_of(sweep, scene_of_catalogue("pyramid"), seed);
        double most = 0;
        for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
            const Vec2 by = scene.bodies[i].def.position - plain.bodies[i].def.position;
            const bool is_fixed = scene.bodies[i].def.type != BodyType::dynamic;
            EXPECT_TRUE(!is_fixed || (by == Vec2{0, 0}));
            most = std::max({most, std::abs(double(by.x)), std::abs(double(by.y))});
        }
        EXPECT_EQ(most > 0.0005, seed > 0);
        EXPECT_TRUE(seed > 0 || most == 0);
        EXPECT_LE(most, 0.001 + 1e-5);  // and the rounding of coordinates of some 10 m
    }
    IsletEngine engine;
    engine.load(plain);
    for (int step = 0; step < plain.steps; ++step) engine.advance(plain, step, plain.dt);
    const SweepPart part = part_of(sweep, scene_of_catalogue("pyramid"));
    EXPECT_EQ(part.runs[0].hash, engine.world().hash());
    EXPECT_NE(part.runs[1].hash, part.runs[0].hash);
    EXPECT_NE(part.runs[2].hash, part.runs[1].hash);
}

TEST(Sweep, ResultsDoNotDependOnThreadsOrShards) {
    const SceneMaker make = scene_of_catalogue("card_house");
    Sweep sweep = sweep_of({"friction=0.3:0.7:3", "substeps=2,4"}, 4);
    sweep.steps = 60;
    const SweepPart one = part_of(sweep, make, 1);
    EXPECT_EQ(manifest_of(one), manifest_of(part_of(sweep, make, 4)));
    for (const std::uint64_t shards : {2u, 5u, 30u}) {
        std::vector<SweepPart> parts;
        for (std::uint64_t shard = shards; shard-- > 0;) parts.push_back(read_manifest(manifest_of(part_of(sweep, make, 2, shard, shards))));
        const SweepPart whole = merge(parts, std::vector<std::string>(parts.size(), "part"));
        EXPECT_EQ(manifest_of(whole), manifest_of(one)) << shards << " shards";
        EXPECT_EQ(json_of(whole.sweep, tabulate(whole)), json_of(one.sweep, tabulate(one)));
        EXPECT_EQ(table_of(whole.sweep, tabulate(whole)), table_of(one.sweep, tabulate(one)));
        EXPECT_EQ(csv_of(whole), csv_of(one));
    }
}

TEST(Sweep, PartsThatDoNotFitAreRefused) {
    const Sweep sweep = sweep_of({"gravity=5,10"}, 3);
    const SweepPart first = part_of(sweep, make_falling, 1, 0, 2), second = part_of(sweep, make_falling, 1, 1, 2);
    const std::vector<std::string> names = {"a", "b", "c"};
    EXPECT_EQ(complaint([&] { merge({first, second, first}, names); }), "nothing") << "the same runs twice agree";
    EXPECT_SAYS("3 of 6 runs are missing, the first is 0", merge({second}, names));
    SweepPart wrong = first;
    wrong.runs[1].hash ^= 1;
    EXPECT_SAYS("'a' and 'c' differ in run 2: hash", merge({first, second, wrong}, names));
    SweepPart other = second;
    other.sweep.seeds = 4;
    EXPECT_SAYS("'a' and 'b' are of two sweeps", merge({first, other}, names));
    other = second;
    other.sweep.fingerprint ^= 1;
    EXPECT_SAYS("two sweeps", merge({first, other}, names));
}

TEST(Sweep, DamagedManifestsAreRefused) {
    const std::string good = manifest_of(part_of(sweep_of({"gravity=5,10"}, 2), make_falling));
    EXPECT_EQ(manifest_of(read_manifest(good)), good);
    EXPECT_SAYS("no whole manifest", read_manifest(""));
    EXPECT_SAYS("no manifest of a sweep", read_manifest("[]"));
    EXPECT_SAYS("no manifest of a sweep", read_manifest("{\"scene\": 1}"));
    EXPECT_SAYS("of format 9", read_manifest("{\"islet_sweep\": 9}"));
    for (std::size_t length = 0; length + 1 < good.size(); length += 7) EXPECT_SAYS("no whole manifest", read_manifest(good.substr(0, length)));
    const auto with = [&good](const std::string& from, const std::string& to) {
        std::string text = good;
        return text.replace(text.find(from), from.size(), to);
    };
    EXPECT_SAYS("16 hexadecimal digits", read_manifest(with("\"hash\": \"", "\"hash\": \"x")));
    EXPECT_SAYS("a run 77, of 4", read_manifest(with("\"run\": 1", "\"run\": 77")));
    EXPECT_SAYS("no whole manifest", read_manifest(with("\"run\": 1", "\"run\": \"1\"")));
    EXPECT_SAYS("no runs, or more", read_manifest(with("\"seeds\": 2", "\"seeds\": 2000000000")));
    EXPECT_SAYS("no runs, or more", read_manifest(with("\"seeds\": 2", "\"seeds\": 0")));
}

TEST(Sweep, FiguresAreSmallestMeanAndLargest) {
    SweepPart part{sweep_of({"gravity=5,10"}, 2), {}};
    for (std::uint64_t i = 0; i < 4; ++i) {
        SweepRun run;
        run.index = run.hash = i;
        run.values.fill(static_cast<double>(i * i));
        if (i == 3) run.values[static_cast<std::size_t>(Measure::sleep_time)] = std::nan("");
        part.runs.push_back(run);
    }
    const SweepTable table = tabulate(part);
    ASSERT_EQ(table.points.size(), 2u);
    const SweepFigure& drift = table.points[1].figures[0];
    EXPECT_EQ(drift.count, 2u);
    EXPECT_EQ(drift.least, 4);
    EXPECT_EQ(drift.mean, 6.5);
    EXPECT_EQ(drift.most, 9);
    const SweepFigure& sleep = table.points[1].figures[static_cast<std::size_t>(Measure::sleep_time)];
    EXPECT_EQ(sleep.count, 1u);
    EXPECT_EQ(sleep.mean, 4);
    EXPECT_NE(table.points[0].hash, table.points[1].hash);
    std::swap(part.runs[0].hash, part.runs[1].hash);
    EXPECT_NE(tabulate(part).points[0].hash, table.points[0].hash) << "the order of seeds counts";
}

TEST(Sweep, ThePictureHasASeriesForEachOtherParameter) {
    const SweepPart part = part_of(sweep_of({"friction=0.2:0.8:4", "gravity=5,10"}, 2), make_sliding);
    const std::string svg = plot_of(part.sweep, tabulate(part));
    EXPECT_NE(svg.find(">gravity 5</text>"), std::string::npos);
    EXPECT_NE(svg.find(">gravity 10</text>"), std::string::npos);
    EXPECT_NE(svg.find(">drift, m</text>"), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
}

}  // namespace
