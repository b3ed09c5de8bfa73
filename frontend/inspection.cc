// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/frontend/inspection.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cvo_slam/frontend/neighbor_grid_internal.h"
#include "cvo_slam/frontend/solvers_internal.h"

namespace cvo_slam {
namespace {

/// Returns sum c k over the kernel matrix of a cloud with itself.
double squared_norm(const PointCloud& cloud, const KernelOptions& options, double length_scale) {
  double sum = 0;
  for (const KernelEntry& entry : kernel_matrix(cloud, cloud, {}, options, length_scale)) {
    sum += entry.c * entry.k;
  }
  return sum;
}

/// Finds the column of a moving point in the kernel matrix, its rows in ascending order.
class ColumnFinder {
 public:
  ColumnFinder(const PointCloud& fixed, const KernelOptions& options, double length_scale)
      : fixed_(fixed), options_(options), inv2_(1 / (length_scale * length_scale)) {
    // A little wider: the grid looks in single precision.
    grid_.build(fixed, 1.001 * support_radius(options, length_scale));
  }

  void append(const PointCloud& moving, std::uint32_t j, const Vector3& place,
              std::vector<KernelEntry>& entries) const {
    const std::size_t begin = entries.size();
    std::array<GridRun, NeighborGrid::kMaxRuns> runs{};
    const std::size_t count =
        grid_.query(static_cast<float>(place.x()), static_cast<float>(place.y()),
                    static_cast<float>(place.z()), runs);
    for (std::size_t run = 0; run < count; ++run) {
      for (std::uint32_t entry = runs.at(run).begin; entry < runs.at(run).end; ++entry) {
        const std::uint32_t i = grid_.order()[entry];
        const double k = options_.sigma * options_.sigma *
                         std::exp(-inv2_ / 2 * (fixed_.position(i) - place).squaredNorm());
        if (!(k > options_.sparsification)) continue;
        entries.push_back({i, j, label_product(options_, fixed_, i, moving, j), k});
      }
    }
    std::sort(entries.begin() + static_cast<std::ptrdiff_t>(begin), entries.end(),
              [](const KernelEntry& a, const KernelEntry& b) { return a.fixed < b.fixed; });
  }

 private:
  const PointCloud& fixed_;
  const KernelOptions& options_;
  double inv2_;
  NeighborGrid grid_;
};

}  // namespace

std::vector<KernelEntry> kernel_matrix(const PointCloud& fixed, const PointCloud& moving,
                                       const SE3& T_fixed_moving, const KernelOptions& options,
                                       double length_scale) {
  if (!(support_radius(options, length_scale) > 0)) return {};
  const ColumnFinder finder(fixed, options, length_scale);
  std::vector<KernelEntry> entries;
  for (std::uint32_t j = 0; j < moving.size(); ++j) {
    const Vector3 place = T_fixed_moving * moving.position(j);
    if (place.allFinite()) finder.append(moving, j, place, entries);
  }
  return entries;
}

CloudSimilarity similarity(const PointCloud& fixed, const PointCloud& moving,
                           const SE3& T_fixed_moving, const KernelOptions& options,
                           double length_scale) {
  CloudSimilarity result;
  constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t last = kNone;
  std::size_t matched = 0;
  for (const KernelEntry& entry :
       kernel_matrix(fixed, moving, T_fixed_moving, options, length_scale)) {
    result.inner_product += entry.c * entry.k;
    ++result.entries;
    matched += entry.moving == last ? 0U : 1U;
    last = entry.moving;
  }
  const double norms = std::sqrt(squared_norm(fixed, options, length_scale) *
                                 squared_norm(moving, options, length_scale));
  // The kernel cut to its support is not positive definite: the quotient can be larger than one.
  if (norms > 0) result.cos_theta = std::min(1.0, result.inner_product / norms);
  if (!moving.empty()) {
    result.overlap = static_cast<double>(matched) / static_cast<double>(moving.size());
  }
  return result;
}

StepCurve::StepCurve(const PointCloud& fixed, const PointCloud& moving, const SE3& T_fixed_moving,
                     const KernelOptions& kernel, const FlowConstants& flow, double length_scale)
    : length_scale_(length_scale),
      fallback_step_(flow.fallback_step * length_scale * length_scale) {
  KernelOptions options = kernel;
  describe(options).check();
  check(flow);
  Objective level;
  level.build(fixed, options, length_scale);
  const Executor executor;
  PairTable table;
  PoseObjective objective(level, moving, moving.size(), table, executor);
  const ObjectiveValue value = objective.evaluate(T_fixed_moving);
  if (value.matched == 0) return;
  const FlowDirection direction = flow_direction(value, flow.metric_a2, flow.metric_b2);
  omega_ = direction.omega;
  v_ = direction.v;
  coefficients_ = step_expansion(objective, T_fixed_moving, direction);
  for (const KernelEntry& entry :
       kernel_matrix(fixed, moving, T_fixed_moving, kernel, length_scale)) {
    pairs_.push_back({fixed.position(entry.fixed), T_fixed_moving * moving.position(entry.moving),
                      entry.c * entry.k});
  }
}

double StepCurve::exact(double t) const {
  Vector6 tangent;
  tangent << -t * v_, -t * omega_;
  const SE3 motion = SE3::exp(tangent);  // h exp(t xi) moves z~ to exp(-t xi) z~
  const double inv2 = 1 / (length_scale_ * length_scale_);
  double sum = 0;
  for (const Pair& pair : pairs_) {
    const double before = (pair.fixed - pair.moving).squaredNorm();
    const double after = (pair.fixed - motion * pair.moving).squaredNorm();
    // Their difference is small where t is: expm1 keeps its digits.
    sum += pair.weight * std::expm1(-inv2 / 2 * (after - before));
  }
  return sum;
}

double StepCurve::expanded(double t, int order) const {
  double sum = 0;
  for (int k = order; k >= 1; --k)
    sum = t * (coefficients_.at(static_cast<std::size_t>(k - 1)) + sum);
  return sum;
}

double StepCurve::step(int order) const {
  std::array<double, 4> g = coefficients_;
  std::fill(g.begin() + order, g.end(), 0.0);
  return smallest_positive_stationary_point(g).value_or(fallback_step_);
}

}  // namespace cvo_slam
