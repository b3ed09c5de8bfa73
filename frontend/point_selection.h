// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/options.h"
#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/rgbd_frame.h"

namespace cvo_slam {

/// Which pixels may become points.
enum class SelectionMethod {
  kGradient,  ///< the pixel of strongest gradient in each small cell of the image
  kEdges,     ///< pixels on Canny edges: the paper's choice
};

/// How the points of a frame are selected.
struct SelectionOptions {
  /// Least depth of a point [m]. 0.3 excludes what a Kinect reports closer than it can see; lower
  /// it for sensors with a short range.
  double min_depth = 0.3;
  /// Largest depth of a point [m]. A Kinect's error grows with the square of the depth and reaches
  /// the finest length scale at 6 m; raise it for sensors with a longer range.
  double max_depth = 6.0;
  SelectionMethod method = SelectionMethod::kGradient;  ///< which pixels may become points
  double min_gradient = 4.0;   ///< least gradient of a point [8-bit values a pixel]
  double weak_gradient = 3.0;  ///< replaces min_gradient in images with few gradients
  int few_pixels = 200;  ///< number of 4x4 cells with a candidate below which gradients are few
  double noise_gradient = 2.0;   ///< least gradient, in standard deviations of the image noise
  double max_depth_step = 0.05;  ///< largest step to a neighbour, as a share of the depth
};

/// Returns the options with their keys, ranges and documentation.
[[nodiscard]] OptionSet describe(SelectionOptions& options);

/// A pixel that may become a point.
struct PixelCandidate {
  ///@{
  /// Column (u) or row (v) of the pixel [px].
  std::uint16_t u, v;
  ///@}
  std::int32_t gradient2;  ///< squared gradient magnitude, on Sobel's scale
};

/// The exposure of an image: how much brighter it is than the first one because of the camera.
struct Exposure {
  double gain = 1;          ///< factor by which colours are divided
  double log_measured = 0;  ///< logarithm of the factor as it was measured
};

/// A frame with all that selecting its points needs. PointSelector::prepare() makes it once a
/// frame; the pictures in it are copies that nobody else writes to.
struct PreparedFrame {
  RgbdFrame images;   ///< the frame, with copies of its images
  Exposure exposure;  ///< select() divides the colours by its gain
  ///@{
  /// Sobel's gradient of the grey image along the rows (dx) or the columns (dy), CV_16SC1.
  cv::Mat dx, dy;
  ///@}
  std::vector<PixelCandidate> candidates;  ///< a fixed number of places a bucket, strongest first
  std::vector<std::uint8_t> counts;        ///< number of candidates of each bucket
};

/// Semi-dense point selection: pixels of high image gradient with a depth that can be trusted,
/// evenly spread over the image, back-projected to points with features. The points come in rounds
/// through square buckets of the image, each of which gives its strongest pixel left, so that every
/// prefix of a cloud is evenly spread too. One object serves the frames of one camera.
class PointSelector {
 public:
  /// Camera and options are copied; they are not checked.
  PointSelector(const Camera& camera, const SelectionOptions& options);

  /// Copies a frame, whose images must be of the camera's size (see check_images()), and ranks its
  /// pixels. The memory of `reused` serves again, except images that somebody else still holds.
  [[nodiscard]] PreparedFrame prepare(const RgbdFrame& frame, PreparedFrame reused = {});

  /// Selects at most `count` points of a prepared frame into `cloud`. If the camera moved between
  /// the stamps of the two images, T_color_depth is that motion (the pose of the camera at the
  /// depth image's time in its frame at the colour image's time), and each pixel's depth is looked
  /// up where the depth image saw it.
  void select(const PreparedFrame& frame, int count, const SE3& T_color_depth, PointCloud& cloud);

 private:
  void rank(double min_gradient, PreparedFrame& frame);
  static void offer(std::size_t bucket, const PixelCandidate& candidate, PreparedFrame& frame);

  Camera camera_;
  SelectionOptions options_;
  std::vector<float> rays_;  // x/z, y/z of each pixel
  int bucket_columns_ = 0;
  std::vector<std::uint32_t> round_;     // order of the buckets within a round
  cv::Mat grey_, edges_;                 // memory of prepare()
  std::vector<PixelCandidate> band_;     // the strongest pixel of each cell of a row; memory
  std::vector<std::uint8_t> next_;       // next candidate of each bucket; memory of select()
  std::vector<cv::Point> depth_pixels_;  // that the points' depths are from; memory of select()
};

/// Selects the points of a single frame; see PointSelector.
[[nodiscard]] PointCloud select_points(const RgbdFrame& frame, const Camera& camera, int count,
                                       const SelectionOptions& options = {},
                                       const SE3& T_color_depth = {});

/// Returns what makes a frame's images unusable for this camera; empty if nothing does.
[[nodiscard]] std::string check_images(const RgbdFrame& frame, const Camera& camera);

}  // namespace cvo_slam
