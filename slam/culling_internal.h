// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/slam/map_state_internal.h"

namespace cvo_slam {

// A map stays small if it does without the keyframes for which others can stand in (culling):
// MapGraph::replace_keyframe() hands on what was measured to them.

/// Number of newest keyframes that stay: new ones are still registered to them.
inline constexpr std::size_t kUnsettledKeyframes = 20;

/// A keyframe that can be done without.
struct Removal {
  std::size_t position = 0;
  std::size_t substitute = 0;  ///< position of the keyframe that stands in for it
  std::size_t edge = 0;        ///< between the two
};

/// The keyframe at a position, if an older one sees the same: the tracker would not have needed the
/// newer one, had it used the older one, which is no further than half of what makes it take
/// another. The best one of several stands in. None if there is none, or if the keyframe has to
/// stay. `limits` are the tracker's.
[[nodiscard]] std::optional<Removal> find_redundancy(const MapState& map, std::size_t position,
                                                     const FieldOfView& field_of_view,
                                                     const KeyframeOptions& limits);

/// The settled keyframe that is nearest to another one, by its distance and its angle as shares of
/// the tracker's limits: that which is missed least where memory is short. None if all have to
/// stay.
[[nodiscard]] std::optional<Removal> find_least_missed(const MapState& map,
                                                       const KeyframeOptions& limits);

}  // namespace cvo_slam
