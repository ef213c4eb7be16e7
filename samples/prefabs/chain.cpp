#include "chain.hpp"

#include "span.hpp"

namespace islet::samples {
namespace {

SpanDef span_of(const ChainDef& def) {
    SpanDef span = line_of(def);
    span.hinge.base.break_force = def.break_force;
    span.radius = 0.5f * def.thickness;  // so a link reaches past its hinges by the wire's radius
    span.flat_links = true;
    return span;
}

}  // namespace

void assemble(const ChainDef& def, Assembler& into) { assemble(span_of(def), into); }

JointFrame chain_start(const ChainDef& def) { return span_start(span_of(def)); }
JointFrame chain_end(const ChainDef& def) { return span_end(span_of(def)); }

}  // namespace islet::samples
