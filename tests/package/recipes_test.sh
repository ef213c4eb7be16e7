#!/usr/bin/env bash
# recipes_test.sh ISLET CMAKE COMPILER LIBRARY: what the recipes for package managers say of Islet is true: its version, its licence, its CMake options, its
# targets; the program that tests the package compiles and runs; what Conan's recipe exports is all that CMake needs, and what it promises is installed
# (conan_recipe.py; nothing is built).
set -euo pipefail

islet=$1 cmake=$2 compiler=$3 library=$4
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
grep -q "^  \"$version\":$" "$recipes/conan/config.yml" || complain "config.yml is not of version $version"
head -n 1 "$islet/LICENSE" | grep -q '^MIT ' || complain "the recipes say MIT, LICENSE does not"

mapfile -t options < <(grep -rhoE 'ISLET_[A-Z]+(_[A-Z]+)*' "$recipes" --include=portfile.cmake --include=conanfile.py | grep -v VERSION | sort -u)
[ ${#options[@]} -ge 5 ] || complain "the recipes name ${#options[@]} options"
for option in "${options[@]}"; do
    grep -rqE "option\(${option}[ )]" "$islet/CMakeLists.txt" "$islet/engine/CMakeLists.txt" || complain "there is no option $option"
done
mapfile -t targets < <(grep -rhoE 'islet::[a-z]+' "$recipes" | sort -u)
for target in "${targets[@]}"; do
    grep -q "add_library($target ALIAS " "$islet"/{engine,bindings/c,samples}/CMakeLists.txt || complain "there is no $target"
done
mapfile -t components < <(sed -nE 's/^set\(Islet_known (.*)\)$/\1/p' "$islet/engine/package/IsletConfig.cmake" | tr ' ' '\n' | sort)
for component in "${components[@]}"; do
    grep -qw "$component" "$recipes/vcpkg/islet/usage" || complain "the usage of vcpkg does not name the component $component"
done

if command -v python3 >/dev/null; then
    for file in "$recipes"/conan/all/conanfile.py "$recipes"/conan/all/test_package/conanfile.py; do
        python3 -c 'import ast, sys; ast.parse(open(sys.argv[1]).read())' "$file" || complain "$file is no Python"
    done
    python3 -c 'import json, sys; json.load(open(sys.argv[1]))' "$recipes/vcpkg/islet/vcpkg.json" || complain "vcpkg.json is no JSON"
fi

# conan WANTED_COMPONENTS [OPTION=VALUE...]: with C++17, which Conan's default profile for GCC asks for, and libraries in lib/, as Conan always has them.
conan() {
    rm -rf "$scratch/conan" "$scratch/conan-build"
    if ! python3 "$islet/tests/package/conan_recipe.py" "$recipes/conan/all/conanfile.py" "$scratch/conan" "${@:2}" >"$scratch/conan.txt"; then
        complain "conanfile.py $*: fails"
        return
    fi
    mapfile -t variables < <(sed -n 's/^set /-D/p' "$scratch/conan.txt")
    if ! "$cmake" -S "$scratch/conan" -B "$scratch/conan-build" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_STANDARD=17 -DCMAKE_INSTALL_LIBDIR=lib \
        "${variables[@]}" >"$scratch/conan.log" 2>&1; then
        cat "$scratch/conan.log"
        complain "conanfile.py $*: CMake does not configure what it exports"
        return
    fi
    diff <(tr ' ' '\n' <<<"$1") <(sed -n 's/^component //p' "$scratch/conan.txt" | sort) || complain "conanfile.py $*: other components"
    diff <(find "$scratch/conan-build" -name cmake_install.cmake -exec grep -ohE '/lib[a-z_]+\.(a|so)"' {} + | sed -E 's|/lib(.*)\..*|\1|' | sort -u) \
        <(sed -n 's/^library //p' "$scratch/conan.txt" | sort) || complain "conanfile.py $*: other libraries than are installed"
    diff <(find "$scratch/conan-build" -name '*.pc' -printf '%f\n' | sed 's/\.pc$//' | sort) <(sed -n 's/^pc //p' "$scratch/conan.txt" | sort) ||
        complain "conanfile.py $*: other packages of pkg-config than are installed"
    grep -B 1 '/IsletConfig\.cmake"$' "$scratch/conan-build/engine/cmake_install.cmake" |
        grep -qF "DESTINATION \"\${CMAKE_INSTALL_PREFIX}/$(sed -n 's/^folder //p' "$scratch/conan.txt")\"" ||
        complain "conanfile.py $*: IsletConfig.cmake is installed into another folder"
    [ ! -e "$scratch/conan/samples/sandbox" ] || complain "conanfile.py exports the sandbox, and what npm has installed there"
}
if command -v python3 >/dev/null; then
    conan "${components[*]}"
    conan 'c engine lcp' shared=True prefabs=False
fi

"$compiler" -std=c++20 -I "$islet/engine/include" "$recipes/conan/all/test_package/drop.cpp" "$library" -o "$scratch/drop"
"$scratch/drop" || complain "the package's test program fails"

if $failed; then exit 1; fi
