#!/usr/bin/env python3
"""make_c_calls.py OUT: writes a call of each function of the C interface, with arguments out of a fuzzer's input, for c_fuzz.c to include.

Every struct is filled with what an input says: good values and bad ones, now and then a wrong size; and now and then a pointer is null. So a new function is
fuzzed from the moment that bindings/api.json has it.
"""
import json
import os
import re
import sys

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bindings", "c"))
sys.dont_write_bytecode = True

from generate import BY_VALUE, GROWS, Api, defaulted, returns_of, snake, world_of  # noqa: E402


def fuzz_calls(api):
    """Fills every struct, and calls every function, with what an input says: good values and bad ones, null pointers, wrong sizes."""
    out = ["// Made by tests/fuzz/make_c_calls.py for c_fuzz.c."]
    stubs = {}

    def stub(function):
        """The name of a function of this type that does nothing."""
        parameters = [p["function"] if p["type"] == "function" else p["type"] for p in function["parameters"]]
        key = json.dumps([function["returns"], parameters], sort_keys=True)
        if key not in stubs:
            stubs[key] = f"stub{len(stubs)}"
            declared = re.sub(r"^(.*)\(\*(\w+)\)", r"\1\2", api.pointer(stubs[key], function))
            names = re.findall(r"(\w+)(?=,|\)$)", re.sub(r"\(\*(\w+)\)\([^)]*\)", r"\1", declared))
            nothing = "" if function["returns"] == "void" else "    return 0;"
            out.extend([f"static {declared} {{", *[f"    (void){n};" for n in names], nothing, "}"])
        return stubs[key]

    def value(cpp):
        if cpp in api.enum_types or cpp == "uint8_t":
            return "take_byte(in)"
        return {"float": "take_float(in)", "bool": "take_flag(in)", "size_t": "take_count(in)", "uint64_t": "take_count(in)", "int32_t": "(int32_t)take_count(in)",
                "uint32_t": "take_count(in)", "DrawColor": "take_count(in)", "void *": "NULL", "BodyId": "take_body(in)", "ShapeId": "take_shape(in)",
                "JointId": "take_joint(in)"}[cpp]

    done = set()

    def fill(name):
        if name in done or name in ("BodyId", "ShapeId", "JointId"):
            return
        done.add(name)
        lines = [f"static void fill_{snake(name)}(Input* in, Islet{name}* s) {{"]
        if name == "Polygon":  # random corners are hardly ever convex
            lines += ["    if (take_byte(in) != 0) {", "        *s = islet_make_box(take_float(in), take_float(in));", "        return;", "    }"]
        lines.append(f"    *s = islet_default_{snake(name)}();" if name in defaulted(api) else "    memset(s, 0, sizeof *s);")
        for f in api.structs[name]["fields"]:
            n, cpp = f["name"], f["type"]
            array = re.fullmatch(r"(\w+)\[(\w+)\]", cpp)
            inner = array.group(1) if array else cpp
            place = f"s->{n}[i]" if array else f"s->{n}"
            if cpp == "function" or cpp in api.callbacks:
                pointer = f["function"] if cpp == "function" else api.callbacks[cpp]
                made = f"s->{n} = {'run_tasks' if n == 'parallel_for' else stub(pointer)};"
            elif cpp in GROWS or cpp in api.pointers or cpp == "const char *":
                continue
            elif inner in api.structs and inner not in ("BodyId", "ShapeId", "JointId"):
                fill(inner)
                made = f"fill_{snake(inner)}(in, &{place});"
            else:
                made = f"{place} = {value(inner)};"
            lines.append(f"    if (take_flag(in)) {made}" if not array else f"    for (int i = 0; i < {array.group(2)}; ++i) {made}")
        if name in GROWS:
            lines.append("    if (take_byte(in) == 0) s->struct_size = take_count(in);")
        out.extend(lines + ["}"])

    for name in ("Drive", "Sense", "Variation"):  # of fleets, which c_fuzz.c calls
        fill(name)
    bodies, names = [], []
    for f, name, _ in api.functions():
        if name in ("islet_create_world", "islet_copy_world", "islet_body_export_island", "islet_separation", "islet_format_is_readable", "islet_world_set_tasks"):
            continue  # in c_fuzz.c
        if f.get("class") == "Fleet":
            continue  # there too
        has_world, changes, parameters = world_of(f)
        result, extra, kind = returns_of(api, f, changes)
        if extra:
            parameters = parameters + [{"name": "out", "type": re.sub(r"^const | &$", "", f["returns"]) + " &"}]
        before, arguments = [], ["world"] if has_world else []
        for k, p in enumerate(parameters):
            n, cpp = p["name"], p["type"]
            span = re.fullmatch(r"span<(const )?(\w+)>", cpp)
            reference = re.fullmatch(r"(const )?(\w+) ([&*])", cpp)
            if span and span.group(2) in ("byte", "char"):
                area = "tape(in)" if "recording" in name and not span.group(1) else f"areas[{k % 4}]"
                before.append(f"    const size_t {n}_bytes = take_count(in) % (sizeof areas[0] + 1);")
                arguments += [f"take_byte(in) == 0 ? NULL : (void*){area}", f"{n}_bytes"]
            elif span:
                inner = span.group(2)
                before.append(f"    static Islet{inner} {n}[16];")
                if span.group(1):
                    fill(inner)
                    before.append(f"    const size_t {n}_count = take_count(in) % 17;")
                    before.append(f"    for (size_t i = 0; i < {n}_count; ++i) fill_{snake(inner)}(in, &{n}[i]);")
                else:
                    before.append(f"    const size_t {n}_count = take_count(in) % 17;")
                arguments += [f"take_byte(in) == 0 ? NULL : {n}", f"{n}_count"]
            elif reference and reference.group(2) == "Error":
                before.append(f"    IsletError {n} = 0;")
                arguments.append(f"&{n}")
            elif reference and reference.group(2) in api.structs:
                inner = reference.group(2)
                fill(inner)
                before += [f"    Islet{inner} {n};", f"    fill_{snake(inner)}(in, &{n});"]
                arguments.append(n if reference.group(1) and inner in BY_VALUE else f"take_byte(in) == 0 ? NULL : &{n}")
            elif cpp in api.callbacks:
                arguments.append(f"take_flag(in) ? {stub(api.callbacks[cpp])} : NULL")
            elif cpp in api.structs and cpp not in ("BodyId", "ShapeId", "JointId"):
                fill(cpp)
                before += [f"    Islet{cpp} {n};", f"    fill_{snake(cpp)}(in, &{n});"]
                arguments.append(n)
            elif cpp == "Error":
                arguments.append("take_byte(in)")
            else:
                before.append(f"    const {api.c_type(cpp)} {n} = {value(cpp)};" if cpp != "void *" else f"    void* {n} = NULL;")
                arguments.append(n)
        call = f"{name}({', '.join(arguments)})"
        after = {"BodyId": f"keep_body({call});", "ShapeId": f"keep_shape({call});", "JointId": f"keep_joint({call});"}.get(f["returns"])
        if after is None and kind == "span":
            inner = re.fullmatch(r"span<const (\w+)>", f["returns"]).group(1)
            after = f"const Islet{inner}Span seen = {call};\n    look(seen.data, seen.count * sizeof(Islet{inner}));"
        elif after is None and kind == "pointer":
            inner = re.fullmatch(r"const (\w+) \*", f["returns"]).group(1)
            after = f"const Islet{inner}* seen = {call};\n    look(seen, seen != NULL ? sizeof(Islet{inner}) : 0);"
        elif after is None and kind == "code":
            after = f"return {call};"
        elif after is None:
            after = f"(void){call};" if f["returns"] != "void" else f"{call};"
        bodies += [f"static IsletError call_{name[6:]}(Input* in, IsletWorld* world) {{", "    (void)in;", "    (void)world;", *before, "    " + after]
        if not after.startswith("return"):
            bodies.append("    return ISLET_ERROR_NONE;")
        bodies.append("}")
        names.append(f"call_{name[6:]}")
    out += bodies + ["", "typedef IsletError (*Call)(Input* in, IsletWorld* world);", "static const Call calls[] = {", *[f"    {n}," for n in names], "};", ""]
    return "\n".join(line for line in out if line)


if __name__ == "__main__":
    with open(sys.argv[1], "w", encoding="utf-8") as made:
        made.write(fuzz_calls(Api()) + "\n")
