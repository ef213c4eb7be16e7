#!/usr/bin/env python3
"""api_comments_test.py API: the comments of the public headers, as bindings/api.json has them, say what a user must know.

- Comment: each function has one. Functions of a class may share that of the function above them without a gap; free functions have their own. Operators
  need none.
- Unit: each number that a struct holds, and each one that a function takes or returns, has a unit (vectors of free functions have that of Vec2), a range,
  or a word that says that it has none (a coefficient, a ratio, a unit vector, how many). The comment may be that of the struct, of the function above
  without a gap, or name the field of a definition that has it.
- Default: each field of a definition has one.
- Error: each function of a world that may fail for another reason than those that the class's comment lists names its errors. Of fleets and of free
  functions, each that reports an error names one, or the function or the field that does. Each that takes spans, or whatever a fleet takes, and reports no
  error says what it returns for what it can not use.
"""
import json
import re
import sys

UNIT = re.compile(
    r"(?<![\w])(m|s|kg|N|Hz|rad|m/s|rad/s|m/s\^2|1/s|N s|N m|kg m\^2|kg/m\^2|kg/m\^3|1/kg|1/\(kg m\^2\)|bytes|ticks|pixels|seconds|metres|radians|newtons|units|width)(?![\w])|\b(in|of) (its|the|their|one|any)( \w+){0,3} units?\b")
NONE = re.compile(r">=? ?0|0 to|-1 to|unit\b|ratio|coefficient|fraction|share|factor|scale|multiple|largest of both|relative|times|how many|cosine|residual|normal", re.I)
FIELD = re.compile(r"\b[A-Z]\w+::[a-z]\w+")
REFUSAL = re.compile(r"\b(0|nothing|null|infinite|no)\b[^.]*\b(if|unless|for|errors)\b|has no errors|as much as there is room|as for", re.I)
NUMBERS = ("float", "Vec2", "Vec2[8]", "double")
PLAIN = {"Vec2", "Rot"}  # numbers without a meaning of their own


def says_unit(text):
    return bool(UNIT.search(text) or NONE.search(text) or FIELD.search(text))


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        api = json.load(file)
    errors = {v["name"] for e in api["enums"] if e["name"] == "Error" for v in e["values"]} - {"none"}
    names_error = re.compile(r"\b(" + "|".join(errors) + r")\b")
    statuses = [v["name"] for e in api["enums"] if e["name"] == "Status" for v in e["values"]]
    names_status = re.compile(r"\b(" + "|".join(name for name in statuses if "_" in name) + r"|unsupported)\b")
    complaints = []
    counts = {"comment": 0, "unit": 0, "default": 0, "error": 0}
    structs = {s["name"]: s for s in api["structs"] if s.get("namespace") != "lcp"}

    for name, struct in structs.items():
        for field in struct["fields"]:
            if field["type"] in NUMBERS and name not in PLAIN:
                counts["unit"] += 1
                if not says_unit(field.get("doc", "") or struct.get("doc", "")):
                    complaints.append(f"{name}::{field['name']}: which unit has it, or is it without one?")
            if name.endswith("Def"):
                counts["default"] += 1
                if "default" not in field:
                    complaints.append(f"{name}::{field['name']}: it has no default")

    world = structs["World"]["doc"]
    for error in ("null_id", "stale_id", "not_finite", "out_of_range", "in_step", "feature_cut"):
        if error not in world:
            complaints.append(f"World: its comment does not say when any function fails with {error}")
    documented = {}
    for f in api["functions"]:
        if "doc" in f:
            documented.setdefault((f.get("class"), f["name"]), f["doc"])
    for f in api["functions"]:
        owner = f.get("class")
        named = f"{owner + '::' if owner else ''}{f['name']}({', '.join(p['type'] for p in f['parameters'])})"
        if f["name"].startswith("operator"):
            continue
        shared = f.get("doc_with") or (owner and f.get("doc_above"))
        doc = f.get("doc") or documented.get((owner, shared), "")
        counts["comment"] += 1
        if not doc:
            complaints.append(f"{named}: it has no comment")
            continue
        asked = NUMBERS if owner else ("float", "double")
        numbers = [p for p in f["parameters"] if p["type"] in asked] + ([f] if f["returns"] in asked else [])
        if numbers:
            counts["unit"] += 1
            if not says_unit(doc):
                complaints.append(f"{named}: which units, or none?")
        if owner != "World":
            result = structs.get(f["returns"], {"fields": []})
            reports = (f["returns"] in ("Error", "Result<T>") or any(p["type"] == "Error *" for p in f["parameters"]) or f["name"] == "create"
                       or (f["returns"] == "bool" and any(p["type"] == "World &" for p in f["parameters"])))
            fields = [field.get("doc", "") for field in result["fields"] if field["type"] == "Error"]
            other = re.search(r"\b(?:as in|same for) (\w+)", doc)
            texts = [doc] + fields + ([documented.get((owner, other.group(1)), "")] if other else [])
            takes = [p["type"] for p in f["parameters"]]
            if reports or fields:
                counts["error"] += 1
                if not any(names_error.search(text) or names_status.search(text) for text in texts):
                    complaints.append(f"{named}: which errors are there?")
            elif any(t.startswith("span<") for t in takes) or (owner == "Fleet" and takes):
                counts["error"] += 1
                if not REFUSAL.search(doc):
                    complaints.append(f"{named}: what does it return for what it can not use?")
            continue
        # Ids, numbers and definitions fail as the class's comment says. Memory, and what a call returns instead of an error, needs words of its own.
        own = any(p["type"].startswith("span<") and "char" not in p["type"] for p in f["parameters"]) or (not f.get("const") and f["returns"] == "bool")
        if own and not f.get("const") or f["name"].startswith("create_"):
            counts["error"] += 1
            if not names_error.search(doc):
                complaints.append(f"{named}: which errors are there?")
    print("\n".join(complaints))
    print(f"{counts['comment']} comments, {counts['unit']} units, {counts['default']} defaults and {counts['error']} lists of errors looked for, {len(complaints)} missing")
    least = {"comment": 300, "unit": 280, "default": 140, "error": 55}
    short = [what for what, count in counts.items() if count < least[what]]
    if short:
        print("there should be more to look at: " + ", ".join(short))
    sys.exit(1 if complaints or short else 0)


if __name__ == "__main__":
    main()
