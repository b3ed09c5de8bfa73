// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/frontend/registration.h"
#include "cvo_slam/slam/map_state_internal.h"
#include "cvo_slam/slam/pair_registration_internal.h"
#include "cvo_slam/slam/proximity_internal.h"

namespace cvo_slam {

/// Where a camera is thought to be in a map before it is registered there.
struct PredictedPose {
  SE3 T_world_camera;
  int submap = 0;          ///< in whose world
  double path_length = 0;  ///< of the camera since its place in the map was measured [m]
};

/// Locates a camera in a map by registering its points to the keyframe that sees most of the same.
/// As its tracker has brought it there, it is nearly known where it is: less overlap is enough than
/// an edge of the graph needs, and a smaller difference from what is expected is allowed.
class Localizer {
 public:
  Localizer(const Camera& camera, const RegistrationOptions& registration, int threads,
            const RegistrationNoise& noise);

  /// None if no keyframe sees enough of the same, or if no registration is believed.
  [[nodiscard]] std::optional<SE3> locate(const PointCloud& cloud, const PredictedPose& predicted,
                                          const MapState& map, const ProximityIndex& index);

 private:
  FieldOfView field_of_view_;
  PairRegistration registration_;
};

}  // namespace cvo_slam
