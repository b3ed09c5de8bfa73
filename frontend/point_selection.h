// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/options.h"
#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/rgbd_frame.h"

namespace cvo_slam {

/// Which pixels may become points.
enum class SelectionMethod {
  kGradient,  ///< the pixel of strongest gradient in each small cell of the image
  kEdges,     ///< pixels on Canny edges: the paper's
};

struct SelectionOptions {
  SelectionMethod method = SelectionMethod::kGradient;
  double min_gradient = 4.0;
  double min_depth = 0.3;
  double max_depth = 6.0;
  double max_depth_step = 0.05;
};

[[nodiscard]] OptionSet describe(SelectionOptions& options);

/// Semi-dense point selection: at most `count` pixels of high image gradient with a depth that can
/// be trusted, evenly spread over the image, back-projected to points with features. The points are
/// ordered in rounds through square buckets of the image, so that a prefix of whole rounds is
/// evenly spread too. `frame` must have images of the camera's size; see check_images(). Where the
/// camera moved between the stamps of the two images, T_color_depth is that motion (the pose of the
/// camera at the depth image's time in its frame at the colour image's time) and each pixel's depth
/// is looked up where the depth image saw it.
[[nodiscard]] PointCloud select_points(const RgbdFrame& frame, const Camera& camera, int count,
                                       const SelectionOptions& options = {},
                                       const SE3& T_color_depth = {});

/// What makes a frame's images unusable for this camera; empty where nothing does.
[[nodiscard]] std::string check_images(const RgbdFrame& frame, const Camera& camera);

}  // namespace cvo_slam
