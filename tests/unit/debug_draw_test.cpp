// DebugDraw: what reaches the user's functions is what the world holds, and only what is asked for and in view.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "support/busy_world.hpp"
#include "support/test_world.hpp"

namespace {

using namespace islet;
using namespace islet::test;

/// One call of one of the functions.
struct Call {
    std::string kind;
    std::vector<Vec2> points;  // of a circle: centre, axis
    float radius = 0;
    std::string text;
    DrawStyle style;
};

bool same(const Call& a, const Call& b) {
    return a.kind == b.kind && a.points == b.points && a.radius == b.radius && a.text == b.text && a.style.color == b.style.color &&
           a.style.part == b.style.part && a.style.solid == b.style.solid && a.style.slot == b.style.slot;
}

/// A DebugDraw that keeps its calls.
struct Sketch {
    DebugDraw draw;
    std::vector<Call> calls;

    Sketch() {
        draw.polygon = [](std::span<const Vec2> corners, float radius, const DrawStyle& style, void* self) {
            keep(self, {"polygon", {corners.begin(), corners.end()}, radius, "", style});
        };
        draw.circle = [](Vec2 center, float radius, Vec2 axis, const DrawStyle& style, void* self) {
            keep(self, {"circle", {center, axis}, radius, "", style});
        };
        draw.capsule = [](Vec2 a, Vec2 b, float radius, const DrawStyle& style, void* self) { keep(self, {"capsule", {a, b}, radius, "", style}); };
        draw.segment = [](Vec2 a, Vec2 b, const DrawStyle& style, void* self) { keep(self, {"segment", {a, b}, 0, "", style}); };
        draw.point = [](Vec2 p, const DrawStyle& style, void* self) { keep(self, {"point", {p}, 0, "", style}); };
        draw.text = [](Vec2 p, const char* words, const DrawStyle& style, void* self) { keep(self, {"text", {p}, 0, words, style}); };
        draw.context = this;
    }
    Sketch(const Sketch&) = delete;
    Sketch& operator=(const Sketch&) = delete;

    static void keep(void* self, Call call) { static_cast<Sketch*>(self)->calls.push_back(std::move(call)); }

