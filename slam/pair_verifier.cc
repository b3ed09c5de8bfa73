// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <fmt/format.h>

#include "cvo_slam/slam/proximity_internal.h"

namespace cvo_slam {
namespace {

PointCloud first_points(const PointCloud& cloud, int count) {
  const auto n =
      static_cast<std::ptrdiff_t>(std::min(cloud.size(), static_cast<std::size_t>(count)));
  const auto head = [n](const std::vector<float>& v) {
    return std::vector<float>(v.begin(), v.begin() + n);
  };
  PointCloud result{head(cloud.x), head(cloud.y), head(cloud.z), {}, head(cloud.u), head(cloud.v)};
  for (std::size_t i = 0; i < PointCloud::kFeatures; ++i) {
    result.features[i] = head(cloud.features[i]);
  }
  return result;
}

/// Puts into the candidate what the two registrations say of themselves and of one another.
void compare(const RegistrationResult& there, const RegistrationResult& back,
             LoopCandidate& candidate) {
  candidate.overlap = std::min(there.overlap, back.overlap);
  candidate.cos_theta = std::min(there.cos_theta, back.cos_theta);
  const SE3 round_trip = there.T_fixed_moving * back.T_fixed_moving;
  candidate.round_trip_translation = round_trip.translation().norm();
  candidate.round_trip_rotation = round_trip.angle();
}

/// Puts into the candidate how far the measurement is from the graph.
void compare(const PairMeasurement& measurement, const PairPrior& prior, LoopCandidate& candidate) {
  const SE3 correction = prior.T_older_newer.inverse() * measurement.T_older_newer;
  candidate.correction_translation = correction.translation().norm();
  candidate.correction_rotation = correction.angle();
  const AlignedMatrix6 information = measurement.information;
  const AlignedMatrix6 covariance = AlignedMatrix6(prior.covariance) + information.inverse();
  const Eigen::Matrix<double, 6, 1> error = correction.log();
  candidate.error = std::sqrt(error.dot(covariance.ldlt().solve(error)));
}

/// Why a pair is not believed; empty where it is.
std::string find_fault(const LoopCandidate& c, double usual_cos_theta, const PairOptions& o) {
  if (c.overlap < o.min_overlap) {
    return fmt::format("overlap {:.2f} is below {:.2f}", c.overlap, o.min_overlap);
  }
  if (c.cos_theta < o.min_cos_theta * usual_cos_theta) {
    return fmt::format("cos_theta {:.2f} is below {:.2f} of the usual {:.2f}", c.cos_theta,
                       o.min_cos_theta, usual_cos_theta);
  }
  if (c.round_trip_translation > o.max_round_trip_translation ||
      c.round_trip_rotation > o.max_round_trip_rotation) {
    return fmt::format("there and back is {:.3f} m and {:.3f} rad", c.round_trip_translation,
                       c.round_trip_rotation);
  }
  if (c.error > o.max_error) {
    return fmt::format("{:.1f} standard deviations from the graph", c.error);
  }
  return {};
}

}  // namespace

PairVerifier::PairVerifier(const RegistrationOptions& registration, int threads,
                           const PairOptions& options, const RegistrationNoise& noise)
    : options_(options),
      noise_(noise),
      to_newest_(registration, threads),
      to_older_(registration, threads) {}

void PairVerifier::set_newest(const PointCloud& cloud) {
  to_newest_.set_fixed(cloud);
  newest_ = first_points(cloud, options_.points);
}

std::optional<PairMeasurement> PairVerifier::verify(const PointCloud& older,
                                                    const SE3& T_older_newer,
                                                    const PairPrior* prior, double usual_cos_theta,
                                                    LoopCandidate& candidate) {
  const RegistrationResult back = to_newest_.align(first_points(older, options_.points),
                                                   T_older_newer.inverse(), options_.skip_scales);
  // The way back costs nothing new to prepare; where it fails the way there need not be tried.
  if (back.status == RegistrationStatus::kFailed || back.overlap < options_.min_overlap) {
    candidate.overlap = back.overlap;
    candidate.cos_theta = back.cos_theta;
    candidate.reason = back.status == RegistrationStatus::kFailed
                           ? back.reason
                           : find_fault(candidate, usual_cos_theta, options_);
    return std::nullopt;
  }
  to_older_.set_fixed(older);
  const RegistrationResult there = to_older_.align(newest_, T_older_newer, options_.skip_scales);
  if (there.status == RegistrationStatus::kFailed) {
    candidate.reason = there.reason;
    return std::nullopt;
  }
  compare(there, back, candidate);
  // Each way has points of its own; the middle has less noise than either.
  const SE3 T_middle =
      interpolate(there.T_fixed_moving, back.T_fixed_moving.inverse(), 0.5).normalized();
  const PairMeasurement measurement{T_middle, noise_.added_to(there.information)};
  if (prior != nullptr) compare(measurement, *prior, candidate);
  candidate.reason = find_fault(candidate, usual_cos_theta, options_);
  candidate.accepted = candidate.reason.empty();
  if (!candidate.accepted) return std::nullopt;
  return measurement;
}

}  // namespace cvo_slam
