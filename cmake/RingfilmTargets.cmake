# ringfilm_library(<folder> [libraries...]): the static library ringfilm_<folder> of all sources in
# src/ringfilm/<folder>.
# A name of another folder stands for its library.
function(ringfilm_library folder)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/src/ringfilm/${folder}/*.cpp")
  set(target ringfilm_${folder})
  if(sources)
    add_library(${target} STATIC ${sources})
    set(scope PUBLIC)
    ringfilm_warnings(${target})
    ringfilm_by_folder(${target})
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(${target} ${scope} "$<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/src>"
                                               "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${folder})
  set_property(GLOBAL APPEND PROPERTY RINGFILM_LIBRARIES ${target})
  foreach(library IN LISTS ARGN)
    if(TARGET ringfilm_${library})
      target_link_libraries(${target} ${scope} ringfilm_${library})
    else()
      target_link_libraries(${target} ${scope} ${library})
    endif()
  endforeach()
endfunction()

function(ringfilm_warnings target)
  # -ffp-contract=off: the same case gives the same bits with and without fused multiply-add.
  # -fno-semantic-interposition: nobody replaces our functions one by one, so they may be inlined in spite of -fPIC.
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                                           -ffp-contract=off -fno-semantic-interposition
                                           $<$<BOOL:${RINGFILM_WERROR}>:-Werror>)
endfunction()

# ringfilm_compiled_fast(<target> [option]): for code that reads, writes and prints, but computes nothing: compiled
# quickly rather than for speed, with -O1 or that option.
function(ringfilm_compiled_fast target)
  set(option -O1)
  if(ARGC GREATER 1)
    set(option ${ARGV1})
  endif()
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${option}>)
endfunction()

# ringfilm_unit_tests(<folder> [libraries...]): the program unit_<folder> of tests/unit/<folder>/*.cpp, of which there
# must be one.
function(ringfilm_unit_tests folder)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/tests/unit/${folder}/*.cpp")
  if(NOT sources)
    message(FATAL_ERROR "tests/unit/${folder} holds no *.cpp: write a test, or take ${folder} off tests/CMakeLists.txt")
  endif()
  ringfilm_test_program(unit_${folder} "${sources}" ringfilm_${folder} ${ARGN})
endfunction()

function(ringfilm_test_program target sources)
  add_executable(${target} ${sources})
  ringfilm_warnings(${target})
  ringfilm_compiled_fast(${target} -Og)  # what is tested is compiled in full
  target_link_libraries(${target} PRIVATE ${ARGN} GTest::gtest_main GTest::gmock)
  ringfilm_headers(${target} tests <filesystem> <fstream> <sstream> <gtest/gtest.h> <gmock/gmock.h>)
  target_compile_definitions(${target} PRIVATE RINGFILM_SOURCE_FOLDER="${CMAKE_SOURCE_DIR}")
  gtest_discover_tests(${target} DISCOVERY_TIMEOUT 60)
endfunction()

# ringfilm_film_kernels(): the inner loops of the film, across and around.
function(ringfilm_film_kernels)
  ringfilm_instruction_sets("${CMAKE_SOURCE_DIR}/src/ringfilm/film/kernels/kernels")
  ringfilm_instruction_sets("${CMAKE_SOURCE_DIR}/src/ringfilm/film/kernels/film2d_kernels")
endfunction()

# ringfilm_instruction_sets(<stem>): compiles <stem>_avx2.cpp and <stem>_avx512.cpp, each for the kind of machine in its
# name, and defines RINGFILM_X86_KERNELS for <stem>.cpp where they exist. Only in these two may products be fused with
# sums: the numbers of one kind of machine are always the same.
function(ringfilm_instruction_sets stem)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
    set_source_files_properties("${stem}_avx2.cpp" "${stem}_avx512.cpp" PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    set_source_files_properties("${stem}_avx2.cpp" PROPERTIES COMPILE_OPTIONS "-mavx2;-mfma;-ffp-contract=fast")
    set_source_files_properties("${stem}_avx512.cpp" PROPERTIES
      COMPILE_OPTIONS "-mavx2;-mfma;-mavx512f;-mavx512dq;-mavx512vl;-ffp-contract=fast")
    set_source_files_properties("${stem}.cpp" PROPERTIES COMPILE_DEFINITIONS RINGFILM_X86_KERNELS)
  else()
    set_source_files_properties("${stem}_avx2.cpp" "${stem}_avx512.cpp" PROPERTIES HEADER_FILE_ONLY TRUE)
  endif()
endfunction()
