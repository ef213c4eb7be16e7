#!/usr/bin/env python3
"""Makes the parts of the Python package that follow from bindings/api.json, in a folder that the build names.

    bindings/python/generate.py FOLDER

records.inc    the fields of each struct, and the names of each enumeration
records_N.cpp  a class for each struct
world_N.cpp    a method of World for each function that needs no rule of its own
__init__.pyi   the types of all of it, with the comments of the headers; src/by_hand.pyi has what is written by hand
"""
import json
import os
import re
import sys
import textwrap

HERE = os.path.dirname(os.path.abspath(__file__))
API = os.path.join(HERE, "..", "api.json")

# What Python has of its own, or has no use for: structs with functions, pictures, exports for solvers.
NOT_STRUCTS = set("Vec2 Rot Transform Aabb DrawStyle DebugDraw TaskSystem Hooks World StaticWorldOf StaticWorld Fleet FleetStep FormatInfo IdHash "
                  "FieldFault RowEnd IslandRow IslandBody IslandProblem StepProfile".split())
NOT_ENUMS = set("DrawPart BodyColors FormatKind RowKind Error".split())
NOT_FIELDS = set("error_hook error_context hooks tasks clock clock_context collides context".split())
# Written by hand in src/, or left out.
BY_HAND = set("create step hash save restore load start_recording stop_recording create_body create_shape create_chain create_joint explode apply_wind "
              "set_solver contact_at overlap_box overlap_point overlap_shape cast_ray_all cast_shape_all surfaces_near contacts shapes joints "
              "sensor_overlaps validate".split())
LEFT_OUT = set("tasks set_tasks profile set_clock hooks set_hooks last_error clear_error error_hook error_context set_error_hook snapshot_bytes is_recording recorded_bytes move_recording "
               "next_shape next_joint next_contact cast_ray_each cast_shape_each overlap_box_each overlap_shape_each overlap_point_each export_island draw draw_shape".split())
# Functions that stand by themselves.
FREE = set("make_box make_rounded_box make_offset_box transform_polygon compute_mass compute_aabb separation overlaps contains cast_ray cast_shape "
           "world_bytes make_rot angle_of".split())
FILES = 3  # into how many the structs and the methods are split, so that they compile side by side

INTS = set("uint8_t uint32_t int32_t uint64_t size_t DrawColor".split())
POINTS = {"Vec2": "Point", "Rot": "Rotation", "Transform": "Pose", "Aabb": "Box"}


def words(text):
    return text.replace("::", ".").replace("\\", "\\\\").strip()


def c_string(text):
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'


