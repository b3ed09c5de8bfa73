// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include "cvo_slam/slam/pair_registration_internal.h"

namespace cvo_slam {
namespace {

/// Figures of two registrations that agree, without the comparison with a prior.
PairVerdict compare(const RegistrationResult& there, const RegistrationResult& back) {
  PairVerdict verdict;
  verdict.overlap = std::min(there.overlap, back.overlap);
  verdict.cos_theta = std::min(there.cos_theta, back.cos_theta);
  const SE3 round_trip = there.T_fixed_moving * back.T_fixed_moving;
  verdict.round_trip_translation = round_trip.translation().norm();
  verdict.round_trip_rotation = round_trip.angle();
  return verdict;
}

/// Distance of a measurement from the prior in standard deviations of both.
double prior_error(const PairMeasurement& measurement, const PairPrior& prior,
                   const SE3& T_prior_measured) {
  const AlignedMatrix6 covariance = prior.covariance + measurement.covariance;
  const Eigen::Matrix<double, 6, 1> error = T_prior_measured.log();
  return std::sqrt(error.dot(covariance.ldlt().solve(error)));
}

/// Why a pair is not believed; empty if it is.
std::string find_fault(const PairVerdict& v, double usual_cos_theta, const PairOptions& o) {
  if (v.overlap < o.min_overlap) {
    return fmt::format("overlap {:.2f} is below {:.2f}", v.overlap, o.min_overlap);
  }
  if (v.cos_theta < o.min_cos_theta * usual_cos_theta) {
    return fmt::format("cos_theta {:.2f} is below {:.2f} of the usual {:.2f}", v.cos_theta,
                       o.min_cos_theta, usual_cos_theta);
  }
  if (v.round_trip_translation > o.max_round_trip_translation ||
      v.round_trip_rotation > o.max_round_trip_rotation) {
    return fmt::format("there and back is {:.3f} m and {:.3f} rad", v.round_trip_translation,
                       v.round_trip_rotation);
  }
  if (v.error > o.max_error)
    return fmt::format("{:.1f} standard deviations from the graph", v.error);
  return {};
}

}  // namespace

PointCloud first_points(const PointCloud& cloud, int count) {
  PointCloud result = cloud;
  result.resize(std::min(cloud.size(), static_cast<std::size_t>(count)));
  return result;
}

Matrix6 RegistrationNoise::added_to(Matrix6 covariance) const {
  covariance.diagonal().head<3>().array() += translation * translation;
  covariance.diagonal().tail<3>().array() += rotation * rotation;
  return covariance;
}

PairRegistration::PairRegistration(const RegistrationOptions& registration, int threads,
                                   const PairOptions& options, const RegistrationNoise& noise)
    : options_(options),
      noise_(noise),
      to_newer_(registration, threads),
      to_older_(registration, threads) {}

void PairRegistration::set_newer(const PointCloud& cloud) {
  to_newer_.set_fixed(cloud);
  newer_cloud_ = first_points(cloud, options_.points);
}

PairVerdict PairRegistration::register_both_ways(const PointCloud& older_cloud,
                                                 const SE3& T_older_newer, const PairPrior* prior,
                                                 double usual_cos_theta) {
  // The fixed cloud of this way is set once for all pairs; the other way builds neighbour grids for
  // each.
  const RegistrationResult back = to_newer_.align(first_points(older_cloud, options_.points),
                                                  T_older_newer.inverse(), options_.skip_scales);
  if (back.status == RegistrationStatus::kFailed || back.overlap < options_.min_overlap) {
    PairVerdict verdict;
    verdict.overlap = back.overlap;
    verdict.cos_theta = back.cos_theta;
    verdict.reason = back.status == RegistrationStatus::kFailed
                         ? back.reason
                         : find_fault(verdict, usual_cos_theta, options_);  // fails by its overlap
    return verdict;
  }
  to_older_.set_fixed(older_cloud);
  const RegistrationResult there =
      to_older_.align(newer_cloud_, T_older_newer, options_.skip_scales);
  if (there.status == RegistrationStatus::kFailed) return PairVerdict::rejected(there.reason);
  PairVerdict verdict = compare(there, back);
  // Each way has points of its own; the middle has less noise than either. The covariance is that
  // of one way, not halved: the two ways share the noise of the same two depth images.
  const SE3 T_middle =
      interpolate(there.T_fixed_moving, back.T_fixed_moving.inverse(), 0.5).normalized();
  const PairMeasurement measurement{T_middle, noise_.added_to(there.covariance)};
  if (prior != nullptr) {
    const SE3 T_prior_measured = prior->T_older_newer.inverse() * measurement.T_older_newer;
    verdict.correction_translation = T_prior_measured.translation().norm();
    verdict.correction_rotation = T_prior_measured.angle();
    verdict.error = prior_error(measurement, *prior, T_prior_measured);
  }
  verdict.reason = find_fault(verdict, usual_cos_theta, options_);
  if (verdict.reason.empty()) verdict.measurement = measurement;
  return verdict;
}

}  // namespace cvo_slam
