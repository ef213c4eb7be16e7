// From a world to a matrix: a crate of 400 kg on two of 1 kg. How much does each gap carry, by what the engine stored, and by the exact solution of the
// problem that it works on?
#include <cmath>
#include <cstdio>
#include <vector>

#include <islet/island.hpp>
#include <islet/islet.hpp>

using namespace islet;

static StaticWorld<Capacity{.bodies = 4, .shapes = 4, .contacts = 8}> storage;

int main() {
    World& world = storage.create();
    world.create_shape(world.create_body({}), make_box(20, 1));
    BodyId crate;
    for (int i = 0; i < 3; ++i) {
        crate = world.create_body({.type = BodyType::dynamic, .position = {0, 1.5f + static_cast<float>(i)}});
        world.create_shape(crate, make_box(0.5f, 0.5f), {.density = i == 2 ? 400.0f : 1.0f});
    }
    for (int i = 0; i < 300; ++i) world.step(1.0f / 60);

    const float h = 1.0f / 240;  // s: a substep
    IslandProblem island;
    std::vector<std::byte> memory(world.export_island(crate, h, {}, island));
    world.export_island(crate, h, memory, island);

    std::vector<float> x(island.impulses.begin(), island.impulses.end());
    std::vector<std::byte> workspace(lcp::workspace_bytes<float>(lcp::Method::newton, x.size()));
    const lcp::Result<float> result = lcp::solve<float>(island.lcp, {.method = lcp::Method::newton, .tolerance = 1e-5f}, x, workspace);
    std::printf("%zu bodies, %zu rows, %zu entries. %s\n", island.bodies.size(), x.size(), island.lcp.sparse.values.size(), lcp::describe(result.status));

    float on_the_ground = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const IslandRow& row = island.rows[i];
        if (row.kind != RowKind::normal) continue;
        std::printf("contact %u, point %u: %7.1f N stored, %7.1f N exact\n", row.slot, row.index, double(island.impulses[i] / h), double(x[i] / h));
        if (row.ends[0].body == no_body || row.ends[1].body == no_body) on_the_ground += x[i] / h;
    }
    return result.status == lcp::Status::converged && std::fabs(on_the_ground - 4020) < 4 ? 0 : 1;
}
