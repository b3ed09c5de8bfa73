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
  /// Image `i` < count; its colour image is empty where it cannot be read. For several threads.
  std::function<RgbdFrame(std::size_t i)> read;
};

/// How many images to take of a source.
struct Thinning {
  int step = 3;               ///< every so many of recorded images
  double synthetic_rate = 2;  ///< of a synthetic world [Hz]
};

/// What a source of `vocab train` names: `synth:<world>:<seed>`, a synthetic world seen by a Kinect
/// along its own path; the folder of a data set; or any folder of PNG and JPEG files, in the order
/// of names. Throws OptionError for a malformed source, InputError where the folder has no images.
[[nodiscard]] TrainingImages open_training_images(const std::string& source,
                                                  const Thinning& thinning);

}  // namespace cvo_slam
