# ringfilm_stamp(<target>): gives the target the header ringfilm_stamp.hpp with program, commit and compiler.
# The commit is looked up at each build, the header is only touched when it changed: one source is compiled again.
function(ringfilm_stamp target)
  set(folder "${CMAKE_BINARY_DIR}/stamp")
  set(compiler "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}")
  set(look_up "${CMAKE_COMMAND}"
      "-DSOURCE_FOLDER=${CMAKE_SOURCE_DIR}"
      "-DTEMPLATE=${CMAKE_SOURCE_DIR}/cmake/ringfilm_stamp.hpp.in"
      "-DHEADER=${folder}/ringfilm_stamp.hpp"
      "-DPROGRAM=${PROJECT_NAME} ${PROJECT_VERSION}"
      "-DCOMPILER=${compiler}, ${CMAKE_SYSTEM_PROCESSOR}, ${CMAKE_BUILD_TYPE}"
      -P "${CMAKE_SOURCE_DIR}/cmake/look_up_commit.cmake")
  add_custom_target(${target}_stamp COMMAND ${look_up} BYPRODUCTS "${folder}/ringfilm_stamp.hpp" VERBATIM
                    COMMENT "Looking up the commit")
  add_dependencies(${target} ${target}_stamp)
  target_include_directories(${target} PRIVATE "${folder}")
endfunction()
