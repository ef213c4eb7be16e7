#include "rope.hpp"

#include "span.hpp"

namespace islet::samples {
namespace {

SpanDef span_of(const RopeDef& def) {
    SpanDef span;
    span.from = def.from;
    span.to = def.to;
    span.slack = def.slack;
    span.links = def.links;
    span.hold_from = def.hold_from;
    span.hold_to = def.hold_to;
    span.rope_limit = true;
    span.hinge.friction = def.stiffness;
    span.link.linear_damping = def.damping;
    span.link.angular_damping = def.damping;
    span.radius = def.radius;
    span.material.density = def.density;
    span.material.filter.group = -def.group;
    return span;
}

}  // namespace

void assemble(const RopeDef& def, Assembler& into) { assemble(span_of(def), into); }

JointFrame rope_start(const RopeDef& def) { return {{-half_link(span_of(def)), 0}, 0}; }
JointFrame rope_end(const RopeDef& def) { return {{half_link(span_of(def)), 0}, 0}; }

}  // namespace islet::samples
