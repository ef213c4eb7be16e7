// Discs in the open, tied to a static body by angle joints alone.
#include "build.hpp"
#include "harness/checks.hpp"
#include "scenes.hpp"

namespace islet::samples {

// Two ratchets are driven forward for 0.9 s and back for 1.1 s, four times over. Their motors of 5 N m take 0.1 s to 2 rad/s, so forward is 1.8 rad: 1.7 while
// driven, 0.1 while braked. The first goes on by three teeth of 0.5 rad each time. The other turns backward and
// has its teeth 0.1 rad off, so it is held at -1.4 rad the first time, and 1.5 rad farther each of the other times.
Scene make_ratchet() {
    Scene scene;
    scene.name = "ratchet";
    scene.world.gravity = {0, 0};
    scene.steps = 480;
    const std::size_t ground = add_static(scene, {4.5f, -2.5f}, make_box(6, 0.25f));
    constexpr float inertia = 0.25f;  // kg m^2: 0.5 m^2 r^2 with a mass of 2 kg and a radius of 0.5 m
    const auto add_disc = [&](float x, const AngleJointDef& def, float spin = 0) {
        const std::size_t disc = add_dynamic(scene, {x, 0}, Circle{{}, 0.5f}, {.density = 8 / pi});
        scene.bodies[disc].def.angular_velocity = spin;
        scene.bodies[disc].def.enable_sleep = false;
        AngleJointDef placed = def;
        placed.base.frame_a.position = {x - 4.5f, 2.5f};
        return add_joint(scene, ground, disc, placed);
    };
    constexpr float torque = 5, speed = 2, brake = 0.5f, spin = 3;  // N m, rad/s, N m, rad/s
    const std::size_t forward = add_disc(0, {.ratchet = {.step = 0.5f}});
    const std::size_t backward = add_disc(3, {.ratchet = {.step = -0.5f, .phase = 0.1f}});
    const std::size_t sprung = add_disc(6, {.spring = {.enable = true, .hertz = 0.5f, .damping_ratio = 1, .target = 1}});
    const std::size_t braked = add_disc(9, {.friction = brake}, spin);
    scene.before_step = [forward, backward](Engine& engine, int step) {
        const float way = step % 120 < 54 ? speed : -speed;
        engine.set_motor(forward, {.enable = true, .speed = way, .max_force = torque});
        engine.set_motor(backward, {.enable = true, .speed = -way, .max_force = torque});
    };
    scene.check = [=](const Engine& engine) -> std::vector<CheckLine> {
        // The joints give to the motors' 5 N m by less than the limits' tolerance.
        return {
            near_line("the ratchet went on by three teeth, four times (rad)", double(engine.joint_position(forward)), 6, 0.005),
            near_line("the other one went back as far, but for its phase (rad)", double(engine.joint_position(backward)), -5.9, 0.005),
            near_line("the spring rests at its target (rad)", double(engine.joint_position(sprung)), 1, 0.005),
            near_line("the brake took w^2 I / (2 T) to stop (rad)", double(engine.joint_position(braked)), double(spin * spin * inertia / (2 * brake)), 0.03)};
    };
    return scene;
}

}  // namespace islet::samples
