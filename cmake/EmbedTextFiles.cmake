# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause

# cvo_slam_embed_cameras(<out.cc> <file.yaml>...): writes the definition of builtin_camera_files(),
# which returns the text of the files. CMake runs again when one of them changes.
function(cvo_slam_embed_cameras OUTPUT)
  set(ENTRIES "")
  foreach(FILE ${ARGN})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${FILE})
    get_filename_component(NAME ${FILE} NAME_WE)
    file(READ ${FILE} TEXT)
    string(APPEND ENTRIES "    {\"${NAME}\", R\"yaml(${TEXT})yaml\"},\n")
  endforeach()
  list(LENGTH ARGN COUNT)
  file(
    CONFIGURE
    OUTPUT ${OUTPUT}
    CONTENT
      "// Written by cmake/EmbedTextFiles.cmake from config/cameras/*.yaml.
#include <array>

#include \"cvo_slam/io/builtin_camera_files_internal.h\"

namespace cvo_slam {
namespace {

constexpr std::array<BuiltinCameraFile, @COUNT@> kFiles = {{
@ENTRIES@}};

}  // namespace

std::span<const BuiltinCameraFile> builtin_camera_files() { return kFiles; }

}  // namespace cvo_slam
"
    @ONLY)
endfunction()
