// The public functions on shapes.
#include "../exact.hpp"

#include "../calls/recorder.hpp"
#include "../step/one_way.hpp"
#include "../world/shapes.hpp"

#include "../bodies/bounds.hpp"
#include "../bodies/geometry_pool.hpp"
#include "../bodies/sleep.hpp"
#include "../broadphase/pairs.hpp"
#include "../broadphase/tree.hpp"
#include "../calls/checks.hpp"
#include "../graph/contacts.hpp"
#include "../graph/sensors.hpp"
#include "../math/float_mode.hpp"
#include "../solver/hits.hpp"

namespace islet {

using namespace detail;

namespace {

// Wakes the body at the other side of a contact, if the shapes touch.
ISLET_SHARED void wake_touched(Core& core, std::uint32_t contact, std::uint32_t side) {
    if ((core.manifolds[contact].flags & contact_touching) != 0) wake_island(core, other_body(core, contact, side), core.arena());
}

}  // namespace

namespace detail {

void remove_shape(Core& core, std::uint32_t index) {
    Shape& s = core.shapes[index];
    const std::uint32_t body = s.body;
    Body& b = core.bodies[body];
    end_contacts_of_shape(core, index);
    if (s.tree_node != null_index) tree_remove({&core.state->tree, core.tree}, s.tree_node);
    if (core.moved_shapes.test(index)) {
        core.moved_shapes.clear(index);
        --core.state->moved_count;
    }
    (s.prev != null_index ? core.shapes[s.prev].next : b.shape_head) = s.next;
    if (s.next != null_index) core.shapes[s.next].prev = s.prev;
    --b.shape_count;
    release_geometry(core, s.geometry);
    clear_slot(s);
    core.boxes[index] = Aabb{};
    pool_give(core.state->shape_pool, core.shapes, index);
}

void end_contacts_of_shape(Core& core, std::uint32_t shape, bool unwanted) {
    for_each_contact(core, core.shapes[shape].body, [&](std::uint32_t contact, std::uint32_t side) {
        const Contact& c = core.contacts[contact];
        if ((c.shape_a != shape && c.shape_b != shape) || (unwanted && may_collide(core, c.shape_a, c.shape_b))) return;
        wake_touched(core, contact, side);
        destroy_contact(core, contact);
    });
}

void remix(Core& core, std::uint32_t shape, std::uint32_t forget) {
    for_each_contact(core, core.shapes[shape].body, [&](std::uint32_t contact, std::uint32_t side) {
        const Contact& c = core.contacts[contact];
        if (c.shape_a != shape && c.shape_b != shape) return;
        core.manifolds[contact].flags &= ~forget;
        mix_materials(core, contact);
        wake_touched(core, contact, side);
    });
    wake_island(core, core.shapes[shape].body, core.arena());
}

}  // namespace detail

namespace {

void list_shape(Core& core, std::uint32_t body, std::uint32_t index, std::uint32_t geometry, const ShapeDef& def) {
    Shape& s = core.shapes[index];
    Body& b = core.bodies[body];
    clear_slot(s);
    s.geometry = geometry;
    s.body = body;
    s.friction = def.friction;
    s.restitution = def.restitution;
    s.rolling_resistance = def.rolling_resistance;
    s.tangent_speed = def.tangent_speed;
    s.density = def.density;
    s.flags = (def.sensor ? std::uint32_t{shape_sensor} : 0u) | (def.sensor_events ? 0u : std::uint32_t{shape_unseen}) |
              (def.hit_events ? std::uint32_t{shape_hit_events} : 0u) | (def.pre_solve ? std::uint32_t{shape_pre_solve} : 0u);
    s.flags |= flags_of_direction(normalize(def.one_way));
    core.state->asked |= asked_of(s.flags);
    s.material = def.material;
    s.filter = def.filter;
    s.user_data = def.user_data;
    s.next = b.shape_head;
    if (b.shape_head != null_index) core.shapes[b.shape_head].prev = index;
    b.shape_head = index;
    ++b.shape_count;
    core.boxes[index] = {{1, 1}, {-1, -1}};  // an empty box, which update_boxes makes anew
}

}  // namespace

namespace detail {

bool check_shape_def(const Core& core, const ShapeDef& d) {
    const bool finite = all_finite(d.friction, d.restitution, d.rolling_resistance, d.tangent_speed, d.density);
    return check(core, finite, Error::not_finite) && check_finite(core, d.one_way) && check_there(core, d.one_way == Vec2{} || has_one_way) &&
           check_range(core, d.friction, 0, max_coefficient) && check_range(core, d.restitution, 0, 1) &&
           check_range(core, d.rolling_resistance, 0, max_coefficient) && check_range(core, d.tangent_speed, -max_speed_limit, max_speed_limit) &&
           check_range(core, d.density, 0, no_limit) && check_there(core, has_restitution || d.restitution == 0) &&
           check_there(core, has_surfaces || (d.rolling_resistance == 0 && d.tangent_speed == 0)) && check_there(core, !d.sensor || has_sensors) &&
           check_there(core, !d.hit_events || has_hits) && check_there(core, !d.pre_solve || has_hooks);
}

void shapes_changed(Core& core, std::uint32_t body, std::uint32_t newest) {
    const DefaultFloatMode mode;
    if (core.bodies[body].type() != BodyType::static_body) newest = every_shape;
    update_mass(core, body, newest);
    refit_boxes(core, body, newest);
}

std::uint32_t add_shape(Core& core, std::uint32_t body, const Geometry& g, const ShapeDef& def) {
    if (!check(core, core.state->shape_pool.count < core.capacity.shapes, Error::shapes_full)) return null_index;
    const std::uint32_t geometry = share_geometry(core, g);
    if (!check(core, geometry != null_index, Error::geometries_full)) return null_index;
    const std::uint32_t index = pool_take(core.state->shape_pool, core.shapes, core.capacity.shapes);
    list_shape(core, body, index, geometry, def);
    return index;
}

ShapeId attach_shape(Core& core, BodyId id, const Geometry& g, bool valid, const ShapeDef& def) {
    const std::uint32_t body = find_slot(core, id);
    if (body == null_index || !check(core, valid, Error::bad_geometry) || !check_shape_def(core, def)) return {};
    if (!check(core, !is_endless(g) || !core.is_dynamic(body), Error::endless_shape)) return {};
    const std::uint32_t index = add_shape(core, body, g, def);
    if (index == null_index) return {};
    shapes_changed(core, body, 1);
    return core.shape_id(index);
}

}  // namespace detail

// A type that only programs which make it link has a file of its own.
#define ISLET_CREATE(name, Type, feature, kind, linked) ISLET_CREATE_##linked(name, Type)
#define ISLET_CREATE_always ISLET_DEFINE_CREATE_SHAPE
#define ISLET_CREATE_when_made(name, Type)
ISLET_SHAPE_TYPES(ISLET_CREATE)

void World::destroy_shape(ShapeId id) {
    const auto [c, i] = begin_call<Call::destroy_shape>(core(), id);
    if (i == null_index) return;
    const std::uint32_t body = c.shapes[i].body;
    wake_island(c, body, c.arena());
    const bool spared = c.bodies[body].type() == BodyType::static_body && is_within_others(c, i);
    remove_shape(c, i);
    shapes_changed(c, body, spared ? 0 : every_shape);
}

bool World::is_valid(ShapeId id) const { return pool_holds(core().state->shape_pool, core().shapes, id); }
std::uint32_t World::shape_count() const { return core().state->shape_pool.count; }

ShapeId World::shape_at(std::uint32_t slot) const {
    const Core& c = core();
    return pool_live(c.state->shape_pool, c.shapes, slot) ? c.shape_id(slot) : ShapeId{};
}

BodyId World::body(ShapeId id) const { ISLET_READ(c.body_id(c.shapes[i].body)); }
ShapeType World::shape_type(ShapeId id) const { ISLET_READ(c.geometries[c.shapes[i].geometry].shape_type()); }
Aabb World::aabb(ShapeId id) const { ISLET_READ(shape_aabb(c, i)); }
float World::density(ShapeId id) const { ISLET_READ(c.shapes[i].density); }
float World::friction(ShapeId id) const { ISLET_READ(c.shapes[i].friction); }
float World::restitution(ShapeId id) const { ISLET_READ(c.shapes[i].restitution); }
float World::rolling_resistance(ShapeId id) const { ISLET_READ(c.shapes[i].rolling_resistance); }
float World::tangent_speed(ShapeId id) const { ISLET_READ(c.shapes[i].tangent_speed); }
Filter World::filter(ShapeId id) const { ISLET_READ(c.shapes[i].filter); }
std::uint64_t World::user_data(ShapeId id) const { ISLET_READ(c.shapes[i].user_data); }

namespace {

const Geometry* geometry_if(const Core& c, ShapeId id, ShapeType type) {
    const std::uint32_t i = find_slot(c, id);
    if (i == null_index) return nullptr;
    const Geometry& g = c.geometries[c.shapes[i].geometry];
    return g.shape_type() == type ? &g : nullptr;
}

}  // namespace

#define ISLET_DEFINE_READ(name, Type, ...)                            \
    const Type* World::name(ShapeId id) const {                       \
        const Geometry* g = geometry_if(core(), id, ShapeType::name); \
        return g != nullptr ? &g->name : nullptr;                     \
    }
ISLET_SHAPE_TYPES(ISLET_DEFINE_READ)

void World::set_friction(ShapeId id, float friction) {
    const auto [c, i] = begin_call<Call::set_friction>(core(), id, friction);
    if (i == null_index || !check_range(c, friction, 0, max_coefficient)) return;
    c.shapes[i].friction = friction;
    remix(c, i);
}

void World::set_restitution(ShapeId id, float restitution) {
    const auto [c, i] = begin_call<Call::set_restitution>(core(), id, restitution);
    if (i == null_index || !check_range(c, restitution, 0, 1) || !check_there(c, has_restitution || restitution == 0)) return;
    c.shapes[i].restitution = restitution;
    remix(c, i);
}

void World::set_rolling_resistance(ShapeId id, float resistance) {
    const auto [c, i] = begin_call<Call::set_rolling_resistance>(core(), id, resistance);
    if (i == null_index || !check_range(c, resistance, 0, max_coefficient) || !check_there(c, has_surfaces || resistance == 0)) return;
    c.shapes[i].rolling_resistance = resistance;
    remix(c, i);
}

void World::set_tangent_speed(ShapeId id, float speed) {
    const auto [c, i] = begin_call<Call::set_tangent_speed>(core(), id, speed);
    if (i == null_index || !check_range(c, speed, -max_speed_limit, max_speed_limit)) return;
    if (!check_there(c, has_surfaces || speed == 0)) return;
    c.shapes[i].tangent_speed = speed;
    remix(c, i);
}

void World::set_filter(ShapeId id, const Filter& filter) {
    const auto [c, i] = begin_call<Call::set_filter>(core(), id, filter);
    if (i == null_index) return;
    c.shapes[i].filter = filter;
    wake_island(c, c.shapes[i].body, c.arena());
    end_contacts_of_shape(c, i, true);
    mark_moved(c, i);
}

void World::set_user_data(ShapeId id, std::uint64_t data) {
    const auto [c, i] = begin_call<Call::set_shape_user_data>(core(), id, data);
    if (i != null_index) c.shapes[i].user_data = data;
}

}  // namespace islet
