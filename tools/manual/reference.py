"""The reference of the site, in C++, C and JavaScript side by side, from bindings/api.json. Used by pages.py.

The C and JavaScript names are those of the generators that make these interfaces; their signatures are read from what the generators write.
"""
import os
import re
import sys

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))


def module(path):
    import importlib.util
    spec = importlib.util.spec_from_file_location(path.replace("/", "_"), os.path.join(ROOT, path))
    loaded = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(loaded)
    return loaded


js_maker = module("bindings/js/generate.py")
c_maker = js_maker.c
camel, snake = js_maker.camel, c_maker.snake

# Pages in their order: name, title, first sentence, and what stands there (patterns of the C function's name; of the struct's, enumeration's or callback's name).
PAGES = [
    ("world", "World", "Making a world, stepping it, its settings and what a step reports.", None,
     r"Capacity|WorldDef|StaticWorld.*|World$|SolverDef|Schedule|JointTrees|SweepOrder|StepReport|WorldCounters|WindDef|ExplosionDef|Error|ErrorHook|Hooks|PreSolve|TaskSystem|.*Event$|SlotRange"),
    ("bodies", "Bodies", "Making bodies, reading and changing them, forces and impulses.", r"islet_(body_(?!export|residual)|create_body|destroy_body)", r"Body(?!Colors).*|MassData"),
    ("shapes", "Shapes", "Shapes of bodies, their materials and filters, and chains.", r"islet_(shape_|create_(circle|capsule|segment|polygon|chain|half|shape)|destroy_(shape|chain)|chain_)",
     r"Shape(?!Proxy).*|SurfaceMaterial|Filter"),
    ("joints", "Joints", "The ten types of joints, and what one reads and changes of them.", r"islet_(joint_|create_\w+_joint|create_joint|destroy_joint)|islet_body_joints", r"Joint(?!Trees).*|.*JointDef"),
    ("contacts", "Contacts", "The contacts of a world, one by one.", r"islet_world_contact|islet_body_contacts", r"Contact.*"),
    ("queries", "Queries", "Rays, casts, overlaps and closest points, of a world and of single shapes.",
     r"islet_world_(cast|overlap|closest|surfaces)|islet_(cast_|separation|ray_|closest|time_of)|islet_make_\w*proxy|.*_proxy$", r"QueryFilter|QueryHit|ClosestHit|Surface|CastHit|Separation|ShapeProxy|.*Visitor"),
    ("mover", "Character", "The mover of characters.", r"islet_step_mover", r"Mover.*"),
    ("snapshots", "Snapshots and recordings", "Saving, restoring, deltas, recording, replay, and the formats of these files.",
     r".*(snapshot|delta|record|replay|_save$|_restore$|_load$|_format|hash$|validate$|copy_world)|islet_apply$", r"Recording.*|Replay.*|SnapshotInfo|Format.*"),
    ("drawing", "Drawing and profile", "Debug drawing through functions of yours, and the time that the stages of a step take.", r".*(draw|distinct_color|profile|clock)", r"Draw.*|DebugDraw|BodyColors|StepProfile|Clock"),
    ("math", "Math and geometry", "Vectors, rotations, boxes, and shapes as plain values.", r"islet_(?!world_).*", r"Vec2|Rot|Transform|Aabb|Circle|Capsule|Segment|ChainSegment|HalfSpace|Hull|Polygon"),
    ("matrix", "Matrix solvers", "Solvers for complementarity problems, and islands as matrices. In C++ alone, but for the export.", r"islet_body_export_island", r"Island.*|Row.*|.*"),
]


def escape(text):
    """Plain text as Markdown that Vue does not read."""
    parts = re.split(r"(`[^`]*`)", text)
    for i in range(0, len(parts), 2):
        parts[i] = re.sub(r"([\\*_\[\]|#~])", r"\\\1", parts[i]).replace("<", "&lt;").replace("{{", "&#123;{")
    for i in range(1, len(parts), 2):
        parts[i] = parts[i].replace("|", "\\|")
    return "".join(parts)


