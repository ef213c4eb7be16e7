# Cortex-M33 (Armv8-M). The board starts in secure state, whose view of code and memory is 0x10000000 higher.
set(ISLET_CPU_FLAGS "-mcpu=cortex-m33 -mfloat-abi=hard -mfpu=fpv5-sp-d16")
set(ISLET_MACHINE mps2-an505)
set(ISLET_FLASH_ORIGIN 0x10000000)
set(ISLET_RAM_ORIGIN 0x38000000)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
