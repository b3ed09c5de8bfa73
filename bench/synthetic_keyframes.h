// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>

#include <opencv2/core.hpp>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/core/rgbd_frame.h"
#include "cvo_slam/core/se3.h"
#include "cvo_slam/frontend/point_selection.h"

namespace cvo_slam {

/// Keyframes of a camera that mows a wall like a lawn: along a row, down to the next one, and back.
/// Any number of them can be made, each is made alone, and each sees some of the same as a dozen
/// before it and a dozen after it and nothing of all others, so that what a keyframe costs cannot
/// grow because more of them overlap.
///
/// The wall is 2 m away and covered with random squares, so that no place looks like another one:
/// images, depths, point clouds and poses agree with one another to within a depth unit.
class SyntheticKeyframes {
 public:
  /// A small one, because what an image costs to process is not the question.
  static Camera camera() {
    Camera camera;
    camera.color = {.width = 240, .height = 180, .fx = 200, .fy = 200, .cx = 119.5, .cy = 89.5};
    return camera;
  }

  /// True pose of keyframe i in the world, whose z axis points at the wall.
  static SE3 T_world_camera(std::size_t i) {
    const std::size_t rows = i / kRow;
    const auto row = static_cast<double>(rows);
    const std::size_t in_row = i % kRow;
    const double along = kStep * static_cast<double>(std::min(in_row, kAlong));
    const double down = kStep * static_cast<double>(in_row - std::min(in_row, kAlong));
    const bool backwards = (i / kRow) % 2 == 1;
    const double x = backwards ? kStep * kAlong - along : along;
    return {Matrix3::Identity(), {x, kStep * (kRow - kAlong) * row + down, 0}};
  }

  /// Images of keyframe i, a second after those of the one before.
  static RgbdFrame frame(std::size_t i) {
    const PinholeCamera pinhole = camera().color;
    const Vector3 position = T_world_camera(i).translation();
    RgbdFrame frame;
    frame.index = i;
    frame.stamp = frame.depth_stamp = Timestamp::from_seconds(1000 + static_cast<double>(i));
    frame.color = cv::Mat(pinhole.height, pinhole.width, CV_8UC3);
    frame.depth = cv::Mat(pinhole.height, pinhole.width, CV_16UC1,
                          cv::Scalar(kDistance * camera().depth_scale));
    for (int v = 0; v < pinhole.height; ++v) {
      for (int u = 0; u < pinhole.width; ++u) {
        const double x = position.x() + kDistance * (u - pinhole.cx) / pinhole.fx;
        const double y = position.y() + kDistance * (v - pinhole.cy) / pinhole.fy;
        frame.color.at<cv::Vec3b>(v, u) = color_at(x, y);
      }
    }
    return frame;
  }

  /// Points that the tracker would select in an image, a few hundred.
  static std::shared_ptr<const PointCloud> cloud(const RgbdFrame& frame) {
    constexpr int kPoints = 500;
    return std::make_shared<const PointCloud>(select_points(frame, camera(), kPoints));
  }

 private:
  static constexpr double kStep = 0.2;        // from a keyframe to the next [m]
  static constexpr std::size_t kAlong = 100;  // steps along a row
  static constexpr std::size_t kRow = 115;    // with the 3 m down to the next row; an image has 1.8
  static constexpr double kDistance = 2;      // of the wall [m]

  static cv::Vec3b color_at(double x, double y) {
    constexpr double kSquare = 0.1;  // [m]; ten pixels
    const auto column = static_cast<std::uint64_t>(std::llround(x / kSquare) + 1'000'000);
    const auto row = static_cast<std::uint64_t>(std::llround(y / kSquare) + 1'000'000);
    const std::uint64_t bits = mix(column * 4'000'000 + row);
    return {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8U),
            static_cast<std::uint8_t>(bits >> 16U)};
  }

  /// Random bits of a number: the finaliser of splitmix64 (S. Vigna, public domain).
  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }
};

}  // namespace cvo_slam
