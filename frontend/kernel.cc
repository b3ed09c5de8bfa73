// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "cvo_slam/frontend/registration.h"

namespace cvo_slam {

OptionSet describe(KernelOptions& o) {
  return OptionSet()
      .add("sigma", o.sigma, {1e-3, 1e3}, "",
           "Amplitude of the position kernel; only its ratio to the sparsification matters. The "
           "default is the paper's.")
      .add("sparsification", o.sparsification, {1e-9, 1e3}, "",
           "Position kernel values below this count as zero. The default is the paper's: pairs up "
           "to "
           "2.15 length scales apart count.")
      .add("color_kernel", o.color_kernel,
           {{"linear", ColorKernel::kLinear},
            {"squared_exponential", ColorKernel::kSquaredExponential}},
           "Inner product of colours: the paper's linear one, or a squared exponential of colour "
           "and gradient, which tells points apart.")
      .add("color_scale", o.color_scale, {1, 1e6}, "8-bit values",
           "Length scale of the squared exponential on (blue, green, red). A smaller one takes "
           "changes "
           "of exposure for other colours; a larger one hardly tells colours apart.")
      .add("gradient_scale", o.gradient_scale, {1, 1e6}, "8-bit values a pixel",
           "Length scale of the squared exponential on the image gradient.")
      .add("ray_noise", o.ray_noise, {0, 100}, "",
           "Factor on the camera's depth noise, by which the kernel is longer along a point's ray "
           "d: its covariance is ell^2 I + (factor noise)^2 d d^T. 0 = it is not. The "
           "solver flow takes balls.")
      .add(
          "surfaces", o.surfaces,
          "Makes the kernel thin across the surface of a point where the depth is clean: a depth "
          "of a millimetre's noise says more about the way to a wall than texture does. The solver "
          "flow takes balls.");
}

double support_radius(const KernelOptions& options, double length_scale) {
  const double ratio = options.sigma * options.sigma / options.sparsification;
  return ratio > 1 ? length_scale * std::sqrt(2 * std::log(ratio)) : 0.0;
}

double label_product(const KernelOptions& options, const PointCloud& a, std::size_t i,
                     const PointCloud& b, std::size_t j) {
  constexpr std::size_t kColors = 3;
  if (options.color_kernel == ColorKernel::kLinear) {
    constexpr double kLinearScale = 1e-5;  // the paper's remark: 1 / 10^5
    double product = 0;
    for (std::size_t f = 0; f < kColors; ++f) {
      product += static_cast<double>(a.features[f][i]) * b.features[f][j];
    }
    return kLinearScale * product;
  }
  double exponent = 0;
  for (std::size_t f = 0; f < PointCloud::kFeatures; ++f) {
    const double difference = static_cast<double>(a.features[f][i]) - b.features[f][j];
    const double scale = f < kColors ? options.color_scale : options.gradient_scale;
    exponent -= difference * difference / (2 * scale * scale);
  }
  return std::exp(exponent);
}

}  // namespace cvo_slam
