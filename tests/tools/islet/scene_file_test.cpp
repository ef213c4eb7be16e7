// Scenes as files: what is written is the same scene when it is read, to the bit, and what is no scene is refused with its place.
#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <stdexcept>
#include <string>

#include "scene_files/printable.hpp"
#include "harness/engine.hpp"
#include "islet/html.hpp"
#include "islet/movie_maker.hpp"
#include "islet/report.hpp"
#include "islet/runner.hpp"
#include "scene_files/scene_file.hpp"
#include "islet/svg.hpp"
#include "scenes/catalogue.hpp"
#include "support/sanitized.hpp"

namespace {

using namespace islet;
using namespace islet::samples;
using namespace islet::tools;

std::uint64_t hash_after(const Scene& scene, int steps) {
    IsletEngine engine;
    engine.load(scene);
    for (int i = 0; i < steps; ++i) engine.advance(scene, i, scene.dt);
    return engine.world().hash();
}

class SceneFile : public testing::TestWithParam<SceneInfo> {};

// Of scenes with a script the start alone: every type of joint and every field that a scene of the catalogue sets is in one of them.
TEST_P(SceneFile, GivesTheSameBitsWhenItIsReadBack) {
    const Scene scene = GetParam().make();
    const std::string text = write_scene(scene);
    const Scene read = read_scene(text);
    EXPECT_EQ(write_scene(read), text);
    EXPECT_EQ(read.name, scene.name);
    EXPECT_EQ(read.steps, scene.steps);
    EXPECT_EQ(read.traced, scene.traced);
    EXPECT_EQ(capacity_of(read).contacts, capacity_of(scene).contacts - 7 * scene.extra_shapes);
    const bool is_large = std::string(GetParam().group) == "benchmark";
    if (!has_script(scene)) {
        EXPECT_EQ(hash_after(read, is_large ? 2 : 60), hash_after(scene, is_large ? 2 : 60));
        return;
    }
    // Room for what a script makes is no part of the state, nor is it in the file.
    Scene bare = scene;
    bare.before_step = nullptr;
    bare.after_step = nullptr;
    bare.world.hooks = {};
    EXPECT_EQ(hash_after(read, 2), hash_after(bare, 2));
}

INSTANTIATE_TEST_SUITE_P(Scenes, SceneFile, testing::ValuesIn(catalogue()), [](const auto& test) { return std::string(test.param.name); });

/// What read_scene says of a text that is no scene.
std::string refusal(const std::string& text) {
    try {
        read_scene(text);
    } catch (const SceneFileError& error) {
        return error.what();
    }
    return "it is a scene";
}

TEST(SceneFiles, TellTheDefaultsWhereTheyAreSilent) {
    const Scene scene = read_scene("{}");
    EXPECT_EQ(scene.steps, Scene{}.steps);
    EXPECT_EQ(scene.world.gravity, WorldDef{}.gravity);
    EXPECT_TRUE(scene.bodies.empty());
    EXPECT_EQ(refusal("{}"), "it is a scene");
}

TEST(SceneFiles, TakeFieldsByTheirNames) {
    const Scene scene = read_scene(R"({
        "dt": 0.01, "view": [-1, -2, 3, 4], "world": {"gravity": [0, -3], "solver": {"substeps": 8, "sweep_order": "upward"}},
        "bodies": [{"type": "kinematic", "position": [1, 2], "bullet": true,
                    "shapes": [{"polygon": {"points": [[0, 0], [1, 1], [1, 0]], "radius": 0.1}, "filter": {"mask": 6, "group": -2}, "sensor": true}]},
                   {"shapes": [{"chain": {"points": [[0, 0], [1, 0], [1, 1]], "loop": true}}]}, {"type": "dynamic"}],
        "joints": [{"type": "mouse", "body": 2, "target": [5, 6], "max_force": 7}, {"type": "wheel", "body_a": 0, "body_b": 2, "spring": {"hertz": 9}}]})");
    EXPECT_EQ(scene.dt, 0.01f);
    EXPECT_EQ(scene.view.upper, (Vec2{3, 4}));
    EXPECT_EQ(scene.world.gravity, (Vec2{0, -3}));
    EXPECT_EQ(scene.world.solver.substeps, 8u);
    EXPECT_EQ(scene.world.solver.sweep_order, SweepOrder::upward);
    EXPECT_EQ(scene.bodies[0].def.type, BodyType::kinematic);
    EXPECT_TRUE(scene.bodies[0].def.bullet);
    const SceneShape& shape = scene.bodies[0].shapes[0];
    EXPECT_EQ(std::get<Polygon>(shape.geometry).count, 3u);
    EXPECT_EQ(std::get<Polygon>(shape.geometry).radius, 0.1f);
    EXPECT_EQ(shape.def.filter.mask, 6u);
    EXPECT_EQ(shape.def.filter.group, -2);
    EXPECT_TRUE(shape.def.sensor);
    EXPECT_TRUE(std::get<Chain>(scene.bodies[1].shapes[0].geometry).loop);
    EXPECT_EQ(scene.joints[0].body_b, 2u);
    EXPECT_EQ(std::get<MouseJointDef>(scene.joints[0].def).max_force, 7);
    EXPECT_EQ(std::get<WheelJointDef>(scene.joints[1].def).spring.hertz, 9);
    EXPECT_TRUE(std::get<WheelJointDef>(scene.joints[1].def).spring.enable) << "a wheel's own default";
}

