# RISC-V, 32 bits, with compressed instructions and no floating-point unit, as the ESP32-C3 has it.
set(architecture "-march=rv32imc -mabi=ilp32")
include(${CMAKE_CURRENT_LIST_DIR}/riscv32.cmake)
