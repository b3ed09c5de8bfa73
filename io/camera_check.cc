// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/camera_check.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/core/association.h"
#include "cvo_slam/io/reprojection_internal.h"

namespace cvo_slam {
namespace {

/// The middle one of the values of a member.
double median(std::vector<Reprojection> pairs, double Reprojection::*value) {
  const auto middle = pairs.begin() + static_cast<std::ptrdiff_t>(pairs.size() / 2);
  std::nth_element(
      pairs.begin(), middle, pairs.end(),
      [&](const Reprojection& a, const Reprojection& b) { return a.*value < b.*value; });
  return *middle.*value;
}

double squared_difference(double a, double b) {
  constexpr double kMost = 40;  // an occluded pixel must not outweigh a hundred others
  const double difference = std::min(std::fabs(a - b), kMost);
  return difference * difference;
}

/// Returns the grey value between four pixels; the position lies inside the image.
double interpolated(const cv::Mat& grey, const Eigen::Vector2d& pixel) {
  const int u = static_cast<int>(pixel.x());
  const int v = static_cast<int>(pixel.y());
  const double right = pixel.x() - u;
  const double down = pixel.y() - v;
  const auto value = [&](int du, int dv) {
    return static_cast<double>(grey.at<std::uint8_t>(v + dv, u + du));
  };
  return (1 - down) * ((1 - right) * value(0, 0) + right * value(1, 0)) +
         down * ((1 - right) * value(0, 1) + right * value(1, 1));
}

bool is_inside(const cv::Mat& image, const Eigen::Vector2d& pixel) {
  return pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() < image.cols - 1 &&
         pixel.y() < image.rows - 1;
}

/// Returns the largest distance between a corner of the image and where its ray is projected to:
/// beyond the turning point of a polynomial there is no ray for a pixel.
double fold_at_corners(const PinholeCamera& camera) {
  double largest = 0;
  for (const double u : {0.0, camera.width - 1.0}) {
    for (const double v : {0.0, camera.height - 1.0}) {
      const Eigen::Vector2d corner(u, v);
      const double error = (camera.project(camera.unproject(corner)) - corner).norm();
      largest = std::isfinite(error) ? std::max(largest, error) : 1e9;
    }
  }
  return largest;
}

void warn_of_pinhole(const PinholeCamera& camera, const std::string& name,
                     std::vector<std::string>& warnings) {
  // Published Kinects, phones and renderers stay within a twelfth.
  constexpr double kOffCentre = 0.15;
  if (std::fabs(camera.cx - 0.5 * camera.width) > kOffCentre * camera.width ||
      std::fabs(camera.cy - 0.5 * camera.height) > kOffCentre * camera.height) {
    warnings.push_back(fmt::format(
        "the principal point ({}, {}) of the {} camera is far from the centre of its {}x{} pixels; "
        "is the camera of images of another size?",
        camera.cx, camera.cy, name, camera.width, camera.height));
  }
  // 20 to 127 degrees across.
  constexpr double kNarrow = 2.8;
  constexpr double kWide = 0.25;
  const double focal = std::fabs(camera.fx) / camera.width;
  if (focal > kNarrow || focal < kWide) {
    warnings.push_back(fmt::format(
        "the focal length {} of the {} camera is {:.2f} times the width of its image, {} px; is "
        "the camera of images of another size?",
        camera.fx, name, focal, camera.width));
  }
  constexpr double kSquare = 0.1;
  if (std::fabs(std::fabs(camera.fx / camera.fy) - 1) > kSquare) {
    warnings.push_back(
        fmt::format("fx {} and fy {} of the {} camera differ: its pixels would not "
                    "be square",
                    camera.fx, camera.fy, name));
  }
  constexpr double kFold = 0.5;  // [px]
  if (fold_at_corners(camera) > kFold) {
    warnings.push_back(
        fmt::format("the distortion of the {} camera folds back inside the image: pixels at the "
                    "rim have no ray; check the coefficients and their order (k1, k2, p1, p2, k3)",
                    name));
  }
}

}  // namespace

std::vector<LocatedFrame> posed_frames(const std::vector<Timestamp>& stamps,
                                       const std::vector<StampedPose>& poses) {
  std::vector<LocatedFrame> frames;
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    const auto pose = interpolate_at(poses, stamps[i], kMaxPoseGap);
    if (pose) frames.push_back({i, *pose});
  }
  return frames;
}

std::vector<FramePairMotion> choose_pairs(const std::vector<LocatedFrame>& frames) {
  constexpr std::size_t kPairs = 6;
  constexpr std::size_t kFarthest = 60;
  // Most of the image is seen by both.
  constexpr double kTurn = 0.2;   // [rad]
  constexpr double kStep = 0.25;  // [m]
  std::vector<FramePairMotion> pairs;
  if (frames.size() < 2) return pairs;
  const std::size_t count = std::min(kPairs, frames.size() - 1);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t first = k * (frames.size() - 1) / count;
    std::optional<std::size_t> last;
    for (std::size_t i = first + 1; i < std::min(frames.size(), first + kFarthest); ++i) {
      const SE3 motion = frames[first].T_world_camera.inverse() * frames[i].T_world_camera;
      if (motion.angle() > kTurn || motion.translation().norm() > kStep) break;
      last = i;
    }
    if (last) pairs.push_back({frames[first], frames[*last]});
  }
  return pairs;
}

