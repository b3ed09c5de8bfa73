// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <optional>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/saved_state.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/loop/loop_verifier.h"
#include "cvo_slam/slam/appearance_cache_internal.h"

namespace cvo_slam {

/// Finds where the tracker may start a registration by the ORB features of the images, which do not
/// care how far the camera has moved. What it finds is refined and judged by the registration:
/// fewer inliers are enough than a loop needs.
class FeatureStart {
 public:
  /// `options` are those of loops. `appearances` must outlive the object.
  FeatureStart(const Camera& camera, const VerificationOptions& options,
               AppearanceCache& appearances);

  /// Takes a keyframe, with its pose as it was tracked. The last ones are kept.
  void add(const RgbdFrame& images, const SE3& T_world_camera);
  /// Forgets them: for a new submap, which has another world.
  void clear() { last_keyframes_.clear(); }
  /// Returns T_keyframe_camera of the frame, by the features of the keyframe or, if too few of them
  /// agree, of the last two other ones; none if those do not either.
  [[nodiscard]] std::optional<SE3> find(const RgbdFrame& keyframe, const SE3& T_world_keyframe,
                                        const RgbdFrame& frame);
  /// Throws DataError if the images are not of the camera.
  void exchange(SavedState& state);

 private:
  struct PosedImages {
    RgbdFrame images;
    SE3 T_world_camera;

    void exchange(SavedState& state) { state(images, T_world_camera); }
  };

  [[nodiscard]] std::optional<SE3> compare(const RgbdFrame& keyframe, const RgbdFrame& frame);

  Camera camera_;
  AppearanceCache& appearances_;
  LoopVerifier verifier_;
  std::deque<PosedImages> last_keyframes_;  // in ascending order
};

}  // namespace cvo_slam
