// A scene as text, for an engine of another package that runs it beside Islet: the fields of a scene file (docs/scenes-and-tools.md), those as usual left out.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <type_traits>

#include "harness/scene_fields.hpp"
#include "scenes/catalogue.hpp"

using namespace islet;
using namespace islet::samples;

namespace {

/// Writes an object of JSON, a field at a time.
struct Text {
    std::string& out;
    bool first = true;

    explicit Text(std::string& to) : out(to) { out += '{'; }
    void end() { out += '}'; }

    void name(const char* name) {
        out += first ? "\"" : ",\"";
        first = false;
        out += name;
        out += "\":";
    }

    template <class T>
    void operator()(const char* field, const T& value, const T& usual) {
        if (is_same(value, usual)) return;
        name(field);
        put(value);
    }

    template <class T>
    static bool is_same(const T& a, const T& b) {
        if constexpr (std::is_same_v<T, Vec2>) {
            return is_same(a.x, b.x) && is_same(a.y, b.y);
        } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_same_v<T, std::string>) {
            return a == b;
        } else {
            return false;
        }
    }

    template <class T>
    void put(const T& value) {
        if constexpr (std::is_same_v<T, bool>) {
            out += value ? "true" : "false";
        } else if constexpr (std::is_floating_point_v<T>) {
            number("%.9g", std::isinf(value) ? std::copysign(1e39, double(value)) : double(value));
        } else if constexpr (std::is_integral_v<T>) {
            number("%.17g", static_cast<double>(value));
        } else if constexpr (std::is_enum_v<T>) {
            text(enum_names<T>[static_cast<std::size_t>(value)]);
        } else if constexpr (std::is_same_v<T, std::string>) {
            text(value.c_str());
        } else if constexpr (std::is_same_v<T, Vec2>) {
            const float xy[] = {value.x, value.y};
            list(xy, 2);
        } else if constexpr (std::is_same_v<T, Aabb>) {
            const float sides[] = {value.lower.x, value.lower.y, value.upper.x, value.upper.y};
            list(sides, 4);
        } else if constexpr (std::is_same_v<T, std::vector<Vec2>> || std::is_same_v<T, std::vector<std::size_t>>) {
            list(value.data(), value.size());
        } else {
            Text nested(out);
            fields(nested, value, T{});
            nested.end();
        }
    }

    template <class T>
    void list(const T* items, std::size_t count) {
        out += '[';
        for (std::size_t i = 0; i < count; ++i) {
            if (i > 0) out += ',';
            put(items[i]);
        }
        out += ']';
    }

    void number(const char* format, double value) {
        char digits[40];
        out.append(digits, static_cast<std::size_t>(std::snprintf(digits, sizeof digits, format, value)));
    }
    void text(const char* value) { out.append("\"").append(value).append("\""); }  // names need no escapes
};

/// Named, and all of it: of a polygon both corners and normals.
void put_shape(std::string& out, const SceneShape& made) {
    Text shape(out);
    shape.name(geometry_names[made.geometry.index()]);
    const auto put = [&out]<class Geometry>(const Geometry& geometry) {
        Text io(out);
        if constexpr (std::is_same_v<Geometry, Polygon>) {
            io.name("points");
            io.list(geometry.vertices, geometry.count);
            io("radius", geometry.radius, 0.0f);
        } else {
            fields(io, geometry, Geometry{});
        }
        io.end();
    };
    std::visit(put, made.geometry);
    fields(shape, made.def, ShapeDef{});
    shape.end();
}

void put_joint(std::string& out, const SceneJoint& made) {
    Text joint(out);
    joint.name("type");
    joint.text(joint_names[made.def.index()]);
    joint.name("body_a");
    joint.put(made.body_a);
    joint.name("body_b");
    joint.put(made.body_b);
    std::visit([&joint]<class D>(const D& def) { joint_fields(joint, def, D{}); }, made.def);
    joint.end();
}

template <class List, class Put>
void put_all(Text& io, const char* name, const List& list, Put put) {
    io.name(name);
    io.out += '[';
    for (const auto& item : list) {
        put(item);
        io.out += ',';
    }
    if (io.out.back() == ',') io.out.pop_back();
    io.out += ']';
}

std::string text_of(const Scene& scene) {
    std::string out;
    Text io(out);
    fields(io, scene, Scene{});
    put_all(io, "bodies", scene.bodies, [&out](const SceneBody& made) {
        Text body(out);
        fields(body, made.def, BodyDef{});
        put_all(body, "shapes", made.shapes, [&out](const SceneShape& shape) { put_shape(out, shape); });
        body.end();
    });
    put_all(io, "joints", scene.joints, [&out](const SceneJoint& joint) { put_joint(out, joint); });
    io.end();
    return out;
}

std::string described;

}  // namespace

/// A scene of the catalogue as JSON, until the next call.
extern "C" const char* sandbox_describe(std::uint32_t scene) {
    described = text_of(catalogue()[scene].make());
    return described.c_str();
}