TEST(SceneFiles, AreRefusedWithThePlaceThatIsWrong) {
    struct Case {
        const char *text, *refusal;
    };
    constexpr Case cases[] = {
        {"", "line 1, column 1: here it ceases to be JSON"},
        {"{\n \"steps\": 3,,\n}", "line 2, column 13: here it ceases to be JSON"},
        {"[]", "the file: must be an object, not a list"},
        {R"({"steps": 3, "dt": 0.01, "steps": 4})", "steps: there are two such fields in one object"},
        {R"({"bodies": [{"angle": 1}, {"angle": 1, "position": [0, 0], "angle": 2}]})", "angle: there are two such fields in one object"},
        {R"({"step": 3})", "step: there is no such field; near names: steps"},
        {R"({": zzzzzzzzzz": 3})", "\": zzzzzzzzzz\": there is no such field"},
        {R"({"steps": 3.5})", "steps: must be a whole number, not a number like 3.5"},
        {R"({"steps": -1})", "steps: must be from 0 to 100000000"},
        {R"({"steps": 99999999999999999999})", "steps: must be a whole number, not a number like 1e+20"},
        {R"({"dt": 0})", "dt: must be from 1e-06 to 1 s"},
        {R"({"dt": 1e-9})", "dt: must be from 1e-06 to 1 s"},
        {R"({"view": [0, 0, 1]})", "view: must be a list of 4 numbers"},
        {R"({"view": [1, 0, 0, 1]})", "view: must be [left, bottom, right, top]"},
        {R"({"traced": [0]})", "traced: there is no body 0; there are 0, and the first is 0"},
        {R"({"traced": [-1]})", "traced[0]: must be from 0 to 18446744073709551615"},
        {R"({"world": {"gravity": [0, "down"]}})", "world.gravity[1]: must be a number, not a word"},
        {R"({"world": {"gravity": [0, 1e39]}})", "world.gravity[1]: is too large a number"},
        {R"({"world": {"solver": {"sweep_order": "sideways"}}})", "world.solver.sweep_order: must be colored, as_found, upward or downward"},
        {R"({"bodies": {}})", "bodies: must be a list, not an object"},
        {R"({"bodies": [{}, {"type": "heavy"}]})", "bodies[1].type: must be static, kinematic or dynamic"},
        {R"({"bodies": [{"awake": 1}]})", "bodies[0].awake: must be true or false, not a number like 1"},
        {R"({"bodies": [{"shapes": [{}]}]})", "bodies[0].shapes[0]: must have one geometry: a circle, capsule, segment, box, polygon, chain or half_space"},
        {R"({"bodies": [{"shapes": [{"circle": {}, "box": [1, 1]}]}]})",
         "bodies[0].shapes[0]: must have one geometry: a circle, capsule, segment, box, polygon, chain or half_space"},
        {R"({"bodies": [{"shapes": [{"circle": {"radius": 0}}]}]})",
         "bodies[0].shapes[0].circle: is no sound geometry: sizes must be above 0, points apart, and corners those of a convex polygon"},
        {R"({"bodies": [{"shapes": [{"polygon": {"points": [[0, 0], [1, 0]]}}]}]})", "bodies[0].shapes[0].polygon.points: must be 3 to 8 corners"},
        {R"({"bodies": [{"shapes": [{"polygon": {}}]}]})", "bodies[0].shapes[0].polygon: \"points\" is missing"},
        {R"({"bodies": [{"shapes": [{"polygon": {"points": [[0, 0], [1, 0], [0, 1]], "normals": [[0, -1]]}}]}]})",
         "bodies[0].shapes[0].polygon.normals: must be as many as there are points"},
        {R"({"bodies": [{"shapes": [{"polygon": {"points": [[0, 0], [1, 0], [0, 1]], "normals": [[0, 1], [1, 0], [0, 0]]}}]}]})",
         "bodies[0].shapes[0].polygon: is no sound geometry: sizes must be above 0, points apart, and corners those of a convex polygon"},
        {R"({"bodies": [{}], "joints": [{"type": "weld", "body_a": 0, "body_b": 1}]})", "joints[0].body_b: there is no body 1; there are 1, and the first is 0"},
        {R"({"bodies": [{}], "joints": [{"type": "glue"}]})",
         "joints[0].type: must be revolute, prismatic, distance, weld, wheel, motor, mouse, pulley, gear or angle"},
        {R"({"bodies": [{}], "joints": [{"type": "gear", "joint1": 0, "joint2": 1}]})",
         "joints[0].joint1: there is no joint before this one 0; there are 0, and the first is 0"},
        {R"({"bodies": [{}, {}], "joints": [{"type": "weld", "body_a": 0, "body_b": 1, "motor": {}}]})", "joints[0].motor: there is no such field"},
    };
    for (const Case& c : cases) EXPECT_EQ(refusal(c.text), c.refusal) << c.text;
}

