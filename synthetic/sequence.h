// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/synthetic/sensor_options.h"
#include "cvo_slam/synthetic/world.h"

namespace cvo_slam::synthetic {

/// File format of the colour images.
enum class ImageFormat { kPng, kJpeg };

/// What to record of a world.
struct SequenceOptions {
  std::string scene = "room";  ///< a name of world_names(), or a world file (*.yaml)
  std::uint32_t seed = 1;      ///< seed of textures, clutter, tremor and sensor
  /// Seed of another walk through the same world (WorldOptions); empty = the path as it is.
  std::optional<std::uint32_t> path_seed = std::nullopt;
  std::optional<PathStyle> path = std::nullopt;  ///< empty = the world's own path
  double speed = 1;                              ///< 2 = the same path in half the time
  std::optional<std::size_t> frames;             ///< number of frames; empty = the whole path
  int laps = 1;      ///< rounds of the whole path, in [1, 1000]; a path with ends stays at its end
  int width = 640;   ///< [px] in [16, 4096]
  int height = 480;  ///< [px] in [16, 4096]
  /// Format of the colour images. PNG is lossless, so that colour is as exact as the poses; JPEG
  /// (quality 95) takes about a third of the space.
  ImageFormat image = ImageFormat::kPng;
  SensorOptions sensor = {};  ///< the default is an ideal sensor
};

/// What write_sequence() has written.
struct SequenceSummary {
  std::size_t frames = 0;  ///< number of frames, including those whose images were dropped
  double seconds = 0;      ///< time from the first to the last stamp [s]
  double path_length = 0;  ///< length of the camera path [m]
};

/// Called in the calling thread with the number of frames done and their total.
using Progress = std::function<void(std::size_t done, std::size_t total)>;

/// Returns the camera of synthetic sequences: the field of view of a Kinect, no distortion, 5000
/// depth units a metre.
[[nodiscard]] Camera synthetic_camera(int width, int height);

/// Records a sequence in the layout of the TUM RGB-D benchmark: rgb/, depth/, rgb.txt, depth.txt,
/// groundtruth.txt (the exact poses at the stamps of the colour images and 100 times a second),
/// camera.yaml and synthetic.yaml, which contains the command that made the sequence and marks the
/// folder as one that a later call may replace. `threads` threads make the frames; the files do not
/// depend on their number. The lists are written last, so that an interrupted recording is not
/// mistaken for a complete one.
/// Throws OptionError for a bad option, and OutputError if the folder contains anything but a
/// synthetic sequence or cannot be written.
SequenceSummary write_sequence(const std::filesystem::path& folder, const SequenceOptions& options,
                               int threads = 1, const Progress& progress = {});

}  // namespace cvo_slam::synthetic
