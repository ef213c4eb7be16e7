#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "harness/scene_fields.hpp"
#include "scene_files/near_names.hpp"
#include "scene_files/printable.hpp"
#include "scene_files/scene_file.hpp"

namespace islet::samples {
namespace {

using Json = nlohmann::json;

[[noreturn]] void refuse(const std::string& place, const std::string& why) { throw SceneFileError(printable(place.empty() ? why : place + ": " + why)); }

[[noreturn]] void refuse_type(const std::string& place, const char* wanted, const Json& got) {
    refuse(place, fmt::format("must be {}, not {}", wanted,
                              got.is_null()      ? "null"
                              : got.is_object()  ? "an object"
                              : got.is_array()   ? "a list"
                              : got.is_string()  ? "a word"
                              : got.is_boolean() ? "true or false"
                                                 : "a number like " + got.dump()));
}

std::string list_of(const char* const* names) {
    std::string text;
    for (; *names != nullptr; ++names) text += fmt::format("{}{}", text.empty() ? "" : names[1] != nullptr ? ", " : " or ", *names);
    return text;
}

std::size_t index_of(const char* const* names, const Json& value, const std::string& place) {
    for (std::size_t i = 0; value.is_string() && names[i] != nullptr; ++i) {
        if (value.get_ref<const std::string&>() == names[i]) return i;
    }
    refuse(place, "must be " + list_of(names));
}

const Json& list_at(const Json& value, const std::string& place) {
    if (!value.is_array()) refuse_type(place, "a list", value);
    return value;
}

float float_at(const Json& value, const std::string& place) {
    if (!value.is_number()) refuse_type(place, "a number", value);
    const auto n = static_cast<float>(value.get<double>());
    if (!std::isfinite(n)) refuse(place, "is too large a number");
    return n;
}

/// A whole number from `least` to the type's largest.
template <class Int>
Int int_at(const Json& value, const std::string& place, Int least = std::numeric_limits<Int>::min()) {
    if (!value.is_number_integer()) refuse_type(place, "a whole number", value);
    const bool is_above = value.is_number_unsigned() && value.get<std::uint64_t>() > static_cast<std::uint64_t>(std::numeric_limits<Int>::max());
    const bool is_below = !value.is_number_unsigned() && (std::is_unsigned_v<Int> || value.get<std::int64_t>() < static_cast<std::int64_t>(least));
    if (is_above || is_below) refuse(place, fmt::format("must be from {} to {}", least, std::numeric_limits<Int>::max()));
    return value.get<Int>();
}

/// The numbers of a list of so many.
template <std::size_t count>
std::array<float, count> floats_at(const Json& value, const std::string& place) {
    if (list_at(value, place).size() != count) refuse(place, fmt::format("must be a list of {} numbers", count));
    std::array<float, count> numbers;
    for (std::size_t i = 0; i < count; ++i) numbers[i] = float_at(value[i], fmt::format("{}[{}]", place, i));
    return numbers;
}

/// Takes the fields that an object has, and in the end refuses those that nobody asked for.
class Reader {
public:
    Reader(const Json& object, std::string place) : object_(object), place_(std::move(place)) {
        if (!object.is_object()) refuse_type(place_.empty() ? "the file" : place_, "an object", object);
    }

