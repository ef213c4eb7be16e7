#!/usr/bin/env python3
"""Describes the public headers as JSON: bindings/api.json, from which bindings to other languages are made.

    tools/api/describe.py            writes bindings/api.json
    tools/api/describe.py --check    says whether it is up to date, and lists what is not described

It reads the headers with libclang (Debian: python3-clang-14). The description lists constants, enumerations, structs with their fields, callbacks and
functions, each with its types as C++ spells them, its default and its comment. A field's or constant's unit is what its comment begins with.
"""
import ctypes
import json
import os
import re
import sys

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
HEADERS = os.path.join(ROOT, "engine", "include")
OUT = os.path.join(ROOT, "bindings", "api.json")
UNITS = ("kg m^2", "kg/m^3", "kg/m^2", "1/(kg m^2)", "1/kg", "m/s^2", "m/s", "rad/s", "rad", "N m", "N s", "Hz", "1/s", "kg", "N", "m", "s", "bytes", "radians", "metres")


def load_clang():
    sys.path.append("/usr/lib/python3/dist-packages")  # Debian's, if another Python comes first
    try:
        from clang import cindex
    except ImportError:
        sys.exit("describe.py needs libclang: apt-get install python3-clang-14")
    for name in ("libclang-14.so.1", "libclang-14.so.13", "libclang-14.so", "libclang.so"):
        for folder in ("/usr/lib/llvm-14/lib", "/usr/lib/x86_64-linux-gnu", "/usr/lib/aarch64-linux-gnu"):
            path = os.path.join(folder, name)
            if os.path.exists(path):
                cindex.Config.set_library_file(path)
                return cindex
    return cindex


cindex = load_clang()
Kind = cindex.CursorKind


def comment_of(cursor):
    """The text of a /// or ///< comment, on one line a paragraph."""
    raw = cursor.raw_comment
    if not raw or not raw.lstrip().startswith("///"):
        return ""
    lines = [re.sub(r"^\s*///<?\s?", "", line).rstrip() for line in raw.splitlines()]
    return re.sub(r"\s+", " ", " ".join(lines)).strip()


def unit_of(comment):
    for unit in UNITS:
        if re.match(re.escape(unit) + r"([,;.: (]|$)", comment):
            return {"radians": "rad", "metres": "m"}.get(unit, unit)
    return None


def plain_type(text):
    """A type as C++ spells it, without namespaces and elaborations."""
    text = re.sub(r"\b(islet::detail::|islet::|std::|struct |class |enum )", "", text)
    text = {"unsigned long": "uint64_t", "unsigned int": "uint32_t"}.get(text.strip(), text)
    return text.strip()


def tokens_of(cursor):
    return [t.spelling for t in cursor.get_tokens()]


def initialiser(cursor):
    """The tokens after the = of a field, parameter or constant; None without one."""
    depth, words = 0, tokens_of(cursor)
    for i, word in enumerate(words):
        if word in "([{":
            depth += 1
        elif word in ")]}":
            depth -= 1
        elif word == "=" and depth == 0 and (words[i - 1] in (cursor.spelling, ")", "]")):
            return words[i + 1:]
    return None


def parse_value(words, type_name):
    """A default as JSON: numbers, true, false, null, lists, objects of named members; enumerators and other expressions as text."""
    value, rest = parse_some(words)
    return value if not rest else "".join(words)


