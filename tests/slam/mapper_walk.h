// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "cvo_slam/frontend/point_selection.h"
#include "cvo_slam/slam/mapper_internal.h"
#include "cvo_slam/tests/frontend/synthetic_frames.h"
#include "cvo_slam/tests/frontend/test_frames.h"
#include "cvo_slam/tests/frontend/tracker_test_options.h"

namespace cvo_slam {

/// Keyframes are recognised by their images alone: proximity is off, so that nothing else connects
/// keyframes that are far apart.
inline SlamOptions loop_options() {
  SlamOptions options;
  options.tracker = tracker_test_options();
  options.proximity.recent = options.proximity.near = 0;
  options.loops.enabled = true;
  options.loops.detection.candidates.min_gap = 3;  // these walks have few keyframes
  return options;
}

inline std::vector<LoopCandidate> loops_of(const std::vector<LoopCandidate>& candidates) {
  std::vector<LoopCandidate> loops;
  for (const LoopCandidate& candidate : candidates) {
    if (candidate.kind == EdgeKind::kLoop) loops.push_back(candidate);
  }
  return loops;
}

inline std::size_t accepted(const std::vector<LoopCandidate>& loops) {
  std::size_t count = 0;
  for (const LoopCandidate& loop : loops) count += loop.accepted ? 1 : 0;
  return count;
}

/// A mapper fed with keyframes whose images and poses need not belong together.
class MapperWalk : public testing::Test {
 protected:
  void make_mapper(const SlamOptions& options) {
    mapper_ = std::make_unique<Mapper>(walk_.camera(), options);
  }

  /// Adds a keyframe with the image of a place, which the tracker believes to be at a pose.
  void add(std::size_t place, const SE3& T_world_camera, int submap = 0) {
    const RgbdFrame images = walk_.frame(poses_.size(), place);
    KeyframeInput keyframe;
    keyframe.number = poses_.size();
    keyframe.stamp = images.stamp;
    keyframe.tracked_submap = submap;
    keyframe.T_world_camera = T_world_camera;
    if (!poses_.empty() && submap == submap_) {
      keyframe.odometry = {poses_.size() - 1, poses_.back().inverse() * T_world_camera,
                           1e-6 * Matrix6::Identity(), kCosTheta};
    }
    keyframe.cloud = std::make_shared<const PointCloud>(points_of(images));
    keyframe.images = images;
    poses_.push_back(T_world_camera);
    submap_ = submap;
    mapper_->add(keyframe);
  }
  [[nodiscard]] PointCloud points_of(const RgbdFrame& image) const {
    return select_points(image, walk_.camera(), kPoints);
  }

  /// Keyframes along the walk, believed to be where they are.
  void walk(int keyframes) {
    for (int i = 0; i < keyframes; ++i) add(place(i), pose(place(i)));
  }
  static std::size_t place(int keyframe) { return 8 * static_cast<std::size_t>(keyframe); }
  [[nodiscard]] SE3 pose(std::size_t place) const { return walk_.T_first_camera(0, place); }
  /// The pose at another place that looks the same.
  [[nodiscard]] SE3 same_looking(std::size_t place) const {
    return SE3(Matrix3::Identity(), Vector3(kCorridor, 0, 0)) * pose(place);
  }

  [[nodiscard]] std::vector<LoopCandidate> loops_of_newest() const {
    std::vector<LoopCandidate> newest;
    for (const LoopCandidate& loop : loops_of(mapper_->candidates())) {
      if (loop.to == poses_.size() - 1) newest.push_back(loop);
    }
    return newest;
  }

  static constexpr double kCorridor =
      6;  // [m]; distance of ambiguous places in the synthetic house
  static constexpr int kPoints = 2000;
  static constexpr double kCosTheta = 0.5;  // of the links: less than of the same image twice
  SyntheticFrames walk_{small_camera(320, 240)};
  std::unique_ptr<Mapper> mapper_;
  std::vector<SE3> poses_;
  int submap_ = 0;
};

}  // namespace cvo_slam
