# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# cmake -D PREFIX=... -D SOURCE_DIR=... -P check_installed_files.cmake
# Checks that the headers of the rooms that are not named *_internal.h are installed, and no others,
# and that the installed CMake files do not lead back to the source or build tree.

foreach(ROOM core frontend backend loop slam io plot render synthetic)
  file(GLOB_RECURSE HEADERS RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/${ROOM}/*.h)
  list(APPEND EXPECTED ${HEADERS})
endforeach()
list(FILTER EXPECTED EXCLUDE REGEX "_internal\\.h$")
file(GLOB_RECURSE INSTALLED RELATIVE ${PREFIX}/include/cvo_slam ${PREFIX}/include/cvo_slam/*)

set(MISSING ${EXPECTED})
list(REMOVE_ITEM MISSING ${INSTALLED})
set(SURPLUS ${INSTALLED})
list(REMOVE_ITEM SURPLUS ${EXPECTED})
foreach(HEADER IN LISTS MISSING)
  message(SEND_ERROR "${HEADER} is not installed: add it to PUBLIC_HEADERS of its room, or name it "
                     "*_internal.h")
endforeach()
foreach(HEADER IN LISTS SURPLUS)
  message(SEND_ERROR "${HEADER} is installed and should not be: remove it from PUBLIC_HEADERS")
endforeach()

file(GLOB_RECURSE SCRIPTS ${PREFIX}/*.cmake)
if(NOT SCRIPTS OR NOT EXPECTED)
  message(SEND_ERROR "${PREFIX}: no CMake files or headers; did the installation run?")
endif()
foreach(SCRIPT IN LISTS SCRIPTS)
  file(READ ${SCRIPT} TEXT)
  # ${PREFIX} itself is in the build tree.
  string(REPLACE "${PREFIX}" "" TEXT "${TEXT}")
  # A path is looked for at its begin only: lib/cmake/cvo_slam does not name a checkout in /cvo_slam.
  string(REGEX REPLACE "[; ]" "\"" TEXT "${TEXT}")
  string(FIND "${TEXT}" "\"${SOURCE_DIR}" POSITION)
  if(NOT POSITION EQUAL -1)
    message(SEND_ERROR "${SCRIPT}: names ${SOURCE_DIR}; an installation must stand alone")
  endif()
endforeach()
