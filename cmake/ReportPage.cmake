# ringfilm_report_page(<target>): bundles src/ringfilm/report/page into one HTML template with esbuild and compiles it
# into
# <target>. Packages are fetched once, locked, into the build folder; nothing of them is kept in the source tree. Those
# that format, check and test the page only where tests are built.
function(ringfilm_report_page target)
  find_program(NODE_PROGRAM NAMES node nodejs REQUIRED)
  find_program(NPM_PROGRAM NAMES npm REQUIRED)
  set(page "${CMAKE_SOURCE_DIR}/src/ringfilm/report/page")
  set(work "${CMAKE_BINARY_DIR}/report_page")
  set(generated "${work}/page_template.cpp")
  set(tools "")
  if(RINGFILM_TESTS)
    set(tools --with-tools)
  endif()
  file(GLOB_RECURSE page_sources CONFIGURE_DEPENDS "${page}/src/*.js" "${page}/src/*.css")

  add_custom_command(
    OUTPUT "${work}/packages.stamp"
    COMMAND "${NODE_PROGRAM}" "${page}/install.mjs" "${work}" ${tools}
    COMMAND "${CMAKE_COMMAND}" -E touch "${work}/packages.stamp"
    DEPENDS "${page}/install.mjs" "${page}/package.json" "${page}/package-lock.json" "${page}/.npmrc"
    COMMENT "Packages of the report page"
    VERBATIM)
  add_custom_command(
    OUTPUT "${generated}"
    COMMAND "${NODE_PROGRAM}" "${page}/bundle.mjs" "${work}" "${generated}"
    DEPENDS "${work}/packages.stamp" "${page}/bundle.mjs" "${page}/template.html" ${page_sources}
    COMMENT "Bundling the report page"
    VERBATIM)
  target_sources(${target} PRIVATE "${generated}")
endfunction()
