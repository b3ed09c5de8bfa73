// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/pose_interpolation.h"

#include <algorithm>

namespace cvo_slam {

std::optional<SE3> interpolate_at(const std::vector<StampedPose>& poses, const Timestamp& stamp,
                                  double max_gap) {
  const auto after =
      std::lower_bound(poses.begin(), poses.end(), stamp,
                       [](const StampedPose& pose, const Timestamp& t) { return pose.stamp < t; });
  if (after == poses.end()) return std::nullopt;
  if (after->stamp == stamp) return after->T_world_camera;
  if (after == poses.begin()) return std::nullopt;
  const auto before = std::prev(after);
  const double gap = seconds_between(before->stamp, after->stamp);
  if (gap > max_gap) return std::nullopt;
  return interpolate(before->T_world_camera, after->T_world_camera,
                     seconds_between(before->stamp, stamp) / gap);
}

}  // namespace cvo_slam
