// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "cvo_slam/synthetic/camera_path.h"
#include "cvo_slam/synthetic/scene.h"

namespace cvo_slam::synthetic {

/// The camera must not come nearer to a surface [m].
inline constexpr double kNearestSurface = 0.05;

struct Collision {
  double seconds = 0;
  std::size_t primitive = 0;
};

/// The first time at which the camera is too near to a surface.
[[nodiscard]] std::optional<Collision> first_collision(const Scene& scene, const CameraPath& path);

}  // namespace cvo_slam::synthetic
