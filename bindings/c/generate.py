#!/usr/bin/env python3
"""Makes the C interface from bindings/api.json: include/islet/islet.h and most files of src; and tests, tests/c/refusals.c,
defaults.c, defaults_test.cpp and joint_defaults_test.cpp.

    bindings/c/generate.py           writes them
    bindings/c/generate.py --check   says whether they are up to date, and how much of the C++ interface they cover

The rules are short. What C++ passes by value C passes by value, and so poses and boxes; other references become pointers. A span becomes a pointer and a
count. A function of the world that changes it returns an IsletError; others return their result. A struct that may grow (GROWS) begins with its size, and
what it has of such structs it points to. What follows no rule is written by hand: src/by_hand.h and src/*_by_hand.cpp. What C does not have is in LEFT_OUT.
"""
import json
import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
API = os.path.join(HERE, "..", "api.json")
FIRST = os.path.join(HERE, "first.json")
HEADER = os.path.join(HERE, "include", "islet", "islet.h")
TESTS = os.path.join(HERE, "..", "..", "tests", "c")

# The functions stand in several files, because a linker takes whole objects from an archive: what makes joints, chains and recordings, and what loads images,
# brings parts of the engine that other programs leave out (ISLET_OPTIONAL in engine/src/data/features.hpp).
AREAS = ("values", "world", "bodies", "shapes", "chains", "joints", "queries", "mover", "images", "recording", "checks", "faults", "profile", "drawing", "fleets")
BY_HAND = os.path.join(HERE, "src", "by_hand.h")

# Structs that carry their size, so that they may get further fields at the end.
GROWS = set(
    "Capacity WorldDef SolverDef Hooks TaskSystem BodyDef ShapeDef ExplosionDef WindDef RevoluteJointDef PrismaticJointDef DistanceJointDef WeldJointDef "
    "WheelJointDef MotorJointDef MouseJointDef PulleyJointDef GearJointDef AngleJointDef DebugDraw MoverDef MoverInput StepReport StepProfile WorldCounters "
    "SnapshotInfo RecordingInfo ReplayResult FormatInfo".split())
RESULTS = {"SnapshotInfo", "RecordingInfo"}  # of those, written to
BY_VALUE = {"Transform", "Aabb"}  # though C++ has references to them
IN_REGISTERS = {"Vec2", "Rot", "Transform", "Aabb"}  # up to four floats, which many processors return in registers: made there, all else in place

# Written by hand, and why. Signature: (C function, reason)
HANDMADE = {
    "World::create(span<byte>, const Capacity &, const WorldDef &, Error *)": ("islet_create_world", "WorldDef points to three structs here"),
    "World::clear_error()": ("islet_world_clear_error", "its result is not the error before"),
    "World::last_error()": ("islet_world_last_error", "of no world it is null_pointer"),
    "World::export_island(BodyId, float, span<byte>, IslandProblem &)": ("islet_body_export_island", "its spans are of another library's types"),
    "copy_world(const World &, span<byte>, const Capacity &, span<byte>, Error *)": ("islet_copy_world", "it returns a world"),
    "read_snapshot(span<const byte>, SnapshotInfo &)": ("islet_read_snapshot", "the capacities are pointed to"),
    "read_recording(span<const byte>, RecordingInfo &)": ("islet_read_recording", "the capacities are pointed to"),
    "FormatInfo::is_readable()": ("islet_format_is_readable", "member of a plain struct"),
    "find_fault(const WorldDef &)": ("islet_find_world_def_fault", "WorldDef points to three structs here"),
    "describe(Error)": ("islet_describe", "knows the errors of C too"),
    "separation(const ShapeProxy &, const ShapeProxy &)": ("islet_separation", "of no shape the distance is not 0"),
    "Fleet::bytes(uint32_t, const Capacity &, uint32_t)": ("islet_fleet_bytes", "functions of a fleet have no world, and check that it is a fleet"),
    "Fleet::create(span<byte>, const World &, uint32_t, const TaskSystem &, Error *)": ("islet_create_fleet", "it returns a fleet"),
    "Fleet::size()": ("islet_fleet_size", "as for islet_fleet_bytes"),
    "Fleet::operator[](uint32_t)": ("islet_fleet_world", "it checks k"),
    "Fleet::step(const FleetStep &)": ("islet_fleet_step", "FleetStep has spans"),
    "Fleet::observe(span<const Sense>, span<float>, span<const uint8_t>)": ("islet_fleet_observe", "as for islet_fleet_bytes"),
    "Fleet::reset(uint32_t, span<const byte>, uint64_t, span<const Variation>)": ("islet_fleet_reset", "as for islet_fleet_bytes"),
    "Fleet::copy(uint32_t, uint32_t)": ("islet_fleet_copy", "as for islet_fleet_bytes"),
    "Fleet::fork(span<const uint32_t>)": ("islet_fleet_fork", "as for islet_fleet_bytes"),
}
NOT_STRUCTS = ("World", "StaticWorld", "StaticWorldOf", "IslandProblem", "IdHash", "Fleet", "FleetStep")  # classes, and what is written by hand

# Not in C, and why.
LEFT_OUT = {
    "operator*(Vec2, float)": "islet_vec2_scale",
    "operator+=(Vec2 &, Vec2)": "islet_vec2_add",
    "operator-=(Vec2 &, Vec2)": "islet_vec2_subtract",
    "operator*=(Vec2 &, float)": "islet_vec2_scale",
    "min(float, float)": "C has fminf",
    "max(float, float)": "C has fmaxf",
    "abs(float)": "C has fabsf",
    "clamp(float, float, float)": "C has fminf and fmaxf",
    "is_finite(float)": "C has isfinite",
    "StaticWorldOf::get()": "islet_create_world returns the world",
    "all_bodies(const World &)": "a range; islet_world_body_at and islet_world_capacity make the same loop",
    "all_shapes(const World &)": "islet_world_shape_at",
    "all_joints(const World &)": "islet_world_joint_at",
    "all_contacts(const World &)": "islet_world_contact_at",
    "shapes_of(const World &, BodyId)": "islet_body_next_shape",
    "joints_of(const World &, BodyId)": "islet_body_next_joint",
    "contacts_of(const World &, BodyId)": "islet_body_next_contact",
    "contacts_of(const World &, ShapeId)": "islet_shape_next_contact",
    "StaticWorldOf::create(const WorldDef &)": "a template; islet_create_world takes a static array",
    "lcp::*": "islet/islet_lcp.h has the matrix solvers, by hand",
}

