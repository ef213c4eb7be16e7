// A character to walk about in tests: after every step no shape may overlap its capsule, by exact distances in double precision (known.hpp).
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "islet/mover.hpp"
#include "known.hpp"

namespace hero {

using namespace islet;
using test::TestWorld;

inline constexpr float dt = 1.0f / 60;
inline constexpr float gap = mover_gap;
inline constexpr float radius = 0.3f;

// Speeds that are reached at once, so that distances are speed times time.
inline MoverDef sudden() {
    MoverDef def;
    def.ground_acceleration = 1e6f;
    def.air_acceleration = 0;
    return def;
}

struct Hero {
    TestWorld& w;
    MoverDef def = sudden();
    MoverState state;
    float worst_overlap = 0;
    int steps_in_air = 0;

    explicit Hero(TestWorld& world, Vec2 feet) : w(world) { state.position = feet; }

    void step(const MoverInput& input, int steps = 1) {
        for (int i = 0; i < steps; ++i) {
            w->step(dt);
            ASSERT_TRUE(step_mover(*w, def, state, input, dt));
            steps_in_air += state.ground ? 0 : 1;
            watch();
        }
    }
    void watch() {
        const Capsule c{state.position + def.capsule.point1, state.position + def.capsule.point2, def.capsule.radius};
        const oracle::Solid solid = oracle::solid_of(make_proxy(c));
        for (const test::Known& k : test::known_shapes(w)) {
            if (def.collides == nullptr) worst_overlap = std::max(worst_overlap, static_cast<float>(-oracle::signed_distance(solid, k.solid)));
        }
    }
    Vec2 middle() const { return state.position + def.capsule.point1; }
};

inline void add_slope(TestWorld& w, float degrees) {
    // A block whose upper face goes through the origin.
    const Rot q = make_rot(degrees * pi / 180);
    w.add(make_offset_box(50, 1, {rotate(q, {0, -1}), q}), Vec2{0, 0}, {}, BodyType::static_body);
}

inline void add_stairs(TestWorld& w, int steps, float rise, float depth) {
    w.add_ground(0);
    for (int i = 1; i <= steps; ++i) {
        const float left = 2 + depth * static_cast<float>(i - 1), top = rise * static_cast<float>(i);
        w.add(make_offset_box(25, 0.5f * top, {{left + 25, 0.5f * top}, {}}), Vec2{0, 0}, {}, BodyType::static_body);
    }
}

}  // namespace hero
