// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <random>

#include <opencv2/imgproc.hpp>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/rgbd_frame.h"

namespace cvo_slam {

/// A wall covered with random triangles, one metre in front of a camera that looks straight at it:
/// moving the camera along the wall moves a window over a picture, and nothing else changes.
class Poster {
 public:
  static constexpr double kDistance = 1;  // [m]

  explicit Poster(unsigned seed, int width = 2400, int height = 480)
      : picture_(height, width, CV_8UC3, cv::Scalar(120, 120, 120)) {
    std::mt19937 engine(seed);
    const auto below = [&](int n) { return static_cast<int>(engine() % static_cast<unsigned>(n)); };
    for (int i = 0; i < width * height / 400; ++i) {
      const cv::Scalar color(below(256), below(256), below(256));
      const cv::Point middle(below(width), below(height));
      std::array<cv::Point, 3> triangle;
      for (auto& corner : triangle) corner = middle + cv::Point(below(40) - 20, below(40) - 20);
      cv::fillConvexPoly(picture_, triangle, color);
    }
  }

  static Camera camera() {
    Camera camera;
    camera.color.width = 320;
    camera.color.height = 240;
    camera.color.fx = camera.color.fy = 250;
    camera.color.cx = 159.5;
    camera.color.cy = 119.5;
    return camera;
  }

  /// Returns the view of a camera whose upper left pixel is at (x, y) of the picture.
  [[nodiscard]] RgbdFrame frame(std::size_t index, int x, int y) const {
    RgbdFrame frame;
    frame.index = index;
    frame.color = picture_(cv::Rect(x, y, 320, 240)).clone();
    frame.depth = cv::Mat(240, 320, CV_16UC1, cv::Scalar(kDistance * camera().depth_scale));
    return frame;
  }

  /// Returns the motion of the camera [m] that moves the window by this many pixels.
  static double metres(int pixels) { return pixels * kDistance / camera().color.fx; }

 private:
  cv::Mat picture_;
};

}  // namespace cvo_slam