    template <class T>
    void operator()(const char* name, T& value, const T&) {
        if (const Json* told = find(name)) read(value, *told, at(name));
    }
    /// The field, or null.
    const Json* find(const char* name) {
        known_.emplace_back(name);
        const auto found = object_.find(name);
        return found != object_.end() ? &*found : nullptr;
    }
    const Json& need(const char* name) {
        const Json* told = find(name);
        if (told == nullptr) refuse(place_, fmt::format("\"{}\" is missing", name));
        return *told;
    }
    std::string at(const std::string& name) const {
        const bool is_plain = !name.empty() && name.find_first_of(" .:[]\"") == std::string::npos;
        return (place_.empty() ? "" : place_ + ".") + (is_plain ? name : fmt::format("\"{}\"", name));
    }
    void end() const {
        for (const auto& [name, value] : object_.items()) {
            if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
            const std::vector<std::string> near = near_names(name, known_);
            refuse(at(name), near.empty() ? "there is no such field" : fmt::format("there is no such field; near names: {}", fmt::join(near, ", ")));
        }
    }

private:
    template <class T>
    static void read(T& value, const Json& told, const std::string& place) {
        if constexpr (std::is_same_v<T, float>) {
            value = float_at(told, place);
        } else if constexpr (std::is_same_v<T, bool>) {
            if (!told.is_boolean()) refuse_type(place, "true or false", told);
            value = told.get<bool>();
        } else if constexpr (std::is_same_v<T, std::string>) {
            if (!told.is_string()) refuse_type(place, "a word", told);
            value = told.get<std::string>();
        } else if constexpr (std::is_integral_v<T>) {
            value = int_at<T>(told, place);
        } else if constexpr (std::is_enum_v<T>) {
            value = static_cast<T>(index_of(enum_names<T>, told, place));
        } else if constexpr (std::is_same_v<T, Vec2>) {
            const auto [x, y] = floats_at<2>(told, place);
            value = {x, y};
        } else if constexpr (std::is_same_v<T, Aabb>) {
            const auto [left, bottom, right, top] = floats_at<4>(told, place);
            value = {{left, bottom}, {right, top}};
        } else if constexpr (requires { value.push_back(value.front()); }) {
            value.clear();
            for (const Json& entry : list_at(told, place)) {
                value.emplace_back();
                read(value.back(), entry, fmt::format("{}[{}]", place, value.size() - 1));
            }
        } else {
            Reader nested(told, place);
            fields(nested, value, T{});
            nested.end();
        }
    }

