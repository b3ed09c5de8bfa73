// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "cvo_slam/core/se3.h"
#include "cvo_slam/synthetic/image_sensors_internal.h"
#include "cvo_slam/synthetic/random_internal.h"
#include "cvo_slam/synthetic/sequence.h"
#include "cvo_slam/tests/synthetic/plane_scene.h"

namespace cvo_slam::synthetic {
namespace {

const Camera kCamera = synthetic_camera(160, 120);

IdealImages ideal_images(const WorldScene& scene) {
  const RayCaster rays(scene, kCamera.color, {});
  return cast_image(kCamera.color, [&rays](int) -> const RayCaster& { return rays; },
                    {.color = false, .depth = true, .geometry = true, .reflectance = true});
}

/// Metres, 0 = no depth.
cv::Mat measured(const IdealImages& ideal, const DepthNoiseOptions& options,
                 std::uint32_t seed = 1) {
  cv::Mat metres;
  DepthSensor(kCamera, options).measure(ideal, seed).convertTo(metres, CV_64F, 1.0 / 5000);
  return metres;
}

/// Root mean square of the measured errors in units of the formula's standard deviation.
double relative_noise(const WorldScene& scene, const DepthNoiseOptions& options) {
  const IdealImages ideal = ideal_images(scene);
  double squares = 0;
  int count = 0;
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    const cv::Mat depth = measured(ideal, options, seed);
    for (int y = 0; y < depth.rows; ++y) {
      for (int x = 0; x < depth.cols; ++x) {
        const double truth = ideal.depth.at<double>(y, x);
        if (truth == 0 || depth.at<double>(y, x) == 0) continue;
        const double sigma = kinect_axial_noise(truth, ideal.angle.at<float>(y, x));
        squares += std::pow((depth.at<double>(y, x) - truth) / sigma, 2);
        ++count;
      }
    }
  }
  return std::sqrt(squares / count);
}

double share_missing(const IdealImages& ideal, const DepthNoiseOptions& options) {
  const cv::Mat depth = measured(ideal, options);
  return 1 - static_cast<double>(cv::countNonZero(depth)) / static_cast<double>(depth.total());
}

TEST(KinectNoise, IsThatOfThePaper) {
  // Nguyen et al., at 0.4 m, at 3.4 m, and with the term of the angle at 1 m and 60 deg, where
  // a / (pi/2 - a) is 2.
  EXPECT_NEAR(kinect_axial_noise(0.4, 0), 0.0012, 1e-12);
  EXPECT_NEAR(kinect_axial_noise(3.4, 0), 0.0012 + 0.0019 * 9, 1e-12);
  EXPECT_NEAR(kinect_axial_noise(1, 60 / kDegrees), 0.0012 + 0.0019 * 0.36 + 0.0004, 1e-12);
  EXPECT_NEAR(kinect_lateral_noise(60 / kDegrees), 0.87, 1e-12);
}

TEST(DepthSensor, AnIdealOneOnlyRounds) {
  const IdealImages ideal = ideal_images(plane_at(2, 0.4));
  const cv::Mat depth = measured(ideal, {});
  double largest = 0;
  cv::minMaxLoc(cv::abs(depth - ideal.depth), nullptr, &largest);
  EXPECT_LE(largest, 0.5 / 5000 + 1e-9);
}

// The sheet is turned a little, so that depths lie anywhere between two steps. About 6,000
// independent values: 1 % of statistical error.
TEST(DepthSensor, AxialNoiseFollowsTheFormulaWithDepth) {
  const DepthNoiseOptions kinect = sensor_preset("kinect").depth;
  for (const double z : {1.0, 2.0, 3.0}) {
    EXPECT_NEAR(relative_noise(plane_at(z, 0.2), {.axial = 1, .correlation = 1}), 1, 0.1) << z;
    EXPECT_NEAR(relative_noise(plane_at(z, 0.2), kinect), 1, 0.1) << z;
  }
  EXPECT_NEAR(relative_noise(plane_at(2, 0.2), {.axial = 2}), 2, 0.1);
}

TEST(DepthSensor, AxialNoiseFollowsTheFormulaWithTheAngle) {
  const WorldScene scene = plane_at(2, 70 / kDegrees);
  EXPECT_NEAR(relative_noise(scene, {.axial = 1, .correlation = 1}), 1, 0.1);
  // The term of the angle matters there: with it the noise is half as large again.
  EXPECT_GT(kinect_axial_noise(1, 75 / kDegrees), 1.5 * kinect_axial_noise(1, 0));
}

TEST(DepthSensor, NoiseOfNeighborsIsCorrelatedAsAsked) {
  constexpr int kSide = 256;
  const auto correlation = [](const cv::Mat& field, int lag) {
    const cv::Mat a = field.colRange(0, kSide - lag);
    const cv::Mat b = field.colRange(lag, kSide);
    return cv::mean(a.mul(b))[0];
  };
  const cv::Mat white = noise_field(7, {kSide, kSide}, 0);
  EXPECT_NEAR(correlation(white, 0), 1, 0.02);
  EXPECT_NEAR(correlation(white, 1), 0, 0.02);
  EXPECT_NEAR(cv::mean(white)[0], 0, 0.02);
  // That of white noise smoothed by a Gaussian is exp(-lag^2 / (4 sigma^2)).
  const cv::Mat smooth = noise_field(7, {kSide, kSide}, 1);
  EXPECT_NEAR(correlation(smooth, 0), 1, 0.05);
  EXPECT_NEAR(correlation(smooth, 1), std::exp(-0.25), 0.05);
  EXPECT_NEAR(correlation(smooth, 4), std::exp(-4.0), 0.05);
}

TEST(DepthSensor, DisparityComesInSteps) {
  const IdealImages ideal = ideal_images(plane_at(2, 0.4));
  // Distance of a disparity from the nearest multiple of 1/8 px, in steps.
  const auto offset = [](double depth) {
    const double steps = 580 * 0.075 / depth / 0.125;
    return std::abs(steps - std::round(steps));
  };
  double with_steps = 0;
  double without = 0;
  const cv::Mat stepped = measured(ideal, {.disparity_step = 0.125});
  const cv::Mat continuous = measured(ideal, {});
  for (int i = 0; i < 160 * 120; ++i) {
    with_steps = std::max(with_steps, offset(stepped.ptr<double>()[i]));
    without = std::max(without, offset(continuous.ptr<double>()[i]));
  }
  // At 1.4 m, the nearest, half a depth unit is 0.002 px of disparity.
  EXPECT_LT(with_steps, 0.02);
  EXPECT_GT(without, 0.45);
  EXPECT_NEAR(kinect_depth_step(2, 0.125), 0.0115, 1e-4);
  double largest = 0;
  cv::minMaxLoc(cv::abs(stepped - ideal.depth), nullptr, &largest);
  EXPECT_LT(largest, kinect_depth_step(3.4, 0.125));  // half a step at the farthest, 3.4 m, is less
}

/// A box whose front is a metre away, as wide as half the image, before a sheet at two metres.
WorldScene box_before_wall() {
  WorldScene scene = plane_at(2, 0);
  scene.primitives.push_back(
      {Box{{0.61, 10, 0.2}}, SE3(Matrix3::Identity(), {0, 0, 1.1}), plain(0.5)});
  return scene;
}

TEST(DepthSensor, LateralNoiseMovesEdgesByTheFormulasPixels) {
  const IdealImages ideal = ideal_images(box_before_wall());
  // Columns of the first pixels of the box and of the wall behind its right side.
  int first = 0;
  while (first < ideal.depth.cols && ideal.depth.at<double>(60, first) > 1.5) ++first;
  int last = first;
  while (last < ideal.depth.cols && ideal.depth.at<double>(60, last) < 1.5) ++last;
  ASSERT_LT(last, ideal.depth.cols);
  std::array<double, 3>
      wrong{};  // share of pixels 1, 2, 3 px off the edge that show what is beyond
  constexpr int kFrames = 16;
  for (std::uint32_t seed = 1; seed <= kFrames; ++seed) {
    const cv::Mat depth = measured(ideal, {.lateral = 1}, seed);
    for (int y = 0; y < depth.rows; ++y) {
      for (int k = 0; k < 3; ++k) {
        const double share = 0.5 / (kFrames * depth.rows);
        wrong[static_cast<std::size_t>(k)] += depth.at<double>(y, first + k) > 1.5 ? share : 0;
        wrong[static_cast<std::size_t>(k)] += depth.at<double>(y, last + k) < 1.5 ? share : 0;
      }
    }
  }
  // A pixel k off is displaced across the edge where the noise, of 0.8 px, exceeds k - 1/2; 3,840
  // pixels leave a statistical error of 0.007.
  const auto tail = [](double x) { return 0.5 * std::erfc(x / std::numbers::sqrt2); };
  EXPECT_NEAR(wrong[0], tail(0.5 / 0.8), 0.03);
  EXPECT_NEAR(wrong[1], tail(1.5 / 0.8), 0.015);
  EXPECT_NEAR(wrong[2], tail(2.5 / 0.8), 0.005);
  // Within a surface nothing changes.
  EXPECT_NEAR(measured(ideal, {.lateral = 1}).at<double>(60, 80), 1, 1e-4);
}

TEST(DepthSensor, TheProjectorsShadowIsToTheLeftOfWhatIsNear) {
  std::vector<double> row(100, 2.0);
  std::fill(row.begin() + 40, row.begin() + 60, 1.0);
  // The baseline is seen as 500 px m / 1 m - 500 px m / 2 m of 0.02 m: five pixels.
  const auto hidden = hidden_from_projector(row.data(), 100, 500, 0.02);
  for (int x = 0; x < 100; ++x) {
    EXPECT_EQ(hidden[static_cast<std::size_t>(x)], x >= 35 && x < 40) << x;
  }
  const IdealImages ideal = ideal_images(box_before_wall());
  // fx is 131 px: 131 * 0.075 / 2 = 4.9 of 160 columns, give or take one.
  EXPECT_NEAR(share_missing(ideal, {.shadows = true}), 4.9 / 160, 1.0 / 160);
  EXPECT_EQ(share_missing(ideal, {}), 0);
}

TEST(DepthSensor, AContinuousSurfaceCastsNoShadow) {
  for (const double angle : {-1.2, -0.5, 0.5, 1.0}) {
    const IdealImages ideal = ideal_images(plane_at(2, angle));
    const double nothing = share_missing(ideal, {});
    EXPECT_EQ(share_missing(ideal, {.shadows = true}), nothing) << angle;
  }
}

TEST(DepthSensor, IsBlindOutsideItsRange) {
  const IdealImages ideal = ideal_images(plane_at(2, 0.5));
  const cv::Mat depth = measured(ideal, {.min_range = 1.7, .max_range = 2.2});
  for (int i = 0; i < 160 * 120; ++i) {
    const double truth = ideal.depth.ptr<double>()[i];
    if (std::abs(truth - 1.7) < 1e-3 || std::abs(truth - 2.2) < 1e-3) continue;
    ASSERT_EQ(depth.ptr<double>()[i] > 0, truth > 1.7 && truth < 2.2) << truth;
  }
}

TEST(DepthSensor, IsBlindAtGrazingAngles) {
  const IdealImages ideal = ideal_images(plane_at(2, 70 / kDegrees));
  const cv::Mat depth = measured(ideal, {.max_incidence = 1.2});
  cv::Mat expected = ideal.angle <= 1.2;
  expected.setTo(0, ideal.depth == 0);
  expected.setTo(0, ideal.depth > 13);  // beyond 16 bits
  EXPECT_EQ(cv::countNonZero((depth > 0) != expected), 0);
  EXPECT_GT(cv::countNonZero(expected), 1000);
  EXPECT_LT(cv::countNonZero(expected), 15000);
}

TEST(DepthSensor, IsBlindOnDarkSurfacesWhereAsked) {
  EXPECT_EQ(share_missing(ideal_images(plane_at(2, 0, 0.05)), {.min_reflectance = 0.1}), 1);
  EXPECT_EQ(share_missing(ideal_images(plane_at(2, 0, 0.2)), {.min_reflectance = 0.1}), 0);
  EXPECT_EQ(share_missing(ideal_images(plane_at(2, 0, 0.05)), {}), 0);
}

TEST(DepthSensor, LeavesTheShareOfPixelsInPatchesWithoutDepth) {
  const IdealImages ideal = ideal_images(plane_at(2, 0));
  EXPECT_NEAR(share_missing(ideal, {.missing = 0.3}), 0.3, 1e-3);
  // In patches: nearly all pixels are like their neighbour.
  const cv::Mat gaps = measured(ideal, {.missing = 0.3}) == 0;
  const cv::Mat changes = gaps.colRange(1, gaps.cols) != gaps.colRange(0, gaps.cols - 1);
  EXPECT_LT(cv::countNonZero(changes), 0.05 * static_cast<double>(gaps.total()));
}

}  // namespace
}  // namespace cvo_slam::synthetic
