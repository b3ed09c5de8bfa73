// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/frontend/registration.h"

namespace cvo_slam {

// What a registration computes, for people who want to see it: in double precision, and not made
// for speed.

/// An entry of the kernel matrix that is not zero.
struct KernelEntry {
  std::uint32_t fixed = 0;   ///< its row: a point of the fixed cloud
  std::uint32_t moving = 0;  ///< its column: a point of the moving cloud
  double c = 0;              ///< inner product of the labels
  double k = 0;              ///< position kernel, above KernelOptions::sparsification
};

/// Returns the kernel matrix of two clouds at a pose and a length scale [m]: the pairs within the
/// kernel's support, by column, then row. Points that are not finite have none.
[[nodiscard]] std::vector<KernelEntry> kernel_matrix(const PointCloud& fixed,
                                                     const PointCloud& moving,
                                                     const SE3& T_fixed_moving,
                                                     const KernelOptions& options,
                                                     double length_scale);

/// Measures of how well two clouds match at a pose and a length scale.
struct CloudSimilarity {
  double inner_product = 0;  ///< `<f_X, h.f_Z>` = sum c k
  double cos_theta = 0;      ///< inner_product / (|f_X| |f_Z|), in [0, 1]; 0 if a norm is 0
  double overlap = 0;        ///< share of the moving points with an entry in the kernel matrix
  std::size_t entries = 0;   ///< number of entries of the kernel matrix
};

/// Compares two clouds at a pose and a length scale [m].
[[nodiscard]] CloudSimilarity similarity(const PointCloud& fixed, const PointCloud& moving,
                                         const SE3& T_fixed_moving, const KernelOptions& options,
                                         double length_scale);

/// G(t) = F(h exp(t xi)) - F(h) along the gradient flow xi from a pose T = h^-1, of the pairs in
/// the kernel matrix at t = 0. Solver::kFlow chooses its steps by it. Over the same pairs the exact
/// curve is smooth; the pairs that come into the support on the way are no part of it.
class StepCurve {
 public:
  /// Throws OptionError if an option or constant is out of range. `length_scale` in metres.
  StepCurve(const PointCloud& fixed, const PointCloud& moving, const SE3& T_fixed_moving,
            const KernelOptions& kernel, const FlowConstants& flow, double length_scale);

  /// Returns G(t).
  [[nodiscard]] double exact(double t) const;
  /// Returns the expansion of G(t) up to t^order, `order` 1 to 4.
  [[nodiscard]] double expanded(double t, int order) const;
  /// Coefficients of t, t^2, t^3 and t^4 (frontend/pair_sums_internal.h has their formulas).
  [[nodiscard]] const std::array<double, 4>& coefficients() const { return coefficients_; }
  /// Returns the smallest positive stationary point of the expansion up to t^order, 2 to 4, or the
  /// fallback step if there is none; in the time of the flow with its factor 1 / ell^2.
  [[nodiscard]] double step(int order = 4) const;
  /// Returns the length scale [m] that the curve was made for.
  [[nodiscard]] double length_scale() const { return length_scale_; }
  /// False if there is no pair or no gradient: then the curve is zero.
  [[nodiscard]] bool has_slope() const { return coefficients_[0] > 0; }

 private:
  struct Pair {
    Vector3 fixed;      ///< x
    Vector3 moving;     ///< z~ = T z at t = 0
    double weight = 0;  ///< c k at t = 0
  };

  std::vector<Pair> pairs_;
  Vector3 omega_ = Vector3::Zero();
  Vector3 v_ = Vector3::Zero();
  std::array<double, 4> coefficients_{};
  double length_scale_ = 0;
  double fallback_step_ = 0;
};

}  // namespace cvo_slam
