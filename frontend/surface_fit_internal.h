// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <opencv2/core.hpp>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/point_cloud.h"

namespace cvo_slam {

/// Fits planes to the depths around pixels of a depth image.
class SurfaceFit {
 public:
  /// `rays` holds x/z and y/z of each pixel. Depths that differ by more than max_depth_step, a
  /// share of the depth, belong to another surface. All arguments must outlive the object.
  SurfaceFit(const cv::Mat& depth, const Camera& camera, const std::vector<float>& rays,
             double max_depth_step);

  struct Plane {
    Vector3 normal;    ///< unit vector in the depth image's frame
    double depth_rms;  ///< standard deviation of the depths from the plane, along the rays [m]
  };
  /// Returns the plane around a pixel that has a depth; empty if too many depths are missing or
  /// belong to another surface. 1/z of a plane is linear in the ray (x/z, y/z).
  [[nodiscard]] std::optional<Plane> at(const cv::Point& pixel) const;

 private:
  const cv::Mat& depth_;
  const std::vector<float>& rays_;
  double metres_;  // a unit of the depth image
  double max_depth_step_;
  int step_;  // distance of neighbouring samples [px]
};

/// Sets the cloud's surface_noise and, where the depth is so clean that surfaces help, its
/// surfaces; ray_noise shrinks with the noise seen, if that is less than the camera's noise model
/// predicts. `pixels` are those that the depths of the points were taken from, T_color_depth the
/// motion between the images.
void fit_surfaces(const SurfaceFit& fit, const std::vector<cv::Point>& pixels,
                  const SE3& T_color_depth, const SensorNoise& noise, PointCloud& cloud);

}  // namespace cvo_slam
