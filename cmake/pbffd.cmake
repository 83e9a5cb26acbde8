# What every target of the project shares: warnings, sanitizers, ccache, and the functions that add targets.

add_library(pbffd_options INTERFACE)
target_compile_features(pbffd_options INTERFACE cxx_std_20)
target_compile_options(pbffd_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
  -Wimplicit-fallthrough -Wextra-semi -Werror
  # The same bits on every processor: no multiply and add is contracted into one rounding.
  -ffp-contract=off)
target_include_directories(pbffd_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_definitions(pbffd_options INTERFACE QT_NO_KEYWORDS PBFFD_VERSION="${PROJECT_VERSION}")

if(PBFFD_SANITIZE)
  target_compile_options(pbffd_options INTERFACE -fsanitize=${PBFFD_SANITIZE} -fno-sanitize-recover=all
    -fno-omit-frame-pointer)
  target_link_options(pbffd_options INTERFACE -fsanitize=${PBFFD_SANITIZE})
endif()

find_program(PBFFD_CCACHE ccache)
if(PBFFD_CCACHE)
  # The sloppiness is what ccache needs to cache translation units with a precompiled header.
  set(launcher ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
    ${PBFFD_CCACHE})
  set(CMAKE_C_COMPILER_LAUNCHER ${launcher})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${launcher})
  add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess>)
endif()

# The headers of other libraries are not ours to warn about.
function(pbffd_link_system target)
  foreach(library IN LISTS ARGN)
    target_link_libraries(${target} PRIVATE ${library})
    get_target_property(includes ${library} INTERFACE_INCLUDE_DIRECTORIES)
    if(includes)
      target_include_directories(${target} SYSTEM PRIVATE ${includes})
    endif()
  endforeach()
endfunction()

# pbffd_add_library(NAME SOURCES... PUBLIC libraries... PRIVATE libraries...)
function(pbffd_add_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;PUBLIC;PRIVATE")
  add_library(${name} STATIC ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE pbffd_options PUBLIC ${arg_PUBLIC})
  pbffd_link_system(${name} ${arg_PRIVATE})
endfunction()