# Names that no rule makes: overloads, operators, and what would be clumsy.
NAMES = {
    "operator+(Vec2, Vec2)": "vec2_add",
    "operator-(Vec2, Vec2)": "vec2_subtract",
    "operator-(Vec2)": "vec2_negate",
    "operator*(float, Vec2)": "vec2_scale",
    "operator*(Rot, Rot)": "rot_multiply",
    "cross(float, Vec2)": "vec2_cross_rate",
    "rotate(Rot, Vec2)": "rot_rotate",
    "transform_point(const Transform &, Vec2)": "transform_point",
    "inv_transform_point(const Transform &, Vec2)": "inv_transform_point",
    "make_rot(float)": "make_rot",
    "atan2(float, float)": "atan2",
    "angle_of(Rot)": "rot_angle",
    "make_proxy(span<const Vec2>, float)": "make_proxy",
    "make_proxy(const Aabb &)": "make_box_proxy",
    "transform_proxy(const Transform &, const ShapeProxy &)": "transform_proxy",
    "transform_polygon(const Transform &, const Polygon &)": "transform_polygon",
    "is_valid(const ShapeProxy &)": "proxy_is_valid",
    "overlaps(const ShapeProxy &, const ShapeProxy &)": "proxy_overlaps",
    "contains(const ShapeProxy &, Vec2)": "proxy_contains",
    "cast_ray(const ShapeProxy &, Vec2, Vec2)": "cast_ray",
    "cast_shape(const ShapeProxy &, Vec2, const ShapeProxy &)": "cast_shape",
    "World::create_joint(const RevoluteJointDef &)": "create_revolute_joint",
    "World::draw_shape(const DebugDraw &, ShapeId, const Transform &, const DrawStyle &)": "world_draw_shape",
    "describe_format(const FormatInfo &, span<char>)": "describe_format",
    "World::contact_at(uint32_t, ContactInfo &)": "world_contact_at",
    "World::set_transform(BodyId, const Transform &)": "body_set_pose",
    "columns(span<const Sense>)": "sense_columns",
    "World::joint1(JointId)": "gear_joint1",
    "World::joint2(JointId)": "gear_joint2",
}

SCALARS = {"float": "float", "bool": "bool", "uint8_t": "uint8_t", "uint32_t": "uint32_t", "int32_t": "int32_t", "uint64_t": "uint64_t", "size_t": "size_t",
           "void *": "void*", "const char *": "const char*", "void": "void"}


def snake(name):
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower()


class Api:
    def __init__(self):
        with open(API, encoding="utf-8") as file:
            self.all = json.load(file)
        self.constants = [c for c in self.all["constants"] if c.get("namespace") != "lcp"]
        self.enums = [e for e in self.all["enums"] if e.get("namespace") != "lcp"]
        self.structs = {s["name"]: s for s in self.all["structs"] if s.get("namespace") != "lcp" and s["name"] not in NOT_STRUCTS}
        self.callbacks = {c["name"]: c for c in self.all["callbacks"]}
        self.pointers = {f"const {name} *": name for name in self.structs}  # fields that point to one or several
        self.enum_types = {e["name"]: e["type"] for e in self.enums}
        self.plain = set(SCALARS) | {"DrawColor"}
        self.c_names = {}  # C++ name in comments: that in C

    # -- types ----------------------------------------------------------------------------------------------------------------------

    def c_type(self, cpp):
        if cpp in SCALARS:
            return SCALARS[cpp]
        if cpp in self.structs or cpp in self.enum_types or cpp in self.callbacks or cpp in ("DrawColor", "World"):
            return "Islet" + cpp
        raise KeyError("no C type for " + cpp)

    def parameter(self, name, cpp):
        """A parameter as C declares it."""
        span = re.fullmatch(r"span<(const )?(\w+)>", cpp)
        if span:
            const, inner = span.group(1) or "", span.group(2)
            if inner in ("byte", "char"):
                return f"{const}{'char' if inner == 'char' else 'void'}* {name}, size_t {name}_bytes"
            return f"{const}{self.c_type(inner)}* {name}, size_t {name}_count"
        reference = re.fullmatch(r"(const )?(\w+) ([&*])", cpp)
        if reference and cpp not in SCALARS:
            const, inner = reference.group(1) or "", reference.group(2)
            if const and inner in BY_VALUE:
                return f"{self.c_type(inner)} {name}"
            return f"{const}{self.c_type(inner)}* {name}"
        return f"{self.c_type(cpp)} {name}".replace("* ", "* ")

    def pointer(self, name, function):
        """A pointer to a function as C declares it."""
        parameters = []
        for p in function["parameters"]:
            parameters.append(self.pointer(p["name"], p["function"]) if p["type"] == "function" else self.parameter(p["name"], p["type"]))
        return f"{self.c_type(function['returns'])} (*{name})({', '.join(parameters)})"

    def field(self, struct, f):
        if f["type"] == "function":
            return self.pointer(f["name"], f["function"])
        array = re.fullmatch(r"(\w+)\[(\w+)\]", f["type"])
        if array:
            return f"{self.c_type(array.group(1))} {f['name']}[{array.group(2)}]"
        if f["type"] in GROWS:
            return f"{'' if struct in RESULTS else 'const '}{self.c_type(f['type'])}* {f['name']}"
        if f["type"] in self.pointers:
            return f"const {self.c_type(self.pointers[f['type']])}* {f['name']}"
        return f"{self.c_type(f['type'])} {f['name']}"

    def points_to_others(self, struct):
        return any(f["type"] in GROWS for f in self.structs[struct]["fields"])

    def has_wide_fields(self, struct):
        """Whether a field may need an alignment of 8."""
        for f in self.structs[struct]["fields"]:
            inner = re.sub(r"\[.*", "", f["type"])
            if inner in ("uint64_t", "size_t", "void *", "const char *", "function") or inner in self.pointers or inner in self.callbacks or inner in GROWS:
                return True
            if inner in self.structs and self.has_wide_fields(inner):
                return True
        return False

    # -- functions ------------------------------------------------------------------------------------------------------------------

    def signature(self, f):
        owner = f["class"] + "::" if "class" in f else f["namespace"] + "::" if "namespace" in f else ""
        return f"{owner}{f['name']}({', '.join(p['type'] for p in f['parameters'])})"

    def c_name(self, f):
        signature = self.signature(f)
        if signature in HANDMADE:
            return HANDMADE[signature][0]
        if signature in NAMES:
            return "islet_" + NAMES[signature]
        name = f["name"]
        types = [p["type"] for p in f["parameters"]]
        of = re.sub(r"^const | &$", "", types[0]) if types else ""
        if "class" not in f:
            if name == "make_proxy":
                return f"islet_make_{snake(of)}_proxy"
            if name == "find_fault":
                return f"islet_find_{snake(of)}_fault"
            if name == "draw_shape":
                return "islet_draw_" + snake(re.sub(r"^const | &$", "", types[1]))
            return f"islet_{snake(of)}_{name}" if of in ("Vec2", "Rot", "Transform", "Aabb", "Circle", "Capsule", "Segment", "ChainSegment", "HalfSpace", "Polygon", "Capacity") and name not in (
                "world_bytes", "max_snapshot_bytes") else "islet_" + name
        if name == "create_joint":
            return "islet_create_" + snake(re.sub(r"^const |Def &$", "", types[0]))
        if name == "create_shape":
            return "islet_create_" + snake(re.sub(r"^const | &$", "", types[1]))
        if name.startswith(("create_", "destroy_")):
            return "islet_" + name
        if of in ("BodyId", "ShapeId", "JointId"):
            kind = of[:-2].lower()
            return f"islet_{kind}_{name.replace(kind + '_', '', 1)}"
        return "islet_world_" + name

    def functions(self):
        """Those with a C function each: (entry, C name, handmade)."""
        for f in self.all["functions"]:
            signature = self.signature(f)
            if signature in LEFT_OUT or f.get("namespace") == "lcp" or (f["name"] == "operator[]" and f.get("const")):
                continue
            yield f, self.c_name(f), signature in HANDMADE

    # -- comments -------------------------------------------------------------------------------------------------------------------

    def translated(self, text):
        def member(match):
            owner, name = match.groups()
            if owner in ("World", "islet"):
                return self.c_names.get((owner, name), match.group(0))
            if owner in self.enum_types:
                return f"ISLET_{snake(owner)}_{name}".upper()
            if owner in self.structs:
                return f"Islet{owner}.{name}"
            return match.group(0)
        return re.sub(r"\b(\w+)::(\w+)", member, text)

    def comment(self, entry, indent=""):
        return wrapped(self.translated(entry["doc"]), indent + "/// ") if "doc" in entry else []


