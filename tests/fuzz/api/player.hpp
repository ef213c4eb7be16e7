// One input's play with a world: a list of calls, good and bad, made of the fuzzer's bytes. Each area of the API is a file of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "caller.hpp"
#include "islet/islet.hpp"
#include "islet/mover.hpp"

namespace islet::fuzz {

/// So small that every pool fills up.
inline constexpr Capacity capacity{.bodies = 12, .shapes = 20, .contacts = 24, .joints = 8, .geometries = 10};

/// What every input starts from anew.
struct Fixture {
    StaticWorld<capacity> storage[3], twin_storage;
    test::Chorus all;
    std::vector<std::byte> spare;  ///< a block for worlds that are made by the way
    std::vector<std::byte> image, earlier, packed, unpacked;
    std::vector<std::byte> recording, longer_recording;
    std::vector<std::byte> island;
    bool trace = std::getenv("ISLET_FUZZ_TRACE") != nullptr;
    unsigned long inputs = 0, calls = 0, refused = 0, steps = 0;

    Fixture();
    ~Fixture();
};

struct Player : Caller {
    Player(World& other, Fixture& fixture, Reader reader) : Caller(fixture.all, reader), twin(other), f(fixture) {}

    World& twin;  ///< is to have the same future, on other lanes and workers
    Fixture& f;
    MoverState mover = {};
    std::size_t earlier_bytes = 0;      ///< of the image taken before, 0 if there is none
    std::span<std::byte> recorded = {};  ///< where the recording goes

    void play();

    // api_fuzz.cpp
    void set_hooks(std::uint32_t number) override;
    void change_host();

    // reads.cpp: none of these may change the world
    void read();
    void read_world();
    void read_body(BodyId b);
    void read_shape(ShapeId s);
    void read_joint(JointId j);
    void read_contacts(BodyId b);

    // queries.cpp: nor these
    void ask();
    void ask_by_casts();
    void ask_by_overlaps();

    // drawing.cpp
    void draw();

    // matrices.cpp
    void solve_island(BodyId b);
    void solve_matrix();

    // values.cpp: what needs no world
    void try_geometry();
    void try_math();
    void try_create();

    // futures.cpp
    void start_recording();
    void move_recording();
    void round_trip();
    void pack(std::span<const std::byte> bytes);
    void damage(std::span<std::byte> bytes);
    void replay_all();

    // api_fuzz.cpp
    void furnish();
    void step();
    void walk();
    void check();
};

/// What the world holds, for who looks into a finding.
void print(const World& world);

}  // namespace islet::fuzz
