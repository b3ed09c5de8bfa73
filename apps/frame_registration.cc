// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/frame_registration.h"

#include <array>

#include <Eigen/LU>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cvo_slam/apps/sequence_run.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/frontend/point_selection.h"

namespace cvo_slam {
namespace {

/// Returns why a tracker would reject the result; empty if it would not.
std::string rejection_of(const RegistrationResult& result, const LostOptions& limits) {
  if (result.overlap < limits.min_overlap) {
    return fmt::format("overlap {:.2f} is below lost.min_overlap={}", result.overlap,
                       limits.min_overlap);
  }
  if (result.cos_theta < limits.min_cos_theta) {
    return fmt::format("cos_theta {:.2f} is below lost.min_cos_theta={}", result.cos_theta,
                       limits.min_cos_theta);
  }
  return {};
}

PointCloud points_of(const RgbdFrame& frame, const std::string& name, const Camera& camera,
                     int count, const TrackerOptions& options) {
  PointCloud cloud = select_points(frame, camera, count, options.selection);
  if (cloud.size() < static_cast<std::size_t>(options.lost.min_points)) {
    throw DataError(fmt::format(
        "{} has {} points with gradient and depth, {} are needed (lost.min_points); take another",
        name, cloud.size(), options.lost.min_points));
  }
  return cloud;
}

std::array<double, 3> components(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

std::string motion_text(const SE3& T) {
  return fmt::format("{:.1f} mm, {:.3f} deg", T.translation().norm() * kMillimetres,
                     T.angle() * kDegrees);
}

}  // namespace

Vector6 standard_deviations(const RegistrationResult& result) {
  return result.covariance.diagonal().cwiseSqrt();
}

FrameRegistration register_frames(const FramePair& pair, const TrackerOptions& options) {
  const double start = process_cpu_seconds();
  FrameRegistration registration;
  registration.points_a =
      points_of(pair.a, pair.name_a, pair.camera, options.keyframe_points, options);
  registration.points_b = points_of(pair.b, pair.name_b, pair.camera, options.points, options);
  Registration solver(options.registration, options.threads);
  solver.set_fixed(registration.points_a);
  registration.result = solver.align(registration.points_b, SE3());
  registration.cpu_seconds = process_cpu_seconds() - start;
  const RegistrationResult& result = registration.result;
  if (result.status == RegistrationStatus::kFailed) {
    throw DataError(
        fmt::format("{} and {} cannot be registered: {}", pair.name_a, pair.name_b, result.reason));
  }
  registration.rejection = rejection_of(result, options.lost);
  registration.length_scale = options.registration.length_scales.back();
  const auto similarity_at = [&](const SE3& T) {
    return similarity(registration.points_a, registration.points_b, T, options.registration.kernel,
                      registration.length_scale);
  };
  registration.before = similarity_at(SE3());
  registration.after = similarity_at(result.T_fixed_moving);
  return registration;
}

std::string to_table(const FramePair& pair, const FrameRegistration& registration) {
  const RegistrationResult& result = registration.result;
  const SE3& T = result.T_fixed_moving;
  const Eigen::Vector4d q = T.quaternion();
  const Vector6 deviations = standard_deviations(result);
  const CloudSimilarity& before = registration.before;
  const CloudSimilarity& after = registration.after;
  std::string text = fmt::format("a              {}{}\nb              {}{}\n", pair.name_a,
                                 pair.source.empty() ? "" : " of " + pair.source, pair.name_b,
                                 pair.seconds ? fmt::format(", {:+.3f} s", *pair.seconds) : "");
  text += fmt::format("T_a_b          {:.6f}  qx qy qz qw {:.6f}\n",
                      fmt::join(components(T.translation()), " "),
                      fmt::join(q.data(), q.data() + 4, " "));
  text += fmt::format("motion         {}\n", motion_text(T));
  text += fmt::format("deviations     x y z {:.2f} mm, about x y z {:.4f} deg\n",
                      fmt::join(components(deviations.head<3>() * kMillimetres), " "),
                      fmt::join(components(deviations.tail<3>() * kDegrees), " "));
  if (pair.T_a_b_truth) {
    text += fmt::format("error          {} from the reference\n",
                        motion_text(pair.T_a_b_truth->inverse() * T));
  }
  text += fmt::format("cos_theta      {:.4f}, {:.4f} before\n", after.cos_theta, before.cos_theta);
  text += fmt::format("inner product  {:.6g}, {:.6g} before\n", after.inner_product,
                      before.inner_product);
  text += fmt::format("overlap        {:.1f} %, {:.1f} % before\n", 100 * after.overlap,
                      100 * before.overlap);
  text += fmt::format("kernel matrix  {} x {}, {} entries, {} before (length scale {} m)\n",
                      registration.points_a.size(), registration.points_b.size(), after.entries,
                      before.entries, registration.length_scale);
  text += fmt::format("iterations     {}, {}\n", result.iterations, result.reason);
  text += fmt::format("CPU time       {:.1f} ms\n", registration.cpu_seconds * 1000);
  if (!registration.rejection.empty())
    text += fmt::format("rejected       {}\n", registration.rejection);
  return text;
}

}  // namespace cvo_slam