    const std::vector<Call>& of(const World& w) {
        calls.clear();
        w.draw(draw);
        return calls;
    }
    std::vector<Call> part(const World& w, DrawPart part) {
        std::vector<Call> some;
        for (const Call& call : of(w))
            if (call.style.part == part) some.push_back(call);
        return some;
    }
    void ask_for_nothing() { draw.shapes = draw.joints = false; }
    void ask_for_everything() {
        draw.contacts = draw.normals = draw.impulses = draw.boxes = draw.fat_boxes = draw.tree = draw.centers = draw.names = true;
    }
};

void expect_near(Vec2 got, double x, double y, double tolerance = 1e-5) {
    EXPECT_NEAR(double(got.x), x, tolerance);
    EXPECT_NEAR(double(got.y), y, tolerance);
}

// A quarter turn at (3, 5): a point (x, y) of the body is at (3 - y, 5 + x).
constexpr float quarter = 0.5f * pi;

TEST(DebugDraw, EachTypeOfShapeIsDrawnWhereItIs) {
    TestWorld w;
    const auto turned = [](BodyType type) {
        BodyDef def;
        def.type = type;
        def.position = {3, 5};
        def.angle = quarter;
        return def;
    };
    w.add(Circle{{1, 0.5f}, 0.25f}, turned(BodyType::dynamic));
    w.add(Capsule{{-1, 0}, {2, 0.5f}, 0.4f}, turned(BodyType::kinematic));
    w.add(Segment{{0, -1}, {4, 1}}, turned(BodyType::static_body));
    w.add(make_rounded_box(2, 1, 0.1f), turned(BodyType::dynamic));
    const BodyId ground = w->create_body(turned(BodyType::static_body));
    const Vec2 chain[] = {{0, 0}, {-2, 0}, {-4, 1}, {-6, 1}};
    ASSERT_EQ(w->create_chain(ground, chain, false), 3u);

    Sketch sketch;
    const std::vector<Call> calls = sketch.of(*w);
    ASSERT_EQ(calls.size(), 7u);
    EXPECT_EQ(calls[0].kind, "circle");
    expect_near(calls[0].points[0], 2.5, 6);
    expect_near(calls[0].points[1], 0, 1);
    EXPECT_EQ(calls[0].radius, 0.25f);
    EXPECT_EQ(calls[1].kind, "capsule");
    expect_near(calls[1].points[0], 3, 4);
    expect_near(calls[1].points[1], 2.5, 7);
    EXPECT_EQ(calls[1].radius, 0.4f);
    EXPECT_EQ(calls[2].kind, "segment");
    expect_near(calls[2].points[0], 4, 5);
    expect_near(calls[2].points[1], 2, 9);
    EXPECT_EQ(calls[3].kind, "polygon");
    EXPECT_EQ(calls[3].radius, 0.1f);
    ASSERT_EQ(calls[3].points.size(), 4u);
    double area = 0;  // of the corners, by the shoelace formula: positive is counter-clockwise
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec2 p = calls[3].points[i], q = calls[3].points[(i + 1) % 4];
        EXPECT_NEAR(std::abs(double(p.x) - 3), 1, 1e-5);
        EXPECT_NEAR(std::abs(double(p.y) - 5), 2, 1e-5);
        area += 0.5 * double(cross(p, q));
    }
    EXPECT_NEAR(area, 8, 1e-4);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(calls[4 + i].kind, "segment");
        expect_near(calls[4 + i].points[0], 3 - double(chain[i].y), 5 + double(chain[i].x));
        expect_near(calls[4 + i].points[1], 3 - double(chain[i + 1].y), 5 + double(chain[i + 1].x));
    }
    for (std::size_t i = 0; i < calls.size(); ++i) {
        EXPECT_EQ(calls[i].style.part, DrawPart::shape);
        EXPECT_TRUE(calls[i].style.solid);
        EXPECT_EQ(calls[i].style.slot, std::min<std::size_t>(i, 4));
    }
}

TEST(DebugDraw, ColoursSayWhatABodyIs) {
    TestWorld w;
    w.add_ground();
    w.add_box({0, 4}, 0.5f, 0.5f, {}, BodyType::kinematic);
    w.add_box({3, 4});
    BodyDef asleep;
    asleep.type = BodyType::dynamic;
    asleep.position = {6, 4};
    asleep.awake = false;
    w.add(Circle{}, asleep);
    w.add(Circle{}, BodyDef{.type = BodyType::dynamic, .position = {9, 4}, .bullet = true});
    w.add(Circle{}, BodyDef{.type = BodyType::dynamic, .position = {12, 4}, .enabled = false});
    w.add(make_box(1, 1), Vec2{15, 4}, {.sensor = true}, BodyType::static_body);
    Sketch sketch;
    const std::vector<Call>& calls = sketch.of(*w);
    ASSERT_EQ(calls.size(), 7u);
    const DrawColor wanted[] = {draw_color::static_body, draw_color::kinematic, draw_color::awake, draw_color::asleep,
                                draw_color::bullet,      draw_color::disabled,  draw_color::sensor};
    for (std::size_t i = 0; i < 7; ++i) {
        EXPECT_EQ(calls[i].style.color, wanted[i]) << i;
        EXPECT_EQ(calls[i].style.solid, wanted[i] != draw_color::sensor) << i;
    }
    EXPECT_EQ(w->sensor_overlaps(w.shape_of(w.bodies()[6]), {}), 0u);  // whoever calls this has sensors linked
}

