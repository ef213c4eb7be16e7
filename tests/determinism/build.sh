# Shared by the scripts in this folder: builds the program that compares hashes by hand, for any compiler and any flags. Meant to be sourced.
# shellcheck shell=bash
#
# The caller sets `root` and `work`, and `jobs` if it likes.

jobs=${jobs:-$(nproc 2>/dev/null || echo 2)}

# What engine/CMakeLists.txt gives every build of the scenes, whatever the user's flags are; for a processor as uname -m names it.
exact_flags() {
    local flags=(-fno-fast-math -ffp-contract=off -fno-math-errno)
    case $1 in
    x86_64 | amd64) flags+=(-mno-fma -mno-fma4 -mno-avx512f) ;;
    i?86) flags+=(-mno-fma -mno-fma4 -mno-avx512f -msse2 -mfpmath=sse) ;;
    esac
    printf '%s\n' "${flags[@]}"
}

# compile FOLDER PROCESSOR COMPILER FLAG...: every source named on standard input, with the given flags first, as those of CMAKE_CXX_FLAGS come first,
# and the scenes' own after them. The engine's source says what it needs by itself, but for what its refusals ask for.
compile() {
    local folder=$1 processor=$2 compiler=$3 source object flags exact engine
    shift 3
    mkdir -p "$folder"
    mapfile -t exact < <(exact_flags "$processor")
    engine=(-fno-fast-math -fno-exceptions -fno-rtti -fno-threadsafe-statics)
    case $processor in i?86) engine+=(-msse2 -mfpmath=sse) ;; esac
    while IFS= read -r source; do
        object=$folder/$(echo "${source#"$root"/}" | tr / _).o
        case $source in
        "$root"/engine/* | "$folder"/engine.cpp) flags=("${engine[@]}") ;;
        "$root"/samples/* | "$folder"/scenes.cpp) flags=("${exact[@]}" -I"$root/samples") ;;
        *) flags=(-I"$root/samples") ;; # the program is the user's: no flags but the user's own
        esac
        printf '%s\0' "$compiler -std=c++20 $* ${flags[*]} -I$root/engine/include -c $source -o $object"
    done >"$folder/commands"
    xargs -0 -P "$jobs" -I{} sh -c '{}' <"$folder/commands"
}

# as_one FILE: all sources named on standard input as one, since most of the time goes into what they all include. Names that are a file's own differ
# from those of the others.
as_one() {
    mkdir -p "$(dirname "$1")"
    sed 's/.*/#include "&"/' >"$1"
}

# build_scenes FOLDER PROCESSOR COMPILER FLAG...: the scenes and what loads them, unless they are there. Where bodies start is the same at every
# level of optimisation, so they are built with none.
build_scenes() {
    local folder=$1 processor=$2
    shift 2
    [ ! -e "$folder/built" ] || return 0
    rm -rf "$folder"  # objects of files that are elsewhere by now
    mkdir -p "$folder"
    find "$root"/samples/{harness,prefabs,scenes} -name '*.cpp' | sort | as_one "$folder/scenes.cpp"
    {
        echo "$folder/scenes.cpp"
        case $processor in wasm*) ;; *) echo "$root/samples/workers/thread_pool.cpp" ;; esac
    } | compile "$folder" "$processor" "$@" -O0 || return
    touch "$folder/built"
}

# build_engine FOLDER PROCESSOR COMPILER FLAG...: the engine and the program. (The engine of every other build is compiled file by file.)
build_engine() {
    local folder=$1 wide=()
    case $2 in x86_64 | amd64) wide=("$root"/engine/src/*/*_avx*.cpp) ;; esac # for other processors they hold nothing
    find "$root/engine/src" -name '*.cpp' ! -path '*/lcp/*' ! -name '*_avx*.cpp' | sort | as_one "$folder/engine.cpp"
    printf '%s\n' "$folder/engine.cpp" "${wide[@]}" "$root/tests/determinism/hashes.cpp" | compile "$@"
}
