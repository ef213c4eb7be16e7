#!/usr/bin/env python3
"""Makes the parts of the package @islet/engine that follow from bindings/api.json, in a folder that the build names.

    bindings/js/generate.py FOLDER

calls.js      how each struct lies in the engine's memory, and a method for each function
functions.js  names those of calls.js that need no world
types.d.ts    the types of both, with the comments of the headers
layouts.cpp   checks, when WebAssembly is compiled, that structs lie as calls.js has them
exports.txt   what WebAssembly exports, for the linker

calls.js calls the functions of the C interface (bindings/c) as WebAssembly's C compilers do: a struct is passed by its address, and written to the address
that comes first if it is the result. Names follow C: islet_body_position is world.bodyPosition, islet_world_step is world.step.
"""
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "c"))
import generate as c  # noqa: E402  (the rules by which C is made)

# Written by hand in src/islet.js, or of no use in JavaScript.
BY_HAND = set(
    "islet_create_world islet_world_last_error islet_world_clear_error islet_describe islet_world_save islet_delta islet_apply "
    "islet_world_start_recording islet_world_stop_recording islet_world_set_hooks islet_world_hooks islet_read_snapshot islet_read_recording".split())
AS_THE_REST = {"islet_separation"}  # by hand in C, but not here
UNUSED = {"islet_world_hooks", "islet_world_last_error", "islet_world_clear_error"}  # of BY_HAND: calls throw their errors
# What JavaScript does not have: why.
LEFT_OUT = {
    r"islet_(vec2|rot|transform|aabb)_|islet_(inv_)?transform_point|islet_make_rot|islet_atan2|islet_rot_": "JavaScript programs have a vector library of theirs",
    r"islet_draw_|islet_world_draw|islet_distinct_color": "draw from World.poses and the shapes",
    r"islet_world_(set_)?tasks$": "WebAssembly without threads",
    r"islet_world_set_clock": "World.measureTime sets the browser's",
    r"islet_world_((set_)?error_hook|error_context)$": "World.onError can be replaced at any time",
    r"islet_world_(move_recording|recorded_bytes)|islet_(max_(snapshot|delta)_bytes|world_snapshot_bytes)": "memory grows by itself",
    r"islet_body_export_island|islet_describe_format|islet_format_is_readable": "for tools",
    r"islet_transform_(polygon|proxy)": "for tools",
    r"islet_find_\w+_fault": "takes 4 kB",
    r"islet_create_fleet|islet_fleet_|islet_sense_columns": "fleets are for programs that step worlds on several cores",
    r"islet_(body|shape)_next_": "bodyShapes, bodyJoints, bodyContacts and shapeContacts give lists",
    r"islet_copy_world": "load a snapshot into a larger world",
}
SKIPPED_FIELDS = {"error_hook", "error_context", "tasks", "clock", "clock_context", "context", "poses"}  # set by src/islet.js
HOOKS = {"filter": 0, "pre_solve": 1, "mix_friction": 2, "mix_restitution": 3}  # places in islet_js_callback (src/callbacks.cpp)
CALLBACKS = {"CastVisitor": 5, "OverlapVisitor": 6, "MoverFilter": 7}
SIZES = {"float": 4, "bool": 1, "uint8_t": 1, "uint32_t": 4, "int32_t": 4, "uint64_t": 8, "size_t": 4, "void *": 4, "const char *": 4, "function": 4, "DrawColor": 4}
IDS = {"BodyId", "ShapeId", "JointId"}
VECTORS = {"Vec2": "{x: 0, y: 0}", "Rot": "{c: 1, s: 0}"}  # and what they are where a definition leaves them out
OF_VECTORS = {"Transform", "Aabb"}  # whose parts must all be given
WHOLE_NUMBERS = 2**53 - 1  # the largest that JavaScript counts up to


def camel(name):
    head, *rest = name.split("_")
    return head + "".join(part.capitalize() if not part.isupper() else part for part in rest)


