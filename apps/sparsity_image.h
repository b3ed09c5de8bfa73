// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/frontend/inspection.h"

namespace cvo_slam {

/// Where the entries of a kernel matrix are, as a CV_8UC3 picture: the points of the fixed cloud
/// from top to bottom, those of the moving one from left to right, each in the order of a curve
/// that stays near in the image, so that a pair of points that are seen at the same pixel is near
/// the diagonal. A pixel of the picture is darker the more entries it holds.
[[nodiscard]] cv::Mat draw_sparsity(const std::vector<KernelEntry>& entries,
                                    const PointCloud& fixed, const PointCloud& moving,
                                    cv::Size size);

}  // namespace cvo_slam