def parse_some(words):
    if words[0] == "{":
        words = words[1:]
        items, named = [], {}
        while words[0] != "}":
            if words[0] == ".":
                name = words[1]
                assert words[2] == "="
                named[name], words = parse_some(words[3:])
            else:
                value, words = parse_some(words)
                items.append(value)
            if words[0] == ",":
                words = words[1:]
        return (items if items else named), words[1:]  # {}: the type's own defaults
    if words[0] == "-":
        value, rest = parse_some(words[1:])
        return -value if isinstance(value, (int, float)) else "-" + value, rest
    word, rest = words[0], words[1:]
    if word in ("true", "false"):
        return word == "true", rest
    if word == "nullptr":
        return None, rest
    number = re.fullmatch(r"(0x[0-9a-fA-F]+|[0-9.]+(e[+-]?[0-9]+)?)([fFuU]?)", word)
    if number:
        text = number.group(1)
        if text.startswith("0x"):
            return int(text, 16), rest
        return (int(text) if re.fullmatch("[0-9]+", text) else float(text)), rest
    if word == "~":  # ~std::uint64_t{0}
        return (1 << 64) - 1, []
    while len(rest) >= 2 and rest[0] == "::":
        word, rest = word + "::" + rest[1], rest[2:]
    return word, rest


def evaluated(cursor):
    """A constant's value, worked out by the compiler."""
    lib = cindex.conf.lib
    lib.clang_Cursor_Evaluate.argtypes = [cindex.Cursor]
    lib.clang_Cursor_Evaluate.restype = ctypes.c_void_p
    for name, result in (("Kind", ctypes.c_int), ("AsLongLong", ctypes.c_longlong), ("AsUnsigned", ctypes.c_ulonglong), ("AsDouble", ctypes.c_double), ("AsInt", ctypes.c_int)):
        function = getattr(lib, "clang_EvalResult_get" + name)
        function.argtypes, function.restype = [ctypes.c_void_p], result
    found = lib.clang_Cursor_Evaluate(cursor)
    if not found:
        return None
    kind = lib.clang_EvalResult_getKind(found)
    if kind == 1:
        return lib.clang_EvalResult_getAsLongLong(found)
    if kind == 2:
        return lib.clang_EvalResult_getAsDouble(found)
    return None


def described(cursor, entry):
    comment = comment_of(cursor)
    if comment:
        entry["doc"] = comment
        unit = unit_of(comment)
        if unit:
            entry["unit"] = unit
    return entry


