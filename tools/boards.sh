#!/usr/bin/env bash
# The sketches of samples/boards on three processors: made of the library that tools/package.sh makes, compiled as packages for Arduino compile for these
# processors, linked with a stub of a board (samples/boards/stub), and run in QEMU. Worlds and frames must be the host's, to the bit.
#   tools/boards.sh            a table. In bytes: flash of the engine and the compiler's runtime; static memory, which is the world and the display's dots; the
#                              deepest that the stack was. Then the instructions of a frame, in the mean: a step, drawing, sending. "trimmed" is the engine
#                              without what the sketch does not use (islet_options.h). Balls is also run on floats without subnormal numbers, like those in
#                              the RP2040's ROM, and the library is compiled for the ESP8266
#   tools/boards.sh --check    the same, and whether docs/microcontrollers.md says so, but for 5 %: part of tools/test.sh --release
#   tools/boards.sh --check-few    the same on the Cortex-M0+ alone: part of tools/test.sh --all
#   tools/boards.sh --write    the same, and writes the table into docs/microcontrollers.md
# Installs the cross compilers and QEMU with apt if they are missing.
set -euo pipefail
# shellcheck source=tools/lib.sh
. "$(dirname "$0")/lib.sh"

mode=table
few=false
case ${1:-} in
'') ;;
--check) mode=check ;;
--check-few) mode=check few=true ;;
--write) mode='write' ;;
-h | --help)
    sed -n '2,11s/^# \{0,1\}//p' "$0"
    exit 0
    ;;
*) die "$0: unknown option $1; there are --check, --check-few and --write" ;;
esac

need_build_tools
need_firmware_tools
install_missing

work=$root/build/boards
stub=$root/samples/boards/stub
firmware=$root/samples/firmware
page=$root/docs/microcontrollers.md
sketches=(Balls MarbleMaze RobotArm)
declare -A frames=([Balls]=300 [MarbleMaze]=400 [RobotArm]=400)
library=$work/Islet
mkdir -p "$work"
"$root/tools/package.sh" "$library" >/dev/null

# What the packages give every file: of arduino-pico for the RP2040, of the STM32 core for an STM32F4, of arduino-esp32 for the ESP32-C3.
small=(-Os -ffunction-sections -fdata-sections -fno-exceptions -fno-rtti)
cortex_m0plus=(arm-none-eabi-g++ -march=armv6-m -mcpu=cortex-m0plus -mthumb -std=gnu++17 "${small[@]}")
cortex_m4f=(arm-none-eabi-g++ -mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard -mthumb -std=gnu++17 "${small[@]}" --param max-inline-insns-single=500
    -fno-use-cxa-atexit -fno-threadsafe-statics)
rv32imc=(riscv64-unknown-elf-g++ -march=rv32imc -mabi=ilp32 -std=gnu++2b "${small[@]}" -fno-threadsafe-statics)

lx106=(xtensa-lx106-elf-g++ -mlongcalls -std=gnu++17 "${small[@]}")  # of the ESP8266

