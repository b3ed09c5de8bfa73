// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/synthetic/sensor_options.h"

namespace cvo_slam::synthetic {

/// How much brighter than by default an image taken at `seconds` is: slow drift and jumps of an
/// automatic exposure. 1 where both are off.
[[nodiscard]] double exposure_gain(const ExposureOptions& options, std::uint32_t seed,
                                   double seconds);

/// What the chip makes of the light of an image (CV_32FC3, grey levels): CV_8UC3 with read and shot
/// noise, white where it is too bright. `seed` is that of the frame.
[[nodiscard]] cv::Mat expose(const cv::Mat& light, double gain, const ImageNoiseOptions& options,
                             std::uint32_t seed);

}  // namespace cvo_slam::synthetic
