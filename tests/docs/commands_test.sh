#!/usr/bin/env bash
# commands_test.sh ROOT BUILD CMAKE: the commands of the manual work as they are written.
#   In blocks (```sh)     `islet`, `rollback` and the tools are run. `islet bench` is, for one step. Scripts that take long must have the options given.
#   In blocks (```cmake)  each is configured, in a project with a target "game".
#   In blocks (```json)   each is run as a scene file.
#   In text (`islet ...`) each is run for two steps, words in capitals replaced by names; scripts (`./tools/...`) must have the options, programs exist.
# A command that no rule knows is an error.
# shellcheck disable=SC2016  # what stands in single quotes is for the manual, CMake and sed
set -euo pipefail

root=$(cd "$1" && pwd) build=$(cd "$2" && pwd) cmake=$3
# shellcheck source=tests/docs/pages.sh
. "$(dirname "$0")/pages.sh"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# A folder like the root of the tree, with the programs where the manual says they are.
cd "$scratch"
ln -s "$root" islet
for name in samples tools engine bindings docs LICENSE; do ln -s "$root/$name" "$name"; done
mkdir build
ln -s "$build" build/release
PATH=$build/tools/islet:$build/samples:$PATH

# has_options SCRIPT OPTION...: its help names each of them.
has_options() {
    local script=$1 help option
    help=$("$script" --help)
    for option in "${@:2}"; do grep -q -e "$option" <<<"$help" || return 1; done
}

# is_left_out PROGRAM: there is such a target, but not in this build, because its libraries are missing.
is_left_out() { [ ! -d "$(dirname "$1")/CMakeFiles/$(basename "$1").dir" ] && grep -rqE "add_executable\($(basename "$1")[ )]" "$root"/{samples,tools} --include=CMakeLists.txt; }

# try COMMAND: runs it, or what of it can be run here.
try() {
    local command=$1
    local -a words
    read -r -a words <<<"$command"
    case $command in
    # All starts take a minute or more: one scene will do.
    'islet steady'*) eval "${command/--engine islet --engine box2d/} flat_bounce" ;;
    # Clusters: tests/python/dask_test.py.
    'islet sweep'*--scheduler*) islet sweep --help | grep -q -e --scheduler ;;
    'islet sweep --merge'*) eval "$command" ;;
    'islet sweep'*) eval "$(sed -E 's/--seeds [0-9]+/--seeds 2/' <<<"$command")" ;;
    'sudo apt-get install python3-distributed') grep -q 'python3-distributed' "$root/tests/python/dask_test.py" ;;
    './bindings/python/examples/rollouts.py'*) for word in "${words[@]:1}"; do [[ $word != --* ]] || grep -qe "\"$word\"" "$root/${words[0]}" || return 1; done ;;
    'islet bench'*) eval "${command/--quick/--repeat 1} --steps 1" ;;
    'islet '* | 'rollback '*) eval "$command" ;;
    'window '*) is_left_out build/release/samples/window || ! command -v xvfb-run || xvfb-run --auto-servernum build/release/samples/window "${words[@]:1}" --frames 2 ;;
    build/release/*) is_left_out "${words[0]}" || eval "$command" ;;
    './tools/run.sh --web'*) has_options tools/run.sh --web ;;  # tests/browser/sandbox.test.mjs plays with what it builds
    './tools/manual.sh'*) has_options tools/manual.sh "${words[1]}" ;;  # tests/browser/manual.test.mjs reads what it builds
    'npm install '*) grep -q "\"name\": \"${words[2]}\"" bindings/js/package.json ;;
    ./bindings/js/build.sh | ./samples/sandbox/build.sh) [ -x "$command" ] ;;  # tests/CMakeLists.txt runs both
    ./bindings/js/bench/run.sh | './tests/browser/measure.sh '*) [ -x "${words[0]}" ] ;;  # they take minutes
    './tools/run.sh'*) has_options tools/run.sh && islet run "${words[1]-hello}" ;;  # first_command_test.sh runs it in a fresh tree
    ./tools/test.sh* | ./tools/footprint.sh* | ./tools/c_cost.sh | ./tools/boards.sh*) has_options "${words[@]}" ;;
    'cmake --preset '*) grep -q "\"name\": \"${words[2]}\"" "$root/CMakePresets.json" ;;
    # tools/footprint.sh builds the firmware like that, and tests/determinism/by_hand.sh the engine.
    'cmake -S samples/firmware'*) [ -e "$(sed -n 's/.*toolchain "$PWD\/\([^"]*\)".*/\1/p' <<<"$command")" ] ;;
    'cmake --build build/m4'*) ;;
    # All files take a minute.
    flags=*) ;;
    'arm-none-eabi-g++ '*)
        ! command -v arm-none-eabi-g++ ||
            { eval "$(grep '^flags=' "$root/docs/microcontrollers.md")" && eval "${command/-c engine\/src\/\*/-fsyntax-only engine\/src\/world}"; }
        ;;
    'emcmake cmake -S engine'*) grep -q 'em++' "$root/tests/determinism/targets.sh" ;; # where there is Emscripten
    # The build of the wheel takes minutes; tests/python tries what it holds, and tests/python/manual_test.py the page's examples.
    'sudo apt-get install '*pybind11*) grep -q 'find_package(pybind11' "$root/bindings/python/CMakeLists.txt" ;;
    '/usr/bin/python3 -m venv'*'pip install ./bindings/python') [ -e bindings/python/pyproject.toml ] ;;
    # Building the package takes minutes; tests/python/envs_test.py learns with the same program.
    './bindings/python/run.sh '*) has_options bindings/python/run.sh && [ -x "${words[1]}" ] && python3 -c 'import ast, sys; ast.parse(open(sys.argv[1]).read())' "${words[1]}" ;;
    # tests/package/install_test.sh does that.
    'cmake --build --preset install' | 'cmake --install build/install'* | 'cpack --config build/install'*) grep -q '"$cmake" --install' "$root/tests/package/install_test.sh" ;;
    ./tools/windows.sh) [ -x tools/windows.sh ] ;; # takes minutes
    'alias islet="$PWD/build/release/tools/islet/islet"') ;;  # what the other commands are tried with
    ./tools/package.sh*) "$root/tools/package.sh" Islet && [ -s Islet/library.properties ] ;;
    # tests/package/one_file_test.sh compiles what the first writes as the second does.
    ./tools/amalgamate.sh*) eval "$command" && [ -s "${words[1]}/islet.cpp" ] ;;
    'g++ -std=c++20 -O2 islet.cpp '*) grep -q '"$compiler" -std=c++20 islet.cpp hello.cpp' "$root/tests/package/one_file_test.sh" ;;
    'g++ -std=c++20 -O2 -I engine/include -c engine/src/'*) grep -q 'as_manual' "$root/tests/determinism/by_hand.sh" ;;
    *)
        printf 'no rule for: %s\n' "$command"
        return 1
        ;;
    esac
}

