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

namespace cvo_slam {

/// The inner product of the labels of two points.
enum class ColorKernel {
  kLinear,              ///< `1e-5 <rgb, rgb>`: the paper's choice
  kSquaredExponential,  ///< exp(-|d color|^2 / (2 s_c^2) - |d gradient|^2 / (2 s_g^2))
};

/// The kernels of the function space: k(x, y) = sigma^2 exp(-|x - y|^2 / (2 ell^2)) on positions,
/// and the inner product c of labels. A pair of points weighs c k.
struct KernelOptions {
  /// Amplitude of the position kernel; only sigma^2 / sparsification matters.
  double sigma = 0.1;
  /// Least value of k that counts, so that pairs further apart than
  /// ell sqrt(2 ln(sigma^2 / sparsification)) need not be looked at.
  double sparsification = 1e-3;
  ColorKernel color_kernel = ColorKernel::kSquaredExponential;  ///< how labels are compared
  double color_scale = 60.0;                                    ///< s_c, on 8-bit values
  double gradient_scale = 60.0;                                 ///< s_g, on 8-bit values a pixel
  /// Factor on PointCloud::ray_noise of the moving points. The kernel is longer along a point's ray
  /// d: its covariance is ell^2 I + (factor noise)^2 d d^T. 0 = it is not.
  double ray_noise = 0.4;
  /// True for kernels that are thin across the surface of a moving point (PointCloud::surfaces), as
  /// far as the noise of its depth allows.
  bool surfaces = true;
};

/// Returns the distance beyond which the sparsified kernel is zero [m].
[[nodiscard]] double support_radius(const KernelOptions& options, double length_scale);

/// Returns c, the inner product of the labels of a[i] and b[j].
[[nodiscard]] double label_product(const KernelOptions& options, const PointCloud& a, std::size_t i,
                                   const PointCloud& b, std::size_t j);

/// How the pose of largest objective is searched.
enum class Solver {
  kFlow,    ///< the paper's gradient flow on SE(3)
  kNewton,  ///< second-order steps on the same objective
};

/// Constants of the paper's gradient flow: M. Ghaffari et al., "Continuous Direct Sparse Visual
/// Odometry from RGB-D Images", RSS 2019. They can be changed in code, not by options.
struct FlowConstants {
  double metric_a2 = 7.0;      ///< a^2, weight of rotations in the metric
  double metric_b2 = 7.0;      ///< b^2, weight of translations in the metric
  double max_step = 0.8;       ///< longest step in time of the flow without 1/ell^2
  double fallback_step = 0.2;  ///< step if the expansion has no stationary point
  double min_step = 1e-5;      ///< a step with a smaller distance |log|_F on SE(3) is the last one
  double min_gradient = 5e-5;  ///< a flow without 1/ell^2 that is slower in both parts has ended
};

/// How a cloud is registered to another one.
struct RegistrationOptions {
  /// Length scales of the position kernel [m], run one after the other for every pair of clouds,
  /// coarse to fine. The first reaches motions that the prediction misses by a decimetre; below the
  /// last, recordings of a Kinect do not gain. Scale them with the depth noise of the sensor;
  /// coarse scales alone are biased towards dense regions.
  std::vector<double> length_scales = {0.1, 0.05, 0.025, 0.015, 0.0125};
  /// Finer ones that follow where the depth is clean (PointCloud::surface_noise below 0.1 mm/m^2)
  /// [m].
  std::vector<double> clean_length_scales = {0.007};
  /// Length scale at which overlap and cos_theta are measured, with a ball, or the finest one if
  /// that is longer [m]: so they mean the same whatever the kernel.
  double judged_length_scale = 0.015;
  Solver solver = Solver::kNewton;  ///< how the pose is searched
  KernelOptions kernel;             ///< what makes two points similar
  /// Largest number of iterations at each length scale; the last entry holds for the scales after
  /// it.
  std::vector<int> max_iterations = {5, 5, 5, 10};
  double coarser_share = 0.5;  ///< share of the points at twice the finest scale
  /// A shorter Newton step ends a length scale [m] and [rad]; at a finer scale than
  /// judged_length_scale by so much less.
  double tolerance = 1e-4;
  double coarse_tolerance = 0.1;   ///< the same at coarse scales, as a share of the next scale
  double depth_noise = 2.2;        ///< factor on PointCloud::ray_noise, for the covariance
  double information_scale = 1.5;  ///< factor of the information before the depth noise
  FlowConstants flow;              ///< used by Solver::kFlow only
};

///@{
/// Returns the options with their keys, ranges and documentation.
[[nodiscard]] OptionSet describe(KernelOptions& options);
[[nodiscard]] OptionSet describe(RegistrationOptions& options);
///@}

/// Throws OptionError if options that are each in range contradict one another, or a constant of
/// the flow is impossible.
void check_consistency(const RegistrationOptions& options);

/// How a registration ended.
enum class RegistrationStatus {
  kConverged,       ///< the last step was below the tolerance
  kIterationLimit,  ///< usable, but the last step was not below the tolerance
  kFailed,          ///< no pose: see reason
};

/// The pose of a cloud in the frame of another one, and how far it can be trusted.
struct RegistrationResult {
  SE3 T_fixed_moving;  ///< pose that maps the moving cloud onto the fixed one; if failed, the start
  RegistrationStatus status = RegistrationStatus::kFailed;  ///< how the search ended
  std::string reason;                                       ///< why it ended as it did, in words
  int iterations = 0;                                       ///< over all length scales
  /// Sum of c max(k - sparsification, 0) over the pairs of points, at the final pose and length
  /// scale.
  double objective = 0;
  /// Share of the moving points with a fixed point inside the kernel's support at the judged length
  /// scale, in [0, 1].
  double overlap = 0;
  /// `<f_X, h.f_Z> / (|f_X| |f_Z|)` at the judged length scale, in [0, 1].
  double cos_theta = 0;
  /// Covariance of a right perturbation of T_fixed_moving, tangent order [translation; rotation];
  /// positive definite. It is the inverse of the negative second derivative of the objective,
  /// scaled so that a moving point counts as one measurement with its kernel as covariance, times
  /// information_scale; plus the effect of the depth noise along the rays. If the search ended away
  /// from a maximum, the second derivative is that of the majorising least squares. Zero if the
  /// registration failed.
  Matrix6 covariance = Matrix6::Zero();
};

/// The state of a registration before its last length scale.
struct Approach {
  SE3 T_fixed_moving;  ///< the pose found so far
  int iterations = 0;  ///< over all length scales so far
};

/// Registration to one fixed cloud: neighbour search is prepared once per length scale and serves
/// every moving cloud. An object works in memory of its own: it serves one thread at a time, and
/// none after it was moved from; every function throws UsageError otherwise.
class Registration {
 public:
  /// Throws OptionError if an option is out of range.
  explicit Registration(const RegistrationOptions& options = {}, int threads = 1);
  ~Registration();
  ///@{
  /// Takes over the state of `other`, whose functions throw UsageError from then on.
  Registration(Registration&& other) noexcept;
  Registration& operator=(Registration&& other) noexcept;
  ///@}