class Api:
    def __init__(self):
        with open(API, encoding="utf-8") as file:
            self.all = json.load(file)
        self.enums = [e for e in self.all["enums"] if "namespace" not in e and e["name"] not in NOT_ENUMS]
        self.every_enum = {e["name"]: e for e in self.all["enums"]}
        self.structs = {s["name"]: s for s in self.all["structs"] if "namespace" not in s and not s.get("template") and s["name"] not in NOT_STRUCTS}
        self.enum_names = {e["name"] for e in self.enums}
        self.constants = {c["name"]: c["value"] for c in self.all["constants"] if "namespace" not in c}

    def fields(self, struct):
        """(name in Python, C++ expression of its place, field): those of a JointBase stand among those of the definition."""
        for f in self.structs[struct]["fields"]:
            if f["name"] in NOT_FIELDS:
                continue
            if f["type"] == "JointBase":
                for inner in self.structs["JointBase"]["fields"]:
                    yield inner["name"], f"{f['name']}.{inner['name']}", inner
            else:
                yield f["name"], f["name"], f

    # -- types in stubs -------------------------------------------------------------------------------------------------------------

    def python_type(self, cpp, takes):
        """The type of a value of C++ that a function takes, or gives."""
        cpp = re.sub(r"^const |( [&*])$", "", cpp).strip()
        if cpp == "void":
            return "None"
        if cpp in ("float", "bool"):
            return cpp
        if cpp in INTS:
            return "int"
        if cpp == "const char *" or cpp == "char":
            return "str"
        if cpp in POINTS:
            return POINTS[cpp] if takes else cpp
        if cpp == "Error":
            return "ErrorCode | str" if takes else "ErrorCode"
        if cpp in self.enum_names:
            return f"{cpp} | str" if takes else cpp
        array = re.fullmatch(r"(\w+)\[\w+\]", cpp)
        if array:
            inner = self.python_type(array.group(1), takes)
            return f"Sequence[{inner}]" if takes else f"tuple[{inner}, ...]"
        span = re.fullmatch(r"span<(?:const )?(\w+)>", cpp)
        if span:
            return f"list[{self.python_type(span.group(1), False)}]"
        if cpp == "ShapeProxy" and takes:
            return "ShapeProxy | Circle | Capsule | Segment | Polygon"
        if cpp in self.structs:
            return f"{cpp} | Mapping[str, Any] | Sequence[Any]" if takes and not cpp.endswith("Id") else cpp
        raise KeyError(f"no type in Python for {cpp}")

    # -- records ----------------------------------------------------------------------------------------------------------------------

    def records_inc(self):
        out = []
        for e in self.enums + [self.every_enum["Error"]]:
            names = ", ".join(c_string(v["name"]) for v in e["values"])
            out.append(f"template <>\ninline const EnumInfo& enum_of<{e['name']}>() {{\n    static const char* const names[] = {{{names}}};\n"
                       f"    static EnumInfo info = {{{c_string('ErrorCode' if e['name'] == 'Error' else e['name'])}, names, {len(e['values'])}, {{}}, {{}}}};\n    return info;\n}}")
        for name in self.structs:
            out.append(f"template <>\nconst RecordInfo& record_of<{name}>();")
        return "\n".join(out) + "\n"

    def casters_inc(self):
        out = [f"template <>\nstruct type_caster<islet::{e['name']}> : islet::python::EnumCaster<islet::{e['name']}> {{}};" for e in self.enums]
        out.append("template <>\nstruct type_caster<islet::Error> : islet::python::EnumCaster<islet::Error> {};")
        out += [f"template <>\nstruct type_caster<islet::{name}> : islet::python::RecordCaster<islet::{name}> {{}};" for name in self.structs]
        return "\n".join(out) + "\n"

    def records_cpp(self, part):
        out = ['#include "records.hpp"', "", "namespace islet::python {", ""]
        names = list(self.structs)[part::FILES]
        for name in names:
            s = self.structs[name]
            fields = [f"        {{{c_string(py)}, offsetof({name}, {place}), &kind_of<decltype({name}{{}}.{place})>, "
                      f"{c_string(words(f.get('doc', '')))}}}," for py, place, f in self.fields(name)]
            out += ["template <>", f"const RecordInfo& record_of<{name}>() {{", "    static const Field fields[] = {", *fields, "    };",
                    f"    static RecordInfo info = {{{c_string(name)}, {c_string(words(s.get('doc', '')))}, fields, {len(fields)}, {{}}}};", "    return info;", "}", ""]
        out += [f"void add_records_{part}(py::module_& m) {{", *[f"    add_record<{name}>(m);" for name in names], "}", "", "}  // namespace islet::python"]
        return "\n".join(out) + "\n"

    # -- functions --------------------------------------------------------------------------------------------------------------------

    def methods(self):
        return [f for f in self.all["functions"] if f.get("class") == "World" and f["name"] not in BY_HAND | LEFT_OUT and not f.get("static")]

    def free(self):
        return [f for f in self.all["functions"] if "class" not in f and "namespace" not in f and f["name"] in FREE and "span" not in str(f["parameters"])]

    def arguments(self, f):
        out = []
        for p in f["parameters"]:
            value = ""
            if "default" in p:
                value = f" = {p['type'].replace('const ', '').replace(' &', '')}{{}}" if p["default"] == {} else f" = {self.literal(p['default'], p['type'])}"
            out.append(f'py::arg("{p["name"]}"){value}')
        return "".join(", " + a for a in out)

    @staticmethod
    def literal(value, cpp):
        return str(value).lower() if isinstance(value, bool) else f"{float(value)}f" if cpp == "float" else str(value)

    def cast(self, f):
        owner, const = ("World::*", " const") if f.get("class") else ("*", "")
        types = ", ".join(p["type"] for p in f["parameters"])
        const = const if f.get("const") else ""
        name = ("World::" if f.get("class") else "") + f["name"]
        return f"static_cast<{f['returns']} ({owner})({types}){const}>(&{name})"

    def world_cpp(self, part):
        out = ['#include "world.hpp"', "", "namespace islet::python {", "", f"void add_calls_{part}(WorldClass& w, py::module_& m) {{", "    (void)m;"]
        mine = self.methods()[part::FILES]
        out += [f"    w.def({c_string(f['name'])}, checked({self.cast(f)}){self.arguments(f)}, {c_string(words(f.get('doc', '')))});" for f in mine]
        if part == 0:
            out += [f"    m.def({c_string(f['name'])}, {self.cast(f)}{self.arguments(f)}, {c_string(words(f.get('doc', '')))});" for f in self.free()]
        return "\n".join(out + ["}", "", "}  // namespace islet::python"]) + "\n"

    # -- stubs ------------------------------------------------------------------------------------------------------------------------

    def doc(self, text, indent):
        text = words(text)
        if not text:
            return [f"{indent}..."]
        lines = textwrap.wrap(text, 130 - len(indent))
        return [f'{indent}"""{lines[0]}"""'] if len(lines) == 1 else [f'{indent}"""{lines[0]}', *[indent + line for line in lines[1:]], f'{indent}"""']

    def stub_default(self, f):
        value = f.get("default")
        if isinstance(value, bool) or isinstance(value, (int, float)):
            return repr(value)
        if isinstance(value, str) and "::" in value:
            return re.sub(r"^Error\.", "ErrorCode.", value.replace("::", "."))
        return "..."

    def stub_functions(self, functions, indent):
        counts = {}
        for f in functions:
            counts[f["name"]] = counts.get(f["name"], 0) + 1
        out, previous = [], None
        for f in sorted(functions, key=lambda f: [g["name"] for g in functions].index(f["name"])):
            if counts[f["name"]] > 1:
                out.append(f"{indent}@overload")
            parameters = ["self"] if indent else []
            for p in f["parameters"]:
                parameters.append(f"{p['name']}: {self.python_type(p['type'], True)}" + (" = ..." if "default" in p else ""))
            gives = self.python_type(f["returns"], False) + (" | None" if f["returns"].endswith("*") or f["returns"] in ("QueryHit", "ClosestHit") else "")
            out.append(f"{indent}def {f['name']}({', '.join(parameters)}) -> {gives}:")
            out += self.doc(f.get("doc", "" if f["name"] != previous else ""), indent + "    ")
            previous = f["name"]
        return out

    def stub_record(self, name):
        out = [f"class {name}:", *[line for line in self.doc(self.structs[name].get("doc", ""), "    ") if line.strip() != "..."]]
        fields = list(self.fields(name))
        is_id = name.endswith("Id")
        out.append("    def __init__(" + ", ".join(["self", *[f"{py}: {self.python_type(f['type'], True)} = {self.stub_default(f)}" for py, _, f in fields]]) + ") -> None: ...")
        for py, _, f in fields:
            out.append("    @property")
            out.append(f"    def {py}(self) -> {self.python_type(f['type'], False)}:")
            out += self.doc(f.get("doc", ""), "        ")
            if not is_id:
                out += [f"    @{py}.setter", f"    def {py}(self, value: {self.python_type(f['type'], True)}) -> None: ..."]
        if is_id:
            out += ["    @property", "    def slot(self) -> int:", '        """Row of the object in World.poses and World.velocities: index1 - 1."""',
                    "    def __hash__(self) -> int: ...", f"    def __lt__(self, other: {name}) -> bool: ...", "    def __bool__(self) -> bool: ..."]
        return out

    def stub_enum(self, e, name):
        out = [f"class {name}(enum.IntEnum):"]
        if "doc" in e:
            out += self.doc(e["doc"], "    ")
        for v in e["values"]:
            out.append(f"    {v['name']} = {v['value']}")
            if "doc" in v:
                out += self.doc(v["doc"], "    ")
        return out

    def options(self, struct):
        """The fields of a definition as keywords of a call."""
        return ", ".join(f"{py}: {self.python_type(f['type'], True)} = {self.stub_default(f)}" for py, _, f in self.fields(struct))

    def stub(self):
        with open(os.path.join(HERE, "src", "by_hand.pyi"), encoding="utf-8") as file:
            text = file.read()
        # The fields of a definition become keywords of the function.
        text = re.sub(r"(\*, [^()]*)?\*\*options: (\w+)", lambda m: (m.group(1) or "*, ") + self.options(m.group(2)), text)
        types = [self.stub_enum(e, e["name"]) for e in self.enums] + [self.stub_enum(self.every_enum["Error"], "ErrorCode")]
        types += [self.stub_record(name) for name in self.structs]
        text = text.replace("# TYPES\n", "\n\n".join("\n".join(t) for t in types) + "\n")
        text = text.replace("    # METHODS\n", "\n".join(self.stub_functions(self.methods(), "    ")) + "\n")
        return text.replace("# FUNCTIONS\n", "\n".join(self.stub_functions(self.free(), "")) + "\n")


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__.strip())
    api, folder = Api(), sys.argv[1]
    os.makedirs(folder, exist_ok=True)
    files = {"records.inc": api.records_inc(), "casters.inc": api.casters_inc(), "__init__.pyi": api.stub()}
    for part in range(FILES):
        files[f"records_{part}.cpp"] = api.records_cpp(part)
        files[f"world_{part}.cpp"] = api.world_cpp(part)
    for name, text in files.items():
        path = os.path.join(folder, name)
        if os.path.exists(path):
            with open(path, encoding="utf-8") as file:
                if file.read() == text:
                    continue
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)


if __name__ == "__main__":
    main()
