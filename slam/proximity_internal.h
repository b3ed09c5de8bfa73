// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/core/timestamp.h"
#include "cvo_slam/frontend/registration.h"
#include "cvo_slam/slam/loop_candidate.h"
#include "cvo_slam/slam/registration_noise_internal.h"
#include "cvo_slam/slam/slam_options.h"

namespace cvo_slam {

/// A keyframe as the search for near ones sees it.
struct KeyframeView {
  std::size_t frame = 0;
  int segment = 0;
  int part = 0;  ///< the first segment among those that the graph connects with this one
  SE3 T_world_camera;
  std::shared_ptr<const PointCloud> cloud;
  Timestamp stamp;
};

/// An earlier keyframe to register the newest one to.
struct NearView {
  std::size_t index = 0;  ///< in the list of views
  double expected_overlap = 0;
};

/// Those of the views before the last one that the last one shall be registered to: the most recent
/// ones but its predecessor, and the older ones that see most of the same, spread over the
/// sequence.
[[nodiscard]] std::vector<NearView> find_near_views(const std::vector<KeyframeView>& views,
                                                    const PinholeCamera& camera,
                                                    const ProximityOptions& options);

/// What the graph knows of a pair.
struct PairPrior {
  SE3 T_older_newer;
  Matrix6 covariance = Matrix6::Zero();  ///< of a right perturbation
};

struct PairMeasurement {
  SE3 T_older_newer;
  Matrix6 information = Matrix6::Identity();  ///< of a right perturbation
};

/// Registers the newest keyframe to earlier ones, and judges the answers.
class PairVerifier {
 public:
  PairVerifier(const RegistrationOptions& registration, int threads, const PairOptions& options,
               const RegistrationNoise& noise);

  void set_newest(const PointCloud& cloud);
  /// The measurement, searched for from T_older_newer, where it is believed; `candidate` gets all
  /// figures and the verdict. `usual_cos_theta` is that of registrations that are known to be good.
  /// Null where the graph does not know the pair.
  [[nodiscard]] std::optional<PairMeasurement> verify(const PointCloud& older,
                                                      const SE3& T_older_newer,
                                                      const PairPrior* prior,
                                                      double usual_cos_theta,
                                                      LoopCandidate& candidate);

 private:
  PairOptions options_;
  RegistrationNoise noise_;
  Registration to_newest_;
  Registration to_older_;
  PointCloud newest_;  // the first points
};

}  // namespace cvo_slam
