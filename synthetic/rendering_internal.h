// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <optional>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/synthetic/ray_caster_internal.h"

namespace cvo_slam::synthetic {

/// The images to record.
struct Channels {
  bool color = true;
  bool depth = true;
  bool geometry = false;
  bool reflectance = false;
};

/// The images of an ideal camera, with what a sensor model needs. Those that Channels does not ask
/// for are empty.
struct IdealImages {
  cv::Mat color;        ///< CV_32FC3 (blue, green, red), grey levels; white may exceed 255
  cv::Mat depth;        ///< CV_64FC1, z of the surface at the pixel's centre [m]; 0 = no surface
  cv::Mat surface;      ///< geometry: CV_32SC1, a number for each surface; -1 = no surface
  cv::Mat angle;        ///< geometry: CV_32FC1, between ray and normal [rad]; pi/2 = no surface
  cv::Mat reflectance;  ///< CV_32FC1, mean of the three channels
};

/// A camera that moves through a scene in which shapes may move. Refers to all of them.
struct Motion {
  const WorldScene& scene;
  const PinholeCamera& camera;
  const std::function<SE3(double seconds)>& T_world_camera;
};

/// The ray casters of the rows of an image under a rolling shutter. The middle of the image is seen
/// at `seconds`, its last row `readout` [s] after the first.
class RowRays {
 public:
  RowRays(const Motion& motion, double seconds, double readout);
  /// Returns the ray caster of a row. It is valid until the next but one row is asked for.
  [[nodiscard]] const RayCaster& of_row(int y);
  /// Returns the time at which a row is seen [s].
  [[nodiscard]] double seconds_of_row(int y) const;

 private:
  /// A scene at an instant and the ray caster that refers to it.
  struct Snapshot {
    Snapshot(const Motion& motion, bool moves, double seconds, const RowRange& rows);
    Snapshot(const Snapshot&) = delete;  // the ray caster refers to the scene beside it
    Snapshot& operator=(const Snapshot&) = delete;

    std::optional<WorldScene> moved;
    RayCaster rays;
  };

  Motion motion_;
  double seconds_;
  double readout_;
  bool moves_;  ///< true if a shape of the scene moves
  std::array<std::optional<Snapshot>, 2> snapshots_;
};

/// Returns the ray caster of a row. Rows are asked for in ascending order; a ray caster must stay
/// valid until the next but one is asked for.
using RaysOfRow = std::function<const RayCaster&(int row)>;

/// Number of rays through a pixel at which surfaces meet.
inline constexpr int kRimRays = 9;

/// Casts a ray through the centre of each pixel. If colour is asked for, it casts kRimRays rays
/// through pixels on the rims of surfaces. With `rim_ray`, it casts only that one of them, for an
/// image that will be averaged with others.
[[nodiscard]] IdealImages cast_image(const PinholeCamera& camera, const RaysOfRow& rays_of_row,
                                     const Channels& channels,
                                     std::optional<int> rim_ray = std::nullopt);

}  // namespace cvo_slam::synthetic
