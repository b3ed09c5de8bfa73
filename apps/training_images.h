// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "cvo_slam/core/rgbd_frame.h"

namespace cvo_slam {

/// Images to learn visual words from.
struct TrainingImages {
  std::size_t count = 0;
  /// Reads image `i` < count; its colour image is empty if it cannot be read. Thread-safe.
  std::function<RgbdFrame(std::size_t i)> read;
};

/// The share of the images of a source that is used.
struct Thinning {
  int step = 3;               ///< use every n-th recorded image
  double synthetic_rate = 2;  ///< images per second of a synthetic world [Hz]
};

/// Opens a source of `vocab train`: `synth:<world>:<seed>`, a synthetic world seen by a Kinect
/// along the path of the world; the folder of a data set; or any folder of PNG and JPEG files, in
/// the order of their names. Throws OptionError for a malformed source, InputError if the folder
/// has no images.
[[nodiscard]] TrainingImages open_training_images(const std::string& source,
                                                  const Thinning& thinning);

}  // namespace cvo_slam
