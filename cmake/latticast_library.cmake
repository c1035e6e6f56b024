# SPDX-License-Identifier: GPL-3.0-or-later
# What every target of this project shares: language level, warnings, include root.

set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_CXX_EXTENSIONS OFF)
find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

add_library(latticast_settings INTERFACE)
target_compile_features(latticast_settings INTERFACE cxx_std_20)
target_include_directories(latticast_settings INTERFACE "${CMAKE_SOURCE_DIR}")
target_compile_options(latticast_settings INTERFACE -Wall -Wextra -Wpedantic -Wshadow)
# g++ 12.2 drops the rounding of neighbouring double -> float -> double conversions when it vectorizes
# straight-line code; mesh files and their audit depend on that rounding.
target_compile_options(latticast_settings INTERFACE
                       $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
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

# latticast_library(NAME SOURCES ... LINKS ... PRIVATE ...)
#   LINKS:   targets of ours whose headers appear in this one's headers
#   PRIVATE: third-party targets, seen by this target's sources alone
function(latticast_library NAME)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE" ${ARGN})
  add_library(${NAME} STATIC ${ARG_SOURCES})
  target_link_libraries(${NAME} PUBLIC latticast_settings ${ARG_LINKS} PRIVATE ${ARG_PRIVATE})
endfunction()
