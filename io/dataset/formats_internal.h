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
  /// True if the reference has the poses of the depth camera, false if those of the colour camera.
  bool reference_is_of_depth = false;
  /// True if the stamps are counted at PairingOptions::frame_rate and not measured.
  bool has_counted_stamps = false;
  std::vector<std::string> notes;
  /// A depth value that means "no measurement", as 0 always does.
  std::uint16_t invalid_depth = 0;
};

/// Returns the stamp of a numbered frame, in whole microseconds as trajectory files have them.
Timestamp stamp_of_frame(std::int64_t number, double frame_rate);

/// How the images of a sequence are paired to frames.
struct PairingOptions {
  /// A file of pairs to use in place of the sequence's own; its paths are relative to the folder of
  /// the sequence.
  std::optional<std::filesystem::path> associations;
  double max_stamp_difference = 0.02;  ///< [s], if there is no list of pairs
  double depth_offset = 0;             ///< added to the stamps of depth images first [s]
  double frame_rate = 30;              ///< of images that are numbered and not stamped [Hz]
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
  /// Returns the built-in camera that a file of the recording names; empty if none does. A null
  /// pointer if no file of this format does.
  std::optional<SuggestedCamera> (*named_camera)(const std::filesystem::path& folder);
  /// Opens a folder of this layout. Throws InputError, OptionError for an option that the layout
  /// has no use for.
  Sequence (*open)(const std::filesystem::path& folder, const PairingOptions& options);
};

extern const DatasetFormat kImageFoldersFormat;
extern const DatasetFormat kSevenScenesFormat;
extern const DatasetFormat kTumFormat;

/// Returns the formats in the order in which they are tried.
std::span<const DatasetFormat* const> all_dataset_formats();

/// Returns the name of a folder, even if its path is "." or ends with a slash.
std::string folder_name(const std::filesystem::path& folder);

}  // namespace cvo_slam
