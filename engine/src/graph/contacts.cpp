#include "../exact.hpp"

#include "../graph/contacts.hpp"

#include <cstring>

#include "../graph/contact_parts.hpp"
#include "../graph/joint_graph.hpp"
#include "../graph/mixing.hpp"
#include "../graph/sensors.hpp"
#include "../math/scalar.hpp"
#include "../shapes/shape_types.hpp"

namespace islet::detail {

namespace {

inline constexpr float shared_normal = 0.9f;        // cosine of the angle up to which two normals count as one
inline constexpr std::uint32_t most_compared = 16;  // contacts of two bodies, the newest: each is compared with these; more than four count as four

const Geometry& geometry_of_shape(const Core& core, std::uint32_t shape) { return core.geometries[core.shapes[shape].geometry]; }
std::uint32_t rank(const Core& core, std::uint32_t shape) { return rank_of(geometry_of_shape(core, shape)); }
bool is_solid(const Core& core, std::uint32_t shape) { return kind_of(geometry_of_shape(core, shape)) == ShapeKind::solid; }

bool filters_agree(const Filter& a, const Filter& b) {
    if (a.group == b.group && a.group != 0) return a.group > 0;
    return (a.mask & b.category) != 0 && (b.mask & a.category) != 0;
}

}  // namespace

bool may_collide(const Core& core, std::uint32_t shape_1, std::uint32_t shape_2) {
    const Shape& s1 = core.shapes[shape_1];
    const Shape& s2 = core.shapes[shape_2];
    if (s1.body == s2.body || ((core.bodies[s1.body].flags | core.bodies[s2.body].flags) & body_disabled) != 0) return false;
    if (has_endless && is_endless(core.geometries[s1.geometry]) && is_endless(core.geometries[s2.geometry])) return false;
    if (has_sensors && ((s1.flags | s2.flags) & shape_sensor) != 0) return may_sense(core, s1, s2) && filters_agree(s1.filter, s2.filter);
    if (!core.is_dynamic(s1.body) && !core.is_dynamic(s2.body)) return false;
    if (!filters_agree(s1.filter, s2.filter)) return false;
    if (!is_solid(core, shape_1) && !is_solid(core, shape_2)) return false;
    return !joint_forbids(core, s1.body, s2.body);
}

bool in_contact_order(const Core& core, std::uint32_t shape_1, std::uint32_t shape_2) {
    const std::uint32_t rank_1 = rank(core, shape_1);
    const std::uint32_t rank_2 = rank(core, shape_2);
    return rank_1 != rank_2 ? rank_1 > rank_2 : shape_1 < shape_2;
}

bool create_contact(Core& core, std::uint32_t shape_1, std::uint32_t shape_2) {
    const std::uint32_t index = pool_take(core.state->contact_pool, core.contacts, core.capacity.contacts);
    if (index == null_index) return false;

    fill_contact(core, index, shape_1, shape_2);
    const ContactManifold& m = core.manifolds[index];
    attach_contact(core, index, 0, m.body_a);
    attach_contact(core, index, 1, m.body_b);
    if (has_pair_set) core.pairs.insert(PairSet::key(shape_1, shape_2));
    const bool awake = note_awake(core, index);
    if (has_sensors && !awake && (m.flags & contact_sensor) != 0 && overlaps_sensor(core, index)) begin_overlap(core, index);  // no update will visit it
    return true;
}

bool find_in_lists(const Core& core, std::uint32_t shape_1, std::uint32_t shape_2) {
    const Body& body_1 = core.bodies[core.shapes[shape_1].body];
    const Body& body_2 = core.bodies[core.shapes[shape_2].body];
    bool found = false;
    for_each_constraint(core.contacts, (body_1.contact_count < body_2.contact_count ? body_1 : body_2).contact_head, [&](std::uint32_t i, std::uint32_t) {
        const Contact& c = core.contacts[i];
        found = found || (c.shape_a == shape_1 && c.shape_b == shape_2) || (c.shape_a == shape_2 && c.shape_b == shape_1);
    });
    return found;
}

void destroy_contact(Core& core, std::uint32_t index) {
    leave_contact(core, index);
    const ContactManifold& m = core.manifolds[index];
    detach_contact(core, index, 0, m.body_a);
    detach_contact(core, index, 1, m.body_b);
    if (has_pair_set) core.pairs.erase(pair_key(core, index));
    core.awake_contacts.clear(index);
    clear_contact(core, index);
    pool_give(core.state->contact_pool, core.contacts, index);
}

void count_sharers(Core& core, std::uint32_t contact) {
    ContactManifold& own = core.manifolds[contact];
    const std::uint32_t body_a = own.body_a, body_b = own.body_b;
    const Body &a = core.bodies[body_a], &b = core.bodies[body_b];
    const bool touches = (own.flags & contact_touching) != 0;
    if (touches ? a.shape_count < 2 && b.shape_count < 2 : own.sharers() == 1) return;
    if (!touches) own.set_sharers(1);
    if (!core.is_dynamic(body_a) || !core.is_dynamic(body_b)) return;
    const auto for_each_between = [&](auto&& visit) {
        for_each_constraint(core.contacts, (a.contact_count < b.contact_count ? a : b).contact_head, [&](std::uint32_t i, std::uint32_t) {
            ContactManifold& m = core.manifolds[i];
            if ((m.flags & contact_touching) == 0) return;
            if (m.body_a == body_a && m.body_b == body_b) visit(m, m.normal);
            if (m.body_a == body_b && m.body_b == body_a) visit(m, -m.normal);
        });
    };
    Vec2 normals[most_compared];
    std::uint32_t compared = 0;
    for_each_between([&](const ContactManifold&, Vec2 normal) {
        if (compared < most_compared) normals[compared++] = normal;
    });
    for_each_between([&](ContactManifold& m, Vec2 normal) {
        std::uint32_t sharers = 0;
        for (std::uint32_t k = 0; k < compared; ++k) sharers += dot(normal, normals[k]) > shared_normal ? 1 : 0;
        m.set_sharers(sharers);
        if (m.sharers() > 1) core.state->asked |= asked_sharing;
    });
}

void mix_materials(Core& core, std::uint32_t contact) {
    Contact& c = core.contacts[contact];
    const Shape& a = core.shapes[c.shape_a];
    const Shape& b = core.shapes[c.shape_b];
    ContactManifold& m = core.manifolds[contact];
    c.forget_own_speed();
    if (has_sensors && (m.flags & contact_sensor) != 0) return;
    m.friction = mixed_friction(core, a, b);
    const bool bouncy = has_restitution && mixed_restitution(core, a, b) > 0;
    const bool special = has_surfaces && a.rolling_resistance + b.rolling_resistance + abs(a.tangent_speed) + abs(b.tangent_speed) > 0;
    if (special != ((m.flags & contact_special) != 0)) m.rolling_impulse = 0;
    const std::uint32_t told = a.flags | b.flags;
    const bool was_one_way = (m.flags & contact_one_way) != 0;
    m.flags = (m.flags & ~static_cast<std::uint32_t>(contact_special | contact_bouncy | contact_hits | contact_asks | contact_one_way)) |
              (special ? std::uint32_t{contact_special} : 0u) | (bouncy ? std::uint32_t{contact_bouncy} : 0u) |
              (has_hits && (told & shape_hit_events) != 0 ? std::uint32_t{contact_hits} : 0u) |
              (has_hooks && (told & shape_pre_solve) != 0 ? std::uint32_t{contact_asks} : 0u) |
              (has_one_way && (told & shape_one_way_bits) != 0 ? std::uint32_t{contact_one_way} : 0u);
    if ((m.flags & contact_one_way) == 0) m.flags &= ~static_cast<std::uint32_t>(contact_passes | contact_dropped);
    if ((m.flags & contact_one_way) != 0 && !was_one_way) m.flags &= ~static_cast<std::uint32_t>(contact_posed);  // decided anew: one_way.cpp
}

void drop_told_ends(Core& core) {
    const std::uint32_t pending = core.end_count - core.end_reported;
    std::memmove(core.end_events, core.end_events + core.end_reported, std::size_t{pending} * sizeof(TouchEvent));
    core.end_count = pending;
    core.end_reported = 0;
    if (!has_sensors) return;
    core.sensor_ends.events += core.sensor_ends_reported;
    core.sensor_ends.count -= core.sensor_ends_reported;
    core.sensor_ends_reported = 0;
}

bool has_room_for_begin(Core& core) {
    if (core.begun + core.begin_count + core.sensor_begins.count < event_capacity(core.capacity)) return true;
    ++core.report.dropped_events;
    core.fail(Error::events_full);
    return false;
}

void note_begin(Core& core, std::uint32_t contact) {
    if (!has_room_for_begin(core)) return;
    core.begins.set(contact);
    ++core.begun;
}

bool has_room_for_end(Core& core) {
    if (core.end_count + core.sensor_ends.count < event_capacity(core.capacity)) return true;
    // What was told already gives way: whether there is room must not depend on it, for a copy of the world does not have it.
    if (core.end_reported + core.sensor_ends_reported != 0) {
        drop_told_ends(core);
        return true;
    }
    ++core.report.dropped_events;
    core.fail(Error::events_full);
    return false;
}

void record_end_event(Core& core, std::uint32_t contact) {
    const Contact& c = core.contacts[contact];
    if (has_room_for_end(core)) push_touch(core, core.end_events, core.end_count, core.sensor_ends, {core.shape_id(c.shape_a), core.shape_id(c.shape_b)});
}

}  // namespace islet::detail
