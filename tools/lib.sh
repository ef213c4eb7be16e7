# Shared by the scripts in this folder: finding and installing what a build needs. Meant to be sourced, by bash.
# shellcheck shell=bash

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
missing=()

say() { printf '\n-- %s\n' "$*" >&2; }
die() {
    printf '%s\n' "$*" >&2
    exit 2
}

# How many compilers at once: the number of cores, or what CMake is told.
jobs() { if [ -n "${CMAKE_BUILD_PARALLEL_LEVEL:-}" ]; then echo "$CMAKE_BUILD_PARALLEL_LEVEL"; else nproc 2>/dev/null || sysctl -n hw.ncpu 2>/dev/null || echo 2; fi; }

# Probes, for need.
command_exists() { command -v "$1" >/dev/null 2>&1; }
header_exists() {
    local folder
    for folder in /usr/include /usr/local/include /opt/homebrew/include; do
        [ -e "$folder/$1" ] && return
    done
    return 1
}

path_exists() { [ -e "$1" ]; }

# need PACKAGE PROBE ARGUMENT...: remembers Debian package PACKAGE as missing unless the probe succeeds.
need() {
    local package=$1
    shift
    "$@" || missing+=("$package")
}

# What every build needs: a compiler, CMake, and what the program islet is made with (its libraries are header-only but for fmt).
need_build_tools() {
    need g++ command_exists c++
    need cmake command_exists cmake
    need make command_exists make
    need libcli11-dev header_exists CLI/CLI.hpp
    need nlohmann-json3-dev header_exists nlohmann/json.hpp
    need libfmt-dev header_exists fmt/format.h
    need esbuild command_exists esbuild
}

need_test_tools() {
    need libgtest-dev header_exists gtest/gtest.h
    need libbox2d-dev header_exists box2d/box2d.h
    need libchipmunk-dev header_exists chipmunk/chipmunk.h
    need gnuplot-nox command_exists gnuplot
    need pkg-config command_exists pkg-config
    need libsdl2-dev header_exists SDL2/SDL.h
    need xvfb command_exists xvfb-run
    need xauth command_exists xauth
    need xdotool command_exists xdotool
}

# What builds the firmware for Cortex-M and RISC-V, and runs it.
need_firmware_tools() {
    need gcc-arm-none-eabi command_exists arm-none-eabi-g++
    need libnewlib-arm-none-eabi header_exists newlib/string.h
    need libstdc++-arm-none-eabi-newlib path_exists /usr/include/newlib/c++
    need qemu-system-arm command_exists qemu-system-arm
    need gcc-riscv64-unknown-elf command_exists riscv64-unknown-elf-g++
    need gcc-xtensa-lx106 command_exists xtensa-lx106-elf-g++
    need picolibc-riscv64-unknown-elf path_exists /usr/lib/picolibc/riscv64-unknown-elf/include/string.h
    need qemu-system-misc command_exists qemu-system-riscv32
}

# What builds for Windows, and runs that.
need_windows_tools() {
    need g++-mingw-w64-x86-64-posix command_exists x86_64-w64-mingw32-g++-posix
    need wine64 path_exists /usr/lib/wine/wine64
    need wine command_exists wine
}

# What builds WebAssembly.
need_wasm_tools() {
    need clang-16 command_exists clang++-16
    need lld-16 command_exists wasm-ld-16
    need wasi-libc path_exists /usr/include/wasm32-wasi
    need libc++-16-dev-wasm32 path_exists /usr/lib/llvm-16/lib/wasm32-wasi
    need libclang-rt-16-dev-wasm32 path_exists /usr/lib/llvm-16/lib/clang/16/lib/wasi
    need binaryen command_exists wasm-opt
    need python3 command_exists python3
    need nodejs command_exists node
    need npm command_exists npm
    need nlohmann-json3-dev header_exists nlohmann/json.hpp  # the sandbox reads scenes
    need libfmt-dev header_exists fmt/format.h
}

# What builds for this processor's 32-bit form.
need_32_bits() { need g++-12-multilib path_exists /usr/lib/gcc/x86_64-linux-gnu/12/32; }

# What builds for the processors that `tests/determinism/targets.sh --few` has, and runs that; and for all of them.
need_few_emulators() {
    need_32_bits
    need g++-aarch64-linux-gnu command_exists aarch64-linux-gnu-g++
    need g++-s390x-linux-gnu command_exists s390x-linux-gnu-g++
    need qemu-user command_exists qemu-aarch64
    need_wasm_tools
}
need_emulators() {
    need_few_emulators
    need g++-arm-linux-gnueabihf command_exists arm-linux-gnueabihf-g++
    need g++-riscv64-linux-gnu command_exists riscv64-linux-gnu-g++
    need emscripten command_exists em++
    need_windows_tools
}

# Installs everything that need found missing.
install_missing() {
    if [ ${#missing[@]} -gt 0 ]; then
        command_exists apt-get ||
            die "Please install, under the names your system has for these Debian packages, then try again: ${missing[*]}"
        local as_root=()
        if [ "$(id -u)" -ne 0 ]; then
            command_exists sudo || die "Please install these packages as root, then try again: apt-get install ${missing[*]}"
            as_root=(sudo)
        fi
        say "installing ${missing[*]}"
        "${as_root[@]}" apt-get update -q >&2
        "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}" >&2
        missing=()
    fi
    check_cmake
}

check_cmake() {
    local version
    version=$(cmake --version | sed -n '1s/[^0-9]*//p')
    [ "$(printf '%s\n' 3.25 "$version" | sort -V | head -n 1)" = 3.25 ] ||
        die "Islet needs CMake 3.25 or newer and this is $version; https://cmake.org/download has one for every system"
}

# configure PRESET [OPTION...]: into build/PRESET.
configure() {
    local preset=$1
    shift
    (cd "$root" && cmake --preset "$preset" "$@") >&2
}

# build PRESET [ARGUMENT...]
build() {
    local preset=$1
    shift
    cmake --build "$root/build/$preset" --parallel "$(jobs)" "$@" >&2
}
