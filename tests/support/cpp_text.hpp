// Values as C++ that makes them again, to the last bit; and numbers made simpler, for programs that shrink.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "islet/islet.hpp"
#include "calls/calls.hpp"

namespace islet::test {

/// Points that are their own.
struct PointList {
    std::vector<Vec2> points;
    PointList() = default;
    explicit PointList(std::span<const Vec2> p) : points(p.begin(), p.end()) {}
    std::span<const Vec2> span() const { return points; }
};

inline std::string cpp_text(float f) {
    if (f != f) return "__builtin_nanf(\"\")";
    if (f - f != 0) return f > 0 ? "__builtin_inff()" : "-__builtin_inff()";
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", double(f));
    std::string s = text;
    if (s.find_first_of(".e") == std::string::npos) s += ".0";
    return s + "f";
}
inline std::string cpp_text(bool b) { return b ? "true" : "false"; }
inline std::string cpp_text(std::uint32_t n) { return std::to_string(n) + "u"; }
inline std::string cpp_text(std::int32_t n) { return std::to_string(n); }
inline std::string cpp_text(std::uint64_t n) { return std::to_string(n) + "u"; }
inline std::string cpp_text(BodyType t) { return t == BodyType::dynamic ? "BodyType::dynamic" : t == BodyType::kinematic ? "BodyType::kinematic" : t == BodyType::static_body ? "BodyType::static_body" : "BodyType(9)"; }
inline std::string cpp_text(Schedule s) { return "Schedule(" + std::to_string(int(s)) + ")"; }
inline std::string cpp_text(JointTrees s) { return "JointTrees(" + std::to_string(int(s)) + ")"; }
inline std::string cpp_text(SweepOrder s) { return "SweepOrder(" + std::to_string(int(s)) + ")"; }
template <class Id>
std::string cpp_text_of_id(const char* name, Id id) {
    return std::string(name) + "{" + std::to_string(id.index1) + ", " + std::to_string(id.generation) + "}";
}
inline std::string cpp_text(BodyId id) { return cpp_text_of_id("BodyId", id); }
inline std::string cpp_text(ShapeId id) { return cpp_text_of_id("ShapeId", id); }
inline std::string cpp_text(JointId id) { return cpp_text_of_id("JointId", id); }
inline std::string cpp_text(Vec2 v) { return "{" + cpp_text(v.x) + ", " + cpp_text(v.y) + "}"; }
inline std::string cpp_text(Rot q) { return "{" + cpp_text(q.c) + ", " + cpp_text(q.s) + "}"; }

/// The type, and the members as detail::members visits them.
template <class T>
struct CppNames;
#define ISLET_NAMES(type, ...) \
    template <> \
    struct CppNames<type> { \
        static constexpr const char* name = #type; \
        static constexpr const char* members[] = {__VA_ARGS__}; \
    };
ISLET_NAMES(Transform, "p", "q")
ISLET_NAMES(Filter, "category", "mask", "group")
ISLET_NAMES(MassData, "mass", "center", "inertia")
ISLET_NAMES(SurfaceMaterial, "friction", "restitution", "rolling_resistance", "tangent_speed", "id")
ISLET_NAMES(ExplosionDef, "position", "radius", "falloff", "impulse_per_length", "mask")
ISLET_NAMES(WindDef, "velocity", "drag", "lift", "density", "wake")
ISLET_NAMES(Circle, "center", "radius")
ISLET_NAMES(Capsule, "point1", "point2", "radius")
ISLET_NAMES(Segment, "point1", "point2")
ISLET_NAMES(ChainSegment, "ghost1", "segment", "ghost2")
ISLET_NAMES(HalfSpace, "normal", "offset")
ISLET_NAMES(SolverDef, "schedule", "substeps", "iterations", "relax_iterations", "contact_hertz", "contact_damping_ratio", "contact_push_speed", "joint_hertz",
            "joint_damping_ratio", "baumgarte", "omega", "warm_start", "joint_trees", "joint_tree_load", "sweep_order", "block_contacts", "shock",
            "measure_residual", "tolerance")
ISLET_NAMES(BodyDef, "type", "position", "angle", "linear_velocity", "angular_velocity", "linear_damping", "angular_damping", "gravity_scale",
            "sleep_threshold", "enable_sleep", "awake", "fixed_rotation", "lock_x", "lock_y", "enabled", "bullet", "user_data")
ISLET_NAMES(ShapeDef, "friction", "restitution", "rolling_resistance", "tangent_speed", "density", "filter", "sensor", "sensor_events", "hit_events",
            "pre_solve", "one_way", "material", "user_data")
ISLET_NAMES(JointFrame, "position", "angle")
ISLET_NAMES(JointSpring, "enable", "hertz", "damping_ratio", "target")
ISLET_NAMES(JointLimit, "enable", "lower", "upper")
ISLET_NAMES(JointMotor, "enable", "speed", "max_force")
ISLET_NAMES(JointSoftness, "linear_hertz", "linear_damping_ratio", "angular_hertz", "angular_damping_ratio")
ISLET_NAMES(JointBase, "body_a", "body_b", "frame_a", "frame_b", "collide_connected", "break_force", "break_torque", "user_data")
ISLET_NAMES(RevoluteJointDef, "base", "spring", "limit", "motor", "friction")
ISLET_NAMES(PrismaticJointDef, "base", "spring", "limit", "motor", "friction")
ISLET_NAMES(DistanceJointDef, "base", "length", "spring", "limit", "motor")
ISLET_NAMES(WeldJointDef, "base", "linear_hertz", "linear_damping_ratio", "angular_hertz", "angular_damping_ratio")
ISLET_NAMES(WheelJointDef, "base", "spring", "limit", "motor", "friction")
ISLET_NAMES(MotorJointDef, "base", "linear_velocity", "angular_velocity", "max_force", "max_torque", "linear_hertz", "linear_damping_ratio", "angular_hertz",
            "angular_damping_ratio")
ISLET_NAMES(MouseJointDef, "body", "target", "hertz", "damping_ratio", "max_force", "user_data")
ISLET_NAMES(PulleyJointDef, "base", "ground_a", "ground_b", "ratio")
ISLET_NAMES(JointRatchet, "step", "phase")
ISLET_NAMES(AngleJointDef, "base", "spring", "limit", "motor", "friction", "ratchet")
ISLET_NAMES(GearJointDef, "joint1", "joint2", "ratio", "break_torque", "user_data")
#undef ISLET_NAMES

template <class T>
std::string cpp_text(const T& value);

/// Member by member, without those that are as in a default one.
struct MemberTexts {
    std::vector<std::string> all;
    template <class... M>
    void operator()(M&... m) { (all.push_back(cpp_text(m)), ...); }
};

inline std::string cpp_text(const Polygon& p) {
    if (p.count == 4) {
        const Polygon box = make_box(p.vertices[2].x, p.vertices[2].y);
        if (std::memcmp(static_cast<const void*>(&box), &p, sizeof p) == 0) return "make_box(" + cpp_text(p.vertices[2].x) + ", " + cpp_text(p.vertices[2].y) + ")";
    }
    const auto list = [](const Vec2* v) {
        std::string s = "{";
        for (std::uint32_t i = 0; i < max_polygon_vertices; ++i) s += cpp_text(v[i]) + (i + 1 < max_polygon_vertices ? ", " : "}");
        return s;
    };
    return "Polygon{" + list(p.vertices) + ", " + list(p.normals) + ", " + cpp_text(p.centroid) + ", " + cpp_text(p.radius) + ", " + cpp_text(p.count) + "}";
}
inline std::string cpp_text(const PointList& list) {
    std::string s = "std::initializer_list<Vec2>{";
    for (std::size_t i = 0; i < list.points.size(); ++i) s += (i > 0 ? ", " : "") + cpp_text(list.points[i]);
    return s + "}";
}
template <class T>
std::string cpp_text(const T& value) {
    MemberTexts mine, usual;
    T copy = value, plain{};
    detail::members(mine, copy);
    detail::members(usual, plain);
    std::string s = CppNames<T>::name + std::string("{");
    bool any = false;
    for (std::size_t i = 0; i < mine.all.size(); ++i) {
        if (mine.all[i] == usual.all[i]) continue;
        s += (any ? ", ." : ".") + std::string(CppNames<T>::members[i]) + " = " + mine.all[i];
        any = true;
    }
    return s + "}";
}

/// Walks over all numbers of a value; makes one of them simpler: as it is by default, or shorter to write.
struct Numbers {
    static constexpr std::uint32_t ways = 6;
    std::uint32_t count = 0;
    std::uint32_t wanted = ~0u;
    std::uint32_t how = 0;
    bool reads = false;       ///< only looks what the number wanted is, which goes to `plain`
    std::uint64_t plain = 0;
    bool changed = false;

