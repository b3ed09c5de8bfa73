// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/map.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/saved_state.h"
#include "cvo_slam/loop/loop_detector.h"
#include "cvo_slam/slam/appearance_cache_internal.h"
#include "cvo_slam/slam/graph_prior_internal.h"
#include "cvo_slam/slam/loop_candidate.h"
#include "cvo_slam/slam/map_state_internal.h"
#include "cvo_slam/slam/pair_registration_internal.h"
#include "cvo_slam/slam/slam_options.h"

namespace cvo_slam {

/// The row of a pair: what was found, and what registration says of it. Rejected unless the verdict
/// has a measurement.
[[nodiscard]] LoopCandidate candidate_row(EdgeKind kind, std::size_t older, std::size_t newer,
                                          const PairVerdict& verdict);
/// The same for a match of images, with its scores and inliers.
[[nodiscard]] LoopCandidate candidate_row(const LoopMatch& match, const PairVerdict& verdict);

/// What becomes of a match. At most one of the last three is set.
struct LoopVerdict {
  LoopCandidate row;
  std::optional<PairMeasurement> edge;  ///< joins the pair now
  /// Believed as far as two images go: waits until other keyframes (submaps) or frames (a lost
  /// camera) agree.
  std::optional<PairMeasurement> unconfirmed;
  std::optional<PairMeasurement> contradiction;  ///< the graph refuses it and may be wrong
};

/// The verdict for a match that is not registered.
[[nodiscard]] LoopVerdict rejected(const LoopMatch& match, const std::string& reason);

/// Recognises keyframes by their images, registers pairs, and decides by what the graph says. The
/// cloud of the image stays between calls: judge() is for the matches of the latest recognize(),
/// judge_lost() for those of the latest recognize_lost().
class LoopClosing {
 public:
  /// Uses the built-in vocabulary if `vocabulary` is null.
  LoopClosing(const Camera& camera, const RegistrationOptions& registration, int threads,
              const LoopClosingOptions& options, const RegistrationNoise& noise,
              const std::shared_ptr<const Vocabulary>& vocabulary);

  /// Enters a keyframe of another map, by what features_of() returned there.
  void restore(std::size_t number, const std::string& features);
  /// Forgets a keyframe.
  void remove(std::size_t number);
  /// The features of a keyframe, as bytes.
  [[nodiscard]] std::string features_of(std::size_t number) const;
  [[nodiscard]] std::uint32_t vocabulary_checksum() const;
  /// Writes where the detector has the keyframes, or enters `keyframes`, of which nothing was
  /// entered yet, there.
  void exchange(SavedState& state, const std::vector<KeyframeMemory>& keyframes);

  /// The earlier keyframes that the newest one, with these images, seems to show, with those that
  /// verification rejected, for loops.csv. Enters the image into the index and keeps the cloud as
  /// the newer one of the pairs.
  [[nodiscard]] std::vector<LoopMatch> recognize(const RgbdFrame& images, const PointCloud& cloud);
  /// Memory of the keyframes' features, words and index [bytes].
  [[nodiscard]] std::size_t bytes() const { return detector_.bytes(); }
  /// The features and words of the last images; for several threads.
  [[nodiscard]] AppearanceCache& appearances() { return appearances_; }
  /// Judges one of the matches of the latest recognize(). `paths` starts at the newest keyframe.
  [[nodiscard]] LoopVerdict judge(const std::vector<LoopMatch>& matches, std::size_t index,
                                  const MapState& map, PathSearch& paths);

  /// The keyframes that a lost image, with its points, seems to show, with those that verification
  /// rejected. Keeps the cloud as the newer one of the pairs; the index stays as it is.
  [[nodiscard]] std::vector<LoopMatch> recognize_lost(const RgbdFrame& images,
                                                      const PointCloud& cloud);
  /// Judges one of the matches of the latest recognize_lost(), without a prior: it is unconfirmed
  /// at most.
  [[nodiscard]] LoopVerdict judge_lost(const std::vector<LoopMatch>& matches, std::size_t index,
                                       const Timestamp& stamp, const MapState& map);

 private:
  [[nodiscard]] LoopVerdict judge_by_prior(const std::vector<LoopMatch>& matches, std::size_t index,
                                           const MapState& map, PathSearch& paths);
  [[nodiscard]] LoopVerdict judge_by_images(const std::vector<LoopMatch>& matches,
                                            std::size_t index, const Timestamp& now,
                                            const MapState& map);

  FieldOfView field_of_view_;
  LoopClosingOptions options_;
  LoopDetector detector_;
  std::unordered_map<std::size_t, std::size_t> places_;  // in the detector, by number
  AppearanceCache appearances_;
  PairRegistration registration_;
};

/// The loop edge that fits the optimised graph worst.
struct WorstLoop {
  std::size_t edge = 0;
  double error = 0;  ///< [standard deviations]
};

/// The worst loop edge if its error exceeds `max_residual`.
[[nodiscard]] std::optional<WorstLoop> find_worst_loop(const PoseGraph& graph, double max_residual);

}  // namespace cvo_slam
