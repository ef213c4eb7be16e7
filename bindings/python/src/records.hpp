// How values of the engine become Python's, and back: points are pairs, enumerations names, structs classes with keywords.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <string>
#include <type_traits>

#include <pybind11/pybind11.h>

#include <islet/fleet.hpp>
#include <islet/islet.hpp>

namespace islet::python {

namespace py = pybind11;

/// An enumeration: an enum.IntEnum of the same names.
struct EnumInfo {
    const char* name;
    const char* const* names;
    std::size_t count;
    py::handle cls;      // made by add_enum; lives as long as the program
    py::handle members;  // a tuple
};
template <class E>
const EnumInfo& enum_of();
void add_enum(py::module_& m, const EnumInfo& info);
/// The number of a member, a name or a number; -1 if it is none of these.
int enum_value(const EnumInfo& info, py::handle from);

/// How a field of one type is read and set.
struct Kind {
    py::object (*get)(const void* place, py::handle record);  // a record in a record is the field itself, not a copy
    void (*set)(void* place, py::handle value);
};

struct Field {
    const char* name;
    std::size_t offset;
    const Kind* kind;
    const char* doc;
};

/// A struct: a class whose constructor takes its fields by their names, or in their order.
struct RecordInfo {
    const char* name;
    const char* doc;
    const Field* fields;
    std::size_t count;
    py::handle cls;
};
template <class T>
const RecordInfo& record_of();

/// Sets a field, of which a complaint names the record and the field.
void set_field(void* record, const RecordInfo& info, const Field& field, py::handle value);
/// The field of that name, or null.
const Field* find_field(const RecordInfo& info, py::handle name);
/// Sets the fields that a dict names, or that a sequence gives in their order. Throws TypeError.
void fill_record(void* record, const RecordInfo& info, const py::tuple& values, const py::dict& named);
/// The same from a dict or a sequence; false if it is neither.
bool fill_from(void* record, const RecordInfo& info, py::handle from);

bool load_point(py::handle from, Vec2& out);
bool load_rotation(py::handle from, Rot& out);
bool load_pose(py::handle from, Transform& out);
bool load_box(py::handle from, Aabb& out);
py::object give_point(Vec2 v);
py::object give_rotation(Rot q);
py::object give_pose(const Transform& t);
py::object give_box(const Aabb& b);

template <class E>
struct EnumCaster {
    PYBIND11_TYPE_CASTER(E, py::detail::const_name("enum"));
    bool load(py::handle from, bool) {
        const int number = enum_value(enum_of<E>(), from);
        value = static_cast<E>(number < 0 ? 0 : number);
        return number >= 0;
    }
    static py::handle cast(E e, py::return_value_policy, py::handle) {
        return py::handle(PyTuple_GET_ITEM(enum_of<E>().members.ptr(), static_cast<Py_ssize_t>(e))).inc_ref();
    }
};

/// Where a record is wanted, a dict or a tuple of its fields will do.
template <class T>
struct RecordCaster : py::detail::type_caster_base<T> {
    using Base = py::detail::type_caster_base<T>;
    T made{};
    RecordCaster() = default;
    RecordCaster(const RecordCaster& other) : Base(other), made(other.made) {
        if (other.value == &other.made) this->value = &made;
    }
    RecordCaster& operator=(const RecordCaster&) = delete;
    bool load(py::handle from, bool convert);
};

#include "records.inc"

}  // namespace islet::python

namespace pybind11::detail {

#define ISLET_PAIR(type, text, from, to)                                                                                 \
    template <>                                                                                                          \
    struct type_caster<islet::type> {                                                                                    \
        PYBIND11_TYPE_CASTER(islet::type, const_name(text));                                                             \
        bool load(handle source, bool) { return islet::python::from(source, value); }                                    \
        static handle cast(const islet::type& v, return_value_policy, handle) { return islet::python::to(v).release(); } \
    };
ISLET_PAIR(Vec2, "Vec2", load_point, give_point)
ISLET_PAIR(Rot, "Rot", load_rotation, give_rotation)
ISLET_PAIR(Transform, "Transform", load_pose, give_pose)
ISLET_PAIR(Aabb, "Aabb", load_box, give_box)
#undef ISLET_PAIR
#include "casters.inc"

}  // namespace pybind11::detail

namespace islet::python {

template <class T>
bool RecordCaster<T>::load(py::handle from, bool convert) {
    if (py::detail::type_caster_base<T>::load(from, false)) return !from.is_none();
    if (!convert) return false;
    if constexpr (std::is_same_v<T, ShapeProxy>) {  // any convex shape will do
        const auto take = [&](auto* shape) {
            using Shape = std::remove_pointer_t<decltype(shape)>;
            if (!py::isinstance<Shape>(from)) return false;
            made = make_proxy(py::cast<const Shape&>(from));
            return true;
        };
        this->value = &made;
        if (take(static_cast<Circle*>(nullptr)) || take(static_cast<Capsule*>(nullptr)) || take(static_cast<Segment*>(nullptr)) ||
            take(static_cast<Polygon*>(nullptr)))
            return true;
    }
    this->value = &made;
    return fill_from(&made, record_of<T>(), from);
}

template <class T>
inline constexpr bool is_id = std::is_same_v<T, BodyId> || std::is_same_v<T, ShapeId> || std::is_same_v<T, JointId>;

template <class T>
struct KindOf {
    static py::object get(const void* place, py::handle record) {
        if constexpr (std::is_base_of_v<py::detail::type_caster_generic, py::detail::make_caster<T>> && !is_id<T>)
            return py::cast(static_cast<const T*>(place), py::return_value_policy::reference_internal, record);
        else
            return py::cast(*static_cast<const T*>(place));
    }
    static void set(void* place, py::handle value) { *static_cast<T*>(place) = py::cast<T>(value); }
};
template <class T, std::size_t n>
struct KindOf<T[n]> {
    static py::object get(const void* place, py::handle) {
        py::tuple all(n);
        for (std::size_t i = 0; i < n; ++i) all[i] = py::cast(static_cast<const T*>(place)[i]);
        return all;
    }
    static void set(void* place, py::handle value) {
        const py::tuple all(py::reinterpret_borrow<py::object>(value));
        if (all.size() > n) throw py::value_error("at most " + std::to_string(n) + " values");
        for (std::size_t i = 0; i < all.size(); ++i) static_cast<T*>(place)[i] = py::cast<T>(all[i]);
    }
};
template <class T>
inline constexpr Kind kind_of = {KindOf<T>::get, KindOf<T>::set};

/// Members that need no template. `place` gives the record in an object.
void add_fields(py::object cls, const RecordInfo& info, void* (*place)(py::handle));
void add_id_members(py::object cls, void* (*place)(py::handle));

/// T.__new__(T), which a damaged pickle may call without T.__init__, has all fields 0.
template <class T>
void zero_what_is_not_made() {
    py::detail::get_type_info(typeid(T), true)->operator_new = [](std::size_t size) { return std::memset(::operator new(size), 0, size); };
}

template <class T>
void add_record(py::module_& m) {
    const RecordInfo& info = record_of<T>();
    py::class_<T> cls(m, info.name, info.doc);
    cls.def(py::init([&info](const py::args& values, const py::kwargs& named) {
        T made{};
        fill_record(&made, info, values, named);
        return made;
    }));
    void* (*const place)(py::handle) = [](py::handle self) -> void* { return &py::cast<T&>(self); };
    zero_what_is_not_made<T>();
    add_fields(cls, info, place);
    if constexpr (is_id<T>) add_id_members(cls, place);
}

}  // namespace islet::python
