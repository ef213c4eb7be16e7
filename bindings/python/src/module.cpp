// The module islet._islet. The package islet (package/__init__.py) shows what is in it.
#include "world.hpp"

namespace islet::python {
namespace {

void translate(std::exception_ptr thrown) {
    static const py::handle cls = py::object(py::module_::import("islet.plain").attr("Error")).release();
    try {
        if (thrown) std::rethrow_exception(thrown);
    } catch (const Refused& refused) {
        std::string text = describe(refused.error);
        if (!refused.detail.empty()) text = refused.detail + ": " + text;
        const py::object error = cls(text, py::cast(refused.error));
        PyErr_SetObject(cls.ptr(), error.ptr());
    } catch (const py::cast_error& wrong) { PyErr_SetString(PyExc_TypeError, wrong.what()); }
}

void add_enums(py::module_& m) {
    add_enum(m, enum_of<ShapeType>());
    add_enum(m, enum_of<Schedule>());
    add_enum(m, enum_of<JointTrees>());
    add_enum(m, enum_of<SweepOrder>());
    add_enum(m, enum_of<BodyType>());
    add_enum(m, enum_of<JointType>());
    add_enum(m, enum_of<DriveKind>());
    add_enum(m, enum_of<SenseKind>());
    add_enum(m, enum_of<ReplayEnd>());
    add_enum(m, enum_of<Error>());
}

Hull hull_of(py::handle points) {
    std::vector<Vec2> corners;
    for (const py::handle point : points) corners.push_back(py::cast<Vec2>(point));
    return compute_hull(corners);
}

void add_geometry(py::module_& m) {
    m.def(
        "make_polygon",
        [](py::handle points, float radius) {
            const Polygon polygon = make_polygon(hull_of(points), radius);
            if (!is_valid(polygon)) refuse(Error::bad_geometry, "points");
            return polygon;
        },
        py::arg("points"), py::arg("radius") = 0.0f, "The convex hull of at least 3 points (8 corners at most), rounded by a radius (m).");
    m.def(
        "describe", [](Error code) { return describe(code); }, py::arg("code"), "A sentence that says what was wrong and how to fix it.");
    m.def(
        "make_proxy", [](const ShapeProxy& shape) { return shape; }, py::arg("shape"), "The proxy of a circle, a capsule, a segment or a polygon.");
}

}  // namespace
}  // namespace islet::python

PYBIND11_MODULE(_islet, m) {
    using namespace islet::python;
    py::register_exception_translator(translate);
    add_enums(m);
    add_records_0(m);
    add_records_1(m);
    add_records_2(m);
    WorldClass w(m, "World", "A world: one block of memory that holds bodies, shapes and joints, and steps them.", collectable());
    zero_what_is_not_made<PyWorld>();
    add_calls_0(w, m);
    add_calls_1(w, m);
    add_calls_2(w, m);
    add_geometry(m);
    add_making(w);
    add_finding(w);
    add_state(w);
    add_asking(w);
    add_images(m);
    add_fleet(m);
    add_scenes(m, w);
    m.attr("__version__") = ISLET_VERSION_STRING;
}
