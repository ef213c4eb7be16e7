// Steps a world on all the threads of the machine: a task system is one function. Here OpenMP, TBB or a game's own job system would do as well; the pool
// is thread_pool.hpp. The same program with one worker prints the same hash.
#include <algorithm>
#include <cstdio>
#include <thread>

#include <islet/islet.hpp>

#include "thread_pool.hpp"

using namespace islet;

static StaticWorld<Capacity{.bodies = 2048, .shapes = 2048, .contacts = 8192}> storage;

int main() {
    samples::ThreadPool pool(std::min(std::max(std::thread::hardware_concurrency(), 1u), max_workers));
    World& world = storage.create({.tasks = pool.tasks()});
    world.create_shape(world.create_body({}), make_box(100, 1));
    for (int i = 0; i < 2000; ++i) {
        const auto column = static_cast<float>(i % 100), row = static_cast<float>(i / 100);
        const BodyId crate = world.create_body({.type = BodyType::dynamic, .position = {1.5f * column - 75, 2 + 1.1f * row}});
        world.create_shape(crate, make_box(0.5f, 0.5f));
    }
    for (int i = 0; i < 120; ++i) world.step(1.0f / 60);
    std::printf("%u workers, state %016llx\n", pool.workers(), static_cast<unsigned long long>(world.hash()));
}
