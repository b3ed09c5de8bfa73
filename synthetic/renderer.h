// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/synthetic/scene.h"

namespace cvo_slam::synthetic {

/// What an ideal camera sees, before any sensor rounds it.
struct Rendering {
  cv::Mat color;  ///< CV_32FC3 (blue, green, red), grey levels in [0, 255]
  cv::Mat depth;  ///< CV_64FC1, z of the surface at the pixel's centre [m]; 0 where nothing is hit
};

/// Casts a ray through the centre of each pixel. Depth is exact to rounding; colour is averaged
/// over the pixel: textures in closed form, the rims of surfaces by supersampling.
/// Throws OptionError for a camera with distortion, which a synthetic camera does not need.
[[nodiscard]] Rendering render(const Scene& scene, const PinholeCamera& camera,
                               const SE3& T_world_camera);

}  // namespace cvo_slam::synthetic
