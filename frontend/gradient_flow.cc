// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "cvo_slam/frontend/gradient_flow_internal.h"

namespace cvo_slam {
namespace {

/// |log(exp(xi))|_F of a tangent as a 4x4 matrix: the paper's distance on SE(3).
double matrix_norm(const Vector6& xi) {
  return std::sqrt(xi.head<3>().squaredNorm() + 2 * xi.tail<3>().squaredNorm());
}

}  // namespace

void find_pairs(const NeighborGrid& grid, const PointCloud& moving, const SE3& T_fixed_moving,
                const KernelOptions& kernel, double length_scale, PairList& list) {
  const PointCloud& fixed = grid.points();
  const double radius2 = grid.radius() * grid.radius();
  const double sigma2 = kernel.sigma * kernel.sigma;
  const double exponent = -0.5 / (length_scale * length_scale);
  list.groups.clear();
  list.pairs.clear();
  std::array<GridRun, NeighborGrid::kMaxRuns> runs{};
  for (std::size_t j = 0; j < moving.size(); ++j) {
    const Vector3 z = T_fixed_moving * moving.position(j);
    const std::size_t begin = list.pairs.size();
    const std::size_t count = grid.query(static_cast<float>(z.x()), static_cast<float>(z.y()),
                                         static_cast<float>(z.z()), runs);
    for (const auto& run : std::span(runs).first(count)) {
      for (std::size_t i = run.begin; i < run.end; ++i) {
        const Vector3 d = fixed.position(i) - z;
        const double d2 = d.squaredNorm();
        if (d2 >= radius2) continue;
        const double c = label_product(kernel, fixed, i, moving, j);
        list.pairs.push_back({d, c * sigma2 * std::exp(exponent * d2)});
      }
    }
    if (list.pairs.size() > begin) list.groups.push_back({z, begin, list.pairs.size()});
  }
}

FlowDirection flow_direction(const PairList& list, double length_scale, double a2, double b2) {
  FlowDirection direction;
  for (const auto& group : list.groups) {
    Vector3 sum = Vector3::Zero();
    for (const auto& [d, w] : list.of(group)) sum += w * d;
    direction.omega += sum.cross(group.z);  // x x z~ = (x - z~) x z~
    direction.v -= sum;
  }
  const double ell2 = length_scale * length_scale;
  direction.omega /= a2 * ell2;
  direction.v /= b2 * ell2;
  return direction;
}

std::array<double, 4> step_expansion(const PairList& list, const FlowDirection& direction,
                                     double length_scale) {
  const double inv2 = 1 / (length_scale * length_scale);
  const Vector3& omega = direction.omega;
  std::array<double, 4> g{};
  for (const auto& group : list.groups) {
    const Vector3 u = omega.cross(group.z) + direction.v;
    const Vector3 wu = omega.cross(u);
    const Vector3 wwu = omega.cross(wu);
    const Vector3 wwwu = omega.cross(wwu);
    const double u2 = u.squaredNorm();
    const double wu2 = wu.squaredNorm();
    for (const auto& [d, w] : list.of(group)) {
      // ln k along the flow: Taylor coefficients of t, t^2, t^3, t^4.
      const double beta = -inv2 * u.dot(d);
      const double gamma = -inv2 / 2 * (u2 - wu.dot(d));
      const double delta = -inv2 / 6 * wwu.dot(d);
      const double eps = inv2 / 24 * (wu2 + wwwu.dot(d));
      // k itself, by the exponential series of the above.
      const double beta2 = beta * beta;
      g[0] += w * beta;
      g[1] += w * (gamma + beta2 / 2);
      g[2] += w * (delta + beta * gamma + beta2 * beta / 6);
      g[3] += w * (eps + beta * delta + beta2 * gamma / 2 + gamma * gamma / 2 + beta2 * beta2 / 24);
    }
  }
  return g;
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

LevelResult gradient_flow(const Objective& objective, const PointCloud& moving,
                          const SE3& T_fixed_moving_init, int max_iterations,
                          const RegistrationOptions& options, const Executor& executor) {
  const FlowOptions& flow = options.flow;
  const double ell = objective.length_scale();
  const double ell2 = ell * ell;
  LevelResult state{T_fixed_moving_init, {}, 0, false};
  PairList list;
  while (state.iterations < max_iterations && !state.converged) {
    find_pairs(objective.grid(), moving, state.T_fixed_moving, options.kernel, ell, list);
    if (list.pairs.empty()) break;
    ++state.iterations;
    const FlowDirection xi = flow_direction(list, ell, flow.metric_a2, flow.metric_b2);
    // Step limits and the gradient's threshold are stated for a flow without the factor 1/ell^2:
    // its time runs slower by ell^2.
    if (ell2 * xi.omega.norm() < flow.min_gradient && ell2 * xi.v.norm() < flow.min_gradient) {
      state.converged = true;
      break;
    }
    const auto root = smallest_positive_stationary_point(step_expansion(list, xi, ell));
    const double t = std::min(root.value_or(flow.fallback_step * ell2), flow.max_step * ell2);
    Vector6 step;
    step << -t * xi.v, -t * xi.omega;
    state.T_fixed_moving = (SE3::exp(step) * state.T_fixed_moving).normalized();
    state.converged = matrix_norm(step) < flow.min_step;
  }
  state.value = objective.evaluate(moving, state.T_fixed_moving, executor);
  return state;
}

}  // namespace cvo_slam
