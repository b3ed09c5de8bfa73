// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "cvo_slam/core/options.h"
#include "cvo_slam/core/parallel.h"
#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/frontend/kernel.h"

namespace cvo_slam {

enum class Solver {
  kFlow,    ///< the paper's gradient flow on SE(3)
  kNewton,  ///< second-order steps on the same objective
};

/// The paper's gradient flow: M. Ghaffari et al., "Continuous Direct Sparse Visual Odometry from
/// RGB-D Images", RSS 2019.
struct FlowOptions {
  double metric_a2 = 7.0;
  double metric_b2 = 7.0;
  double max_step = 0.8;
  double fallback_step = 0.2;
  double min_step = 1e-5;
  double min_gradient = 5e-5;
};

struct RegistrationOptions {
  Solver solver = Solver::kNewton;
  KernelOptions kernel;
  std::vector<double> length_scales = {0.1, 0.05, 0.025, 0.015};
  /// Most iterations at each length scale; the last entry holds for the scales after it.
  std::vector<int> max_iterations = {5, 5, 5, 10};
  double coarser_share = 0.5;
  double tolerance_translation = 1e-4;
  double tolerance_rotation = 1e-4;
  double coarse_tolerance = 0.1;
  double depth_noise = 0.0065;
  double information_scale = 3;
  FlowOptions flow;
};

[[nodiscard]] OptionSet describe(FlowOptions& options);
[[nodiscard]] OptionSet describe(RegistrationOptions& options);

/// Throws OptionError where options that are each in range contradict one another.
void check_consistency(const RegistrationOptions& options);

enum class RegistrationStatus {
  kConverged,
  kIterationLimit,  ///< usable, but the last step was not below the tolerance
  kFailed,          ///< no pose: see reason
};

struct RegistrationResult {
  SE3 T_fixed_moving;
  RegistrationStatus status = RegistrationStatus::kFailed;
  std::string reason;  ///< why it ended as it did, in words
  int iterations = 0;  ///< over all length scales
  /// sum c max(k - sparsification, 0) at the final pose and length scale.
  double objective = 0;
  /// Share of moving points with a fixed point inside the kernel's support at the final length
  /// scale, in [0, 1].
  double overlap = 0;
  /// <f_X, h.f_Z> / (|f_X| |f_Z|) at the final length scale, in [0, 1].
  double cos_theta = 0;
  /// Information (inverse covariance) of a right perturbation of T_fixed_moving, tangent order
  /// [translation; rotation]: the negative second derivative of the objective, scaled so that a
  /// moving point counts as one measurement with the final length scale and its depth noise as
  /// standard deviation, times information_scale, less what the depth noise adds along the rays;
  /// positive definite. Where the search ended away from a maximum it is that of the majorising
  /// least squares.
  Matrix6 information = Matrix6::Zero();
};

/// Where a registration stands before its last length scale.
struct Approach {
  SE3 T_fixed_moving;
  int iterations = 0;
};

/// Registration against one fixed cloud: neighbour search is prepared once per length scale and
/// serves every moving cloud.
class Registration {
 public:
  /// Throws OptionError where an option is out of range.
  explicit Registration(const RegistrationOptions& options = {}, int threads = 1);
  ~Registration();
  Registration(Registration&& other) noexcept;
  Registration& operator=(Registration&& other) noexcept;

  /// Makes `fixed` the cloud that others are aligned to. It is copied.
  void set_fixed(const PointCloud& fixed);
  /// The pose that maps `moving` onto the fixed cloud, searched from T_fixed_moving_init.
  /// Never throws: clouds without points or without overlap give kFailed and a reason.
  /// One call at a time: it works in memory of the object.
  /// `skip` leaves out that many of the coarsest length scales, but not the last one.
  [[nodiscard]] RegistrationResult align(const PointCloud& moving, const SE3& T_fixed_moving_init,
                                         int skip = 0);
  /// align() in two parts, for a caller that can improve the moving cloud where its pose is nearly
  /// known: all length scales but the last, and the last alone.
  [[nodiscard]] Approach approach(const PointCloud& moving, const SE3& T_fixed_moving_init,
                                  int skip = 0);
  [[nodiscard]] RegistrationResult refine(const PointCloud& moving, const Approach& start);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The pose T_fixed_moving that best maps `moving` onto `fixed`.
[[nodiscard]] RegistrationResult align(const PointCloud& fixed, const PointCloud& moving,
                                       const SE3& T_fixed_moving_init = {},
                                       const RegistrationOptions& options = {});

}  // namespace cvo_slam