class Reference:
    def __init__(self):
        self.js = js_maker.Js()
        self.api = self.js.api
        self.all = self.api.all
        self.c_names = {id(f): name for f, name, _ in self.api.functions()}
        self.c_lines = self.read_c()
        self.js_lines = self.read_js()
        self.places = {}  # "World::step", "BodyDef": page and anchor
        self.pages = {name: [] for name, *_ in PAGES}
        self.types = {name: [] for name, *_ in PAGES}
        for kind in ("enums", "callbacks", "structs"):
            for entry in self.all[kind]:
                if entry["name"] in ("IdHash", "StaticWorldOf"):
                    continue
                page = next(name for name, _, _, _, pattern in PAGES if re.fullmatch(pattern, entry["name"]))
                if entry.get("namespace") == "lcp":
                    page = "matrix"
                self.types[page].append((kind, entry))
                self.places[entry["name"]] = (page, entry["name"])  # functions have none with capitals
        for group in self.groups():
            page = self.page_of(group[0])
            self.pages[page].append(group)
        for page, groups in self.pages.items():
            used = {anchor for kind, (p, anchor) in self.places.items() if p == page}
            for group in groups:
                base = anchor = re.sub(r"\W+", "-", group[0]["name"].replace("operator", "operator-" + str(len(used)))).strip("-").replace("_", "-")
                n = 1
                while anchor in used:
                    n += 1
                    anchor = f"{base}-{n}"
                used.add(anchor)
                for f in group:
                    f["anchor"] = anchor
                    owner = f.get("class", f.get("namespace", "islet"))
                    self.places.setdefault(f"{owner}::{f['name']}", (page, anchor))

    # -- what the other interfaces are called -------------------------------------------------------------------------------------------

    def read_c(self):
        with open(os.path.join(ROOT, "bindings/c/include/islet/islet.h"), encoding="utf-8") as file:
            text = file.read()
        found = {}
        for match in re.finditer(r"^ISLET_C_API ([^;]*?\b(islet_\w+)\([^;]*\);)", text, re.M):
            found[match.group(2)] = re.sub(r"\s+", " ", match.group(1))
        return found

    def read_js(self):
        found = {}
        texts = [self.js.types()]
        with open(os.path.join(ROOT, "bindings/js/src/islet.d.ts"), encoding="utf-8") as file:
            texts.append(file.read())
        for text in texts:
            for match in re.finditer(r"^(    |export declare function )(\w+)(\(.*\): .*;)$", text, re.M):
                found[match.group(2)] = ("world." if match.group(1) == "    " else "") + match.group(2) + match.group(3)
        return found

    def page_of(self, f):
        if f.get("namespace") == "lcp":
            return "matrix"
        name = self.c_names.get(id(f), "")
        for page, _, _, pattern, _ in PAGES:
            if name and pattern and re.match(pattern, name):
                return page
        if f.get("class") in ("World", "StaticWorldOf"):
            return next((p for p, _, _, pattern, _ in PAGES[:-2] if pattern and re.match(pattern, "islet_world_" + f["name"])), "world")
        return "math" if not name.startswith("islet_world") else "world"

    def groups(self):
        """Functions that share a comment, or a name, stand together."""
        group = []
        for f in self.all["functions"]:
            first = group[0] if group else None
            joins = first and "doc" not in f and (
                f.get("doc_with") == first["name"] or f["name"] == group[-1]["name"] or f["name"] in (f"set_{first['name']}", f"enable_{first['name']}"))
            joins = joins and f.get("class") == first.get("class") and f.get("namespace") == first.get("namespace")
            if joins:
                group.append(f)
            else:
                if group:
                    yield group
                group = [f]
        yield group

    # -- Markdown -----------------------------------------------------------------------------------------------------------------------

    def linked(self, text):
        """Names such as World::step lead to where they are described."""
        def link(whole):
            owner = whole.partition("::")[0]
            place = self.places.get(whole) or self.places.get(owner)
            return f"[`{whole}`](./{place[0]}.md#{place[1]})" if place else whole
        parts = re.split(r"(`[^`]*`)", text)
        for i in range(0, len(parts), 2):
            pieces = re.split(r"(\b[A-Z]\w+::\w+\b)", parts[i])
            parts[i] = "".join(link(p) if n % 2 else escape(p) for n, p in enumerate(pieces))
        return "".join(parts)

    def cpp_line(self, f):
        owner = f["class"] + "::" if f.get("class") else "lcp::" if f.get("namespace") == "lcp" else ""
        listed = ", ".join(f"{p['type']} {p['name']}".replace(" & ", "& ").replace(" * ", "* ").replace(" &", "&") + (" = {}" if p.get("default") == {} else "")
                           for p in f["parameters"])
        head = ("template <class T> " if f.get("template") else "") + ("static " if f.get("static") else "")
        return f"{head}{f['returns'].replace(' *', '*').replace(' &', '&')} {owner}{f['name']}({listed}){' const' if f.get('const') else ''};"

    def signature(self, line):
        """A declaration as HTML, with links to its types."""
        def link(match):
            name = match.group(1) or match.group(2)
            place = self.places.get(name)
            whole = match.group(0)
            return f'<a href="./{place[0]}.html#{place[1]}">{whole}</a>' if place and name != "World" else whole
        line = line.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
        return re.sub(r"\bIslet([A-Z]\w+)|\b([A-Z]\w+)(?!::)\b", link, line)

    def function(self, group):
        names = list(dict.fromkeys(f["name"] for f in group))
        title = ", ".join(names)
        out = [f"### {escape(title)} {{#{group[0]['anchor']}}}", ""]
        doc = next((f["doc"] for f in group if "doc" in f), "")
        blocks = {"cpp": [self.cpp_line(f) for f in group], "c": [], "ts": []}
        for f in group:
            name = self.c_names.get(id(f))
            if name in self.c_lines:
                blocks["c"].append(self.c_lines[name])
            js = self.js.js_name(name) if name else None
            if js in self.js_lines and not (js == "step" and f["name"] != "step"):
                blocks["ts"].append(self.js_lines[js])
        if doc:
            out += [self.linked(doc), ""]
        out.append('<div class="signatures" v-pre>')
        for language, lines in blocks.items():
            if lines:
                text = "\n".join(self.signature(line) for line in dict.fromkeys(lines))
                out.append(f'<pre class="in-{language}"><code>{text}</code></pre>')
        return out + ["</div>", ""]

    def default(self, f):
        value = f.get("default")
        if value in (None, {}, []):
            return ""
        if isinstance(value, (dict, list)):
            return "`" + re.sub(r"[\"']", "", str(value)) + "`"
        return f"`{str(value).lower() if isinstance(value, bool) else value}`"

    def type_link(self, cpp):
        name = re.sub(r"^const | [&*]$|\[.*", "", cpp)
        if name in self.places:
            return f"[`{cpp}`](./{self.places[name][0]}.md#{self.places[name][1]})"
        return f"`{cpp}`"

    def struct(self, entry):
        out = [f"### {entry['name']} {{#{self.places[entry['name']][1]}}}", ""]
        if "doc" in entry:
            out += [self.linked(entry["doc"]), ""]
        fields = [f for f in entry.get("fields", []) if not f["name"].endswith("_")]
        if fields:
            out += ["| field | type | default | |", "|---|---|---|---|"]
            for f in fields:
                kind = "a function" if f["type"] == "function" else self.type_link(f["type"])
                js = camel(f["name"])
                name = f"`{f['name']}`" if js == f["name"] else f'<code class="in-cpp">{f["name"]}</code><code class="in-ts">{js}</code>'
                out.append(f"| {name} | {kind} | {self.default(f)} | {self.linked(f.get('doc', ''))} |")
            out.append("")
        return out

    def enum(self, entry):
        out = [f"### {entry['name']} {{#{self.places[entry['name']][1]}}}", ""]
        if "doc" in entry:
            out += [self.linked(entry["doc"]), ""]
        out += ["| value | |", "|---|---|"]
        for v in entry["values"]:
            js = camel(v["name"])
            name = f"`{v['name']}`" if js == v["name"] else f'<code class="in-cpp">{v["name"]}</code><code class="in-ts">{js}</code>'
            out.append(f"| {name} | {self.linked(v.get('doc', ''))} |")
        return out + [""]

    def callback(self, entry):
        line = f"using {entry['name']} = {entry['returns']} (*)({', '.join(p['type'] + ' ' + p['name'] for p in entry['parameters'])});"
        return [f"### {entry['name']} {{#{self.places[entry['name']][1]}}}", "", self.linked(entry.get("doc", "")), "", f'<div class="signatures" v-pre><pre><code>{self.signature(line)}</code></pre></div>', ""]

    def constants(self):
        out = ["# Constants", "", "| constant | value | |", "|---|---|---|"]
        for k in self.all["constants"]:
            owner = k["namespace"] + "::" if "namespace" in k else ""
            out.append(f"| `{owner}{k['name']}` | `{k['text']}` | {self.linked(k.get('doc', ''))} |")
        return "\n".join(out + [""])

    def page(self, name, title, sentence):
        out = [f"# {title} {{#page}}", "", sentence, "", "<ReferenceLanguage />", ""]
        if self.pages[name]:
            out += ["## Functions", ""]
            for group in self.pages[name]:
                out += self.function(group)
        if self.types[name]:
            out += ["## Types", ""]
            for kind, entry in self.types[name]:
                out += {"structs": self.struct, "enums": self.enum, "callbacks": self.callback}[kind](entry)
        return "\n".join(out)

    def index(self):
        out = ["# Reference", "",
               "Every function and type of Islet, in C++, C and JavaScript, with the comments of the headers: units, defaults, errors and effects. "
               "Choose a language on any page; the choice is remembered. The search finds the names of all three.", "",
               "| page | what it covers |", "|---|---|"]
        out += [f"| [{title}](./{name}.md) | {sentence} |" for name, title, sentence, _, _ in PAGES]
        out += ["| [Constants](./constants.md) | Limits and colours. |", ""]
        return "\n".join(out)


def write(folder):
    """Writes the pages into `folder`; gives the entries of the list of pages."""
    reference = Reference()
    os.makedirs(folder, exist_ok=True)
    texts = {"index": reference.index(), "constants": reference.constants(), **{name: reference.page(name, title, sentence) for name, title, sentence, _, _ in PAGES}}
    for name, text in texts.items():
        with open(os.path.join(folder, name + ".md"), "w", encoding="utf-8") as file:
            file.write(text)
    return [{"text": title, "link": f"/reference/{name}"} for name, title, *_ in PAGES] + [{"text": "Constants", "link": "/reference/constants"}]


if __name__ == "__main__":
    sys.exit("pages.py uses this")