def wrapped(text, start, width=158):
    lines, line = [], start.rstrip()
    for word in text.split():
        if len(line) + 1 + len(word) > width and line != start.rstrip():
            lines.append(line)
            line = start.rstrip()
        line += " " + word
    return lines + [line]


# -- values ---------------------------------------------------------------------------------------------------------------------------


def c_float(value):
    text = repr(float(value))
    if "e" in text:
        mantissa, exponent = text.split("e")
        text = (mantissa if "." in mantissa else mantissa + ".0") + "e" + str(int(exponent))
    return text + "f"


def c_scalar(api, cpp, value):
    if isinstance(value, str):
        enum, _, name = value.rpartition("::")
        return f"ISLET_{snake(enum) + '_' if enum else ''}{name}".upper()
    if cpp == "float":
        return c_float(value)
    if cpp == "bool":
        return "true" if value else "false"
    return str(value) + ("u" if cpp in ("uint32_t", "uint64_t", "size_t", "DrawColor") else "")


def assignments(api, struct, place, given):
    """Lines that give the fields of a struct that is all zeros its defaults, where `given` (a list or an object) says nothing else."""
    lines = []
    for i, f in enumerate(api.structs[struct]["fields"]):
        cpp, name = f["type"], f["name"]
        default = f.get("default")
        if isinstance(given, list) and i < len(given):
            default = given[i]
        elif isinstance(given, dict) and name in given:
            default = given[name]
        if cpp in api.structs:
            if cpp not in GROWS:
                lines += assignments(api, cpp, place + "." + name, default if default is not None else {})
        elif default not in (None, 0, False, {}, []) and not (isinstance(default, str) and enum_value(api, default) == 0):
            lines.append(f"    {place}.{name} = {c_scalar(api, cpp, default)};")
    return lines


def enum_value(api, text):
    enum, _, name = text.rpartition("::")
    if not enum:
        return next(c["value"] for c in api.constants if c["name"] == name)
    return next(v["value"] for e in api.enums if e["name"] == enum for v in e["values"] if v["name"] == name)


# -- the header -----------------------------------------------------------------------------------------------------------------------

HEAD = """\
// Islet for C, C11 or later: a 2D rigid-body physics engine in one fixed block of memory. docs/c.md is an introduction.
//
// Made by bindings/c/generate.py from the headers of the C++ interface; do not edit.
//
// Units are metres, kilograms, seconds and radians. Names follow C++: islet::BodyDef is IsletBodyDef, World::position(BodyId) is islet_body_position.
//
// Errors. A function that changes a world returns an IsletError. All others return their result, or a null or zero value on an error, which is then
// islet_world_last_error. On an error nothing has changed. Comments name errors in small letters: stale_id is ISLET_ERROR_STALE_ID. Three errors are of C
// alone: null_pointer (a pointer that must not be null is, the world's among them), struct_size and not_a_fleet.
//
// Structs that begin with struct_size may get further fields in later versions. Start from their default (islet_default_body_def), which sets the size. Of a
// wrong size they are refused: struct_size. Where such a struct holds another, it points to it; null stands for the default, or for a result that is not wanted.
// A null pointer also stands for the default where a comment says that it may be null.
//
// Memory. No function allocates. What a pointer or a span returned points to lives until the next call that changes the world.
#ifndef ISLET_ISLET_H
#define ISLET_ISLET_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#if defined(ISLET_SHARED_LIBRARY) && defined(__GNUC__)  // while the library itself is compiled
#define ISLET_C_API __attribute__((visibility("default")))
#else
#define ISLET_C_API
#endif

#ifdef __cplusplus
#define ISLET_ZERO {}
extern "C" {
#else
#define ISLET_ZERO {0}
#endif
"""

