// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "cvo_slam/core/se3.h"
#include "cvo_slam/slam/proximity_internal.h"
#include "cvo_slam/slam/slam_options.h"

namespace cvo_slam {

/// A place of one part of the graph that was recognised in a keyframe of another part, and believed
/// as far as two images go.
struct PartLink {
  std::size_t older = 0;  ///< in the list of views
  std::size_t newer = 0;  ///< likewise: the one that recognised the other
  PairMeasurement measurement;
  std::size_t candidate = 0;  ///< in the list of candidates
};

/// What all links between two parts say together.
struct PartPlacement {
  std::vector<std::size_t> agreeing;  ///< of the links: those that say the same; most of them
  std::size_t keyframes = 0;          ///< newer ones among these
  std::size_t rivals = 0;             ///< newer ones of those that say the same, but another
  SE3 T_world_world;                  ///< from the newer ones' world to that of the older ones

  /// Whether they are enough, and clearly more than those which say otherwise.
  [[nodiscard]] bool is_certain(const RelocalizationOptions& options) const;
};

/// Where the largest set of links that agree puts the one part in the other. All links are between
/// the same two parts, older ones in the one and newer ones in the other.
[[nodiscard]] PartPlacement place_part(const std::vector<PartLink>& links,
                                       const std::vector<KeyframeView>& views,
                                       const RelocalizationOptions& options);

}  // namespace cvo_slam
