// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
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
    : appearances_(appearances), verifier_(camera, for_starts(options)) {}

std::optional<SE3> FeatureStart::find(const RgbdFrame& keyframe, const RgbdFrame& frame) {
  const Verification verification =
      verifier_.verify(*appearances_.of(keyframe), *appearances_.of(frame));
  if (!verification.accepted) return std::nullopt;
  return verification.T_a_b;
}

}  // namespace cvo_slam
