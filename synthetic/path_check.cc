// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/synthetic/path_check_internal.h"
#include "cvo_slam/synthetic/world.h"

namespace cvo_slam::synthetic {

std::optional<Collision> first_collision(const Scene& scene, const CameraPath& path) {
  // What is `free` away cannot be reached before the camera has moved as far: most of a path is
  // passed in few steps, and thin sheets are not jumped over.
  constexpr double kStep = 0.01;  // [s]
  const auto steps = static_cast<long>(path.duration() / kStep) + 1;
  double free = 0;
  Vector3 measured_at = Vector3::Zero();
  for (long i = 0; i < steps; ++i) {
    const double seconds = static_cast<double>(i) * kStep;
    const Vector3 position = path.T_world_camera(seconds).translation();
    if ((position - measured_at).norm() + kNearestSurface < free) continue;
    const Nearest found = nearest(scene, position);
    if (found.distance < kNearestSurface) return Collision{seconds, found.primitive};
    free = found.distance;
    measured_at = position;
  }
  return std::nullopt;
}

void check_path(const Scene& scene, const CameraPath& path) {
  const auto collision = first_collision(scene, path);
  if (!collision) return;
  throw OptionError(fmt::format(
      "camera path: after {:.2f} s the camera is inside or nearer than {} m to primitive "
      "{} of the scene; use another path or speed",
      collision->seconds, kNearestSurface, collision->primitive));
}

}  // namespace cvo_slam::synthetic
