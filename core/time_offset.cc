// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/trajectory_errors.h"

namespace cvo_slam {
namespace {

/// Largest offset that is looked for [s]: clocks that were set by hand differ by more, those of one
/// computer by tens of milliseconds.
constexpr double kLargestOffset = 0.5;
constexpr double kStep = 0.01;       // of the search over all offsets [s]
constexpr double kAccuracy = 5e-5;   // at which the search ends [s]
constexpr double kLeastPairs = 0.8;  // share of the most pairs at any offset that one must have
/// An offset must be this much better than the worst one near it.
constexpr double kLeastGain = 0.01;
constexpr double kNearby = 0.1;  // [s]

struct OffsetError {
  double rotation = std::numeric_limits<double>::infinity();  // RMSE over a second [rad]
  std::size_t pairs = 0;
};

OffsetError error_at(const std::vector<StampedPose>& reference,
                     const std::vector<StampedPose>& estimate, AssociationOptions options,
                     double offset) {
  options.interpolate = true;
  options.time_offset = offset;
  try {
    const auto error = relative_pose_error(associate(reference, estimate, options), {});
    return {error.statistics.rotation.rmse, error.errors.size()};
  } catch (const DataError&) {
    return {};
  }
}

}  // namespace

std::optional<double> measure_time_offset(const std::vector<StampedPose>& reference,
                                          const std::vector<StampedPose>& estimate,
                                          const AssociationOptions& options) {
  constexpr int kSteps = static_cast<int>(kLargestOffset / kStep);
  constexpr int kNearbySteps = static_cast<int>(kNearby / kStep);
  std::vector<OffsetError> errors;
  std::size_t most = 0;
  for (int i = -kSteps; i <= kSteps; ++i) {
    errors.push_back(error_at(reference, estimate, options, i * kStep));
    most = std::max(most, errors.back().pairs);
  }
  // Infinite where too few pairs are left to compare.
  const auto rotation_of = [&](const OffsetError& error) {
    const bool enough = static_cast<double>(error.pairs) >= kLeastPairs * static_cast<double>(most);
    return enough ? error.rotation : std::numeric_limits<double>::infinity();
  };
  const auto error_of_step = [&](int i) {
    const OffsetError none;
    const bool exists = i >= 0 && i <= 2 * kSteps;
    return rotation_of(exists ? errors[static_cast<std::size_t>(i)] : none);
  };
  int best = 0;
  for (int i = 1; i <= 2 * kSteps; ++i) {
    if (error_of_step(i) < error_of_step(best)) best = i;
  }
  double worst_near = 0;
  for (int k = best - kNearbySteps; k <= best + kNearbySteps; ++k) {
    if (std::isfinite(error_of_step(k))) worst_near = std::max(worst_near, error_of_step(k));
  }
  const bool is_found = std::isfinite(error_of_step(best - 1)) &&
                        std::isfinite(error_of_step(best + 1)) &&
                        error_of_step(best) < (1 - kLeastGain) * worst_near;
  if (!is_found) return std::nullopt;

  // The error is convex between the neighbours of the smallest one: cut the interval in three.
  double low = (best - 1 - kSteps) * kStep;
  double high = (best + 1 - kSteps) * kStep;
  while (high - low > 2 * kAccuracy) {
    const double third = (high - low) / 3;
    const double left = error_at(reference, estimate, options, low + third).rotation;
    const double right = error_at(reference, estimate, options, high - third).rotation;
    (left < right ? high : low) = left < right ? high - third : low + third;
  }
  return (low + high) / 2;
}

}  // namespace cvo_slam
