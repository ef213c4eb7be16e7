#include <cstring>
#include <string>
#include <type_traits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "harness/scene_fields.hpp"
#include "scene_files/short_number.hpp"
#include "scene_files/scene_file.hpp"

namespace islet::samples {
namespace {

using Json = nlohmann::ordered_json;

bool same_bits(float a, float b) { return std::memcmp(&a, &b, sizeof a) == 0; }
bool same_bits(Vec2 a, Vec2 b) { return same_bits(a.x, b.x) && same_bits(a.y, b.y); }

/// Puts fields that are not as usual into an object.
struct Writer {
    Json& object;

    template <class T>
    void operator()(const char* name, const T& value, const T& usual) {
        if (Json told = to_json(value, usual); !told.is_null()) object[name] = std::move(told);
    }

    /// Null: as usual.
    template <class T>
    static Json to_json(const T& value, const T& usual) {
        if constexpr (std::is_same_v<T, float>) {
            return same_bits(value, usual) ? Json() : Json(short_number(value));
        } else if constexpr (std::is_same_v<T, Vec2>) {
            return same_bits(value, usual) ? Json() : to_json(value);
        } else if constexpr (std::is_same_v<T, Aabb>) {
            const bool same = same_bits(value.lower, usual.lower) && same_bits(value.upper, usual.upper);
            return same ? Json() : Json({short_number(value.lower.x), short_number(value.lower.y), short_number(value.upper.x), short_number(value.upper.y)});
        } else if constexpr (std::is_same_v<T, std::vector<Vec2>>) {
            Json list = Json::array();
            for (const Vec2 p : value) list.push_back(to_json(p));
            return list;
        } else if constexpr (std::is_enum_v<T>) {
            return value == usual ? Json() : Json(enum_names<T>[static_cast<std::size_t>(value)]);
        } else if constexpr (requires(Writer & io) { fields(io, value, usual); }) {
            Json nested = Json::object();
            Writer io{nested};
            fields(io, value, usual);
            return nested.empty() ? Json() : nested;
        } else {
            return value == usual ? Json() : Json(value);
        }
    }

    static Json to_json(Vec2 p) { return {short_number(p.x), short_number(p.y)}; }
};

bool same_bits(const Polygon& a, const Polygon& b) {
    bool same = a.count == b.count && same_bits(a.radius, b.radius) && same_bits(a.centroid, b.centroid);
    for (std::uint32_t i = 0; same && i < a.count; ++i) same = same_bits(a.vertices[i], b.vertices[i]) && same_bits(a.normals[i], b.normals[i]);
    return same;
}

Json list_of(const Vec2* points, std::uint32_t count) {
    Json list = Json::array();
    for (std::uint32_t i = 0; i < count; ++i) list.push_back(Writer::to_json(points[i]));
    return list;
}

void put_polygon(Json& shape, const Polygon& p) {
    const Vec2 half = p.count == 4 ? p.vertices[2] : Vec2{};
    if (same_bits(p, make_box(half.x, half.y))) {
        shape["box"] = Writer::to_json(half);
        return;
    }
    Json polygon = {{"points", list_of(p.vertices, p.count)}};
    if (p.radius != 0) polygon["radius"] = short_number(p.radius);
    if (!same_bits(p, make_polygon(compute_hull({p.vertices, p.count}), p.radius))) {
        polygon["normals"] = list_of(p.normals, p.count);
        polygon["centroid"] = Writer::to_json(p.centroid);
    }
    shape["polygon"] = std::move(polygon);
}

Json json_of(const SceneShape& made) {
    Json shape = Json::object();
    const auto put = [&]<class Geometry>(const Geometry& geometry) {
        if constexpr (std::is_same_v<Geometry, Polygon>) {
            put_polygon(shape, geometry);
        } else {
            Json told = Json::object();
            Writer io{told};
            fields(io, geometry, Geometry{});
            shape[geometry_names[made.geometry.index()]] = std::move(told);
        }
    };
    std::visit(put, made.geometry);
    Writer io{shape};
    fields(io, made.def, ShapeDef{});
    return shape;
}

Json json_of(const SceneBody& made) {
    Json body = Json::object();
    Writer io{body};
    fields(io, made.def, BodyDef{});
    if (!made.shapes.empty()) body["shapes"] = Json::array();
    for (const SceneShape& shape : made.shapes) body["shapes"].push_back(json_of(shape));
    return body;
}

Json json_of(const SceneJoint& made) {
    Json joint = {{"type", joint_names[made.def.index()]}};
    if (std::holds_alternative<GearJointDef>(made.def)) {
        joint["joint1"] = made.body_a;
        joint["joint2"] = made.body_b;
    } else if (std::holds_alternative<MouseJointDef>(made.def)) {
        joint["body"] = made.body_b;
    } else {
        joint["body_a"] = made.body_a;
        joint["body_b"] = made.body_b;
    }
    Writer io{joint};
    std::visit([&]<class Def>(const Def& def) { joint_fields(io, def, Def{}); }, made.def);
    return joint;
}

/// A list with a line for each entry.
std::string lines(const char* name, const Json& list) {
    if (list.empty()) return {};
    std::string text = fmt::format(",\n  \"{}\": [", name);
    for (std::size_t i = 0; i < list.size(); ++i) text += fmt::format("{}\n    {}", i == 0 ? "" : ",", list[i].dump());
    return text + "\n  ]";
}

}  // namespace

bool has_script(const Scene& scene) { return scene.before_step || scene.world.hooks != Hooks{}; }

std::string write_scene(const Scene& scene) {
    Json head = Json::object(), bodies = Json::array(), joints = Json::array();
    Writer io{head};
    fields(io, scene, Scene{});
    for (const SceneBody& body : scene.bodies) bodies.push_back(json_of(body));
    for (const SceneJoint& joint : scene.joints) joints.push_back(json_of(joint));
    std::string text = fmt::format("{{\n  \"format\": {}", scene_format);
    for (const auto& [name, value] : head.items()) text += fmt::format(",\n  {}: {}", Json(name).dump(), value.dump());
    return text + lines("bodies", bodies) + lines("joints", joints) + "\n}\n";
}

}  // namespace islet::samples
