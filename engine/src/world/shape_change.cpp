// Changing a shape's geometry, density, material and events.
#include "../exact.hpp"

#include "../bodies/bounds.hpp"
#include "../bodies/geometry_pool.hpp"
#include "../bodies/sleep.hpp"
#include "../broadphase/pairs.hpp"
#include "../broadphase/tree.hpp"
#include "../calls/checks.hpp"
#include "../calls/recorder.hpp"
#include "../graph/contacts.hpp"
#include "../math/float_mode.hpp"
#include "../step/one_way.hpp"
#include "../world/shapes.hpp"

namespace islet {

using namespace detail;

namespace detail {

void replace_geometry(Core& core, ShapeId id, const Geometry& g, bool valid, bool there) {
    const DefaultFloatMode mode;
    if (!check_there(core, there)) return;
    const std::uint32_t i = find_slot(core, id);
    if (i == null_index || !check(core, valid, Error::bad_geometry)) return;
    Shape& s = core.shapes[i];
    if (!check(core, !is_endless(g) || !core.is_dynamic(s.body), Error::endless_shape)) return;
    const bool fits = core.state->geometry_pool.count < geometry_capacity(core.capacity) || core.geometries[s.geometry].references == 1 ||
                      find_geometry(core, g) != null_index;
    if (!check(core, fits, Error::geometries_full)) return;
    const std::uint32_t body = s.body;
    wake_island(core, body, core.arena());
    end_contacts_of_shape(core, i);
    if (s.tree_node != null_index) tree_remove({&core.state->tree, core.tree}, s.tree_node);
    s.tree_node = null_index;
    const std::uint32_t old = s.geometry;
    if (core.geometries[old].references > 1) {
        s.geometry = share_geometry(core, g);
        release_geometry(core, old);
    } else {
        release_geometry(core, old);
        s.geometry = share_geometry(core, g);
    }
    core.boxes[i] = {{1, 1}, {-1, -1}};  // an empty box, which is made anew
    shapes_changed(core, body, every_shape);
}

}  // namespace detail

namespace {

void set_flag(Core& core, ShapeId id, std::uint32_t flag, bool on) {
    const std::uint32_t i = find_slot(core, id);
    if (i == null_index) return;
    Shape& s = core.shapes[i];
    s.flags = on ? s.flags | flag : s.flags & ~flag;
    core.state->asked |= asked_of(s.flags);
    for_each_contact(core, s.body, [&](std::uint32_t contact, std::uint32_t) { mix_materials(core, contact); });
}

}  // namespace

#define ISLET_SET(name, Type, feature, kind, linked) ISLET_SET_##linked(name, Type)
#define ISLET_SET_always ISLET_DEFINE_SET_SHAPE
#define ISLET_SET_when_made(name, Type)
ISLET_SHAPE_TYPES(ISLET_SET)

void World::set_density(ShapeId id, float density) {
    const DefaultFloatMode mode;
    const auto [c, i] = begin_call<Call::set_density>(core(), id, density);
    if (i == null_index || !check_range(c, density, 0, no_limit)) return;
    c.shapes[i].density = density;
    wake_island(c, c.shapes[i].body, c.arena());
    update_mass(c, c.shapes[i].body);
    refit_boxes(c, c.shapes[i].body);
}

SurfaceMaterial World::material(ShapeId id) const {
    ISLET_READ(
        (SurfaceMaterial{c.shapes[i].friction, c.shapes[i].restitution, c.shapes[i].rolling_resistance, c.shapes[i].tangent_speed, c.shapes[i].material}));
}

void World::set_material(ShapeId id, const SurfaceMaterial& m) {
    const auto [c, i] = begin_call<Call::set_material>(core(), id, m);
    if (i == null_index) return;
    ShapeDef def;
    def.friction = m.friction;
    def.restitution = m.restitution;
    def.rolling_resistance = m.rolling_resistance;
    def.tangent_speed = m.tangent_speed;
    if (!check_shape_def(c, def)) return;
    Shape& s = c.shapes[i];
    s.friction = m.friction;
    s.restitution = m.restitution;
    s.rolling_resistance = m.rolling_resistance;
    s.tangent_speed = m.tangent_speed;
    s.material = m.id;
    remix(c, i);
}

bool World::is_sensor(ShapeId id) const { ISLET_READ((c.shapes[i].flags & shape_sensor) != 0); }

void World::set_sensor(ShapeId id, bool sensor) {
    const auto [c, i] = begin_call<Call::set_sensor>(core(), id, sensor);
    if (i == null_index || !check_there(c, has_sensors || !sensor) || ((c.shapes[i].flags & shape_sensor) != 0) == sensor) return;
    wake_island(c, c.shapes[i].body, c.arena());
    end_contacts_of_shape(c, i);
    c.shapes[i].flags ^= shape_sensor;
    c.state->asked |= asked_of(c.shapes[i].flags);
    update_extent(c, c.shapes[i].body);  // sensors do not count
    mark_moved(c, i);
}

bool World::hit_events_enabled(ShapeId id) const { ISLET_READ((c.shapes[i].flags & shape_hit_events) != 0); }
bool World::pre_solve_enabled(ShapeId id) const { ISLET_READ((c.shapes[i].flags & shape_pre_solve) != 0); }
bool World::sensor_events_enabled(ShapeId id) const { ISLET_READ((c.shapes[i].flags & shape_unseen) == 0); }

void World::enable_hit_events(ShapeId id, bool enable) {
    note_call<Call::enable_hit_events>(core(), id, enable);
    if (check_there(core(), has_hits || !enable)) set_flag(core(), id, shape_hit_events, enable);
}

void World::enable_pre_solve(ShapeId id, bool enable) {
    note_call<Call::enable_pre_solve>(core(), id, enable);
    if (check_there(core(), has_hooks || !enable)) set_flag(core(), id, shape_pre_solve, enable);
}

Vec2 World::one_way(ShapeId id) const { ISLET_READ(direction_of_flags(c.shapes[i].flags)); }

void World::set_one_way(ShapeId id, Vec2 direction) {
    const DefaultFloatMode mode;
    const auto [c, i] = begin_call<Call::set_one_way>(core(), id, direction);
    if (i == null_index || !check_finite(c, direction) || !check_there(c, has_one_way || direction == Vec2{})) return;
    Shape& s = c.shapes[i];
    s.flags = (s.flags & ~std::uint32_t{shape_one_way_bits}) | flags_of_direction(normalize(direction));
    c.state->asked |= asked_of(s.flags);
    remix(c, i, contact_one_way);  // one_way.cpp decides anew about each contact
}

void World::enable_sensor_events(ShapeId id, bool enable) {
    const auto [c, i] = begin_call<Call::enable_sensor_events>(core(), id, enable);
    if (i == null_index || ((c.shapes[i].flags & shape_unseen) == 0) == enable) return;
    c.shapes[i].flags ^= shape_unseen;
    c.state->asked |= asked_of(c.shapes[i].flags);
    end_contacts_of_shape(c, i, true);
    mark_moved(c, i);
}

}  // namespace islet
