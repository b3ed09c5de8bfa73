// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <vector>

#include "cvo_slam/slam/localization_internal.h"

namespace cvo_slam {
namespace {

/// Keyframes that are tried: the best one may be on the other side of a doorway.
constexpr std::size_t kTries = 2;

/// The tracker is content with as little overlap; four standard deviations are chi-square's 99 %.
const PairOptions kPair = {.min_overlap = 0.3,
                           .max_error = 4,
                           .skip_scales = 0,
                           .max_round_trip_translation = 0.02,
                           .max_round_trip_rotation = 0.02};

/// What the tracker alone may be wrong by after a path [m]: it drifts by about a hundredth.
Matrix6 drift_covariance(double path_length) {
  const double translation = 0.02 + 0.01 * path_length;  // [m]
  const double rotation = 0.01 + 0.005 * path_length;    // [rad]
  Matrix6 covariance = Matrix6::Zero();
  covariance.diagonal().head<3>().setConstant(translation * translation);
  covariance.diagonal().tail<3>().setConstant(rotation * rotation);
  return covariance;
}

}  // namespace

Localizer::Localizer(const Camera& camera, const RegistrationOptions& registration, int threads,
                     const RegistrationNoise& noise)
    : field_of_view_(camera.color), registration_(registration, threads, kPair, noise) {}

std::optional<SE3> Localizer::locate(const PointCloud& cloud, const PredictedPose& predicted,
                                     const MapState& map, const ProximityIndex& index) {
  const CompactCloud compact(cloud);
  const auto T_older_camera = [&](std::size_t position) {
    return map.graph.pose(position).inverse() * predicted.T_world_camera;
  };
  std::vector<NearKeyframe> near_keyframes;
  for (const std::size_t position :
       index.within_reach_of(predicted.T_world_camera.translation(), reach_of(compact))) {
    if (map.submap_at(position) != predicted.submap) continue;
    const double overlap = mutual_overlap(map.keyframes[position].cloud, compact,
                                          T_older_camera(position), field_of_view_);
    if (overlap >= kPair.min_overlap) near_keyframes.push_back({position, overlap});
  }
  std::stable_sort(near_keyframes.begin(), near_keyframes.end(),
                   [](const NearKeyframe& a, const NearKeyframe& b) {
                     return a.expected_overlap > b.expected_overlap;
                   });
  if (near_keyframes.empty()) return std::nullopt;
  registration_.set_newer(cloud);
  near_keyframes.resize(std::min(kTries, near_keyframes.size()));
  for (const NearKeyframe& keyframe : near_keyframes) {
    const PairPrior prior{T_older_camera(keyframe.position),
                          drift_covariance(predicted.path_length)};
    const PairVerdict verdict =
        registration_.register_both_ways(map.keyframes[keyframe.position].cloud.points(),
                                         prior.T_older_newer, &prior, map.usual_cos_theta.mean());
    if (!verdict.measurement) continue;
    return (map.graph.pose(keyframe.position) * verdict.measurement->T_older_newer).normalized();
  }
  return std::nullopt;
}

}  // namespace cvo_slam
