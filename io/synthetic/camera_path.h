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

/// A smooth closed path of a camera: uniform cubic B-splines through the neighbourhood of the
/// viewpoints, for the position and for the target, plus tremor. Position and orientation are
/// continuous to the second derivative, and so at the seam of the loop.
class CameraPath {
 public:
  /// `duration` of one round [s]. Throws OptionError with fewer than four viewpoints (the order of
  /// the spline) or a duration that is not positive.
  CameraPath(std::vector<Viewpoint> viewpoints, double duration, const Tremor& tremor);

  [[nodiscard]] double duration() const { return duration_; }
  /// The exact pose; beyond one round the path repeats.
  [[nodiscard]] SE3 T_world_camera(double seconds) const;

 private:
  struct Wave {
    double rounds;     ///< whole periods in a duration, so that the loop closes
    double amplitude;  ///< [m] or [rad]
    double phase;      ///< [rad]
  };

  [[nodiscard]] Viewpoint viewpoint(double seconds) const;
  [[nodiscard]] Vector6 tremor(double seconds) const;

  std::vector<Viewpoint> viewpoints_;
  double duration_;
  std::array<std::array<Wave, 4>, 6> waves_{};  // of [translation; rotation]
};

/// The pose of a camera at `position` that looks at `target` with the image upright; the two must
/// not lie above each other. Axes: x right, y down, z forward; the world's z is up.
[[nodiscard]] SE3 look_at(const Vector3& position, const Vector3& target);

}  // namespace cvo_slam::synthetic
