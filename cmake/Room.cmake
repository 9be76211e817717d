# What all code of the project is compiled with. Bits must not depend on the compiler's mood:
# no contraction to FMA but where written out, no reassociation.
add_library(cracksim_flags INTERFACE)
target_include_directories(cracksim_flags INTERFACE ${CMAKE_SOURCE_DIR}/src ${CMAKE_SOURCE_DIR})
target_compile_options(cracksim_flags INTERFACE
  -ffp-contract=off -fno-math-errno -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast)
# GCC 12 sees overlapping copies in std::string's operator+ where there are none (its bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(cracksim_flags INTERFACE -Wno-restrict)
endif()
target_compile_definitions(cracksim_flags INTERFACE $<$<BOOL:${CRACKSIM_CONTRACTS}>:CRACKSIM_CONTRACTS>)
# Other compilers know other warnings; a user's first build must not fail on them.
if(CRACKSIM_WERROR AND CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(cracksim_flags INTERFACE -Werror)
endif()
if(CRACKSIM_SANITIZE)
  target_compile_options(cracksim_flags INTERFACE
    -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(cracksim_flags INTERFACE -fsanitize=address,undefined)
endif()

# cracksim_room(NAME SOURCES ... [UPSTREAM rooms whose headers it sees] [LIBRARIES outside libraries of this room])
function(cracksim_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;UPSTREAM;LIBRARIES" ${ARGN})
  add_library(cracksim_${name} STATIC ${ROOM_SOURCES})
  target_link_libraries(cracksim_${name} PUBLIC cracksim_flags)
  foreach(upstream IN LISTS ROOM_UPSTREAM)
    target_link_libraries(cracksim_${name} PUBLIC cracksim_${upstream})
  endforeach()
  target_link_libraries(cracksim_${name} PUBLIC ${ROOM_LIBRARIES})
endfunction()
