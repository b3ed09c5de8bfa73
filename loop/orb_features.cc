// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/loop/orb_features.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/loop/even_selection_internal.h"

namespace cvo_slam {
namespace {

/// Size of the patch that descriptors need around their corner [px]; OpenCV's default.
constexpr int kPatch = 31;

/// Returns the grey image; an empty one if the image cannot be used.
cv::Mat grey_of(const cv::Mat& color) {
  if (std::min(color.rows, color.cols) <= 2 * kPatch) return {};
  if (color.type() == CV_8UC1) return color;
  cv::Mat grey;
  if (color.type() == CV_8UC3) cv::cvtColor(color, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

/// Makes a detector of many more corners than wanted, because OpenCV keeps the strongest of the
/// whole image without regard to their positions.
cv::Ptr<cv::ORB> make_detector(const OrbOptions& options, int threshold) {
  constexpr int kSurplus = 20;
  return cv::ORB::create(kSurplus * options.features, static_cast<float>(options.scale),
                         options.levels, kPatch, 0, 2, cv::ORB::HARRIS_SCORE, kPatch, threshold);
}

std::vector<cv::KeyPoint> detect(const cv::Mat& grey, const OrbOptions& options) {
  std::vector<cv::KeyPoint> all;
  make_detector(options, options.threshold)->detect(grey, all);
  auto selected = select_evenly(all, grey.size(), options, options.features);
  const int missing = options.features - static_cast<int>(selected.size());
  if (missing <= 0 || options.low_threshold >= options.threshold) return selected;
  make_detector(options, options.low_threshold)->detect(grey, all);
  const auto weak = select_evenly(in_empty_cells(all, selected, grey.size(), options), grey.size(),
                                  options, missing);
  selected.insert(selected.end(), weak.begin(), weak.end());
  return selected;
}

/// Returns the depth around a pixel [m]; 0 if most of it is missing or it spans an edge.
double depth_at(const cv::Mat& depth, const cv::Point& pixel, double units_per_metre) {
  std::array<std::uint16_t, 9> values{};
  std::size_t count = 0;
  for (int y = std::max(0, pixel.y - 1); y <= std::min(depth.rows - 1, pixel.y + 1); ++y) {
    for (int x = std::max(0, pixel.x - 1); x <= std::min(depth.cols - 1, pixel.x + 1); ++x) {
      const auto value = depth.at<std::uint16_t>(y, x);
      if (value > 0) values[count++] = value;
    }
  }
  constexpr std::size_t kEnough = 5;
  if (count < kEnough) return 0;
  auto* const end = values.data() + count;
  std::sort(values.data(), end);
  const double median = values[count / 2] / units_per_metre;
  const double spread = (values[count - 1] - values[0]) / units_per_metre;
  // A surface seen at 80 degrees changes by 2.2 % of its depth over the three pixels; a Kinect's
  // noise adds 1 cm at 2 m.
  constexpr double kSlope = 0.025;
  constexpr double kNoise = 0.01;
  return spread <= kSlope * median + kNoise * median * median / 4 ? median : 0;
}

bool has_depth_image(const RgbdFrame& frame) {
  return frame.depth.type() == CV_16UC1 && frame.depth.size() == frame.color.size();
}

OrbFeature to_feature(const cv::KeyPoint& keypoint, const RgbdFrame& frame, const Camera& camera,
                      double scale) {
  const Vector3 ray = camera.color.unproject({keypoint.pt.x, keypoint.pt.y});
  OrbFeature feature;
  feature.u = keypoint.pt.x;
  feature.v = keypoint.pt.y;
  feature.x = static_cast<float>(ray.x());
  feature.y = static_cast<float>(ray.y());
  feature.angle = keypoint.angle * static_cast<float>(std::numbers::pi / 180);
  feature.size = static_cast<float>(std::pow(scale, keypoint.octave));
  if (has_depth_image(frame)) {
    const cv::Point pixel(cvRound(keypoint.pt.x), cvRound(keypoint.pt.y));
    feature.depth = static_cast<float>(depth_at(frame.depth, pixel, camera.depth_scale));
  }
  return feature;
}

}  // namespace

OptionSet describe(OrbOptions& o) {
  return OptionSet()
      .add("features", o.features, {10, 20000}, "",
           "Most features of an image. More make loops under changed viewpoints more likely and "
           "take "
           "more time and memory.")
      .expert()
      .add(
          "levels", o.levels, {1, 16}, "",
          "Levels of the image pyramid; eight at a scale of 1.2 cover a factor of 3.6 in distance.")
      .add("scale", o.scale, {1.05, 2}, "", "Ratio of the sizes of two pyramid levels.")
      .add("threshold", o.threshold, {1, 255}, "grey levels",
           "Contrast of a corner: least difference between its ring and its centre.")
      .add("low_threshold", o.low_threshold, {1, 255}, "grey levels",
           "Contrast of a corner in cells where the other threshold finds none, as on plain walls.")
      .add("per_cell", o.per_cell, {1, 1000}, "",
           "Features in each cell of the grids that spread them; fewer are more even and weaker.");
}

OrbFeatures extract_orb(const RgbdFrame& frame, const Camera& camera, const OrbOptions& options) {
  OrbFeatures features;
  const cv::Mat grey = grey_of(frame.color);
  if (grey.empty()) return features;
  std::vector<cv::KeyPoint> keypoints = detect(grey, options);
  if (keypoints.empty()) return features;
  cv::Mat descriptors;
  make_detector(options, options.threshold)->compute(grey, keypoints, descriptors);
  features.descriptors = to_descriptors(descriptors);
  features.points.reserve(keypoints.size());
  for (const cv::KeyPoint& keypoint : keypoints) {
    features.points.push_back(to_feature(keypoint, frame, camera, options.scale));
  }
  return features;
}

}  // namespace cvo_slam
