// Random shapes of every type.
#pragma once

#include "islet/query.hpp"
#include "unit/exact_geometry.hpp"

namespace islet::test {

/// Within about `size` of the frame's origin: circles, capsules, segments, polygons sharp and round, one-sided segments.
inline ShapeProxy random_shape(exact::Random& r, double size, bool with_one_sided = true) {
    const auto point = [&] { return Vec2{r.in(-size, size), r.in(-size, size)}; };
    const float radius = r.in(0.05 * size, 0.5 * size);
    for (;;) {
        ShapeProxy p;
        switch (r.below(with_one_sided ? 6 : 5)) {
        case 0: p = make_proxy(Circle{point(), radius}); break;
        case 1: p = make_proxy(Capsule{point(), point(), radius}); break;
        case 2: p = make_proxy(Segment{point(), point()}); break;
        case 3: p = make_proxy(exact::random_polygon(r, size)); break;
        case 4: p = make_proxy(exact::random_polygon(r, size, radius)); break;
        default: p = make_proxy(ChainSegment{point(), {point(), point()}, point()});
        }
        if (p.count > 0) return p;
    }
}

}  // namespace islet::test
