// Ready-made things in a world of your own: a soft body drops on a bridge of planks, which holds it up.
#include <cstdio>

#include <islet/islet.hpp>

#include "prefabs/bridge.hpp"
#include "prefabs/soft_body.hpp"

using namespace islet;
using namespace islet::samples;

static StaticWorld<Capacity{.bodies = 64, .shapes = 64, .contacts = 512, .joints = 64}> storage;
static BodyId planks[18], skin[20];
static JointId hinges[17], joints[20];

int main() {
    World& world = storage.create();
    const Spawned bridge = spawn(world, BridgeDef{.from = {-4, 3}, .to = {4, 3}}, planks, hinges);
    const SoftBodyDef ball = {.position = {0, 5}};
    const Spawned soft = spawn(world, ball, skin, joints);
    if (world.last_error() != Error::none) {
        std::printf("not all of it found room: %s\n", describe(world.last_error()));
        return 1;
    }

    for (int step = 0; step < 300; ++step) {
        apply_pressure(world, soft, ball);  // a force acts for one step, so it is given before each
        world.step(1.0f / 60);
    }
    std::printf("the bridge sags to %.2f m; the ball on it keeps %.0f %% of its area\n", double(world.position(bridge.bodies[8]).y),
                double(100 * area_of(world, soft, ball) / round_area(ball)));
}
