// Scenes of the catalogue that have several starts, run from each of them.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "harness/engine.hpp"
#include "scenes/catalogue.hpp"
#include "support/effort.hpp"

namespace islet::test {

/// Runs the scene from every start (in slow builds from every fourth); each line of its check holds, and is within what is wanted of it.
inline void holds_from_every_start(const std::string& name) {
    const samples::SceneInfo* const info = samples::find_scene(name);
    ASSERT_NE(info, nullptr);
    ASSERT_NE(info->make_start, nullptr);
    for (int start = 0; start < info->starts; start += slow_build ? 4 : 1) {
        const samples::Scene scene = info->make_start(start);
        samples::IsletEngine engine;
        engine.load(scene);
        for (int step = 0; step < scene.steps; ++step) engine.advance(scene, step, scene.dt);
        for (const samples::CheckLine& line : scene.check(engine)) {
            EXPECT_TRUE(line.pass()) << "start " << start << ": " << line.what << ": " << line.value << " is not within " << line.low << " to " << line.high;
            if (line.wanted) { EXPECT_LE(line.value, line.wanted->most) << "start " << start << ": " << line.what; }
        }
        EXPECT_EQ(engine.world().validate(), nullptr);
    }
}

}  // namespace islet::test
