// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/frontend/registration.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/exclusive_access.h"
#include "cvo_slam/frontend/depth_uncertainty_internal.h"
#include "cvo_slam/frontend/kernel_shape_internal.h"
#include "cvo_slam/frontend/solvers_internal.h"

namespace cvo_slam {

struct Registration::Impl {
  Impl(const RegistrationOptions& options_in, int threads)
      : options(options_in), executor(threads) {}

  std::atomic_flag in_use;  // see ExclusiveAccess
  RegistrationOptions options;
  Executor executor;
  std::vector<double> scales;     // length scales in use, coarse to fine
  std::vector<Objective> levels;  // the fixed cloud at each of them; there may be more, unused
  Objective judged;               // the fixed cloud at the judged length scale, with balls
  double fixed_squared_norm = 0;  // of `judged`
  PairTable pairs;                // memory
  NeighborGrid moving_grid;       // memory
  PointsByDepth by_depth;         // memory

  /// The list's last entry holds for all levels after it.
  [[nodiscard]] int max_iterations(std::size_t level) const {
    return options.max_iterations[std::min(level, options.max_iterations.size() - 1)];
  }

  /// Returns how many of a cloud's points a level uses.
  [[nodiscard]] std::size_t points_at(std::size_t level, std::size_t size) const {
    constexpr double kLeastShare = 0.125;  // fewer lead nowhere
    constexpr double kAlike = 1.25;        // length scales that differ by less share their pairs
    const double ratio = scales[level] / scales.back();
    const double share =
        ratio < kAlike ? 1.0
                       : std::max(kLeastShare, std::pow(options.coarser_share, std::log2(ratio)));
    return static_cast<std::size_t>(std::ceil(share * static_cast<double>(size)));
  }

