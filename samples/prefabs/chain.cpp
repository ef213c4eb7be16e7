#include "chain.hpp"

#include "span.hpp"

namespace islet::samples {
namespace {

SpanDef span_of(const ChainDef& def) {
    SpanDef span;
    span.from = def.from;
    span.to = def.to;
    span.slack = def.slack;
    span.links = def.links;
    span.hold_from = def.hold_from;
    span.hold_to = def.hold_to;
    span.hinge.base.break_force = def.break_force;
    return span;
}

}  // namespace

Prefab make_chain(const ChainDef& def) {
    const float wire = 0.5f * def.thickness;
    ShapeDef material;
    material.density = def.density;
    material.filter.group = -def.group;
    return make_span(span_of(def), [&](float half, std::size_t index) {
        // A link reaches past its hinges by the wire's radius. Seen flat it is three wires wide; its weight is that of the two long sides.
        if (index % 2 != 0) return std::vector<SceneShape>{{Capsule{{-half, 0}, {half, 0}, wire}, material}};
        ShapeDef flat = material;
        flat.density *= 2.0f / 3;
        return std::vector<SceneShape>{{make_rounded_box(half, 2 * wire, wire), flat}};
    });
}

JointFrame chain_start(const ChainDef& def) { return {{-half_link(span_of(def)), 0}, 0}; }
JointFrame chain_end(const ChainDef& def) { return {{half_link(span_of(def)), 0}, 0}; }

}  // namespace islet::samples
