// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/information.h"
#include "cvo_slam/slam/keyframe_map_internal.h"
#include "cvo_slam/slam/path_uncertainty_internal.h"

namespace cvo_slam {

KeyframeMap::KeyframeMap(const PinholeCamera& camera, const RegistrationOptions& registration,
                         int threads, const SlamOptions& options)
    : camera_(camera),
      options_(options),
      noise_{options.noise_translation, options.noise_rotation},
      verifier_(registration, threads, options.proximity, noise_),
      optimizer_(options.optimizer) {}

SE3 KeyframeMap::add(const TrackedKeyframe& keyframe) {
  add_node(keyframe);
  connect_newest();
  if (++not_optimized_ >= options_.optimize_every) optimize(OptimizationScope::kWindow);
  return graph().nodes().back().T_world_node;
}

void KeyframeMap::add_node(const TrackedKeyframe& keyframe) {
  is_optimized_ = false;
  SE3 T_world_camera = keyframe.T_world_camera;
  if (keyframe.link) {
    const std::size_t reference = graph().index_of(node_id(keyframe.link->reference));
    T_world_camera = (graph().nodes()[reference].T_world_node * keyframe.link->T_reference_keyframe)
                         .normalized();
  }
  views_.push_back({keyframe.frame, keyframe.segment, T_world_camera, keyframe.cloud});
  optimizer_.add_node({node_id(keyframe.frame), T_world_camera});
  if (!keyframe.link) return;
  const KeyframeLink& link = *keyframe.link;
  optimizer_.add_edge(
      {node_id(link.reference), node_id(keyframe.frame), link.T_reference_keyframe,
       edge_information(link.T_reference_keyframe, noise_.added_to(link.information)),
       EdgeKind::kOdometry});
  sum_of_cos_theta_ += link.cos_theta;
  ++odometry_edges_;
}

void KeyframeMap::connect_newest() {
  const auto near = find_near_views(views_, camera_, options_.proximity);
  if (near.empty()) return;
  const KeyframeView& newest = views_.back();
  const auto covariances = path_covariances(graph(), views_.size() - 1);
  verifier_.set_newest(*newest.cloud);
  for (const NearView& view : near) {
    const KeyframeView& older = views_[view.index];
    const auto& covariance = covariances[view.index];
    if (!covariance) continue;
    const SE3 T_older_newer = older.T_world_camera.inverse() * newest.T_world_camera;
    // From a perturbation of the older one as seen from the newest to one of the newest.
    const Matrix6 adjoint = T_older_newer.inverse().adjoint();
    const PairPrior prior{T_older_newer, adjoint * *covariance * adjoint.transpose()};
    LoopCandidate candidate;
    candidate.from = older.frame;
    candidate.to = newest.frame;
    candidate.expected_overlap = view.expected_overlap;
    const auto measurement = verifier_.verify(*older.cloud, prior, usual_cos_theta(), candidate);
    if (measurement) add_edge(candidate, *measurement);
    candidates_.push_back(candidate);
  }
}

void KeyframeMap::add_edge(const LoopCandidate& candidate, const PairMeasurement& measurement) {
  optimizer_.add_edge({node_id(candidate.from), node_id(candidate.to), measurement.T_older_newer,
                       edge_information(measurement.T_older_newer, measurement.information),
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
  is_optimized_ = true;
}

}  // namespace cvo_slam
