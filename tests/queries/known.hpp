// All shapes of a world as solids in double precision, by its public functions.
#pragma once

#include "oracle.hpp"
#include "support/test_world.hpp"

namespace islet::test {

struct Known {
    ShapeId id;
    oracle::Solid solid;
    Filter filter;
    bool sensor = false;
    bool enabled = true;
    exact::Point center;
    double reach = 0;  // of the solid around its centre
};

inline ShapeProxy proxy_of(const World& w, ShapeId id) {
    switch (w.shape_type(id)) {
    case ShapeType::circle: return make_proxy(*w.circle(id));
    case ShapeType::capsule: return make_proxy(*w.capsule(id));
    case ShapeType::segment: return make_proxy(*w.segment(id));
    case ShapeType::polygon: return make_proxy(*w.polygon(id));
    case ShapeType::chain_segment: return make_proxy(*w.chain_segment(id));
    case ShapeType::half_space: break;  // stands for no hull: half_space_test.cpp
    }
    return {};
}

// All shapes by ascending slot.
inline std::vector<Known> known_shapes(const TestWorld& w) {
    std::vector<Known> all;
    for (const BodyId body : w.bodies()) {
        std::vector<ShapeId> ids(w->shapes(body, {}));
        w->shapes(body, ids);
        for (const ShapeId id : ids) {
            Known k;
            k.id = id;
            k.solid = oracle::solid_of(proxy_of(*w, id), w->transform(body));
            k.filter = w->filter(id);
            k.sensor = w->is_sensor(id);
            k.enabled = w->is_enabled(body);
            for (const exact::Point p : k.solid.core) k.center = k.center + (1.0 / double(k.solid.core.size())) * p;
            for (const exact::Point p : k.solid.core) k.reach = std::max(k.reach, exact::length(p - k.center) + k.solid.radius);
            all.push_back(k);
        }
    }
    std::sort(all.begin(), all.end(), [](const Known& a, const Known& b) { return a.id.index1 < b.id.index1; });
    return all;
}

}  // namespace islet::test
