"""Builds the package for pip, by CMake: what pyproject.toml names as its build system (PEP 517). It needs no package of Python's."""
import base64
import hashlib
import os
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))


def version():
    with open(os.path.join(ROOT, "engine", "include", "islet", "version.hpp"), encoding="utf-8") as file:
        return re.search(r'ISLET_VERSION_STRING.*"(.*)"', file.read()).group(1)


def build(folder):
    """Builds islet/ in `folder`/python."""
    options = {"CMAKE_BUILD_TYPE": "Release", "ISLET_BUILD_PYTHON": "ON", "ISLET_BUILD_SAMPLES": "OFF", "ISLET_BUILD_TOOLS": "OFF", "ISLET_BUILD_TESTS": "OFF",
               "ISLET_WERROR": "OFF", "Python_EXECUTABLE": sys.executable}
    subprocess.run(["cmake", "-S", ROOT, "-B", folder, *[f"-D{name}={value}" for name, value in options.items()]], check=True)
    subprocess.run(["cmake", "--build", folder, "--target", "islet_python_package", "--parallel", str(os.cpu_count() or 2)], check=True)


def about():
    return (f"Metadata-Version: 2.1\nName: islet\nVersion: {version()}\nSummary: A 2D rigid-body physics engine in one fixed block of memory\n"
            "License: MIT\nLicense-File: LICENSE\nRequires-Python: >=3.9\nRequires-Dist: numpy\n")


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """Tells pip the name and version without a build."""
    info = f"islet-{version()}.dist-info"
    os.mkdir(os.path.join(metadata_directory, info))
    with open(os.path.join(metadata_directory, info, "METADATA"), "w", encoding="utf-8") as file:
        file.write(about())
    return info


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    tag = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    tag = f"{tag}-{tag}-{re.sub('[-.]', '_', sysconfig.get_platform())}"
    info = f"islet-{version()}.dist-info"
    files = {f"{info}/METADATA": about().encode(),
             f"{info}/WHEEL": f"Wheel-Version: 1.0\nGenerator: islet\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()}
    with open(os.path.join(ROOT, "LICENSE"), "rb") as file:
        files[f"{info}/LICENSE"] = file.read()
    with tempfile.TemporaryDirectory() as folder:
        build(folder)
        package = os.path.join(folder, "python", "islet")
        for folder, inner, names in sorted(os.walk(package)):
            inner[:] = [name for name in inner if name != "__pycache__"]
            for name in sorted(names):
                path = os.path.join(folder, name)
                with open(path, "rb") as file:
                    files["islet/" + os.path.relpath(path, package)] = file.read()
    digest = {name: base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode() for name, data in files.items()}
    record = "".join(f"{name},sha256={digest[name]},{len(data)}\n" for name, data in files.items()) + f"{info}/RECORD,,\n"
    wheel = f"islet-{version()}-{tag}.whl"
    with zipfile.ZipFile(os.path.join(wheel_directory, wheel), "w", zipfile.ZIP_DEFLATED) as out:
        for name, data in {**files, f"{info}/RECORD": record.encode()}.items():
            out.writestr(name, data)
    return wheel


def build_sdist(sdist_directory, config_settings=None):
    raise NotImplementedError("the package is built within Islet's tree")
