# Cortex-M3: no floating-point unit, so the compiler's soft float computes.
set(ISLET_CPU_FLAGS "-mcpu=cortex-m3 -mfloat-abi=soft")
set(ISLET_MACHINE mps2-an385)
set(ISLET_FLASH_ORIGIN 0x00000000)
set(ISLET_RAM_ORIGIN 0x20000000)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
