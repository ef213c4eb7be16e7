# Cortex-M4F: single-precision floating-point unit.
set(ISLET_CPU_FLAGS "-mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16")
set(ISLET_MACHINE mps2-an386)
set(ISLET_FLASH_ORIGIN 0x00000000)
set(ISLET_RAM_ORIGIN 0x20000000)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