// The islands are worked out here by going from body to body over what World tells of contacts and joints until no label changes.
std::map<std::uint32_t, std::uint32_t> islands_by_flooding(const World& w) {
    std::map<std::uint32_t, std::uint32_t> label;
    for (std::uint32_t slot = 0; slot < w.capacity().bodies; ++slot) {
        const BodyId body = w.body_at(slot);
        if (body && w.type(body) == BodyType::dynamic) label[slot] = slot;
    }
    bool changed = true;
    const auto link = [&](BodyId a, BodyId b) {
        if (!a || !b) return;
        const auto at_a = label.find(a.index1 - 1), at_b = label.find(b.index1 - 1);
        if (at_a == label.end() || at_b == label.end() || at_a->second == at_b->second) return;
        at_a->second = at_b->second = std::min(at_a->second, at_b->second);
        changed = true;
    };
    while (changed) {
        changed = false;
        ContactInfo contact;
        for (std::uint32_t slot = 0; slot < w.capacity().contacts; ++slot)
            if (w.contact_at(slot, contact)) link(w.body(contact.shape_a), w.body(contact.shape_b));
        for (std::uint32_t slot = 0; slot < w.capacity().joints; ++slot)
            if (const JointId joint = w.joint_at(slot)) link(w.body_a(joint), w.body_b(joint));
    }
    return label;
}

TEST(DebugDraw, IslandsAreTheSetsThatContactsAndJointsHoldTogetherAsleepOrNot) {
    TestWorld w;
    w.add_ground();
    for (int tower = 0; tower < 4; ++tower)
        for (int i = 0; i < 3; ++i) w.add_box({4 * static_cast<float>(tower), 0.5f + static_cast<float>(i)});
    const BodyId left = w.add_circle({-10, 6}), right = w.add_circle({-12, 6}), lone = w.add_circle({-20, 9});
    join(*w, JointType::distance, left, right);
    for (int step = 0; step < 120; ++step) {
        w.step();
        if (step == 90) w->set_linear_velocity(w.bodies()[1], {0.1f, 0});  // one tower of those asleep wakes
        if (step % 30 != 29) continue;
        Sketch sketch;
        sketch.draw.body_colors = BodyColors::island;
        const auto wanted = islands_by_flooding(*w);
        std::set<std::uint32_t> roots;
        for (const Call& call : sketch.part(*w, DrawPart::shape)) {
            const auto island = wanted.find(call.style.slot);
            ASSERT_EQ(call.style.color, island == wanted.end() ? draw_color::static_body : distinct_color(island->second)) << "body " << call.style.slot;
            if (island != wanted.end()) roots.insert(island->second);
        }
        EXPECT_EQ(roots.size(), 6u);  // four towers, a pair of balls, a ball
    }
    EXPECT_FALSE(w->is_awake(w.bodies()[12]));
    EXPECT_TRUE(w->is_awake(lone));
}

TEST(DebugDraw, AGearHoldsItsFourBodiesTogether) {
    TestWorld w;
    const BodyId a = w.add_box({0, 0}), b = w.add_box({2, 0}), c = w.add_box({20, 0}), d = w.add_box({22, 0}), other = w.add_box({40, 0});
    const JointId first = join(*w, JointType::revolute, a, b), second = join(*w, JointType::revolute, c, d);
    Sketch sketch;
    sketch.draw.body_colors = BodyColors::island;
    const auto colors = [&] {
        std::vector<DrawColor> list;
        for (const Call& call : sketch.part(*w, DrawPart::shape)) list.push_back(call.style.color);
        return list;
    };
    const DrawColor of_a = distinct_color(a.index1 - 1), of_c = distinct_color(c.index1 - 1), of_other = distinct_color(other.index1 - 1);
    EXPECT_EQ(colors(), (std::vector<DrawColor>{of_a, of_a, of_c, of_c, of_other}));
    ASSERT_TRUE(w->create_joint(GearJointDef{.joint1 = first, .joint2 = second}));
    EXPECT_EQ(colors(), (std::vector<DrawColor>{of_a, of_a, of_a, of_a, of_other}));
}

TEST(DebugDraw, AGearHoldsWheelsOnTheGroundTogether) {
    TestWorld w;
    const BodyId ground = w.add_ground(), a = w.add_circle({0, 4}), b = w.add_circle({8, 4});
    const JointId first = join(*w, JointType::revolute, ground, a), second = join(*w, JointType::revolute, ground, b);
    Sketch sketch;
    sketch.draw.body_colors = BodyColors::island;
    EXPECT_NE(sketch.part(*w, DrawPart::shape)[1].style.color, sketch.part(*w, DrawPart::shape)[2].style.color);
    ASSERT_TRUE(w->create_joint(GearJointDef{.joint1 = first, .joint2 = second}));
    EXPECT_EQ(sketch.part(*w, DrawPart::shape)[1].style.color, sketch.part(*w, DrawPart::shape)[2].style.color);
}