VERSION = """
#define ISLET_VERSION_MAJOR {0}
#define ISLET_VERSION_MINOR {1}
#define ISLET_VERSION_PATCH {2}
#define ISLET_VERSION (ISLET_VERSION_MAJOR * 10000 + ISLET_VERSION_MINOR * 100 + ISLET_VERSION_PATCH)
#define ISLET_VERSION_STRING "{0}.{1}.{2}"
"""


def section(title):
    return ["", f"// -- {title} " + "-" * (130 - len(title)), ""]


def constant_text(c):
    if c["name"] == "max_capacity":
        return "(sizeof(void*) >= 8 ? 1u << 22 : 1u << 18)"
    if c["type"] == "float":
        return re.sub(r"max_position", "ISLET_MAX_POSITION", "(" + c["text"] + ")") if " " in c["text"] else c["text"] + ("" if c["text"].endswith("f") else "f")
    if c.get("namespace") == "draw_color":
        return f"0x{c['value']:06x}u"
    return f"{c['value']}u"


def span_types(api):
    found = []
    for f, _, handmade in api.functions():
        span = re.fullmatch(r"span<const (\w+)>", f["returns"])
        if span and span.group(1) not in found:
            found.append(span.group(1))
    return found


def order_of_structs(api):
    return list(api.structs)  # the headers have them in an order in which each knows those before


def defaulted(api):
    """Structs with a function that gives their default."""
    return [s for s in api.structs if s in GROWS or assignments(api, s, "x", {})]


def returns_of(api, f, changes):
    """(C return type, extra parameter or None, kind)."""
    cpp = f["returns"]
    if cpp == "void":
        return ("IsletError", None, "code") if changes else ("void", None, "void")
    if cpp == "Error":
        return "IsletError", None, "error"
    span = re.fullmatch(r"span<const (\w+)>", cpp)
    if span:
        return f"Islet{span.group(1)}Span", None, "span"
    reference = re.fullmatch(r"(?:const )?(\w+) &", cpp)
    inner = reference.group(1) if reference else cpp
    if inner in GROWS:
        return "IsletError", f"Islet{inner}* out", "out"
    pointer = re.fullmatch(r"const (\w+) \*", cpp)
    if pointer and cpp != "const char *":
        return f"const Islet{pointer.group(1)}*", None, "pointer"
    return api.c_type(inner), None, "value"


def world_of(f):
    """Whether the function is one of a world, and whether it changes it; parameters without the world."""
    parameters = f["parameters"]
    if f.get("class") == "World":
        return True, not f.get("const"), parameters
    if parameters and parameters[0]["type"] == "World &":
        return True, True, parameters[1:]
    return False, False, parameters


def declaration(api, f, name):
    has_world, changes, parameters = world_of(f)
    result, extra, _ = returns_of(api, f, changes)
    listed = [f"{'' if changes else 'const '}IsletWorld* world"] if has_world else []
    listed += [api.parameter(p["name"], p["type"]) for p in parameters]
    if extra:
        listed.append(extra)
    return f"{result} {name}({', '.join(listed) or 'void'})".replace("* ", "* ")


def folded(line, width=158):
    """A long declaration on several lines."""
    if len(line) <= width:
        return [line]
    open_at = line.index("(") + 1
    indent, rest, lines, current = " " * 4, line[open_at:], [], line[:open_at]
    for part in re.split(r"(?<=,) ", rest):
        if len(current) + len(part) + 1 > width:
            lines.append(current.rstrip())
            current = indent
        current += part + " "
    return lines + [current.rstrip()]


