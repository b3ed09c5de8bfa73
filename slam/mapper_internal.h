// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/map.h"
#include "cvo_slam/slam/culling_internal.h"
#include "cvo_slam/slam/localization_internal.h"
#include "cvo_slam/slam/loop_candidate.h"
#include "cvo_slam/slam/loop_closing_internal.h"
#include "cvo_slam/slam/map_state_internal.h"
#include "cvo_slam/slam/proximity_internal.h"
#include "cvo_slam/slam/relocalization_internal.h"
#include "cvo_slam/slam/slam_options.h"

namespace cvo_slam {

/// A registration of a keyframe to the one that it was tracked against.
struct OdometryMeasurement {
  std::size_t reference = 0;  ///< number of the other keyframe
  SE3 T_reference_keyframe;
  Matrix6 covariance = Matrix6::Identity();  ///< of a right perturbation
  double cos_theta = 0;
};

/// A new keyframe as the tracker hands it over.
struct KeyframeInput {
  std::size_t number = 0;  ///< the index of its frame; keyframes come in ascending order
  Timestamp stamp;
  int tracked_submap = 0;
  SE3 T_world_camera;  ///< as it was tracked
  std::shared_ptr<const PointCloud> cloud;
  std::optional<OdometryMeasurement> odometry;  ///< none for the first keyframe of a submap
  std::optional<RecognizedPose> recognized;  ///< where relocalisation found the first of a submap
  std::optional<RgbdFrame> images;           ///< only needed where keyframes are recognised
};

/// Builds the map: keyframes, and the graph of what was measured between them. For one thread at a
/// time.
class Mapper {
 public:
  /// Uses the built-in vocabulary if loops are closed and `vocabulary` is null.
  Mapper(const Camera& camera, const SlamOptions& options,
         const std::shared_ptr<const Vocabulary>& vocabulary = nullptr);

  /// Adds a keyframe, connects it with others, and optimises: the newest part of the graph now and
  /// then, all of it when a loop was closed. Returns where the map has the keyframe then.
  CorrectedPose add(const KeyframeInput& keyframe);
  /// Finds where a lost image was taken, by its points too; none if that is not certain enough or
  /// loops are not closed. Adds a row for each keyframe that was tried.
  [[nodiscard]] std::optional<RecognizedPose> relocalize(const RgbdFrame& images,
                                                         const PointCloud& cloud);
  /// The features and words of the last images, for several threads; null if loops are not closed.
  [[nodiscard]] AppearanceCache* appearances() {
    return loop_closing_ ? &loop_closing_->appearances() : nullptr;
  }
  /// Takes over the keyframes and edges of another map, before any of its own. Throws DataError if
  /// its parts do not belong together.
  void restore(const Map& map);
  /// Writes all that later keyframes depend on besides to_map(), or takes it over together with
  /// that map, before any keyframe. Throws DataError if the two do not belong together.
  void exchange(SavedState& state, const Map& map);
  /// Returns the map as a value.
  [[nodiscard]] Map to_map() const;
  /// Registers a camera's points to the keyframe that sees most of the same, and leaves the map as
  /// it is. None if that is not certain enough.
  [[nodiscard]] std::optional<SE3> locate(const PointCloud& cloud, const PredictedPose& predicted);

  /// Optimises the whole graph and takes back the loops that it contradicts, unless nothing was
  /// added since that was done.
  void optimize_all();
  /// Returns the positions of the keyframes that were moved since the last call, ascending.
  [[nodiscard]] std::set<std::size_t> take_moved() { return std::exchange(moved_, {}); }

  [[nodiscard]] const MapState& map() const { return map_; }
  [[nodiscard]] const PoseGraph& graph() const { return map_.graph.graph(); }
  /// Every pair that was tried, with its verdict.
  [[nodiscard]] const std::vector<LoopCandidate>& candidates() const { return candidates_; }
  [[nodiscard]] GraphStatistics statistics() const;

 private:
  void add_keyframe(const KeyframeInput& keyframe);
  void index_keyframes();
  [[nodiscard]] SE3 start_after_gap(const KeyframeInput& keyframe);
  void connect_near_keyframes(PathSearch& paths);
  bool close_loops(const KeyframeInput& keyframe, PathSearch& paths);
  void separate_submaps();
  bool join_submaps();
  void settle_links();
  void cull_keyframes();
  [[nodiscard]] std::size_t keyframe_bytes() const;
  void remove_keyframe(const Removal& removal);
  void add_edge(EdgeKind kind, std::size_t older, std::size_t newer,
                const PairMeasurement& measurement, std::optional<std::size_t> row);
  void accept(std::size_t row);
  void drop_matches(LoopCandidate& row) const;
  void take_back(std::size_t edge, const std::string& reason);
  void optimize(OptimizationScope scope);

  Camera camera_;
  FieldOfView field_of_view_;
  SlamOptions options_;
  RegistrationNoise noise_;
  PairRegistration near_registration_;
  std::optional<LoopClosing> loop_closing_;
  std::optional<Localizer> localizer_;  // made where it is needed
  MapState map_;
  ProximityIndex proximity_;
  std::vector<LoopCandidate> candidates_;
  GraphStatistics statistics_;
  std::set<std::size_t> moved_;  // positions, since take_moved()
  SE3 T_world_newest_tracked_;   // the newest keyframe's pose as it was tracked
  int keyframes_since_solve_ = 0;
  std::size_t next_checked_ = 0;  // position of the keyframe that culling looks at next
  bool is_fully_optimized_ = true;
};

}  // namespace cvo_slam
