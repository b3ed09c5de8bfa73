// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "cvo_slam/core/trajectory.h"

namespace cvo_slam {

/// How the poses of an estimate are matched with those of a reference.
struct AssociationOptions {
  /// Largest difference between the stamps of two matched poses [s], >= 0. More than half the
  /// period of a 30 Hz camera would pair a pose with the neighbour of its partner.
  double max_difference = 0.02;
  /// Offset added to the estimate's stamps before anything else [s], at most a million.
  double time_offset = 0;
  /// If true, the reference is interpolated at the estimate's stamps instead of taking its nearest
  /// pose; `max_difference` is then not used.
  bool interpolate = false;
  /// Longest gap of the reference to interpolate over [s]. Motion capture gives 100 poses a second;
  /// a hand-held camera turns by several degrees in a tenth of a second.
  double max_gap = 0.1;
};

/// A pose of the estimate and the pose of the reference at the same time.
struct MatchedPose {
  Timestamp stamp;  ///< the estimate's, with the time offset
  SE3 reference;    ///< the reference's pose, in the world of the reference
  SE3 estimate;     ///< the estimate's pose, in the world of the estimate
};

/// Returns the matched poses in ascending order of stamps. Without interpolation each pose of the
/// trajectory with fewer poses (the estimate if both have equally many) takes the nearest of the
/// other, the earlier of two equally near ones; as in evo's `sync`, two may take the same one.
/// Throws DataError if a trajectory is empty or nothing matches, OptionError for a bad option.
[[nodiscard]] std::vector<MatchedPose> associate(const std::vector<StampedPose>& reference,
                                                 const std::vector<StampedPose>& estimate,
                                                 const AssociationOptions& options = {});

/// Returns the pose at `stamp`, on the SE(3) geodesic between the two poses around it; `poses` are
/// in ascending order of stamps. Returns nothing outside their range, and if those two poses are
/// more than `max_gap` [s] apart. A stamp that occurs in `poses` gives that pose.
[[nodiscard]] std::optional<SE3> interpolate_at(const std::vector<StampedPose>& poses,
                                                const Timestamp& stamp, double max_gap);

/// Returns the longest time between neighbours that a drawn line may join [s], from stamps in
/// ascending order. A longer step means that poses are missing; a line would show a path that
/// nobody measured.
[[nodiscard]] double longest_usual_step(const std::vector<Timestamp>& stamps);

}  // namespace cvo_slam
