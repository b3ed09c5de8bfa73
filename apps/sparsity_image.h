// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "cvo_slam/frontend/inspection.h"

namespace cvo_slam {

/// Returns the rank of each pixel along a space-filling curve: neighbours on the curve are
/// neighbours in the image. Pixels outside the image count as on its edge.
[[nodiscard]] std::vector<std::size_t> ranks_along_curve(
    const std::vector<Eigen::Vector2d>& pixels);

/// Draws the sparsity pattern of a kernel matrix (CV_8UC3): points of the fixed cloud from top to
/// bottom, points of the moving cloud from left to right, by their ranks. A pixel is darker the
/// more entries it holds.
[[nodiscard]] cv::Mat draw_sparsity(const std::vector<KernelEntry>& entries,
                                    const std::vector<std::size_t>& fixed_ranks,
                                    const std::vector<std::size_t>& moving_ranks, cv::Size size);

}  // namespace cvo_slam
