#include "../exact.hpp"

#include "../mover/mover_slide.hpp"

#include "../collide/manifold.hpp"
#include "../step/one_way.hpp"

namespace islet::detail {
namespace {

constexpr std::uint32_t slide_passes = 8;
constexpr float no_way = 1e-6f;            // m: shorter ways are not gone
constexpr float least_edge_slope = 0.05f;  // an edge whose normal points up less than this is a wall
constexpr float edge_probe = 0.03f;        // m: how far inside an edge its surface is probed
constexpr float leave_speed = 3;           // m/s, at which a mover leaves what overlaps it, besides that one's own speed
constexpr float leave_aside = 1.5f;        // how much farther than out of one surface it may go to leave two

ShapeProxy capsule_of(const Mover& m, float growth) {
    ShapeProxy p;
    p.points[0] = m.state.position + m.def.capsule.point1;
    p.points[1] = m.state.position + m.def.capsule.point2;
    p.count = 2;
    p.radius = m.def.capsule.radius + growth;
    return p;
}

bool stands_in_the_way(const Mover& m, const Surface& s) {
    if (has_one_way) {
        const Vec2 points[] = {m.def.capsule.point1, m.def.capsule.point2};
        const Corners capsule = {points, 2, m.def.capsule.radius};
        const Core& core = Core::of(m.world);
        const std::uint32_t shape = s.shape.index1 - 1;
        // A platform that rises may have come up into the mover in the last step of the world, in which the mover stood where it began its own.
        const bool above = height_above(core, shape, capsule, {m.state.position, {}}) >= least_above ||
                           height_before(core, shape, capsule, {m.start, {}}, m.dt) >= least_above;
        if (!above) return false;
    }
    const MoverFilter collides_hook = m.def.collides;
    if (collides_hook == nullptr) return true;
    const Closed closed(Core::of(m.world));
    return collides_hook(s, m.def.context);
}

float worst_breach(Vec2 x, const Bound* bounds, std::uint32_t count) {
    float worst = 0;
    for (std::uint32_t i = 0; i < count; ++i) worst = max(worst, bounds[i].least - dot(bounds[i].normal, x));
    return worst;
}

}  // namespace

Vec2 Mover::support() const {
    const Vec2 p = def.capsule.point1;
    const Vec2 q = def.capsule.point2;
    return state.position + (dot(p, up) <= dot(q, up) ? p : q);
}

float Mover::height_of(Vec2 point) const { return dot(point - support(), up) + def.capsule.radius; }

Touched touched_by(const Mover& m) {
    Touched t;
    const std::uint32_t count = m.world.surfaces_near(capsule_of(m, 0), mover_gap + mover_touch, t.surfaces, m.def.filter);
    for (std::uint32_t i = 0; i < count && i < mover_planes; ++i) {
        if (stands_in_the_way(m, t.surfaces[i])) t.surfaces[t.count++] = t.surfaces[i];
    }
    return t;
}

// The nearest point of a convex set bounded by lines is the point itself, its projection on a line, or a crossing of two lines. The function tries all of
// these.
Vec2 within_bounds(Vec2 wanted, const Bound* bounds, std::uint32_t count, bool& room) {
    const float tolerance = 1e-6f + 1e-5f * length(wanted);
    Vec2 best = wanted;
    float best_breach = worst_breach(wanted, bounds, count);
    float best_distance = 0;
    const auto consider = [&](Vec2 x) {
        const float breach = worst_breach(x, bounds, count);
        const float distance = distance_squared(x, wanted);
        const bool keeps = breach <= tolerance;
        const bool better = keeps ? best_breach > tolerance || distance < best_distance : breach < best_breach - tolerance;
        if (!better) return;
        best = x;
        best_breach = breach;
        best_distance = distance;
    };
    if (best_breach > tolerance) {
        for (std::uint32_t i = 0; i < count; ++i) {
            const Bound& a = bounds[i];
            const Vec2 onto_a = (a.least - dot(a.normal, wanted)) * a.normal;
            consider(wanted + onto_a);
            for (std::uint32_t j = i + 1; j < count; ++j) {
                const Bound& b = bounds[j];
                const float across = cross(a.normal, b.normal);
                if (abs(across) > 1e-3f) {
                    consider((1.0f / across) * Vec2{a.least * b.normal.y - b.least * a.normal.y, b.least * a.normal.x - a.least * b.normal.x});
                } else if (dot(a.normal, b.normal) < 0) {
                    consider(wanted + 0.5f * (onto_a + (b.least - dot(b.normal, wanted)) * b.normal));  // midway between two surfaces that face each other
                }
            }
        }
    }
    room = best_breach <= tolerance;
    return best;
}

void set_bounds(Mover& m, const Touched& t, Bound (&bounds)[mover_planes]) {
    for (std::uint32_t i = 0; i < t.count; ++i) {
        const Surface& s = t.surfaces[i];
        bounds[i] = {s.normal, mover_gap - s.separation};
        if (s.separation >= 0) continue;
        const float speed = max(dot(m.world.velocity_at(m.world.body(s.shape), s.point), s.normal), 0.0f) + leave_speed;
        const float most = mover_gap + max(speed * m.dt - m.leaving, 0.0f);
        if (bounds[i].least <= most) continue;
        bounds[i].least = most;
        m.state.squeezed = 1;
    }
}

Vec2 next_piece(Mover& m, Vec2 way, const Bound* bounds, std::uint32_t count) {
    bool room = true;
    Vec2 piece = within_bounds(way, bounds, count, room);
    float farthest = mover_gap + leave_speed * m.dt;
    for (std::uint32_t i = 0; i < count; ++i) farthest = max(farthest, bounds[i].least);
    const float most = length(way) + max(leave_aside * farthest - m.leaving, 0.0f), size = length(piece);
    const bool too_far = size > 1.00001f * most + no_way;
    if (too_far) piece *= most / size;
    if (!room || too_far) m.state.squeezed = 1;
    return piece;
}

void go(Mover& m, float fraction, Vec2 piece, Vec2 way) {
    m.state.position += fraction * piece;
    m.leaving += max(fraction * length(piece) - length(way), 0.0f);
}

Met way_ahead(const Mover& m, Vec2 way, float distance) {
    struct Search {
        const Mover& mover;
        Vec2 way;
        float distance;
        Met met;
    } search{m, way, distance, {}};
    const CastVisitor visit = [](const QueryHit& hit, void* context) {
        Search& s = *static_cast<Search*>(context);
        const float into = -dot(hit.normal, s.way);
        if (hit.separation < 0 && into <= 1e-4f * length(s.way)) return -1.0f;
        const Surface surface{hit.shape, hit.point, hit.normal, hit.separation < 0 ? hit.separation + s.distance : 0};
        if (!stands_in_the_way(s.mover, surface)) return -1.0f;
        s.met = {hit.fraction, true, surface};
        return 0.0f;
    };
    m.world.cast_shape_each(capsule_of(m, distance), way, m.def.filter, visit, &search);
    return search.met;
}

void slide(Mover& m, Vec2 way) {
    for (std::uint32_t pass = 0; pass < slide_passes; ++pass) {
        const Touched t = touched_by(m);
        Bound bounds[mover_planes];
        set_bounds(m, t, bounds);
        const Vec2 piece = next_piece(m, way, bounds, t.count);
        if (!(length_squared(piece) > no_way * no_way)) return;
        const float fraction = way_ahead(m, piece).fraction;
        go(m, fraction, piece, way);
        // The rest of the way is barred. One more pass keeps the gap to surfaces that have come near.
        way = fraction == 1 ? Vec2{} : way - fraction * piece;
    }
}

bool finds_ground(const Mover& m, Vec2 from, float depth, Vec2& normal) {
    struct Search {
        const Mover& mover;
        QueryHit hit;
    } search{m, {}};
    const CastVisitor visit = [](const QueryHit& hit, void* context) {
        Search& s = *static_cast<Search*>(context);
        if (!stands_in_the_way(s.mover, {hit.shape, hit.point, hit.normal, hit.separation})) return -1.0f;
        s.hit = hit;
        return 0.0f;
    };
    m.world.cast_ray_each(from, -depth * m.up, m.def.filter, visit, &search);
    normal = search.hit.normal;
    return search.hit && search.hit.separation == 0 && dot(normal, m.up) >= m.least_up;
}

bool is_edge(const Mover& m, const Surface& s, Vec2& top) {
    const Vec2 inward = dot(s.normal, m.right) > 0 ? -m.right : m.right;
    return finds_ground(m, s.point + edge_probe * inward + edge_probe * m.up, 2.0f * edge_probe, top);
}

bool can_stand_on(const Mover& m, const Surface& s, Vec2& face) {
    const float rise = dot(s.normal, m.up);
    face = s.normal;
    if (rise >= m.least_up) return true;
    return rise >= least_edge_slope && m.height_of(s.point) <= m.def.step_height && is_edge(m, s, face);
}

}  // namespace islet::detail