    const Json& object_;
    std::string place_;
    std::vector<std::string> known_;
};

/// Takes the list in a field, if there is one, entry by entry.
template <class Take>
void for_each_entry(Reader& reader, const char* name, const Take& take) {
    const Json* list = reader.find(name);
    if (list == nullptr) return;
    for (std::size_t i = 0; i < list_at(*list, reader.at(name)).size(); ++i) take((*list)[i], fmt::format("{}[{}]", reader.at(name), i));
}

Polygon polygon_from(const Json& told, const std::string& place) {
    Reader reader(told, place);
    std::vector<Vec2> points, normals;
    Polygon p;
    reader.need("points");
    reader("points", points, {});
    reader("radius", p.radius, 0.0f);
    const bool as_it_stands = reader.find("normals") != nullptr;
    reader("normals", normals, {});
    reader("centroid", p.centroid, {});
    reader.end();
    if (points.size() < 3 || points.size() > max_polygon_vertices) refuse(reader.at("points"), fmt::format("must be 3 to {} corners", max_polygon_vertices));
    if (!as_it_stands) return make_polygon(compute_hull(points), p.radius);
    if (normals.size() != points.size()) refuse(reader.at("normals"), "must be as many as there are points");
    p.count = static_cast<std::uint32_t>(points.size());
    std::copy(points.begin(), points.end(), p.vertices);
    std::copy(normals.begin(), normals.end(), p.normals);
    return p;
}

template <class Geometry>
Geometry geometry_from(const Json& told, const std::string& place) {
    Geometry geometry;
    Reader reader(told, place);
    fields(reader, geometry, Geometry{});
    reader.end();
    return geometry;
}

/// A shape's geometry must be one: of chains the engine says more.
void check_geometry(const SceneGeometry& geometry, const std::string& place) {
    const auto is_sound = []<class Geometry>(const Geometry& g) {
        if constexpr (std::is_same_v<Geometry, Chain>)
            return g.points.size() >= (g.loop ? 3u : 2u);
        else
            return is_valid(g);
    };
    if (!std::visit(is_sound, geometry)) refuse(place, "is no sound geometry: sizes must be above 0, points apart, and corners those of a convex polygon");
}

SceneShape shape_from(const Json& told, const std::string& place) {
    SceneShape shape;
    Reader reader(told, place);
    int geometries = 0;
    const auto take = [&](const char* name, auto make) {
        const Json* geometry = reader.find(name);
        if (geometry == nullptr) return;
        shape.geometry = make(*geometry, reader.at(name));
        check_geometry(shape.geometry, reader.at(name));
        ++geometries;
    };
    take("circle", geometry_from<Circle>);
    take("capsule", geometry_from<Capsule>);
    take("segment", geometry_from<Segment>);
    take("polygon", polygon_from);
    take("chain", geometry_from<Chain>);
    take("half_space", geometry_from<HalfSpace>);
    take("box", [](const Json& halves, const std::string& at) {
        const auto [x, y] = floats_at<2>(halves, at);
        return make_box(x, y);
    });
    if (geometries != 1) refuse(place, "must have one geometry: a circle, capsule, segment, box, polygon, chain or half_space");
    fields(reader, shape.def, ShapeDef{});
    reader.end();
    return shape;
}

SceneBody body_from(const Json& told, const std::string& place) {
    SceneBody body;
    Reader reader(told, place);
    fields(reader, body.def, BodyDef{});
    for_each_entry(reader, "shapes", [&](const Json& shape, const std::string& at) { body.shapes.push_back(shape_from(shape, at)); });
    reader.end();
    return body;
}

/// A place in a list that has `count` entries.
std::size_t index_from(Reader& reader, const char* name, const char* what, std::size_t count) {
    const auto index = int_at<std::uint32_t>(reader.need(name), reader.at(name));
    if (index >= count) refuse(reader.at(name), fmt::format("there is no {} {}; there are {}, and the first is 0", what, index, count));
    return index;
}

/// The default definition of that type.
template <std::size_t... i>
JointDef joint_of_type(std::size_t type, std::index_sequence<i...>) {
    JointDef def;
    ((i == type ? static_cast<void>(def.emplace<i>()) : static_cast<void>(0)), ...);
    return def;
}

SceneJoint joint_from(const Json& told, const std::string& place, const Scene& scene) {
    SceneJoint joint;
    Reader reader(told, place);
    const std::size_t type = index_of(joint_names, reader.need("type"), reader.at("type"));
    joint.def = joint_of_type(type, std::make_index_sequence<std::variant_size_v<JointDef>>());
    if (std::holds_alternative<GearJointDef>(joint.def)) {
        joint.body_a = index_from(reader, "joint1", "joint before this one", scene.joints.size());
        joint.body_b = index_from(reader, "joint2", "joint before this one", scene.joints.size());
    } else if (std::holds_alternative<MouseJointDef>(joint.def)) {
        joint.body_b = index_from(reader, "body", "body", scene.bodies.size());
    } else {
        joint.body_a = index_from(reader, "body_a", "body", scene.bodies.size());
        joint.body_b = index_from(reader, "body_b", "body", scene.bodies.size());
    }
    std::visit([&]<class Def>(Def& def) { joint_fields(reader, def, Def{}); }, joint.def);
    reader.end();
    return joint;
}

/// What the rest of islet takes for granted.
void check_head(const Scene& scene) {
    if (scene.steps < 0 || scene.steps > 100'000'000) refuse("steps", "must be from 0 to 100000000");
    if (!(scene.dt >= min_time_step && scene.dt <= 1)) refuse("dt", fmt::format("must be from {} to 1 s", min_time_step));
    if (!(scene.view.lower.x < scene.view.upper.x && scene.view.lower.y < scene.view.upper.y)) refuse("view", "must be [left, bottom, right, top]");
    // What a file asks for is bounded by what it holds: 64 contacts a shape are ten times those of a dense pile.
    const std::size_t most_contacts = 4096 + 64 * std::size_t{capacity_of(scene).shapes};
    if (scene.extra_contacts > most_contacts) refuse("extra_contacts", fmt::format("must be at most {}: 4096, and 64 for each shape", most_contacts));
    for (const std::size_t body : scene.traced) {
        if (body >= scene.bodies.size()) refuse("traced", fmt::format("there is no body {}; there are {}, and the first is 0", body, scene.bodies.size()));
    }
}

/// Where in the text the parser stopped, after it had read so many bytes.
std::string place_of(const std::string& text, std::size_t read) {
    const std::string before = text.substr(0, std::min(read == 0 ? 0 : read - 1, text.size()));
    const std::size_t line_end = before.rfind('\n');
    const std::size_t column = line_end == std::string::npos ? before.size() : before.size() - line_end - 1;
    return fmt::format("line {}, column {}", 1 + std::count(before.begin(), before.end(), '\n'), 1 + column);
}

/// Builds what a text holds as it is read, and refuses an object that has two fields of one name, of which a JSON library takes one in silence. (The
/// library's own way of being told while it builds takes time that grows with the square of a list's length.)
class Builder : public nlohmann::json_sax<Json> {
public:
    explicit Builder(const std::string& text) : text_(text) {}
    Json take() { return std::move(root_); }

