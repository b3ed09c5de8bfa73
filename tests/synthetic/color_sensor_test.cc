// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "cvo_slam/synthetic/image_sensors_internal.h"

namespace cvo_slam::synthetic {
namespace {

double deviation(const cv::Mat& image) {
  cv::Scalar mean;
  cv::Scalar sigma;
  cv::meanStdDev(image.reshape(1), mean, sigma);
  return sigma[0];
}

double deviation(const std::vector<double>& values) { return deviation(cv::Mat(values, true)); }

cv::Mat uniform_light(double level) { return {200, 200, CV_32FC3, cv::Scalar::all(level)}; }

TEST(ColorSensor, NoiseGrowsWithTheRootOfTheLight) {
  const ImageNoiseOptions options{.read = 2, .shot = 5};
  for (const double level : {30.0, 100.0, 200.0}) {
    // 120,000 values: 0.2 % of statistical error. Rounding adds a twelfth.
    const double expected = std::sqrt(4 + 25 * level / 255 + 1.0 / 12);
    EXPECT_NEAR(deviation(expose(uniform_light(level), 1, options, 3)), expected, 0.02 * expected);
  }
  EXPECT_EQ(deviation(expose(uniform_light(100), 1, {}, 3)), 0);
}

TEST(ColorSensor, WithoutNoiseItRoundsAndSaturates) {
  EXPECT_EQ(expose(uniform_light(99.6), 1, {}, 1).at<cv::Vec3b>(0, 0), cv::Vec3b::all(100));
  EXPECT_EQ(expose(uniform_light(300), 1, {}, 1).at<cv::Vec3b>(0, 0), cv::Vec3b::all(255));
  // What saturates at the usual exposure is seen at a shorter one.
  EXPECT_EQ(expose(uniform_light(300), 0.5, {}, 1).at<cv::Vec3b>(0, 0), cv::Vec3b::all(150));
}

std::vector<double> log_gains(const ExposureOptions& options, double seconds) {
  std::vector<double> gains;
  for (double t = 0; t < seconds; t += 0.05)
    gains.push_back(std::log(exposure_gain(options, 5, t)));
  return gains;
}

TEST(Exposure, IsConstantWhereNothingIsAsked) {
  for (const double gain : log_gains({}, 10)) ASSERT_EQ(gain, 0);
}

TEST(Exposure, DriftsSmoothlyWithTheVarianceAskedFor) {
  const auto gains = log_gains({.drift = 0.1, .drift_period = 4}, 4000);
  // 1,000 independent values: 2 % of statistical error.
  EXPECT_NEAR(deviation(gains), 0.1, 0.01);
  // At most pi/2 * 3/2 / 4 s = 0.6 times the deviation of two values a second.
  for (std::size_t i = 1; i < gains.size(); ++i) ASSERT_LT(std::abs(gains[i] - gains[i - 1]), 0.02);
}

TEST(Exposure, JumpsOnceInEachInterval) {
  const auto gains = log_gains({.jump = 0.2, .jump_interval = 4}, 4000);
  EXPECT_NEAR(deviation(gains), 0.2, 0.02);
  int jumps = 0;
  for (std::size_t i = 1; i < gains.size(); ++i) jumps += gains[i] != gains[i - 1] ? 1 : 0;
  EXPECT_NEAR(jumps, 1000, 2);
}

}  // namespace
}  // namespace cvo_slam::synthetic
