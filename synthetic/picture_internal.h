// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/synthetic/view_internal.h"

namespace cvo_slam::synthetic {

/// What to record of each pixel.
struct Channels {
  bool color = true;
  bool depth = true;
  bool geometry = false;
  bool reflectance = false;
};

/// What an ideal camera sees; the images that were not asked for are empty.
struct Picture {
  cv::Mat color;        ///< CV_32FC3 (blue, green, red), grey levels, white may exceed 255
  cv::Mat depth;        ///< CV_64FC1, z of the surface at the pixel's centre [m]; 0 = nothing
  cv::Mat surface;      ///< geometry: CV_32SC1, a number for each surface, -1 = nothing
  cv::Mat angle;        ///< geometry: CV_32FC1, between ray and normal [rad]; pi/2 = nothing
  cv::Mat reflectance;  ///< CV_32FC1, share of light, mean of the three colours
};

/// The view that the rays of a row are cast into. Rows are asked for in ascending order; a view
/// must stay until the next but one is asked for.
using ViewOfRow = std::function<const View&(int row)>;

/// The rays through a pixel where surfaces meet.
inline constexpr int kRimRays = 9;

/// Casts a ray through the centre of each pixel, and where colour is asked for kRimRays through
/// those on the rims of surfaces; with `rim_ray` that one of them alone, for a picture that is to
/// be averaged with others.
[[nodiscard]] Picture draw(const PinholeCamera& camera, const ViewOfRow& view_of_row,
                           const Channels& channels, std::optional<int> rim_ray = std::nullopt);

}  // namespace cvo_slam::synthetic