  /// Makes `fixed` the cloud that others are aligned to. It is copied.
  void set_fixed(const PointCloud& fixed);
  /// Returns the pose that maps `moving` onto the fixed cloud, searched from T_fixed_moving_init.
  /// Clouds without points or without overlap give kFailed and a reason; they do not throw.
  /// `skip` leaves out that many of the coarsest length scales, but not the last one.
  [[nodiscard]] RegistrationResult align(const PointCloud& moving, const SE3& T_fixed_moving_init,
                                         int skip = 0);
  /// Runs all length scales but the last. approach() and refine() are align() in two parts, for a
  /// caller that can improve the moving cloud once its pose is nearly known.
  [[nodiscard]] Approach approach(const PointCloud& moving, const SE3& T_fixed_moving_init,
                                  int skip = 0);
  /// Runs the last length scale. The cloud has the points of approach()'s, perhaps at better
  /// places.
  [[nodiscard]] RegistrationResult refine(const PointCloud& moving, const Approach& start);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Returns the pose T_fixed_moving that best maps `moving` onto `fixed`.
[[nodiscard]] RegistrationResult align(const PointCloud& fixed, const PointCloud& moving,
                                       const SE3& T_fixed_moving_init = {},
                                       const RegistrationOptions& options = {});

}  // namespace cvo_slam