class Reader:
    def __init__(self):
        self.constants, self.enums, self.structs, self.callbacks, self.functions = [], [], [], [], []
        self.aliases, self.left_out = [], []
        self.above = None
        self.last = None  # the function before, and the line it ends on: a comment is for all that follow it without a gap

    def parameters(self, cursor):
        parameters = []
        for child in cursor.get_children():
            if child.kind != Kind.PARM_DECL:
                continue
            parameter = {"name": child.spelling, "type": plain_type(child.type.spelling)}
            words = initialiser(child)
            if words is not None:
                parameter["default"] = parse_value(words, parameter["type"])
            parameters.append(parameter)
        return parameters

    def function(self, cursor, owner, space):
        words = tokens_of(cursor)
        if words[-2:] == ["=", "delete"]:
            return
        name = cursor.spelling
        entry = {"name": name}
        if space:
            entry["namespace"] = space
        if owner:
            entry["class"] = owner
            if cursor.is_static_method():
                entry["static"] = True
            if cursor.is_const_method():
                entry["const"] = True
        if "{" in words and cursor.is_definition():
            entry["inline"] = True
        if cursor.kind == Kind.FUNCTION_TEMPLATE:
            entry["template"] = True
        entry["returns"] = plain_type(cursor.result_type.spelling)
        entry["parameters"] = self.parameters(cursor)
        described(cursor, entry)
        subject = re.sub(r"^(set|is|enable|lock)_|_enabled$", "", name)
        if "doc" not in entry and self.last and self.last[1] == subject and self.last[2] == cursor.extent.start.line - 1:
            entry["doc_with"] = self.last[0]  # of a getter and its setter, and of overloads, the first one is commented
        # Below a commented function, without a gap: its comment may be for this one, too.
        if "doc" in entry:
            self.above = (name, cursor.extent.end.line)
        elif self.above and self.above[1] == cursor.extent.start.line - 1:
            entry["doc_above"] = self.above[0]
            self.above = (self.above[0], cursor.extent.end.line)
        else:
            self.above = None
        self.last = (entry.get("doc_with", name), subject, cursor.extent.end.line) if "doc" in entry or "doc_with" in entry else None
        self.functions.append(entry)

    def struct(self, cursor, space):
        name = cursor.spelling
        fields, inner = [], []
        for child in cursor.get_children():
            if child.kind == Kind.FIELD_DECL and child.access_specifier == cindex.AccessSpecifier.PUBLIC:
                field = {"name": child.spelling, "type": plain_type(child.type.spelling)}
                words = initialiser(child)
                if words is not None:
                    field["default"] = parse_value(words, field["type"])
                elif child.type.kind == cindex.TypeKind.CONSTANTARRAY:
                    pass
                pointer = self.callback_of(child)
                if pointer:
                    field["function"] = pointer
                    field["type"] = "function"
                fields.append(described(child, field))
            elif child.kind in (Kind.CXX_METHOD, Kind.FUNCTION_DECL) and child.access_specifier == cindex.AccessSpecifier.PUBLIC:
                self.function(child, name, space)
            elif child.kind == Kind.CONVERSION_FUNCTION:
                inner.append("bool")
        entry = {"name": name}
        if space:
            entry["namespace"] = space
        if cursor.kind == Kind.CLASS_TEMPLATE:
            entry["template"] = True
        entry["fields"] = fields
        if inner:
            entry["converts_to"] = inner
        self.structs.append(described(cursor, entry))

    def callback_of(self, cursor):
        """What a field, parameter or alias of pointer-to-function type takes and returns."""
        kind = cursor.underlying_typedef_type if cursor.kind in (Kind.TYPE_ALIAS_DECL, Kind.TYPEDEF_DECL) else cursor.type
        if kind.kind != cindex.TypeKind.POINTER or kind.get_pointee().get_canonical().kind != cindex.TypeKind.FUNCTIONPROTO or "(*" not in kind.spelling:
            return None
        pointee = kind.get_pointee()
        names = [c for c in cursor.get_children() if c.kind == Kind.PARM_DECL]
        types = list(pointee.get_canonical().argument_types())
        parameters = []
        for i, one in enumerate(types):
            spelled = names[i].type.spelling if i < len(names) else one.spelling
            parameter = {"name": names[i].spelling if i < len(names) else "", "type": plain_type(spelled)}
            if i < len(names):
                inner = self.callback_of(names[i])
                if inner:
                    parameter["type"], parameter["function"] = "function", inner
            parameters.append(parameter)
        return {"returns": plain_type(pointee.get_canonical().get_result().spelling), "parameters": parameters}

    def read(self, cursor, space=""):
        for child in cursor.get_children():
            file = child.location.file
            if file is None or not os.path.abspath(file.name).startswith(os.path.join(HEADERS, "islet")):
                continue
            if child.kind == Kind.NAMESPACE:
                if child.spelling == "detail":
                    continue
                self.read(child, "" if child.spelling == "islet" and not space else (space + "::" + child.spelling).lstrip(":"))
            elif child.kind == Kind.ENUM_DECL:
                values = [described(v, {"name": v.spelling, "value": v.enum_value}) for v in child.get_children() if v.kind == Kind.ENUM_CONSTANT_DECL]
                entry = {"name": child.spelling, "type": plain_type(child.enum_type.spelling), "values": values}
                if space:
                    entry["namespace"] = space
                self.enums.append(described(child, entry))
            elif child.kind in (Kind.STRUCT_DECL, Kind.CLASS_DECL, Kind.CLASS_TEMPLATE):
                if child.is_definition():
                    self.struct(child, space)
            elif child.kind in (Kind.TYPE_ALIAS_DECL, Kind.TYPEDEF_DECL):
                pointer = self.callback_of(child)
                if pointer:
                    self.callbacks.append(described(child, {"name": child.spelling, **pointer}))
                else:
                    self.aliases.append(described(child, {"name": child.spelling, "type": plain_type(child.underlying_typedef_type.spelling)}))
            elif child.kind == Kind.VAR_DECL:
                entry = {"name": child.spelling, "type": plain_type(re.sub(r"^const ", "", child.type.spelling)), "value": evaluated(child)}
                words = initialiser(child)
                if words:
                    entry["text"] = " ".join(words)
                if space:
                    entry["namespace"] = space
                self.constants.append(described(child, entry))
            elif child.kind in (Kind.FUNCTION_DECL, Kind.FUNCTION_TEMPLATE):
                self.function(child, None, space)
            elif child.kind not in (Kind.STATIC_ASSERT, Kind.UNEXPOSED_DECL, Kind.USING_DECLARATION):  # using std::span
                self.left_out.append(f"{child.kind} {child.spelling}")


