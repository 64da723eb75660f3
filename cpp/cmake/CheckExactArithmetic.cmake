# Ends the configuration where the flags given change the map's bits: compiles
# src/exact_arithmetic.cpp with them and runs it. The same check runs when the
# program starts.

set(OCCGRID_SSE "")
include(CheckCXXSourceCompiles)
# 32-bit x86 has extended precision unless asked for less.
check_cxx_source_compiles("
#if !defined(__i386__)
#error not 32-bit x86
#endif
int main() {}" OCCGRID_IS_32_BIT_X86)
if(OCCGRID_IS_32_BIT_X86)
  set(OCCGRID_SSE -msse2 -mfpmath=sse)
endif()

# Asked again whenever the flags or the compiler are others.
string(TOUPPER "${CMAKE_BUILD_TYPE}" occgrid_config)
string(MD5 occgrid_flags "${CMAKE_CXX_COMPILER} ${CMAKE_CXX_FLAGS} \
${CMAKE_CXX_FLAGS_${occgrid_config}} ${CMAKE_EXE_LINKER_FLAGS}")
set(occgrid_runs OCCGRID_RUNS_${occgrid_flags})
set(occgrid_compiles OCCGRID_COMPILES_${occgrid_flags})

if(NOT DEFINED ${occgrid_compiles})
  message(STATUS "Checking that the flags keep the map's bits")
  set(CMAKE_TRY_COMPILE_CONFIGURATION "${CMAKE_BUILD_TYPE}")
  # In one file: several need a newer CMake.
  file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/exact_arithmetic_check.cpp" "
#include \"${CMAKE_CURRENT_LIST_DIR}/../src/exact_arithmetic.cpp\"
#include \"${CMAKE_CURRENT_LIST_DIR}/../src/portable_math.cpp\"
int main() {
  try {
    occgrid::require_exact_arithmetic();
    return 0;
  } catch (...) {
    return 1;
  }
}
")
  if(CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
    # What runs elsewhere is checked there, at the start of the program.
    set(${occgrid_runs} 0 CACHE INTERNAL "")
    try_compile(${occgrid_compiles} "${CMAKE_CURRENT_BINARY_DIR}/check"
      "${CMAKE_CURRENT_BINARY_DIR}/exact_arithmetic_check.cpp"
      CMAKE_FLAGS
        "-DINCLUDE_DIRECTORIES=${CMAKE_CURRENT_LIST_DIR}/../include"
        "-DCMAKE_CXX_STANDARD=17"
      COMPILE_DEFINITIONS -ffp-contract=off ${OCCGRID_SSE}
      OUTPUT_VARIABLE occgrid_output)
  else()
    try_run(${occgrid_runs} ${occgrid_compiles}
      "${CMAKE_CURRENT_BINARY_DIR}/check"
      "${CMAKE_CURRENT_BINARY_DIR}/exact_arithmetic_check.cpp"
      CMAKE_FLAGS
        "-DINCLUDE_DIRECTORIES=${CMAKE_CURRENT_LIST_DIR}/../include"
        "-DCMAKE_CXX_STANDARD=17"
      COMPILE_DEFINITIONS -ffp-contract=off ${OCCGRID_SSE}
      COMPILE_OUTPUT_VARIABLE occgrid_output)
  endif()
  if(NOT ${occgrid_compiles})
    message(STATUS "${occgrid_output}")
  endif()
endif()

if(NOT ${occgrid_compiles} OR NOT "${${occgrid_runs}}" STREQUAL "0")
  message(FATAL_ERROR
    "occgrid: the compiler's flags change the map's bits, or it cannot "
    "compile. Leave out -ffast-math, -funsafe-math-optimizations, -Ofast and "
    "their like. The flags are: ${CMAKE_CXX_FLAGS} "
    "${CMAKE_CXX_FLAGS_${occgrid_config}}")
endif()
