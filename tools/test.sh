#!/usr/bin/env bash
# Builds Islet and runs every test.
#   tools/test.sh              optimised build, all tests
#   tools/test.sh --all        the same, but for tests that take long and have others of their kind, and with tests and tools compiled many files as one and
#                              run many in a process; once more with clang and sanitizers, but for tests of rules, features left out, physics, control, scenes and
#                              tools, and 90 seconds of fuzzing under them; hashes on other processors, and of the firmware and the sketches in
#                              microcontrollers, all emulated; the engine compiled by hand and in a fresh tree; pages played in a browser, the package for
#                              Python, and the scripts checked: what CI runs
#   tools/test.sh --release    all of that with the optimised build file by file and all its tests, on more processors, systems and boards, with more
#                              compilers' flags, and all tests of the engine under sanitizers: what a release must pass
#   tools/test.sh --coverage   line coverage of engine/, which must be 90 % or more
# Installs a compiler, CMake, Box2D, Chipmunk, SDL, Xvfb, GoogleTest, gnuplot and pkg-config with apt if they are missing (and for the options: clang, gcovr,
# ShellCheck, ccache, Node.js, npm, Chromium, pybind11, numpy, Dask, cross compilers, Emscripten, QEMU and Wine; npm fetches what drives the browser).
set -euo pipefail
# shellcheck source=tools/lib.sh
. "$(dirname "$0")/lib.sh"

least_coverage=90  # %
fuzz_seconds=65
fuzz_c_seconds=15
fuzz_small_seconds=10

all=false
release=false
coverage=false
for argument in "$@"; do
    case $argument in
    --all) all=true ;;
    --release) all=true release=true ;;
    --coverage) coverage=true ;;
    -h | --help)
        sed -n '2,13s/^# \{0,1\}//p' "$0"
        exit 0
        ;;
    *) die "$0: unknown option $argument; there are --all, --release and --coverage" ;;
    esac
done

need_build_tools
need_test_tools
if $all; then
    # first_command_test.sh compiles in a fresh tree what the optimised build has compiled: once, by the user's cache, or else one of this run's own.
    if ! command_exists ccache; then
        need ccache command_exists ccache
        rm -rf "$root/build/ccache"
        export CCACHE_DIR=$root/build/ccache
    fi
    # -fPIC: the package for Python asks for it in the optimised build, which comes first; the fresh tree takes its files as they are.
    export CCACHE_BASEDIR=$root CCACHE_DEPEND=1 CCACHE_IGNOREOPTIONS='-Werror -fPIC'
    export PYTHONDONTWRITEBYTECODE=1 # what Python has compiled is not left in the tree
    export CCACHE_SLOPPINESS=pch_defines,time_macros # or it would not know files that read a precompiled header
    need clang command_exists clang++
    need libclang-rt-14-dev path_exists /usr/lib/llvm-14/lib/clang/14.0.6/lib/linux/libclang_rt.asan-x86_64.a
    need shellcheck command_exists shellcheck
    need python3-clang-14 path_exists /usr/lib/python3/dist-packages/clang/cindex.py
    need libclang1-14 path_exists /usr/lib/llvm-14/lib/libclang-14.so.1
    need nodejs command_exists node
    need npm command_exists npm
    need chromium command_exists chromium
    need pybind11-dev path_exists /usr/include/pybind11/pybind11.h
    need python3-dev path_exists /usr/bin/python3-config
    need python3-numpy path_exists /usr/lib/python3/dist-packages/numpy
    need python3-distributed path_exists /usr/lib/python3/dist-packages/distributed
    need_32_bits
    need_wasm_tools
fi
if $coverage; then need gcovr command_exists gcovr; fi
install_missing

