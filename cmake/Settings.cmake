# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Compiler settings that every target of the project shares, as one interface target.

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

set(CMAKE_CXX_EXTENSIONS OFF)
add_library(cvo_slam_settings INTERFACE)
target_compile_features(cvo_slam_settings INTERFACE cxx_std_20)
# No -march and no -ffast-math: results have the same bytes on every machine, and Eigen's alignment
# is the one of the embedder. Contraction is off so that a compiler with FMA does not round
# differently.
target_compile_options(cvo_slam_settings INTERFACE -ffp-contract=off)
# Nothing here asks for floating-point traps, which keep GCC from vectorising what a comparison
# selects. Values stay the same.
target_compile_options(cvo_slam_settings INTERFACE -fno-trapping-math)
# Without this GCC does not inline a library's own functions in position-independent code.
target_compile_options(cvo_slam_settings INTERFACE -fno-semantic-interposition)
# What oneTBB's target defines in a debug build, in every source, so that all can share one
# precompiled header.
target_compile_definitions(cvo_slam_settings INTERFACE $<$<CONFIG:Debug>:TBB_USE_DEBUG>)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # Lets ccache see the content of a precompiled header.
  target_compile_options(cvo_slam_settings INTERFACE -fpch-preprocess)
endif()
if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # In a unity build GCC takes each source for a header.
  target_compile_options(cvo_slam_settings INTERFACE -Wno-subobject-linkage)
endif()
if(PROJECT_IS_TOP_LEVEL)
  target_compile_options(cvo_slam_settings INTERFACE -Wall -Wextra -Wconversion -Wshadow)
endif()
if(CVO_SLAM_WERROR)
  target_compile_options(cvo_slam_settings INTERFACE -Werror)
endif()
if(CVO_SLAM_SANITIZE)
  # Instrumented code hides from GCC which variables are initialised (see -fsanitize in its manual).
  target_compile_options(
    cvo_slam_settings INTERFACE -fsanitize=${CVO_SLAM_SANITIZE} -fno-omit-frame-pointer
                                $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(cvo_slam_settings INTERFACE -fsanitize=${CVO_SLAM_SANITIZE})
endif()