// A name is any text; a picture of the scene must stay XML, which holds no control characters and no bare brackets.
TEST(SceneFiles, NamesLeaveAPictureWhole) {
    tools::Run run(read_scene(R"({"name": "a\u0001\u0000<b>", "steps": 1})"), {});
    run.run({});
    const std::string picture = draw_svg(run, usual_drawing());
    EXPECT_NE(picture.find("<title>a  &lt;b&gt;</title>"), std::string::npos) << picture;
    EXPECT_EQ(picture.find('\0'), std::string::npos);
    EXPECT_EQ(picture.find('\1'), std::string::npos);
}

// Of U+FFFF and its like XML has no form at all, and a file's name may be of bytes that are no UTF-8.
TEST(SceneFiles, NamesThatAreNoTextLeavePicturesAndPagesWhole) {
    tools::Run run(read_scene(R"({"name": "a\uffff\ufffe\u0085\u001bé\ud83d\ude00&lt;", "steps": 1})"), {});
    MovieMaker movie(run);
    const RunResult result = run.run([&](const StepRecord& step) { movie.observe(step); });
    const std::string fffd = "\xef\xbf\xbd", shown = "a" + fffd + fffd + "  \xc3\xa9\xf0\x9f\x98\x80";
    EXPECT_NE(draw_svg(run, usual_drawing()).find("<title>" + shown + "&amp;lt;</title>"), std::string::npos);
    const std::string page = player_page(run, result, movie);
    EXPECT_NE(page.find("<title>" + shown + "&amp;lt;"), std::string::npos);
    EXPECT_EQ(page.find("\xef\xbf\xbf"), std::string::npos);
    EXPECT_EQ(table_of(result).substr(0, shown.size()), shown);
    EXPECT_EQ(printable("\xff\xc0\x80\xed\xa0\x80\xf4\x90\x80\x80 \xe2\x82"), fffd + fffd + fffd + fffd + fffd + fffd + fffd + fffd + fffd + fffd + " " + fffd + fffd);
}

