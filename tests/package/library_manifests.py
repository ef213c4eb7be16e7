"""library_manifests.py ISLET LIBRARY: the manifests of the library for boards have the fields that each format requires, with the engine's version, and name
files that are there. The rules are those of the formats' documentation: Arduino's library specification 2.2 (and what arduino-lint rejects), PlatformIO's
library.json, ESP-IDF's component manager, Zephyr's modules. None of these tools is needed."""
import json
import os
import re
import sys

islet, library = sys.argv[1:]
complaints = []


def want(condition, words):
    if not condition:
        complaints.append(words)


def text_of(*path):
    with open(os.path.join(*path), encoding="ascii") as file:
        return file.read()


def exists(*path):
    return os.path.exists(os.path.join(library, *path))


version = re.search(r'ISLET_VERSION_STRING "(.*)"', text_of(islet, "engine/include/islet/version.hpp")).group(1)
config = text_of(islet, "engine/include/islet/config.hpp")
features = re.findall(r"^    FEATURE\((\w+)", config, re.M) + [name + "_joints" for name in re.findall(r"^    JOINT\((\w+)", config, re.M)] + ["joints"]
extras = re.findall(r"^    FEATURE\((\w+), \w+, full\)", config, re.M) + features[len(re.findall(r"^    FEATURE", config, re.M)):]
want(len(features) > 25 and len(features) > len(extras) > 20, "config.hpp lists its features in another way now")
sketches = sorted(os.listdir(os.path.join(islet, "samples/boards")))
sketches = [name for name in sketches if exists("examples", name)]
want(len(sketches) == 3 and len(os.listdir(os.path.join(library, "examples"))) == 3, "there are not three examples")
for path, _, names in os.walk(library):
    for name in names:
        left = re.findall(r"@[A-Z]+@", text_of(path, name))
        want(not left, f"{name} has {left}")

# Arduino
properties = {}
for line in text_of(library, "library.properties").splitlines():
    key, equals, value = line.partition("=")
    want(equals and value and key not in properties, f"library.properties: {line}")
    properties[key] = value
for key in ("name", "version", "author", "maintainer", "sentence", "paragraph", "category", "url", "architectures"):
    want(key in properties, f"library.properties has no {key}")
want(properties["version"] == version, "library.properties is of another version")
want(re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9 _.-]{0,62}", properties["name"]) and "arduino" not in properties["name"].lower(), "Arduino takes no such name")
want(os.path.basename(library) == properties["name"], "the folder has another name than the library")
categories = "Display,Communication,Signal Input/Output,Sensors,Device Control,Timing,Data Storage,Data Processing,Other"
want(properties["category"] in categories.split(","), "Arduino has no such category")
want(properties["url"].startswith("https://"), "the URL")
want(not properties["paragraph"].startswith(properties["sentence"]), "the paragraph repeats the sentence")
for header in properties["includes"].split(","):
    want(exists("src", header), f"there is no src/{header}")
for sketch in sketches:
    want(exists("examples", sketch, sketch + ".ino"), f"{sketch}.ino is not in a folder of its name")
    want(re.search(r"^#include <islet.hpp>", text_of(library, "examples", sketch, "display.h"), re.M), f"{sketch} does not include the library")
want(properties.get("dot_a_linkage") == "true", "Arduino would link all of the engine")
want(not exists("src", "examples") and not exists("utility"), "folders that mean something else to Arduino")
words = text_of(library, "keywords.txt").splitlines()
header = text_of(library, "src/islet.hpp")
known = set(re.findall(r"\w+", header))
seen = set()
for line in words:
    if line.startswith("#"):
        continue
    word, tab, kind = line.partition("\t")
    want(tab and kind in ("KEYWORD1", "KEYWORD2") and word in known and word not in seen, f"keywords.txt: {line}")
    seen.add(word)
