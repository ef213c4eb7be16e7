// DebugDraw: what reaches the user's functions is what the world holds, and only what is asked for and in view.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "sketch.hpp"

namespace {

using namespace sketch;

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
