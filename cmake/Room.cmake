# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause

# Nearly every source reads these headers, and compiling them costs more than the source itself:
# compiled once, they halve the time of a build. No header stands here that puts code into every
# object, as CLI11 would (a virtual class without a source of its own). A source includes what it
# uses all the same; the preset `tidy` builds without precompiled headers.
set(CVO_SLAM_COSTLY_HEADERS
    <Eigen/Cholesky>
    <Eigen/Core>
    <Eigen/Geometry>
    <Eigen/LU>
    <algorithm>
    <filesystem>
    <fmt/format.h>
    <functional>
    <opencv2/core.hpp>
    <string>
    <vector>)

# Keeps sources out of a unity build, in which several sources are compiled as one.
function(cvo_slam_compile_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# Sources that Google Highway compiles once for each instruction set. They include themselves; and
# in a debug build GCC 12 does not understand its own intrinsics behind a precompiled header.
function(cvo_slam_highway_sources)
  cvo_slam_compile_alone(${ARGN})
  set_source_files_properties(${ARGN} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
endfunction()

# Lets a target use the precompiled headers of the rooms. GCC reads them only into code that is
# position-independent in the same way: that of a library (-fPIC), also in a program.
function(cvo_slam_reuse_precompiled_headers TARGET)
  get_target_property(TYPE ${TARGET} TYPE)
  if(NOT TYPE STREQUAL EXECUTABLE)
    set_target_properties(${TARGET} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  elseif(CVO_SLAM_PRECOMPILE_HEADERS)
    target_compile_options(${TARGET} PRIVATE -fPIC)
  endif()
  if(CVO_SLAM_PRECOMPILE_HEADERS)
    target_precompile_headers(${TARGET} REUSE_FROM cvo_slam_core)
  endif()
endfunction()

# Compiles a target of a release build with -O1 instead of -O3. It is for code that takes no
# noticeable part of the running time; compiling it takes a quarter less. GCC follows fewer paths
# then, and takes more variables for uninitialised than are.
function(cvo_slam_compile_quickly TARGET)
  target_compile_options(${TARGET}
                         PRIVATE $<$<CONFIG:Release>:-O1>
                                 $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endfunction()

# Makes the headers of a top-level folder available as cvo_slam/<folder>/<file>.h in the build tree.
function(cvo_slam_link_folder FOLDER)
  set(LINK_DIR ${PROJECT_BINARY_DIR}/include/cvo_slam)
  file(MAKE_DIRECTORY ${LINK_DIR})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${FOLDER} ${LINK_DIR}/${FOLDER} SYMBOLIC)
endfunction()

# cvo_slam_room(<name> SOURCES ... PUBLIC_HEADERS ... [PUBLIC_LIBRARIES ...] [PRIVATE_LIBRARIES ...])
#
# One room = one library target cvo_slam::<name>. Includes are spelled cvo_slam/<room>/<file>.h in
# the tree and after installation alike: in the tree through a link <build>/include/cvo_slam/<room>.
# Only PUBLIC_HEADERS are installed; the others are named *_internal.h.
function(cvo_slam_room NAME)
  cmake_parse_arguments(ROOM "" "" "SOURCES;PUBLIC_HEADERS;PUBLIC_LIBRARIES;PRIVATE_LIBRARIES"
                        ${ARGN})
  cvo_slam_link_folder(${NAME})

  set(TARGET cvo_slam_${NAME})
  add_library(${TARGET} ${ROOM_SOURCES})
  add_library(cvo_slam::${NAME} ALIAS ${TARGET})
  set_target_properties(${TARGET} PROPERTIES EXPORT_NAME ${NAME} POSITION_INDEPENDENT_CODE ON)
  target_compile_features(${TARGET} PUBLIC cxx_std_20)
  target_link_libraries(
    ${TARGET}
    PUBLIC ${ROOM_PUBLIC_LIBRARIES}
    PRIVATE ${ROOM_PRIVATE_LIBRARIES} $<BUILD_INTERFACE:cvo_slam_settings>)
  target_include_directories(
    ${TARGET} PUBLIC $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
                     $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)

  if(NOT NAME STREQUAL core)
    cvo_slam_reuse_precompiled_headers(${TARGET})
  elseif(CVO_SLAM_PRECOMPILE_HEADERS)
    target_precompile_headers(${TARGET} PRIVATE ${CVO_SLAM_COSTLY_HEADERS})
  endif()

  if(CVO_SLAM_INSTALL)
    add_dependencies(cvo_slam_installed ${TARGET})
    install(TARGETS ${TARGET} EXPORT cvo_slam_targets)
    foreach(HEADER IN LISTS ROOM_PUBLIC_HEADERS)
      cmake_path(GET HEADER PARENT_PATH SUBFOLDER)
      install(FILES ${HEADER}
              DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/cvo_slam/${NAME}/${SUBFOLDER})
    endforeach()
  endif()
endfunction()
