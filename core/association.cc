// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/association.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/trajectory_errors.h"

namespace cvo_slam {
namespace {

constexpr double kMaxTimeOffset = 1e6;

void check_association(const AssociationOptions& options) {
  if (!(options.max_difference >= 0)) {
    throw OptionError(
        fmt::format("max difference of stamps {} s: must be 0 or more", options.max_difference));
  }
  if (!(std::fabs(options.time_offset) <= kMaxTimeOffset)) {
    throw OptionError(
        fmt::format("time offset {} s: must be between -1e6 and 1e6", options.time_offset));
  }
  if (!(options.max_gap >= 0)) {
    throw OptionError(fmt::format("max gap {} s: must be 0 or more", options.max_gap));
  }
}

std::vector<StampedPose> shifted(std::vector<StampedPose> poses, double offset) {
  const std::int64_t nanoseconds = std::llround(offset * 1e9);
  if (nanoseconds == 0) return poses;
  for (auto& pose : poses) pose.stamp = Timestamp(pose.stamp.nanoseconds() + nanoseconds);
  return poses;
}

/// Returns the stamp rounded to double precision (0.24 us today). evo computes with such numbers. A
/// stamp half way between two others finds the same partner only if it is rounded here as well; one
/// stamp of fr2/desk is such a case and changes the figures in the sixth decimal.
double rounded_seconds(const Timestamp& stamp) {
  return static_cast<double>(static_cast<long double>(stamp.nanoseconds()) / 1e9L);
}

/// Returns the pose nearest in time, the earlier of two equally near ones; null if it is too far.
const StampedPose* nearest(const std::vector<StampedPose>& poses, const Timestamp& stamp,
                           double max_difference) {
  const auto after =
      std::lower_bound(poses.begin(), poses.end(), stamp,
                       [](const StampedPose& pose, const Timestamp& t) { return pose.stamp < t; });
  const double time = rounded_seconds(stamp);
  const auto distance = [&](auto pose) { return std::fabs(rounded_seconds(pose->stamp) - time); };
  auto best = after;
  if (after == poses.end() ||
      (after != poses.begin() && distance(std::prev(after)) <= distance(after))) {
    best = std::prev(after);
  }
  return distance(best) <= max_difference ? &*best : nullptr;
}

std::vector<MatchedPose> match_nearest(const std::vector<StampedPose>& reference,
                                       const std::vector<StampedPose>& estimate,
                                       double max_difference) {
  const bool by_reference = reference.size() < estimate.size();
  const auto& shorter = by_reference ? reference : estimate;
  const auto& longer = by_reference ? estimate : reference;
  std::vector<MatchedPose> matches;
  for (const auto& pose : shorter) {
    const StampedPose* partner = nearest(longer, pose.stamp, max_difference);
    if (partner == nullptr) continue;
    const StampedPose& a = by_reference ? pose : *partner;
    const StampedPose& b = by_reference ? *partner : pose;
    matches.push_back({b.stamp, a.T_world_camera, b.T_world_camera});
  }
  return matches;
}

std::vector<MatchedPose> match_interpolated(const std::vector<StampedPose>& reference,
                                            const std::vector<StampedPose>& estimate,
                                            double max_gap) {
  std::vector<MatchedPose> matches;
  for (const auto& pose : estimate) {
    const auto truth = interpolate_at(reference, pose.stamp, max_gap);
    if (truth) matches.push_back({pose.stamp, *truth, pose.T_world_camera});
  }
  return matches;
}

std::string describe_span(const std::vector<StampedPose>& poses) {
  return fmt::format("{} to {} s", poses.front().stamp.to_string(), poses.back().stamp.to_string());
}

}  // namespace

std::vector<MatchedPose> associate(const std::vector<StampedPose>& reference,
                                   const std::vector<StampedPose>& estimate,
                                   const AssociationOptions& options) {
  check_association(options);
  if (reference.empty()) throw DataError("the reference trajectory has no pose");
  if (estimate.empty()) throw DataError("the estimated trajectory has no pose");
  const auto moved = shifted(estimate, options.time_offset);
  auto matches = options.interpolate ? match_interpolated(reference, moved, options.max_gap)
                                     : match_nearest(reference, moved, options.max_difference);
  if (matches.empty()) {
    throw DataError(fmt::format(
        "no pose of the estimate ({}) has a partner in the reference ({}); check that they are of "
        "the same sequence, or give a time offset or a larger difference",
        describe_span(moved), describe_span(reference)));
  }
  return matches;
}

std::optional<SE3> interpolate_at(const std::vector<StampedPose>& poses, const Timestamp& stamp,
                                  double max_gap) {
  const auto after =
      std::lower_bound(poses.begin(), poses.end(), stamp,
                       [](const StampedPose& pose, const Timestamp& t) { return pose.stamp < t; });
  if (after == poses.end()) return std::nullopt;
  if (after->stamp == stamp) return after->T_world_camera;
  if (after == poses.begin()) return std::nullopt;
  const auto before = std::prev(after);
  const double gap = seconds_between(before->stamp, after->stamp);
  if (gap > max_gap) return std::nullopt;
  return interpolate(before->T_world_camera, after->T_world_camera,
                     seconds_between(before->stamp, stamp) / gap);
}

double longest_usual_step(const std::vector<Timestamp>& stamps) {
  constexpr double kUsualSteps = 5;
  constexpr double kAlwaysJoined = 0.5;
  std::vector<double> steps;
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    steps.push_back(seconds_between(stamps[i - 1], stamps[i]));
  }
  return std::fmax(kUsualSteps * summarize(steps).median, kAlwaysJoined);
}

}  // namespace cvo_slam
