#!/usr/bin/env bash
# readme_test.sh PAGE.md PROGRAM.cpp: the page's first C++ block that has a main function must be the program.
set -euo pipefail

diff -u "$2" <(awk '/^```/ { if (block ~ /int main\(\)/) exit; block = ""; inside = ($0 == "```cpp"); next } inside { block = block $0 "\n" } END { printf "%s", block }' "$1")
