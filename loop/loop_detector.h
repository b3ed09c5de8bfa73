// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/loop/keyframe_database.h"
#include "cvo_slam/loop/loop_options.h"
#include "cvo_slam/loop/loop_verifier.h"
#include "cvo_slam/loop/vocabulary.h"

namespace cvo_slam {

struct CandidateGroup;

/// A keyframe that may show the place of the image that was asked for, and the verdict.
struct LoopMatch {
  std::size_t query = 0;     ///< id of the image
  std::size_t keyframe = 0;  ///< id of the keyframe
  double score = 0;          ///< bag_score() of the two
  /// The score divided by that of the image and the keyframe before it: 1 = as alike as neighbours.
  double normalized_score = 0;
  int shared_words = 0;
  int consistency = 0;        ///< how many images in a row before this one led to the same place
  Verification verification;  ///< a = the keyframe, b = the image: T_a_b is T_keyframe_query
};

/// Recognises places: by their visual words first, then by their geometry.
///
///   LoopDetector detector(camera);
///   for (each keyframe) {
///     auto appearance = detector.extract(frame);
///     for (const LoopMatch& match : detector.find_loops(*appearance)) ...
///     detector.add(appearance);
///   }
///
/// Answers follow from the images, their order and their ids alone. All but extract() is for one
/// thread at a time.
class LoopDetector {
 public:
  /// Without a vocabulary, with the built-in one. Throws OptionError for a bad option or camera.
  explicit LoopDetector(const Camera& camera, const LoopOptions& options = {},
                        std::shared_ptr<const Vocabulary> vocabulary = nullptr);

  /// The features and words of an image; its id is the frame's index. None where there are none
  /// (extract_orb()); such an image matches nothing. May be called from several threads.
  [[nodiscard]] std::shared_ptr<const Appearance> extract(const RgbdFrame& frame) const;

  /// The keyframes that the next keyframe, not yet added, may have come back to, all older than the
  /// newest CandidateOptions::min_gap: the best of each place, the likeliest place first.
  [[nodiscard]] std::vector<LoopMatch> find_loops(const Appearance& query);
  /// The same for an image from anywhere, e.g. when tracking is lost: any keyframe will do.
  [[nodiscard]] std::vector<LoopMatch> relocalize(const Appearance& query);

  /// Adds the next keyframe.
  void add(std::shared_ptr<const Appearance> keyframe);

  /// Number of keyframes.
  [[nodiscard]] std::size_t size() const { return keyframes_.size(); }
  [[nodiscard]] const Appearance& keyframe(std::size_t i) const { return *keyframes_[i]; }
  /// Memory of the keyframes' features, words and index [bytes].
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Place {
    std::size_t first = 0;
    std::size_t last = 0;
    int consistency = 0;
  };

  [[nodiscard]] int consistency(const Place& place) const;
  [[nodiscard]] LoopMatch to_match(const Appearance& query, const CandidateGroup& group,
                                   double neighbor) const;

  Camera camera_;
  LoopOptions options_;
  std::shared_ptr<const Vocabulary> vocabulary_;
  LoopVerifier verifier_;
  KeyframeDatabase database_;
  std::vector<std::shared_ptr<const Appearance>> keyframes_;
  std::vector<Place> places_;  // that the last query of find_loops() led to
};

}  // namespace cvo_slam
