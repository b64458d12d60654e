# Two ways to compile the project faster. The presets choose: docs/decisions/0013.
option(RINGFILM_PRECOMPILED_HEADERS "Compile the headers of other libraries once" OFF)

# ringfilm_headers(<target> <set> [headers...]): with RINGFILM_PRECOMPILED_HEADERS the headers of the standard library
# and these are compiled once for all targets with the same set. They must have the same options.
function(ringfilm_headers target set)
  if(NOT RINGFILM_PRECOMPILED_HEADERS)
    return()
  endif()
  set(owner ringfilm_headers_${set})
  if(NOT TARGET ${owner})
    ringfilm_header_set(${owner} ${target} ${ARGN})
  endif()
  target_precompile_headers(${target} REUSE_FROM ${owner})
  # GCC 12 does not recognize the headers of the system in a precompiled header and warns of those of std::string.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds -Wno-restrict
                                                                    -Wno-stringop-overflow -Wno-stringop-overread>)
endfunction()

# The target that precompiles headers, with the options and the other libraries of <like>.
function(ringfilm_header_set owner like)
  file(WRITE "${CMAKE_BINARY_DIR}/headers/${owner}.cpp" "// All that is compiled here are headers.\n")
  add_library(${owner} OBJECT "${CMAKE_BINARY_DIR}/headers/${owner}.cpp")
  get_target_property(options ${like} COMPILE_OPTIONS)
  target_compile_options(${owner} PRIVATE ${options})
  get_target_property(type ${like} TYPE)
  if(type STREQUAL EXECUTABLE)  # its position-independent code is of another kind than that of libraries
    set_target_properties(${owner} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
    target_compile_options(${owner} PRIVATE -fPIE)
  endif()
  get_target_property(visibility ${like} CXX_VISIBILITY_PRESET)
  if(visibility)
    set_target_properties(${owner} PROPERTIES CXX_VISIBILITY_PRESET ${visibility})
  endif()
  get_target_property(libraries ${like} LINK_LIBRARIES)
  list(FILTER libraries EXCLUDE REGEX "^ringfilm_")
  target_link_libraries(${owner} PRIVATE ${libraries})
  target_precompile_headers(${owner} PRIVATE <algorithm> <array> <charconv> <cmath> <cstddef> <cstdint> <cstdio>
    <cstring> <functional> <iterator> <limits> <map> <memory> <numbers> <numeric> <optional> <set> <span> <stdexcept>
    <string> <string_view> <tuple> <utility> <variant> <vector> ${ARGN})
endfunction()

# ringfilm_by_folder(<target>): with CMAKE_UNITY_BUILD the sources of a folder are compiled as one, but not those with
# options of their own.
function(ringfilm_by_folder target)
  if(NOT CMAKE_UNITY_BUILD)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(folder "${source}" DIRECTORY)
    file(RELATIVE_PATH folder "${CMAKE_SOURCE_DIR}" "${folder}")
    string(MAKE_C_IDENTIFIER "${folder}" group)
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP ${group})
  endforeach()
endfunction()
