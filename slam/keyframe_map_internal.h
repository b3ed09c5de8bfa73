// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "cvo_slam/backend/pose_graph_optimizer.h"
#include "cvo_slam/core/camera.h"
#include "cvo_slam/frontend/registration.h"
#include "cvo_slam/slam/graph_statistics.h"
#include "cvo_slam/slam/keyframe_internal.h"
#include "cvo_slam/slam/loop_candidate.h"
#include "cvo_slam/slam/proximity_internal.h"
#include "cvo_slam/slam/registration_noise_internal.h"
#include "cvo_slam/slam/slam_options.h"

namespace cvo_slam {

/// The keyframes, their clouds, and the graph of what was measured between them. For one thread at
/// a time.
class KeyframeMap {
 public:
  KeyframeMap(const PinholeCamera& camera, const RegistrationOptions& registration, int threads,
              const SlamOptions& options);

  /// Adds a keyframe, registers it to near ones, and now and then optimises the newest part.
  /// Answers the pose that the keyframe has now. Frames must ascend.
  SE3 add(const TrackedKeyframe& keyframe);
  /// Optimises the whole graph, unless nothing was added since that was done.
  void optimize_all();

  [[nodiscard]] const PoseGraph& graph() const { return optimizer_.graph(); }
  [[nodiscard]] const std::vector<LoopCandidate>& candidates() const { return candidates_; }
  [[nodiscard]] const GraphStatistics& statistics() const { return statistics_; }

 private:
  void add_node(const TrackedKeyframe& keyframe);
  void add_edge(const LoopCandidate& candidate, const PairMeasurement& measurement);
  void connect_newest();
  void optimize(OptimizationScope scope);
  [[nodiscard]] double usual_cos_theta() const;

  PinholeCamera camera_;
  SlamOptions options_;
  RegistrationNoise noise_;
  PairVerifier verifier_;
  PoseGraphOptimizer optimizer_;
  std::vector<KeyframeView> views_;  // in the order of the graph's nodes
  std::vector<LoopCandidate> candidates_;
  GraphStatistics statistics_;
  double sum_of_cos_theta_ = 0;  // of the odometry edges
  std::size_t odometry_edges_ = 0;
  int not_optimized_ = 0;  // keyframes since the last optimisation
  bool is_optimized_ = true;
};

}  // namespace cvo_slam
