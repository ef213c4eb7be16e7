"""Conan 2 recipe. It exports the tree that it lies in: `conan create tools/recipes/conan`."""

import os
import re

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load

TREE = os.path.join("..", "..", "..")


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
        for pattern in ("CMakeLists.txt", "LICENSE", "engine/*", "samples/*"):
            copy(self, pattern, src=tree, dst=self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def validate(self):
        check_min_cppstd(self, 20)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["ISLET_BUILD_SAMPLES"] = bool(self.options.prefabs)
        toolchain.cache_variables["ISLET_BUILD_TOOLS"] = False
        toolchain.cache_variables["ISLET_BUILD_TESTS"] = False
        toolchain.cache_variables["ISLET_WERROR"] = False
        toolchain.cache_variables["ISLET_INSTALL"] = True
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", src=self.source_folder, dst=os.path.join(self.package_folder, "licenses"))
        CMake(self).install()

    def package_info(self):
        # Islet's own IsletConfig.cmake is used, not one that Conan makes.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs.append(os.path.join("lib", "cmake", "Islet"))
        self.cpp_info.set_property("pkg_config_name", "islet")
        self.cpp_info.libs = (["islet_prefabs"] if self.options.prefabs else []) + ["islet_lcp", "islet"]
