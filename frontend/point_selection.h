// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

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
  double weak_gradient = 3.0;
  int few_pixels = 200;
  double noise_gradient = 2.0;
  double min_depth = 0.3;
  double max_depth = 6.0;
  double max_depth_step = 0.05;
};

[[nodiscard]] OptionSet describe(SelectionOptions& options);

/// Semi-dense point selection: pixels of high image gradient with a depth that can be trusted,
/// evenly spread over the image, back-projected to points with features. The points come in rounds
/// through square buckets of the image, each of which gives its strongest pixel left, so that every
/// prefix of a cloud is evenly spread too. An object serves the frames of one camera and keeps its
/// memory between them.
class PointSelector {
 public:
  PointSelector(const Camera& camera, const SelectionOptions& options);

  /// Ranks the pixels of a frame, whose images must be of the camera's size (see check_images())
  /// and are referred to until the next call.
  void prepare(const RgbdFrame& frame);
  /// At most `count` points of the prepared frame. Where the camera moved between the stamps of the
  /// two images, T_color_depth is that motion (the pose of the camera at the depth image's time in
  /// its frame at the colour image's time) and each pixel's depth is looked up where the depth
  /// image saw it.
  void select(int count, const SE3& T_color_depth, PointCloud& cloud);

 private:
  struct Candidate {
    std::uint16_t u, v;      ///< pixel
    std::int32_t gradient2;  ///< squared gradient magnitude, on Sobel's scale
  };

  void rank(double min_gradient);
  void offer(std::size_t bucket, const Candidate& candidate);
  void append(const Candidate& candidate, const Vector3& point, PointCloud& cloud) const;

  Camera camera_;
  SelectionOptions options_;
  std::vector<float> rays_;  // x/z, y/z of each pixel
  cv::Mat color_, depth_;    // of the prepared frame
  cv::Mat grey_, dx_, dy_, edges_;
  int bucket_columns_ = 0;
  std::vector<Candidate> band_;        // the strongest pixel of each cell of a row of cells
  std::vector<Candidate> candidates_;  // kBucketCells^2 places a bucket, strongest first
  std::vector<std::uint8_t> counts_;   // candidates of each bucket
  std::vector<std::uint8_t> next_;     // of each bucket, while selecting
  std::vector<std::uint32_t> round_;   // order of the buckets within a round
};

/// The points of a single frame; see PointSelector.
[[nodiscard]] PointCloud select_points(const RgbdFrame& frame, const Camera& camera, int count,
                                       const SelectionOptions& options = {},
                                       const SE3& T_color_depth = {});

/// What makes a frame's images unusable for this camera; empty where nothing does.
[[nodiscard]] std::string check_images(const RgbdFrame& frame, const Camera& camera);

}  // namespace cvo_slam
