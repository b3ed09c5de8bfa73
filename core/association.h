// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "cvo_slam/core/trajectory.h"

namespace cvo_slam {

/// How the poses of an estimate find those of a reference.
struct AssociationOptions {
  /// Largest difference of the stamps of two poses that belong together [s], >= 0. More than half
  /// the period of a 30 Hz camera would pair a pose with the neighbour of its partner.
  double max_difference = 0.02;
  /// Added to the estimate's stamps before anything else [s], at most a million.
  double time_offset = 0;
  /// Interpolate the reference at the estimate's stamps instead of taking the nearest pose; then
  /// `max_difference` plays no part.
  bool interpolate = false;
  /// Longest gap of the reference to interpolate over [s]. Motion capture gives 100 poses a second;
  /// a hand-held camera turns by several degrees in a tenth of a second.
  double max_gap = 0.1;
};

/// A pose of the estimate and the reference's pose of the same time.
struct MatchedPose {
  Timestamp stamp;  ///< the estimate's, with the time offset
  SE3 reference;
  SE3 estimate;
};

/// The matched poses in ascending order. Without interpolation each pose of the trajectory with
/// fewer poses (the estimate where they are equal) takes the nearest of the other, the earlier of
/// two equally near ones; as in evo's `sync` two may take the same one.
/// Throws DataError where a trajectory is empty or nothing matches, OptionError for a bad option.
[[nodiscard]] std::vector<MatchedPose> associate(const std::vector<StampedPose>& reference,
                                                 const std::vector<StampedPose>& estimate,
                                                 const AssociationOptions& options = {});

}  // namespace cvo_slam
