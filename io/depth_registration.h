// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "cvo_slam/core/camera.h"

namespace cvo_slam {

/// Moves depth images of a depth camera of its own into the colour image.
///
/// Each depth pixel becomes a point, and its footprint in the colour image, a rectangle about the
/// projected point, gets the point's depth in the colour camera; where footprints overlap the
/// nearest wins. Footprints of neighbours touch, so that a surface has no pinholes, and reach no
/// further, so that an edge moves by less than a pixel.
class DepthRegistration {
 public:
  /// `camera.depth` must be set; throws OptionError where it is not or the camera is impossible.
  explicit DepthRegistration(const Camera& camera);

  /// `depth`: CV_16UC1 of the depth camera's size, 0 = none. The result has the colour camera's
  /// size and the same units. May be called from several threads.
  [[nodiscard]] cv::Mat to_color(const cv::Mat& depth) const;

 private:
  [[nodiscard]] Eigen::Vector2f project(const Eigen::Vector3f& point) const;
  /// Lets `depth` fill the rectangle pixel +- half_size where nothing nearer is.
  static void splat(const Eigen::Vector2f& pixel, const Eigen::Vector2f& half_size,
                    std::uint16_t depth, cv::Mat& image);

  PinholeCamera color_;
  int width_ = 0;
  int height_ = 0;
  bool color_is_distorted_ = false;
  Eigen::Vector2f focal_;
  Eigen::Vector2f center_;
  /// Beyond this (x/z)^2 + (y/z)^2 a point is out of the image; Brown's polynomial may fold back.
  float max_radius2_ = 0;
  /// R_color_depth * unproject(pixel) and t_color_depth, in units of the depth image.
  std::vector<Eigen::Vector3f> rays_;
  Eigen::Vector3f translation_;
  /// Half a footprint [px] of a pixel whose depth is the same in both cameras.
  Eigen::Vector2f half_size_;
};

}  // namespace cvo_slam
