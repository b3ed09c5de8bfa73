// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// own_images: tracks images that are in memory; here of a wall that the camera passes.
#include <cstdint>
#include <cstdio>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/slam/slam.h"

namespace {

/// In your program: the camera. Here: 2 px a frame along a wall at 2 m.
bool grab(int frame, cv::Mat& color, cv::Mat& depth, std::int64_t& nanoseconds) {
  static cv::Mat wall;
  if (wall.empty()) {
    cv::Mat blocks(60, 120, CV_8UC3);
    cv::RNG(1).fill(blocks, cv::RNG::UNIFORM, 0, 256);
    cv::resize(blocks, wall, {}, 4, 4, cv::INTER_NEAREST);
  }
  if (frame == 30) return false;
  color = wall.colRange(2 * frame, 2 * frame + 320);
  depth = cv::Mat(240, 320, CV_16UC1, cv::Scalar(2000));  // millimetres
  nanoseconds = frame * std::int64_t{33'333'333};
  return true;
}

}  // namespace

int main() {
  cvo_slam::Camera camera;
  camera.color = {320, 240, 260, 260, 159.5, 119.5, {}};
  camera.depth_scale = 1000;
  cvo_slam::Slam slam(camera);
  cvo_slam::RgbdFrame frame;
  for (std::int64_t now = 0; grab(static_cast<int>(frame.index), frame.color, frame.depth, now);
       ++frame.index) {
    frame.stamp = frame.depth_stamp = cvo_slam::Timestamp(now);
    const cvo_slam::FrameRecord record = slam.track(frame);
    if (record.status == cvo_slam::TrackingStatus::kLost) {
      std::printf("lost: %s\n", record.reason.c_str());
    } else {
      std::printf("x = %.3f m\n", record.T_world_camera.translation().x());
    }
  }
  slam.finish();
}
