// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cvo_slam/backend/pose_graph_optimizer.h"
#include "cvo_slam/core/camera.h"
#include "cvo_slam/frontend/registration.h"
#include "cvo_slam/loop/loop_detector.h"
#include "cvo_slam/slam/graph_statistics.h"
#include "cvo_slam/slam/keyframe_internal.h"
#include "cvo_slam/slam/loop_candidate.h"
#include "cvo_slam/slam/part_links_internal.h"
#include "cvo_slam/slam/proximity_internal.h"
#include "cvo_slam/slam/registration_noise_internal.h"
#include "cvo_slam/slam/slam_options.h"

namespace cvo_slam {

/// The row of a place that was recognised, without a verdict.
[[nodiscard]] LoopCandidate candidate_of(const LoopMatch& match);

/// The keyframes, their clouds, and the graph of what was measured between them. For one thread at
/// a time.
class KeyframeMap {
 public:
  /// Without a vocabulary, with the built-in one, where loops are looked for.
  KeyframeMap(const Camera& camera, const RegistrationOptions& registration, int threads,
              const SlamOptions& options, const std::shared_ptr<const Vocabulary>& vocabulary = {});

  /// Adds a keyframe, registers it to near ones and to those that show the same place, and now and
  /// then optimises the newest part, or all where a loop was closed. Answers the pose that the
  /// keyframe has now. Frames must ascend.
  SE3 add(const TrackedKeyframe& keyframe);
  /// Which keyframe shows the place of a frame that tracking has lost, by its image and its points;
  /// none where that is not sure enough, or where loops are not looked for.
  [[nodiscard]] std::optional<FoundPlace> relocalize(const RgbdFrame& image,
                                                     const PointCloud& cloud);
  /// Optimises the whole graph, and takes back loops that do not fit, unless nothing was added
  /// since that was done.
  void optimize_all();

  /// A name for all segments that the graph connects with this one, and whose poses are of one
  /// world: the first of them.
  [[nodiscard]] int part_of(int segment) const;
  [[nodiscard]] const PoseGraph& graph() const { return optimizer_.graph(); }
  [[nodiscard]] const std::vector<LoopCandidate>& candidates() const { return candidates_; }
  [[nodiscard]] const GraphStatistics& statistics() const { return statistics_; }

 private:
  /// What it takes to close a loop.
  struct LoopCloser {
    LoopDetector detector;
    PairVerifier verifier;
  };
  using Covariances = std::vector<std::optional<Matrix6>>;  // of each as seen from the newest

  void add_node(const TrackedKeyframe& keyframe);
  void join_near_views(const Covariances& covariances);
  void add_place(const KeyframeLink& place, std::size_t frame);
  bool close_loops(const RgbdFrame& image, const Covariances& covariances);
  void close_loop(const std::vector<LoopMatch>& matches, std::size_t index,
                  const Covariances& covariances, LoopCandidate& candidate);
  // Where the graph cannot say whether a place is likely (keyframe_map_parts.cc).
  [[nodiscard]] SE3 after_gap(const TrackedKeyframe& keyframe);
  [[nodiscard]] std::optional<PairPrior> prior_of_lost(std::size_t older,
                                                       const Timestamp& now) const;
  [[nodiscard]] bool is_likely(const LoopMatch& match, const Timestamp& now) const;
  [[nodiscard]] std::string find_doubt(const std::vector<LoopMatch>& matches,
                                       std::size_t index) const;
  [[nodiscard]] std::string find_strangeness(const LoopMatch& match, double cos_theta,
                                             const Timestamp& now) const;
  [[nodiscard]] std::string find_rival_reason(const std::vector<LoopMatch>& matches,
                                              std::size_t index) const;
  [[nodiscard]] const LoopMatch* find_rival(const std::vector<LoopMatch>& matches,
                                            std::size_t index) const;
  [[nodiscard]] std::optional<KeyframeLink> register_lost(const LoopMatch& match,
                                                          const Timestamp& now,
                                                          LoopCandidate& candidate);
  void link_part(const LoopMatch& match, LoopCandidate& candidate);
  bool join_parts();
  void add_part_link(const PartLink& link);
  void move_part(int part, const SE3& T_new_old);
  void update_parts();
  // keyframe_map_contradictions.cc
  void keep_contradiction(const std::vector<LoopMatch>& matches, std::size_t index);
  [[nodiscard]] bool leads_out_of(const PoseGraphEdge& edge, int segment) const;
  void take_back_joins();
  [[nodiscard]] PairPrior prior_of(std::size_t older, const Matrix6& covariance) const;
  void join(PairVerifier& verifier, std::size_t older, const SE3& T_older_newer,
            const PairPrior& prior, LoopCandidate& candidate);
  bool take_back_worst_loop();
  void take_back(const PoseGraphEdge& edge, const std::string& reason);
  void optimize(OptimizationScope scope);
  [[nodiscard]] double usual_cos_theta() const;

  Camera camera_;
  SlamOptions options_;
  RegistrationNoise noise_;
  PairVerifier near_verifier_;
  std::optional<LoopCloser> loop_closer_;
  PoseGraphOptimizer optimizer_;
  std::vector<KeyframeView> views_;  // in the order of the graph's nodes
  std::vector<LoopCandidate> candidates_;
  std::vector<PartLink> part_links_;      // that did not join parts yet
  std::vector<PartLink> contradictions_;  // that the graph does not believe
  std::vector<PoseGraphEdge> gaps_;       // from the last of a segment to the first of the next
  SE3 T_world_newest_tracked_;            // the tracker's world
  GraphStatistics statistics_;
  double sum_of_cos_theta_ = 0;  // of the odometry edges
  std::size_t odometry_edges_ = 0;
  int not_optimized_ = 0;  // keyframes since the last optimisation
  bool is_optimized_ = true;
};

}  // namespace cvo_slam
