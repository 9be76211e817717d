# Run by the build: cmake -D GIT=... -D SOURCE=... -D TEMPLATE=... -D HEADER=... -P git_revision.cmake
# Writes HEADER only if the revision changed. "unknown" without git, and in a tree that is no checkout of its own:
# an unpacked archive inside another project's checkout must not be given that project's revision.
set(REVISION unknown)
set(ENV{GIT_OPTIONAL_LOCKS} 0)
if(GIT)
  execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse --show-toplevel
    OUTPUT_VARIABLE TOP RESULT_VARIABLE FAILED OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  file(REAL_PATH "${SOURCE}" SOURCE)
  if(NOT FAILED AND TOP STREQUAL SOURCE)
    execute_process(COMMAND ${GIT} -C ${SOURCE} describe --always --dirty --abbrev=12
      OUTPUT_VARIABLE DESCRIBED RESULT_VARIABLE FAILED OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(NOT FAILED AND DESCRIBED)
      set(REVISION ${DESCRIBED})
    endif()
  endif()
endif()
configure_file(${TEMPLATE} ${HEADER} @ONLY)
