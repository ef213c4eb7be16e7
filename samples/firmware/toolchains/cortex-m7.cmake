# Cortex-M7 with the single-precision unit, as most have.
set(ISLET_CPU_FLAGS "-mcpu=cortex-m7 -mfloat-abi=hard -mfpu=fpv5-sp-d16")
set(ISLET_MACHINE mps2-an500)
set(ISLET_FLASH_ORIGIN 0x00000000)
set(ISLET_RAM_ORIGIN 0x20000000)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
