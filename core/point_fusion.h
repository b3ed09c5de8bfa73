// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/map.h"
#include "cvo_slam/core/options.h"
#include "cvo_slam/core/parallel.h"
#include "cvo_slam/core/rgbd_frame.h"

namespace cvo_slam {

/// How frames become the points of a map.
struct FusionOptions {
  int pixel_step = 3;
  double voxel_size = 0.02;
  int min_samples = 2;
  double max_depth = 4;
  double max_jump = 0.05;
  double min_cosine = 0.15;
};

[[nodiscard]] OptionSet describe(FusionOptions& options);

/// The pixels of a frame that fusion looks at: little enough to keep of every keyframe until its
/// pose is final.
struct SampledFrame {
  Timestamp stamp;
  int pixel_step = 1;  ///< pixel (u, v) here is pixel step * (u, v) + step / 2 of the frame
  cv::Mat color;       ///< as RgbdFrame::color
  cv::Mat depth;       ///< as RgbdFrame::depth
};

/// Every `pixel_step`-th pixel of every such row; without images where the frame has none, or of
/// different sizes.
[[nodiscard]] SampledFrame sample_frame(const RgbdFrame& frame, int pixel_step);

struct PosedFrame {
  SampledFrame frame;
  SE3 T_world_camera;
};

/// The surface that the frames saw: of each voxel the mean of the points in it, weighted by
/// 1 / depth^4, because the noise of a depth from stereo or structured light grows with depth^2.
/// Normals are those of the depth images, turned to the camera. Left out are pixels whose
/// neighbours lie elsewhere (rims), surfaces seen from the side, and frames without images or with
/// a pose that is not finite. Points are in the order in which their voxels were met, whatever the
/// executor's threads. Throws OptionError where the camera or an option is impossible.
[[nodiscard]] std::vector<MapPoint> fuse_points(std::span<const PosedFrame> frames,
                                                const Camera& camera,
                                                const FusionOptions& options = {},
                                                const Executor& executor = Executor(1));

}  // namespace cvo_slam
