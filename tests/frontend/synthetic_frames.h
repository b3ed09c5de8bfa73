// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/synthetic/rendering.h"
#include "cvo_slam/synthetic/world.h"

namespace cvo_slam {

/// Frames of a walk through the built-in room at 30 Hz, with the exact poses, without noise.
class SyntheticFrames {
 public:
  explicit SyntheticFrames(Camera camera) : camera_(std::move(camera)) {}

  [[nodiscard]] const Camera& camera() const { return camera_; }

  [[nodiscard]] SE3 T_world_camera(std::size_t place) const {
    return world_.path.T_world_camera(static_cast<double>(place) / 30);
  }

  /// Returns the frame of index and time `index` as seen from the pose of frame `place`.
  [[nodiscard]] RgbdFrame frame(std::size_t index, std::size_t place) const {
    const auto rendering = synthetic::render(world_.scene, camera_.color, T_world_camera(place));
    RgbdFrame frame;
    frame.index = index;
    frame.stamp = frame.depth_stamp =
        Timestamp::from_seconds(100 + static_cast<double>(index) / 30);
    rendering.color.convertTo(frame.color, CV_8U);
    rendering.depth.convertTo(frame.depth, CV_16U, camera_.depth_scale);
    return frame;
  }
  [[nodiscard]] RgbdFrame frame(std::size_t index) const { return frame(index, index); }

  /// Returns the exact pose at frame `place` in the camera frame of frame `first`.
  [[nodiscard]] SE3 T_first_camera(std::size_t first, std::size_t place) const {
    return T_world_camera(first).inverse() * T_world_camera(place);
  }

 private:
  Camera camera_;
  synthetic::World world_ = synthetic::make_world("room");
};

}  // namespace cvo_slam