# Compilers for other processors and what emulates these are large, and the first build needs none of them: they come while it runs.
installing=0
if $all; then
    need_firmware_tools
    if $release; then need_emulators; else need_few_emulators; fi
    if [ ${#missing[@]} -gt 0 ]; then
        install_missing &
        installing=$!
    fi
fi
finish_installing() {
    [ "$installing" -eq 0 ] && return
    wait "$installing" || die "what emulates other processors could not be installed"
    installing=0
}

results=()  # one line per build, printed at the end
failures=() # the parts and tests that failed, printed after that
tools=ON    # whether run_tests builds the adapters of other engines and the comparison
targets=()  # what it builds; everything if empty
check=(--check-few)
few=(--few)
leave=()    # what the optimised build's tests leave to --release
if $release; then check=(--check) few=(); fi

# tell PART STATUS GOOD BAD: one of the two, by the part's status, as its line in the end.
tell() {
    if [ "$2" -eq 0 ]; then
        results+=("$1: $3")
    else
        results+=("$1: $4")
        failures+=("$1")
    fi
}

# What each part took. (`times` in a subshell would tell the subshell's own.)
laps=()
lap_seconds=0
lap_processor=0
lap() {
    local times processor
    times=$(mktemp)
    times >"$times"
    processor=$(awk 'NR == 2 { gsub(/s/, ""); split($1, u, "m"); split($2, s, "m"); print int(60 * (u[1] + s[1]) + u[2] + s[2]) }' "$times")
    rm -f "$times"
    laps+=("$(printf '%-22s %6d s, %6d s of processor time' "$1" $((SECONDS - lap_seconds)) $((processor - lap_processor)))")
    lap_seconds=$SECONDS
    lap_processor=$processor
}

# build_tests PRESET
build_tests() {
    local preset=$1 options=(-DISLET_WERROR=ON)
    say "$preset: building"
    case $preset in
    # The optimised build compiles file by file what users build. For a release it does so with all, and runs each test by itself.
    asan-ubsan) options+=(-DISLET_PRECOMPILE=ON -DCMAKE_UNITY_BUILD=ON -DISLET_TEST_SHARDS=8 -DISLET_BUILD_PYTHON="$($release && echo ON || echo OFF)") ;;
    tsan) options=(-DCMAKE_UNITY_BUILD=ON -DISLET_WERROR=OFF) ;;           # the optimised build by the same compiler gives the warnings
    release)
        local extras unite=OFF shards=0
        extras=$($all && echo ON || echo OFF)
        if $all && ! $release; then unite=ON shards=8; fi
        options+=(-DISLET_UNITE="$unite" -DISLET_TEST_SHARDS="$shards")
        options+=(-DISLET_PRECOMPILE="$extras" -DISLET_BROWSER_TESTS="$extras" -DISLET_BUILD_PYTHON="$extras")
        ;;
    esac
    options+=(-DISLET_TOGETHER="$(IFS=';' && echo "${targets[*]}")")
    configure "$preset" -DISLET_BUILD_SAMPLES=ON -DISLET_BUILD_TOOLS="$tools" -DISLET_BUILD_TESTS=ON "${options[@]}"
    if [ ${#targets[@]} -gt 0 ]; then
        build "$preset" --target islet_together
    else
        build "$preset"
    fi
    lap "$preset: build"
}

# A build in the background, which takes the time that others leave; and its end.
building=0  # its process
start_building() { # start_building PRESET
    { renice -n 19 "$BASHPID" && build_tests "$1"; } >"$root/build/$1.log" 2>&1 &
    building=$!
    trap 'pkill -P "$building" 2>/dev/null; kill "$building" 2>/dev/null || true' EXIT
}
finish_building() { # finish_building PRESET
    say "$1: waiting for its build"
    wait "$building" || {
        tail -n 60 "$root/build/$1.log"
        die "$1: does not build"
    }
    trap - EXIT
    lap "$1: build"
}

# run_tests PRESET [CTEST ARGUMENT...]: remembers the closing lines and whether a test failed.
run_tests() {
    local preset=$1 log=$root/build/$1/tests.log status=0
    shift
    say "$preset: testing"
    # A failed test must not end the script here: the other builds are tested too.
    ctest --test-dir "$root/build/$preset" --parallel "$(jobs)" --output-on-failure --no-tests=error "$@" | tee "$log" || status=$?
    results+=("$preset: $(grep -E 'tests passed|No tests' "$log" || echo 'no result')$(sed -n 's/^Total Test time (real) = */, /p' "$log")")
    if [ "$status" -ne 0 ]; then
        failures+=("$preset: tests")
        mapfile -t -O "${#failures[@]}" failures < <(sed -n "/^The following tests FAILED/,/^Errors while/s/^[[:space:]]*[0-9]* - /$preset: /p" "$log")
    fi
    lap "$preset: tests"
}

# The fuzzers that call all of the public API, in C and in C++, and the one of images for the small profile, with the sanitizers' build, beside what comes
# next: much of that has work for one core only. An input that breaks something stays in build/findings.
fuzzing=0  # their process
fuzz_log() { printf '%s/build/fuzz_%s.log' "$root" "$1"; }
fuzz() { # fuzz TARGET SECONDS
    "$root/build/asan-ubsan/tests/fuzz/islet_fuzz_$1" -max_total_time="$2" -max_len=1500 -len_control=0 -timeout=60 \
        -artifact_prefix="$root/build/findings/$1-" >"$(fuzz_log "$1")" 2>&1
}
start_fuzzers() {
    say "fuzzing in the background for $((fuzz_c_seconds + fuzz_seconds + fuzz_small_seconds)) s"
    mkdir -p "$root/build/findings"
    rm -f "$(fuzz_log c)" "$(fuzz_log api)" "$(fuzz_log small)"
    { # the fuzzers' own status is in what they print
        fuzz c "$fuzz_c_seconds" || true
        fuzz api "$fuzz_seconds" || true
        fuzz small "$fuzz_small_seconds" || true
    } &
    fuzzing=$!
    # Should the script end early, the fuzzers must not go on alone.
    trap 'pkill -P "$fuzzing" 2>/dev/null; kill "$fuzzing" 2>/dev/null || true' EXIT
}
finish_fuzzers() {
    local target log finding
    say "waiting for the fuzzers"
    wait "$fuzzing" || true
    trap - EXIT
    for target in c api small; do
        log=$(fuzz_log "$target")
        # One that says nothing of its runs has found something, or has made none.
        if grep -q '^Done ' "$log" && ! grep -q -E '^islet_fuzz_[a-z]*: |ERROR: |runtime error' "$log"; then
            results+=("fuzz $target: $(sed -n 's/^Done \([0-9]*\) runs in \([0-9]*\) second.*/\1 runs in \2 s/p' "$log"), $(
                sed -n 's/^#[0-9]*\tDONE .* ft: \([0-9]*\) .*/\1 features covered/p' "$log"), nothing found")
        else
            failures+=("fuzz $target")
            grep -v -E '^(#[0-9]+|\s*NEW_FUNC)' "$log" | tail -n 40 || true # killed at once, it has said nothing
            finding=$(sed -n 's/.*Test unit written to //p' "$log")
            # For `base64 --decode`, where build/ is not kept: the fuzzer itself prints short ones only.
            if [ -f "$finding" ]; then base64 --wrap=0 "$finding" && echo; fi
            results+=("fuzz $target: $(grep -m 1 -E '^islet_fuzz_[a-z]*: |ERROR: |runtime error' "$log" || echo 'no result')${finding:+; see $finding}")
        fi
    done
    lap "fuzzing"
}

# Line coverage of engine/ by the tests just run under the coverage preset.
measure_coverage() {
    local status=0
    say "coverage of engine/"
    gcovr --root "$root" --filter "$root/engine/" --object-directory "$root/build/coverage" --fail-under-line "$least_coverage" \
        --sort-percentage --print-summary "$root/build/coverage/engine" | tee "$root/build/coverage/coverage.txt" || status=$?
    local lines
    lines="$(grep '^lines:' "$root/build/coverage/coverage.txt"), at least $least_coverage % wanted"
    tell "coverage of engine/" "$status" "$lines" "$lines"
}

check_scripts() {
    say "checking the scripts"
    local scripts=() status=0
    mapfile -t scripts < <(find "$root"/{tools,tests,docs,bindings,samples,.ci} -name node_modules -prune -o \( -name '*.sh' -o -path '*/.ci/run' \) -print)
    (cd "$root" && shellcheck --external-sources "${scripts[@]}") || status=$?
    tell scripts "$status" "clean (${#scripts[@]} files)" 'shellcheck complains'
}

# The firmware in emulated microcontrollers: the host's hashes, and its size and stack within their limits.
check_firmware() {
    local status=0
    say "the firmware"
    "$root/tools/footprint.sh" "${check[@]}" || status=$?
    tell firmware "$status" "the host's hashes, within its limits" 'see above'
}

# The sketches for boards, on emulated processors.
check_boards() {
    local status=0
    say "the sketches for boards"
    "$root/tools/boards.sh" "${check[@]}" || status=$?
    tell boards "$status" "the sketches keep the host's bits" 'see above'
}

# The description of the public headers, from which bindings are made.
check_description() {
    local status=0
    say "the description of the public headers"
    "$root/tools/api/describe.py" --check || status=$?
    tell description "$status" 'is what the headers say' 'run tools/api/describe.py'
}

# The golden hashes on other processors, emulated, and by this one's compilers with all its instructions.
check_targets() {
    local status=0 table=$root/build/targets.txt
    say "the same bits on other processors"
    "$root/tests/determinism/targets.sh" "${few[@]}" "$root/build/targets" | tee "$table" || status=$?
    [ "$status" -eq 0 ] || failures+=("other processors")
    while IFS= read -r line; do results+=("hashes on $line"); done < <(tail -n +2 "$table")
}

# The engine compiled as the manual says for those without CMake, and with flags that would ruin its bits.
check_by_hand() {
    local status=0 log=$root/build/by_hand.txt
    say "the engine by hand"
    "$root/tests/determinism/by_hand.sh" "${few[@]}" "$root/build/by_hand" | tee "$log" || status=$?
    tell "by hand" "$status" "$(wc -l <"$log") builds keep the bits or are refused" 'see above'
    if $release; then # else Clang reads what it builds for the sanitizers, and the engine above
        status=0
        "$root/tests/package/uncompiled.py" "$root" "$root/build/asan-ubsan" || status=$?
        tell "Clang" "$status" 'has read every file' 'see above'
    fi
    status=0
    "$root/tests/package/msvc_mode.sh" "$root" || status=$?
    tell "Clang's Microsoft mode" "$status" 'reads every file' 'see above'
}

# The first command of README.md, in a fresh copy of the tree.
check_first_command() {
    local status=0 log=$root/build/first_command.txt
    say "the first command of the manual"
    "$root/tests/docs/first_command_test.sh" "$root" "$root/build/fresh" | tee "$log" || status=$?
    tell "first command" "$status" 'a fresh tree builds and draws a scene' 'see above'
}

# What drives the browser and what builds the sandbox and the manual's site, in the versions that package-lock.json names; fetched once.
fetch_browser_driver() {
    local folder
    for folder in "$root/tests/browser" "$root/samples/sandbox" "$root/tools/manual"; do
        [ "$folder/node_modules/.package-lock.json" -nt "$folder/package-lock.json" ] && continue
        say "fetching what $folder needs"
        (cd "$folder" && npm ci --no-audit --no-fund) >&2
    done
}

if $coverage; then
    find "$root/build/coverage" -name '*.gcda' -delete 2>/dev/null || true
    build_tests coverage
    run_tests coverage
    measure_coverage
fi
if $all; then fetch_browser_driver; fi
lap "preparing"
if $all || ! $coverage; then
    build_tests release
    finish_installing
    if $all; then
        # Once more by the other compiler, under sanitizers; but what is compared with other engines has been, and so have a user's compile flags.
        # (What lacks a feature has no code that the whole engine lacks, and the small profile is fuzzed.)
        targets=(islet_{unit,queries,robustness,determinism,c}_tests)
        if $release; then targets+=(islet_{embedded,features,physics,control,samples,tools_islet,tools_lab}_tests islet_runner islet-lab islet_python_made); fi
        targets+=(islet_hashes islet_fuzz_{api,c,small} islet_lockstep islet_lcp_search islet_scene_mutants islet_c_{calls,lcp,refusals} islet_fleet_workers)
        start_building asan-ubsan
    fi
    # Of tests that take long, --all has one of each kind. That leaves out the sketches on this machine (boards.sh runs them on a board), Islet compiled by
    # somebody else's project (by_hand.sh has such flags too), the headers in each standard (the one file is compiled as C++17), the sandbox's tools and views
    # and the manual's site in a browser (the sandbox is played, the site is built), random worlds in lockstep (sanitizers watch them below), and two programs
    # in Python.
    if $all && ! $release; then
        leave=(--exclude-regex '^package\.(boards|embedding|standards)|^sandbox\.(tools|views)|^manual\.read|^robustness\.lockstep|^python\.(dask|planning)')
    fi
    run_tests release "${leave[@]}" --parallel "$(($(jobs) + 1))" # tests of pages wait most of the time
fi
if $all; then
    check_scripts
    check_description
    check_firmware
    lap "firmware"
    check_boards
    lap "boards"
    check_targets
    lap "other processors"
    finish_building asan-ubsan
    start_fuzzers
    check_by_hand
    lap "by hand"
    check_first_command
    lap "first command"
    # Planning and random rooms call nothing that the lockstep tester does not; the thread sanitizer sees workers; the manual's tests read files alone. The package for Python is only read
    # (check_by_hand).
    left_out='^(islet_)?(reference|tools[._]engines)|^docs\.|fast_math|^samples\.planning|random_rooms|any_number_of_workers|^python\.'
    if ! $release; then left_out+='|^(islet_)?(embedded|features|small|physics|control|samples|tools)'; fi
    run_tests asan-ubsan --exclude-regex "$left_out"
    tools=OFF
    # What two workers share by mistake.
    targets=(islet_hashes islet_fleet_workers)
    build_tests tsan
    run_tests tsan --tests-regex '^determinism\.workers_share'
    finish_fuzzers
fi

printf '\n'
printf '%s\n' "${laps[@]}"
printf '\n'
printf '%s\n' "${results[@]}"
if [ ${#failures[@]} -gt 0 ]; then
    printf 'FAILED\n'
    printf '%s\n' "${failures[@]:0:40}"
    exit 1
fi
printf 'all passed\n'
