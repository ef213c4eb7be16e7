# RISC-V, 32 bits, with single-precision floating point: Debian's gcc-riscv64-unknown-elf and picolibc-riscv64-unknown-elf. There is no C++ library
# for it; the header-only parts of the Arm one serve.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR riscv32)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_CXX_COMPILER riscv64-unknown-elf-g++)
file(GLOB headers /usr/include/newlib/c++/*)
if(NOT headers)
    message(FATAL_ERROR "The C++ headers are missing: install libstdc++-arm-none-eabi-newlib")
endif()
if(NOT architecture)  # riscv32imc.cmake sets its own
    set(architecture "-march=rv32imafc -mabi=ilp32f")
endif()
set(CMAKE_CXX_FLAGS_INIT
    "${architecture} -ffreestanding -isystem ${headers} -isystem ${headers}/arm-none-eabi"
    " -isystem /usr/lib/picolibc/riscv64-unknown-elf/include")
string(REPLACE ";" "" CMAKE_CXX_FLAGS_INIT "${CMAKE_CXX_FLAGS_INIT}")
set(CMAKE_CROSSCOMPILING_EMULATOR
    qemu-system-riscv32 -machine virt -bios none -icount shift=0 -display none -monitor none -serial none
    -semihosting-config enable=on,target=native -kernel)
set(ISLET_BOARD riscv)
set(ISLET_FLASH_ORIGIN 0x80000000)
set(ISLET_RAM_ORIGIN 0x80100000)