TEST(DebugDraw, WhatIsDisabledHoldsNothingTogether) {
    TestWorld w;
    const BodyId a = w.add_box({0, 0}), b = w.add_box({4, 0}), c = w.add_box({8, 0});
    join(*w, JointType::distance, a, b);
    join(*w, JointType::distance, b, c);
    Sketch sketch;
    sketch.draw.body_colors = BodyColors::island;
    const auto color_of = [&](BodyId body) {
        for (const Call& call : sketch.part(*w, DrawPart::shape))
            if (call.style.slot == body.index1 - 1) return call.style.color;
        return DrawColor{0};
    };
    EXPECT_EQ(color_of(c), color_of(a));
    w->set_enabled(b, false);
    EXPECT_NE(color_of(c), color_of(a));
    EXPECT_EQ(color_of(b), draw_color::disabled);
    for (const Call& call : sketch.part(*w, DrawPart::joint)) EXPECT_EQ(call.style.color, draw_color::idle_joint);
}

TEST(DebugDraw, DistinctColoursAre) {
    // Any two of eight in a row differ by a tenth of the way from black to white at least, in the brightest of their three parts.
    for (std::uint32_t n = 0; n < 300; ++n) {
        for (std::uint32_t m = n + 1; m < n + 8; ++m) {
            int most = 0;
            for (int shift = 0; shift < 24; shift += 8) {
                const int p = static_cast<int>(distinct_color(n) >> shift & 255u), q = static_cast<int>(distinct_color(m) >> shift & 255u);
                most = std::max(most, std::abs(p - q));
            }
            ASSERT_GE(most, 26) << n << " and " << m;
        }
        ASSERT_LE(distinct_color(n), 0xffffffu);
    }
}

TEST(DebugDraw, ContactsAreThoseOfTheWorld) {
    TestWorld w;
    w.add_ground();
    for (int i = 0; i < 4; ++i) w.add_box({0.1f * static_cast<float>(i), 0.5f + static_cast<float>(i)});
    w.step(20);
    Sketch sketch;
    sketch.ask_for_nothing();
    sketch.draw.contacts = sketch.draw.normals = sketch.draw.impulses = true;
    sketch.draw.size = 0.5f;
    sketch.draw.impulse_scale = 3;
    const std::vector<Call> points = sketch.part(*w, DrawPart::contact), normals = sketch.part(*w, DrawPart::normal);
    const std::vector<Call> impulses = sketch.part(*w, DrawPart::impulse);
    std::size_t at = 0, drawn_impulses = 0;
    ContactInfo contact;
    for (std::uint32_t slot = 0; slot < w->capacity().contacts; ++slot) {
        if (!w->contact_at(slot, contact)) continue;
        for (std::uint32_t i = 0; i < contact.point_count; ++i, ++at) {
            ASSERT_LT(at, points.size());
            const ContactPoint& p = contact.points[i];
            ASSERT_EQ(p.normal_impulse > 0, true);
            EXPECT_EQ(points[at].points[0], p.point);
            EXPECT_EQ(points[at].style.slot, slot);
            EXPECT_EQ(points[at].style.color, draw_color::pressing);
            const Vec2 way = normals[at].points[1] - normals[at].points[0];
            expect_near(way, 0, 0.5, 1e-3);  // boxes on boxes: up, and A is the lower one
            // The push on what is above is upward, and as long as it is strong.
            const Call& push = impulses[drawn_impulses++];
            EXPECT_EQ(push.points[0], p.point);
            EXPECT_NEAR(double(push.points[1].y - push.points[0].y), 3 * double(p.normal_impulse), 1e-4);
            if (p.tangent_impulse == 0) continue;
            const Call& drag = impulses[drawn_impulses++];
            EXPECT_NEAR(double(drag.points[1].x - drag.points[0].x), 3 * double(p.tangent_impulse), 1e-4);  // right_perp of up is to the right
        }
    }
    EXPECT_EQ(points.size(), 8u);
    EXPECT_EQ(at, points.size());
    EXPECT_EQ(drawn_impulses, impulses.size());
}

