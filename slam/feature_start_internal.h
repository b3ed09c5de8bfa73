// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/loop/loop_detector.h"
#include "cvo_slam/loop/loop_verifier.h"

namespace cvo_slam {

/// Finds where the tracker may start a registration by the ORB features of the two images, which do
/// not care how far the camera has moved. What it finds is refined and judged by the registration:
/// fewer inliers are enough than a loop needs.
class FeatureStart {
 public:
  FeatureStart(const Camera& camera, const LoopOptions& options,
               std::shared_ptr<const Vocabulary> vocabulary);

  /// Returns T_keyframe_camera of the frame; none if too few features agree.
  [[nodiscard]] std::optional<SE3> find(const RgbdFrame& keyframe, const RgbdFrame& frame);

 private:
  [[nodiscard]] std::shared_ptr<const Appearance> appearance_of(const RgbdFrame& frame);

  Camera camera_;
  LoopOptions options_;
  std::shared_ptr<const Vocabulary> vocabulary_;
  LoopVerifier verifier_;
  // The last two images: a keyframe serves several frames, and a frame becomes a keyframe.
  std::shared_ptr<const Appearance> newer_;
  std::shared_ptr<const Appearance> older_;
};

}  // namespace cvo_slam
