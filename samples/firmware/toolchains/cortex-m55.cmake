# Cortex-M55 (Armv8.1-M), scalar floating point only: the vectoriser could use MVE, whose vectors flush denormal numbers to zero. The board starts
# in secure state, whose view of code and memory is 0x10000000 higher.
set(ISLET_CPU_FLAGS "-mcpu=cortex-m55+nomve -mfloat-abi=hard")
set(ISLET_MACHINE mps3-an547)
set(ISLET_FLASH_ORIGIN 0x10000000)
set(ISLET_RAM_ORIGIN 0x30000000)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
