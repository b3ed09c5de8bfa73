// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/core/trajectory.h"

namespace cvo_slam {

/// A piece of surface.
struct MapPoint {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();  ///< in the world [m]
  /// Unit vector towards the side it was seen from; zero where it is not known.
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  std::array<std::uint8_t, 3> color = {0, 0, 0};  ///< red, green, blue
};

/// What is known of a place: where the camera stood, how that was measured, and what it saw.
struct Map {
  std::vector<StampedPose> keyframes;  ///< in ascending order of stamps
  /// Node i is keyframe i and has its pose; without nodes where nothing but poses is known.
  PoseGraph graph;
  std::vector<MapPoint> points;
};

}  // namespace cvo_slam
