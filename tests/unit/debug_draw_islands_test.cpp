// DebugDraw colours islands as World tells of contacts and joints.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "sketch.hpp"

namespace {

using namespace sketch;

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
    const BodyId left = w.add_circle({-10, 6}), right = w.add_circle({-12, 6}), lone = w.add_circle({-20, 14});  // the last comes down after 100 steps
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

}  // namespace
