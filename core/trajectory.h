// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "cvo_slam/core/se3.h"
#include "cvo_slam/core/timestamp.h"

namespace cvo_slam {

/// The pose of a camera at a time.
struct StampedPose {
  Timestamp stamp;     ///< when the camera was there
  SE3 T_world_camera;  ///< where it was, in the world of its trajectory
};

/// A frame without a pose, and the reason.
struct LostFrame {
  Timestamp stamp;     ///< stamp of its colour image
  std::string reason;  ///< why it has no pose, in words
};

/// The path of a camera.
struct Trajectory {
  std::vector<StampedPose> poses;  ///< in ascending order of stamps, none twice
  std::vector<LostFrame> lost;     ///< in the order of the frames
};

/// Returns the sum of the distances between consecutive positions [m].
[[nodiscard]] inline double path_length(const std::vector<StampedPose>& poses) {
  double length = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    length +=
        (poses[i].T_world_camera.translation() - poses[i - 1].T_world_camera.translation()).norm();
  }
  return length;
}

}  // namespace cvo_slam
