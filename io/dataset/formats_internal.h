// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/timestamp.h"
#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/io/dataset.h"

namespace cvo_slam {

/// The image files of one frame.
struct FrameFiles {
  Timestamp stamp;  ///< stamp of the colour image
  Timestamp depth_stamp;
  std::filesystem::path color;
  std::filesystem::path depth;
};

/// The content of a sequence's folder. The images themselves are read later.
struct Sequence {
  std::vector<FrameFiles> frames;
  UnpairedImages unpaired;
  std::vector<StampedPose> reference;
  std::vector<std::string> notes;
  /// A depth value that means "no measurement", as 0 always does.
  std::uint16_t invalid_depth = 0;
};

/// A built-in camera, and why a sequence is taken to be recorded with it.
struct SuggestedCamera {
  std::string name;
  std::string reason;
};

/// A layout of files that can be opened as a sequence. All that the library and the program know of
/// a format is in here: to add one, write a file that defines such a value, declare it below, and
/// add a line to the table in formats.cc.
struct DatasetFormat {
  std::string_view name;    ///< for people, e.g. "7-Scenes"
  std::string_view layout;  ///< the files it is recognised by, for help texts and errors
  /// Returns true if a folder has this layout.
  bool (*recognise)(const std::filesystem::path& folder);
  /// Returns the camera of a sequence that comes without a camera file; empty if it is not known.
  std::optional<SuggestedCamera> (*suggest_camera)(const std::filesystem::path& folder);
  /// Opens a folder of this layout. Images of a frame differ by at most `max_stamp_difference` [s]
  /// if the format has no list of pairs. Throws InputError.
  Sequence (*open)(const std::filesystem::path& folder, const Camera& camera,
                   double max_stamp_difference);
};

extern const DatasetFormat kIclNuimFormat;
extern const DatasetFormat kSevenScenesFormat;
extern const DatasetFormat kTumFormat;

/// Returns the formats in the order in which they are tried.
std::span<const DatasetFormat* const> all_dataset_formats();

/// Returns the name of a folder, even if its path is "." or ends with a slash.
std::string folder_name(const std::filesystem::path& folder);

}  // namespace cvo_slam
