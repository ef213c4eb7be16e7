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

void hold(Prefab& span, std::size_t link, Vec2 place, float end, RevoluteJointDef hinge) {
    BodyDef holder;
    holder.position = place;
    span.bodies.push_back({holder, {}});
    hinge.base.frame_a = {};
    hinge.base.frame_b.position = {end, 0};
    span.joints.push_back({span.bodies.size() - 1, link, hinge});
}

}  // namespace

float half_link(const SpanDef& def) { return 0.5f * def.slack * distance(def.from, def.to) / static_cast<float>(def.links); }

Prefab make_span(const SpanDef& def, const std::function<std::vector<SceneShape>(float half, std::size_t index)>& shapes_of_link) {
    const float half = half_link(def), n = static_cast<float>(def.links);
    const Vec2 way = def.to - def.from;
    const float turn = def.slack > 1 ? turn_on_arc(def.links, n / def.slack) : 0;

    Prefab span;
    float angle = atan2(way.y, way.x) - 0.5f * (n - 1) * turn;
    Vec2 end = def.from;
    BodyDef link = def.link;
    link.type = BodyType::dynamic;
    RevoluteJointDef hinge = def.hinge;
    hinge.base.frame_a.position = {half, 0};
    hinge.base.frame_b.position = {-half, 0};
    for (std::size_t i = 0; i < def.links; ++i) {
        const Vec2 arm = rotate(make_rot(angle), {half, 0});
        link.position = end + arm;
        link.angle = angle;
        span.bodies.push_back({link, shapes_of_link(half, i)});
        if (i > 0) span.joints.push_back({i - 1, i, hinge});
        end += 2 * arm;
        angle += turn;
    }

    if (def.hold_from) hold(span, 0, def.from, -half, hinge);
    if (def.hold_to) hold(span, def.links - 1, def.to, half, hinge);
    if (def.rope_limit && def.links > 2) {
        DistanceJointDef limit;
        limit.base.frame_a.position = {-half, 0};
        limit.base.frame_b.position = {half, 0};
        limit.length = 1.01f * 2 * half * n;  // slack enough for the hinges to carry the line's own weight
        limit.limit = {.enable = true, .lower = 0, .upper = limit.length};
        span.joints.push_back({0, def.links - 1, limit});
    }
    return span;
}

}  // namespace islet::samples
