// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/trajectory.h"

namespace cvo_slam {

struct DatasetOptions {
  /// The camera to use; empty = camera.yaml in the sequence's folder, else the built-in camera that
  /// its name or layout calls for.
  std::optional<Camera> camera;
  /// Largest difference of the stamps of a colour and a depth image that make a frame [s]. The
  /// cameras run at 30 Hz: with more than half of 33 ms the nearest image is another one's partner.
  double max_stamp_difference = 0.02;
};

/// How many images have no partner and are in no frame.
struct UnpairedImages {
  std::size_t color = 0;
  std::size_t depth = 0;
};

/// A recorded RGB-D sequence.
class Dataset {
 public:
  virtual ~Dataset() = default;

  /// The name of the sequence, from its folder.
  [[nodiscard]] virtual const std::string& name() const = 0;
  /// The layout it was recognised by, for people: "TUM RGB-D", "ICL-NUIM", "7-Scenes".
  [[nodiscard]] virtual const std::string& kind() const = 0;
  [[nodiscard]] virtual const Camera& camera() const = 0;
  /// Number of frames: associated pairs of a colour and a depth image, in ascending order of time.
  [[nodiscard]] virtual std::size_t size() const = 0;
  /// Reads frame `index` < size(). An image that is missing or broken gives a frame without images
  /// whose `problem` says why. May be called from several threads.
  [[nodiscard]] virtual RgbdFrame read(std::size_t index) const = 0;
  /// The stamp of frame `index`, without reading it.
  [[nodiscard]] virtual Timestamp stamp(std::size_t index) const = 0;
  [[nodiscard]] virtual UnpairedImages unpaired() const = 0;
  /// Ground-truth poses of the colour camera; empty where the sequence has none.
  [[nodiscard]] virtual const std::vector<StampedPose>& reference() const = 0;
  /// What a user should know of the sequence, a line each: unpaired images, dropped duplicates, ...
  [[nodiscard]] virtual const std::vector<std::string>& notes() const = 0;
};

/// Opens a sequence whose kind is recognised by its files: TUM RGB-D (and whatever shares its
/// layout, as ICL-NUIM with an associations file does), or 7-Scenes.
/// Throws InputError where the folder is missing, of no known kind, has no frame, has a list with a
/// malformed line (file:line), or calls for no camera that is known.
///
/// A file whose bytes are cut off is recognised before it is decoded. Damage inside a whole file is
/// found by the decoder; the frame is marked alike, but libpng and libjpeg may then write a line of
/// their own to stderr, which cannot be kept back without changing the state of the process.
[[nodiscard]] std::unique_ptr<Dataset> open_dataset(const std::filesystem::path& folder,
                                                    const DatasetOptions& options = {});

}  // namespace cvo_slam
