// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <opencv2/core/types.hpp>

#include "cvo_slam/loop/orb_features.h"

namespace cvo_slam {

/// Returns at most `wanted` of the keypoints. The share of a pyramid level falls as 1 / scale; what
/// a coarser level cannot fill goes to the next finer one. Within a level each cell of a grid gives
/// its strongest keypoint, then each its second, and so on; from the last round the strongest are
/// taken. A level has OrbOptions::per_cell times fewer cells than features.
[[nodiscard]] std::vector<cv::KeyPoint> select_evenly(const std::vector<cv::KeyPoint>& keypoints,
                                                      const cv::Size& image,
                                                      const OrbOptions& options, int wanted);

/// Returns the keypoints in those cells of an image that have none of `others`.
[[nodiscard]] std::vector<cv::KeyPoint> in_empty_cells(const std::vector<cv::KeyPoint>& keypoints,
                                                       const std::vector<cv::KeyPoint>& others,
                                                       const cv::Size& image,
                                                       const OrbOptions& options);

}  // namespace cvo_slam
