#!/usr/bin/env bash
# Builds the package for Python, and runs a program with it.
#   bindings/python/run.sh [PROGRAM [ARGUMENT...]]      e.g. bindings/python/run.sh bindings/python/examples/train.py cart_pole
# Without a program it starts Python. Installs a compiler, CMake, pybind11, fmt and numpy with apt if they are missing.
set -euo pipefail
if [ "${1-}" = -h ] || [ "${1-}" = --help ]; then
    sed -n '2,4s/^# *//p' "$0"
    exit 0
fi
# shellcheck source=tools/lib.sh
. "$(dirname "$0")/../../tools/lib.sh"

python=/usr/bin/python3  # the system's, for which apt has numpy
has_numpy() { "$python" -c 'import numpy' 2>/dev/null; }
need g++ command_exists c++
need cmake command_exists cmake
need make command_exists make
need libfmt-dev header_exists fmt/format.h
need pybind11-dev header_exists pybind11/pybind11.h
need python3-dev command_exists python3-config
need python3-numpy has_numpy
install_missing

folder=$root/build/python
say "building the package for Python"
cmake -S "$root" -B "$folder" -DCMAKE_BUILD_TYPE=Release -DISLET_BUILD_PYTHON=ON -DISLET_BUILD_SAMPLES=OFF -DISLET_BUILD_TOOLS=OFF -DISLET_BUILD_TESTS=OFF \
    -DISLET_WERROR=OFF -DPython_EXECUTABLE="$python" >&2
cmake --build "$folder" --target islet_python_package --parallel "$(jobs)" >&2
PYTHONPATH="$folder/python" exec "$python" "$@"
