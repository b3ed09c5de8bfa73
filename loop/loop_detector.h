// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/options.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/loop/loop_verifier.h"
#include "cvo_slam/loop/orb_features.h"
#include "cvo_slam/loop/vocabulary.h"

namespace cvo_slam {

struct CandidateGroup;
struct DetectorKeyframe;

/// Which keyframes become loop candidates.
struct CandidateOptions {
  /// Number of newest keyframes that are not searched [keyframes], 0 to 1000000. They look alike
  /// because little has happened since, and tracking connects them. Lower it for short loops at
  /// few keyframes per second.
  int min_gap = 15;
  /// Least bag-of-words score of a candidate, as a share of the score with the preceding keyframe,
  /// 0 to 1. Lower values find more loops under changed viewpoints and cost more verifications.
  double min_score = 0.3;
  /// Least value that is used as the score with the preceding keyframe, for fast motions, 0 to 1.
  double min_neighbor_score = 0.05;
  /// Largest gap between candidates of the same place [keyframes], 1 to 1000.
  int group_gap = 3;
  /// Most places to verify for an image, 1 to 1000. A verification takes a few milliseconds.
  int candidates = 3;
};

/// How places are recognised by features.
struct LoopOptions {
  OrbOptions orb;                    ///< how features are extracted
  CandidateOptions candidates;       ///< which keyframes are tried
  VerificationOptions verification;  ///< which of them are accepted
};

/// Returns the options with their keys, ranges and documentation.
[[nodiscard]] OptionSet describe(LoopOptions& options);

/// A keyframe that may show the same place as an image, and the result of the verification.
struct LoopMatch {
  std::size_t query = 0;     ///< id of the image
  std::size_t keyframe = 0;  ///< id of the keyframe
  double score = 0;          ///< bag_score() of the two
  /// The score divided by that with the preceding keyframe, or for a lost image (relocalize()) by
  /// the best score; the divisor is not less than CandidateOptions::min_neighbor_score. 1 means as
  /// similar as neighbours.
  double normalized_score = 0;
  int shared_words = 0;       ///< number of different words that both images show
  Verification verification;  ///< a is the keyframe and b the image: T_a_b is T_keyframe_query
};

/// A keyframe that shares words with an image.
struct KeyframeMatch {
  std::size_t position = 0;  ///< of the keyframe: counted from 0 in the order of add()
  double score = 0;          ///< bag_score()
  int shared_words = 0;      ///< number of different words that both images show

  /// Returns true if all members are equal.
  bool operator==(const KeyframeMatch&) const = default;
};

/// An inverted index: for each word the keyframes that show it. A query visits only the entries of
/// its own words, so that its cost grows with the number of shared words. Takes 8 bytes per word of
/// a keyframe (8 KB with 1,000 different words), and 32 per word of the vocabulary. For one thread
/// at a time.
class KeyframeDatabase {
 public:
  /// `words` is the number of words of the vocabulary.
  explicit KeyframeDatabase(std::size_t words);

  /// Adds the next keyframe. Throws DataError for a word that the vocabulary does not have.
  void add(const BagOfWords& bag);
  /// Removes the keyframe at a position, whose words are given. Others keep their positions.
  void remove(std::size_t position, const BagOfWords& bag);
  /// Returns those of the first `end` keyframes that share a word, in ascending order.
  [[nodiscard]] std::vector<KeyframeMatch> query(const BagOfWords& bag, std::size_t end);

  /// Number of keyframes that were added.
  [[nodiscard]] std::size_t size() const { return sums_.size(); }
  /// Memory of the index [bytes].
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Entry {
    std::uint32_t position = 0;
    float weight = 0;
  };
  struct Sum {
    double score = 0;
    int shared_words = 0;
  };

  std::vector<std::vector<Entry>> entries_;  // indexed by word, positions ascending
  std::vector<Sum> sums_;                    // indexed by position; zero between queries
};

/// Place recognition: finds earlier keyframes by their visual words and verifies them by geometry.
///
///     LoopDetector detector(camera);
///     for (each keyframe) {
///       auto appearance = detector.extract(frame);
///       for (const LoopMatch& match : detector.find_loops(*appearance)) {
///         if (!match.verification.accepted) continue;
///         ...
///       }
///       detector.add(appearance);
///     }
///
/// The results depend only on the images, their order and their ids. All functions except extract()
/// are for one thread at a time. Only the word query of find_loops() and
/// relocalize() takes longer with more keyframes.
class LoopDetector {
 public:
  /// Uses the built-in vocabulary if none is given. Throws OptionError for a bad option or camera.
  explicit LoopDetector(const Camera& camera, const LoopOptions& options = {},
                        std::shared_ptr<const Vocabulary> vocabulary = nullptr);

  /// Returns the features and words of an image, with the frame's index as id. An image without
  /// features (see extract_orb()) matches nothing. May be called from several threads.
  [[nodiscard]] std::shared_ptr<const Appearance> extract(const RgbdFrame& frame) const;

  /// Returns the keyframes whose place the next keyframe, not yet added, may show, all older than
  /// the newest CandidateOptions::min_gap: the best match of each place, the likeliest place first.
  /// Matches that verification rejects are among them: test LoopMatch::verification.accepted.
  [[nodiscard]] std::vector<LoopMatch> find_loops(const Appearance& query);
  /// Returns the same for an image from anywhere, e.g. when tracking is lost; searches all
  /// keyframes.
  [[nodiscard]] std::vector<LoopMatch> relocalize(const Appearance& query);

  /// Adds the next keyframe. Of its features 40 bytes each are kept: places are rounded to 1/16 px,
  /// depths to 0.1 %, orientations to 1.4 degrees.
  void add(const std::shared_ptr<const Appearance>& keyframe);
  /// Adds the next keyframe, with what features_of() returned for it. Throws DataError if the bytes
  /// are not those of features.
  void add(std::size_t id, std::string_view features);
  /// Removes a keyframe, counted from 0 in the order of add(); others keep their numbers. The
  /// newest one may not be removed.
  void remove(std::size_t i);

  /// Returns the vocabulary in use.
  [[nodiscard]] const Vocabulary& vocabulary() const { return *vocabulary_; }
  /// Number of keyframes that were added.
  [[nodiscard]] std::size_t size() const { return keyframes_.size(); }
  /// Returns the features of a keyframe that was not removed, counted from 0 in the order of add(),
  /// as bytes for a file.
  [[nodiscard]] std::string features_of(std::size_t i) const;
  /// Memory of the keyframes' features, words and index [bytes].
  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] std::vector<LoopMatch> verify(const Appearance& query,
                                              const std::vector<CandidateGroup>& groups,
                                              double reference_score) const;

  Camera camera_;
  LoopOptions options_;
  std::shared_ptr<const Vocabulary> vocabulary_;
  LoopVerifier verifier_;
  KeyframeDatabase database_;
  std::vector<std::shared_ptr<const DetectorKeyframe>> keyframes_;  // null where one was removed
};

}  // namespace cvo_slam
