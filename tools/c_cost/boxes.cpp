// A pyramid of 55 boxes in C++, as boxes.c has it in C. tools/c_cost.sh compares them.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>

#include <islet/islet.hpp>

using namespace islet;

alignas(world_alignment) static std::byte memory[600000];

int main(int argc, char** argv) {
    const int steps = argc > 1 ? std::atoi(argv[1]) : 60, reads = argc > 2 ? std::atoi(argv[2]) : 1;
    Capacity capacity;
    capacity.bodies = capacity.shapes = 64;
    capacity.contacts = 512;
    World* const made = World::create(memory, capacity, {});
    if (made == nullptr) return 1;
    World& world = *made;
    BodyDef def;
    const Polygon floor = make_box(20, 1), box = make_box(0.5f, 0.5f);
    const BodyId ground = world.create_body(def);
    world.create_shape(ground, floor);
    BodyId boxes[55];
    int count = 0;
    def.type = BodyType::dynamic;
    def.enable_sleep = false;
    for (int row = 0; row < 10; ++row) {
        for (int i = 0; i < 10 - row; ++i) {
            def.position.x = static_cast<float>(i) + 0.5f * static_cast<float>(row);
            def.position.y = 1.5f + 1.01f * static_cast<float>(row);
            boxes[count] = world.create_body(def);
            world.create_shape(boxes[count++], box);
        }
    }
    float sum = 0;
    for (int step = 0; step < steps; ++step) {
        world.step(1.0f / 60);
        for (int read = 0; read < reads; ++read) {
            for (int i = 0; i < count; ++i) {
                const Transform pose = world.transform(boxes[i]);
                sum += pose.p.x + pose.p.y + pose.q.s;
            }
        }
    }
    std::printf("%016" PRIx64 " %.9g\n", world.hash(), double(sum));
    return static_cast<int>(world.last_error());
}
