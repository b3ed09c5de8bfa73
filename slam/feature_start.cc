// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

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

FeatureStart::FeatureStart(const Camera& camera, const LoopOptions& options,
                           std::shared_ptr<const Vocabulary> vocabulary)
    : camera_(camera),
      options_(options),
      vocabulary_(std::move(vocabulary)),
      verifier_(camera, for_starts(options.verification)) {}

std::optional<SE3> FeatureStart::find(const RgbdFrame& keyframe, const RgbdFrame& frame) {
  const auto a = appearance_of(keyframe);
  const auto b = appearance_of(frame);
  newer_ = b;
  older_ = a;
  const Verification verification = verifier_.verify(*a, *b);
  if (!verification.accepted) return std::nullopt;
  return verification.T_a_b;
}

std::shared_ptr<const Appearance> FeatureStart::appearance_of(const RgbdFrame& frame) {
  for (const auto& known : {newer_, older_}) {
    if (known && known->id == frame.index) return known;
  }
  Appearance appearance;
  appearance.id = frame.index;
  appearance.features = extract_orb(frame, camera_, options_.orb);
  appearance.words = vocabulary_->transform(appearance.features.descriptors,
                                            options_.verification.matching.node_level);
  return std::make_shared<const Appearance>(std::move(appearance));
}

}  // namespace cvo_slam