def header(api):
    out = [HEAD.rstrip()] + VERSION.format(*api.all["version"].split(".")).splitlines()

    out += section("constants")
    for c in api.constants:
        space = c.get("namespace", "")
        out += api.comment(c)
        out.append(f"#define ISLET_{(space + '_' if space else '').upper()}{c['name'].upper()} {constant_text(c)}")

    out += section("enumerations, all one byte wide")
    for e in api.enums:
        out += api.comment(e)
        out.append(f"typedef {e['type']} Islet{e['name']};")
        out.append("enum {")
        for v in e["values"]:
            out += api.comment(v, "    ")
            out.append(f"    ISLET_{snake(e['name']).upper()}_{v['name'].upper()} = {v['value']},")
        if e["name"] == "Error":
            out += ["    /// What a pointer to a fleet points to is none, or has been moved.", "    ISLET_ERROR_NOT_A_FLEET = 253,",
                    "    /// A pointer that must not be null is null.", "    ISLET_ERROR_NULL_POINTER = 254,",
                    "    /// A struct has a struct_size that no version of Islet up to this one gives it: start from its default.", "    ISLET_ERROR_STRUCT_SIZE = 255,"]
        out += ["};", ""]

    out += section("types")
    out += ["/// A world. It lives in memory of yours (islet_create_world).", "typedef struct IsletWorld IsletWorld;", "", "/// 0xrrggbb.",
            "typedef uint32_t IsletDrawColor;", ""]
    late = {"ErrorHook", "Clock"}
    made = set()

    def callback(c):
        made.add(c["name"])
        return api.comment(c) + ["typedef " + api.pointer("Islet" + c["name"], c) + ";", ""]

    for c in api.callbacks.values():
        if c["name"] in late:
            out += callback(c)
    declared = {p["type"] for s in api.structs.values() for f in s["fields"] if f["type"] == "function" for p in f["function"]["parameters"]}
    forward = sorted({m.group(1) for t in declared for m in [re.fullmatch(r"(?:const )?(\w+) &", t)] if m and m.group(1) == "PreSolve"})
    for name in forward:
        out += [f"typedef struct Islet{name} Islet{name};", ""]
    for name in order_of_structs(api):
        s = api.structs[name]
        for f in s["fields"]:
            if f["type"] in api.callbacks and f["type"] not in made:
                out += callback(api.callbacks[f["type"]])
        out += api.comment(s)
        out.append(f"struct Islet{name} {{" if name in forward else f"typedef struct Islet{name} {{")
        if name in GROWS:
            out.append(f"    uint32_t struct_size;  ///< sizeof(Islet{name})")
            if api.has_wide_fields(name):
                out.append("    uint32_t reserved;     ///< 0")
        for f in s["fields"]:
            out += api.comment(f, "    ")
            out.append(f"    {api.field(name, f)};")
        out += ["};" if name in forward else f"}} Islet{name};", ""]
    for c in api.callbacks.values():
        if c["name"] not in made:
            out += callback(c)
    for name in span_types(api):
        out += [f"typedef struct Islet{name}Span {{", f"    const Islet{name}* data;", "    size_t count;", f"}} Islet{name}Span;", ""]

    out += section("defaults") + ["#ifndef __cplusplus  // GCC makes a value without a name in its place, but copies a variable", ""]
    for name in defaulted(api):
        given = [f".struct_size = sizeof(Islet{name})"] if name in GROWS else []
        given += [line.strip().rstrip(";") for line in assignments(api, name, "", {})]
        lines, line = [], f"    return (Islet{name}){{" + given[0]
        for field in given[1:]:
            if len(line) + len(field) > 153:
                lines.append(line + ",")
                line = " " * 8 + field
            else:
                line += ", " + field
        out += [f"static inline Islet{name} islet_default_{snake(name)}(void) {{", *lines, line + "};", "}", ""]
    out += ["#else", ""]
    for name in defaulted(api):
        out.append(f"static inline Islet{name} islet_default_{snake(name)}(void) {{")
        out.append(f"    Islet{name} def = ISLET_ZERO;")
        if name in GROWS:
            out.append("    def.struct_size = sizeof def;")
        out += assignments(api, name, "def", {}) + ["    return def;", "}", ""]
    out += ["#endif", ""]

    out += section("functions")
    with open(BY_HAND, encoding="utf-8") as file:
        out += file.read().rstrip().splitlines()
    gap = True
    for f, name, handmade in api.functions():
        if handmade:
            continue
        comment = api.comment(f)
        nullable = [p["name"] for p in world_of(f)[2] if nulls(p) == "default"]
        if "doc" in f and gap is False:
            out.append("")
        if nullable:
            comment = wrapped(api.translated(f.get("doc", "")) + f" {' and '.join(nullable)} may be null.", "/// ")
        out += comment + folded("ISLET_C_API " + declaration(api, f, name) + ";")
        gap = False
    out += ["", "#ifdef __cplusplus", "}", "#endif", "", "#endif", ""]
    return "\n".join(out)


# -- the source -----------------------------------------------------------------------------------------------------------------------


def nulls(p):
    """What a null pointer stands for: 'default', 'refused', 'allowed', or '' if the parameter is none."""
    cpp = p["type"]
    if cpp in SCALARS or re.fullmatch(r"Error \*", cpp):
        return ""
    reference = re.fullmatch(r"(const )?(\w+) &", cpp)
    if reference:
        if reference.group(1) and reference.group(2) in BY_VALUE:
            return ""
        return "default" if has_default(p) else "refused"
    return ""


def has_default(p):
    """Filters of queries may be null everywhere, though C++ has a default only where one can be last."""
    return "default" in p or p["type"] == "const QueryFilter &"


