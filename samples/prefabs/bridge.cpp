#include "bridge.hpp"

#include "span.hpp"

namespace islet::samples {

Prefab make_bridge(const BridgeDef& def) {
    SpanDef span;
    span.from = def.from;
    span.to = def.to;
    span.slack = def.slack;
    span.links = def.planks;
    span.hold_from = true;
    span.hold_to = true;
    span.hinge.friction = def.stiffness;
    span.hinge.spring = {.enable = def.hertz > 0, .hertz = def.hertz, .damping_ratio = 1};
    span.hinge.base.break_force = def.break_force;
    ShapeDef wood;
    wood.density = def.density;
    wood.friction = def.friction;
    // Rounded by half its thickness, so that no corner opens between planks that are bent against each other.
    return make_span(span, [&](float half, std::size_t) {
        return std::vector<SceneShape>{{Capsule{{-half, 0}, {half, 0}, 0.5f * def.thickness}, wood}};
    });
}

}  // namespace islet::samples
