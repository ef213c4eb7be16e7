// What a world draws, kept call by call.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/busy_world.hpp"
#include "support/test_world.hpp"

namespace sketch {

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

inline bool same(const Call& a, const Call& b) {
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

inline void expect_near(Vec2 got, double x, double y, double tolerance = 1e-5) {
    EXPECT_NEAR(double(got.x), x, tolerance);
    EXPECT_NEAR(double(got.y), y, tolerance);
}

// A quarter turn at (3, 5): a point (x, y) of the body is at (3 - y, 5 + x).
inline constexpr float quarter = 0.5f * pi;

}  // namespace sketch
