#!/usr/bin/env bash
# install_test.sh CMAKE COMPILER ISLET TREE WORK: Islet installed into empty folders, and used from there as a stranger does: by find_package, by pkg-config and
# by hand, with flags of the user's own too. All programs print what those of the TREE (a build's folder) print.
#   static   the manual's preset, where there is a compiler alone: built, installed, then moved elsewhere
#   small    the engine alone in the small profile, with what hello_world needs put back: programs get the definitions without which they do not link with it
#   shared   the .tar.gz that cpack makes of a build with BUILD_SHARED_LIBS; its .deb holds the same. The libraries show the public names alone
set -euo pipefail

cmake=$1 compiler=$2 islet=$3 tree=$4 work=$5
programs=$islet/samples/programs
user=$(cd "$(dirname "$0")/user" && pwd)
failed=false
fail() {
    printf 'FAILED: %s\n' "$*"
    failed=true
}

rm -rf "$work" && mkdir -p "$work"
cd "$work"
for program in hello_world island prefabs; do "$tree/samples/$program" >"$program.txt"; done

# same PROGRAM NAME HOW: it prints what the tree's does.
same() {
    if "$1" | diff - "$2.txt"; then printf 'ok: %s\n' "$3"; else fail "$3: prints something else"; fi
}

# by_cmake PREFIX WANTED: configures the user's project, quietly.
by_cmake() {
    rm -rf user-build
    "$cmake" -S "$user" -B user-build -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_PREFIX_PATH="$1" -DISLET_WANTED="$2" -DPROGRAMS="$programs" >user.log 2>&1
}

# refused PREFIX WANTED SENTENCE
refused() {
    if by_cmake "$1" "$2"; then fail "find_package(Islet $2) is content"; fi
    tr -s '\n ' ' ' <user.log | grep -q "$3" || fail "find_package(Islet $2) does not say: $3"
}

# use NAME PREFIX [LINKER FLAG...]
use() {
    local name=$1 prefix=$2 flags
    export LD_LIBRARY_PATH=$prefix/lib PKG_CONFIG_PATH=$prefix/lib/pkgconfig
    if ! by_cmake "$prefix" '0.2;COMPONENTS;engine;lcp;c' || ! "$cmake" --build user-build >>user.log 2>&1; then cat user.log && fail "$name: find_package"; fi
    same user-build/hello hello_world "$name: find_package"
    same user-build/island island "$name: find_package, with lcp"
    same user-build/hello_c hello_world "$name: find_package, in C"
    if [ "$name" = static ]; then same user-build/prefabs prefabs "$name: find_package, with prefabs"; fi
    refused "$prefix" '0.3' '0.2'
    refused "$prefix" '0.2;COMPONENTS;fortran' 'Islet has no component fortran; there are engine'

    if command -v pkg-config >/dev/null; then
        [ "$(pkg-config --modversion islet)" = "$version" ] || fail "$name: pkg-config's version"
        read -r -a flags < <(pkg-config --cflags --libs islet islet-lcp)
        "$compiler" -std=c++20 "$programs/hello_world.cpp" "${flags[@]}" -o hello-pkg && same ./hello-pkg hello_world "$name: pkg-config"
        "$compiler" -std=c++20 "$programs/island.cpp" "${flags[@]}" -o island-pkg && same ./island-pkg island "$name: pkg-config, with lcp"
        read -r -a flags < <(pkg-config --cflags --libs islet)
        cc "$programs/hello_world.c" "${flags[@]}" -o hello-c && same ./hello-c hello_world "$name: pkg-config, in C"
    fi
    # Lanes are the library's: a user's flags change nothing.
    for flags in -O0 '-O2 -march=native -ffast-math' '-O1 -mno-sse4'; do
        # shellcheck disable=SC2086  # several flags
        if [ "$(uname -m)" = x86_64 ] || [ "$flags" = -O0 ]; then
            "$compiler" -std=c++20 $flags -I "$prefix/include" "$programs/hello_world.cpp" -L "$prefix/lib" -lislet -o hello-hand &&
                same ./hello-hand hello_world "$name: by hand, $flags"
        fi
    done
    unset LD_LIBRARY_PATH PKG_CONFIG_PATH
}

version=$(sed -n 's/^#define ISLET_VERSION_STRING "\(.*\)".*/\1/p' "$islet/engine/include/islet/version.hpp")

# What is optimised does not matter here.
quick=(-DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0)
absent=()
for package in GTest fmt CLI11 nlohmann_json SDL2 box2d; do absent+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON"); done
(
    cd "$islet" # where the presets are
    "$cmake" --preset install -B "$work/install-build" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS_RELEASE=-O0 "${quick[@]}" "${absent[@]}"
    "$cmake" --build "$work/install-build" --target islet islet_c islet_lcp islet_prefabs
    "$cmake" --install "$work/install-build" --prefix "$work/first"
) >install.log 2>&1 || { cat install.log && fail 'the preset that installs'; }
mv first static
use static "$work/static"

