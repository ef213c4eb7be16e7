// What going back costs: size of a snapshot and the time of save, restore and load beside a plain copy of as many bytes; and for a rollback of 12
// steps, what it costs beyond the steps themselves.
//
//     snapshot_bench [SCENE [STEPS]]        large_pyramid, 500 by default
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "harness/engine.hpp"
#include "scenes/catalogue.hpp"

namespace {

using namespace islet;

// Median of many runs, ms.
template <class Work>
double time_of(Work&& work) {
    std::vector<double> ms;
    for (int i = 0; i < 101; ++i) {
        const auto start = std::chrono::steady_clock::now();
        work();
        ms.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    std::nth_element(ms.begin(), ms.begin() + 50, ms.end());
    return ms[50];
}

}  // namespace

int main(int argc, char** argv) {
    const char* name = argc > 1 ? argv[1] : "large_pyramid";
    const samples::SceneInfo* info = samples::find_scene(name);
    if (info == nullptr) {
        std::fprintf(stderr, "there is no scene %s\n", name);
        return 2;
    }
    const samples::Scene scene = info->make();
    const int steps = argc > 2 ? std::atoi(argv[2]) : 500;
    samples::IsletEngine engine;
    engine.load(scene);
    for (int i = 0; i < steps; ++i) engine.advance(scene, i, scene.dt);
    World& w = engine.world();

    std::vector<std::byte> image(w.snapshot_bytes()), other(image.size());
    const double save = time_of([&] { w.save(image); });
    const double restore = time_of([&] { w.restore(image); });
    const double load = time_of([&] { w.load(image); });
    const double copy = time_of([&] { std::memcpy(other.data(), image.data(), image.size()); });
    const double step = time_of([&] {
        w.restore(image);
        w.step(scene.dt);
    }) - restore;

    w.step(scene.dt);
    w.save(other);
    std::vector<std::byte> packed(max_delta_bytes(other.size()));
    const std::size_t changed = delta(image, other, packed);
    w.restore(image);

    const double bodies = w.body_count();
    std::printf("%s after %d steps: %u bodies, %u contacts, %u joints\n", name, steps, w.body_count(), w.contact_count(), w.joint_count());
    std::printf("snapshot        %10zu bytes, %.0f a body\n", image.size(), static_cast<double>(image.size()) / bodies);
    std::printf("delta of a step %10zu bytes, %.0f a body\n", changed, static_cast<double>(changed) / bodies);
    std::printf("save    %8.4f ms\nrestore %8.4f ms\nload    %8.4f ms\nmemcpy  %8.4f ms\nstep    %8.4f ms\n", save, restore, load, copy, step);
    std::printf("going back and taking 12 steps anew, each saved, costs %.1f %% of a step beyond the steps\n", 100 * (restore + 12 * save) / step);
    std::printf("one save and one restore: %.1f %% of a step\n", 100 * (restore + save) / step);
}
