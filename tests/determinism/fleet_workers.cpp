// Steps fleets of scenes with one worker and with several, with actions, observations, resets and forks, and compares every world's hash. A bare program,
// because it is built under the thread sanitizer too (tools/test.sh --all), which sees what two workers share by mistake.
#include <cstdio>
#include <cstring>
#include <vector>

#include <islet/fleet.hpp>
#include <islet/ranges.hpp>

#include "harness/engine.hpp"
#include "scenes/catalogue.hpp"
#include "workers/thread_pool.hpp"

using namespace islet;

namespace {

constexpr std::uint32_t worlds = 35, rounds = 24;  // worlds: no multiple of what a worker takes at a time

struct alignas(world_alignment) Line {
    std::byte bytes[world_alignment];
};

/// A force, a torque and three senses for each of the scene's first dynamic bodies, a ray among them, and a motor and a sense for each of its joints.
struct Columns {
    std::vector<Drive> drives;
    std::vector<Sense> senses;

    explicit Columns(const World& world) {
        for (const BodyId body : all_bodies(world)) {
            if (world.type(body) != BodyType::dynamic || drives.size() >= 16) continue;
            drives.push_back({.kind = DriveKind::force_x, .body = body, .scale = 20 * world.mass(body)});
            drives.push_back({.kind = DriveKind::torque, .body = body, .scale = world.rotational_inertia(body)});
            senses.push_back({.kind = SenseKind::position, .body = body});
            senses.push_back({.kind = SenseKind::touching, .body = body});
            senses.push_back({.kind = SenseKind::ray, .body = body, .translation = {3, -3}});
        }
        for (const JointId joint : all_joints(world)) {
            drives.push_back({.kind = DriveKind::motor_speed, .joint = joint, .scale = 3});
            senses.push_back({.kind = SenseKind::joint, .joint = joint});
        }
    }
};

/// The hashes of all worlds after each round, and then the observations.
std::vector<std::uint64_t> story(const World& prototype, std::uint32_t workers) {
    samples::ThreadPool pool(workers);
    const Columns columns(prototype);
    std::vector<Line> block(Fleet::bytes(worlds, prototype.capacity(), workers) / sizeof(Line) + 1);
    Fleet& fleet = *Fleet::create({block[0].bytes, block.size() * sizeof(Line)}, prototype, worlds, pool.tasks());
    std::vector<std::uint64_t> told;
    std::vector<std::byte> image(prototype.snapshot_bytes());
    prototype.save(image);
    std::vector<float> actions(worlds * columns.drives.size()), seen(worlds * islet::columns(columns.senses));
    std::vector<std::uint8_t> mask(worlds);
    std::vector<std::uint32_t> parents(worlds);
    for (std::uint32_t k = 0; k < worlds; ++k) parents[k] = k - k % 5;
    for (std::uint32_t round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < actions.size(); ++i) actions[i] = static_cast<float>((i * 37 + round * 11) % 64) / 32 - 1;
        for (std::uint32_t k = 0; k < worlds; ++k) mask[k] = (k + round) % 4 != 0;
        if (round % 10 == 5) fleet.reset(round, image, round);
        if (round % 10 == 8) fleet.fork(parents);
        const Error error =
            fleet.step({.repeat = 1 + round % 2, .mask = mask, .drives = columns.drives, .actions = actions, .senses = columns.senses, .observations = seen});
        if (error != Error::none) std::printf("%s\n", describe(error));
        for (std::uint32_t k = 0; k < worlds; ++k) told.push_back(fleet[k].hash());
    }
    fleet.observe(columns.senses, seen);
    for (const float number : seen) told.push_back(__builtin_bit_cast(std::uint32_t, number));
    return told;
}

}  // namespace

int main() {
    std::size_t compared = 0, wrong = 0;
    for (const char* name : {"card_house", "car", "chain_ball", "ragdoll", "soft_stack"}) {
        const samples::SceneInfo* info = samples::find_scene(name);
        if (info == nullptr) return std::printf("there is no scene %s\n", name), 2;
        const samples::Scene scene = info->make();
        samples::IsletEngine engine;
        engine.load(scene);
        for (int step = 0; step < 30; ++step) engine.advance(scene, step, scene.dt);
        const std::vector<std::uint64_t> one = story(engine.world(), 1);
        for (const std::uint32_t workers : {2u, 4u}) {
            const std::vector<std::uint64_t> more = story(engine.world(), workers);
            for (std::size_t i = 0; i < one.size(); ++i) wrong += one[i] != more[i];
            compared += one.size();
        }
        if (one[0] == one[worlds - 1]) return std::printf("%s: the actions do nothing\n", name), 1;
    }
    std::printf("%zu numbers compared, %zu differ\n", compared, wrong);
    return wrong == 0 ? 0 : 1;
}
