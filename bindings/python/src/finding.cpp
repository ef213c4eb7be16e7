// Queries and lists: as many results as there are.
#include "world.hpp"

namespace islet::python {
namespace {

/// The ids of a range of the world, by slot.
template <class RangeOf>
py::list listed(const PyWorld& world, RangeOf range_of) {
    Call call(world);
    py::list all;
    for (const auto id : range_of(*world.world)) all.append(py::cast(id));
    return all;
}

}  // namespace

void add_finding(WorldClass& w) {
    const auto filter = py::arg("filter") = QueryFilter{};
    w.def(
        "overlap_box", [](PyWorld& world, const Aabb& box, const QueryFilter& f) {
            return all_of<ShapeId>(world, [&](World& in, span<ShapeId> out) { return in.overlap_box(box, out, f); });
        },
        py::arg("box"), filter, "The shapes whose tight box overlaps a box.");
    w.def(
        "overlap_shape", [](PyWorld& world, const ShapeProxy& shape, const QueryFilter& f) {
            return all_of<ShapeId>(world, [&](World& in, span<ShapeId> out) { return in.overlap_shape(shape, out, f); });
        },
        py::arg("shape"), filter, "The shapes that share a point with a shape, which stands in the world.");
    w.def(
        "overlap_point", [](PyWorld& world, Vec2 point, const QueryFilter& f) {
            return all_of<ShapeId>(world, [&](World& in, span<ShapeId> out) { return in.overlap_point(point, out, f); });
        },
        py::arg("point"), filter, "The shapes that contain a point.");
    w.def(
        "cast_ray_all", [](PyWorld& world, Vec2 origin, Vec2 translation, const QueryFilter& f) {
            return all_of<QueryHit>(world, [&](World& in, span<QueryHit> out) { return in.cast_ray_all(origin, translation, out, f); });
        },
        py::arg("origin"), py::arg("translation"), filter, "All hits of a ray, first ones first.");
    w.def(
        "cast_shape_all", [](PyWorld& world, const ShapeProxy& shape, Vec2 translation, const QueryFilter& f) {
            return all_of<QueryHit>(world, [&](World& in, span<QueryHit> out) { return in.cast_shape_all(shape, translation, out, f); });
        },
        py::arg("shape"), py::arg("translation"), filter, "All hits of a shape that moves, first ones first.");
    w.def(
        "surfaces_near", [](PyWorld& world, const ShapeProxy& shape, float within, const QueryFilter& f) {
            return all_of<Surface>(world, [&](World& in, span<Surface> out) { return in.surfaces_near(shape, within, out, f); });
        },
        py::arg("shape"), py::arg("within"), filter, "The surfaces no farther than `within` (m) from a shape in the world, the closest first.");
    w.def(
        "sensor_overlaps",
        [](PyWorld& world, ShapeId sensor) { return all_of<ShapeId>(world, [&](World& in, span<ShapeId> out) { return in.sensor_overlaps(sensor, out); }); },
        py::arg("sensor"), "The shapes that overlap a sensor.");
    // Of a body or of a shape; of the whole world without one.
    w.def(
        "contacts", [](PyWorld& world, BodyId body) { return all_of<ContactInfo>(world, [&](World& in, span<ContactInfo> out) { return in.contacts(body, out); }); },
        py::arg("body"), "The touching contacts of a body, newest first.");
    w.def(
        "contacts", [](PyWorld& world, ShapeId shape) { return all_of<ContactInfo>(world, [&](World& in, span<ContactInfo> out) { return in.contacts(shape, out); }); },
        py::arg("shape"), "The touching contacts of a shape, newest first.");
    w.def(
        "contacts",
        [](PyWorld& world) {
            Call call(world);
            py::list all;
            ContactInfo contact;
            for (std::uint32_t slot = 0; slot < world.world->capacity().contacts; ++slot)
                if (world.world->contact_at(slot, contact)) all.append(py::cast(contact));
            return all;
        },
        "All contacts of shapes that touch, by slot.");
    w.def(
        "shapes", [](PyWorld& world, BodyId body) { return all_of<ShapeId>(world, [&](World& in, span<ShapeId> out) { return in.shapes(body, out); }); },
        py::arg("body"), "The shapes of a body, newest first.");
    w.def(
        "joints", [](PyWorld& world, BodyId body) { return all_of<JointId>(world, [&](World& in, span<JointId> out) { return in.joints(body, out); }); },
        py::arg("body"), "The joints of a body, newest first.");
    w.def("bodies", [](PyWorld& world) { return listed(world, [](const World& of) { return all_bodies(of); }); }, "All bodies, by slot.");
    w.def("shapes", [](PyWorld& world) { return listed(world, [](const World& of) { return all_shapes(of); }); }, "All shapes, by slot.");
    w.def("joints", [](PyWorld& world) { return listed(world, [](const World& of) { return all_joints(of); }); }, "All joints, by slot.");
}

}  // namespace islet::python
