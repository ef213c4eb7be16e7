// DebugDraw: how joints look.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "sketch.hpp"

namespace {

using namespace sketch;

TEST(DebugDraw, NamesAreSlotsAndTypesOfJoints) {
    TestWorld w;
    add_machine(*w, {0, 0});
    Sketch sketch;
    sketch.ask_for_nothing();
    sketch.draw.names = true;
    std::vector<std::string> words, wanted;
    for (const Call& call : sketch.of(*w)) {
        EXPECT_EQ(call.style.part, DrawPart::name);
        words.push_back(call.text);
    }
    for (std::uint32_t slot = 1; slot < machine_bodies; ++slot) wanted.push_back(std::to_string(slot));
    for (const JointType type : joint_types) wanted.emplace_back(name_of(type));
    EXPECT_EQ(words, wanted);
}

/// The machine's joint of each type as it is drawn, relative to its first point.
std::map<JointType, std::vector<Call>> drawn_machine(Sketch& sketch, const World& w) {
    std::map<JointType, std::vector<Call>> drawn;
    for (const Call& call : sketch.part(w, DrawPart::joint)) drawn[w.joint_type(w.joint_at(call.style.slot))].push_back(call);
    return drawn;
}

std::string kinds_of(const std::vector<Call>& calls) {
    std::map<std::string, int> count;
    for (const Call& call : calls) ++count[call.kind + (call.style.color == draw_color::limit ? " of a limit" : "")];
    std::string text;
    for (const auto& [kind, n] : count) text += std::to_string(n) + ' ' + kind + "; ";
    return text;
}

TEST(DebugDraw, EachTypeOfJointLooksDifferent) {
    TestWorld w;
    const Machine m = add_machine(*w, {0, 0});
    Sketch sketch;
    const auto drawn = drawn_machine(sketch, *w);
    ASSERT_EQ(drawn.size(), joint_type_count);
    std::set<std::string> looks;
    for (const auto& [type, calls] : drawn) {
        EXPECT_TRUE(looks.insert(kinds_of(calls)).second) << name_of(type) << " looks like another: " << kinds_of(calls);
        for (const Call& call : calls) EXPECT_FALSE(call.style.solid);
        if (type == JointType::gear) continue;
        std::vector<Vec2> dots;
        for (const Call& call : calls)
            if (call.kind == "point") dots.push_back(call.points[0]);
        ASSERT_EQ(dots.size(), 2u) << name_of(type);
        expect_near(dots[0], double(w->anchor_a(m[type]).x), double(w->anchor_a(m[type]).y));
        expect_near(dots[1], double(w->anchor_b(m[type]).x), double(w->anchor_b(m[type]).y));
    }
    EXPECT_EQ(kinds_of(drawn.at(JointType::gear)).find("point"), std::string::npos);
    EXPECT_EQ(drawn.at(JointType::gear)[0].kind, "circle");
    EXPECT_EQ(drawn.at(JointType::gear)[0].points[0], drawn.at(JointType::revolute).back().points[0]);  // around the hinge's point of B
}

TEST(DebugDraw, AHingesMarksAreItsRingHandAndLimits) {
    TestWorld w;
    const BodyId ground = w.add_ground();
    const BodyId door = w.add_box({3, 5});
    w->set_transform(door, {3, 5}, 0.5f);
    RevoluteJointDef def{.base = {.body_a = ground, .body_b = door}};
    def.base.frame_a.position = inv_transform_point(w->transform(ground), {3, 5});
    Sketch sketch;
    sketch.draw.size = 2;
    w->create_joint(def);
    EXPECT_EQ(kinds_of(sketch.part(*w, DrawPart::joint)), "1 circle; 2 point; 1 segment; ");  // the line to the door's centre, and none to the ground's
    w->destroy_joint(w.joints_of(door)[0]);
    def.limit = {.enable = true, .lower = 0, .upper = quarter};
    w->create_joint(def);
    const std::vector<Call> calls = sketch.part(*w, DrawPart::joint);
    EXPECT_EQ(kinds_of(calls), "1 circle; 2 point; 2 segment; 2 segment of a limit; ");
    std::vector<Call> lines;
    for (const Call& call : calls) {
        if (call.kind == "segment") lines.push_back(call);
        if (call.kind == "circle") {
            EXPECT_EQ(call.radius, 1);
        }
    }
    expect_near(lines[1].points[1], 3 + 2 * std::cos(0.5), 5 + 2 * std::sin(0.5));
    expect_near(lines[2].points[0], 4, 5);
    expect_near(lines[2].points[1], 5, 5);
    expect_near(lines[3].points[0], 3, 6);
    expect_near(lines[3].points[1], 3, 7);
}

TEST(DebugDraw, ARailReachesFromLimitToLimit) {
    TestWorld w;
    const BodyId ground = w.add_ground();
    const BodyId slider = w.add_box({3, 5});
    PrismaticJointDef def{.base = {.body_a = ground, .body_b = slider}};
    def.base.frame_a = {inv_transform_point(w->transform(ground), {3, 5}), quarter};
    def.base.frame_b.angle = quarter;
    def.limit = {.enable = true, .lower = -2, .upper = 7};
    w->create_joint(def);
    Sketch sketch;
    bool rail = false;
    std::vector<double> bars;
    for (const Call& call : sketch.part(*w, DrawPart::joint)) {
        if (call.kind == "polygon") {
            Vec2 middle = {};
            for (const Vec2 corner : call.points) middle += 0.25f * corner;
            expect_near(middle, 3, 5);
        }
        if (call.kind != "segment") continue;
        rail = rail || (distance(call.points[0], {3, 3}) < 1e-5f && distance(call.points[1], {3, 12}) < 1e-5f);
        if (call.style.color == draw_color::limit) bars.push_back(0.5 * double(call.points[0].y + call.points[1].y));
    }
    EXPECT_TRUE(rail);
    ASSERT_EQ(bars.size(), 2u);
    EXPECT_NEAR(bars[0], 3, 1e-5);
    EXPECT_NEAR(bars[1], 12, 1e-5);
}

}  // namespace
