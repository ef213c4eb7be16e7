#!/usr/bin/env python3
"""Makes the pages of the site, in a folder that the build names: docs/, the reference, and every file that a page links to.

    tools/manual/pages.py FOLDER

docs/X.md becomes X.md, docs/README.md becomes the list of guides (guide.md), and the first page is made from README.md. A picture that shows a scene becomes a
world that runs (SCENES). A link out of docs/ leads to a page with that file (in static/, as HTML), so that the site needs no other. contents.json lists the pages for the side of each page.
"""
import html
import json
import os
import re
import shutil
import sys

import reference

ROOT = reference.ROOT
# Pictures (docs/draw.sh) whose place a running world takes.
SCENES = {name: name for name in "card_house arch hello bullets sensors chain_ball v_grooves platformer".split()} | {
    "impulses": "cairn", "islands": "cairn", "compare": "bridge"}
SHOWN = set(".hpp .cpp .h .c .py .sh .json .ts .js .mjs .md .cmake .txt .ino .s .ld".split())
LARGEST = 100000  # bytes of a file that a list of files leads to
SOURCE = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><meta name="color-scheme" content="light dark">
<title>{path} · Islet</title><link rel="icon" href="data:,">
<style>:root { color-scheme: light dark } body { margin: 16px; font: 15px/1.5 system-ui, sans-serif } pre { font: 13px/1.5 ui-monospace, Consolas, monospace; overflow-x: auto }
a { color: #b3600c }</style></head>
<body><p><a href="{up}">Islet</a> · {path}</p><pre>{text}</pre></body></html>
"""


class Pages:
    def __init__(self, folder):
        self.folder = folder
        self.wanted = []  # files and folders that pages link to, from the root
        self.seen = set()

    def write(self, path, text):
        file = os.path.join(self.folder, path)
        os.makedirs(os.path.dirname(file), exist_ok=True)
        with open(file, "w", encoding="utf-8") as out:
            out.write(text)

    def place_of(self, path):
        """The page of a file or folder of the tree."""
        if path == "docs/README.md":
            return "guide.md"
        if path == "README.md":
            return "index.md"
        if path.startswith("docs/") and path.endswith(".md"):
            return path[5:]
        if path not in self.seen:
            self.seen.add(path)
            self.wanted.append(path)
        if os.path.isdir(os.path.join(ROOT, path)):
            return f"source/{path}/index.md"
        return f"source/{path}" + ("" if path.endswith(".md") else ".html")

    def rewritten(self, text, page, file):
        """The text of `file` of the tree, as `page` of the site has it."""
        here, there = os.path.dirname(page), os.path.dirname(file)

        def link(match):
            target, hash_, anchor = match.group(2).partition("#")
            if not target or re.match(r"[a-z]+:", target):
                return match.group(0)
            path = os.path.normpath(os.path.join(there, target))
            place = os.path.relpath(self.place_of(path), here or ".")
            if place.endswith(".html"):  # not a page of VitePress
                words = re.sub(r"`([^`]*)`", r"<code>\1</code>", match.group(1)[1:-1])
                return f'<a href="{place}" target="_self">{words}</a>'
            return f"{match.group(1)}({place}{hash_}{anchor})"

        def picture(match):
            alt, path = match.group(1), os.path.normpath(os.path.join(there, match.group(2)))
            name = os.path.splitext(os.path.basename(path))[0]
            source = os.path.relpath(path.removeprefix("docs/"), here or ".")
            source = source if source.startswith(".") else "./" + source
            image = f'<img src="{source}" alt="{alt.replace(chr(96), "")}">'
            if name in ("pgs",):
                return f"<islet-pgs>{image}</islet-pgs>"
            return f'<islet-world scene="{SCENES[name]}">{image}</islet-world>' if name in SCENES else f'<p class="picture">{image}</p>'

        parts = re.split(r"(^```.*?^```$)", text, flags=re.M | re.S)
        for i in range(0, len(parts), 2):
            parts[i] = re.sub(r"^!\[([^\]]*)\]\(([^)]+)\)$", picture, parts[i], flags=re.M)
            parts[i] = re.sub(r"(?<!!)(\[(?:[^\]\[]|\[[^\]]*\])*\])\(([^)\s]+)\)", link, parts[i])
        return "".join(parts)

    def guide(self, name):
        with open(os.path.join(ROOT, "docs", name), encoding="utf-8") as file:
            text = file.read()
        page = "guide.md" if name == "README.md" else name
        self.write(page, self.rewritten(text, page, "docs/" + name))

    def source(self, path):
        full, page = os.path.join(ROOT, path), self.place_of(path)
        up = f"`{path}`"
        head = "---\nsearch: false\nprev: false\nnext: false\n---\n\n"
        if os.path.isdir(full):
            names = sorted(n for n in os.listdir(full) if n not in ("node_modules", "dist", "__pycache__") and not n.startswith("."))
            text = ""
            if "README.md" in names:
                with open(os.path.join(full, "README.md"), encoding="utf-8") as file:
                    text = self.rewritten(file.read(), page, path + "/README.md") + "\n\n## Files\n\n"
            else:
                text = f"# {up}\n\n"
            for name in names:
                target = f"{path}/{name}"
                place = os.path.relpath(self.place_of(target), os.path.dirname(page)) if self.is_shown(target) else None
                text += f'- <a href="{place}" target="_self">{name}</a>\n' if place and place.endswith(".html") else f"- [{name}]({place})\n" if place else f"- {name}\n"
            self.write(page, head + text)
        elif path.endswith(".md"):
            with open(full, encoding="utf-8") as file:
                self.write(page, head + self.rewritten(file.read(), page, path))
        else:
            with open(full, encoding="utf-8") as file:
                text = file.read()
            up = os.path.relpath("guide.html", os.path.dirname(page))
            text = SOURCE.replace("{path}", path).replace("{up}", up).replace("{text}", html.escape(text))
            self.write(os.path.join("static", page), text)

    def is_shown(self, path):
        full = os.path.join(ROOT, path)
        if os.path.isdir(full):
            return False
        return os.path.splitext(path)[1] in SHOWN and os.path.getsize(full) < LARGEST

    def first(self):
        """The first page: what README.md opens with, its promises, and its smallest program."""
        with open(os.path.join(ROOT, "README.md"), encoding="utf-8") as file:
            text = file.read()
        opening = re.search(r"^# Islet\n\n(.+?)\n\n", text, re.S).group(1).replace("\n", " ")
        promises = re.findall(r"^\d\. \*\*(.+?)\*\* (.+?)(?=\n\d\. |\n\n)", text, re.M | re.S)
        program = re.search(r"## The smallest program\n.*?(?=\n## )", text, re.S).group(0)
        table = re.search(r"## What it can do\n.*?(?=\n## )", text, re.S).group(0)
        hero = {"name": "Islet", "text": "2D physics, the same bits everywhere", "tagline": opening}
        features = [{"title": title.rstrip("."), "details": re.sub(r"\s+", " ", re.sub(r"[`*]", "", details))} for title, details in promises]
        front = {"layout": "home", "hero": hero | {"actions": [
            {"theme": "brand", "text": "Use it", "link": "/using-islet"}, {"theme": "alt", "text": "Reference", "link": "/reference/"},
            {"theme": "alt", "text": "All pages", "link": "/guide"}]}, "features": features}
        body = '<islet-world scene="pyramid"><img src="./images/film.svg" alt="A pyramid of boxes"></islet-world>\n\n'
        self.write("index.md", "---\n" + json.dumps(front) + "\n---\n\n" + body + self.rewritten(program + "\n" + table, "index.md", "README.md") + "\n")

    def contents(self):
        """The list of pages, from docs/README.md: a sentence with a colon, then a table."""
        with open(os.path.join(ROOT, "docs/README.md"), encoding="utf-8") as file:
            text = file.read()
        groups = []
        for line in text.splitlines():
            heading = re.fullmatch(r"([A-Z][^|.]*):", line)
            entry = re.match(r"\| \[([^\]]+)\]\(([^)]+)\.md\)", line)
            if heading:
                groups.append({"text": heading.group(1), "items": []})
            elif entry:
                groups[-1]["items"].append({"text": entry.group(1), "link": "/" + entry.group(2)})
        return groups


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        print(__doc__)
        sys.exit(0 if sys.argv[1:] == ["--help"] else 2)
    folder = sys.argv[1]
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    pages = Pages(folder)
    shutil.copytree(os.path.join(ROOT, "docs/images"), os.path.join(folder, "images"))
    for name in sorted(os.listdir(os.path.join(ROOT, "docs"))):
        if name.endswith(".md"):
            pages.guide(name)
    pages.first()
    while pages.wanted:
        pages.source(pages.wanted.pop())
    guides = pages.contents()
    listed = reference.write(os.path.join(folder, "reference"))
    with open(os.path.join(folder, "contents.json"), "w", encoding="utf-8") as file:
        json.dump({"guides": guides, "reference": listed}, file, indent=1)


if __name__ == "__main__":
    main()