    void operator()(BodyId&) {}
    void operator()(ShapeId&) {}
    void operator()(JointId&) {}
    void operator()(PointList&) {}
    void operator()(float& a) {
        if (!is_wanted(a)) return;
        float usual = 0;
        std::memcpy(&usual, &plain, sizeof usual);
        if (how == 0) return set(a, usual);
        float b = a;
        if (how == 1) b = 0;
        if (how == 2) b = 1;
        if (how == 3) b = std::round(a);
        if (how == 4) b = std::round(a * 8) / 8;
        if (how == 5 && a - a == 0 && a != 0) {
            const float digit = std::pow(10.0f, std::floor(std::log10(std::fabs(a))) - 1);
            b = std::round(a / digit) * digit;
        }
        if (cpp_text(b).size() < cpp_text(a).size() && a != usual) set(a, b);
    }
    void operator()(Polygon& p) {
        (*this)(p.radius);
        if (count++ != wanted || how > 3) return;
        const Vec2 size = p.count > 0 ? Vec2{abs(p.vertices[0].x), abs(p.vertices[0].y)} : Vec2{1, 1};
        const Vec2 choices[] = {{0.5f, 0.5f}, {1, 0.5f}, {0.5f, 1}, size};
        const Polygon box = make_box(choices[how].x, choices[how].y);
        if (cpp_text(box).size() >= cpp_text(p).size()) return;
        p = box;
        changed = true;
    }
    /// What is as a rule left out: a whole definition, and each of its members.
    template <class T>
    void operator()(T& a) {
        if constexpr (requires { detail::members(*this, a); }) {
            if (count++ == wanted && how == 0 && !reads && cpp_text(a) != cpp_text(T{})) {
                a = T{};
                changed = true;
            }
            detail::members(*this, a);
        } else if (is_wanted(a) && how == 0) {
            T usual{};
            std::memcpy(&usual, &plain, sizeof usual);
            set(a, usual);
        }
    }
    template <class A, class B, class... Rest>
    void operator()(A& a, B& b, Rest&... rest) {
        (*this)(a);
        (*this)(b);
        ((*this)(rest), ...);
    }

private:
    template <class T>
    bool is_wanted(const T& a) {
        if (count++ != wanted) return false;
        if (reads) std::memcpy(&plain, &a, sizeof a);
        return !reads;
    }
    template <class T>
    void set(T& a, T b) {
        if (std::memcmp(&a, &b, sizeof a) == 0) return;
        a = b;
        changed = true;
    }
};

}  // namespace islet::test