want({"World", "BodyId", "StaticWorldOf", "step", "create_body", "set_gravity"} <= seen, "keywords.txt lacks what every program uses")

# PlatformIO
manifest = json.loads(text_of(library, "library.json"))
for key in ("name", "version", "description", "keywords", "repository", "authors", "license", "frameworks", "platforms", "headers", "examples"):
    want(manifest.get(key), f"library.json has no {key}")
want(manifest["version"] == version, "library.json is of another version")
want(len(manifest["name"]) <= 50 and len(manifest["description"]) <= 255, "library.json: too long")
want(exists("src", manifest["headers"]) and exists(manifest["build"]["srcDir"]), "library.json names what is not there")
want(sorted(e["name"] for e in manifest["examples"]) == sketches, "library.json has other examples")
for example in manifest["examples"]:
    want(sorted(example["files"]) == sorted(os.listdir(os.path.join(library, example["base"]))), f"library.json: the files of {example['name']}")

# ESP-IDF and Zephyr: YAML, of which only the plainest is used.
component = text_of(library, "idf_component.yml")
for key in ("version", "description", "url", "license"):
    want(re.search(rf'^{key}: ".+"$', component, re.M), f"idf_component.yml has no {key}")
want(f'version: "{version}"' in component.splitlines(), "idf_component.yml is of another version")
want(re.search(r'^dependencies:\n  idf: ">=\d', component, re.M), "idf_component.yml does not say which ESP-IDF it needs")
want("idf_component_register(" in text_of(library, "CMakeLists.txt"), "CMakeLists.txt registers no component")
module = dict(re.findall(r"^ *(name|cmake|kconfig): (\S+)$", text_of(library, "zephyr/module.yml"), re.M))
want(module.get("name") == "islet", "module.yml has no name")
want(exists(module.get("cmake", "?"), "CMakeLists.txt") and exists(module.get("kconfig", "?")), "module.yml names what is not there")
kconfig = text_of(library, "zephyr/Kconfig")
options = re.findall(r"^config (\w+)\n\tbool \"[^\"]+\"$", kconfig, re.M)
wanted = ["ISLET", "ISLET_SMALL"] + ["ISLET_WITH_" + name.upper() for name in extras] + ["ISLET_WITHOUT_" + name.upper() for name in features]
want(options == wanted, "Kconfig has other options than config.hpp")
want(len(re.findall(r"^config ", kconfig, re.M)) == len(options), "Kconfig has options without a prompt")
want(len(re.findall(r"^if ", kconfig, re.M)) == len(re.findall(r"^endif", kconfig, re.M)) == 1, "Kconfig: if and endif")
for names in (features, extras):
    want("foreach(feature " + " ".join(names) + ")" in text_of(library, "zephyr/CMakeLists.txt"), "Zephyr's CMakeLists.txt has other features than config.hpp")

# What the engine is compiled without.
want(re.findall(r"^// #define ISLET_WITHOUT_(\w+) 1$", text_of(library, "src/islet_options.h"), re.M) == features, "islet_options.h has other features than config.hpp")
want(re.findall(r"^// #define ISLET_WITH_(\w+) 1$", text_of(library, "src/islet_options.h"), re.M) == extras, "islet_options.h puts other features back")
want(0 < header.find('#include "islet_options.h"') < header.find("#if !defined(ISLET_SMALL)"), "islet.hpp does not begin with its options")
for path, _, names in os.walk(os.path.join(library, "src", "engine")):
    for name in names:
        for included in re.findall(r'^#include "(.*)"', text_of(path, name), re.M):
            want(included == "islet.hpp" or os.path.exists(os.path.join(path, included)), f"{name} includes {included}, which is not there")
want(text_of(library, "LICENSE") == text_of(islet, "LICENSE") and manifest["license"] == "MIT", "the licence")
want(version in text_of(library, "README.md"), "README.md is of another version")

print("\n".join(complaints))
sys.exit(1 if complaints else 0)
