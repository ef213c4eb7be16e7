#!/usr/bin/env bash
# Builds Islet for Windows with MinGW-w64 and runs the tests of single parts, of bad input, of determinism and of the C interface there, for which Wine
# stands. Ends with a line for each program. (tools/test.sh --release compares the golden hashes there.)
#   tools/windows.sh
# Installs the compiler, Wine and GoogleTest's source with apt if they are missing.
set -euo pipefail
# shellcheck source=tools/lib.sh
. "$(dirname "$0")/lib.sh"

need_build_tools
need_windows_tools
need googletest path_exists /usr/src/googletest/CMakeLists.txt
install_missing

work=$root/build/windows
mkdir -p "$work"
cat >"$work/toolchain.cmake" <<END
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR AMD64)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
set(CMAKE_CROSSCOMPILING_EMULATOR wine)
set(CMAKE_FIND_ROOT_PATH "$work/googletest")
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
foreach(kind LIBRARY INCLUDE PACKAGE)
    set(CMAKE_FIND_ROOT_PATH_MODE_\${kind} ONLY)
endforeach()
END
for_windows=(--toolchain "$work/toolchain.cmake" -DCMAKE_BUILD_TYPE=Release)

say "GoogleTest for Windows"
if [ ! -e "$work/googletest/lib/libgtest.a" ]; then
    cmake -S /usr/src/googletest -B "$work/googletest-build" "${for_windows[@]}" -DBUILD_GMOCK=OFF -DCMAKE_INSTALL_PREFIX="$work/googletest"
    cmake --build "$work/googletest-build" --parallel "$(jobs)" --target install
fi

say "Islet for Windows"
tests=(islet_{unit,robustness,determinism,c}_tests) # of GoogleTest
programs=(islet_c_{calls,refusals,lcp})
cmake -S "$root" -B "$work/islet" "${for_windows[@]}" -DISLET_BUILD_SAMPLES=ON -DISLET_BUILD_TOOLS=OFF -DISLET_BUILD_TESTS=ON -DISLET_WERROR=ON -DISLET_PRECOMPILE=ON
cmake --build "$work/islet" --parallel "$(jobs)" --target "${tests[@]}" "${programs[@]}"

say "testing under Wine"
export WINEPREFIX=$work/wine WINEDEBUG=-all
results=()
failed=false
# under_wine PROGRAM ARGUMENT...
under_wine() {
    local log=$work/$1.log program
    program=$(find "$work/islet/tests" -name "$1.exe")
    if (cd "$work/islet/tests" && wine "$program" "${@:2}") >"$log" 2>&1; then
        results+=("$1: passed")
    else
        tail -n 40 "$log"
        results+=("$1: FAILED")
        failed=true
    fi
}
for program in "${tests[@]}"; do under_wine "$program" --gtest_brief=1; done
for program in "${programs[@]}"; do under_wine "$program"; done
printf '%s\n' "${results[@]}"
! $failed
