// Two values are equal if all their fields are. The comparisons are written out, since C++17 makes none, so a new field is easily forgotten there: then the list
// of names below does not fit the struct any more, and this file does not compile.
#include <gtest/gtest.h>

#include <cstring>

#include <islet/islet.hpp>

#include "data/arrays.hpp"

namespace islet {
namespace {

/// Another value of a field: the lowest bit of its first byte is not what it was.
template <class Field>
void change(Field& field) {
    unsigned char bytes[sizeof(Field)];
    std::memcpy(bytes, &field, sizeof field);
    bytes[0] ^= 1;
    std::memcpy(static_cast<void*>(&field), bytes, sizeof field);
}

template <class T, class... Fields>
void expect_all_count(T& value, Fields&... fields) {
    const T before = value;
    EXPECT_TRUE(value == before);
    EXPECT_FALSE(value != before);
    int place = 0;
    const auto expect_one_counts = [&](auto& field) {
        change(field);
        EXPECT_FALSE(value == before) << "field " << place;
        EXPECT_TRUE(value != before) << "field " << place;
        change(field);
        EXPECT_TRUE(value == before) << "field " << place;
        ++place;
    };
    (expect_one_counts(fields), ...);
}

TEST(Equality, CountsEveryField) {
    {
        Vec2 v = {1, 2};
        auto& [x, y] = v;
        expect_all_count(v, x, y);
    }
    {
        Rot v;
        auto& [c, s] = v;
        expect_all_count(v, c, s);
    }
    {
        Transform v = {{1, 2}, {}};
        auto& [p, q] = v;
        expect_all_count(v, p, q, p.y, q.s);
    }
    {
        Aabb v = {{1, 2}, {3, 4}};
        auto& [lower, upper] = v;
        expect_all_count(v, lower, upper, lower.y, upper.y);
    }
    {
        BodyId v = {2, 4};
        auto& [index1, generation] = v;
        expect_all_count(v, index1, generation);
    }
    {
        ShapeId v = {2, 4};
        auto& [index1, generation] = v;
        expect_all_count(v, index1, generation);
    }
    {
        JointId v = {2, 4};
        auto& [index1, generation] = v;
        expect_all_count(v, index1, generation);
    }
    {
        Capacity v;
        auto& [a, b, c, d, e, f, g] = v;
        expect_all_count(v, a, b, c, d, e, f, g);
    }
    {
        SurfaceMaterial v;
        auto& [a, b, c, d, e] = v;
        expect_all_count(v, a, b, c, d, e);
    }
    {
        Hooks v;
        auto& [a, b, c, d, e] = v;
        expect_all_count(v, a, b, c, d, e);
    }
    {
        SolverDef v;
        auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s] = v;
        expect_all_count(v, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s);
    }
    {
        detail::Counts v;
        auto& [a, b, c, d, e, f] = v;
        expect_all_count(v, a, b, c, d, e, f);
    }
}

TEST(StaticWorldOf, IsTheSameWorldAsStaticWorld) {
    static StaticWorldOf<8, 8, 24, 2> by_number;
    static StaticWorld<Capacity{.bodies = 8, .shapes = 8, .contacts = 24, .joints = 2}> by_name;
    static_assert(sizeof by_number == sizeof by_name && decltype(by_number)::bytes == decltype(by_name)::bytes);
    World& a = by_number.create({.gravity = {0, -5}});
    World& b = by_name.create({.gravity = {0, -5}});
    EXPECT_EQ(a.capacity(), (Capacity{8, 8, 24, 2, 0, 0}));
    EXPECT_EQ(a.capacity(), b.capacity());
    for (World* world : {&a, &b}) {
        world->create_shape(world->create_body({.type = BodyType::dynamic}), Circle{});
        for (int i = 0; i < 10; ++i) world->step(1.0f / 60);
    }
    EXPECT_EQ(a.hash(), b.hash());
}

}  // namespace
}  // namespace islet
