// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>

#include <opencv2/core.hpp>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/rgbd_frame.h"

namespace cvo_slam {

/// Returns a camera with the field of view of a Kinect and 5000 depth units a metre.
inline Camera small_camera(int width = 320, int height = 240) {
  Camera camera;
  camera.color.width = width;
  camera.color.height = height;
  camera.color.fx = camera.color.fy = 525.0 * width / 640;
  camera.color.cx = 0.5 * (width - 1);
  camera.color.cy = 0.5 * (height - 1);
  camera.depth_scale = 5000;
  return camera;
}

/// Returns colour noise, which has strong gradients everywhere.
inline cv::Mat noise_image(const Camera& camera, unsigned seed) {
  cv::Mat image(camera.color.height, camera.color.width, CV_8UC3);
  std::mt19937 rng(seed);
  for (int v = 0; v < image.rows; ++v) {
    auto* row = image.ptr<std::uint8_t>(v);
    for (int k = 0; k < 3 * image.cols; ++k) row[k] = static_cast<std::uint8_t>(rng() >> 24U);
  }
  return image;
}

/// Returns a depth image with depth(u, v) [m] at each pixel.
template <typename Depth>
cv::Mat depth_image(const Camera& camera, const Depth& depth) {
  cv::Mat image(camera.color.height, camera.color.width, CV_16UC1);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      image.at<std::uint16_t>(v, u) =
          static_cast<std::uint16_t>(cvRound(camera.depth_scale * depth(u, v)));
    }
  }
  return image;
}

/// Returns a frame with colour noise on a wall at `depth` [m].
inline RgbdFrame noise_frame(const Camera& camera, unsigned seed, double depth = 2.0) {
  RgbdFrame frame;
  frame.color = noise_image(camera, seed);
  frame.depth = depth_image(camera, [depth](int, int) { return depth; });
  return frame;
}

}  // namespace cvo_slam
