// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "cvo_slam/core/se3.h"
#include "cvo_slam/loop/bag_of_words.h"
#include "cvo_slam/loop/loop_options.h"
#include "cvo_slam/loop/orb_features.h"

namespace cvo_slam {

/// Features of two images that look alike, by their indices.
struct FeatureMatch {
  std::uint32_t a = 0;
  std::uint32_t b = 0;

  bool operator==(const FeatureMatch&) const = default;
  bool operator<(const FeatureMatch& other) const {
    return std::pair(a, b) < std::pair(other.a, other.b);
  }
};

/// Compares features of the same vocabulary node alone. A match is the nearest one both ways, is
/// nearer than MatchingOptions::max_distance, and nearer than the second nearest by its ratio.
/// In ascending order.
[[nodiscard]] std::vector<FeatureMatch> match_by_nodes(const OrbFeatures& a,
                                                       const std::vector<NodeFeature>& a_nodes,
                                                       const OrbFeatures& b,
                                                       const std::vector<NodeFeature>& b_nodes,
                                                       const MatchingOptions& options);

/// Those that turn with most of the others: between two images of one place the orientations of all
/// features change by about the same angle.
[[nodiscard]] std::vector<FeatureMatch> keep_common_rotation(
    const OrbFeatures& a, const OrbFeatures& b, const std::vector<FeatureMatch>& matches,
    const MatchingOptions& options);

/// Matches again with the pose known: each feature of `a` that has depth with the one of `b` that
/// looks most alike within MatchingOptions::search_radius of where the pose says that it is.
struct ProjectionMatches {
  std::vector<FeatureMatch> matches;  ///< none of `b` twice; in ascending order
  /// The rays in frame b of those features of `a` with depth that lie in b's image.
  std::vector<Eigen::Vector2d> visible;
};
[[nodiscard]] ProjectionMatches match_by_projection(const OrbFeatures& a, const OrbFeatures& b,
                                                    const SE3& T_b_a, const PinholeCamera& camera,
                                                    const MatchingOptions& options);

}  // namespace cvo_slam
