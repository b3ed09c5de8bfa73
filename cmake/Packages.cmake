# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Debian packages (`make packages`): libcvo-slam-dev, cvo-slam and python3-cvo-slam.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The cvo_slam authors <cvo_slam@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_COMPONENTS_ALL library)
set(CPACK_STRIP_FILES ON)

# What find_package(cvo_slam) and the headers ask for.
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libcvo-slam-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS
    "libeigen3-dev, libopencv-dev, libtbb-dev, libyaml-cpp-dev, libfmt-dev, libhwy-dev, zlib1g-dev, libturbojpeg0-dev, libjpeg62-turbo-dev, libceres-dev")
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION
    "Track an RGB-D camera and build a map of what it sees: static libraries, headers, and files for
CMake and pkg-config.")

# A license where Debian has them.
function(cvo_slam_package_license COMPONENT PACKAGE)
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${PACKAGE}
          COMPONENT ${COMPONENT} RENAME copyright ${ARGN})
endfunction()
cvo_slam_package_license(library libcvo-slam-dev)

if(CVO_SLAM_BUILD_APPS)
  list(APPEND CPACK_COMPONENTS_ALL program)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME cvo-slam)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
  # Loaded when a picture is drawn.
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS libosmesa6)
  set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
      "The program cvo_slam: runs recorded or growing RGB-D sequences, evaluates trajectories,
optimises pose graphs, draws maps without a display.")
  cvo_slam_package_license(program cvo-slam)
endif()

if(CVO_SLAM_BUILD_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-cvo-slam)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  math(EXPR NEXT_MINOR "${CVO_SLAM_PYTHON_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= 3.${CVO_SLAM_PYTHON_MINOR}), python3 (<< 3.${NEXT_MINOR}), python3-numpy, libosmesa6")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION
      "The Python module cvo_slam: numpy images in, poses and maps out.")
  cvo_slam_package_license(python python3-cvo-slam EXCLUDE_FROM_ALL)
endif()

include(CPack)
