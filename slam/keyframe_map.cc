// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cvo_slam/core/pose_graph.h"
#include "cvo_slam/slam/keyframe_map_internal.h"
#include "cvo_slam/slam/path_uncertainty_internal.h"
#include "cvo_slam/slam/view_overlap_internal.h"

namespace cvo_slam {
namespace {

bool are_joined(const PoseGraph& graph, NodeId from, NodeId to) {
  return std::any_of(graph.edges().begin(), graph.edges().end(),
                     [&](const PoseGraphEdge& edge) { return edge.from == from && edge.to == to; });
}

struct LoopResidual {
  std::size_t edge = 0;
  double error = 0;  // [standard deviations]
};

/// The loop that fits the graph's poses worst; an error of 0 where there is none.
LoopResidual worst_loop(const PoseGraph& graph) {
  LoopResidual worst;
  for (std::size_t i = 0; i < graph.edges().size(); ++i) {
    if (graph.edges()[i].kind != EdgeKind::kLoop) continue;
    const double error = std::sqrt(squared_error(graph, i));
    if (error > worst.error) worst = {i, error};
  }
  return worst;
}

}  // namespace

LoopCandidate candidate_of(const LoopMatch& match) {
  LoopCandidate candidate;
  candidate.kind = EdgeKind::kLoop;
  candidate.from = match.keyframe;
  candidate.to = match.query;
  candidate.score = match.score;
  candidate.normalized_score = match.normalized_score;
  candidate.inliers = match.verification.inliers;
  candidate.pixels = match.verification.pixels;
  return candidate;
}

KeyframeMap::KeyframeMap(const Camera& camera, const RegistrationOptions& registration, int threads,
                         const SlamOptions& options,
                         const std::shared_ptr<const Vocabulary>& vocabulary)
    : camera_(camera),
      options_(options),
      noise_{options.noise_translation, options.noise_rotation},
      near_verifier_(registration, threads, options.proximity.pair, noise_),
      optimizer_(options.optimizer) {
  const LoopClosingOptions& loops = options_.loops;
  if (!loops.enabled) return;
  loop_closer_.emplace(LoopCloser{LoopDetector(camera, loops.detection, vocabulary),
                                  PairVerifier(registration, threads, loops.pair, noise_)});
}

SE3 KeyframeMap::add(const TrackedKeyframe& keyframe) {
  add_node(keyframe);
  // Of the graph as its poses are: what is joined now has not moved them yet.
  const Covariances covariances = path_covariances(graph(), views_.size() - 1);
  join_near_views(covariances);
  bool has_loop = loop_closer_ && keyframe.image && close_loops(*keyframe.image, covariances);
  take_back_joins();
  has_loop = join_parts() || has_loop;
  ++not_optimized_;
  if (has_loop) {
    optimize_all();
  } else if (not_optimized_ >= options_.optimize_every) {
    optimize(OptimizationScope::kWindow);
  }
  return graph().nodes().back().T_world_node;
}

void KeyframeMap::add_node(const TrackedKeyframe& keyframe) {
  is_optimized_ = false;
  SE3 T_world_camera = keyframe.T_world_camera;
  int part = keyframe.segment;
  if (const auto& known = keyframe.link ? keyframe.link : keyframe.place) {
    const KeyframeView& reference = views_[graph().index_of(node_id(known->reference))];
    T_world_camera = (reference.T_world_camera * known->T_reference_keyframe).normalized();
    part = reference.part;
  } else if (!views_.empty()) {
    T_world_camera = after_gap(keyframe);
  }
  views_.push_back(
      {keyframe.frame, keyframe.segment, part, T_world_camera, keyframe.cloud, keyframe.stamp});
  T_world_newest_tracked_ = keyframe.T_world_camera;
  optimizer_.add_node({node_id(keyframe.frame), T_world_camera});
  if (keyframe.place) add_place(*keyframe.place, keyframe.frame);
  if (!keyframe.link) return;
  const KeyframeLink& link = *keyframe.link;
  optimizer_.add_edge(
      {node_id(link.reference), node_id(keyframe.frame), link.T_reference_keyframe,
       edge_information(link.T_reference_keyframe, noise_.added_to(link.information)),
       EdgeKind::kOdometry});
  sum_of_cos_theta_ += link.cos_theta;
  ++odometry_edges_;
}

void KeyframeMap::join_near_views(const Covariances& covariances) {
  const auto near = find_near_views(views_, camera_.color, options_.proximity);
  if (near.empty()) return;
  near_verifier_.set_newest(*views_.back().cloud);
  for (const NearView& view : near) {
    const auto& covariance = covariances[view.index];
    if (!covariance) continue;
    LoopCandidate candidate;
    candidate.from = views_[view.index].frame;
    candidate.to = views_.back().frame;
    candidate.expected_overlap = view.expected_overlap;
    const PairPrior prior = prior_of(view.index, *covariance);
    join(near_verifier_, view.index, prior.T_older_newer, prior, candidate);
    candidates_.push_back(candidate);
  }
}

/// Answers whether there is a new edge.
bool KeyframeMap::close_loops(const RgbdFrame& image, const Covariances& covariances) {
  LoopDetector& detector = loop_closer_->detector;
  const auto appearance = detector.extract(image);
  const std::vector<LoopMatch> matches = detector.find_loops(*appearance);
  detector.add(appearance);
  if (!matches.empty()) loop_closer_->verifier.set_newest(*views_.back().cloud);
  bool closed = false;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    LoopCandidate candidate = candidate_of(matches[i]);
    close_loop(matches, i, covariances, candidate);
    closed = closed || candidate.accepted;
    candidates_.push_back(std::move(candidate));
  }
  return closed;
}