# Where the emulated board has its flash and its memory; the rest is as in samples/firmware/toolchains. No board of QEMU's has a Cortex-M0+ and enough memory:
# its code runs on a Cortex-M3, which here faults as an M0+ does where a word is not aligned.
arm=(-display none -monitor none -serial none -icount shift=0 -semihosting-config 'enable=on,target=native')
newlib=(/usr/include/newlib/c++/*)
headers=(-isystem "${newlib[0]}" -isystem "${newlib[0]}/arm-none-eabi" -isystem /usr/lib/picolibc/riscv64-unknown-elf/include)  # for compilers without

# use TARGET: sets compile, link, run.
use() {
    case $1 in
    cortex-m0plus)
        compile=("${cortex_m0plus[@]}")
        link=(--entry=reset --defsym=flash_origin=0 --defsym=ram_origin=0x20000000)
        run=(qemu-system-arm -machine mps2-an385 "${arm[@]}" -kernel)
        board=board_cortex_m
        ;;
    cortex-m4f)
        compile=("${cortex_m4f[@]}")
        link=(--entry=reset --defsym=flash_origin=0 --defsym=ram_origin=0x20000000)
        run=(qemu-system-arm -machine mps2-an386 "${arm[@]}" -kernel)
        board=board_cortex_m
        ;;
    riscv32imc)
        compile=("${rv32imc[@]}" "${headers[@]}")
        link=(--entry=start --defsym=flash_origin=0x80000000 --defsym=ram_origin=0x80100000)
        run=(qemu-system-riscv32 -machine virt -bios none "${arm[@]}" -kernel)
        board=board_riscv
        ;;
    esac
}

# What the sketches do not use.
unused=(half_spaces surfaces bullets hits hooks one_way disabling queries recorder tuning profile shortcuts)
mapfile -t -O ${#unused[@]} unused < <(sed -nE '/JOINT\(revolute/d; s/^ +JOINT\(([a-z_]+).*/\1_joints/p' "$root/engine/include/islet/config.hpp")
declare -A unused_by=([Balls]='joints polygons capsules segments sensors' [MarbleMaze]='joints polygons capsules chains' [RobotArm]='segments chains sensors restitution')

# sketch_flags SKETCH
sketch_flags() {
    printf '%s\n' "-DSKETCH_FILE=\"$library/examples/$1/$1.ino\"" "-DSKETCH_NAME=\"$1\"" "-DSKETCH_FRAMES=${frames[$1]}" -DSKETCH_SHOWN=100 "-I$stub" "-I$library/src"
}

# What a program prints, without what only a board can tell.
bits() { sed -E 's/ instructions .*//; /^stack /d'; }

# compile_engine FOLDER FLAG...: as a library, which share.awk knows by its name.
compile_engine() {
    local objects=$1/engine
    rm -rf "$objects" "$1/libislet.a" && mkdir -p "$objects"
    (cd "$objects" && find "$library/src/engine" -name '*.cpp' -exec "${compile[@]}" "${@:2}" -I "$library/src" -c {} +)
    ar rcs "$1/libislet.a" "$objects"/*.o
}

# compile_engine_as_one FOLDER FLAG...: the same from one file, which takes half the time. Its size is not that of a sketch.
compile_engine_as_one() {
    local objects=$1/engine
    rm -rf "$objects" "$1/libislet.a" && mkdir -p "$objects"
    find "$library/src/engine" -name '*.cpp' ! -name '*_avx*.cpp' -printf '#include "%p"\n' | LC_ALL=C sort >"$objects/engine.cpp"
    "${compile[@]}" "${@:2}" -I "$library/src" -c "$objects/engine.cpp" -o "$objects/engine.o"
    ar rcs "$1/libislet.a" "$objects/engine.o"
}

# compile_board FOLDER
compile_board() {
    local source
    for source in "$board" console runtime; do
        "${compile[@]/%rv32imc/rv32imc_zicsr}" -fno-tree-loop-distribute-patterns -c "$firmware/$source.cpp" -o "$1/$source.o"
    done
}

# compile_sketch SKETCH FOLDER
compile_sketch() {
    local flags
    mapfile -t flags < <(sketch_flags "$1")
    "${compile[@]}" "${flags[@]}" -c "$stub/stub.cpp" -o "$2/$1.o"
}

# link_sketch SKETCH FOLDER ENGINE [ARGUMENT...]: what was compiled into the folders, to FOLDER/SKETCH.elf.
link_sketch() {
    "${compile[@]}" "$2/$1.o" "$2"/{"$board",console,runtime}.o "$3/libislet.a" -nostdlib -static -Wl,-T,"$firmware/firmware.ld" \
        "${link[@]/#/-Wl,}" -Wl,--defsym=flash_length=0x80000,--defsym=ram_length=0x40000,--defsym=stack_length=8192 -Wl,--gc-sections \
        -Wl,-Map,"$2/$1.map" "${@:4}" -lgcc -o "$2/$1.elf"
}

# build TARGET [trimmed]: the engine, the board, the sketches.
build() (
    local folder=$work/$1${2:+-$2} sketch engine=$work/$1 without
    use "$1"
    rm -rf "$folder" && mkdir -p "$folder"
    if [ $# -eq 2 ]; then
        for sketch in "${sketches[@]}"; do
            # shellcheck disable=SC2206  # words of a list
            without=("${unused[@]}" ${unused_by[$sketch]})
            compile_engine "$folder/$sketch.engine" "${without[@]/#/-DISLET_WITHOUT_}" &
        done
        wait
    else
        compile_engine "$folder" &
    fi
    compile_board "$folder"
    for sketch in "${sketches[@]}"; do compile_sketch "$sketch" "$folder"; done
    wait
    for sketch in "${sketches[@]}"; do
        engine=$folder
        [ $# -eq 1 ] || engine=$folder/$sketch.engine
        link_sketch "$sketch" "$folder" "$engine"
    done
)

# build_on_rom_floats: Balls as Arduino compiles it for an RP2040, on the floats of its ROM.
build_on_rom_floats() (
    local folder=$work/rp2040 name wraps=()
    use cortex-m0plus
    compile+=(-DARDUINO_ARCH_RP2040)
    rm -rf "$folder" && mkdir -p "$folder"
    compile_engine_as_one "$folder"
    compile_board "$folder"
    compile_sketch Balls "$folder"
    "${compile[@]}" -c "$stub/rom_floats.cpp" -o "$folder/rom_floats.o"
    for name in add sub mul div cmpeq cmplt cmple cmpgt cmpge; do wraps+=("-Wl,--wrap=__aeabi_f$name"); done
    link_sketch Balls "$folder" "$folder" "$folder/rom_floats.o" "${wraps[@]}"
)

# host: what the sketches print there, in C++20.
host() {
    local folder=$work/host sketch flags
    mkdir -p "$folder"
    local compile=(g++ -std=c++20 -O1 -DISLET_MAX_LANES=4)
    compile_engine_as_one "$folder"
    for sketch in "${sketches[@]}"; do
        mapfile -t flags < <(sketch_flags "$sketch")
        g++ -std=c++20 -O1 "${flags[@]}" "$stub/stub.cpp" "$firmware"/{board_host,console}.cpp "$folder/libislet.a" -o "$folder/$sketch"
        "$folder/$sketch" >"$folder/$sketch.txt"
    done
}

# Two at once: most of the time is work for one core each.
say "building the sketches"
host &
host=$!
build cortex-m0plus
wait "$host"
targets=(cortex-m0plus)
if ! $few; then
    build cortex-m4f &
    m4f=$!
    build riscv32imc
    wait "$m4f"
    build cortex-m4f trimmed &
    trimmed=$!
    build_on_rom_floats
    compile=("${lx106[@]}" "${headers[@]}")
    compile_engine_as_one "$work/esp8266"  # which nothing here emulates
    wait "$trimmed"
    targets+=(cortex-m4f 'cortex-m4f trimmed' riscv32imc)
fi

failed=false
rows=()
for target in "${targets[@]}"; do
    say "$target"
    use "${target% trimmed}"
    folder=$work/${target// /-}
    for sketch in "${sketches[@]}"; do
        "${run[@]}" "$folder/$sketch.elf" >"$folder/$sketch.txt" 2>&1 &
    done
    wait
    for sketch in "${sketches[@]}"; do
        if ! diff <(bits <"$work/host/$sketch.txt") <(bits <"$folder/$sketch.txt") >"$folder/$sketch.diff"; then
            printf '%s: %s prints something else than on the host: %s\n' "$target" "$sketch" "$(tail -n 3 "$folder/$sketch.diff")" >&2
            failed=true
        fi
        engine=$(($(awk -v library=libislet.a -f "$root/tools/footprint/share.awk" "$folder/$sketch.map") + $(awk -v library=libgcc.a -f "$root/tools/footprint/share.awk" "$folder/$sketch.map")))
        # Static memory of what is not the board: the world and the display's dots.
        ram=$(nm --size-sort --print-size --radix=d --demangle "$folder/$sketch.elf" | awk '$3 ~ /^[bBdD]$/ && $4 !~ /^(stub::|\(anonymous|firmware::)/ { sum += $2 } END { print sum + 0 }')
        rows+=("| $sketch | $target | $engine | $ram | $(sed -n 's/^stack //p' "$folder/$sketch.txt") | $(sed -n 's/^[A-Z].* instructions \([0-9]*\) .*/\1/p' "$folder/$sketch.txt") |")
    done
done
printf '%s\n' "${rows[@]}"

check_rom_floats() {
    say "floats without subnormal numbers"
    use cortex-m0plus
    "${run[@]}" "$work/rp2040/Balls.elf" >"$work/rp2040/Balls.txt" 2>&1 || true
    diff <(bits <"$work/host/Balls.txt") <(bits <"$work/rp2040/Balls.txt") >"$work/rp2040/Balls.diff" && return
    printf 'floats without subnormal numbers: Balls prints something else than on the host: %s\n' "$(tail -n 3 "$work/rp2040/Balls.diff")" >&2
    failed=true
}
$few || check_rom_floats

# spaced ROW: its numbers in groups of three digits, as the manual writes them.
spaced() { sed -E ':again; s/([0-9])([0-9]{3})( |$)/\1 \2\3/; t again' <<<"$1"; }
# What the manual says: "| sketch | target |" and its figures.
case $mode in
write)
    for row in "${rows[@]}"; do
        key=$(cut -d '|' -f 1-3 <<<"$row")
        grep -qF "$key|" "$page" || die "$page has no row $key"
        new=$(spaced "$row") key=$key awk 'index($0, ENVIRON["key"] "|") == 1 { $0 = ENVIRON["new"] } { print }' "$page" >"$work/page" && cat "$work/page" >"$page"
    done
    ;;
check)
    for row in "${rows[@]}"; do
        said=$(grep -F "$(cut -d '|' -f 1-3 <<<"$row")|" "$page" | tr -d ' ' || true)
        paste -d ' ' <(tr -d ' ' <<<"$row" | cut -d '|' -f 4-7 | tr '|' '\n') <(cut -d '|' -f 4-7 <<<"$said" | tr '|' '\n') |
            awk '{ off = $1 - $2; if (NF != 2 || off * off * 400 > $1 * $1) bad = 1 } END { exit bad }' ||
            { printf 'docs/microcontrollers.md says otherwise, see --write: %s\n' "$row" >&2; failed=true; }
    done
    ;;
esac
! $failed
