// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cvo_slam/core/se3.h"

/// Sequences with exact ground truth, by ray casting.
namespace cvo_slam::synthetic {

/// A position that the camera passes near, and the point that it looks at, in the world [m].
struct Viewpoint {
  Vector3 position;  ///< of the camera
  Vector3 target;    ///< the point that it looks at
};

/// The tremor of a hand: sinusoids from 0.5 to 4 Hz whose amplitude falls with their frequency.
struct Tremor {
  double translation = 0.003;  ///< amplitude of each axis at 1 Hz [m]
  double rotation = 0.006;     ///< amplitude of each axis at 1 Hz [rad]
  std::uint32_t seed = 0;      ///< seed of frequencies and phases
};

/// The plan of a camera path.
struct PathPlan {
  std::vector<Viewpoint> viewpoints = {};  ///< at equal distances in time
  double duration = 10;                    ///< duration of one round, or from end to end [s]
  bool closed = true;                      ///< true if the path returns to the first viewpoint
  Tremor tremor = {};                      ///< added to the smooth path
  double speed = 1;                        ///< 2 = twice as fast, in half the duration
};

/// Longest duration of a path [s]; more would be millions of frames.
inline constexpr double kLongestPath = 86400;

/// A smooth path of a camera: uniform cubic B-splines that pass near the viewpoints, one for the
/// position and one for the target, plus tremor. Position and orientation are continuous to the
/// second derivative, also at the seam of a closed path. An open path starts and ends at rest,
/// exactly at its first and last viewpoint (except for tremor).
class CameraPath {
 public:
  /// Throws OptionError for fewer than four viewpoints (the order of the spline), for a target that
  /// is above, below or at its position, for a duration or speed that is not positive, and for a
  /// path that takes more than a day.
  explicit CameraPath(PathPlan plan);

  /// Returns the duration of one round, or from end to end, at the plan's speed [s].
  [[nodiscard]] double duration() const { return plan_.duration / plan_.speed; }
  /// Returns the exact pose. After its duration a closed path repeats, and an open one stays at its
  /// end.
  [[nodiscard]] SE3 T_world_camera(double seconds) const;
  /// Returns what the constructor was given.
  [[nodiscard]] const PathPlan& plan() const { return plan_; }

 private:
  struct Wave {
    double rounds;     ///< number of whole periods in the duration, so that a closed path closes
    double amplitude;  ///< [m] or [rad]
    double phase;      ///< [rad]
  };

  [[nodiscard]] Viewpoint viewpoint(double share) const;
  [[nodiscard]] Vector6 tremor(double share) const;

  PathPlan plan_;
  // Control points of the spline; those of a closed path repeat the first ones at the end.
  std::vector<Viewpoint> controls_;
  std::array<std::array<Wave, 4>, 6> waves_{};  // tremor of [translation; rotation]
};

/// Returns the pose of a camera at `position` that looks at `target` with the image upright. One
/// must not be above the other. Axes of the camera: x right, y down, z forward; z of the world is
/// up.
[[nodiscard]] SE3 look_at(const Vector3& position, const Vector3& target);

}  // namespace cvo_slam::synthetic
