# RISC-V, 32 bits, with compressed instructions and no floating-point unit, as the ESP32-C3 has it. The rest is as in riscv32.cmake.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR riscv32)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_CXX_COMPILER riscv64-unknown-elf-g++)
file(GLOB headers /usr/include/newlib/c++/*)
if(NOT headers)
    message(FATAL_ERROR "The C++ headers are missing: install libstdc++-arm-none-eabi-newlib")
endif()
set(CMAKE_CXX_FLAGS_INIT
    "-march=rv32imc -mabi=ilp32 -ffreestanding -isystem ${headers} -isystem ${headers}/arm-none-eabi"
    " -isystem /usr/lib/picolibc/riscv64-unknown-elf/include")
string(REPLACE ";" "" CMAKE_CXX_FLAGS_INIT "${CMAKE_CXX_FLAGS_INIT}")
set(CMAKE_CROSSCOMPILING_EMULATOR
    qemu-system-riscv32 -machine virt -bios none -icount shift=0 -display none -monitor none -serial none
    -semihosting-config enable=on,target=native -kernel)
set(ISLET_BOARD riscv)
set(ISLET_FLASH_ORIGIN 0x80000000)
set(ISLET_RAM_ORIGIN 0x80100000)
