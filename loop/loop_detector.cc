// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/loop/loop_detector.h"

#include <algorithm>
#include <utility>

#include "cvo_slam/loop/candidate_groups_internal.h"
#include "cvo_slam/loop/compact_features_internal.h"

namespace cvo_slam {

/// What the detector remembers of a keyframe.
struct DetectorKeyframe {
  std::size_t id = 0;
  CompactFeatures features;
  ImageWords words;
};

namespace {

OptionSet describe_candidates(CandidateOptions& o) {
  return OptionSet()
      .add("min_gap", o.min_gap, {0, 1000000}, "keyframes",
           "Number of newest keyframes that are not searched, because tracking connects them.")
      .add("min_score", o.min_score, {0, 1}, "",
           "Least bag-of-words score of a candidate, as a share of the score with the preceding "
           "keyframe.")
      .expert()
      .add("candidates", o.candidates, {1, 1000}, "", "Most places to verify for an image.")
      .add("min_neighbor_score", o.min_neighbor_score, {0, 1}, "",
           "Least value that is used as the score with the preceding keyframe, for fast motions.")
      .add("group_gap", o.group_gap, {1, 1000}, "keyframes",
           "Candidates at most this far apart are the same place.");
}

std::size_t bytes_of(const DetectorKeyframe& keyframe) {
  return sizeof(DetectorKeyframe) + keyframe.features.bytes() +
         keyframe.words.bag.size() * sizeof(WordWeight) +
         keyframe.words.nodes.size() * sizeof(NodeFeature);
}

/// Returns the groups of the matches with a sufficient score, the best ones first.
std::vector<CandidateGroup> best_groups(std::vector<KeyframeMatch> matches, double reference_score,
                                        const CandidateOptions& options) {
  std::erase_if(matches, [&](const KeyframeMatch& match) {
    return match.score < options.min_score * reference_score;
  });
  auto groups = group_candidates(matches, static_cast<std::size_t>(options.group_gap));
  const auto most = static_cast<std::size_t>(options.candidates);
  if (groups.size() > most) groups.resize(most);
  return groups;
}

LoopOptions checked(LoopOptions options) {
  describe(options).check();
  return options;
}

}  // namespace

OptionSet describe(LoopOptions& o) {
  return OptionSet()
      .add("orb", describe(o.orb))
      .add("candidates", describe_candidates(o.candidates))
      .add("verification", describe(o.verification));
}

LoopDetector::LoopDetector(const Camera& camera, const LoopOptions& options,
                           std::shared_ptr<const Vocabulary> vocabulary)
    : camera_(camera),
      options_(checked(options)),
      vocabulary_(vocabulary ? std::move(vocabulary) : builtin_vocabulary()),
      verifier_(camera, options.verification),
      database_(vocabulary_->words()) {
  camera_.check();
}

std::shared_ptr<const Appearance> LoopDetector::extract(const RgbdFrame& frame) const {
  Appearance appearance;
  appearance.id = frame.index;
  appearance.features = extract_orb(frame, camera_, options_.orb);
  appearance.words = vocabulary_->transform(appearance.features.descriptors,
                                            options_.verification.matching.node_level);
  return std::make_shared<const Appearance>(std::move(appearance));
}

std::vector<LoopMatch> LoopDetector::find_loops(const Appearance& query) {
  if (keyframes_.empty() || !keyframes_.back()) return {};
  const CandidateOptions& options = options_.candidates;
  const double neighbor_score = std::max(options.min_neighbor_score,
                                         bag_score(query.words.bag, keyframes_.back()->words.bag));
  const std::size_t end = size() - std::min(size(), static_cast<std::size_t>(options.min_gap));
  const auto groups = best_groups(database_.query(query.words.bag, end), neighbor_score, options);
  return verify(query, groups, neighbor_score);
}

std::vector<LoopMatch> LoopDetector::relocalize(const Appearance& query) {
  const auto candidates = database_.query(query.words.bag, size());
  double best_score = options_.candidates.min_neighbor_score;
  for (const KeyframeMatch& candidate : candidates) {
    best_score = std::max(best_score, candidate.score);
  }
  return verify(query, best_groups(candidates, best_score, options_.candidates), best_score);
}

std::vector<LoopMatch> LoopDetector::verify(const Appearance& query,
                                            const std::vector<CandidateGroup>& groups,
                                            double reference_score) const {
  std::vector<LoopMatch> matches;
  for (const CandidateGroup& group : groups) {
    const KeyframeMatch& best = group.best;
    const DetectorKeyframe& stored = *keyframes_[best.position];
    const Appearance keyframe{stored.id, stored.features.features(camera_.color), stored.words};
    matches.push_back({.query = query.id,
                       .keyframe = keyframe.id,
                       .score = best.score,
                       .normalized_score = best.score / reference_score,
                       .shared_words = best.shared_words,
                       .verification = verifier_.verify(keyframe, query)});
  }
  return matches;
}

void LoopDetector::add(const std::shared_ptr<const Appearance>& keyframe) {
  database_.add(keyframe->words.bag);
  keyframes_.push_back(std::make_shared<const DetectorKeyframe>(
      DetectorKeyframe{keyframe->id, CompactFeatures(keyframe->features), keyframe->words}));
}

void LoopDetector::add(std::size_t id, std::string_view features) {
  DetectorKeyframe keyframe{id, CompactFeatures::from_bytes(features), {}};
  keyframe.words = vocabulary_->transform(keyframe.features.descriptors(),
                                          options_.verification.matching.node_level);
  database_.add(keyframe.words.bag);
  keyframes_.push_back(std::make_shared<const DetectorKeyframe>(std::move(keyframe)));
}

std::string LoopDetector::features_of(std::size_t i) const {
  return keyframes_[i]->features.to_bytes();
}

void LoopDetector::remove(std::size_t i) {
  database_.remove(i, keyframes_[i]->words.bag);
  keyframes_[i].reset();
}

std::size_t LoopDetector::bytes() const {
  std::size_t sum = database_.bytes();
  for (const auto& keyframe : keyframes_) {
    if (keyframe) sum += bytes_of(*keyframe);
  }
  return sum;
}

}  // namespace cvo_slam