def name_members(structs):
    """Gives the members of a default their names, where the header lists values only: C++17 has no names there. (Not where all are alike, as in a vector.)"""
    fields_of = {s["name"]: s["fields"] for s in structs}
    for struct in structs:
        for field in struct["fields"]:
            inner = fields_of.get(field["type"], [])
            if isinstance(field.get("default"), list) and len({f["type"] for f in inner}) > 1:
                field["default"] = {f["name"]: value for f, value in zip(inner, field["default"])}


def describe():
    lines = [f'#include "islet/{name}"' for name in sorted(os.listdir(os.path.join(HEADERS, "islet"))) if name.endswith(".hpp")]
    unit = cindex.Index.create().parse(
        "all.cpp", args=["-std=c++20", "-xc++", "-I" + HEADERS, "-DISLET_MAX_LANES=1"], unsaved_files=[("all.cpp", "\n".join(lines) + "\n")])
    faults = [str(d) for d in unit.diagnostics if d.severity >= 3]
    if faults:
        sys.exit("libclang does not read the headers:\n" + "\n".join(faults))
    reader = Reader()
    reader.read(unit.cursor)
    name_members(reader.structs)
    if reader.left_out:
        sys.exit("declarations of a kind that is not described: " + "; ".join(reader.left_out))
    with open(os.path.join(HEADERS, "islet", "version.hpp"), encoding="utf-8") as file:
        version = re.search(r'ISLET_VERSION_STRING "(.*)"', file.read()).group(1)
    return {
        "note": "Made by tools/api/describe.py from engine/include/islet; do not edit.",
        "version": version,
        "constants": reader.constants,
        "aliases": reader.aliases,
        "enums": reader.enums,
        "callbacks": reader.callbacks,
        "structs": reader.structs,
        "functions": reader.functions,
    }


def as_text(description):
    """A line for each entry, so that a change shows as a change of one line."""
    def line(entry):
        return json.dumps(entry, ensure_ascii=False)
    parts = []
    for key, value in description.items():
        if not isinstance(value, list):
            parts.append(f"{json.dumps(key)}: {line(value)}")
            continue
        rows = []
        for entry in value:
            inner = next((k for k in ("fields", "values") if entry.get(k)), None)
            if inner is None:
                rows.append("  " + line(entry))
                continue
            head = {k: v for k, v in entry.items() if k != inner}
            rows.append("  " + line(head)[:-1] + f", {json.dumps(inner)}: [\n" + ",\n".join("    " + line(one) for one in entry[inner]) + "\n  ]}")
        parts.append(f"{json.dumps(key)}: [\n" + ",\n".join(rows) + "\n]")
    return "{\n" + ",\n".join(parts) + "\n}\n"


def main():
    if sys.argv[1:] not in ([], ["--check"]):
        print(__doc__)
        sys.exit(0 if sys.argv[1:] == ["--help"] else 2)
    text = as_text(describe())
    json.loads(text)
    if sys.argv[1:] == ["--check"]:
        with open(OUT, encoding="utf-8") as file:
            if file.read() != text:
                sys.exit("bindings/api.json is not what the headers say: run tools/api/describe.py, then bindings/c/generate.py")
        print("bindings/api.json is what the headers say")
        return
    with open(OUT, "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    main()