// The grid had a line for every few metres of it, without end.
TEST(SceneFiles, ViewsOfAnyShapeGiveAPicture) {
    for (const char* view : {"[-5, -9223372036854775808, 5, 5]", "[-3e38, -1, 3e38, 1]", "[0, 0, 1e-38, 3e38]", "[0, 0, 1e-38, 1e-38]", "[-3e38, -3e38, 3e38, 3e38]",
                             "[16777215, 16777215, 16777216, 16777216]", "[0, 0, 3e38, 1e-38]"}) {
        tools::Run run(read_scene(std::string(R"({"view": )") + view + R"(, "steps": 1, "bodies": [{"shapes": [{"box": [5, 0.5]}]}]})"), {});
        run.run({});
        const std::string picture = draw_svg(run, usual_drawing());
        EXPECT_LT(picture.size(), 20'000u) << view;
        EXPECT_NE(picture.find("</svg>"), std::string::npos);
        EXPECT_EQ(picture.find("nan"), std::string::npos) << view;
        EXPECT_EQ(picture.find("inf"), std::string::npos) << view;
    }
}

std::string many_bodies(int count) {
    std::string text = "{\"bodies\": [{}";
    for (int i = 1; i < count; ++i) text += ",\n{\"type\": \"dynamic\", \"position\": [" + std::to_string(i) + ", 0], \"shapes\": [{\"circle\": {\"radius\": 0.5}}]}";
    return text;
}

/// Processor time, s; the least of three.
template <class Work>
double time_of(const Work& work) {
    double least = 1e9;
    for (int i = 0; i < 3; ++i) {
        const std::clock_t start = std::clock();
        work();
        least = std::min(least, double(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return least;
}

// Eight times the bodies take eight times as long (and a cache that is too small): not 64 times. With a tenth of the bodies what is square shows less:
// under sanitizers, where only memory counts.
TEST(SceneFiles, AreReadInLinearTime) {
    constexpr int count = test::sanitized ? 1000 : 10'000;
    const std::string few = many_bodies(count), many = many_bodies(8 * count);
    const double reading = time_of([&] { read_scene(few + "]}"); });
    EXPECT_LT(time_of([&] { read_scene(many + "]}"); }), 16 * reading);
    const double refusing = time_of([&] { refusal(few + "}"); });
    EXPECT_LT(time_of([&] { refusal(many + "}"); }), 16 * refusing);
    const std::string last_line = "line " + std::to_string(8 * count) + ",";
    EXPECT_EQ(refusal(many + "}").substr(0, last_line.size()), last_line);
}

TEST(SceneFiles, AskForNoMoreContactsThanTheirShapesCouldHave) {
    EXPECT_EQ(refusal(R"({"extra_contacts": 4160})"), "it is a scene");
    EXPECT_EQ(refusal(R"({"extra_contacts": 10000000})"), "extra_contacts: must be at most 4160: 4096, and 64 for each shape");
}

TEST(SceneFiles, TellWhichNumberIsTooLarge) { EXPECT_EQ(refusal("{\"steps\":\n 1e999}"), "line 2, column 6: the number 1e999 is too large"); }

/// What the engine says of a scene that read_scene takes.
std::string engines_refusal(const std::string& text) {
    try {
        IsletEngine engine;
        engine.load(read_scene(text));
    } catch (const std::runtime_error& error) {
        return std::string(error.what()).substr(0, std::string(error.what()).find(':'));
    }
    return "it is a scene";
}

// What only the engine can tell is said with its place too.
TEST(SceneFiles, TheFieldThatTheEngineRefusesIsNamed) {
    const std::string circle = R"({"circle": {}})", body = R"({"type": "dynamic", "shapes": [)" + circle + "]}";
    EXPECT_EQ(engines_refusal(R"({"bodies": [{}, {"shapes": [)" + circle + R"(, {"circle": {}, "friction": -1}]}]})"), "bodies[1].shapes[1].friction");
    EXPECT_EQ(engines_refusal(R"({"bodies": [{"shapes": [{"circle": {}, "density": -1, "restitution": -2}]}]})"), "bodies[0].shapes[0].density");
    EXPECT_EQ(engines_refusal(R"({"bodies": [{"angular_damping": -1}]})"), "bodies[0].angular_damping");
    EXPECT_EQ(engines_refusal(R"({"bodies": [{"shapes": [{"chain": {"points": [[0, 0], [0, 0], [1, 0], [2, 0]]}}]}]})"), "bodies[0].shapes[0].chain");
    EXPECT_EQ(engines_refusal(R"({"world": {"solver": {"substeps": 0}}})"), "world.solver.substeps");
    EXPECT_EQ(engines_refusal(R"({"bodies": [{}, )" + body + R"(], "joints": [{"type": "weld", "body_a": 0, "body_b": 1},
        {"type": "revolute", "body_a": 0, "body_b": 1, "motor": {"max_force": -1}}]})"), "joints[1].motor.max_force");
}

// What it takes to refuse a file grows with the file, however many fields it has and however deep it goes: under sanitizers too this is a matter of a second.
TEST(SceneFiles, LargeOnesThatAreNoSceneAreRefusedSoon) {
    std::string many = "{\"steps\": 1";
    for (int i = 0; i < 50'000; ++i) many += ", \"" + std::to_string(i) + "\": 0";
    EXPECT_EQ(refusal(many + "}").substr(0, 26), "0: there is no such field;");
    std::string deep(300'000, '['), deeper = "{\"bodies\": " + deep + std::string(300'000, ']') + "}";
    EXPECT_EQ(refusal(deep), "line 1, column 300001: here it ceases to be JSON");
    EXPECT_EQ(refusal(deeper), "bodies[0]: must be an object, not a list");
}

// Whatever is cut off or changed, a file is read or refused: nothing else happens. Sanitizers watch.
TEST(SceneFiles, TornAndScribbledOnesAreReadOrRefused) {
    std::string whole = write_scene(find_scene("seesaw")->make());
    whole.pop_back();  // the last line's end
    for (std::size_t size = 0; size < whole.size(); ++size) ASSERT_NE(refusal(whole.substr(0, size)), "it is a scene") << size;
    EXPECT_EQ(refusal(whole), "it is a scene");
    for (std::size_t at = 0; at < whole.size(); at += 3) {
        for (const char c : {'"', '-', '9', '{', ']'}) {
            std::string scribbled = whole;
            scribbled[at] = c;
            refusal(scribbled);
        }
    }
}

}  // namespace
