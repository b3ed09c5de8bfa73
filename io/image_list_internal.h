// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cvo_slam/core/timestamp.h"
#include "cvo_slam/io/sequence_internal.h"

namespace cvo_slam {

struct StampedFile {
  Timestamp stamp;
  std::filesystem::path file;
};

/// Reads "stamp file" lines (rgb.txt, depth.txt) in ascending order of stamps; paths are relative
/// to the list's folder. Throws InputError with the line of a malformed one.
std::vector<StampedFile> read_image_list(const std::filesystem::path& list,
                                         std::vector<std::string>& notes);

struct AssociationList {
  std::vector<FrameFiles> frames;
  bool depth_first = false;
};

/// Reads "stamp file stamp file" lines, whose colour or depth image comes first: the words depth,
/// rgb and color in the paths tell, else the images themselves. Throws InputError.
AssociationList read_association_list(const std::filesystem::path& list,
                                      std::vector<std::string>& notes);

}  // namespace cvo_slam
