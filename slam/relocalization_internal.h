// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/saved_state.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/core/timestamp.h"
#include "cvo_slam/slam/loop_candidate.h"
#include "cvo_slam/slam/loop_closing_internal.h"

namespace cvo_slam {

/// Where one image says that a lost camera is.
struct RecognizedPose {
  std::size_t keyframe = 0;  ///< number of the keyframe it was registered to
  PairMeasurement measurement;
  SE3 T_world_camera;
  int submap = 0;  ///< name of the keyframe's submap, whose world the pose is of
  /// Index of its row: in Relocalization::rows; in what Mapper::relocalize() returns, in
  /// Mapper::candidates().
  std::size_t row = 0;

  void exchange(SavedState& state) { state(keyframe, measurement, T_world_camera, submap, row); }
};

/// What the map says of a lost image.
struct Relocalization {
  std::optional<RecognizedPose> pose;  ///< none if that is not certain enough
  std::vector<LoopCandidate> rows;     ///< one for each keyframe that the image seems to show
};

/// Looks for a lost image, with its points, among all keyframes.
[[nodiscard]] Relocalization relocalize(const RgbdFrame& images, const PointCloud& cloud,
                                        const MapState& map, LoopClosing& loop_closing);

/// Decides when enough lost frames agree on where the camera is: one alone may show an ambiguous
/// place.
class PoseConsensus {
 public:
  /// `frames` must agree, on a path that a camera of no more than these speeds [m/s, rad/s] can
  /// take, and be of at least 0.06 s.
  PoseConsensus(int frames, double max_speed, double max_angular_speed);

  /// Adds the pose of a frame, `period` seconds after the frame before, and forgets earlier ones
  /// that disagree with it or are too old: of more than half a second ago and, where few frames
  /// come a second, of more than one frame more than must agree, of at most a second each.
  /// Returns true if enough agree.
  bool add(const Timestamp& stamp, double period, const RecognizedPose& pose);
  void clear() { observations_.clear(); }
  /// Number of frames that agree now.
  [[nodiscard]] int count() const { return static_cast<int>(observations_.size()); }
  void exchange(SavedState& state) { state(observations_); }

 private:
  struct Observation {
    Timestamp stamp;
    int submap = 0;
    SE3 T_world_camera;

    void exchange(SavedState& state) { state(stamp, submap, T_world_camera); }
  };
  [[nodiscard]] bool agree(const Observation& a, const Observation& b, double longest) const;

  int frames_;
  double max_speed_;
  double max_angular_speed_;
  std::vector<Observation> observations_;
};

}  // namespace cvo_slam
