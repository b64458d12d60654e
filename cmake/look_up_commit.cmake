# Writes HEADER from TEMPLATE with the commit of SOURCE_FOLDER. Where that is not a git checkout of its own (an unpacked
# archive, even inside somebody else's checkout), the commit that git wrote into the archive, else "unknown".
set(COMMIT "unknown")
file(READ "${SOURCE_FOLDER}/cmake/commit.txt" archived)
if(archived MATCHES "^([0-9a-f]+)")
  string(SUBSTRING "${CMAKE_MATCH_1}" 0 12 COMMIT)
endif()
find_program(GIT git)
if(GIT)
  execute_process(COMMAND "${GIT}" rev-parse --show-toplevel WORKING_DIRECTORY "${SOURCE_FOLDER}"
                  OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  get_filename_component(source "${SOURCE_FOLDER}" REALPATH)
  if(NOT failed AND top STREQUAL source)
    execute_process(COMMAND "${GIT}" describe --always --dirty --abbrev=12 "--exclude=*"
                    WORKING_DIRECTORY "${SOURCE_FOLDER}" OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE
                    ERROR_QUIET RESULT_VARIABLE failed)
    if(NOT failed)
      set(COMMIT "${described}")
    endif()
  endif()
endif()
configure_file("${TEMPLATE}" "${HEADER}" @ONLY)