void KeyframeMap::close_loop(const std::vector<LoopMatch>& matches, std::size_t index,
                             const Covariances& covariances, LoopCandidate& candidate) {
  const LoopMatch& match = matches[index];
  const std::size_t older = graph().index_of(node_id(match.keyframe));
  const auto& covariance = covariances[older];
  const KeyframeView& view = views_[older];
  if (covariance) {
    candidate.expected_overlap =
        mutual_overlap(*view.cloud, *views_.back().cloud,
                       view.T_world_camera.inverse() * views_.back().T_world_camera, camera_.color);
  }
  if (!match.verification.accepted) {
    candidate.reason = match.verification.reason;
  } else if (are_joined(graph(), node_id(match.keyframe), node_id(match.query))) {
    candidate.reason = "joined already, as near ones";
  } else if (covariance) {
    const PairPrior prior = prior_of(older, *covariance);
    join(loop_closer_->verifier, older, match.verification.T_a_b, prior, candidate);
    if (candidate.error > options_.loops.pair.max_error) keep_contradiction(matches, index);
  } else if (candidate.reason = find_doubt(matches, index); candidate.reason.empty()) {
    link_part(match, candidate);
  }
}

/// `covariance` is that of a perturbation of the older one as seen from the newest.
PairPrior KeyframeMap::prior_of(std::size_t older, const Matrix6& covariance) const {
  const SE3 T_older_newer = views_[older].T_world_camera.inverse() * views_.back().T_world_camera;
  const Matrix6 adjoint = T_older_newer.inverse().adjoint();
  return {T_older_newer, adjoint * covariance * adjoint.transpose()};
}

/// Registers the newest keyframe to an older one from T_older_newer, and adds an edge where the
/// answer is believed.
void KeyframeMap::join(PairVerifier& verifier, std::size_t older, const SE3& T_older_newer,
                       const PairPrior& prior, LoopCandidate& candidate) {
  const auto measurement =
      verifier.verify(*views_[older].cloud, T_older_newer, &prior, usual_cos_theta(), candidate);
  if (!measurement) return;
  optimizer_.add_edge({node_id(candidate.from), node_id(candidate.to), measurement->T_older_newer,
                       edge_information(measurement->T_older_newer, measurement->information),
                       candidate.kind, true});
}

double KeyframeMap::usual_cos_theta() const {
  return odometry_edges_ == 0 ? 0 : sum_of_cos_theta_ / static_cast<double>(odometry_edges_);
}

void KeyframeMap::optimize(OptimizationScope scope) {
  const Summary summary = optimizer_.optimize(scope);
  for (std::size_t i = 0; i < views_.size(); ++i) {
    views_[i].T_world_camera = graph().nodes()[i].T_world_node;
  }
  not_optimized_ = 0;
  if (scope == OptimizationScope::kWindow) {
    ++statistics_.window_solves;
    statistics_.window_seconds += summary.seconds;
  } else {
    ++statistics_.full_solves;
    statistics_.full_seconds += summary.seconds;
    statistics_.last_full = summary;
  }
}

void KeyframeMap::optimize_all() {
  if (is_optimized_) return;
  optimize(OptimizationScope::kFull);
  while (take_back_worst_loop()) {
    update_parts();
    optimize(OptimizationScope::kFull);
  }
  is_optimized_ = true;
}

/// Removes the loop that fits worst, where that is too badly. One at a time: a wrong loop makes
/// right ones fit badly too.
bool KeyframeMap::take_back_worst_loop() {
  const LoopResidual worst = worst_loop(graph());
  if (worst.error <= options_.loops.max_residual) return false;
  const PoseGraphEdge edge = graph().edges()[worst.edge];
  optimizer_.remove_edge(worst.edge);
  take_back(edge, fmt::format("taken back: {:.1f} standard deviations from the optimised graph",
                              worst.error));
  return true;
}

/// Says in the row of an edge that it is no more.
void KeyframeMap::take_back(const PoseGraphEdge& edge, const std::string& reason) {
  for (LoopCandidate& candidate : candidates_) {
    if (!candidate.accepted || candidate.kind != edge.kind ||
        node_id(candidate.from) != edge.from || node_id(candidate.to) != edge.to) {
      continue;
    }
    candidate.accepted = false;
    candidate.reason = reason;
  }
}

}  // namespace cvo_slam