def taken_apart(api, f, name):
    """The body of a function in C++: what the call needs is checked, one condition after the other, and the call is made if all hold. Code that functions
    have in common stands in glue.cpp and in World (begin_call, end_call), so that each takes little flash."""
    has_world, changes, parameters = world_of(f)
    result, extra, kind = returns_of(api, f, changes)
    world = "world" if has_world else "nullptr"
    lines, conditions, arguments = [], [], []
    if has_world:
        conditions.append("begin(world)" if kind == "code" else "world != nullptr")
    for p in parameters:
        n, cpp = p["name"], p["type"]
        span = re.fullmatch(r"span<(const )?(\w+)>", cpp)
        reference = re.fullmatch(r"(const )?(\w+) &", cpp)
        if span:
            const, inner = span.group(1) or "", span.group(2)
            length = f"{n}_bytes" if inner in ("byte", "char") else f"{n}_count"
            conditions.append(f"is_there({world}, {n}, {length})")
            cpp_inner = {"byte": "std::byte", "char": "char"}.get(inner, inner)
            arguments.append(f"span_of<{const}{cpp_inner}>({n}, {length})")
        elif reference:
            const, inner = reference.group(1) or "", reference.group(2)
            if const and inner in BY_VALUE:
                arguments.append(f"in<{inner}>({n})")
            elif inner in GROWS:
                other = re.fullmatch(r"is_there\(world, (\w+)\)", conditions[-1]) if has_default(p) and kind == "value" and conditions else None
                if conditions == ["world != nullptr"] and not has_default(p) and kind != "out":
                    conditions.clear()  # take() checks it
                if other:  # a shape and its definition: one function checks both, and the world
                    conditions.clear()
                    taken = f"take_with<{inner}>({world}, {other.group(1)}, {n}, {n}_room)"
                else:
                    taken = f"take{'_or_default' if has_default(p) else ''}<{inner}>({world}, {n}, {n}_room)"
                lines += [f"    Room<{inner}> {n}_room;", f"    const {inner}* {n}_taken = nullptr;"]
                conditions.append(f"({n}_taken = {taken}) != nullptr")
                if inner == "DebugDraw":
                    arguments.append(f"Drawing(*{n}_taken).functions")
                else:
                    arguments.append(f"*{n}_taken")
            elif has_default(p):
                arguments.append(f"{n} == nullptr ? *take_default<{inner}>() : *cast<const {inner}>({n})")
            else:
                conditions.append(f"is_there({world}, {n})")
                arguments.append(f"*cast<{const}{inner}>({n})")
        elif cpp == "Error *":
            arguments.append(f"cast<Error>({n})")
        elif cpp in api.callbacks:
            arguments.append(f"function<{cpp}>({n})")
        elif cpp in SCALARS or cpp == "DrawColor":
            arguments.append(n)
        else:
            arguments.append(f"in<{cpp}>({n})")
    operator = re.fullmatch(r"operator(.+)", f["name"])
    if operator:
        call = f" {operator.group(1)} ".join(arguments) if len(arguments) > 1 else operator.group(1) + arguments[0]
    elif f.get("class") == "World":
        call = f"of(world).{f['name']}({', '.join(arguments)})"
    elif has_world:
        call = f"islet::{f['name']}(of(world), {', '.join(arguments)})"
    else:
        call = f"islet::{f['name']}({', '.join(arguments)})"
    inner = re.fullmatch(r"(?:span<const (\w+)>|const (\w+) \*|(?:const )?(\w+) &)", f["returns"])
    inner = next((g for g in inner.groups() if g), None) if inner else f["returns"]
    scalar = f["returns"] in SCALARS or f["returns"] == "DrawColor"
    in_place = kind == "value" and not scalar and inner not in IN_REGISTERS and inner not in api.enum_types and inner not in defaulted(api)
    if in_place:
        call = f"new (&found) {inner}({call})"
    test = " && ".join(conditions)
    guard = f"    if ({test}) " if test else "    "
    if len(guard) + len(call) > 140:
        guard = "    if (" + (" &&\n        ".join(conditions) if len(guard) > 150 else test) + ")\n        "
    if kind == "void":
        lines.append(f"{guard}{call};")
    elif kind == "code":
        lines += [f"{guard}{call};", "    return end(world);"]
    elif kind == "out":
        conditions.append(f"fits<{inner}>({world}, out)")
        for condition in conditions:
            given = "out" if condition.startswith("fits") else re.search(r"take\S*\(\w+, (\w+)", condition)
            error = "ISLET_ERROR_NULL_POINTER" if given is None else f"why({given if given == 'out' else given.group(1)})"
            refused = {"world != nullptr": "world == nullptr"}.get(condition, f"!({condition})" if " " in condition.split("(")[0] or "!=" in condition else f"!{condition}")
            lines.append(f"    if ({refused}) return {error};")
        lines += [f"    give<{inner}>(out, {call});", "    return ISLET_ERROR_NONE;"]
    elif in_place:
        nothing = f" = {{why({parameters[0]['name']}), nullptr}}" if inner == "FieldFault" else " = {}" if test else ""  # errors of C are faults, too
        lines += [f"    Islet{inner} found{nothing};", f"{guard}{call};", "    return found;"]
    elif not test:
        lines.append(f"    return {call if scalar else 'out(' + call + ')'};")
    elif kind == "span":
        lines += [f"    span<const {inner}> found;", f"{guard}found = {call};", f"    return {{cast<const Islet{inner}>(found.data()), found.size()}};"]
    elif kind == "pointer":
        lines += [f"    const {inner}* found = nullptr;", f"{guard}found = {call};", f"    return cast<const Islet{inner}>(found);"]
    elif scalar:
        lines += [f"    {api.c_type(f['returns'])} found = {{}};", f"{guard}found = {call};", "    return found;"]
    elif f["returns"] in api.callbacks:
        lines += [f"    {f['returns']} found = nullptr;", f"{guard}found = {call};", f"    return function<{api.c_type(f['returns'])}>(found);"]
    else:
        lines += [f"    {inner} found = {{}};", f"{guard}found = {call};", "    return out(found);"]
    return lines


def area_of(name):
    """The file that a function stands in."""
    if name.endswith("_fault"):
        return "faults"
    if name == "islet_sense_columns":
        return "fleets"
    if "chain" in name:
        return "chains"
    if "joint" in name:
        return "joints"
    if name == "islet_step_mover":
        return "mover"
    if "record" in name or name == "islet_replay":
        return "recording"
    if name.endswith(("_validate", "_hash")):
        return "checks"
    if re.search(r"snapshot|_counters$|_save$|_restore$|_load$|_delta|_apply$|_format$", name):
        return "images"
    if name.endswith(("_profile", "_set_clock")):
        return "profile"
    if "draw" in name or name == "islet_distinct_color":
        return "drawing"
    if re.search(r"islet_world_(cast|overlap|closest|surfaces)", name):
        return "queries"
    if re.match(r"islet_(body_|create_body|destroy_body)", name):
        return "bodies"
    if re.match(r"islet_(shape_|create_|destroy_shape)", name):
        return "shapes"
    return "world" if name.startswith("islet_world_") else "values"


def source(api, area):
    out = [f"// Functions of islet.h: {area}.", "//", "// Made by bindings/c/generate.py; do not edit.", '#include "glue.hpp"', "", "using namespace islet;",
           "using namespace islet::c;", "", 'extern "C" {', ""]
    for f, name, handmade in api.functions():
        if handmade or area_of(name) != area:
            continue
        out += folded(declaration(api, f, name) + " {") + taken_apart(api, f, name) + ["}", ""]
    out += ['}  // extern "C"', ""]
    return "\n".join(out)


def layouts(api, first):
    out = ["// The structs, enumerations and constants of islet.h are those of C++.", "//", "// Made by bindings/c/generate.py; do not edit.", '#include "glue.hpp"', "",
           "namespace islet::c {", ""]
    for e in api.enums:
        out.append(f"static_assert(sizeof({e['name']}) == sizeof(Islet{e['name']}) && static_cast<int>({e['name']}::{e['values'][-1]['name']}) == "
                   f"ISLET_{snake(e['name']).upper()}_{e['values'][-1]['name'].upper()});")
    out.append("")
    for name in api.structs:
        s = api.structs[name]
        c = "Islet" + name
        if api.points_to_others(name):
            continue
        if name in GROWS:
            start = s["fields"][0]["name"]
            out.append(f"static_assert(sizeof({c}) == sizeof({name}) + start_of<{name}> && start_of<{name}> == offsetof({c}, {start}));")
            shift = f" + start_of<{name}>"
        else:
            out.append(f"static_assert(sizeof({c}) == sizeof({name}) && alignof({c}) == alignof({name}));")
            shift = ""
        for f in s["fields"]:
            out.append(f"static_assert(offsetof({c}, {f['name']}) == offsetof({name}, {f['name']}){shift} && sizeof({c}::{f['name']}) == sizeof({name}::{f['name']}));")
        if name in first and first[name] != [f["name"] for f in s["fields"]]:
            out.append(f"static_assert(sizeof({c}) > sizeof(First<{name}>));")
    for c in api.constants:
        space = c.get("namespace", "")
        out.append(f"static_assert(ISLET_{(space + '_' if space else '').upper()}{c['name'].upper()} == {space + '::' if space else ''}{c['name']});")
    out += ["", "}  // namespace islet::c", ""]
    return "\n".join(out)