"$cmake" -S "$islet/engine" -B small-build -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS='-O0 -DISLET_MAX_LANES=1' \
    "${quick[@]}" -DISLET_PROFILE=small -DISLET_WITH='sleep;continuous' >small.log
"$cmake" --build small-build >>small.log 2>&1
"$cmake" --install small-build --prefix "$work/small" >>small.log
if ! by_cmake "$work/small" '0.2;COMPONENTS;engine;lcp' || ! "$cmake" --build user-build >>user.log 2>&1; then cat user.log && fail "small: find_package"; fi
same user-build/hello hello_world "small: find_package"
refused "$work/small" '0.2;COMPONENTS;c' 'Islet was installed without its component c'
if command -v pkg-config >/dev/null; then
    read -r -a flags < <(PKG_CONFIG_PATH=$work/small/lib/pkgconfig pkg-config --cflags --libs islet)
    "$compiler" -std=c++20 "$programs/hello_world.cpp" "${flags[@]}" -o hello-small || fail "small: pkg-config"
    same ./hello-small hello_world "small: pkg-config"
    for definition in ISLET_SMALL=1 ISLET_WITH_sleep ISLET_WITH_continuous; do
        [[ " ${flags[*]} " == *" -D$definition "* ]] || fail "small: pkg-config does not say -D$definition: ${flags[*]}"
    done
    if "$compiler" -std=c++20 -I "$work/small/include" "$programs/hello_world.cpp" -L "$work/small/lib" -lislet -o hello-full 2>/dev/null; then
        fail "small: a program of the full profile links"
    fi
    # With these put back, a world's own records are those of the full profile; only what a step takes from scratch is smaller.
    read -r -a back <<<"-DISLET_SMALL=1 $(printf -- '-DISLET_WITH_%s ' hits tuning surfaces sleep profile)"
    if "$compiler" -std=c++20 "${back[@]}" -I "$work/static/include" "$programs/hello_world.cpp" -L "$work/static/lib" -lislet -o hello-back 2>/dev/null; then
        fail "static: a program of the small profile links"
    fi
fi

"$cmake" -S "$islet" -B shared-build -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS=-O0 "${quick[@]}" \
    -DBUILD_SHARED_LIBS=ON -DISLET_BUILD_SAMPLES=OFF -DISLET_BUILD_TOOLS=OFF -DISLET_BUILD_TESTS=OFF -DISLET_WERROR=OFF >shared.log
"$cmake" --build shared-build >>shared.log 2>&1
generators=TGZ
if command -v dpkg-deb >/dev/null; then generators='TGZ;DEB'; fi
(cd shared-build && "$(dirname "$cmake")/cpack" -G "$generators" -B "$work/packages" >>"$work/shared.log")
mkdir shared && tar -xf packages/*.tar.gz -C shared --strip-components=1
use shared "$work/shared"
if command -v dpkg-deb >/dev/null; then
    dpkg-deb -x packages/*.deb deb
    diff <(cd deb/usr && find . | sort) <(cd shared && find . | sort) || fail "the .deb holds other files than the .tar.gz"
fi

# Shown is what the public headers declare: in namespace islet, not in islet::detail, nor anybody else's.
nm -DC --defined-only shared/lib/libislet_c.so | cut -c20- >libislet_c.txt
grep -v -E '^islet_[a-z0-9_]+$' libislet_c.txt && fail "libislet_c shows more than the names of islet.h"
[ "$(wc -l <libislet_c.txt)" -gt 300 ] || fail "libislet_c shows $(wc -l <libislet_c.txt) names"
for library in libislet libislet_lcp; do
    nm -DC --defined-only "shared/lib/$library.so" | cut -c20- >"$library.txt"
    grep -v -E '^(vtable for |typeinfo (name )?for )?(islet::|islet::lcp::(Result|Residuals)<[a-z]+> islet::|islet_lcp_[a-z_]+$)' "$library.txt" && fail "$library shows more than islet's names"
    # (StaticWorld, which is compiled with the user's program, calls the first exception, and libislet_c the others.)
    grep 'detail::' "$library.txt" | grep -v -E '^islet::detail::(create_static|refuse_call|refuse_creation|begin_call|end_call|is_fleet)\(' && fail "$library shows the engine's own names"
    printf 'ok: %s.so shows %s names\n' "$library" "$(wc -l <"$library.txt")"
done
for name in 'islet::World::step(float)' 'islet::make_box(float, float)' 'islet::replay(' 'islet::step_mover('; do
    grep -q -F "$name" libislet.txt || fail "libislet does not show $name"
done
grep -q -F 'islet_lcp_solve' libislet_lcp.txt || fail "libislet_lcp does not show its functions for C"
grep -q -F 'islet::lcp::solve<float>' libislet_lcp.txt || fail "libislet_lcp does not show solve"

if $failed; then exit 1; fi
