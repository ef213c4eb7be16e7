#include "records.hpp"

#include <cstring>
#include <string>

namespace islet::python {
namespace {

/// A class of package/plain.py.
py::handle plain_class(const char* name) { return py::object(py::module_::import("islet.plain").attr(name)).release(); }

/// A tuple of a subclass, as NamedTuple makes it, without a call in Python.
template <class... Value>
py::object make_tuple_of(py::handle cls, Value... values) {
    auto* type = reinterpret_cast<PyTypeObject*>(cls.ptr());
    PyObject* made = type->tp_alloc(type, sizeof...(values));
    if (made == nullptr) throw py::error_already_set();
    Py_ssize_t i = 0;
    ((PyTuple_SET_ITEM(made, i++, values)), ...);
    return py::reinterpret_steal<py::object>(made);
}

PyObject* number(float v) { return PyFloat_FromDouble(static_cast<double>(v)); }

/// A sequence of two that is no text.
bool split(py::handle from, py::object& first, py::object& second) {
    PyObject* const o = from.ptr();
    if (PyTuple_Check(o) || PyList_Check(o)) {
        if (PySequence_Fast_GET_SIZE(o) != 2) return false;
        first = py::reinterpret_borrow<py::object>(PySequence_Fast_GET_ITEM(o, 0));
        second = py::reinterpret_borrow<py::object>(PySequence_Fast_GET_ITEM(o, 1));
        return true;
    }
    if (!PySequence_Check(o) || PyUnicode_Check(o) || PyBytes_Check(o) || PySequence_Size(o) != 2) {
        PyErr_Clear();
        return false;
    }
    first = py::reinterpret_steal<py::object>(PySequence_GetItem(o, 0));
    second = py::reinterpret_steal<py::object>(PySequence_GetItem(o, 1));
    if (first && second) return true;
    PyErr_Clear();
    return false;
}

bool load_number(py::handle from, float& out) {
    const double value = PyFloat_AsDouble(from.ptr());
    if (value == -1 && PyErr_Occurred() != nullptr) {
        PyErr_Clear();
        return false;
    }
    out = static_cast<float>(value);
    return true;
}

}  // namespace

bool load_point(py::handle from, Vec2& out) {
    py::object x, y;
    return split(from, x, y) && load_number(x, out.x) && load_number(y, out.y);
}

bool load_rotation(py::handle from, Rot& out) {
    float angle = 0;
    if (!PyTuple_Check(from.ptr()) && load_number(from, angle)) {
        out = is_finite(angle) ? make_rot(angle) : Rot{angle, angle};
        return true;
    }
    py::object c, s;
    return split(from, c, s) && load_number(c, out.c) && load_number(s, out.s);
}

bool load_pose(py::handle from, Transform& out) {
    py::object p, q;
    return split(from, p, q) && load_point(p, out.p) && load_rotation(q, out.q);
}

bool load_box(py::handle from, Aabb& out) {
    py::object lower, upper;
    return split(from, lower, upper) && load_point(lower, out.lower) && load_point(upper, out.upper);
}

py::object give_point(Vec2 v) {
    static const py::handle cls = plain_class("Vec2");
    return make_tuple_of(cls, number(v.x), number(v.y));
}

py::object give_rotation(Rot q) {
    static const py::handle cls = plain_class("Rot");
    return make_tuple_of(cls, number(q.c), number(q.s));
}

py::object give_pose(const Transform& t) {
    static const py::handle cls = plain_class("Transform");
    return make_tuple_of(cls, give_point(t.p).release().ptr(), give_rotation(t.q).release().ptr());
}

py::object give_box(const Aabb& b) {
    static const py::handle cls = plain_class("Aabb");
    return make_tuple_of(cls, give_point(b.lower).release().ptr(), give_point(b.upper).release().ptr());
}

// -- enumerations ----------------------------------------------------------------------------------------------------------------------

void add_enum(py::module_& m, const EnumInfo& info) {
    py::list pairs;
    for (std::size_t i = 0; i < info.count; ++i) pairs.append(py::make_tuple(info.names[i], i));
    py::object cls = py::module_::import("enum").attr("IntEnum")(info.name, pairs, py::arg("module") = "islet");
    auto& known = const_cast<EnumInfo&>(info);
    known.members = py::tuple(cls).release();
    m.attr(info.name) = cls;
    known.cls = cls.release();
}

int enum_value(const EnumInfo& info, py::handle from) {
    if (PyLong_Check(from.ptr()) && !PyBool_Check(from.ptr())) {
        // A member of another enumeration is a mistake.
        if (!PyLong_CheckExact(from.ptr()) && !py::isinstance(from, info.cls)) return -1;
        const long number = PyLong_AsLong(from.ptr());
        if (number == -1 && PyErr_Occurred() != nullptr) PyErr_Clear();
        return number >= 0 && number < static_cast<long>(info.count) ? static_cast<int>(number) : -1;
    }
    if (!PyUnicode_Check(from.ptr())) return -1;
    for (std::size_t i = 0; i < info.count; ++i)
        if (PyUnicode_CompareWithASCIIString(from.ptr(), info.names[i]) == 0) return static_cast<int>(i);
    std::string known;
    for (std::size_t i = 0; i < info.count; ++i) known += (i > 0 ? ", " : "") + std::string(info.names[i]);
    throw py::value_error(std::string(info.name) + " has no " + py::cast<std::string>(py::repr(from)) + "; there are " + known);
}

// -- records -----------------------------------------------------------------------------------------------------------------------------

const Field* find_field(const RecordInfo& info, py::handle name) {
    if (!PyUnicode_Check(name.ptr())) return nullptr;
    for (std::size_t i = 0; i < info.count; ++i)
        if (PyUnicode_CompareWithASCIIString(name.ptr(), info.fields[i].name) == 0) return &info.fields[i];
    return nullptr;
}

void set_field(void* record, const RecordInfo& info, const Field& field, py::handle value) {
    try {
        field.kind->set(static_cast<char*>(record) + field.offset, value);
    } catch (const py::cast_error&) {
        throw py::type_error(std::string(info.name) + "." + field.name + " cannot be " + py::cast<std::string>(py::repr(value)));
    }
}

void fill_record(void* record, const RecordInfo& info, const py::tuple& values, const py::dict& named) {
    if (values.size() > info.count) throw py::type_error(std::string(info.name) + " has only " + std::to_string(info.count) + " fields");
    for (std::size_t i = 0; i < values.size(); ++i) set_field(record, info, info.fields[i], values[i]);
    for (const auto& [name, value] : named) {
        const Field* const field = find_field(info, name);
        if (field == nullptr) throw py::type_error(std::string(info.name) + " has no field " + py::cast<std::string>(py::str(name)));
        set_field(record, info, *field, value);
    }
}

bool fill_from(void* record, const RecordInfo& info, py::handle from) {
    if (PyDict_Check(from.ptr())) {
        fill_record(record, info, py::tuple(), py::reinterpret_borrow<py::dict>(from));
        return true;
    }
    if (!PyTuple_CheckExact(from.ptr()) && !PyList_Check(from.ptr())) return false;
    fill_record(record, info, py::tuple(py::reinterpret_borrow<py::object>(from)), py::dict());
    return true;
}

void add_fields(py::object cls, const RecordInfo& info, void* (*place)(py::handle)) {
    const_cast<RecordInfo&>(info).cls = cls.inc_ref();
    const py::handle property(reinterpret_cast<PyObject*>(&PyProperty_Type));
    const bool is_id = py::hasattr(cls, "slot") || std::string(info.name).ends_with("Id");
    for (std::size_t i = 0; i < info.count; ++i) {
        const Field& field = info.fields[i];
        const py::cpp_function get([&field, place](py::handle self) { return field.kind->get(static_cast<const char*>(place(self)) + field.offset, self); });
        const py::cpp_function set([&info, &field, place](py::handle self, py::handle value) { set_field(place(self), info, field, value); });
        cls.attr(field.name) = property(get, is_id ? py::object(py::none()) : py::object(set), py::none(), field.doc);
    }
    const auto method = [&cls](const char* name, auto function) { cls.attr(name) = py::cpp_function(function, py::name(name), py::is_method(cls)); };
    const auto values = [&info, place](py::handle self) {
        py::tuple all(info.count);
        for (std::size_t i = 0; i < info.count; ++i) all[i] = info.fields[i].kind->get(static_cast<const char*>(place(self)) + info.fields[i].offset, self);
        return all;
    };
    method("__repr__", [&info, values](py::handle self) {
        std::string text = std::string(info.name) + "(";
        const py::tuple all = values(self);
        for (std::size_t i = 0; i < info.count; ++i)
            text += (i > 0 ? ", " : "") + std::string(info.fields[i].name) + "=" + py::cast<std::string>(py::repr(all[i]));
        return text + ")";
    });
    method("__eq__", [values](py::handle self, py::handle other) -> py::object {
        if (!py::type::handle_of(self).is(py::type::handle_of(other))) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
        return py::bool_(values(self).equal(values(other)));
    });
    method("__reduce__", [values, cls = py::handle(cls)](py::handle self) { return py::make_tuple(cls, values(self)); });
    if (!is_id) cls.attr("__hash__") = py::none();
}

void add_id_members(py::object cls, void* (*place)(py::handle)) {
    const auto method = [&cls](const char* name, auto function) { cls.attr(name) = py::cpp_function(function, py::name(name), py::is_method(cls)); };
    const auto read = [place](py::handle self) {  // all ids are alike
        BodyId id;
        std::memcpy(&id, place(self), sizeof id);
        return id;
    };
    static_assert(sizeof(BodyId) == sizeof(ShapeId) && sizeof(BodyId) == sizeof(JointId));
    method("__hash__", [read](py::handle self) {
        const BodyId id = read(self);
        return static_cast<Py_ssize_t>((std::uint64_t{id.generation} << 32 | id.index1) * 0x9e3779b97f4a7c15u >> 2);
    });
    method("__bool__", [read](py::handle self) { return bool(read(self)); });
    method("__lt__", [read](py::handle self, py::handle other) -> py::object {
        if (!py::type::handle_of(self).is(py::type::handle_of(other))) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
        return py::bool_(read(self) < read(other));
    });
    const py::handle property(reinterpret_cast<PyObject*>(&PyProperty_Type));
    cls.attr("slot") = property(py::cpp_function([read](py::handle self) { return static_cast<long>(read(self).index1) - 1; }));
}

}  // namespace islet::python
