// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include "cvo_slam/slam/ambiguity_internal.h"
#include "cvo_slam/slam/graph_prior_internal.h"

namespace cvo_slam {
namespace {

/// True if two poses are of one place, however good they are.
bool is_one_place(const SE3& a, const SE3& b) {
  constexpr double kTranslation = 1;  // [m]; places that look the same are further apart
  constexpr double kRotation = 0.5;   // [rad]
  const SE3 motion = a.inverse() * b;
  return motion.translation().norm() < kTranslation && motion.angle() < kRotation;
}

/// True if the camera can have come to where a match says it is: little moved, however long it was
/// lost, or within what is known of its motion.
bool is_reachable(const LoopMatch& match, const Timestamp& now, const MapState& map,
                  const RelocalizationOptions& options) {
  const std::size_t older_position = map.keyframes.position_of(match.keyframe);
  const std::size_t newest_position = map.keyframes.size() - 1;
  const bool is_of_another_session =
      older_position < map.loaded &&
      (!map.has_own_keyframes() || map.submap_at(older_position) != map.submap_at(newest_position));
  if (is_of_another_session) return false;
  const SE3 T_older_newest =
      map.graph.pose(older_position).inverse() * map.graph.pose(newest_position);
  if (is_one_place(T_older_newest, match.verification.T_a_b)) return true;
  const auto prior = prior_across_gaps(map, older_position, now, options);
  if (!prior) return false;
  const Eigen::Matrix<double, 6, 1> error =
      (prior->T_older_newer.inverse() * match.verification.T_a_b).log();
  constexpr double kMaxError = 4;  // standard deviations: chi-square's 99 %
  return std::sqrt(error.dot(AlignedMatrix6(prior->covariance).ldlt().solve(error))) <= kMaxError;
}

/// Another place of the same submap that explains nearly as much of the image; null if there is
/// none. The number of inliers says little of ambiguous places, where posters have most features;
/// they cover less of the image.
const LoopMatch* find_rival(const std::vector<LoopMatch>& matches, std::size_t index,
                            const MapState& map, const RelocalizationOptions& options) {
  const Verification& best = matches[index].verification;
  const std::size_t position = map.keyframes.position_of(matches[index].keyframe);
  const SE3 T_world_camera = map.graph.pose(position) * best.T_a_b;
  const double enough = options.rival_share * best.coverage;
  const auto rival = std::find_if(matches.begin(), matches.end(), [&](const LoopMatch& other) {
    const Verification& v = other.verification;
    const std::size_t other_position = map.keyframes.position_of(other.keyframe);
    return v.accepted && v.coverage > enough &&
           map.submap_at(other_position) == map.submap_at(position) &&
           !is_one_place(T_world_camera, map.graph.pose(other_position) * v.T_a_b);
  });
  return rival == matches.end() ? nullptr : &*rival;
}

}  // namespace

std::string ambiguity_of_images(const std::vector<LoopMatch>& matches, std::size_t index,
                                const MapState& map, const RelocalizationOptions& options) {
  const double coverage = matches[index].verification.coverage;
  if (coverage < options.min_coverage) {
    return fmt::format(
        "{:.2f} of the image cells that both should see match; {:.2f} needed where the graph does "
        "not say where the camera is",
        coverage, options.min_coverage);
  }
  const LoopMatch* const rival = find_rival(matches, index, map, options);
  if (rival == nullptr) return {};
  return fmt::format(
      "ambiguous place: keyframe {} explains as much of the image, {:.2f} of the "
      "cells against {:.2f}",
      rival->keyframe, rival->verification.coverage, coverage);
}

std::string ambiguity_of_registration(const LoopMatch& match, double cos_theta,
                                      const Timestamp& now, const MapState& map,
                                      const RelocalizationOptions& options) {
  const Verification& v = match.verification;
  const double usual = map.usual_cos_theta.mean();
  const double agreement = 2 * (v.coverage + v.inlier_share) + (usual > 0 ? cos_theta / usual : 0);
  if (agreement >= options.min_agreement || is_reachable(match, now, map, options)) return {};
  return fmt::format("agreement {:.2f}; {:.2f} needed so far from where the camera was lost",
                     agreement, options.min_agreement);
}

}  // namespace cvo_slam