def glue_types(api, first):
    """For glue.hpp: what in() and out() convert, and the structs that grow."""
    out = ["// Which types of C stand for which of C++. Made by bindings/c/generate.py; do not edit.", "//",
           "//   ISLET_C_SAME(X)   the same size and fields", "//   ISLET_C_GROWS(X)  the same after the first bytes of the C struct: X(type, bytes)", "#pragma once", ""]
    same = [e["name"] for e in api.enums] + [s for s in api.structs if s not in GROWS]
    grows = [s for s in api.structs if s in GROWS and not api.points_to_others(s)]
    out.append("#define ISLET_C_SAME(X) \\")
    out.append(" \\\n".join(f"    X({name})" for name in same))
    out += ["", "#define ISLET_C_GROWS(X) \\"]
    out.append(" \\\n".join(f"    X({name}, {8 if api.has_wide_fields(name) else 4})" for name in grows))
    changed = [s for s in grows if first.get(s) and first[s] != [f["name"] for f in api.structs[s]["fields"]]]
    out += ["", "namespace islet::c {", "/// The first version of a struct that has grown since.", "template <class T>", "struct First;", "}  // namespace islet::c", ""]
    for name in changed:
        fields = [f["name"] for f in api.structs[name]["fields"]]
        if fields[: len(first[name])] != first[name]:
            sys.exit(f"{name}: new fields of a struct that C programs know must stand at its end, or be converted by hand")
        kept = [f for f in api.structs[name]["fields"] if f["name"] in first[name]]
        out += ["template <>", f"struct islet::c::First<islet::{name}> {{", "    std::uint32_t struct_size;"]
        if api.has_wide_fields(name):
            out.append("    std::uint32_t reserved;")
        out += [f"    {api.field(name, f)};" for f in kept] + ["};"]
    return "\n".join(out).rstrip() + "\n"


# -- a test ---------------------------------------------------------------------------------------------------------------------------

REFUSALS = """\
// Every function of the C interface that takes a pointer refuses a null one, and structs of a wrong size, and changes nothing.
//
// Made by bindings/c/generate.py; do not edit.
#include "refusals.h"
"""


def refusals(api):
    """A call for each pointer that must not be null and each size that may be wrong; all else that the call gets is good."""
    calls = []

    def good(p):
        n, cpp = p["name"], p["type"]
        span = re.fullmatch(r"span<(const )?(\w+)>", cpp)
        if span:
            inner = span.group(2)
            return ["some_bytes" if inner == "byte" else "(char*)some_bytes", "sizeof some_bytes"] if inner in ("byte", "char") else [f"&some_{inner}", "1"]
        reference = re.fullmatch(r"(const )?(\w+) &", cpp)
        if reference:
            return [("" if reference.group(1) and reference.group(2) in BY_VALUE else "&") + "some_" + reference.group(2)]
        if cpp in ("Error *", "void *") or cpp in api.callbacks:
            return ["NULL"]
        if cpp == "bool":
            return ["false"]
        return ["0"] if cpp in SCALARS or cpp in api.enum_types or cpp == "DrawColor" else [f"some_{cpp}"]

    for f, name, _ in api.functions():
        if name in ("islet_create_world", "islet_find_world_def_fault", "islet_copy_world", "islet_describe", "islet_separation", "islet_format_is_readable", "islet_body_export_island"):
            continue  # in calls.c
        if f.get("class") == "Fleet":
            continue  # in fleets.c
        has_world, changes, parameters = world_of(f)
        result, extra, kind = returns_of(api, f, changes)
        codes = kind in ("code", "error", "out")
        given = [(p, good(p)) for p in parameters]
        if extra:
            given.append(({"name": "out", "type": re.sub(r"^const | &$", "", f["returns"]) + " &"}, ["&some_" + re.sub(r"^const | &$", "", f["returns"])]))
        every = [a for _, arguments in given for a in arguments]
        if name == "islet_world_last_error":
            continue

        def call(arguments, world="world"):
            return f"{name}({', '.join(([world] if has_world else []) + arguments) })"

        def check(what, error):
            if codes:
                return f"    CODE({what}, {error});"
            return f"    {'LAST' if has_world else 'CALL'}({what}{', ' + error if has_world else ''});"

        if has_world:
            calls.append(f"    {'CODE' if codes else 'CALL'}({call(every, 'NULL')}{', ISLET_ERROR_NULL_POINTER' if codes else ''});")
        place = 0
        for p, arguments in given:
            reference = re.fullmatch(r"(const )?(\w+) &", p["type"])
            span = p["type"].startswith("span<")
            first = every[place]
            if (first.startswith("&") or first.endswith("some_bytes")) and (span or nulls(p) != "default"):
                calls.append(check(call(every[:place] + ["NULL"] + every[place + 1:]), "ISLET_ERROR_NULL_POINTER"))
            if reference and reference.group(2) in GROWS:
                for size in ("0", f"sizeof(Islet{reference.group(2)}) - 1", f"sizeof(Islet{reference.group(2)}) + 8"):
                    calls.append(f"    {first[1:]}.struct_size = {size};")
                    calls.append(check(call(every), "ISLET_ERROR_STRUCT_SIZE"))
                calls.append(f"    {first[1:]}.struct_size = sizeof(Islet{reference.group(2)});")
            place += len(arguments)
    text = "\n".join(calls)
    used = [name for name in list(api.structs) if re.search(rf"\bsome_{name}\b", text)]
    out = [REFUSALS.rstrip(), ""] + [f"static Islet{name} some_{name};" for name in used] + ["static uint64_t some_bytes[8];", "", "int main(void) {", "    IsletWorld* world = make_world();"]
    out += [f"    some_{name} = islet_default_{snake(name)}();" for name in used if name in GROWS]
    out += calls + ["    return result();", "}", ""]
    return "\n".join(out)


