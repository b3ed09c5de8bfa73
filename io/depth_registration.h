// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/rgbd_frame.h"

namespace cvo_slam {

/// Registers depth images of a separate depth camera to the colour image, as the tracker needs
/// them. The readers of data sets do it where `Camera::depth` is set; callers who grab their own
/// images do
///
///     const Camera camera = read_camera("camera.yaml");  // with the key `depth`
///     const DepthRegistration registration(camera);
///     while (grab(color, depth)) {
///       RgbdFrame frame;
///       frame.stamp = frame.depth_stamp = stamp;
///       frame.color = color;
///       frame.depth = registration.register_depth(depth);
///       slam.track(frame);
///     }
///
/// Colour images stay as they are, and so does their lens distortion: the tracker knows it from
/// `Camera::color`, and registered depth has the same distortion as the colour image.
///
/// Each depth pixel becomes a 3D point. Its footprint in the colour image, a rectangle around the
/// projected point, gets the depth of the point in the colour camera; where footprints overlap, the
/// nearest point counts. Footprints of neighbours overlap a little, so that a surface has no holes,
/// but reach less than a pixel beyond an edge.
class DepthRegistration {
 public:
  /// Throws OptionError if `camera.depth` is not set or a value of the camera is impossible.
  explicit DepthRegistration(const Camera& camera);

  /// Returns an image of the colour camera's size in the units of `depth`, a CV_16UC1 image of the
  /// depth camera's size; 0 means "no measurement" in both. Throws Error if `depth` has another
  /// size or type. May be called from several threads.
  [[nodiscard]] cv::Mat register_depth(const cv::Mat& depth) const;

 private:
  struct ProjectedRow;
  struct Footprints;
  void project_row(const std::uint16_t* depth, int depth_row, ProjectedRow& row) const;
  void find_footprints(const ProjectedRow& row, Footprints& footprints) const;
  static void fill(const Footprints& footprints, cv::Mat& image);

  PinholeCamera color_;
  int width_ = 0;
  int height_ = 0;
  std::vector<float> ray_x_, ray_y_, ray_z_;  ///< R_color_depth * unproject(pixel) of each pixel
  std::array<float, 3> translation_{};        ///< t_color_depth in units of the depth image
  /// Half the size of the footprint of a point whose depth is the same in both cameras [px].
  float half_u_ = 0;
  float half_v_ = 0;
  /// A point with a larger (x/z)^2 + (y/z)^2 is outside the image, whatever Brown's polynomial,
  /// which may fold back there, says.
  float max_radius2_ = 0;
};

/// Reads a frame from two image files that belong to no data set; depth is registered to colour if
/// `camera.depth` is set. The stamps of the frame are 0. Throws InputError if a file is missing or
/// broken, or if the depth image has no valid pixel; OptionError for an impossible camera.
[[nodiscard]] RgbdFrame read_rgbd_images(const std::filesystem::path& color,
                                         const std::filesystem::path& depth, const Camera& camera);

}  // namespace cvo_slam
