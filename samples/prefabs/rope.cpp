#include "rope.hpp"

#include "span.hpp"

namespace islet::samples {
namespace {

SpanDef span_of(const RopeDef& def) {
    SpanDef span = line_of(def);
    span.rope_limit = true;
    span.hinge.friction = def.stiffness;
    span.link.linear_damping = def.damping;
    span.link.angular_damping = def.damping;
    span.radius = def.radius;
    return span;
}

}  // namespace

void assemble(const RopeDef& def, Assembler& into) { assemble(span_of(def), into); }

JointFrame rope_start(const RopeDef& def) { return span_start(span_of(def)); }
JointFrame rope_end(const RopeDef& def) { return span_end(span_of(def)); }

}  // namespace islet::samples