tried=0
check() {
    tried=$((tried + 1))
    local log status=0
    log=$(try "$2" 2>&1) || status=$?
    [ "$status" -eq 0 ] || complain "$(basename "$1"): $2"$'\n'"$(tail -n 5 <<<"$log")"
}

for page in $(pages "$root"); do
    while IFS= read -r line; do
        line=${line%%#*}
        [ -z "$line" ] || check "$page" "$line"
    done < <(blocks sh "$page")
done

# In text: cut short, a scene's check is skipped.
for page in $(pages "$root"); do
    while IFS= read -r line; do
        line=$(sed 's/SCENE/hello/; s/FILE/out/' <<<"$line")
        case $line in
        'islet run'*--help | 'islet list'*) check "$page" "$line" ;;
        'islet run'*) check "$page" "$line --steps 2" ;;
        'islet scene'* | 'islet replay '*.rec*) check "$page" "$line" ;;
        esac
    done < <(prose "$page" | grep -oE '`islet (run|scene|replay|list) [^`]+`' | tr -d '`' || true)
    while IFS= read -r line; do check "$page" "$line"; done < <(prose "$page" | grep -oE '`\./tools/[^`]+\.sh[^`]*`' | tr -d '`' || true)
    while IFS= read -r line; do
        program=${line%% *}
        [ -x "$program" ] || is_left_out "$program" || complain "$(basename "$page"): there is no $program"
    done < <(prose "$page" | grep -oE '`build/release/[^`]+`' | tr -d '`' || true)
done

# configure BLOCK: in a project of somebody else's; what is fetched is this tree.
configure() {
    rm -rf project && mkdir project
    {
        printf 'cmake_minimum_required(VERSION 3.25)\nproject(game LANGUAGES CXX)\nfile(WRITE ${CMAKE_BINARY_DIR}/game.cpp "int main() {}")\n'
        printf 'add_executable(game ${CMAKE_BINARY_DIR}/game.cpp)\n%s\n' "$1"
    } >project/CMakeLists.txt
    ln -s "$root" project/islet
    if grep -q 'find_package(Islet' project/CMakeLists.txt; then "$cmake" --install "$build" --prefix "$scratch/installed"; fi
    "$cmake" -S project -B project/build -DFETCHCONTENT_SOURCE_DIR_ISLET="$root" -DCMAKE_PREFIX_PATH="$scratch/installed"
}
for page in $(pages "$root"); do
    count=$(grep -c '^```cmake$' "$page" || true)
    for ((i = 1; i <= count; ++i)); do
        block=$(awk -v wanted="$i" '/^```/ { inside = $0 == "```cmake" && ++n == wanted; next } inside' "$page")
        tried=$((tried + 1))
        log=$(configure "$block" 2>&1) || complain "$(basename "$page"): CMake block $i"$'\n'"$(tail -n 8 <<<"$log")"
    done
    if grep -q '^```json$' "$page"; then
        blocks json "$page" >scene.json
        check "$page" 'islet run scene.json'
    fi
done

printf '%d commands tried\n' "$tried"
[ "$tried" -gt 40 ] && [ "$failures" -eq 0 ]
