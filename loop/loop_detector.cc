// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/loop/loop_detector.h"

#include <algorithm>

#include <fmt/format.h>

#include "cvo_slam/loop/builtin_vocabulary.h"
#include "cvo_slam/loop/candidate_groups_internal.h"

namespace cvo_slam {
namespace {

std::size_t bytes_of(const Appearance& appearance) {
  const OrbFeatures& features = appearance.features;
  return sizeof(Appearance) + features.points.capacity() * sizeof(OrbFeature) +
         features.descriptors.capacity() * sizeof(Descriptor) +
         appearance.words.bag.capacity() * sizeof(WordWeight) +
         appearance.words.nodes.capacity() * sizeof(NodeFeature);
}

/// Those that are alike enough, most of them first.
std::vector<CandidateGroup> best_groups(std::vector<KeyframeMatch> matches, double neighbor,
                                        const CandidateOptions& options) {
  std::erase_if(matches, [&](const KeyframeMatch& match) {
    return match.score < options.min_score * neighbor;
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

LoopDetector::LoopDetector(const Camera& camera, const LoopOptions& options,
                           std::shared_ptr<const Vocabulary> vocabulary)
    : camera_(camera),
      options_(checked(options)),
      vocabulary_(vocabulary ? std::move(vocabulary) : builtin_vocabulary()),
      verifier_(camera.color, options.verification),
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

int LoopDetector::consistency(const Place& place) const {
  const auto gap = static_cast<std::size_t>(options_.candidates.group_gap);
  int longest = 0;
  for (const Place& earlier : places_) {
    const bool is_near = place.first <= earlier.last + gap && earlier.first <= place.last + gap;
    if (is_near) longest = std::max(longest, earlier.consistency + 1);
  }
  return longest;
}

std::vector<LoopMatch> LoopDetector::find_loops(const Appearance& query) {
  if (keyframes_.empty()) return {};
  const CandidateOptions& options = options_.candidates;
  const double neighbor = std::max(options.min_neighbor_score,
                                   bag_score(query.words.bag, keyframes_.back()->words.bag));
  const std::size_t end = size() - std::min(size(), static_cast<std::size_t>(options.min_gap));
  std::vector<LoopMatch> matches;
  std::vector<Place> places;
  for (const CandidateGroup& group :
       best_groups(database_.query(query.words.bag, end), neighbor, options)) {
    Place place{group.first, group.last, 0};
    place.consistency = consistency(place);
    places.push_back(place);
    matches.push_back(to_match(query, group, neighbor));
    LoopMatch& match = matches.back();
    match.consistency = place.consistency;
    if (place.consistency >= options.min_consistency) {
      match.verification = verifier_.verify(*keyframes_[group.best.keyframe], query);
    } else {
      match.verification.reason = fmt::format("{} images in a row before it led here; {} needed",
                                              place.consistency, options.min_consistency);
    }
  }
  places_ = std::move(places);
  return matches;
}

std::vector<LoopMatch> LoopDetector::relocalize(const Appearance& query) {
  const auto candidates = database_.query(query.words.bag, size());
  double best = options_.candidates.min_neighbor_score;
  for (const KeyframeMatch& candidate : candidates) best = std::max(best, candidate.score);
  std::vector<LoopMatch> matches;
  for (const CandidateGroup& group : best_groups(candidates, best, options_.candidates)) {
    matches.push_back(to_match(query, group, best));
    matches.back().verification = verifier_.verify(*keyframes_[group.best.keyframe], query);
  }
  return matches;
}

LoopMatch LoopDetector::to_match(const Appearance& query, const CandidateGroup& group,
                                 double neighbor) const {
  LoopMatch match;
  match.query = query.id;
  match.keyframe = keyframes_[group.best.keyframe]->id;
  match.score = group.best.score;
  match.normalized_score = group.best.score / neighbor;
  match.shared_words = group.best.shared_words;
  return match;
}

void LoopDetector::add(std::shared_ptr<const Appearance> keyframe) {
  database_.add(keyframe->words.bag);
  keyframes_.push_back(std::move(keyframe));
}

std::size_t LoopDetector::bytes() const {
  std::size_t sum = database_.bytes();
  for (const auto& keyframe : keyframes_) sum += bytes_of(*keyframe);
  return sum;
}

}  // namespace cvo_slam