// A crate that slides to the right on the ground is braked: the line drawn for friction on it points to the left.
TEST(DebugDraw, FrictionIsDrawnAsItActsOnB) {
    TestWorld w;
    w.add_ground();
    const BodyId crate = w.add_box({0, 0.5f});
    w.step(10);
    w->set_linear_velocity(crate, {4, 0});
    w.step(5);
    Sketch sketch;
    sketch.draw.impulses = true;
    double sum = 0;
    for (const Call& call : sketch.part(*w, DrawPart::impulse))
        if (call.style.color == draw_color::friction_impulse) sum += double(call.points[1].x - call.points[0].x);
    ContactInfo contact = w.contacts().at(0);
    const double sign = w->body(contact.shape_b) == crate ? -1 : 1;
    EXPECT_GT(sign * sum, 1e-3);
}

TEST(DebugDraw, BoxesHoldTheirShapes) {
    TestWorld w;
    w.add_ground();
    const BodyId body = w.add_box({0, 4});
    w->set_transform(body, {1, 4}, 0.7f);
    Sketch sketch;
    sketch.ask_for_nothing();
    sketch.draw.boxes = sketch.draw.fat_boxes = true;
    const std::vector<Call> tight = sketch.part(*w, DrawPart::box), fat = sketch.part(*w, DrawPart::fat_box);
    ASSERT_EQ(tight.size(), 2u);
    ASSERT_EQ(fat.size(), 2u);
    const double half = 0.5 * (std::cos(0.7) + std::sin(0.7));
    expect_near(tight[1].points[0], 1 - half, 4 - half);
    expect_near(tight[1].points[2], 1 + half, 4 + half);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_FALSE(tight[i].style.solid);
        EXPECT_LT(fat[i].points[0].x, tight[i].points[0].x);
        EXPECT_GT(fat[i].points[2].y, tight[i].points[2].y);
        EXPECT_LT(fat[i].points[2].y - tight[i].points[2].y, 0.2f);
    }
}

TEST(DebugDraw, TheTreesBoxesHoldAllThatRests) {
    TestWorld w;
    for (int i = 0; i < 9; ++i) w.add_box({3 * static_cast<float>(i), 0}, 1, 1, {}, BodyType::static_body);
    w.add_box({3, 30});
    w.step();
    Sketch sketch;
    sketch.ask_for_nothing();
    sketch.draw.tree = true;
    const std::vector<Call> boxes = sketch.part(*w, DrawPart::tree_box);
    ASSERT_EQ(boxes.size(), 8u);  // a binary tree of nine leaves has eight other nodes
    bool whole = false;
    for (const Call& call : boxes) {
        EXPECT_LT(call.points[2].y, 2.0f);
        whole = whole || (call.points[0].x <= -1 && call.points[2].x >= 25);
    }
    EXPECT_TRUE(whole);
}

TEST(DebugDraw, CentresOfMassHaveTheBodysAxes) {
    TestWorld w;
    w.add_ground();
    const BodyId body = w.add(make_offset_box(1, 1, {{2, 0}, {}}), BodyDef{.type = BodyType::dynamic, .position = {3, 5}, .angle = quarter});
    Sketch sketch;
    sketch.draw.centers = true;
    const std::vector<Call> calls = sketch.part(*w, DrawPart::center);
    ASSERT_EQ(calls.size(), 3u);
    expect_near(calls[0].points[1] - calls[0].points[0], 0, 0.25);
    EXPECT_EQ(calls[0].style.color, draw_color::x_axis);
    expect_near(calls[1].points[1] - calls[1].points[0], -0.25, 0);
    EXPECT_EQ(calls[2].kind, "point");
    expect_near(calls[2].points[0], 3, 7);
    EXPECT_EQ(calls[2].points[0], w->center_of_mass(body));
}

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

