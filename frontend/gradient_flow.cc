// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/frontend/pair_sums_internal.h"
#include "cvo_slam/frontend/solvers_internal.h"

namespace cvo_slam {
namespace {

/// Returns |log(exp(xi))|_F of a tangent as a 4x4 matrix: the paper's distance on SE(3).
double matrix_norm(const Vector6& xi) {
  return std::sqrt(xi.head<3>().squaredNorm() + 2 * xi.tail<3>().squaredNorm());
}

}  // namespace

FlowDirection flow_direction(const ObjectiveValue& value, double a2, double b2) {
  return {-value.gradient.tail<3>() / a2, -value.gradient.head<3>() / b2};
}

std::array<double, 4> step_expansion(PoseObjective& objective, const SE3& T_fixed_moving,
                                     const FlowDirection& direction) {
  return sum_expansion(objective.pairs(T_fixed_moving), T_fixed_moving, objective.kernel(),
                       objective.length_scale(), direction.omega, direction.v);
}

std::optional<double> smallest_positive_stationary_point(const std::array<double, 4>& g) {
  // Scaling t by the ratio of neighbouring coefficients keeps the companion matrix balanced.
  const double scale = std::abs(g[1]) > 0 ? std::abs(g[0] / g[1]) : 1.0;
  std::vector<double> c = {g[0], 2 * g[1] * scale, 3 * g[2] * scale * scale,
                           4 * g[3] * scale * scale * scale};
  const double largest = std::abs(*std::max_element(
      c.begin(), c.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
  while (!c.empty() && std::abs(c.back()) <= 1e-14 * largest) c.pop_back();
  if (c.size() < 2) return std::nullopt;

  const auto n = static_cast<Eigen::Index>(c.size()) - 1;
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    companion(i, n - 1) = -c[static_cast<std::size_t>(i)] / c.back();
    if (i > 0) companion(i, i - 1) = 1;
  }
  std::optional<double> smallest;
  const Eigen::VectorXcd roots =
      Eigen::EigenSolver<Eigen::MatrixXd>(companion, false).eigenvalues();
  for (const auto& root : roots) {
    const bool real = std::abs(root.imag()) <= 1e-9 * std::abs(root.real());
    if (real && root.real() > 0 && (!smallest || root.real() < *smallest)) smallest = root.real();
  }
  if (!smallest) return std::nullopt;
  return *smallest * scale;
}

void check(const FlowConstants& constants) {
  const std::array<std::pair<const char*, double>, 4> positive = {
      {{"metric_a2", constants.metric_a2},
       {"metric_b2", constants.metric_b2},
       {"max_step", constants.max_step},
       {"fallback_step", constants.fallback_step}}};
  for (const auto& [name, value] : positive) {
    if (value > 0 && std::isfinite(value)) continue;
    throw OptionError(fmt::format("flow.{}={} must be positive and finite", name, value));
  }
}

LevelResult gradient_flow(PoseObjective& objective, const SE3& T_fixed_moving_init,
                          int max_iterations, const FlowConstants& constants) {
  const double ell2 = objective.length_scale() * objective.length_scale();
  LevelResult state{T_fixed_moving_init, objective.evaluate(T_fixed_moving_init), 0, false};
  while (state.iterations < max_iterations && state.value.matched > 0 && !state.converged) {
    ++state.iterations;
    const FlowDirection xi = flow_direction(state.value, constants.metric_a2, constants.metric_b2);
    // Step limits and the gradient's threshold are stated for a flow without the factor 1/ell^2:
    // its time runs slower by ell^2.
    if (ell2 * xi.omega.norm() < constants.min_gradient &&
        ell2 * xi.v.norm() < constants.min_gradient) {
      state.converged = true;
      break;
    }
    const auto root =
        smallest_positive_stationary_point(step_expansion(objective, state.T_fixed_moving, xi));
    const double t =
        std::min(root.value_or(constants.fallback_step * ell2), constants.max_step * ell2);
    Vector6 step;
    step << -t * xi.v, -t * xi.omega;
    state.T_fixed_moving = (SE3::exp(step) * state.T_fixed_moving).normalized();
    state.value = objective.evaluate(state.T_fixed_moving);
    state.converged = matrix_norm(step) < constants.min_step;
  }
  return state;
}

}  // namespace cvo_slam