class Js:
    def __init__(self):
        self.api = c.Api()
        for of_fleets in ("Drive", "Sense", "Variation"):
            del self.api.structs[of_fleets]
        self.api.enums = [e for e in self.api.enums if e["name"] not in ("DriveKind", "SenseKind")]
        self.layouts = {}
        for name in self.api.structs:
            self.layout(name)
        left = re.compile("|".join(LEFT_OUT))
        self.functions = []
        for f, name, handmade in self.api.functions():
            if name in BY_HAND or left.match(name):
                continue
            if handmade and name not in AS_THE_REST:
                sys.exit(f"{name} is made by hand in C: name it in BY_HAND or LEFT_OUT of bindings/js/generate.py")
            self.functions.append((f, name))
        names = {}
        for f, name, _ in self.api.functions():
            names.setdefault(f["name"], self.js_name(name))
        self.known = {**{f["name"]: camel(f["name"]) for s in self.api.structs.values() for f in s["fields"]},
                      **{p["name"]: camel(p["name"]) for f in self.api.all["functions"] for p in f["parameters"]},
                      **{v["name"]: camel(v["name"]) for e in self.api.enums for v in e["values"]},
                      **{k["name"]: camel(k["name"]) for k in self.api.constants}, **{k: v for k, v in names.items() if "operator" not in k}}

    # -- where fields lie -------------------------------------------------------------------------------------------------------------

    def size_and_alignment(self, cpp):
        array = re.fullmatch(r"(\w+)\[(\w+)\]", cpp)
        if array:
            size, alignment = self.size_and_alignment(array.group(1))
            return size * self.length(array.group(2)), alignment
        if cpp in self.api.enum_types:
            return 1, 1
        if cpp in self.api.callbacks or cpp in c.GROWS or cpp in self.api.pointers:
            return 4, 4
        if cpp in self.api.structs:
            return self.layout(cpp)[:2]
        return SIZES[cpp], SIZES[cpp]

    def length(self, text):
        return int(text) if text.isdigit() else next(k["value"] for k in self.api.constants if k["name"] == text)

    def layout(self, name):
        """(size, alignment, [(field, offset)])"""
        if name in self.layouts:
            return self.layouts[name]
        place, widest, fields = 0, 1, []
        if name in c.GROWS:
            place, widest = (8 if self.api.has_wide_fields(name) else 4), 4
        for f in self.api.structs[name]["fields"]:
            size, alignment = self.size_and_alignment(f["type"])
            place = -(-place // alignment) * alignment
            fields.append((f, place))
            place += size
            widest = max(widest, alignment)
        self.layouts[name] = (-(-place // widest) * widest, widest, fields)
        return self.layouts[name]

    def room(self, name):
        """Bytes of a struct with those that it points to, which come after it."""
        return -(-self.layout(name)[0] // 8) * 8 + sum(self.room(f["type"]) for f, _ in self.layout(name)[2] if f["type"] in c.GROWS)

    # -- names and comments -----------------------------------------------------------------------------------------------------------

    def js_name(self, c_name):
        return camel(re.sub(r"^islet_(world_(?!bytes))?", "", c_name))

    def doc(self, entry, indent="", more=""):
        if "doc" not in entry and not more:
            return []
        text = entry.get("doc", "") + more

        def member(match):
            owner, name = match.groups()
            return {"islet": ""}.get(owner, owner + ".") + self.known.get(name, camel(name))
        text = re.sub(r"\b(\w+)::(\w+)", member, text)
        text = re.sub(r"\b[a-z]+(?:_[a-z0-9]+)+\b", lambda m: self.known.get(m.group(0), m.group(0)), text).replace("*/", "* /")
        lines = c.wrapped(text.strip(), indent + " * ", 130)
        return [f"{indent}/** {lines[0].strip()[2:]} */"] if len(lines) == 1 else [indent + "/**", *lines, indent + " */"]

    # -- calls.js: structs ------------------------------------------------------------------------------------------------------------

    def put_value(self, cpp, at, value, name=""):
        """A statement that writes a value. `at` is an expression of bytes, and `name` what errors call the value."""
        if cpp == "float":
            return f"F32[{at} >> 2] = {value}"
        if cpp in ("uint32_t", "int32_t", "size_t", "void *", "DrawColor"):
            return f"U32[{at} >> 2] = {value}"
        if cpp == "uint64_t":
            return f"putWide({at}, {value})"
        if cpp == "bool":
            return f"U8[{at}] = {value} ? 1 : 0"
        if cpp in self.api.enum_types:
            return f"U8[{at}] = code({cpp}, {value}, '{cpp}')"
        if cpp in IDS:
            return f"putId({at}, {value})"
        return f"put{cpp}({at}, {value}{f', {name}' if cpp in VECTORS else ''})"

    def get_value(self, cpp, at, old="undefined", name=""):
        if cpp == "float":
            return f"F32[{at} >> 2]"
        if cpp == "int32_t":
            return f"U32[{at} >> 2] | 0"
        if cpp in ("uint32_t", "size_t", "DrawColor"):
            return f"U32[{at} >> 2]"
        if cpp == "uint64_t":
            return f"getWideBits({at})" if name.endswith("hash") else f"getWide({at})"
        if cpp == "bool":
            return f"U8[{at}] !== 0"
        if cpp in self.api.enum_types:
            return f"{'errorName' if cpp == 'Error' else cpp + 'Names.at'}(U8[{at}])" if cpp == "Error" else f"{cpp}[U8[{at}]]"
        if cpp in IDS:
            return f"getId({at})"
        return f"get{cpp}({at}, {old})"

    def literal(self, cpp, value):
        """A default as JavaScript has it."""
        if isinstance(value, str):
            enum, _, name = value.rpartition("::")
            if not enum:
                return str(c.enum_value(self.api, value))
            return f"'{camel(name)}'"
        if isinstance(value, bool):
            return "true" if value else "false"
        return repr(min(value, WHOLE_NUMBERS) if cpp == "uint64_t" else value)

    def default_of(self, struct, field, given):
        """The default of a field of a struct, where the struct itself has the default `given` in another."""
        fields = self.api.structs[struct]["fields"]
        if isinstance(given, list):
            i = fields.index(field)
            if i < len(given):
                return given[i]
        elif isinstance(given, dict) and field["name"] in given:
            return given[field["name"]]
        return field.get("default")

    def put_lines(self, struct, at, value, given, depth):
        """Lines that write a struct; fields that are undefined get their defaults."""
        out = []
        after = -(-self.layout(struct)[0] // 8) * 8
        for f, offset in self.layout(struct)[2]:
            cpp, js = f["type"], f"{value}.{camel(f['name'])}"
            place = f"{at} + {offset}" if offset else at
            array = re.fullmatch(r"(\w+)\[(\w+)\]", cpp)
            if cpp == "JointBase":  # its fields stand among those of the definition
                out += self.put_lines(cpp, place, value, {}, depth)
            elif f["name"] in SKIPPED_FIELDS:
                if f["name"] == "context":
                    out.append(f"U32[{place} >> 2] = context")
                else:
                    out.append(f"U32[{place} >> 2] = 0")
            elif array:
                inner, count = array.group(1), self.length(array.group(2))
                step = self.size_and_alignment(inner)[0]
                put = self.put_value(inner, f"{place} + {step} * i", f"{js}[i]", f"'{camel(f['name'])}', i")
                out.append(f"if ({js} !== undefined) for (let i = 0; i < {count} && i < {js}.length; ++i) {put}")
            elif cpp == "function":
                out.append(f"U32[{place} >> 2] = typeof {js} === 'function' ? callback({HOOKS[f['name']]}) : 0")
            elif cpp in self.api.callbacks:
                out.append(f"U32[{place} >> 2] = typeof {js} === 'function' ? callback({CALLBACKS[cpp]}) : 0")
            elif cpp in c.GROWS:
                out.append(f"U32[{place} >> 2] = {js} === undefined ? 0 : (put{cpp}({at} + {after}, {js}), {at} + {after})")
                after += self.room(cpp)
            elif cpp in self.api.structs and cpp not in IDS:
                default = self.default_of(struct, f, given)
                if struct in OF_VECTORS:
                    out.append(self.put_value(cpp, place, js, f"'{struct}.{camel(f['name'])}'"))
                    continue
                part = "none" if default in (None, {}, []) else self.object(cpp, default)  # of a part with defaults of its own
                out.append(self.put_value(cpp, place, f"{js} ?? {part}", f"'{camel(f['name'])}'"))
            else:
                default = self.default_of(struct, f, given)
                default = 0 if cpp in IDS or default is None else default
                if cpp in self.api.enum_types and default == 0:
                    default = f"{cpp}::{next(e for e in self.api.enums if e['name'] == cpp)['values'][0]['name']}"
                if f["name"] in ("count", "point_count") and any("[" in g["type"] for g in self.api.structs[struct]["fields"]):
                    first = next(g for g in self.api.structs[struct]["fields"] if "[" in g["type"])
                    out.append(self.put_value(cpp, place, f"({js} ?? {value}.{camel(first['name'])}?.length ?? 0)"))
                else:
                    out.append(self.put_value(cpp, place, f"({js} ?? {self.literal(cpp, default)})"))
        return out

    def object(self, struct, given):
        fields = self.api.structs[struct]["fields"]
        parts = []
        for f in fields:
            value = self.default_of(struct, f, given)
            if f["type"] in self.api.structs:
                parts.append(f"{camel(f['name'])}: {self.object(f['type'], value or {})}")
            else:
                parts.append(f"{camel(f['name'])}: {self.literal(f['type'], value)}")
        return "{" + ", ".join(parts) + "}"

    def struct_code(self, name):
        if name in IDS or name in ("DebugDraw", "DrawStyle", "TaskSystem", "RowEnd", "IslandRow", "IslandBody", "FieldFault"):
            return []
        size, _, fields = self.layout(name)
        out = []
        flat = [g for f, _ in fields for g in (self.api.structs["JointBase"]["fields"] if f["type"] == "JointBase" else [f])]
        keys = ", ".join(f"{camel(f['name'])}: 1" for f in flat if f["name"] not in SKIPPED_FIELDS)
        if name in VECTORS:  # in every call
            x, y = ("x", "y") if name == "Vec2" else ("c", "s")
            out += [f"const left_out_{name} = Object.freeze({VECTORS[name]});", f"export function put{name}(p, v, name, index) {{",
                    f"    if (typeof v?.{x} !== 'number' || typeof v.{y} !== 'number') v = leftOut(v, left_out_{name}, name, index);",
                    f"    F32[p >> 2] = v.{x};", f"    F32[p + 4 >> 2] = v.{y};", "}"]
            return out + [f"export function get{name}(p, out = {{{x}: NaN, {y}: NaN}}) {{", f"    out.{x} = F32[p >> 2];", f"    out.{y} = F32[p + 4 >> 2];", "    return out;", "}"]
        out.append(f"const fieldsOf{name} = {{__proto__: null, {keys}}};")
        out.append(f"export function put{name}(p, v) {{")
        out.append(f"    checkFields(v, fieldsOf{name}, '{name}');")
        if name in c.GROWS:
            out.append(f"    U32[p >> 2] = {size};")
            if self.api.has_wide_fields(name):
                out.append("    U32[(p >> 2) + 1] = 0;")
        out += [f"    {line};" for line in self.put_lines(name, "p", "v", {}, 0)] + ["}"]
        if any(f["type"] == "function" or f["type"] in self.api.callbacks for f, _ in fields) or name in ("WorldDef",):
            return out
        if name in c.RESULTS:
            after = -(-size // 8) * 8
            out += [f"/// Readies memory that the engine writes one to.", f"export function expect{name}(p) {{", f"    U32[p >> 2] = {size};"]
            for f, offset in fields:
                if f["type"] in c.GROWS:
                    out += [f"    U32[p + {offset} >> 2] = p + {after};", f"    U32[p + {after} >> 2] = {self.layout(f['type'])[0]};"]
                    after += self.room(f["type"])
            out.append("}")
        # Every object of a struct has the same shape from the start, which engines of JavaScript like.
        out.append(f"export function get{name}(p, out = {{{', '.join(camel(f['name']) + ': ' + self.empty(f['type']) for f, _ in fields)}}}) {{")
        for f, offset in fields:
            cpp, js = f["type"], f"out.{camel(f['name'])}"
            place = f"p + {offset}" if offset else "p"
            array = re.fullmatch(r"(\w+)\[(\w+)\]", cpp)
            if array:
                inner = array.group(1)
                step = self.size_and_alignment(inner)[0]
                counted = next((o for g, o in fields if g["name"] in ("count", "point_count")), None)
                number = f"U32[p + {counted} >> 2]" if counted is not None else str(self.length(array.group(2)))
                out.append(f"    {js} = getArray(p + {offset}, {number}, {step}, {js}, {self.getter(inner)});")
            elif cpp in c.GROWS:
                out.append(f"    {js} = get{cpp}(U32[{place} >> 2], {js});")
            else:
                out.append(f"    {js} = {self.get_value(cpp, place, js, f['name'])};")
        out += ["    return out;", "}"]
        return out

    def empty(self, cpp):
        """What a field holds at first: of its kind, or numbers written to it later would be objects."""
        return "NaN" if cpp == "float" or cpp in IDS else "0" if cpp in ("uint32_t", "int32_t", "size_t") else "false" if cpp == "bool" else "undefined"

    def getter(self, cpp):
        if cpp in IDS:
            return "getId"
        if cpp in ("float", "uint32_t"):
            return f"(p) => {self.get_value(cpp, 'p')}"
        return f"get{cpp}"

    # -- calls.js: functions ----------------------------------------------------------------------------------------------------------

    def function_code(self, f, name):
        api = self.api
        has_world, changes, parameters = c.world_of(f)
        _, extra, kind = c.returns_of(api, f, changes)
        js = self.js_name(name)
        inner = re.sub(r"^const | &$", "", f["returns"])
        place, before, arguments, listed = 0, [], ["this.pointer"] if has_world else [], []
        after, list_of, found_one = [], None, None

        def take(size):
            nonlocal place
            at = f"A + {place}" if place else "A"
            place += -(-size // 8) * 8
            return at

        result_at = None
        span = re.fullmatch(r"span<const (\w+)>", f["returns"])
        if kind == "out":
            result_at = take(self.room(inner))
        elif span:
            result_at = take(8)
        elif inner in api.structs and kind == "value":
            if self.leaves(inner) == 1:
                sys.exit(f"{name}: a struct of one field is passed as that field")
            result_at = take(self.layout(inner)[0])
        if result_at and kind != "out":
            arguments.insert(0, result_at)
        for p in parameters:
            n, cpp = camel(p["name"]), p["type"]
            listed.append(n)
            found = re.fullmatch(r"span<(const )?(\w+)>", cpp)
            reference = re.fullmatch(r"(const )?(\w+) &", cpp)
            if found and found.group(2) == "byte":
                before.append(f"const {n}Place = putBytes({n}, 1);")
                arguments += [f"{n}Place", f"{n}.length"]
            elif found and found.group(1):
                before.append(f"const {n}Place = putArray({n}, {self.size_and_alignment(found.group(2))[0]}, put{found.group(2)}, '{n}');")
                arguments += [f"{n}Place", f"{n}.length"]
            elif found:
                listed.pop()
                list_of = found.group(2)
                arguments += ["ROOM.at", "ROOM.count"]
            elif reference:
                struct = reference.group(2)
                at = take(self.room(struct))
                if c.has_default(p):
                    before.append(f"if ({n} !== undefined) put{struct}({at}, {n});")
                    arguments.append(f"{n} === undefined ? 0 : {at}")
                else:
                    arguments.append(at)
                    if self.is_found(f, p):
                        found_one = f"return result === 0 ? undefined : get{struct}({at}, {n});"
                        continue
                    before.append(f"put{struct}({at}, {n});")
                    if not reference.group(1):
                        after.append(f"get{struct}({at}, {n});")
            elif cpp in api.callbacks:
                before.append(f"visitors.push({n});")
                after.append("visitors.pop();")
                arguments.append(f"callback({CALLBACKS[cpp]})")
            elif cpp == "void *":
                listed.pop()
                arguments.append("0")
            elif cpp in api.structs:
                at = take(self.layout(cpp)[0])
                before.append(self.put_value(cpp, at, n, f"'{n}'") + ";")
                arguments.append(at)
            elif cpp in api.enum_types:
                arguments.append(f"code({cpp}, {n}, '{cpp}')")
            elif cpp == "uint64_t":
                arguments.append(f"wide({n})")
            elif cpp == "bool":
                arguments.append(f"{n} ? 1 : 0")
            else:
                arguments.append(n)
        if kind == "out":
            before.append(f"U32[{result_at} >> 2] = {self.layout(inner)[0]};")
            if api.has_wide_fields(inner):
                before.append(f"U32[({result_at} >> 2) + 1] = 0;")
            arguments.append(result_at)
        if place > 2000:
            sys.exit(f"{name}: too much for a frame of arguments")
        # Definitions may be left out; what a function fills in may be given, so that nothing new is made.
        optional = {p["name"]: "{}" for p in parameters if re.fullmatch(r"const (\w+) &", p["type"]) and p["type"][6:-2] in c.GROWS and not c.has_default(p)}
        optional.update({p["name"]: self.literal(p["type"], p["default"]) for p in parameters if self.has_plain_default(p)})
        listed = [n + "".join(f" = {value}" for k, value in optional.items() if camel(k) == n) for n in listed]
        call = f"wasm.{name}({', '.join(arguments)})"
        check = "check();"
        out = []
        gets = result_at and not span and inner not in IDS
        if gets:
            listed.append("out")
        body = list(before)
        if span:
            size = self.size_and_alignment(span.group(1))[0]
            return [f"    {js}() {{", f"        {call};", "        check();",
                    f"        return listOf(this, '{js}', U32[A >> 2], U32[(A >> 2) + 1], {size}, {self.getter(span.group(1))});", "    }"], js
        if list_of:
            size = self.size_and_alignment(list_of)[0]
            once = call.replace("ROOM.at", "room.at").replace("ROOM.count", f"room.bytes / {size} >>> 0")
            if changes:  # called once, with room enough
                many = next(camel(p["name"]) for p in parameters if p["type"].startswith("span<const"))
                body = [f"reserve({size} * {many}.length);"] + before + [f"const count = {once};", check, f"return getArray(room.at, count, {size}, undefined, {self.getter(list_of)});"]
            else:
                body = [f"reserve({size} * 64);"] + before
                body += [f"let count = {once};", check, f"if (count * {size} > room.bytes) {{", f"    reserve(count * {size});", f"    count = {once};", "}",
                     f"return getArray(room.at, count, {size}, undefined, {self.getter(list_of)});"]
        elif kind in ("void", "code", "error"):
            body += [call + ";"] + after + [check]
        elif kind == "pointer":
            inner = re.fullmatch(r"const (\w+) \*", f["returns"]).group(1)
            listed.append("out")
            body += [f"const at = {call};", check, f"return at === 0 ? undefined : get{inner}(at, out);"]
        elif result_at:
            body += [call + ";"] + after + [check, f"return {self.get_value(inner, result_at, 'out')};"]
        else:
            cpp = f["returns"]
            got = {"bool": "result !== 0", "uint32_t": "result >>> 0", "size_t": "result >>> 0", "const char *": "sentence(result)"}.get(cpp, "result")
            if cpp in api.enum_types:
                got = f"{cpp}[result & 255]"
            if cpp == "uint64_t":
                got = "BigInt.asUintN(64, result)" if name.endswith("hash") else "Number(BigInt.asUintN(64, result))"
            body += [f"const result = {call};"] + after + [check, found_one or f"return {got};"]
        if kind == "out":
            body = [line for line in body if not line.startswith("return")] + [f"return get{inner}({result_at}, out);"]
        if after and any(line.startswith("visitors") for line in after):
            at = body.index(before[[i for i, b in enumerate(before) if b.startswith("visitors")][0]])
            rest = [line for line in body[at + 1:] if line != "visitors.pop();"]
            body = body[: at + 1] + ["try {"] + ["    " + line for line in rest] + ["} finally {", "    visitors.pop();", "}"]
        if js == "stepMover":
            body = ["visitors.push(def.collides);", "try {"] + ["    " + line for line in body] + ["} finally {", "    visitors.pop();", "}"]
        head = f"    {js}({', '.join(listed)}) {{" if has_world else f"export function {js}({', '.join(listed)}) {{"
        indent = "        " if has_world else "    "
        if self.needed(f) > 0:
            body.insert(0, f"takes('{js}', {self.needed(f)}, arguments.length);")
        if not has_world:
            body.insert(0, "mustBeLoaded();")
        out = [head] + [indent + line for line in body] + ["    }" if has_world else "}"]
        return out, js

    def is_found(self, f, p):
        """Whether a parameter of C is what a function looks for: here it is the result, or undefined."""
        return f["returns"] == "bool" and f.get("const", False) and re.fullmatch(r"\w+ &", p["type"]) is not None

    def is_taken(self, p):
        """Whether a parameter of C is one in JavaScript: lists that a function fills in are its result."""
        return p["type"] != "void *" and not re.fullmatch(r"span<(?!const )\w+>", p["type"])

    def needed(self, f):
        """How many arguments a function must be called with: up to the last that cannot be left out."""
        left_out = [self.may_be_left_out(p) or self.is_found(f, p) for p in c.world_of(f)[2] if self.is_taken(p)]
        return max((i + 1 for i, may_be in enumerate(left_out) if not may_be), default=0)

    def leaves(self, struct):
        return sum(self.leaves(f["type"]) if f["type"] in self.api.structs else 2 if "[" in f["type"] else 1 for f in self.api.structs[struct]["fields"])

    def calls(self):
        out = ["// Made by bindings/js/generate.py from bindings/api.json: the structs of the engine in its memory, and its functions.",
               "import {A, F32, U32, U8, callback, check, checkFields, code, context, errorName, getArray, getId, getWide, getWideBits, leftOut, listOf,",
               "    mustBeLoaded, none, putArray, putBytes, putId, putWide, reserve, room, sentence, takes, visitors, wasm, wide} from './memory.js';", ""]
        for e in self.api.enums:
            if e["name"] == "Error":
                continue
            out.append(f"export const {e['name']} = Object.freeze([{', '.join(repr(camel(v['name'])) for v in e['values'])}]);")
        out.append("export const errorNames = Object.freeze({" + ", ".join(
            f"{v['value']}: '{camel(v['name'])}'" for e in self.api.enums if e["name"] == "Error" for v in e["values"]) + ", 254: 'nullPointer', 255: 'structSize'});")
        out.append("export const constants = Object.freeze({" + ", ".join(
            f"{camel(k['name'])}: {k['value'] if k['name'] != 'max_capacity' else 1 << 18}" for k in self.api.constants if "namespace" not in k) + "});")
        out.append(f"export const version = '{self.api.all['version']}';")
        out.append("")
        for name in self.api.structs:
            out += self.struct_code(name)
        out += ["", "/// The functions of a world, one for one.", "export class Calls {"]
        free = []
        for f, name in self.functions:
            code, _ = self.function_code(f, name)
            if c.world_of(f)[0]:
                out += code
            else:
                free += code
        world = {f["name"]: offset for f, offset in self.layout("WorldDef")[2]}
        out += ["}", "", f"export const places = {{errorHook: {world['error_hook']}, errorContext: {world['error_context']}}};  // in a WorldDef", ""] + free + [""]
        return "\n".join(out)

    def free_names(self):
        return [self.js_name(name) for f, name in self.functions if not c.world_of(f)[0]]

    # -- types.d.ts -------------------------------------------------------------------------------------------------------------------

    def ts_type(self, cpp, into=False, name=""):
        """`into` the engine: parts may be left out."""
        array = re.fullmatch(r"(\w+)\[(\w+)\]", cpp)
        if array:
            return f"readonly {self.ts_type(array.group(1), into)}[]" if into else f"{self.ts_type(array.group(1))}[]"
        if cpp in ("float", "uint32_t", "int32_t", "size_t", "DrawColor", "uint8_t"):
            return "number"
        if cpp == "uint64_t":
            return "bigint" if name.endswith("hash") else "number"
        if cpp == "bool":
            return "boolean"
        if cpp == "const char *":
            return "string | undefined"
        if cpp == "Error":
            return "ErrorCode"
        if cpp in self.api.structs and into and cpp not in IDS and cpp not in c.GROWS and not self.is_whole(cpp):
            return f"Partial<{cpp}>"
        return cpp

    def is_whole(self, struct):
        """A plain value all of whose fields one gives."""
        return struct in ("Vec2", "Rot", "Transform", "Aabb", "Circle", "Capsule", "Segment", "HalfSpace", "ChainSegment", "ShapeProxy", "Polygon", "MoverState")

    def is_given(self, struct):
        """What programs fill in as far as they like."""
        return struct.endswith("Def") or struct in ("Capacity", "Hooks", "MoverInput", "QueryFilter", "JointBase")

    def callback_type(self, function):
        listed = [f"{camel(p['name'])}: {self.ts_type(re.sub(r'^const | &$', '', p['type']))}" for p in function["parameters"] if p["type"] != "void *"]
        return f"({', '.join(listed)}) => {self.ts_type(function['returns']) if function['returns'] != 'void' else 'void'}"

    def types(self):
        out = ["// Made by bindings/js/generate.py from bindings/api.json.", "",
               "/** The number of a body. 0 is none. Ids are never used again; those of objects that are gone throw `staleId`. */", "export type BodyId = number;",
               "/** The number of a shape. 0 is none. */", "export type ShapeId = number;", "/** The number of a joint. 0 is none. */", "export type JointId = number;", ""]
        for e in self.api.enums:
            name = "ErrorCode" if e["name"] == "Error" else e["name"]
            out += self.doc(e, more="".join(f" `{camel(v['name'])}`: {v['doc']};" for v in e["values"] if "doc" in v))
            values = [camel(v["name"]) for v in e["values"]] + (["nullPointer", "structSize", "notLoaded"] if name == "ErrorCode" else [])
            out += [f"export type {name} = {' | '.join(repr(v) for v in values)};", ""]
        out += ["/** Limits and other constants. */", "export declare const constants: {"]
        for k in self.api.constants:
            if "namespace" not in k:
                out += self.doc(k, "    ") + [f"    readonly {camel(k['name'])}: number;"]
        out += ["};", "/** The version of the engine. */", "export declare const version: string;", ""]
        results = set()
        for f, _ in self.functions:
            results.add(re.sub(r"^const | [&*]$|span<const |>", "", f["returns"]))
        for name, s in self.api.structs.items():
            if name in IDS or name in ("DebugDraw", "DrawStyle", "TaskSystem", "RowEnd", "IslandRow", "IslandBody", "FieldFault"):
                continue
            given = self.is_given(name)
            extends = " extends JointBase" if any(f["type"] == "JointBase" for f in s["fields"]) else ""
            out += self.doc(s) + [f"export interface {name}{extends} {{"]
            for f in s["fields"]:
                if f["name"] in SKIPPED_FIELDS or f["type"] == "JointBase":
                    continue
                more = ""
                if given and f.get("default") not in (None, {}, []) and not isinstance(f["default"], (list, dict)):
                    more = ("" if f.get("doc", ".").endswith((".", ")")) else ".") + f" Default: {self.literal(f['type'], f['default'])}."
                if f["type"] == "function":
                    cpp = self.callback_type(f["function"])
                elif f["type"] in self.api.callbacks:
                    cpp = self.callback_type(self.api.callbacks[f["type"]])
                else:
                    cpp = self.ts_type(f["type"], given, f["name"])
                    if not given and self.is_given(cpp):
                        cpp = f"Required<{cpp}>"
                out += self.doc(f, "    ", more) + [f"    {camel(f['name'])}{'?' if given else ''}: {cpp};"]
            out += ["}", ""]
        out += ["/** Events of a step. Iterating makes no objects: each turn fills in the same one, so copy what you keep. Valid until the next step. */",
                "export interface EventList<T> extends Iterable<T> {", "    readonly length: number;", "    /** The event at a place, in `out` if given. */",
                "    at(index: number, out?: T): T;", "}", "", "/** The functions of the engine, one for one. */", "export declare class Calls {"]
        free = []
        for f, name in self.functions:
            has_world, changes, parameters = c.world_of(f)
            _, extra, kind = c.returns_of(self.api, f, changes)
            listed, list_of, found_one = [], None, None
            for p in parameters:
                cpp = p["type"]
                span = re.fullmatch(r"span<(const )?(\w+)>", cpp)
                if span and not span.group(1):
                    list_of = span.group(2)
                    continue
                if cpp == "void *":
                    continue
                if self.is_found(f, p):
                    found_one = cpp[:-2]
                    listed.append(f"{camel(p['name'])}?: {found_one}")
                    continue
                if span and span.group(2) == "byte":
                    kind_of = "Uint8Array"
                elif span:
                    kind_of = f"readonly {self.ts_type(span.group(2))}[]"
                elif cpp in self.api.callbacks:
                    kind_of = self.callback_type(self.api.callbacks[cpp])
                else:
                    kind_of = self.ts_type(re.sub(r"^const | &$", "", cpp), cpp.startswith("const") or cpp in self.api.structs)
                if self.may_be_left_out(p):
                    listed.append(f"{camel(p['name'])}?: {kind_of}" if len(listed) >= self.needed(f) else f"{camel(p['name'])}: {kind_of} | undefined")
                else:
                    listed.append(f"{camel(p['name'])}: {kind_of}")
            inner = re.sub(r"^const | [&*]$", "", f["returns"])
            span = re.fullmatch(r"span<const (\w+)>", f["returns"])
            if span:
                result = f"EventList<{span.group(1)}>"
            elif list_of:
                result = f"{list_of}[]"
            elif found_one:
                result = f"{found_one} | undefined"
            elif kind in ("void", "code", "error"):
                result = "void"
            else:
                result = self.ts_type(inner if kind == "pointer" else f["returns"] if f["returns"] == "const char *" else inner, name=name)
                if kind == "pointer":
                    result += " | undefined"
                if self.is_given(inner):
                    result = f"Required<{result}>"
                if inner in self.api.structs and inner not in IDS:
                    listed.append(f"out?: {'Required<' + inner + '>' if self.is_given(inner) else inner}")
            line = f"{self.js_name(name)}({', '.join(listed)}): {result};"
            if has_world:
                out += self.doc(f, "    ") + ["    " + line]
            else:
                free += self.doc(f) + ["export declare function " + line]
        return "\n".join(out + ["}", ""] + free + [""])

    def has_plain_default(self, p):
        """Whether a number, a flag or an enumerator has a default."""
        return "default" in p and (p["type"] in ("float", "bool", "uint32_t", "int32_t", "uint64_t") or p["type"] in self.api.enum_types)

    def may_be_left_out(self, p):
        match = re.fullmatch(r"const (\w+) &", p["type"])
        return self.has_plain_default(p) or (bool(match) and (c.has_default(p) or match.group(1) in c.GROWS))

    # -- what WebAssembly is made with ------------------------------------------------------------------------------------------------

    def layouts_cpp(self):
        out = ["// Made by bindings/js/generate.py: structs lie in memory as calls.js has them.", "#include <stddef.h>", "#include <islet/islet.h>", ""]
        for name in self.api.structs:
            size, _, fields = self.layout(name)
            out.append(f"static_assert(sizeof(Islet{name}) == {size});")
            out += [f"static_assert(offsetof(Islet{name}, {f['name']}) == {offset});" for f, offset in fields]
        return "\n".join(out + [""])

    def exports(self):
        return "\n".join([name for _, name in self.functions] + sorted(BY_HAND - UNUSED) + [
            "islet_world_recorded_bytes", "islet_world_snapshot_bytes", "islet_max_delta_bytes", "islet_world_set_clock", "islet_world_move_recording",
            "islet_js_callback", "islet_js_poses", "malloc", "free"]) + "\n"


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        print(__doc__)
        sys.exit(0 if sys.argv[1:] == ["--help"] else 2)
    js = Js()
    os.makedirs(sys.argv[1], exist_ok=True)
    for name, text in (("calls.js", js.calls()), ("types.d.ts", js.types()), ("functions.js", "// Made by bindings/js/generate.py.\nexport {" + ", ".join(js.free_names()) + "} from './calls.js';\n"), ("layouts.cpp", js.layouts_cpp()), ("exports.txt", js.exports())):
        with open(os.path.join(sys.argv[1], name), "w", encoding="utf-8") as file:
            file.write(text)


if __name__ == "__main__":
    main()
