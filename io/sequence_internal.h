// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/timestamp.h"
#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/io/dataset.h"

namespace cvo_slam {

struct FrameFiles {
  Timestamp stamp;
  Timestamp depth_stamp;
  std::filesystem::path color;
  std::filesystem::path depth;
};

/// What the folder of a sequence says, before any image is read. A reader of a data set's layout is
/// a function that makes one of these.
struct Sequence {
  std::string name;
  std::string kind;
  Camera camera;
  std::vector<FrameFiles> frames;
  UnpairedImages unpaired;
  std::vector<StampedPose> reference;
  std::vector<std::string> notes;
  /// A depth value that means "none" beside 0.
  std::uint16_t invalid_depth = 0;
};

/// rgb.txt and depth.txt, or an associations file: the layout of TUM RGB-D and ICL-NUIM.
bool is_tum_folder(const std::filesystem::path& folder);
Sequence open_tum_sequence(const std::filesystem::path& folder, const DatasetOptions& options);

/// frame-NNNNNN.{color.png,depth.png,pose.txt}: the layout of 7-Scenes.
bool is_seven_scenes_folder(const std::filesystem::path& folder);
Sequence open_seven_scenes_sequence(const std::filesystem::path& folder,
                                    const DatasetOptions& options);

/// The name of a folder, also where it is given as "." or with a slash at its end.
std::string folder_name(const std::filesystem::path& folder);

}  // namespace cvo_slam
