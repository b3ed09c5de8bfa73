// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/frontend/registration.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "cvo_slam/frontend/gradient_flow_internal.h"
#include "cvo_slam/frontend/newton_internal.h"

namespace cvo_slam {

struct Registration::Impl {
  RegistrationOptions options;
  Executor executor;
  std::vector<Objective> levels;
  double fixed_squared_norm = 0;  // at the last level

  [[nodiscard]] LevelResult run_level(std::size_t level, const PointCloud& moving,
                                      const SE3& T_init) const {
    const auto& limits = options.max_iterations;
    const int limit = limits[std::min(level, limits.size() - 1)];
    const auto solve = options.solver == Solver::kFlow ? gradient_flow : newton;
    return solve(levels[level], moving, T_init, limit, options, executor);
  }
};

namespace {

RegistrationResult failed(const SE3& T, const std::string& reason) {
  RegistrationResult result;
  result.T_fixed_moving = T;
  result.reason = reason;
  return result;
}

/// The information of a right perturbation, T exp(xi), from a Hessian for a left one, exp(xi) T.
Matrix6 right_information(const Matrix6& left, const SE3& T) {
  const Matrix6 adjoint = T.adjoint();
  return adjoint.transpose() * left * adjoint;
}

/// The negative Hessian, or where it is not positive definite, as away from a maximum, the
/// majorising one, which is.
Matrix6 curvature(const ObjectiveValue& value) {
  const Eigen::LLT<Eigen::Matrix<double, 6, 6>> llt{Eigen::Matrix<double, 6, 6>(value.hessian)};
  return llt.info() == Eigen::Success ? value.hessian : value.majorizer;
}

/// True where the points leave a motion free: too few of them, or all on a line. The majorising
/// Hessian is that of point-to-point distances, whatever the weights.
bool is_undetermined(const ObjectiveValue& value) {
  constexpr double kMinEigenvalueRatio = 1e-10;
  const Eigen::Matrix<double, 6, 6> majorizer = value.majorizer;
  const Vector6 eigenvalues =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>(majorizer, Eigen::EigenvaluesOnly)
          .eigenvalues();
  return !(eigenvalues.minCoeff() > kMinEigenvalueRatio * eigenvalues.maxCoeff());
}

RegistrationOptions checked(RegistrationOptions options) {
  describe(options).check();
  check_consistency(options);
  return options;
}

}  // namespace

Registration::Registration(const RegistrationOptions& options, int threads)
    : impl_(std::make_unique<Impl>(Impl{checked(options), Executor(threads), {}, 0})) {}

Registration::~Registration() = default;
Registration::Registration(Registration&&) noexcept = default;
Registration& Registration::operator=(Registration&&) noexcept = default;

void Registration::set_fixed(const PointCloud& fixed) {
  const auto& scales = impl_->options.length_scales;
  impl_->levels.resize(scales.size());
  for (std::size_t level = 0; level < scales.size(); ++level) {
    impl_->levels[level].build(fixed, impl_->options.kernel, scales[level]);
  }
  impl_->fixed_squared_norm = impl_->levels.back().squared_norm(fixed);
}

RegistrationResult Registration::align(const PointCloud& moving,
                                       const SE3& T_fixed_moving_init) const {
  if (impl_->levels.empty() || impl_->levels.back().grid().size() == 0) {
    return failed(T_fixed_moving_init, "the fixed cloud has no points");
  }
  if (moving.empty()) return failed(T_fixed_moving_init, "the moving cloud has no points");

  LevelResult state{T_fixed_moving_init, {}, 0, false};
  int iterations = 0;
  for (std::size_t level = 0; level < impl_->levels.size(); ++level) {
    state = impl_->run_level(level, moving, state.T_fixed_moving);
    iterations += state.iterations;
  }
  if (state.value.matched == 0) return failed(T_fixed_moving_init, "the clouds do not overlap");
  if (is_undetermined(state.value)) {
    return failed(T_fixed_moving_init,
                  "the points that match do not determine the pose: too few, or all on a line");
  }

  RegistrationResult result;
  result.T_fixed_moving = state.T_fixed_moving.normalized();
  result.status =
      state.converged ? RegistrationStatus::kConverged : RegistrationStatus::kIterationLimit;
  result.reason = state.converged ? "converged" : "iteration limit";
  result.iterations = iterations;
  result.objective = state.value.value;
  result.overlap = static_cast<double>(state.value.matched) / static_cast<double>(moving.size());
  const Objective& finest = impl_->levels.back();
  // The kernel cut to its support is not positive definite: on a regular lattice the quotient can
  // be larger than one.
  result.cos_theta =
      std::min(1.0, state.value.inner_product /
                        std::sqrt(impl_->fixed_squared_norm * finest.squared_norm(moving)));
  const double mean_weight = state.value.inner_product / static_cast<double>(state.value.matched);
  result.information =
      right_information(curvature(state.value), result.T_fixed_moving) / mean_weight;
  return result;
}

RegistrationResult align(const PointCloud& fixed, const PointCloud& moving,
                         const SE3& T_fixed_moving_init, const RegistrationOptions& options) {
  Registration registration(options);
  registration.set_fixed(fixed);
  return registration.align(moving, T_fixed_moving_init);
}

}  // namespace cvo_slam
