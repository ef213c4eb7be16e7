# Shared by the scripts in this folder: builds the program that compares hashes by hand, for any compiler and any flags. Meant to be sourced.
# shellcheck shell=bash
#
# The caller sets `root` and `work`, and `jobs` if it likes.

jobs=${jobs:-$(nproc 2>/dev/null || echo 2)}

# What engine/CMakeLists.txt gives every build of the engine and the scenes, whatever the user's flags are; for a processor as uname -m names it.
exact_flags() {
    local flags=(-fno-fast-math -ffp-contract=off -fno-math-errno)
    case $1 in
    x86_64 | amd64) flags+=(-mno-fma -mno-fma4 -mno-avx512f) ;;
    i?86) flags+=(-mno-fma -mno-fma4 -mno-avx512f -msse2 -mfpmath=sse) ;;
    esac
    printf '%s\n' "${flags[@]}"
}

# compile FOLDER PROCESSOR COMPILER FLAG...: every source named on standard input, with the given flags first, as those of CMAKE_CXX_FLAGS come first,
# and the engine's or the scenes' own after them.
compile() {
    local folder=$1 processor=$2 compiler=$3 source object flags exact engine
    shift 3
    mkdir -p "$folder"
    mapfile -t exact < <(exact_flags "$processor")
    engine=("${exact[@]}" -fno-exceptions -fno-rtti -fno-threadsafe-statics -I"$root/engine/src")
    while IFS= read -r source; do
        object=$folder/$(echo "${source#"$root"/}" | tr / _).o
        case $source in
        */kernel_avx2.cpp)
            flags=("${engine[@]}")
            case $processor in x86_64 | amd64) flags+=(-mavx2) ;; esac
            ;;
        "$root"/engine/*) flags=("${engine[@]}") ;;
        "$root"/samples/* | "$folder"/*) flags=("${exact[@]}" -I"$root/samples") ;;
        *) flags=(-I"$root/samples") ;; # the program is the user's: no flags but the user's own
        esac
        printf '%s\0' "$compiler -std=c++20 $* ${flags[*]} -I$root/engine/include -c $source -o $object"
    done >"$folder/commands"
    xargs -0 -P "$jobs" -I{} sh -c '{}' <"$folder/commands"
}

# build_scenes FOLDER PROCESSOR COMPILER FLAG...: the scenes and what loads them, unless they are there. Where bodies start is the same at every
# level of optimisation, so they are built with none; and since that leaves little to do but to read what they all include, as two files. So
# names that are a scene's own must differ from those of the other scenes.
build_scenes() {
    local folder=$1 processor=$2 sources
    shift 2
    [ ! -e "$folder/built" ] || return 0
    mkdir -p "$folder"
    mapfile -t sources < <(
        find "$root"/samples/{scenes,prefabs} -name '*.cpp' | sort
        printf '%s\n' "$root"/samples/{catalogue,engine,islet_engine,joint_measure,near_names,spawn}.cpp
    )
    local half=$((${#sources[@]} / 2))
    printf '#include "%s"\n' "${sources[@]:0:half}" >"$folder/scenes_1.cpp"
    printf '#include "%s"\n' "${sources[@]:half}" >"$folder/scenes_2.cpp"
    {
        printf '%s\n' "$folder"/scenes_{1,2}.cpp
        case $processor in wasm*) ;; *) printf '%s\n' "$root/samples/thread_pool.cpp" ;; esac
    } | compile "$folder" "$processor" "$@" -O0 || return
    touch "$folder/built"
}

# build_engine FOLDER PROCESSOR COMPILER FLAG...: the engine and the program.
build_engine() {
    { find "$root/engine/src" -name '*.cpp' ! -path '*/lcp/*' && printf '%s\n' "$root/tests/determinism/hashes.cpp"; } | compile "$@"
}
