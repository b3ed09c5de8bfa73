// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "cvo_slam/core/options.h"
#include "cvo_slam/core/point_cloud.h"

namespace cvo_slam {

/// The inner product of two points' labels.
enum class ColorKernel {
  kLinear,              ///< 1e-5 <rgb, rgb>: the paper's
  kSquaredExponential,  ///< exp(-|d color|^2 / (2 s_c^2) - |d gradient|^2 / (2 s_g^2))
};

/// The kernels of the function space: k(x, y) = sigma^2 exp(-|x - y|^2 / (2 ell^2)) on positions,
/// and the inner product c of labels. Weights of pairs of points are c k.
struct KernelOptions {
  double sigma = 0.1;
  /// k below this value counts as zero, so that pairs further apart than
  /// ell sqrt(2 ln(sigma^2 / sparsification)) need not be looked at.
  double sparsification = 1e-3;
  ColorKernel color_kernel = ColorKernel::kSquaredExponential;
  double color_scale = 60.0;     ///< s_c, on 8-bit values
  double gradient_scale = 60.0;  ///< s_g, on 8-bit values a pixel
};

[[nodiscard]] OptionSet describe(KernelOptions& options);

/// The distance beyond which the sparsified kernel is zero [m].
[[nodiscard]] double support_radius(const KernelOptions& options, double length_scale);

/// c, the inner product of the labels of a[i] and b[j].
[[nodiscard]] double label_product(const KernelOptions& options, const PointCloud& a, std::size_t i,
                                   const PointCloud& b, std::size_t j);

}  // namespace cvo_slam