    bool null() override { return put(nullptr); }
    bool boolean(bool value) override { return put(value); }
    bool number_integer(number_integer_t value) override { return put(value); }
    bool number_unsigned(number_unsigned_t value) override { return put(value); }
    bool number_float(number_float_t value, const string_t&) override { return put(value); }
    bool string(string_t& value) override { return put(std::move(value)); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(Json::object()); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(string_t& name) override {
        const auto [field, is_new] = open_.back()->get_ref<Json::object_t&>().emplace(std::move(name), nullptr);
        if (!is_new) refuse(field->first.empty() ? "\"\"" : field->first, "there are two such fields in one object");
        field_ = &field->second;
        return true;
    }
    bool parse_error(std::size_t position, const std::string& token, const Json::exception& error) override {
        constexpr int number_overflow = 406;
        refuse(place_of(text_, position), error.id == number_overflow ? fmt::format("the number {} is too large", token) : "here it ceases to be JSON");
    }

private:
    template <class Value>
    bool put(Value&& value) {
        place_for_value() = std::forward<Value>(value);
        return true;
    }
    bool open(Json container) {
        Json& place = place_for_value();
        place = std::move(container);
        open_.push_back(&place);
        return true;
    }
    bool close() {
        open_.pop_back();
        return true;
    }
    /// (A list that grows moves its entries, but none of those is open.)
    Json& place_for_value() {
        if (open_.empty()) return root_;
        if (open_.back()->is_object()) return *field_;
        return open_.back()->get_ref<Json::array_t&>().emplace_back();
    }

    const std::string& text_;
    Json root_;
    Json* field_ = nullptr;    // of the innermost open object: what its latest name stands for
    std::vector<Json*> open_;  // lists and objects that have begun and not ended
};

Json parse(const std::string& text) {
    Builder builder(text);
    Json::sax_parse(text, &builder);
    return builder.take();
}

}  // namespace

namespace {

// What a later version writes is refused by its number, before any field that this one does not know.
void check_format(Reader& reader) {
    const Json* told = reader.find("format");
    if (told == nullptr) return;
    if (const auto format = int_at<std::int64_t>(*told, "format"); format != scene_format)
        refuse("format", fmt::format("this is a scene file of format {}; Islet {} reads format {}", format, ISLET_VERSION_STRING, scene_format));
}

}  // namespace

Scene read_scene(const std::string& text) {
    const Json told = parse(text);
    Scene scene;
    Reader reader(told, "");
    check_format(reader);
    fields(reader, scene, Scene{});
    for_each_entry(reader, "bodies", [&](const Json& body, const std::string& at) { scene.bodies.push_back(body_from(body, at)); });
    for_each_entry(reader, "joints", [&](const Json& joint, const std::string& at) { scene.joints.push_back(joint_from(joint, at, scene)); });
    reader.end();
    check_head(scene);
    return scene;
}

}  // namespace islet::samples
