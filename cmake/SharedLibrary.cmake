# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# libcvo_slam.so: the rooms as one shared library, cvo_slam::shared, beside the static ones. Only what
# is in namespace cvo_slam can be seen from outside; the ABI may change with each minor version, so
# that the soname has both numbers.

set(VERSION_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/exported_symbols.map)
add_library(cvo_slam_shared SHARED)
add_library(cvo_slam::shared ALIAS cvo_slam_shared)
foreach(ROOM core frontend backend loop slam io plot render synthetic)
  target_sources(cvo_slam_shared PRIVATE $<TARGET_OBJECTS:cvo_slam_${ROOM}>)
endforeach()
set_target_properties(
  cvo_slam_shared
  PROPERTIES EXPORT_NAME shared
             OUTPUT_NAME cvo_slam
             VERSION ${PROJECT_VERSION}
             SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
             LINK_DEPENDS ${VERSION_SCRIPT}
             LINKER_LANGUAGE CXX)
target_compile_features(cvo_slam_shared PUBLIC cxx_std_20)
target_link_libraries(
  cvo_slam_shared
  PUBLIC Eigen3::Eigen opencv_core
  PRIVATE Ceres::ceres TBB::tbb ZLIB::ZLIB fmt::fmt hwy::hwy opencv_calib3d opencv_features2d
          opencv_imgcodecs opencv_imgproc libjpeg-turbo::turbojpeg yaml-cpp
          ${CMAKE_DL_LIBS})
target_link_options(cvo_slam_shared PRIVATE -Wl,--version-script=${VERSION_SCRIPT} -Wl,--no-undefined)
target_include_directories(
  cvo_slam_shared INTERFACE $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
                            $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
if(CVO_SLAM_INSTALL)
  add_dependencies(cvo_slam_installed cvo_slam_shared)
  install(TARGETS cvo_slam_shared EXPORT cvo_slam_targets)
endif()
