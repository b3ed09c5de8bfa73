// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/frontend/point_selection.h"

namespace cvo_slam {

/// Looks up the depth of colour pixels if it can be trusted.
class DepthLookup {
 public:
  /// `rays` holds x/z and y/z of each pixel. All arguments must outlive the object.
  DepthLookup(const cv::Mat& depth, const Camera& camera, const std::vector<float>& rays,
              const SE3& T_color_depth, const SelectionOptions& options)
      : depth_(depth),
        camera_(camera.color),
        rays_(rays),
        metres_(1 / camera.depth_scale),
        T_color_depth_(T_color_depth),
        T_depth_color_(T_color_depth.inverse()),
        moved_(T_color_depth.log().norm() > 0),
        options_(options) {}

  struct Point {
    Vector3 position;       ///< at the colour image's time [m]
    cv::Point depth_pixel;  ///< that its depth is from
  };
  /// Returns the point seen at colour pixel (u, v); empty if it has no depth to be trusted.
  [[nodiscard]] std::optional<Point> point(int u, int v) const {
    const std::size_t pixel = 2 * static_cast<std::size_t>(v * depth_.cols + u);
    const Vector3 ray(rays_[pixel], rays_[pixel + 1], 1);
    if (!moved_) {
      if (!trusted(u, v)) return std::nullopt;
      return Point{depth_at(u, v) * ray, {u, v}};
    }

    // The depth image was taken from elsewhere: search where it saw this ray. Depth changes little
    // over the few pixels between, so that the iteration contracts quickly.
    constexpr int kIterations = 3;
    double z = depth_at(u, v);
    if (z <= 0) return std::nullopt;
    cv::Point nearest;
    for (int i = 0; i < kIterations; ++i) {
      const Vector3 expected = T_depth_color_ * (z * ray);
      if (expected.z() <= 0) return std::nullopt;
      const Eigen::Vector2d seen = camera_.project(expected);
      // trusted() looks at neighbours.
      const double border = 1 + kReach;
      if (!(seen.x() > border && seen.y() > border && seen.x() < depth_.cols - 1 - border &&
            seen.y() < depth_.rows - 1 - border)) {
        return std::nullopt;
      }
      nearest = {cvRound(seen.x()), cvRound(seen.y())};
      const double measured = depth_at(nearest.x, nearest.y);
      const bool is_last = i + 1 == kIterations;
      if (measured <= 0 || (is_last && !trusted(nearest.x, nearest.y))) return std::nullopt;
      z = (T_color_depth_ * (expected * (measured / expected.z()))).z();
    }
    return Point{z * ray, nearest};
  }

 private:
  static constexpr int kReach = 2;  // distance of the neighbours that trusted() looks at [px]

  [[nodiscard]] double depth_at(int u, int v) const {
    return metres_ * depth_.at<std::uint16_t>(v, u);
  }

  /// Returns true if the depth is in range and no neighbour two pixels around is much nearer or
  /// farther: at a discontinuity colour and depth may belong to different surfaces. Neighbours
  /// without depth are the shadow of structured light beside a discontinuity.
  [[nodiscard]] bool trusted(int u, int v) const {
    const double z = depth_at(u, v);
    if (!(z >= options_.min_depth && z <= options_.max_depth)) return false;
    const double limit = options_.max_depth_step * z;
    for (int dv = -kReach; dv <= kReach; dv += kReach) {
      for (int du = -kReach; du <= kReach; du += kReach) {
        const double neighbour = depth_at(u + du, v + dv);
        if (neighbour <= 0 || std::abs(neighbour - z) > limit) return false;
      }
    }
    return true;
  }

  const cv::Mat& depth_;
  const PinholeCamera& camera_;
  const std::vector<float>& rays_;
  double metres_;
  SE3 T_color_depth_;
  SE3 T_depth_color_;
  bool moved_;
  const SelectionOptions& options_;
};

}  // namespace cvo_slam
