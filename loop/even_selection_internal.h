// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <opencv2/core/types.hpp>

#include "cvo_slam/loop/orb_features.h"

namespace cvo_slam {

/// At most `wanted` of the keypoints. Each level of the pyramid has a share that falls as 1 /
/// scale, and what a coarser one cannot fill goes to the next finer. Within a level each cell of a
/// grid gives its strongest, then each its second, and so on; of the last round the strongest are
/// taken. There are OrbOptions::per_cell times fewer cells than features of the level.
[[nodiscard]] std::vector<cv::KeyPoint> select_evenly(const std::vector<cv::KeyPoint>& keypoints,
                                                      const cv::Size& image,
                                                      const OrbOptions& options, int wanted);

/// The keypoints in cells that have none of `others`, of a grid for all features of an image.
[[nodiscard]] std::vector<cv::KeyPoint> in_empty_cells(const std::vector<cv::KeyPoint>& keypoints,
                                                       const std::vector<cv::KeyPoint>& others,
                                                       const cv::Size& image,
                                                       const OrbOptions& options);

}  // namespace cvo_slam
