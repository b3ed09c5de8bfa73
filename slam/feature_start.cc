// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/error.h"
#include "cvo_slam/frontend/point_selection.h"
#include "cvo_slam/slam/feature_start_internal.h"

namespace cvo_slam {
namespace {

/// As for loops, with less evidence: a start that is wrong costs a registration, and no more.
VerificationOptions for_starts(VerificationOptions options) {
  options.min_inliers = 15;
  options.min_visible_share = 0.03;
  options.min_coverage = 0.2;
  options.max_deviation_translation = 0.05;
  options.max_deviation_rotation = 0.03;
  return options;
}

}  // namespace

FeatureStart::FeatureStart(const Camera& camera, const VerificationOptions& options,
                           AppearanceCache& appearances)
    : camera_(camera), appearances_(appearances), verifier_(camera, for_starts(options)) {}

void FeatureStart::add(const RgbdFrame& images, const SE3& T_world_camera) {
  constexpr std::size_t kMost = 3;  // the current one may be among them
  last_keyframes_.push_back({images, T_world_camera});
  if (last_keyframes_.size() > kMost) last_keyframes_.pop_front();
}

std::optional<SE3> FeatureStart::find(const RgbdFrame& keyframe, const SE3& T_world_keyframe,
                                      const RgbdFrame& frame) {
  if (auto T_keyframe_camera = compare(keyframe, frame)) return T_keyframe_camera;
  int left = 2;
  for (auto last = last_keyframes_.rbegin(); last != last_keyframes_.rend() && left > 0; ++last) {
    if (last->images.index == keyframe.index) continue;
    --left;
    if (const auto T_last_camera = compare(last->images, frame)) {
      return T_world_keyframe.inverse() * last->T_world_camera * *T_last_camera;
    }
  }
  return std::nullopt;
}

void FeatureStart::exchange(SavedState& state) {
  state(last_keyframes_);
  for (const PosedImages& keyframe : last_keyframes_) {
    if (check_images(keyframe.images, camera_).empty()) continue;
    throw DataError("a saved state has images of another camera");
  }
}

std::optional<SE3> FeatureStart::compare(const RgbdFrame& keyframe, const RgbdFrame& frame) {
  const Verification verification =
      verifier_.verify(*appearances_.of(keyframe), *appearances_.of(frame));
  if (!verification.accepted) return std::nullopt;
  return verification.T_a_b;
}

}  // namespace cvo_slam
