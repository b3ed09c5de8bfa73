// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/core/camera.h"

namespace cvo_slam {

/// Moves depth images of a depth camera of its own into the colour image.
///
/// Each depth pixel becomes a point, and its footprint in the colour image, a rectangle about the
/// projected point, gets the point's depth in the colour camera; where footprints overlap the
/// nearest wins. Footprints of neighbours overlap a little, so that a surface has no pinholes, and
/// reach no further, so that an edge moves by less than a pixel.
class DepthRegistration {
 public:
  /// `camera.depth` must be set; throws OptionError where it is not or the camera is impossible.
  explicit DepthRegistration(const Camera& camera);

  /// `depth`: CV_16UC1 of the depth camera's size, 0 = none. The result has the colour camera's
  /// size and the same units. Throws Error for an image of another size or type. May be called from
  /// several threads.
  [[nodiscard]] cv::Mat to_color(const cv::Mat& depth) const;

 private:
  /// The pixels of one row of the depth image, seen by the colour camera.
  struct ProjectedRow {
    explicit ProjectedRow(std::size_t width) : u(width), v(width), z(width), scale(width) {}
    std::vector<float> u, v;   ///< [px]
    std::vector<float> z;      ///< in units of the depth image; 0 = none or out of sight
    std::vector<float> scale;  ///< depth in the depth camera / z
  };
  void project_row(const std::uint16_t* depth, int v, ProjectedRow& row) const;
  void splat_row(const ProjectedRow& row, cv::Mat& image) const;

  PinholeCamera color_;
  int width_ = 0;
  int height_ = 0;
  /// R_color_depth * unproject(pixel) of each pixel, and t_color_depth in units of the depth image.
  std::vector<float> ray_x_, ray_y_, ray_z_;
  std::array<float, 3> translation_{};
  /// Half a footprint [px] of a point whose depth is the same in both cameras.
  float half_u_ = 0;
  float half_v_ = 0;
  /// Beyond this (x/z)^2 + (y/z)^2 a point is out of the image; Brown's polynomial may fold back.
  float max_radius2_ = 0;
};

}  // namespace cvo_slam
