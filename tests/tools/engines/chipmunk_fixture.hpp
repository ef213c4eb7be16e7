// A scene under construction and Chipmunk to load it into; skips where Chipmunk is missing.
#pragma once

#include <gtest/gtest.h>

#include "engines/registry.hpp"

namespace islet::test {

using namespace islet::samples;

inline constexpr double g = 10, h = double(1.0f / 60);  // m/s^2, s: a scene's defaults
inline constexpr double rounding = 1e-5;                // results are read as floats

inline SceneBody body_of(BodyType type, Vec2 position, SceneGeometry geometry, const ShapeDef& material = {}) {
    SceneBody body;
    body.def.type = type;
    body.def.position = position;
    body.shapes.push_back({std::move(geometry), material});
    return body;
}
inline SceneBody dynamic(Vec2 position, SceneGeometry geometry, const ShapeDef& material = {}) {
    return body_of(BodyType::dynamic, position, std::move(geometry), material);
}
inline SceneBody fixed(SceneGeometry geometry, const ShapeDef& material = {}) {
    return body_of(BodyType::static_body, {}, std::move(geometry), material);
}

/// Ground whose surface is y = 0.
inline SceneBody ground(const ShapeDef& material = {}) { return fixed(make_offset_box(50, 1, {{0, -1}, {}}), material); }

class Chipmunk : public testing::Test {
protected:
    void SetUp() override {
        const engines::EngineInfo* info = engines::find_engine("chipmunk");
        if (info == nullptr) GTEST_SKIP() << "built without Chipmunk";
        lacks_ = info->lacks;
        engine = info->make();
    }
    void load() { engine->load(scene); }
    void step(int steps) {
        for (int i = 0; i < steps; ++i) engine->advance(scene, step_++, scene.dt);
    }
    std::string lacks() const { return lacks_(scene); }
    std::size_t add(SceneBody body) {
        scene.bodies.push_back(std::move(body));
        return scene.bodies.size() - 1;
    }

    Scene scene;
    std::unique_ptr<Engine> engine;

private:
    std::string (*lacks_)(const Scene&) = nullptr;
    int step_ = 0;
};

/// Body 0 of every scene here is a static one at the origin, without shapes.
class ChipmunkJoints : public Chipmunk {
protected:
    void SetUp() override {
        Chipmunk::SetUp();
        scene.world.enable_sleep = false;
        scene.bodies.emplace_back();
    }
    std::size_t join(std::size_t a, std::size_t b, JointDef def) {
        scene.joints.push_back({a, b, std::move(def)});
        return scene.joints.size() - 1;
    }
    /// A disc of 1 m at `place` on a hinge in its middle.
    std::size_t add_wheel(Vec2 place, RevoluteJointDef hinge = {}) {
        const std::size_t wheel = add(dynamic(place, Circle{{}, 1}));
        hinge.base.frame_a.position = place;
        return join(0, wheel, hinge);
    }
    float position() const { return engine->joint_position(0); }
    float speed() const { return engine->joint_speed(0); }
};

}  // namespace islet::test
