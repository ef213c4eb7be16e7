"""conan_recipe.py RECIPE FOLDER [OPTION=VALUE...]: what Conan does with a recipe before it builds, without Conan. Exports the sources into FOLDER and
prints, one per line: `set NAME=VALUE` for each CMake variable, `library NAME`, `pc NAME`, `component NAME` and `folder PATH` (where find_package looks)
for each one that the package is said to have. Of Conan there is only what Islet's recipe uses, and copy() as in Conan's manual: patterns of fnmatch, on
the path below src."""
import fnmatch
import importlib.util
import os
import shutil
import sys
import types
from collections import defaultdict

recipe, folder, *given = sys.argv[1:]


class Info:
    """cpp_info, and each of its components."""

    def __init__(self):
        self.libs, self.requires, self.builddirs, self.properties = [], [], [], {}

    def set_property(self, name, value):
        self.properties[name] = value


class ConanFile:
    def __init__(self):
        self.recipe_folder = self.export_sources_folder = None
        self.cpp_info = Info()
        self.cpp_info.components = defaultdict(Info)


class CMakeToolchain:
    def __init__(self, conanfile):
        self.cache_variables = conanfile.variables = {}

    def generate(self):
        pass


def copy(conanfile, pattern, src, dst, excludes=()):
    excludes = (excludes,) if isinstance(excludes, str) else excludes
    for root, folders, files in os.walk(src):
        path = os.path.relpath(root, src)
        if path != "." and any(fnmatch.fnmatch(path.lower(), exclude) for exclude in excludes):
            folders[:] = []
            continue
        for file in files:
            name = os.path.normpath(os.path.join(path, file))
            if fnmatch.fnmatch(name.lower(), pattern.lower()) and not any(fnmatch.fnmatch(name.lower(), exclude) for exclude in excludes):
                os.makedirs(os.path.dirname(os.path.join(dst, name)), exist_ok=True)
                shutil.copy2(os.path.join(root, file), os.path.join(dst, name))


def load(conanfile, path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def module(name, **names):
    sys.modules[name] = types.ModuleType(name)
    vars(sys.modules[name]).update(names)


module("conan", ConanFile=ConanFile)
module("conan.tools")
module("conan.tools.build", check_min_cppstd=None)
module("conan.tools.cmake", CMake=None, CMakeToolchain=CMakeToolchain, cmake_layout=None)
module("conan.tools.files", copy=copy, load=load)
sys.dont_write_bytecode = True
spec = importlib.util.spec_from_file_location("conanfile", recipe)
conanfile = importlib.util.module_from_spec(spec)
spec.loader.exec_module(conanfile)
(kind,) = [each for each in vars(conanfile).values() if isinstance(each, type) and issubclass(each, ConanFile) and each is not ConanFile]

it = kind()
values = dict(kind.default_options)
for option in given:
    name, value = option.split("=")
    values[name] = value == "True"
for name, value in values.items():
    if value not in kind.options[name]:
        sys.exit(f"the option {name} cannot be {value}")
it.options = types.SimpleNamespace(**values)
it.recipe_folder, it.export_sources_folder = os.path.dirname(os.path.abspath(recipe)), folder
it.set_version()
it.export_sources()
it.generate()
it.package_info()
print(f"set BUILD_SHARED_LIBS={'ON' if values['shared'] else 'OFF'}")
for name, value in it.variables.items():
    print(f"set {name}={'ON' if value is True else 'OFF' if value is False else value}")
for name, info in it.cpp_info.components.items():
    print("component", name)
    for needed in info.requires:
        if needed not in it.cpp_info.components:
            sys.exit(f"the component {name} needs {needed}, which the recipe does not have")
if it.cpp_info.libs or it.cpp_info.builddirs:
    sys.exit("libs or builddirs are given beside components: Conan does not read them there")
for info in it.cpp_info.components.values():
    for path in info.builddirs:
        print("folder", path)
    for library in info.libs:
        print("library", library)
    if "pkg_config_name" in info.properties:
        print("pc", info.properties["pkg_config_name"])
