// How many steps of worlds a fleet takes in a second, beside as many worlds by themselves; and what copies cost.
//
//     fleet_bench [WORLDS [ROUNDS]]        1024 and 5 by default
//
// The worlds are pyramids of 3 and 10 boxes and one of 45 with five balls beside, on a floor. Nothing sleeps. Rounds of all ways take turns; the table shows
// medians. Box2D has no row here: whoever wants one steps as many of its worlds in a loop.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <vector>

#include <islet/fleet.hpp>
#include <islet/islet.hpp>

#include "workers/thread_pool.hpp"

namespace {

using namespace islet;

struct Block {
    explicit Block(std::size_t bytes) : data(static_cast<std::byte*>(::operator new (bytes, std::align_val_t{world_alignment}))), size(bytes) {}
    ~Block() { ::operator delete (data, std::align_val_t{world_alignment}); }
    Block(const Block&) = delete;
    Block& operator=(const Block&) = delete;
    span<std::byte> all() const { return {data, size}; }
    std::byte* data;
    std::size_t size;
};

constexpr int steps = 20;  // of each world a round

/// A pyramid with `rows` rows, and balls beside it.
void build(World& world, int rows, int balls) {
    const BodyId floor = world.create_body({});
    world.create_shape(floor, make_offset_box(50, 1, {{0, -1}, {}}), {});
    BodyDef def;
    def.type = BodyType::dynamic;
    for (int row = 0; row < rows; ++row) {
        for (int i = 0; i < rows - row; ++i) {
            def.position = {static_cast<float>(i) + 0.5f * static_cast<float>(row - rows), 0.5f + static_cast<float>(row)};
            world.create_shape(world.create_body(def), make_box(0.5f, 0.5f), {});
        }
    }
    for (int i = 0; i < balls; ++i) {
        def.position = {static_cast<float>(rows + 2 * i), 0.5f};
        world.create_shape(world.create_body(def), Circle{{0, 0}, 0.5f}, {});
    }
}

/// Worlds of one kind, in three forms.
class Contest {
public:
    Contest(int rows, int balls, std::uint32_t worlds, const TaskSystem& tasks) {
        const auto bodies = static_cast<std::uint32_t>(rows * (rows + 1) / 2 + balls + 1);
        const Capacity capacity{.bodies = bodies, .shapes = bodies, .contacts = 4 * bodies, .joints = 0, .geometries = 4};
        WorldDef def;
        def.enable_sleep = false;
        for (std::uint32_t k = 0; k < worlds; ++k) {
            blocks_.push_back(std::make_unique<Block>(world_bytes(capacity)));
            alone_.push_back(World::create(blocks_.back()->all(), capacity, def));
            build(*alone_.back(), rows, balls);
        }
        one_ = std::make_unique<Block>(Fleet::bytes(worlds, capacity));
        two_ = std::make_unique<Block>(Fleet::bytes(worlds, capacity, tasks.workers));
        fleet_ = Fleet::create(one_->all(), *alone_[0], worlds);
        parallel_ = Fleet::create(two_->all(), *alone_[0], worlds, tasks);
        world_bytes_ = world_bytes(capacity);
    }
    void step_alone() {
        for (World* world : alone_)
            for (int i = 0; i < steps; ++i) world->step(1.0f / 60);
    }
    void step_fleet() { fleet_->step({.repeat = steps}); }
    void step_parallel() { parallel_->step({.repeat = steps}); }
    void copy_all() {
        for (std::uint32_t k = 1; k < fleet_->size(); ++k) fleet_->copy(0, k);
    }
    void memcpy_all() {
        const std::size_t bytes = one_->size / fleet_->size();
        for (std::uint32_t k = 1; k < fleet_->size(); ++k) std::memcpy(two_->data + k * bytes, two_->data, bytes);
    }
    bool agrees() const { return (*fleet_)[0].hash() == alone_[0]->hash() && (*parallel_)[fleet_->size() - 1].hash() == alone_[0]->hash(); }
    std::size_t bytes_alone() const { return world_bytes_; }
    std::size_t bytes_in_fleet() const { return one_->size / fleet_->size(); }

private:
    std::vector<std::unique_ptr<Block>> blocks_;
    std::vector<World*> alone_;
    std::unique_ptr<Block> one_, two_;
    Fleet* fleet_ = nullptr;
    Fleet* parallel_ = nullptr;
    std::size_t world_bytes_ = 0;
};

double seconds_of(Contest& contest, void (Contest::*work)()) {
    const auto begin = std::chrono::steady_clock::now();
    (contest.*work)();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
    const int worlds = argc > 1 ? std::atoi(argv[1]) : 1024, rounds = argc > 2 ? std::atoi(argv[2]) : 5;
    if (worlds < 2 || rounds < 1 || argc > 3) {
        std::fputs("usage: fleet_bench [WORLDS [ROUNDS]]\n", stderr);
        return 2;
    }
    samples::ThreadPool pool(2);
    std::printf("%d worlds; steps of worlds a second, medians of %d rounds of %d steps\n", worlds, rounds, steps);
    std::printf("%7s %11s %11s %11s %7s %7s %13s %13s %12s\n", "bodies", "alone", "fleet", "2 workers", "fleet", "workers", "bytes alone", "bytes here", "copy/memcpy");
    bool agrees = true;
    struct Kind {
        int rows, balls;
    };
    for (const Kind kind : {Kind{2, 0}, Kind{4, 2}, Kind{9, 5}}) {
        Contest contest(kind.rows, kind.balls, static_cast<std::uint32_t>(worlds), pool.tasks());
        std::vector<double> alone, fleet, parallel, copies, plain;
        for (int round = 0; round < rounds; ++round) {
            alone.push_back(seconds_of(contest, &Contest::step_alone));
            fleet.push_back(seconds_of(contest, &Contest::step_fleet));
            parallel.push_back(seconds_of(contest, &Contest::step_parallel));
        }
        agrees &= contest.agrees();
        for (int round = 0; round < rounds; ++round) {
            plain.push_back(seconds_of(contest, &Contest::memcpy_all));
            copies.push_back(seconds_of(contest, &Contest::copy_all));
        }
        const double taken = double(steps) * worlds;
        std::printf("%7d %11.0f %11.0f %11.0f %6.2fx %6.2fx %13zu %13zu %11.2fx\n", kind.rows * (kind.rows + 1) / 2 + kind.balls, taken / median(alone), taken / median(fleet),
                    taken / median(parallel), median(alone) / median(fleet), median(fleet) / median(parallel), contest.bytes_alone(), contest.bytes_in_fleet(),
                    median(copies) / median(plain));
    }
    std::puts(agrees ? "all ways came to the same bits" : "THE WAYS DIFFER");
    return agrees ? 0 : 1;
}