TEST(DebugDraw, ConstraintsOfOneColourShareNoBody) {
    TestWorld w;
    w.add_ground();
    for (int i = 0; i < 6; ++i) w.add_box({0, 0.5f + static_cast<float>(i)});
    w.step(10);
    Sketch sketch;
    sketch.draw.contacts = sketch.draw.constraint_colors = true;
    std::map<DrawColor, std::set<std::uint32_t>> contacts;
    for (const Call& call : sketch.part(*w, DrawPart::contact)) contacts[call.style.color].insert(call.style.slot);
    EXPECT_GE(contacts.size(), 2u);
    for (const auto& [color, slots] : contacts) {
        std::set<std::uint32_t> bodies;
        for (const std::uint32_t slot : slots) {
            ContactInfo contact;
            ASSERT_TRUE(w->contact_at(slot, contact));
            for (const ShapeId shape : {contact.shape_a, contact.shape_b}) {
                if (w->type(w->body(shape)) != BodyType::dynamic) continue;
                EXPECT_TRUE(bodies.insert(w->body(shape).index1).second);
            }
        }
    }
}

TEST(DebugDraw, WhatIsOutOfViewIsLeftOutAndNothingElse) {
    TestWorld w{busy_capacity};
    fill_busy(*w);
    Sketch all;
    all.ask_for_everything();
    all.of(*w);
    ASSERT_GT(all.calls.size(), 200u);
    for (const Aabb view : {Aabb{{-9, 0}, {-6, 4}}, Aabb{{28, 0}, {31, 2}}, Aabb{{51, 0}, {53, 1}}, Aabb{{500, 500}, {501, 501}}}) {
        Sketch some;
        some.ask_for_everything();
        some.draw.view = view;
        some.of(*w);
        EXPECT_LT(some.calls.size(), all.calls.size() / 2);
        // What is drawn is a part of the whole, in its order; what is missing lies outside: all its points on one side of the view.
        std::size_t next = 0;
        for (const Call& call : all.calls) {
            if (next < some.calls.size() && same(call, some.calls[next])) {
                ++next;
                continue;
            }
            const std::size_t corners = call.kind == "circle" ? 1 : call.points.size();
            Aabb box = {call.points[0], call.points[0]};
            for (std::size_t i = 1; i < corners; ++i) box = merge(box, {call.points[i], call.points[i]});
            box = expand(box, call.radius);
            // A normal, an impulse or an axis is left out with the point it begins at.
            const bool begins_outside = !contains(view, {call.points[0], call.points[0]});
            const bool is_line = call.style.part == DrawPart::normal || call.style.part == DrawPart::impulse || call.style.part == DrawPart::center;
            EXPECT_TRUE(!overlaps(box, view) || (is_line && begins_outside)) << call.kind << " of " << call.style.slot;
        }
        EXPECT_EQ(next, some.calls.size());
    }
}

// A ball of radius 1 around the origin, seen through a window that comes near it from the right: its fat box is in view before it is.
TEST(DebugDraw, AShapeIsInViewWithItsTightBox) {
    TestWorld w;
    w.add_circle({0, 0}, 1);
    Sketch sketch;
    sketch.draw.boxes = sketch.draw.fat_boxes = true;
    sketch.draw.view = {{1.01f, -1}, {2, 1}};
    EXPECT_TRUE(sketch.part(*w, DrawPart::shape).empty());
    EXPECT_TRUE(sketch.part(*w, DrawPart::box).empty());
    EXPECT_EQ(sketch.part(*w, DrawPart::fat_box).size(), 1u);
    sketch.draw.view.lower.x = 0.99f;
    EXPECT_EQ(sketch.part(*w, DrawPart::shape).size(), 1u);
    EXPECT_EQ(sketch.part(*w, DrawPart::box).size(), 1u);
}

