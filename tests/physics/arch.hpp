// A half circle of equal stones that stands on the ground.
#pragma once

#include <vector>

#include "support/test_world.hpp"

namespace islet::test {

/// Adds the stones, the rightmost first. Inner radius and thickness in m; off() says by how much a stone is put beside its place, m.
template <class Off>
std::vector<BodyId> add_arch(TestWorld& world, int stones, float radius, float thickness, const ShapeDef& stone, Off&& off) {
    std::vector<BodyId> arch;
    for (int i = 0; i < stones; ++i) {
        const auto corner = [&](float from_center, int side) {
            const Rot q = make_rot(pi * static_cast<float>(i + side) / static_cast<float>(stones));
            return from_center * Vec2{q.c, q.s};
        };
        const float outer = radius + thickness;
        const Vec2 middle = 0.25f * (corner(radius, 0) + corner(radius, 1) + corner(outer, 0) + corner(outer, 1));
        const Vec2 corners[] = {corner(radius, 0) - middle, corner(outer, 0) - middle, corner(outer, 1) - middle, corner(radius, 1) - middle};
        arch.push_back(world.add(make_polygon(compute_hull(corners)), middle + off(), stone));
    }
    return arch;
}

}  // namespace islet::test
