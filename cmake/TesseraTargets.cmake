# What every target of the project shares: standard, warnings, output folders, and one function per kind of target.
include(CTest)
include(GoogleTest)
include(Precompiled)

option(TESSERA_BENCHMARKS "Build the benchmarks" ON)
option(TESSERA_WITH_QT "Build what needs Qt: serial port, charts, command line" ON)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
# With CMAKE_UNITY_BUILD, which every target takes up, the files of a target are compiled in one go (docs/decisions/0011-build-time.md).
set(CMAKE_UNITY_BUILD_BATCH_SIZE 0 CACHE STRING "Files of a target that are compiled in one go, 0: all")
# What looks for bytes that are taken for something wider and lie askew, for the folders that do so (the preset asan sets it).
set(TESSERA_ALIGNMENT "" CACHE STRING "Options of the folders that cast bytes to something wider")
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE RelWithDebInfo)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
endif()

# Ninety programs are linked in a tree: mold takes a fifth of the time. What is handed out is linked as Debian links.
find_program(MOLD_PROGRAM mold)
if(MOLD_PROGRAM AND CMAKE_CXX_COMPILER_ID STREQUAL GNU AND NOT CMAKE_BUILD_TYPE STREQUAL Release)
  add_link_options(-fuse-ld=mold)
endif()

add_library(tessera_options INTERFACE)
target_compile_options(tessera_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Woverloaded-virtual -Wundef -Werror)
# GCC 12 takes "text" + std::string for overlapping memory at -O3 (its bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(tessera_options INTERFACE $<$<CONFIG:Release>:-Wno-restrict>)
endif()

# tessera_library(NAME SOURCES ... [DEPS ...] [LIBS ...])
# One folder of core/ or firmware/ as one static library called tessera_NAME. DEPS are the folders that it may know
# (their names without the prefix); LIBS are outside libraries.
function(tessera_library NAME)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPS;LIBS" ${ARGN})
  set(target tessera_${NAME})
  if(ARG_SOURCES)
    add_library(${target} STATIC ${ARG_SOURCES})
    set(scope PUBLIC)
    target_link_libraries(${target} PRIVATE tessera_options)
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(${target} ${scope} "${PROJECT_SOURCE_DIR}/core" "${PROJECT_SOURCE_DIR}")
  foreach(dep IN LISTS ARG_DEPS)
    target_link_libraries(${target} ${scope} tessera_${dep})
  endforeach()
  target_link_libraries(${target} ${scope} ${ARG_LIBS})
endfunction()

# tessera_moc(TARGET)
# For a target with Q_OBJECT classes. CMake compiles moc's output apart from the rest, which reads Qt's headers once more for each target: in
# a unity tree it is one of the files that are compiled in one go.
function(tessera_moc TARGET)
  set_target_properties(${TARGET} PROPERTIES AUTOMOC ON)
  if(CMAKE_UNITY_BUILD)
    set(mocs "${TARGET}_autogen/mocs_compilation.cpp")
    set_source_files_properties("${CMAKE_CURRENT_BINARY_DIR}/${mocs}" PROPERTIES HEADER_FILE_ONLY ON)
    file(CONFIGURE OUTPUT "${TARGET}_mocs.cpp" CONTENT "#include \"${mocs}\"\n" @ONLY)
    set_source_files_properties("${CMAKE_CURRENT_BINARY_DIR}/${TARGET}_mocs.cpp" PROPERTIES SKIP_AUTOGEN ON)
    target_sources(${TARGET} PRIVATE "${CMAKE_CURRENT_BINARY_DIR}/${TARGET}_mocs.cpp")
    target_include_directories(${TARGET} PRIVATE "${CMAKE_CURRENT_BINARY_DIR}")
  endif()
endfunction()

add_custom_target(threaded_tests)

# tessera_test(NAME SOURCES ... [DEPS ...] [LIBS ...] [LABELS ...])
# A GoogleTest program whose cases ctest lists one by one. LABELS is one of unit (the default), scenario (closed loops,
# seconds long), window, qemu (needs the ELF and the emulator, runs in real time); threads beside it says that more than
# one thread runs in it, without Qt, which is what ThreadSanitizer is for.
function(tessera_test NAME)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPS;LIBS;LABELS" ${ARGN})
  add_executable(${NAME} ${ARG_SOURCES})
  set_target_properties(${NAME} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/tests")
  target_include_directories(${NAME} PRIVATE "${PROJECT_SOURCE_DIR}/tests" "${PROJECT_SOURCE_DIR}")
  foreach(dep IN LISTS ARG_DEPS)
    target_link_libraries(${NAME} PRIVATE tessera_${dep})
  endforeach()
  if(NOT ARG_LABELS)
    set(ARG_LABELS unit)
  endif()
  target_link_libraries(${NAME} PRIVATE tessera_options GTest::gtest GTest::gmock GTest::gtest_main ${ARG_LIBS})
  # What is tested is optimised; optimising the tests as well takes half as long again to compile.
  target_compile_options(${NAME} PRIVATE $<$<CONFIG:RelWithDebInfo>:-O0>)
  if("threads" IN_LIST ARG_LABELS)
    add_dependencies(threaded_tests ${NAME})
  endif()
  # An emulator needs the machine for itself: kept waiting, it sees wheels that do not turn. Other programs in real time
  # wait most of the time: one without a window and one with a window may run at a time. They take longest, so they come
  # first, and what is quick fills in.
  set(company RUN_SERIAL OFF)
  if("qemu" IN_LIST ARG_LABELS)
    set(company RUN_SERIAL ON)
  elseif("window" IN_LIST ARG_LABELS AND "system" IN_LIST ARG_LABELS)
    set(company RESOURCE_LOCK window_in_real_time COST 50)
  elseif("system" IN_LIST ARG_LABELS)
    set(company RESOURCE_LOCK real_time COST 50)
  endif()
  # Discovery hands the properties through several lists; so many backslashes bring a semicolon through all of them.
  # With fewer the second label would be taken for the next property's name, and what follows be lost with it.
  list(JOIN ARG_LABELS "\\\\\\\\\\\\\\;" labels)
  gtest_discover_tests(${NAME} DISCOVERY_MODE PRE_TEST PROPERTIES LABELS "${labels}" ${company})
endfunction()