TEST(DebugDraw, FunctionsThatAreNullAreSkippedAndTheRestAreCalledAsBefore) {
    TestWorld w{busy_capacity};
    fill_busy(*w);
    Sketch all;
    all.ask_for_everything();
    all.of(*w);
    for (const char* missing : {"polygon", "circle", "capsule", "segment", "point", "text", "all"}) {
        const std::string kind = missing;
        Sketch some;
        some.ask_for_everything();
        if (kind == "polygon" || kind == "all") some.draw.polygon = nullptr;
        if (kind == "circle" || kind == "all") some.draw.circle = nullptr;
        if (kind == "capsule" || kind == "all") some.draw.capsule = nullptr;
        if (kind == "segment" || kind == "all") some.draw.segment = nullptr;
        if (kind == "point" || kind == "all") some.draw.point = nullptr;
        if (kind == "text" || kind == "all") some.draw.text = nullptr;
        some.of(*w);
        std::vector<Call> wanted;
        for (const Call& call : all.calls)
            if (kind != "all" && call.kind != kind) wanted.push_back(call);
        EXPECT_LT(wanted.size(), all.calls.size()) << kind;
        ASSERT_EQ(some.calls.size(), wanted.size()) << kind;
        for (std::size_t i = 0; i < wanted.size(); ++i) ASSERT_TRUE(same(some.calls[i], wanted[i])) << kind;
    }
}

TEST(DebugDraw, NothingAskedForIsNothingDrawn) {
    TestWorld w{busy_capacity};
    fill_busy(*w);
    Sketch sketch;
    sketch.ask_for_nothing();
    EXPECT_TRUE(sketch.of(*w).empty());
}

TEST(DebugDraw, DrawingChangesNoWorld) {
    TestWorld drawn{busy_capacity}, plain{busy_capacity};
    fill_busy(*drawn);
    fill_busy(*plain);
    Sketch sketch;
    sketch.ask_for_everything();
    sketch.draw.body_colors = BodyColors::island;
    for (int i = 0; i < 60; ++i) {
        sketch.of(*drawn);
        drawn.step();
        plain.step();
        ASSERT_EQ(drawn->hash(), plain->hash());
    }
    EXPECT_EQ(drawn->validate(), nullptr);
}

TEST(DebugDraw, BadOptionsAreRefusedAndNothingIsDrawn) {
    TestWorld w;
    w.add_ground();
    const auto refuses = [&](Error error, void (*spoil)(DebugDraw&)) {
        Sketch sketch;
        spoil(sketch.draw);
        w.errors.clear();
        EXPECT_TRUE(sketch.of(*w).empty());
        EXPECT_EQ(w.errors, std::vector<Error>{error});
    };
    refuses(Error::not_finite, [](DebugDraw& d) { d.view.lower.x = NAN; });
    refuses(Error::not_finite, [](DebugDraw& d) { d.view.upper.y = INFINITY; });
    refuses(Error::not_finite, [](DebugDraw& d) { d.size = NAN; });
    refuses(Error::not_finite, [](DebugDraw& d) { d.impulse_scale = INFINITY; });
    refuses(Error::out_of_range, [](DebugDraw& d) { d.view = {{1, 0}, {0, 1}}; });
    refuses(Error::out_of_range, [](DebugDraw& d) { d.size = 0; });
    refuses(Error::out_of_range, [](DebugDraw& d) { d.impulse_scale = -1; });
}

TEST(DebugDraw, AGeometryCanBeDrawnWithoutAWorld) {
    Sketch sketch;
    const DrawStyle style = {0x123456, DrawPart::shape, true, 7};
    draw_shape(sketch.draw, make_box(1, 2), {{3, 5}, make_rot(quarter)}, style);
    ASSERT_EQ(sketch.calls.size(), 1u);
    EXPECT_EQ(sketch.calls[0].style.color, 0x123456u);
    for (const Vec2 p : sketch.calls[0].points) EXPECT_NEAR(std::abs(double(p.x) - 3), 2, 1e-5);
    Polygon bad = make_box(1, 2);
    bad.count = 9;
    draw_shape(sketch.draw, bad, {}, style);
    EXPECT_EQ(sketch.calls.size(), 1u);
}

}  // namespace
