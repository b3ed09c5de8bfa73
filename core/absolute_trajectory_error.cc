// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/absolute_trajectory_error.h"

#include "cvo_slam/core/error.h"

namespace cvo_slam {

AbsoluteTrajectoryError absolute_trajectory_error(const std::vector<MatchedPose>& matches,
                                                  Alignment alignment) {
  if (matches.empty()) throw DataError("no matched pose to take the trajectory error of");
  AbsoluteTrajectoryError result;
  result.alignment = align_positions(matches, alignment);
  result.errors.reserve(matches.size());
  for (const auto& match : matches) {
    const SE3 error = match.reference.inverse() * (result.alignment * match.estimate);
    result.errors.push_back({match.stamp, error.translation().norm(), error.angle()});
  }
  result.statistics = summarize(result.errors);
  return result;
}

}  // namespace cvo_slam
