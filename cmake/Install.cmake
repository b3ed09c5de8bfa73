# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes find_package(cvo_slam) work for the libraries that the rooms install.

include(CMakePackageConfigHelpers)
set(CONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/cvo_slam)

# Sets OUTPUT to the find_dependency() calls of the packages, one on each line.
function(cvo_slam_find_calls OUTPUT)
  list(TRANSFORM ARGN REPLACE "(.+)" "find_dependency(\\1)")
  list(JOIN ARGN "\n" CALLS)
  set(${OUTPUT} "${CALLS}" PARENT_SCOPE)
endfunction()

cvo_slam_find_calls(FIND_DEPENDENCIES ${CVO_SLAM_DEPENDENCIES})
cvo_slam_find_calls(FIND_BACKEND_DEPENDENCIES ${CVO_SLAM_BACKEND_DEPENDENCIES})

install(EXPORT cvo_slam_targets NAMESPACE cvo_slam:: DESTINATION ${CONFIG_DIR})
configure_package_config_file(cmake/cvo_slam-config.cmake.in
                              ${PROJECT_BINARY_DIR}/cvo_slam-config.cmake
                              INSTALL_DESTINATION ${CONFIG_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cvo_slam-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
# For builds without CMake: all rooms, those that need others first.
set(ROOMS synthetic render plot io slam loop backend frontend core)
list(TRANSFORM ROOMS PREPEND -lcvo_slam_ OUTPUT_VARIABLE ROOM_FLAGS)
list(JOIN ROOM_FLAGS " " ROOM_FLAGS)
list(GET OpenCV_INCLUDE_DIRS 0 OPENCV_INCLUDE_DIR)
file(RELATIVE_PATH PREFIX_FROM_PKGCONFIG /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(cmake/cvo_slam.pc.in ${PROJECT_BINARY_DIR}/cvo_slam.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/cvo_slam.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

install(FILES ${PROJECT_BINARY_DIR}/cvo_slam-config.cmake
              ${PROJECT_BINARY_DIR}/cvo_slam-config-version.cmake DESTINATION ${CONFIG_DIR})
