#include "span.hpp"

namespace islet::samples {
namespace {

/// The turn from one link to the next on an arc whose `links` sides of length 1 span `chord`: chord = sin(links turn / 2) / sin(turn / 2), which
/// falls as the turn grows.
float turn_on_arc(std::size_t links, float chord) {
    const float n = static_cast<float>(links);
    float low = 0, high = 2 * pi / n;
    for (int i = 0; i < 32; ++i) {
        const float turn = 0.5f * (low + high), sine = make_rot(0.5f * turn).s;
        (sine > 0 && make_rot(0.5f * n * turn).s > chord * sine ? low : high) = turn;
    }
    return low;
}

void assemble_links(const SpanDef& def, float half, Assembler& into) {
    const float n = static_cast<float>(def.links);
    const Vec2 way = def.to - def.from;
    const float turn = def.slack > 1 ? turn_on_arc(def.links, n / def.slack) : 0;
    // Seen flat a link is three wires wide; its weight is that of the two long sides.
    ShapeDef flat = def.material;
    flat.density *= 2.0f / 3;
    float angle = atan2(way.y, way.x) - 0.5f * (n - 1) * turn;
    Vec2 end = def.from;
    BodyDef link = def.link;
    link.type = BodyType::dynamic;
    for (std::size_t i = 0; i < def.links; ++i) {
        const Vec2 arm = rotate(make_rot(angle), {half, 0});
        link.position = end + arm;
        link.angle = angle;
        into.body(link);
        if (def.flat_links && i % 2 == 0)
            into.shape(make_rounded_box(half, 2 * def.radius, def.radius), flat);
        else
            into.shape(Capsule{{-half, 0}, {half, 0}, def.radius}, def.material);
        end += 2 * arm;
        angle += turn;
    }
}

}  // namespace

float half_link(const SpanDef& def) { return 0.5f * def.slack * distance(def.from, def.to) / static_cast<float>(def.links); }

void assemble(const SpanDef& def, Assembler& into) {
    const float half = half_link(def);
    assemble_links(def, half, into);
    BodyDef holder;
    holder.position = def.from;
    if (def.hold_from) into.body(holder);
    holder.position = def.to;
    if (def.hold_to) into.body(holder);

    RevoluteJointDef hinge = def.hinge;
    hinge.base.frame_a.position = {half, 0};
    hinge.base.frame_b.position = {-half, 0};
    for (std::size_t i = 1; i < def.links; ++i) into.joint(i - 1, i, hinge);
    hinge.base.frame_a = {};
    std::size_t next = def.links;
    if (def.hold_from) into.joint(next++, 0, hinge);
    hinge.base.frame_b.position = {half, 0};
    if (def.hold_to) into.joint(next, def.links - 1, hinge);
    if (def.rope_limit && def.links > 2) {
        DistanceJointDef limit;
        limit.base.frame_a.position = {-half, 0};
        limit.base.frame_b.position = {half, 0};
        limit.length = 1.01f * 2 * half * static_cast<float>(def.links);  // slack enough for the hinges to carry the line's own weight
        limit.limit = {.enable = true, .lower = 0, .upper = limit.length};
        into.joint(0, def.links - 1, limit);
    }
}

}  // namespace islet::samples
