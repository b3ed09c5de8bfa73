// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "cvo_slam/core/se3.h"
#include "cvo_slam/loop/loop_verifier.h"
#include "cvo_slam/loop/orb_features.h"
#include "cvo_slam/loop/vocabulary.h"

namespace cvo_slam {

/// Two similar features of two images, by their indices.
struct FeatureMatch {
  std::uint32_t a = 0;
  std::uint32_t b = 0;

  bool operator==(const FeatureMatch&) const = default;
  bool operator<(const FeatureMatch& other) const {
    return std::pair(a, b) < std::pair(other.a, other.b);
  }
};

/// Returns the matches between features of the same vocabulary node, in ascending order. A match is
/// the nearest feature in both directions, no farther than MatchingOptions::max_distance, and
/// nearer than the second nearest by MatchingOptions::ratio.
[[nodiscard]] std::vector<FeatureMatch> match_by_nodes(const OrbFeatures& a,
                                                       const std::vector<NodeFeature>& a_nodes,
                                                       const OrbFeatures& b,
                                                       const std::vector<NodeFeature>& b_nodes,
                                                       const MatchingOptions& options);

/// Returns the matches that agree with the most common rotation: between two images of one place
/// the orientations of all features change by about the same angle.
[[nodiscard]] std::vector<FeatureMatch> keep_common_rotation(
    const OrbFeatures& a, const OrbFeatures& b, const std::vector<FeatureMatch>& matches,
    const MatchingOptions& options);

/// Matches with a known pose, and the features that should be visible.
struct ProjectionMatches {
  std::vector<FeatureMatch> matches;  ///< in ascending order, no feature of `b` twice
  /// Rays in frame b of the features of `a` with depth that lie in the image of b.
  std::vector<Eigen::Vector2d> visible;
};

/// Matches each feature of `a` that has depth with the most similar feature of `b` within
/// MatchingOptions::search_radius of its projection.
[[nodiscard]] ProjectionMatches match_by_projection(const OrbFeatures& a, const OrbFeatures& b,
                                                    const SE3& T_b_a, const PinholeCamera& camera,
                                                    const MatchingOptions& options);

}  // namespace cvo_slam