def compared(api, name):
    """Lines that compare the fields of a struct of C with those of C++."""
    out = []
    if name in GROWS:
        out.append("    EXPECT_EQ(c.struct_size, sizeof c);")
        if api.has_wide_fields(name):
            out.append("    EXPECT_EQ(c.reserved, 0u);")
    for f in api.structs[name]["fields"]:
        field, cpp = f["name"], re.sub(r"\[.*", "", f["type"])
        if f["type"] in GROWS:
            out.append(f"    EXPECT_EQ(c.{field}, nullptr);")
        elif f["type"] in api.structs:
            out.append(f"    expect_same(c.{field}, cpp.{field});")
        elif "[" in f["type"]:
            continue
        elif cpp == "function" or cpp in api.callbacks or cpp in api.pointers:
            out.append(f"    EXPECT_TRUE(c.{field} == nullptr && cpp.{field} == nullptr);")
        elif cpp in api.enum_types:
            out.append(f"    EXPECT_EQ(int(c.{field}), int(cpp.{field}));")
        else:
            out.append(f"    EXPECT_EQ(c.{field}, cpp.{field});")
    return out


def parts(api, name):
    """The structs that a struct holds, those inside before those around."""
    for f in api.structs[name]["fields"]:
        if f["type"] in api.structs and f["type"] not in GROWS:
            yield from parts(api, f["type"])
            yield f["type"]


def defaults_test(api, of, names, headers):
    out = [f"// The defaults of {of} in C are those of C++.", "//", "// Made by bindings/c/generate.py; do not edit.", "#include <gtest/gtest.h>",
           "#include <islet/islet.h>", "", *(f"#include <islet/{header}>" for header in headers), "", "namespace {", ""]
    inner = dict.fromkeys(part for whole in names for part in parts(api, whole))
    for name in inner:
        out += [f"void expect_same(const Islet{name}& c, const islet::{name}& cpp) {{", *compared(api, name), "}", ""]
    for name in names:
        lines = ["    expect_same(c, cpp);"] if name in inner else compared(api, name)
        out += [f'extern "C" Islet{name} default_{snake(name)}_of_c(void);', f"TEST(Defaults, Of{name}) {{", f"    const islet::{name} cpp = {{}};",
                f"    for (const Islet{name}& c : {{islet_default_{snake(name)}(), default_{snake(name)}_of_c()}}) {{", *("    " + line for line in lines), "    }", "}", ""]
    return "\n".join(out + ["}  // namespace", ""])


def defaults_of_c(api):
    out = ["// The defaults as a program in C gets them, for the tests in C++.", "//", "// Made by bindings/c/generate.py; do not edit.", "#include <islet/islet.h>", ""]
    for name in defaulted(api):
        function = f"Islet{name} default_{snake(name)}_of_c(void)"
        out += [function + ";", f"{function} {{ return islet_default_{snake(name)}(); }}"]
    return "\n".join(out + [""])


def defaults_tests(api):
    """Two files of tests, of joints and of all else, so that neither grows too long."""
    of_joints = [name for name in defaulted(api) if "Joint" in name]
    others = [name for name in defaulted(api) if name not in of_joints]
    return {os.path.join(TESTS, "defaults.c"): defaults_of_c(api),
            os.path.join(TESTS, "defaults_test.cpp"): defaults_test(api, "all structs but those of joints", others, ["islet.hpp", "fleet.hpp", "island.hpp"]),
            os.path.join(TESTS, "joint_defaults_test.cpp"): defaults_test(api, "structs of joints", of_joints, ["islet.hpp"])}


# -- ----------------------------------------------------------------------------------------------------------------------------------


def make():
    api = Api()
    names = {}
    for f, name, _ in api.functions():
        if name in names:
            sys.exit(f"{name} would be {api.signature(f)} and {names[name]}: give one of them another name in NAMES")
        names[name] = api.signature(f)
        owner = f.get("class", "islet")
        api.c_names.setdefault((owner, f["name"]), name)
    for table in (HANDMADE, NAMES, LEFT_OUT):
        known = {api.signature(f) for f in api.all["functions"]} | {"lcp::*"}
        for signature in table:
            if signature not in known:
                sys.exit(f"bindings/c/generate.py names {signature}, which there is not")
    first = {}
    if os.path.exists(FIRST):
        with open(FIRST, encoding="utf-8") as file:
            first = json.load(file)
    for name in api.structs:
        if name in GROWS:
            first.setdefault(name, [f["name"] for f in api.structs[name]["fields"]])
    files = {
        FIRST: "{\n" + ",\n".join(f"  {json.dumps(k)}: {json.dumps(v)}" for k, v in sorted(first.items())) + "\n}\n",
        os.path.join(HERE, "src", "types.inc.hpp"): glue_types(api, first),
        HEADER: header(api),
        os.path.join(HERE, "src", "layouts.cpp"): layouts(api, first),
        **{os.path.join(HERE, "src", area + ".cpp"): source(api, area) for area in AREAS},
        os.path.join(TESTS, "refusals.c"): refusals(api),
        **defaults_tests(api),
    }
    return api, names, files


def main():
    if sys.argv[1:] not in ([], ["--check"], ["--names"]):
        print(__doc__)
        sys.exit(0 if sys.argv[1:] == ["--help"] else 2)
    api, names, files = make()
    if sys.argv[1:] == ["--names"]:
        print("\n".join(sorted(names)))
        return
    if sys.argv[1:] == ["--check"]:
        for path, text in files.items():
            with open(path, encoding="utf-8") as file:
                if file.read() != text:
                    sys.exit(f"{os.path.relpath(path)} is not up to date: run bindings/c/generate.py")
        with open(HEADER, encoding="utf-8") as file:
            text = file.read()
        for name in names:
            if not re.search(r"\b" + name + r"\(", text):
                sys.exit(f"{name} is not in islet.h")
        every = [f for f in api.all["functions"] if f.get("namespace") != "lcp"]
        left = [f for f in every if api.signature(f) in LEFT_OUT]
        print(f"{len(names)} functions for the {len(every)} of C++; {len(left)} have none, for the reasons in LEFT_OUT")
        return
    for path, text in files.items():
        if os.path.exists(path):
            with open(path, encoding="utf-8") as file:
                if file.read() == text:
                    continue
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)


if __name__ == "__main__":
    main()
