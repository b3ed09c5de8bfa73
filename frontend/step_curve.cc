// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "cvo_slam/frontend/gradient_flow_internal.h"
#include "cvo_slam/frontend/inspection.h"

namespace cvo_slam {
namespace {

template <typename Options>
Options checked(Options options) {
  describe(options).check();
  return options;
}

}  // namespace

StepCurve::StepCurve(const PointCloud& fixed, const PointCloud& moving, const SE3& T_fixed_moving,
                     const KernelOptions& kernel, const FlowOptions& flow, double length_scale)
    : length_scale_(length_scale),
      fallback_step_(flow.fallback_step * length_scale * length_scale) {
  const FlowOptions options = checked(flow);
  Objective level;
  level.build(fixed, checked(kernel), length_scale);
  const Executor executor;
  PairTable table;
  PoseObjective objective(level, moving, moving.size(), table, executor);
  const ObjectiveValue value = objective.evaluate(T_fixed_moving);
  if (value.matched == 0) return;
  const FlowDirection direction = flow_direction(value, options.metric_a2, options.metric_b2);
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