std::optional<Reprojection> reproject(const GreyDepth& a, const GreyDepth& b, const SE3& T_a_b,
                                      const Camera& camera) {
  constexpr int kStep = 6;              // [px]
  constexpr std::size_t kFewest = 200;  // pixels
  double color = 0;
  double still = 0;
  std::vector<double> depth_errors;
  for (int v = kStep / 2; v < b.depth.rows; v += kStep) {
    for (int u = kStep / 2; u < b.depth.cols; u += kStep) {
      const double z = b.depth.at<std::uint16_t>(v, u) / camera.depth_scale;
      if (z <= 0) continue;
      const Vector3 p = T_a_b * (z * camera.color.unproject({u, v}));
      if (!(p.z() > 0)) continue;
      const Eigen::Vector2d pixel = camera.color.project(p);
      if (!is_inside(a.grey, pixel)) continue;
      const double measured = a.depth.at<std::uint16_t>(static_cast<int>(std::lround(pixel.y())),
                                                        static_cast<int>(std::lround(pixel.x()))) /
                              camera.depth_scale;
      if (measured <= 0) continue;
      const double grey = b.grey.at<std::uint8_t>(v, u);
      color += squared_difference(interpolated(a.grey, pixel), grey);
      still += squared_difference(a.grey.at<std::uint8_t>(v, u), grey);
      depth_errors.push_back(std::fabs(measured - p.z()) / p.z());
    }
  }
  if (depth_errors.size() < kFewest) return std::nullopt;
  const auto count = static_cast<double>(depth_errors.size());
  const auto middle = depth_errors.begin() + static_cast<std::ptrdiff_t>(depth_errors.size() / 2);
  std::nth_element(depth_errors.begin(), middle, depth_errors.end());
  return Reprojection{1, color / count, still / count, *middle};
}

std::optional<Reprojection> median_of(const std::vector<Reprojection>& pairs) {
  if (pairs.empty()) return std::nullopt;
  return Reprojection{pairs.size(), median(pairs, &Reprojection::color_error),
                      median(pairs, &Reprojection::still_error),
                      median(pairs, &Reprojection::depth_error)};
}

cv::Mat to_grey(const cv::Mat& color) {
  if (color.channels() == 1) return color;
  cv::Mat grey;
  cv::cvtColor(color, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

std::optional<Reprojection> measure_reprojection(const Dataset& data,
                                                 const std::vector<StampedPose>& poses) {
  std::vector<Timestamp> stamps;
  for (std::size_t i = 0; i < data.size(); ++i) stamps.push_back(data.stamp(i));
  std::vector<Reprojection> pairs;
  for (const auto& [a, b] : choose_pairs(posed_frames(stamps, poses))) {
    const RgbdFrame frame_a = data.read(a.index);
    const RgbdFrame frame_b = data.read(b.index);
    if (!frame_a.problem.empty() || !frame_b.problem.empty()) continue;
    const auto agreement =
        reproject({to_grey(frame_a.color), frame_a.depth}, {to_grey(frame_b.color), frame_b.depth},
                  a.T_world_camera.inverse() * b.T_world_camera, data.camera());
    if (agreement) pairs.push_back(*agreement);
  }
  return median_of(pairs);
}

std::vector<std::string> camera_warnings(const Camera& camera) {
  std::vector<std::string> warnings;
  warn_of_pinhole(camera.color, "colour", warnings);
  if (camera.depth) warn_of_pinhole(camera.depth->pinhole, "depth", warnings);
  return warnings;
}

std::optional<std::string> reprojection_warning(const Reprojection& agreement,
                                                const std::string& poses) {
  // Noise of a Kinect at 3 m is 1 %, and true poses remove most of the difference of two images.
  constexpr double kDepth = 0.03;
  constexpr double kColor = 0.7;
  constexpr double kMoves = 25;
  const bool bad_color =
      agreement.still_error > kMoves && agreement.color_error > kColor * agreement.still_error;
  if (agreement.depth_error <= kDepth && !bad_color) return std::nullopt;
  return fmt::format(
      "frames re-project badly into each other by {}: depth is off by {:.1f} %, grey values by "
      "{:.0f} % of what they differ by unmoved; check the camera (intrinsics, depth_scale), and "
      "that depth is registered to colour",
      poses, 100 * agreement.depth_error,
      100 * std::sqrt(agreement.color_error / std::max(agreement.still_error, 1e-9)));
}

}  // namespace cvo_slam
