# What `cmake --install` puts where, in components: program, library (and python, which its own folder adds); portable
# is the program with the libraries that it needs beside it, made by script/package and by nothing else.

# ringfilm_install_program(): bin/ringfilm, and share/ringfilm with the cases, data and verifications that it finds from
# its own place.
function(ringfilm_install_program)
  install(TARGETS ringfilm RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT program)
  ringfilm_install_shared_data(program)
endfunction()

function(ringfilm_install_shared_data component)
  install(DIRECTORY "${CMAKE_SOURCE_DIR}/cases" "${CMAKE_SOURCE_DIR}/data" "${CMAKE_SOURCE_DIR}/verification"
          DESTINATION "${CMAKE_INSTALL_DATADIR}/ringfilm" COMPONENT ${component} ${ARGN}
          PATTERN "__pycache__" EXCLUDE)
  install(FILES "${CMAKE_SOURCE_DIR}/matlab/ringfilm_read.m"
          DESTINATION "${CMAKE_INSTALL_DATADIR}/ringfilm/matlab" COMPONENT ${component} ${ARGN})
  install(FILES "${CMAKE_SOURCE_DIR}/docs/references.bib"
          DESTINATION "${CMAKE_INSTALL_DATADIR}/ringfilm/docs" COMPONENT ${component} ${ARGN})
endfunction()

# ringfilm_install_library(): the static libraries, the headers that ringfilm/ringfilm.hpp leads to, and what finds
# them: find_package(ringfilm) with the target ringfilm::ringfilm, and pkg-config ringfilm.
function(ringfilm_install_library)
  get_property(libraries GLOBAL PROPERTY RINGFILM_LIBRARIES)
  add_library(ringfilm_public INTERFACE)
  target_link_libraries(ringfilm_public INTERFACE ringfilm_run ringfilm_report ringfilm_instrument)
  target_compile_features(ringfilm_public INTERFACE cxx_std_20)
  set_target_properties(ringfilm_public PROPERTIES EXPORT_NAME ringfilm)

  set(package "${CMAKE_INSTALL_LIBDIR}/cmake/ringfilm")
  install(TARGETS ${libraries} ringfilm_public EXPORT ringfilmTargets
          ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT library)
  install(EXPORT ringfilmTargets NAMESPACE ringfilm:: DESTINATION "${package}" COMPONENT library)
  configure_package_config_file("${CMAKE_SOURCE_DIR}/cmake/ringfilmConfig.cmake.in"
                                "${CMAKE_BINARY_DIR}/package/ringfilmConfig.cmake" INSTALL_DESTINATION "${package}")
  # Until 1.0 names may change with the second number.
  write_basic_package_version_file("${CMAKE_BINARY_DIR}/package/ringfilmConfigVersion.cmake"
                                   COMPATIBILITY SameMinorVersion)
  install(FILES "${CMAKE_BINARY_DIR}/package/ringfilmConfig.cmake"
                "${CMAKE_BINARY_DIR}/package/ringfilmConfigVersion.cmake"
          DESTINATION "${package}" COMPONENT library)

  # A static library comes before those that it uses.
  set(RINGFILM_LINK_FLAGS "")
  foreach(library IN LISTS libraries)
    get_target_property(kind ${library} TYPE)
    if(kind STREQUAL "STATIC_LIBRARY")
      string(PREPEND RINGFILM_LINK_FLAGS "-l${library} ")
    endif()
  endforeach()
  file(RELATIVE_PATH RINGFILM_PREFIX "/at/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/at")
  configure_file("${CMAKE_SOURCE_DIR}/cmake/ringfilm.pc.in" "${CMAKE_BINARY_DIR}/package/ringfilm.pc" @ONLY)
  install(FILES "${CMAKE_BINARY_DIR}/package/ringfilm.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig"
          COMPONENT library)

  # Looked up when it is installed: an edited header does not configure anew.
  install(CODE "set(RINGFILM_SOURCES \"${CMAKE_SOURCE_DIR}/src\")
set(RINGFILM_HEADER_FOLDER \"${CMAKE_INSTALL_INCLUDEDIR}\")" COMPONENT library)
  install(SCRIPT "${CMAKE_SOURCE_DIR}/cmake/install_headers.cmake" COMPONENT library)
endfunction()

include(CMakePackageConfigHelpers)
