# The firmware's ELF files for the LM3S6965 in bin/: a build within the build, as it needs another compiler.
# Target tessera-firmware; it looks at its sources on every build and does nothing when they stand still.
include(ExternalProject)

ExternalProject_Add(tessera-firmware
  SOURCE_DIR "${PROJECT_SOURCE_DIR}/firmware/boards/lm3s6965"
  BINARY_DIR "${CMAKE_BINARY_DIR}/arm"
  PREFIX "${CMAKE_BINARY_DIR}/arm/external"
  CMAKE_ARGS
    "-DCMAKE_TOOLCHAIN_FILE=${PROJECT_SOURCE_DIR}/cmake/arm-none-eabi.cmake"
    "-DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}"
    "-DTESSERA_ELF_DIRECTORY=${CMAKE_RUNTIME_OUTPUT_DIRECTORY}"
  BUILD_ALWAYS ON
  INSTALL_COMMAND "")
