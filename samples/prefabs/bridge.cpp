#include "bridge.hpp"

#include "span.hpp"

namespace islet::samples {

void assemble(const BridgeDef& def, Assembler& into) {
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
    span.material.density = def.density;
    span.material.friction = def.friction;
    span.radius = 0.5f * def.thickness;  // round ends: no corner opens between planks that are bent against each other
    assemble(span, into);
}

}  // namespace islet::samples
