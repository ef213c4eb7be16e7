# What the Cortex-M toolchains share: Debian's gcc-arm-none-eabi and libstdc++-arm-none-eabi-newlib, of which only headers are used. Each of them sets
# ISLET_CPU_FLAGS, ISLET_MACHINE (a QEMU board with that processor), and where that board has its code and its memory.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_C_FLAGS_INIT "${ISLET_CPU_FLAGS} -mthumb -ffreestanding")
set(CMAKE_CXX_FLAGS_INIT "${CMAKE_C_FLAGS_INIT}")
set(CMAKE_CROSSCOMPILING_EMULATOR
    qemu-system-arm -machine ${ISLET_MACHINE} -icount shift=0 -display none -monitor none -serial none -semihosting-config enable=on,target=native
    -kernel)
set(ISLET_BOARD cortex_m)
