// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cvo_slam/core/se3.h"

namespace cvo_slam::synthetic {

/// Where the camera is drawn to, and what it looks at, both in the world [m].
struct Viewpoint {
  Vector3 position;
  Vector3 target;
};

/// The unrest of a hand: sinusoids from 0.5 to 4 Hz whose amplitude falls with their frequency.
struct Tremor {
  double translation = 0.003;  ///< amplitude of each axis at 1 Hz [m]
  double rotation = 0.006;     ///< amplitude of each axis at 1 Hz [rad]
  std::uint32_t seed = 0;
};

/// The plan of a camera's way.
struct PathPlan {
  std::vector<Viewpoint> viewpoints = {};  ///< at equal distances in time
  double duration = 10;                    ///< of one round, or of the way from end to end [s]
  bool closed = true;                      ///< after the last viewpoint comes the first again
  Tremor tremor = {};
  double speed = 1;  ///< 2 = everything happens twice as fast, in half the duration
};

/// A smooth path of a camera: uniform cubic B-splines through the neighbourhood of the viewpoints,
/// for the position and for the target, plus tremor. Position and orientation are continuous to the
/// second derivative, and so at the seam of a closed path. An open one starts and ends at rest
/// exactly at its first and last viewpoint (tremor aside).
class CameraPath {
 public:
  /// Throws OptionError with fewer than four viewpoints (the order of the spline), with one that
  /// has its target above, below or at its position, or with a duration or speed that is not
  /// positive.
  explicit CameraPath(PathPlan plan);

  /// Of one round, or from end to end, at the plan's speed [s].
  [[nodiscard]] double duration() const { return plan_.duration / plan_.speed; }
  /// The exact pose. After its duration a closed path repeats, and an open one stays.
  [[nodiscard]] SE3 T_world_camera(double seconds) const;
  [[nodiscard]] const PathPlan& plan() const { return plan_; }

 private:
  struct Wave {
    double rounds;     ///< whole periods in a duration, so that a loop closes
    double amplitude;  ///< [m] or [rad]
    double phase;      ///< [rad]
  };

  [[nodiscard]] Viewpoint viewpoint(double share) const;
  [[nodiscard]] Vector6 tremor(double share) const;

  PathPlan plan_;
  std::vector<Viewpoint>
      controls_;  // of the spline; the first of a closed one stand again at the end
  std::array<std::array<Wave, 4>, 6> waves_{};  // of [translation; rotation]
};

/// The pose of a camera at `position` that looks at `target` with the image upright; the two must
/// not lie above each other. Axes: x right, y down, z forward; the world's z is up.
[[nodiscard]] SE3 look_at(const Vector3& position, const Vector3& target);

}  // namespace cvo_slam::synthetic
