// A half-space as a slope: what is on it goes on for ever, as the formulas of an inclined plane say.
#include <cmath>

#include "build.hpp"
#include "harness/checks.hpp"
#include "scenes.hpp"

namespace islet::samples {

Scene make_endless_slope() {
    constexpr float lean = 0.2f;  // rad
    Scene scene;
    scene.name = "endless_slope";
    scene.steps = 180;
    scene.view = {{-8, -7}, {24, 5}};
    const Rot tilt = make_rot(-lean);
    const Vec2 normal = rotate(tilt, {0, 1}), down = rotate(tilt, {1, 0});
    ShapeDef rough, smooth;
    rough.friction = 0.6f;
    smooth.friction = 0;
    add_body(scene, {}, {{HalfSpace{normal, 0}, rough}});

    const auto put = [&](float along, const SceneGeometry& geometry, const ShapeDef& def) {
        BodyDef body;
        body.type = BodyType::dynamic;
        body.position = along * down + 0.5f * normal;
        body.angle = -lean;
        scene.traced.push_back(add_body(scene, body, {{geometry, def}}));
        return scene.traced.back();
    };
    const std::size_t stays = put(-5, make_box(0.5f, 0.5f), rough), rolls = put(0, Circle{{}, 0.5f}, rough), slides = put(10, make_box(0.5f, 0.5f), smooth);

    scene.check = [=, t = double(scene.dt) * scene.steps, g = -double(scene.world.gravity.y)](const Engine& engine) -> std::vector<CheckLine> {
        const auto along = [&](std::size_t body) { return double(dot(engine.body(body).position, down)); };
        const auto height = [&](std::size_t body) { return double(dot(engine.body(body).position, normal)); };
        const double slid = 0.5 * g * std::sin(double(lean)) * t * t, rolled = slid / 1.5;  // a disc's inertia is half of m r^2
        return {
            near_line("the rough box went (m)", along(stays) + 5, 0, 0.02),
            near_line("the disc rolled (m), as 1/3 g sin t^2", along(rolls), rolled, 0.02 * rolled),
            near_line("the smooth box slid (m), as 1/2 g sin t^2", along(slides) - 10, slid, 0.02 * slid),
            near_line("height of the disc's middle over the slope (m)", height(rolls), 0.5, 0.005),
            near_line("height of the smooth box's middle (m)", height(slides), 0.5, 0.005),
        };
    };
    return scene;
}

}  // namespace islet::samples
