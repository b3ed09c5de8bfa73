// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <map>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/loop/vocabulary.h"
#include "cvo_slam/slam/ambiguity_internal.h"
#include "cvo_slam/slam/loop_closing_internal.h"
#include "cvo_slam/slam/proximity_internal.h"

namespace cvo_slam {

LoopCandidate candidate_row(EdgeKind kind, std::size_t older, std::size_t newer,
                            const PairVerdict& verdict) {
  LoopCandidate row;
  row.kind = kind;
  row.from = older;
  row.to = newer;
  row.overlap = verdict.overlap;
  row.cos_theta = verdict.cos_theta;
  row.round_trip_translation = verdict.round_trip_translation;
  row.round_trip_rotation = verdict.round_trip_rotation;
  row.correction_translation = verdict.correction_translation;
  row.correction_rotation = verdict.correction_rotation;
  row.error = verdict.error;
  row.accepted = verdict.measurement.has_value();
  row.reason = verdict.reason;
  return row;
}

LoopCandidate candidate_row(const LoopMatch& match, const PairVerdict& verdict) {
  LoopCandidate row = candidate_row(EdgeKind::kLoop, match.keyframe, match.query, verdict);
  row.score = match.score;
  row.normalized_score = match.normalized_score;
  row.inliers = match.verification.inliers;
  row.pixels = match.verification.pixels;
  return row;
}

LoopVerdict rejected(const LoopMatch& match, const std::string& reason) {
  LoopVerdict verdict;
  verdict.row = candidate_row(match, PairVerdict::rejected(reason));
  return verdict;
}

LoopClosing::LoopClosing(const Camera& camera, const RegistrationOptions& registration, int threads,
                         const LoopClosingOptions& options, const RegistrationNoise& noise,
                         const std::shared_ptr<const Vocabulary>& vocabulary)
    : field_of_view_(camera.color),
      options_(options),
      detector_(camera, options.detection, vocabulary),
      appearances_(detector_),
      registration_(registration, threads, options.pair, noise) {}

void LoopClosing::restore(std::size_t number, const std::string& features) {
  places_.emplace(number, detector_.size());
  detector_.add(number, features);
}

void LoopClosing::remove(std::size_t number) {
  const auto place = places_.find(number);
  if (place == places_.end()) return;  // it had no images
  detector_.remove(place->second);
  places_.erase(place);
}

std::string LoopClosing::features_of(std::size_t number) const {
  return detector_.features_of(places_.at(number));
}

std::uint32_t LoopClosing::vocabulary_checksum() const {
  return crc32_of(vocabulary_bytes(detector_.vocabulary()));
}

void LoopClosing::exchange(SavedState& state, const std::vector<KeyframeMemory>& keyframes) {
  std::map<std::size_t, std::size_t> places(places_.begin(), places_.end());
  std::size_t size = detector_.size();
  state(places, size);
  if (!state.is_reading()) return;
  std::size_t entered = 0;
  for (const KeyframeMemory& keyframe : keyframes) {
    const auto place = places.find(keyframe.number);
    if (place == places.end()) continue;
    if (place->second < detector_.size() || place->second >= size) break;
    // Keyframes that were removed leave their places.
    while (detector_.size() < place->second) {
      detector_.add(std::make_shared<const Appearance>());
      detector_.remove(detector_.size() - 1);
    }
    restore(keyframe.number, keyframe.features);
    ++entered;
  }
  if (entered != places.size()) {
    throw DataError("a saved state does not belong to the keyframes of its map");
  }
}

std::vector<LoopMatch> LoopClosing::recognize(const RgbdFrame& images, const PointCloud& cloud) {
  const auto appearance = appearances_.of(images);
  std::vector<LoopMatch> matches = detector_.find_loops(*appearance);
  places_.emplace(images.index, detector_.size());
  detector_.add(appearance);
  if (!matches.empty()) registration_.set_newer(cloud);
  return matches;
}

LoopVerdict LoopClosing::judge(const std::vector<LoopMatch>& matches, std::size_t index,
                               const MapState& map, PathSearch& paths) {
  const LoopMatch& match = matches[index];
  const std::size_t older_position = map.keyframes.position_of(match.keyframe);
  const std::size_t newest_position = map.keyframes.size() - 1;
  const bool is_connected = map.submap_at(older_position) == map.submap_at(newest_position);
  LoopVerdict verdict;
  if (!match.verification.accepted) {
    verdict = rejected(match, match.verification.reason);
  } else if (map.graph.graph().has_edge(node_id(match.keyframe), node_id(match.query))) {
    verdict = rejected(match, "joined already, as near keyframes");
  } else if (is_connected) {
    verdict = judge_by_prior(matches, index, map, paths);
  } else {
    verdict = judge_by_images(matches, index, map.keyframes.newest().stamp, map);
    if (verdict.unconfirmed)
      verdict.row.reason = "of another submap: waits for keyframes that agree";
  }
  if (is_connected) {
    verdict.row.expected_overlap = mutual_overlap(
        map.keyframes[older_position].cloud, map.keyframes[newest_position].cloud,
        map.graph.pose(older_position).inverse() * map.graph.pose(newest_position), field_of_view_);
  }
  return verdict;
}

/// Judges a match whose keyframe the graph connects with the newest one.
LoopVerdict LoopClosing::judge_by_prior(const std::vector<LoopMatch>& matches, std::size_t index,
                                        const MapState& map, PathSearch& paths) {
  const LoopMatch& match = matches[index];
  const std::size_t older_position = map.keyframes.position_of(match.keyframe);
  const std::size_t newest_position = map.keyframes.size() - 1;
  // There is a path: edges added since the search was made join no submaps.
  const auto covariance = paths.covariance_to(older_position);
  const PairPrior prior =
      graph_prior(map.graph, older_position, newest_position, covariance.value());
  const PairVerdict pair = registration_.register_both_ways(
      map.keyframes[older_position].cloud.points(), match.verification.T_a_b, &prior,
      map.usual_cos_theta.mean());
  LoopVerdict verdict{.row = candidate_row(match, pair),
                      .edge = pair.measurement,
                      .unconfirmed = {},
                      .contradiction = {}};
  // Where the way there leads through another recognised keyframe, it is the graph that may be
  // wrong.
  const bool crosses_submaps =
      map.keyframes[older_position].tracked_submap != map.keyframes.newest().tracked_submap;
  if (pair.error > options_.pair.max_error && crosses_submaps) {
    verdict.contradiction =
        judge_by_images(matches, index, map.keyframes.newest().stamp, map).unconfirmed;
  }
  return verdict;
}

/// Judges a match whose keyframe the graph does not connect with the image: a measurement that is
/// believed as far as two images go.
LoopVerdict LoopClosing::judge_by_images(const std::vector<LoopMatch>& matches, std::size_t index,
                                         const Timestamp& now, const MapState& map) {
  const LoopMatch& match = matches[index];
  const RelocalizationOptions& options = options_.relocalization;
  const std::string reason = ambiguity_of_images(matches, index, map, options);
  if (!reason.empty()) return rejected(match, reason);
  const std::size_t older_position = map.keyframes.position_of(match.keyframe);
  const PairVerdict pair = registration_.register_both_ways(
      map.keyframes[older_position].cloud.points(), match.verification.T_a_b, nullptr,
      map.usual_cos_theta.mean());
  LoopVerdict verdict{.row = candidate_row(match, pair),
                      .edge = {},
                      .unconfirmed = pair.measurement,
                      .contradiction = {}};
  verdict.row.accepted = false;
  if (!pair.measurement) return verdict;
  verdict.row.reason = ambiguity_of_registration(match, pair.cos_theta, now, map, options);
  if (!verdict.row.reason.empty()) verdict.unconfirmed.reset();
  return verdict;
}

std::vector<LoopMatch> LoopClosing::recognize_lost(const RgbdFrame& images,
                                                   const PointCloud& cloud) {
  std::vector<LoopMatch> matches = detector_.relocalize(*appearances_.of(images));
  const bool any = std::any_of(matches.begin(), matches.end(),
                               [](const LoopMatch& match) { return match.verification.accepted; });
  if (any) registration_.set_newer(cloud);
  return matches;
}

LoopVerdict LoopClosing::judge_lost(const std::vector<LoopMatch>& matches, std::size_t index,
                                    const Timestamp& stamp, const MapState& map) {
  const Verification& verification = matches[index].verification;
  LoopVerdict verdict = verification.accepted ? judge_by_images(matches, index, stamp, map)
                                              : rejected(matches[index], verification.reason);
  if (verdict.unconfirmed) verdict.row.reason = "waits for frames that agree";
  return verdict;
}

std::optional<WorstLoop> find_worst_loop(const PoseGraph& graph, double max_residual) {
  WorstLoop worst;
  for (std::size_t i = 0; i < graph.edges().size(); ++i) {
    if (graph.edges()[i].kind != EdgeKind::kLoop) continue;
    const double error = std::sqrt(squared_error(graph, i));
    if (error > worst.error) worst = {i, error};
  }
  if (worst.error <= max_residual) return std::nullopt;
  return worst;
}

}  // namespace cvo_slam
