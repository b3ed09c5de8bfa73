// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/loop/loop_verifier.h"
#include "cvo_slam/slam/appearance_cache_internal.h"

namespace cvo_slam {

/// Finds where the tracker may start a registration by the ORB features of the two images, which do
/// not care how far the camera has moved. What it finds is refined and judged by the registration:
/// fewer inliers are enough than a loop needs.
class FeatureStart {
 public:
  /// `options` are those of loops. `appearances` must outlive the object.
  FeatureStart(const Camera& camera, const VerificationOptions& options,
               AppearanceCache& appearances);

  /// Returns T_keyframe_camera of the frame; none if too few features agree.
  [[nodiscard]] std::optional<SE3> find(const RgbdFrame& keyframe, const RgbdFrame& frame);

 private:
  AppearanceCache& appearances_;
  LoopVerifier verifier_;
};

}  // namespace cvo_slam
