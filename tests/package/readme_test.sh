#!/usr/bin/env bash
# readme_test.sh README.md PROGRAM.cpp: the README's first C++ block must be the program.
set -euo pipefail

diff -u "$2" <(awk '/^```/ { if (inside) exit; inside = ($0 == "```cpp"); next } inside' "$1")
