// Bodies, shapes and joints: a definition, or its fields by their names.
#include "world.hpp"

namespace islet::python {
namespace {

/// A definition that may be given whole, and fields of it.
template <class Def>
Def def_from(py::handle given, const py::kwargs& named) {
    Def def = given.is_none() ? Def{} : py::cast<Def>(given);
    fill_record(&def, record_of<Def>(), py::tuple(), named);
    return def;
}

/// The sentence names the field that is wrong, if one is.
template <class Def>
void check(Call& call, const Def& def) {
    const Error error = call.error();
    if (error == Error::none) return;
    const FieldFault fault = find_fault(def);
    refuse(error, fault.error == error && fault.field != nullptr ? fault.field : std::string());
}

template <class Shape>
bool try_shape(PyWorld& w, BodyId body, py::handle geometry, const ShapeDef& def, ShapeId& made) {
    if (!py::isinstance<Shape>(geometry)) return false;
    const Shape& shape = py::cast<const Shape&>(geometry);
    Call call(w);
    made = w.world->create_shape(body, shape, def);
    check(call, def);
    return true;
}

ShapeId create_shape(PyWorld& w, BodyId body, py::handle geometry, py::handle given, const py::kwargs& named) {
    const auto def = def_from<ShapeDef>(given, named);
    ShapeId made;
    if (try_shape<Circle>(w, body, geometry, def, made) || try_shape<Polygon>(w, body, geometry, def, made) || try_shape<Capsule>(w, body, geometry, def, made) ||
        try_shape<Segment>(w, body, geometry, def, made) || try_shape<ChainSegment>(w, body, geometry, def, made) ||
        try_shape<HalfSpace>(w, body, geometry, def, made))
        return made;
    throw py::type_error("a shape is a Circle, Polygon, Capsule, Segment, ChainSegment or HalfSpace, not " + py::cast<std::string>(py::repr(geometry)));
}

py::object create_chain(PyWorld& w, BodyId body, py::handle points, bool loop, py::handle given, const py::kwargs& named) {
    const auto def = def_from<ShapeDef>(given, named);
    std::vector<Vec2> corners;
    for (const py::handle point : points) corners.push_back(py::cast<Vec2>(point));
    std::vector<ShapeId> made(corners.size());
    Call call(w);
    made.resize(w.world->create_chain(body, corners, loop, def, made));
    check(call, def);
    return give(span<const ShapeId>(made));
}

template <class Def>
bool try_joint(PyWorld& w, py::handle given, JointId& made) {
    if (!py::isinstance<Def>(given)) return false;
    const Def& def = py::cast<const Def&>(given);
    Call call(w);
    made = w.world->create_joint(def);
    check(call, def);
    return true;
}

JointId create_joint(PyWorld& w, py::handle def) {
    JointId made;
    if (try_joint<RevoluteJointDef>(w, def, made) || try_joint<PrismaticJointDef>(w, def, made) || try_joint<DistanceJointDef>(w, def, made) ||
        try_joint<WeldJointDef>(w, def, made) || try_joint<WheelJointDef>(w, def, made) || try_joint<MotorJointDef>(w, def, made) ||
        try_joint<MouseJointDef>(w, def, made) || try_joint<PulleyJointDef>(w, def, made) || try_joint<GearJointDef>(w, def, made) ||
        try_joint<AngleJointDef>(w, def, made))
        return made;
    throw py::type_error("a joint is a RevoluteJointDef or another of the JointDefs, not " + py::cast<std::string>(py::repr(def)));
}

/// create_revolute_joint(body_a=..., ...) and so on.
template <class Def>
void add_joint(WorldClass& w, const char* name) {
    w.def(
        name,
        [](PyWorld& world, const py::kwargs& named) {
            const auto def = def_from<Def>(py::none(), named);
            Call call(world);
            const JointId made = world.world->create_joint(def);
            check(call, def);
            return made;
        },
        record_of<Def>().doc);
}

}  // namespace

void add_making(WorldClass& w) {
    w.def(
        "create_body",
        [](PyWorld& world, py::handle given, const py::kwargs& named) {
            const auto def = def_from<BodyDef>(given, named);
            Call call(world);
            const BodyId made = world.world->create_body(def);
            check(call, def);
            return made;
        },
        py::arg("definition") = py::none(), "Makes a body from a BodyDef, or from fields of one.");
    w.def("create_shape", create_shape, py::arg("body"), py::arg("shape"), py::arg("definition") = py::none(),
          "Gives a body a shape: a Circle, Polygon, Capsule, Segment, ChainSegment or HalfSpace, with the fields of a ShapeDef.");
    w.def("create_chain", create_chain, py::arg("body"), py::arg("points"), py::arg("loop") = false, py::arg("definition") = py::none(),
          "A chain of ChainSegments through points, all or nothing, which collides on the right of its direction. Returns their ids.");
    w.def("create_joint", create_joint, py::arg("definition"), "Makes the joint of a RevoluteJointDef or another of the JointDefs.");
    add_joint<RevoluteJointDef>(w, "create_revolute_joint");
    add_joint<PrismaticJointDef>(w, "create_prismatic_joint");
    add_joint<DistanceJointDef>(w, "create_distance_joint");
    add_joint<WeldJointDef>(w, "create_weld_joint");
    add_joint<WheelJointDef>(w, "create_wheel_joint");
    add_joint<MotorJointDef>(w, "create_motor_joint");
    add_joint<MouseJointDef>(w, "create_mouse_joint");
    add_joint<PulleyJointDef>(w, "create_pulley_joint");
    add_joint<GearJointDef>(w, "create_gear_joint");
    add_joint<AngleJointDef>(w, "create_angle_joint");
    w.def(
        "explode",
        [](PyWorld& world, py::handle given, const py::kwargs& named) {
            const auto def = def_from<ExplosionDef>(given, named);
            Call call(world);
            world.world->explode(def);
            check(call, def);
        },
        py::arg("definition") = py::none(), "Pushes the shapes of dynamic bodies away from a point, with the fields of an ExplosionDef.");
    w.def(
        "apply_wind",
        [](PyWorld& world, ShapeId shape, py::handle given, const py::kwargs& named) {
            const auto def = def_from<WindDef>(given, named);
            Call call(world);
            world.world->apply_wind(shape, def);
            check(call, def);
        },
        py::arg("shape"), py::arg("definition") = py::none(), "Wind on a shape during the next step, with the fields of a WindDef.");
    w.def(
        "set_solver",
        [](PyWorld& world, py::handle given, const py::kwargs& named) {
            SolverDef def = given.is_none() ? world.world->solver() : py::cast<SolverDef>(given);
            fill_record(&def, record_of<SolverDef>(), py::tuple(), named);
            Call call(world);
            world.world->set_solver(def);
            check(call, def);
        },
        py::arg("definition") = py::none(), "Changes settings of the solver: a SolverDef, or the fields to change.");
}

}  // namespace islet::python
