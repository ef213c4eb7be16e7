// Which pair finder? Sorting and sweeping against tree queries, on boxes in motion, all of which leave their fat boxes in every round.
//
// Both sides do what a step would need of them. Sweep: find_pairs as the engine runs it (sort, sweep, ask the pair set). Tree: take every box out, put the
// new one in, query it, and ask the same pair set. The numbers in broadphase/pairs.cpp come from here. Usage: pair_finder [boxes] [rounds]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

#include "broadphase/pairs.hpp"
#include "broadphase/tree.hpp"
#include "bodies/bounds.hpp"
#include "scenes/random.hpp"

using namespace islet;
using namespace islet::detail;

namespace {

double milliseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

struct Block {
    explicit Block(std::size_t bytes) : size(bytes), data(static_cast<std::byte*>(::operator new(bytes, std::align_val_t{world_alignment}))) {}
    ~Block() { ::operator delete(data, std::align_val_t{world_alignment}); }
    Block(const Block&) = delete;
    Block& operator=(const Block&) = delete;
    std::size_t size;
    std::byte* data;
};

}  // namespace

int main(int argc, char** argv) {
    const auto count = static_cast<std::uint32_t>(argc > 1 ? std::atoi(argv[1]) : 8100);
    const int rounds = argc > 2 ? std::atoi(argv[2]) : 51;
    const Capacity capacity{.bodies = count, .shapes = count, .contacts = count * 16, .geometries = 1};
    const Block block(world_bytes(capacity));
    World* world = World::create({block.data, block.size}, capacity, {.gravity = {0, 0}});
    if (world == nullptr) return 2;
    Core& core = Core::of(*world);

    // A square of 0.2 m boxes packed as in the washer scene, each moved by a tenth of its size or so a round.
    const auto side = static_cast<std::uint32_t>(std::sqrt(double(count)));
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec2 at{0.21f * static_cast<float>(i % side), 0.21f * static_cast<float>(i / side)};
        world->create_shape(world->create_body({.type = BodyType::dynamic, .position = at}), make_box(0.1f, 0.1f));
    }
    TreeState tree_state;
    std::vector<TreeNode> nodes(2 * std::size_t{count});
    const Tree tree{&tree_state, nodes.data()};
    std::vector<std::uint32_t> leaves(count);
    for (std::uint32_t s = 0; s < count; ++s) leaves[s] = tree_insert(tree, core.boxes[s], s);
    find_pairs(core, 1.0f / 60);

    samples::Random random(1);
    std::vector<double> sweep_ms, tree_ms;
    std::size_t tree_pairs = 0, known = 0;
    for (int round = 0; round < rounds; ++round) {
        for (std::uint32_t body = 0; body < count; ++body) {
            const Vec2 step{random.uniform(-0.02f, 0.02f), random.uniform(-0.02f, 0.02f)};
            core.poses[body].center += step;
            core.bodies[body].origin += step;
            update_boxes(core, body, true);
        }
        auto start = std::chrono::steady_clock::now();
        find_pairs(core, 1.0f / 60);
        sweep_ms.push_back(milliseconds_since(start));

        start = std::chrono::steady_clock::now();
        for (std::uint32_t s = 0; s < count; ++s) {
            tree_remove(tree, leaves[s]);
            leaves[s] = tree_insert(tree, core.boxes[s], s);
        }
        for (std::uint32_t s = 0; s < count; ++s) {
            tree_query(tree, core.boxes[s], [&](std::uint32_t other) {
                if (other <= s) return;
                ++tree_pairs;
                known += core.pairs.contains(PairSet::key(s, other)) ? 1 : 0;
            });
        }
        tree_ms.push_back(milliseconds_since(start));
    }
    if (known != tree_pairs) return 1;  // the tree found a pair that the sweep did not
    const double sweep = median(sweep_ms), queries = median(tree_ms);
    std::printf("%u boxes, %zu pairs a round, median of %d rounds\n", count, tree_pairs / static_cast<std::size_t>(rounds), rounds);
    std::printf("  sort and sweep   %8.3f ms\n  tree queries     %8.3f ms   %.1f times as long\n", sweep, queries, queries / sweep);
    return 0;
}
