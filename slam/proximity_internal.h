// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/slam/map_state_internal.h"
#include "cvo_slam/slam/slam_options.h"

namespace cvo_slam {

/// An earlier keyframe that sees much of what the newest one sees.
struct NearKeyframe {
  std::size_t position = 0;
  double expected_overlap = 0;  ///< mutual_overlap() by the poses of the graph
};

/// The smaller one of two shares: that of the points of `a` which lie in the image of `b`, and the
/// reverse (visible_share()).
[[nodiscard]] double mutual_overlap(const CompactCloud& a, const CompactCloud& b, const SE3& T_a_b,
                                    const FieldOfView& field_of_view);

/// Finds keyframes by where their cameras are, so that a search costs the same however large the
/// map is.
class ProximityIndex {
 public:
  /// Enters a keyframe, or moves it to where its camera is now.
  void set(std::size_t position, const Vector3& camera, double reach);
  /// Removes a keyframe; the positions of later ones decrease by one.
  void remove(std::size_t position);

  /// Positions, descending, of the other keyframes that may have seen a point that the given one
  /// saw: their cameras are no further apart than their reaches together.
  [[nodiscard]] std::vector<std::size_t> within_reach_of(std::size_t position) const;
  /// The same for a camera that is not in the index.
  [[nodiscard]] std::vector<std::size_t> within_reach_of(const Vector3& camera, double reach) const;

 private:
  using Cell = std::array<std::int32_t, 3>;
  struct Entry {
    Vector3 camera = Vector3::Zero();
    double reach = 0;
    Cell cell = {};
  };

  std::vector<Entry> entries_;  // by position
  std::map<Cell, std::vector<std::size_t>> cells_;
  double largest_reach_ = 0;
};

/// The keyframes that the newest one is to be registered to besides its predecessor: the most
/// recent ones, and of the older ones those that see most of the same, spread over the sequence.
[[nodiscard]] std::vector<NearKeyframe> find_near_keyframes(const MapState& map,
                                                            const ProximityIndex& index,
                                                            const FieldOfView& field_of_view,
                                                            const ProximityOptions& options);

}  // namespace cvo_slam
