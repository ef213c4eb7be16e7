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
    span.radius = 0.5f * def.thickness;  // so a link reaches past its hinges by the wire's radius
    span.flat_links = true;
    span.material.density = def.density;
    span.material.filter.group = -def.group;
    return span;
}

}  // namespace

void assemble(const ChainDef& def, Assembler& into) { assemble(span_of(def), into); }

JointFrame chain_start(const ChainDef& def) { return {{-half_link(span_of(def)), 0}, 0}; }
JointFrame chain_end(const ChainDef& def) { return {{half_link(span_of(def)), 0}, 0}; }

}  // namespace islet::samples
