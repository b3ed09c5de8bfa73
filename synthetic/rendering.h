// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/synthetic/world_scene.h"

namespace cvo_slam::synthetic {

/// The images of an ideal camera, before a sensor rounds them.
struct Rendering {
  cv::Mat color;  ///< CV_32FC3 (blue, green, red), grey levels in [0, 255]
  cv::Mat depth;  ///< CV_64FC1, z of the surface at the pixel's centre [m]; 0 = no surface
};

/// Renders a scene by one ray through the centre of each pixel. Depth is exact to rounding. Colour
/// is averaged over the pixel: textures in closed form, the rims of surfaces by supersampling.
/// Throws OptionError for a camera with distortion.
[[nodiscard]] Rendering render(const WorldScene& scene, const PinholeCamera& camera,
                               const SE3& T_world_camera);

}  // namespace cvo_slam::synthetic
