// What the pieces of programs in the manual take for granted: a world with something in it, a game around it, and a few functions of yours.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <vector>

#include <islet/island.hpp>
#include <islet/islet.hpp>
#include <islet/lcp.hpp>
#include <islet/mover.hpp>

#include "workers/thread_pool.hpp"

using namespace islet;

// The world, and the bodies in it.
extern World& world;
extern World& other;
extern BodyId ground, crate, door, drum;
extern std::span<std::byte> block, buffer;
extern Capacity capacity;

// The game: time, what the player does, where things are.
inline constexpr float dt = 1.0f / 60, h = dt / 4;
extern float owed, elapsed, stick, lowest, strongest;
extern bool pressed;
extern Transform before, now;
extern Vec2 eye, direction, hand, blast;
inline constexpr std::uint32_t wall = 1, enemy = 2, shot = 4, enemies = enemy;

void draw(Vec2 at);
void mark(ShapeId shape, Vec2 point, Vec2 normal);
void open(ShapeId sensor, ShapeId visitor);
void crack(Vec2 point, float speed);
void play();

struct Window {
    void line(Vec2 a, Vec2 b, DrawColor color);
};
extern Window window;

// A problem for the matrix solvers.
extern std::vector<float> m, q, x;
extern std::vector<std::byte> memory;
