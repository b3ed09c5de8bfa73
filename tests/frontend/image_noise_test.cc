// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdint>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/frontend/image_noise_internal.h"
#include "cvo_slam/frontend/point_selection.h"
#include "cvo_slam/tests/frontend/test_frames.h"

namespace cvo_slam {
namespace {

/// A slope from dark to bright.
cv::Mat slope() {
  cv::Mat image(480, 640, CV_8UC1);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      image.at<std::uint8_t>(v, u) = static_cast<std::uint8_t>(60 + (u + v) / 10);
    }
  }
  return image;
}

cv::Mat noisy(const cv::Mat& image, double deviation) {
  cv::RNG random(5);
  cv::Mat noise(image.size(), CV_16SC1);
  random.fill(noise, cv::RNG::NORMAL, 0, deviation);
  cv::Mat result;
  cv::add(image, noise, result, cv::noArray(), CV_8U);
  return result;
}

TEST(ImageNoise, IsItsStandardDeviation) {
  for (const double deviation : {2.0, 5.0, 10.0}) {
    EXPECT_NEAR(image_noise(noisy(slope(), deviation)), deviation, 0.05 * deviation + 0.1);
  }
}

TEST(ImageNoise, EdgesAndTextureOnLessThanHalfOfTheImageHardlyCount) {
  cv::Mat image = slope();
  noisy(image.rowRange(0, 150), 60).copyTo(image.rowRange(0, 150));
  cv::rectangle(image, {300, 200}, {500, 400}, 250, cv::FILLED);
  EXPECT_NEAR(image_noise(noisy(image, 4)), 4, 2);
}

TEST(ImageNoise, OfACleanImageIsNextToNothing) {
  EXPECT_LT(image_noise(cv::Mat(480, 640, CV_8UC1, cv::Scalar(90))), 0.1);
  EXPECT_LT(image_noise(slope()), 0.3);
}

TEST(ImageNoise, OfAnImageTooSmallIsZero) {
  EXPECT_EQ(image_noise(cv::Mat()), 0);
  EXPECT_EQ(image_noise(cv::Mat(9, 9, CV_8UC1, cv::Scalar(3))), 0);
}

TEST(ImageNoise, IsNoReasonToSelectAPixel) {
  const Camera camera = small_camera(640, 480);
  RgbdFrame frame = noise_frame(camera, 1);
  frame.color = slope();
  constexpr int kTexture = 100;  // number of rows with texture
  const cv::Mat top = frame.color.rowRange(0, kTexture);
  noisy(top, 60).copyTo(top);
  frame.color = noisy(frame.color, 4);
  SelectionOptions options;
  const auto below_texture = [&] {
    const PointCloud cloud = select_points(frame, camera, 2000, options);
    return std::count_if(cloud.v.begin(), cloud.v.end(), [](float v) { return v > kTexture; });
  };
  EXPECT_LT(below_texture(), 20);
  options.noise_gradient = 0;
  EXPECT_GT(below_texture(), 1000);
}

}  // namespace
}  // namespace cvo_slam
