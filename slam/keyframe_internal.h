// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/core/timestamp.h"

namespace cvo_slam {

/// Of a keyframe in the graph: the index of its frame.
[[nodiscard]] inline NodeId node_id(std::size_t frame) { return static_cast<NodeId>(frame); }

/// How a keyframe was registered to the one that it was tracked against.
struct KeyframeLink {
  std::size_t reference = 0;  ///< frame index of the other
  SE3 T_reference_keyframe;
  Matrix6 information = Matrix6::Identity();  ///< of a right perturbation
  double cos_theta = 0;
};

/// Where a lost camera was recognised to be.
struct FoundPlace {
  KeyframeLink link;  ///< to the keyframe that shows the place
  SE3 T_world_camera;
  int part = 0;  ///< of the graph, see KeyframeMap::part_of()
};

/// What the tracker knows of a keyframe.
struct TrackedKeyframe {
  std::size_t frame = 0;
  Timestamp stamp;
  int segment = 0;
  SE3 T_world_camera;
  std::optional<KeyframeLink> link;   ///< none for the first of a segment
  std::optional<KeyframeLink> place;  ///< of the first of a segment, where the place was recognised
  std::shared_ptr<const PointCloud> cloud;
  std::shared_ptr<const RgbdFrame> image;  ///< none where places are not recognised
};

}  // namespace cvo_slam
