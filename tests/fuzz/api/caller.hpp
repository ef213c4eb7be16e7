// Who makes calls of bytes, good and bad ones, to worlds that are to stay equal. Each area of the API is a file of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "hosts.hpp"
#include "reader.hpp"
#include "support/chorus.hpp"

namespace islet::fuzz {

inline void expect(bool holds, const char* what) {
    if (!holds) test::broken(what);
}

/// No world here has more.
inline constexpr std::uint32_t max_shapes = 512;

struct Caller {
    Caller(test::Chorus& worlds, Reader reader) : all(worlds), w(worlds.first()), in(reader) {}
    virtual ~Caller() = default;

    test::Chorus& all;
    World& w;  ///< the first of them
    Reader in;
    BodyId dead_body = {};
    ShapeId dead_shape = {};
    JointId dead_joint = {};

    // arguments.cpp
    BodyId body();
    ShapeId shape();
    JointId joint();
    WorldDef world_def();
    SolverDef solver_def(SolverDef from);
    BodyDef body_def();
    ShapeDef shape_def();
    Filter filter();
    Circle circle();
    Capsule capsule();
    Segment segment();
    ChainSegment chain_segment();
    HalfSpace half_space();
    Polygon polygon();
    ShapeProxy proxy();
    JointSpring spring();
    JointLimit limit();
    JointMotor motor();
    JointRatchet ratchet();
    JointFrame frame();

    // changes.cpp
    void create_shape(BodyId owner);
    void create_joint();
    void change_body();
    void change_shape();
    void change_joint();
    void change_world();
    virtual void set_hooks(std::uint32_t number) { all.set_hooks(number); }
};

}  // namespace islet::fuzz
