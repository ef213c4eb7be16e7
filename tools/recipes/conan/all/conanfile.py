"""Conan 2 recipe. It exports the tree that it lies in: `conan create tools/recipes/conan/all`."""

import os
import re

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load

TREE = os.path.join("..", "..", "..", "..")


class IsletConan(ConanFile):
    name = "islet"
    license = "MIT"
    description = "A 2D rigid-body physics engine in one fixed block of memory, with the same bits on every machine"
    topics = ("physics", "2d", "game", "embedded", "deterministic")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False], "prefabs": [True, False]}
    default_options = {"shared": False, "fPIC": True, "prefabs": True}
    implements = ["auto_shared_fpic"]

    def set_version(self):
        header = load(self, os.path.join(self.recipe_folder, TREE, "engine", "include", "islet", "version.hpp"))
        self.version = re.search(r'ISLET_VERSION_STRING "([^"]+)"', header).group(1)

    def export_sources(self):
        tree = os.path.join(self.recipe_folder, TREE)
        for file in ("CMakeLists.txt", "LICENSE"):
            copy(self, file, src=tree, dst=self.export_sources_folder)
        for folder in ("engine", "bindings/c", "samples"):
            # The sandbox is not built here; its folder holds the packages of Node.js, where they were installed.
            copy(self, "*", src=os.path.join(tree, folder), dst=os.path.join(self.export_sources_folder, folder), excludes=("sandbox*", "*__pycache__*"))

    def layout(self):
        cmake_layout(self)

    def validate(self):
        # CMake compiles Islet, and programs that link its targets, as C++20, also where the profile says 17, as Conan's default for GCC does.
        check_min_cppstd(self, 17)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["ISLET_BUILD_SAMPLES"] = bool(self.options.prefabs)
        toolchain.cache_variables["ISLET_BUILD_TOOLS"] = False
        toolchain.cache_variables["ISLET_BUILD_TESTS"] = False
        toolchain.cache_variables["ISLET_WERROR"] = False
        toolchain.cache_variables["ISLET_INSTALL"] = True
        toolchain.generate()

    def libraries(self):
        """What is installed: for each component of find_package, its library and the components that it needs."""
        libraries = {"engine": ("islet", []), "c": ("islet_c", ["engine"]), "lcp": ("islet_lcp", [])}
        if self.options.prefabs:
            libraries["prefabs"] = ("islet_prefabs", ["engine"])
        return libraries

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        for library, _ in self.libraries().values():  # not the samples' programs
            cmake.build(target=library)

    def package(self):
        copy(self, "LICENSE", src=self.source_folder, dst=os.path.join(self.package_folder, "licenses"))
        CMake(self).install()

    def package_info(self):
        # Islet's own IsletConfig.cmake is used, not one that Conan makes. (Of a package with components, Conan reads the folders of the components alone.)
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.components["engine"].builddirs = [os.path.join("lib", "cmake", "Islet")]
        for component, (library, needed) in self.libraries().items():
            self.cpp_info.components[component].libs = [library]
            self.cpp_info.components[component].requires = needed
            self.cpp_info.components[component].set_property("pkg_config_name", library.replace("_", "-"))
