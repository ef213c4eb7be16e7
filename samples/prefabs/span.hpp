// A line of links, hinged end to end: what ropes, chains and bridges are.
#pragma once

#include "prefab.hpp"

namespace islet::samples {

struct SpanDef {
    Vec2 from = {}, to = {};  ///< m
    float slack = 1;          ///< >= 1: the line's length over the distance of its ends
    std::size_t links = 1;
    float radius = 0.1f;          ///< m, of a link, which is a capsule from hinge to hinge
    ShapeDef material = {};       ///< of the links
    bool flat_links = false;      ///< links 0, 2, 4, ... are steel links seen flat: three wires wide, `radius` being the wire's
    bool hold_from = false;       ///< a static body holds this end
    bool hold_to = false;         ///< and this one
    bool rope_limit = false;      ///< one more joint keeps the ends within 1.01 times the line's length, however heavy the load
    RevoluteJointDef hinge = {};  ///< friction, spring and breaking force of every hinge; the rest is filled in
    BodyDef link = {};            ///< damping and the like; the rest is filled in
};

/// What the definitions of ropes and chains have in common.
template <class Def>
SpanDef line_of(const Def& def) {
    SpanDef span = {
        .from = def.from, .to = def.to, .slack = def.slack, .links = def.links, .hold_from = def.hold_from, .hold_to = def.hold_to};
    span.material.density = def.density;
    span.material.filter.group = -def.group;
    return span;
}

/// Half of a link's length, m.
float half_link(const SpanDef& def);
/// Where the line begins and ends on its first and its last link.
inline JointFrame span_start(const SpanDef& def) { return {{-half_link(def), 0}, 0}; }
inline JointFrame span_end(const SpanDef& def) { return {{half_link(def), 0}, 0}; }

/// A link lies along its x axis, from (-half, 0) to (half, 0). Bodies: the links from `from` to `to`, then what holds the ends. Joint i hinges
/// link i to link i + 1; then come the ends' hinges and the limit. Where there is slack, the links start on an arc to the right of the
/// way: below it if `from` is on the left.
void assemble(const SpanDef& def, Assembler& into);

}  // namespace islet::samples
