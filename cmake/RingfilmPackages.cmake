# What cpack makes of the components: ringfilm, libringfilm-dev and, unless RINGFILM_PYTHON is off, python3-ringfilm as
# .deb. script/package calls it, and makes the archives.
set(CPACK_PACKAGE_NAME ringfilm)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_VENDOR "The ringfilm authors")
set(CPACK_PACKAGE_CONTACT "The ringfilm authors <ringfilm@ringfilm.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE "${CMAKE_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_SOURCE_GENERATOR TGZ)
set(CPACK_SOURCE_IGNORE_FILES "/build/;/build-[^/]*/;/[.]git/;__pycache__;/node_modules/")

set(components program library)
get_cmake_property(known COMPONENTS)
if(python IN_LIST known)
  list(APPEND components python)
elseif(RINGFILM_PYTHON)
  message(FATAL_ERROR "python3-ringfilm cannot be made: pybind11-dev or python3-dev is missing.\n"
                      "script/bootstrap --python installs both; -DRINGFILM_PYTHON=OFF makes the other packages alone")
endif()
set(CPACK_COMPONENTS_ALL ${components})

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME ringfilm)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
"Friction, oil film and oil flow of a piston ring over the engine cycle: the
transient Reynolds equation along the face of the ring, or around the whole
ring, with the contact of rough surfaces and the balance of the ring, integrated
over crank angle until it repeats. One case file in, one result file and one
web page out.
.
This package holds the program, the cases that come with it, its oils, its
verifications, and a reader of result files for MATLAB and Octave.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "gwyddion, octave-netcdf, python3-ringfilm")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libringfilm-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION
"The C++ library: headers, static libraries, and the files by which CMake and
pkg-config find them, for programs that compute cycles, batches and studies
themselves, or bring an oil law of their own.")
# The cases and data that it finds at run time are those of the program.
string(CONCAT CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS
    "libboost-dev (>= 1.74), libfmt-dev, libnetcdf-dev, libnlopt-dev, libpugixml-dev, libssl-dev, libtomlplusplus-dev, "
    "libudunits2-dev, libzip-dev, nlohmann-json3-dev, zlib1g-dev")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_RECOMMENDS "ringfilm (= ${PROJECT_VERSION}-1), cmake, pkg-config")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-ringfilm)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION
"The Python module: cases, cycles, batches, studies and measured surfaces at
home in numpy, xarray and pandas; python3 -m ringfilm is the command line.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
# Built for one version of Python, the system's.
set(print_versions "import sys; n = sys.version_info[1]; print('python3 (>= 3.%d), python3 (<< 3.%d)' % (n, n + 1))")
execute_process(COMMAND /usr/bin/python3 -c "${print_versions}"
                OUTPUT_VARIABLE python_versions OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "ringfilm (= ${PROJECT_VERSION}-1), ${python_versions}, python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-xarray, python3-netcdf4, python3-pandas, python3-matplotlib")

# Each package carries its licence and what changed.
find_program(GZIP gzip REQUIRED)
set(papers "${CMAKE_BINARY_DIR}/package")
file(READ "${CMAKE_SOURCE_DIR}/NOTICE" notice)
file(WRITE "${papers}/copyright" "${notice}
On Debian systems the text of the licence is in /usr/share/common-licenses/Apache-2.0.
")
configure_file("${CMAKE_SOURCE_DIR}/CHANGELOG.md" "${papers}/changelog" COPYONLY)
execute_process(COMMAND "${GZIP}" -9nc "${papers}/changelog" OUTPUT_FILE "${papers}/changelog.gz"
                COMMAND_ERROR_IS_FATAL ANY)
foreach(component IN LISTS components)
  string(TOUPPER ${component} upper)
  install(FILES "${papers}/copyright" "${papers}/changelog.gz"
          DESTINATION "share/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME}" COMPONENT ${component})
endforeach()

# The program once more, with the libraries that it needs in a folder beside it: for systems without their packages.
# DT_RPATH, not DT_RUNPATH: these libraries find one another by it, too.
add_executable(ringfilm_portable $<TARGET_OBJECTS:ringfilm>)
find_package(CLI11 REQUIRED)
get_target_property(links ringfilm LINK_LIBRARIES)
target_link_libraries(ringfilm_portable PRIVATE ${links})
target_link_options(ringfilm_portable PRIVATE -Wl,--disable-new-dtags)
set_target_properties(ringfilm_portable PROPERTIES OUTPUT_NAME ringfilm
  RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/portable" BUILD_WITH_INSTALL_RPATH ON
  INSTALL_RPATH "\$ORIGIN/../lib/ringfilm")
install(TARGETS ringfilm_portable RUNTIME_DEPENDENCY_SET portable DESTINATION bin COMPONENT portable EXCLUDE_FROM_ALL)
# What belongs to the system and not to a program stays with it: the C library and its loader.
install(RUNTIME_DEPENDENCY_SET portable DESTINATION lib/ringfilm COMPONENT portable EXCLUDE_FROM_ALL
        PRE_EXCLUDE_REGEXES "^(ld-linux.*|libc|libm|libdl|librt|libpthread|libresolv)[.]so")
ringfilm_install_shared_data(portable EXCLUDE_FROM_ALL)
find_path(UDUNITS2_TABLE udunits2.xml PATHS /usr/share/xml/udunits /usr/share/udunits NO_DEFAULT_PATH REQUIRED)
install(DIRECTORY "${UDUNITS2_TABLE}/" DESTINATION share/ringfilm/udunits COMPONENT portable EXCLUDE_FROM_ALL
        FILES_MATCHING PATTERN "udunits2*.xml")
install(FILES LICENSE NOTICE README.md CHANGELOG.md DESTINATION share/doc/ringfilm COMPONENT portable EXCLUDE_FROM_ALL)

include(CPack)