  void set_fixed(const PointCloud& fixed);
  [[nodiscard]] StopRule stop_rule(std::size_t level) const;
  LevelResult run_level(std::size_t level, const PointCloud& moving, const SE3& T_init);
  Approach approach(const PointCloud& moving, const SE3& T_init, int skip);
  RegistrationResult refine(const PointCloud& moving, const Approach& start);
  ObjectiveValue judge(const PointCloud& moving, const LevelResult& state);
  RegistrationResult assess(const PointCloud& moving, const LevelResult& state,
                            const ObjectiveValue& seen);
};

namespace {

/// Noise of a depth over its square below which depth is clean [1/m]: a renderer's, or an average
/// of many images.
constexpr double kCleanNoise = 1e-4;

RegistrationResult failed(const SE3& T, const std::string& reason) {
  RegistrationResult result;
  result.T_fixed_moving = T;
  result.reason = reason;
  return result;
}

/// Converts the information of a left perturbation, exp(xi) T, to that of a right one, T exp(xi).
Matrix6 right_information(const Matrix6& left, const SE3& T) {
  const Matrix6 adjoint = T.adjoint();
  return adjoint.transpose() * left * adjoint;
}

/// Returns the negative Hessian, or the majorising one if the former is not positive definite, as
/// away from a maximum. The majorising one always is.
Matrix6 curvature(const ObjectiveValue& value) {
  const Eigen::LLT<AlignedMatrix6> llt{AlignedMatrix6(value.hessian)};
  return llt.info() == Eigen::Success ? value.hessian : value.majorizer;
}

/// Returns true if the points leave a motion free: too few of them, or all on a line. The
/// majorising Hessian is that of point-to-point distances, whatever the weights.
bool is_undetermined(const ObjectiveValue& value) {
  // Single precision leaves 1e-7; points 5 m away within 5 mm of a line give 1e-6.
  constexpr double kMinEigenvalueRatio = 1e-6;
  const AlignedMatrix6 majorizer = value.majorizer;
  const Vector6 eigenvalues =
      Eigen::SelfAdjointEigenSolver<AlignedMatrix6>(majorizer, Eigen::EigenvaluesOnly)
          .eigenvalues();
  return !(eigenvalues.minCoeff() > kMinEigenvalueRatio * eigenvalues.maxCoeff());
}

RegistrationOptions checked_options(RegistrationOptions options) {
  describe(options).check();
  check_consistency(options);
  if (options.solver == Solver::kFlow) {  // the paper's flow is derived for balls
    options.kernel.ray_noise = 0;
    options.kernel.surfaces = false;
  }
  return options;
}

}  // namespace

OptionSet describe(RegistrationOptions& o) {
  return OptionSet()
      .add("length_scales", o.length_scales, {1e-4, 10}, "m",
           "Length scales of the position kernel, coarse to fine, run one after the other for "
           "every pair of clouds. The first reaches motions that the prediction misses by a "
           "decimetre; below the last, recordings of a Kinect do not gain.")
      .expert()
      .add("solver", o.solver, {{"flow", Solver::kFlow}, {"newton", Solver::kNewton}},
           "Solver: newton finds the same maximum as the paper's flow in a fraction of the "
           "iterations.")
      .add("kernel", describe(o.kernel))
      .add("clean_length_scales", o.clean_length_scales, {1e-4, 10}, "m",
           "Finer length scales that follow where the depth is clean: its noise is below 0.1 mm at "
           "1 m and grows with the square of the depth.")
      .add("judged_length_scale", o.judged_length_scale, {1e-4, 10}, "m",
           "Length scale at which overlap and cos_theta are measured, whatever the kernel; the "
           "finest one if that is longer.")
      .add("max_iterations", o.max_iterations, {1, 10000}, "",
           "Largest number of iterations at each length scale; the last entry also holds for those "
           "after it.")
      .add("coarser_share", o.coarser_share, {0.05, 1}, "",
           "Share of the points that a length scale twice the finest uses; four times, the square "
           "of "
           "it, down to an eighth: twice as wide a kernel reaches four times the points of a "
           "surface.")
      .add("tolerance", o.tolerance, {0, 1}, "m and rad",
           "A Newton step that is shorter in translation and in rotation ends a length scale.")
      .add("coarse_tolerance", o.coarse_tolerance, {0, 10}, "",
           "The tolerance of a coarse length scale, as a share of the next length scale.")
      .add("depth_noise", o.depth_noise, {0, 100}, "",
           "Factor on the camera's depth noise, for the covariance: both clouds have it, and "
           "neighbouring points share some of it.")
      .add("information_scale", o.information_scale, {1e-6, 1e6}, "",
           "Factor of the information before the depth noise, calibrated with depth_noise on "
           "synthetic worlds; see docs/theory/tracking.md.");
}

void check_consistency(const RegistrationOptions& options) {
  const double peak = options.kernel.sigma * options.kernel.sigma;
  if (options.kernel.sparsification >= peak) {
    throw OptionError(
        fmt::format("kernel.sparsification={} leaves nothing of a kernel whose peak is sigma^2={}; "
                    "take a smaller one",
                    options.kernel.sparsification, peak));
  }
  check(options.flow);
}

Registration::Registration(const RegistrationOptions& options, int threads)
    : impl_(std::make_unique<Impl>(checked_options(options), threads)) {}

Registration::~Registration() = default;
Registration::Registration(Registration&&) noexcept = default;
Registration& Registration::operator=(Registration&&) noexcept = default;

void Registration::Impl::set_fixed(const PointCloud& fixed) {
  scales = options.length_scales;
  if (static_cast<double>(fixed.surface_noise) < kCleanNoise && options.kernel.surfaces) {
    for (const double scale : options.clean_length_scales) {
      if (scale < scales.back()) scales.push_back(scale);
    }
  }
  pairs.clear();
  by_depth.sort(fixed);
  levels.resize(std::max(levels.size(), scales.size()));
  for (std::size_t level = 0; level < scales.size(); ++level) {
    levels[level].build(fixed, by_depth, points_at(level, fixed.size()), options.kernel,
                        scales[level]);
  }
  KernelOptions ball = options.kernel;
  ball.ray_noise = 0;
  ball.surfaces = false;
  judged.build(fixed, by_depth, fixed.size(), ball,
               std::max(options.judged_length_scale, scales.back()));
  fixed_squared_norm =
      squared_norm(judged.grid(), fixed, judged.kernel(), judged.length_scale(), executor);
}

/// Returns when the search at a level ends. A coarse level need only lead well into the reach of
/// the next one.
StopRule Registration::Impl::stop_rule(std::size_t level) const {
  const double tolerance =
      options.tolerance * std::min(1.0, scales[level] / options.judged_length_scale);
  StopRule rule{max_iterations(level), tolerance, tolerance, false};
  if (level + 1 == scales.size()) return rule;
  const double enough = options.coarse_tolerance * levels[level + 1].length_scale();
  rule.translation = std::max(rule.translation, enough);
  rule.rotation = std::max(rule.rotation, 0.5 * enough);  // of a point 2 m away
  rule.take_last_step = true;
  return rule;
}

LevelResult Registration::Impl::run_level(std::size_t level, const PointCloud& moving,
                                          const SE3& T_init) {
  PoseObjective objective(levels[level], moving, points_at(level, moving.size()), pairs, executor);
  if (options.solver == Solver::kNewton) return newton(objective, T_init, stop_rule(level));
  return gradient_flow(objective, T_init, max_iterations(level), options.flow);
}

/// Runs all levels but the last; a level without overlap changes nothing.
Approach Registration::Impl::approach(const PointCloud& moving, const SE3& T_init, int skip) {
  Approach result{T_init, 0};
  pairs.clear();
  for (auto level = static_cast<std::size_t>(skip); level + 1 < scales.size(); ++level) {
    const LevelResult state = run_level(level, moving, result.T_fixed_moving);
    result.T_fixed_moving = state.T_fixed_moving;
    result.iterations += state.iterations;
  }
  return result;
}

RegistrationResult Registration::Impl::refine(const PointCloud& moving, const Approach& start) {
  const SE3& T_init = start.T_fixed_moving;
  if (scales.empty() || judged.grid().size() == 0) {
    return failed(T_init, "the fixed cloud has no points");
  }
  if (moving.empty()) return failed(T_init, "the moving cloud has no points");
  const LevelResult state = run_level(scales.size() - 1, moving, T_init);
  if (state.value.matched == 0) return failed(T_init, "the clouds do not overlap");
  const ObjectiveValue seen = judge(moving, state);
  if (is_undetermined(seen)) {
    return failed(T_init,
                  "the points that match do not determine the pose: too few, or all on a line");
  }
  RegistrationResult result = assess(moving, state, seen);
  result.iterations = start.iterations + state.iterations;
  return result;
}

/// Returns the objective with balls at the judged length scale.
ObjectiveValue Registration::Impl::judge(const PointCloud& moving, const LevelResult& state) {
  const bool is_known =
      scales.back() == judged.length_scale() && !is_shaped(moving, options.kernel);
  if (is_known) return state.value;
  return PoseObjective(judged, moving, moving.size(), pairs, executor)
      .evaluate(state.T_fixed_moving);
}

RegistrationResult Registration::Impl::assess(const PointCloud& moving, const LevelResult& state,
                                              const ObjectiveValue& seen) {
  RegistrationResult result;
  result.T_fixed_moving = state.T_fixed_moving.normalized();
  result.status =
      state.converged ? RegistrationStatus::kConverged : RegistrationStatus::kIterationLimit;
  result.reason = state.converged ? "converged" : "iteration limit";
  result.objective = state.value.value;
  result.overlap = static_cast<double>(seen.matched) / static_cast<double>(moving.size());
  by_depth.sort(moving);
  moving_grid.build(moving, by_depth, moving.size(),
                    support_radius(judged.kernel(), judged.length_scale()));
  const double moving_squared_norm =
      squared_norm(moving_grid, moving, judged.kernel(), judged.length_scale(), executor);
  // The kernel cut to its support is not positive definite: on a regular lattice the quotient can
  // be larger than one.
  result.cos_theta =
      std::min(1.0, seen.inner_product / std::sqrt(fixed_squared_norm * moving_squared_norm));
  const double mean_weight = state.value.inner_product / static_cast<double>(state.value.matched);
  // Errors of the depth along the rays are independent of what the objective knows.
  result.covariance =
      inverse_of_spd(right_information(curvature(state.value), result.T_fixed_moving) *
                     (options.information_scale / mean_weight)) +
      depth_covariance(moving, options.depth_noise);
  return result;
}

void Registration::set_fixed(const PointCloud& fixed) {
  ExclusiveAccess(impl_, "Registration")->set_fixed(fixed);
}

RegistrationResult Registration::align(const PointCloud& moving, const SE3& T_fixed_moving_init,
                                       int skip) {
  const ExclusiveAccess impl(impl_, "Registration");
  RegistrationResult result =
      impl->refine(moving, impl->approach(moving, T_fixed_moving_init, skip));
  if (result.status == RegistrationStatus::kFailed) result.T_fixed_moving = T_fixed_moving_init;
  return result;
}

Approach Registration::approach(const PointCloud& moving, const SE3& T_fixed_moving_init,
                                int skip) {
  return ExclusiveAccess(impl_, "Registration")->approach(moving, T_fixed_moving_init, skip);
}

RegistrationResult Registration::refine(const PointCloud& moving, const Approach& start) {
  return ExclusiveAccess(impl_, "Registration")->refine(moving, start);
}

RegistrationResult align(const PointCloud& fixed, const PointCloud& moving,
                         const SE3& T_fixed_moving_init, const RegistrationOptions& options) {
  Registration registration(options);
  registration.set_fixed(fixed);
  return registration.align(moving, T_fixed_moving_init);
}

}  // namespace cvo_slam
