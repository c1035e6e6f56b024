# SPDX-License-Identifier: GPL-3.0-or-later
# What every target of this project shares: language level, warnings, include root.

set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_CXX_EXTENSIONS OFF)
option(CMAKE_DISABLE_PRECOMPILE_HEADERS "Compile the standard headers anew for each source" ON)
find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
  # Without these two liberties ccache stores nothing that uses a precompiled header.
  if(NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
    list(PREPEND CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_SLOPPINESS=pch_defines,time_macros)
  endif()
endif()

add_library(latticast_settings INTERFACE)
target_compile_features(latticast_settings INTERFACE cxx_std_20)
target_include_directories(latticast_settings INTERFACE "${CMAKE_SOURCE_DIR}")
target_compile_options(latticast_settings INTERFACE -Wall -Wextra -Wpedantic)
# Sources compiled together share their private names; two that clash do not compile, one that hides another is harmless.
if(CMAKE_UNITY_BUILD)
  target_compile_options(latticast_settings INTERFACE -Wno-subobject-linkage)
else()
  target_compile_options(latticast_settings INTERFACE -Wshadow)
endif()
# g++ 12.2 drops the rounding of neighbouring double -> float -> double conversions when it vectorizes
# straight-line code; mesh files and their audit depend on that rounding.
target_compile_options(latticast_settings INTERFACE
                       $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
# A cached precompiled header is as good as a new one.
target_compile_options(latticast_settings INTERFACE
                       "SHELL:$<$<CXX_COMPILER_ID:Clang>:-Xclang -fno-pch-timestamp>")
if(LATTICAST_WARNINGS_AS_ERRORS)
  target_compile_options(latticast_settings INTERFACE -Werror)
endif()
if(LATTICAST_SANITIZE)
  target_compile_options(latticast_settings INTERFACE -fsanitize=address,undefined
                         -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  target_link_options(latticast_settings INTERFACE -fsanitize=address,undefined)
endif()

if(LATTICAST_FUZZ)
  target_compile_options(latticast_settings INTERFACE -fsanitize=fuzzer-no-link)
endif()

# The standard library's headers, compiled once for all targets: they were most of what a small source cost. Sources
# include what they use all the same. Off unless CMAKE_DISABLE_PRECOMPILE_HEADERS=OFF asks for it: clang-tidy cannot
# read g++'s precompiled header. Third-party headers stay out, so that only their sources see them and settings like
# FMT_SHARED may differ between targets.
file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/standard_headers.cpp" CONTENT "" @ONLY)
add_library(latticast_standard_headers OBJECT EXCLUDE_FROM_ALL "${CMAKE_BINARY_DIR}/standard_headers.cpp")
target_link_libraries(latticast_standard_headers PRIVATE latticast_settings)
target_precompile_headers(latticast_standard_headers PRIVATE
  <algorithm> <array> <charconv> <cmath> <cstddef> <cstdint> <filesystem> <functional> <limits> <map> <memory> <numbers>
  <numeric> <optional> <set> <span> <stdexcept> <string> <string_view> <utility> <variant> <vector>)

# latticast_rooms(TARGET SOURCE...): with CMAKE_UNITY_BUILD=ON, the sources of one folder compile as one: what they all
# include is read once. Their private names must therefore differ. Off for daily work, where one source changes at a time
# and clang-tidy wants each alone.
function(latticast_rooms TARGET)
  set_target_properties(${TARGET} PROPERTIES UNITY_BUILD_MODE GROUP)
  foreach(SOURCE ${ARGN})
    if(IS_ABSOLUTE "${SOURCE}") # generated
      continue()
    endif()
    get_filename_component(FOLDER "${SOURCE}" DIRECTORY)
    string(MAKE_C_IDENTIFIER "room_${FOLDER}" ROOM)
    set_source_files_properties("${SOURCE}" PROPERTIES UNITY_GROUP ${ROOM})
  endforeach()
endfunction()

# latticast_room(NAME SOURCE...): these sources of a target compile as one, apart from the rest of their folder. For those
# that share a heavy library and see few of our headers, and for those that the same headers reach.
function(latticast_room NAME)
  set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP "room_${NAME}")
endfunction()

# latticast_library(NAME SOURCES ... LINKS ... PRIVATE ...)
#   LINKS:   targets of ours whose headers appear in this one's headers
#   PRIVATE: third-party targets, seen by this target's sources alone
function(latticast_library NAME)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE" ${ARGN})
  add_library(${NAME} STATIC ${ARG_SOURCES})
  latticast_rooms(${NAME} ${ARG_SOURCES})
  target_link_libraries(${NAME} PUBLIC latticast_settings ${ARG_LINKS} PRIVATE ${ARG_PRIVATE})
  target_precompile_headers(${NAME} REUSE_FROM latticast_standard_headers)
endfunction()
