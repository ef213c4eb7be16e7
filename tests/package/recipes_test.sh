#!/usr/bin/env bash
# recipes_test.sh ISLET COMPILER LIBRARY: what the recipes for package managers say of Islet is true: its version, its licence, its CMake options, its targets;
# and the program that tests the package compiles and runs.
set -euo pipefail

islet=$1 compiler=$2 library=$3
recipes=$islet/tools/recipes
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failed=false
complain() {
    printf '%s\n' "$*"
    failed=true
}

version=$(sed -n 's/.*ISLET_VERSION_STRING "\(.*\)".*/\1/p' "$islet/engine/include/islet/version.hpp")
grep -q "\"version\": \"$version\"" "$recipes/vcpkg/islet/vcpkg.json" || complain "vcpkg.json is not of version $version"
grep -q "find_package(Islet ${version%.*} " "$recipes/vcpkg/islet/usage" || complain "the usage of vcpkg asks for another version than ${version%.*}"
head -n 1 "$islet/LICENSE" | grep -q '^MIT ' || complain "the recipes say MIT, LICENSE does not"

mapfile -t options < <(grep -rhoE 'ISLET_[A-Z]+(_[A-Z]+)*' "$recipes" --include=portfile.cmake --include=conanfile.py | grep -v VERSION | sort -u)
[ ${#options[@]} -ge 5 ] || complain "the recipes name ${#options[@]} options"
for option in "${options[@]}"; do
    grep -rqE "option\(${option}[ )]" "$islet/CMakeLists.txt" "$islet/engine/CMakeLists.txt" || complain "there is no option $option"
done
mapfile -t targets < <(grep -rhoE 'islet::[a-z]+' "$recipes" | sort -u)
for target in "${targets[@]}"; do
    grep -q "add_library($target ALIAS " "$islet/engine/CMakeLists.txt" "$islet/samples/CMakeLists.txt" || complain "there is no $target"
done

if command -v python3 >/dev/null; then
    for file in "$recipes"/conan/conanfile.py "$recipes"/conan/test_package/conanfile.py; do
        python3 -c 'import ast, sys; ast.parse(open(sys.argv[1]).read())' "$file" || complain "$file is no Python"
    done
    python3 -c 'import json, sys; json.load(open(sys.argv[1]))' "$recipes/vcpkg/islet/vcpkg.json" || complain "vcpkg.json is no JSON"
fi

"$compiler" -std=c++20 -I "$islet/engine/include" "$recipes/conan/test_package/drop.cpp" "$library" -o "$scratch/drop"
"$scratch/drop" || complain "the package's test program fails"

if $failed; then exit 1; fi
