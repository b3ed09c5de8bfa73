// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/map.h"

namespace cvo_slam {
namespace {

/// A camera whose pixels are round numbers: 1 cm apart at 1 m.
Camera test_camera() {
  Camera camera;
  camera.color = {.width = 64, .height = 48, .fx = 100, .fy = 100, .cx = 31.5, .cy = 23.5};
  camera.depth_scale = 1000;
  return camera;
}

/// A wall across the view, at a depth [mm].
RgbdFrame wall(std::uint16_t depth, const cv::Vec3b& bgr = {10, 20, 30}) {
  RgbdFrame frame;
  frame.color = cv::Mat(48, 64, CV_8UC3, bgr);
  frame.depth = cv::Mat(48, 64, CV_16UC1, cv::Scalar(depth));
  return frame;
}

/// Returns all pixels of a frame with a pose.
PosedFrame posed(const RgbdFrame& frame, const SE3& T_world_camera = {}, int step = 1) {
  return {sample_frame(frame, step), T_world_camera};
}

FusionOptions fine_voxels() { return {.pixel_step = 1, .voxel_size = 0.005, .min_samples = 1}; }

TEST(SampleFrame, TakesEveryNthPixelFromTheMiddleOfItsCell) {
  RgbdFrame frame = wall(1000);
  frame.depth.at<std::uint16_t>(2, 6) = 1234;
  frame.color.at<cv::Vec3b>(2, 6) = {1, 2, 3};
  const SampledFrame sampled = sample_frame(frame, 4);
  ASSERT_EQ(sampled.depth.size(), cv::Size(16, 12));
  EXPECT_EQ(sampled.depth.at<std::uint16_t>(0, 1), 1234);
  EXPECT_EQ(sampled.color.at<cv::Vec3b>(0, 1), cv::Vec3b(1, 2, 3));
  // 49 rows in steps of 4 from row 2: the last is 46.
  frame.depth = cv::Mat(49, 64, CV_16UC1, cv::Scalar(1));
  frame.color = cv::Mat(49, 64, CV_8UC1, cv::Scalar(1));
  EXPECT_EQ(sample_frame(frame, 4).depth.rows, 12);
}

TEST(FusePoints, AWallIsWhereItWasSeenAndFacesTheCamera) {
  // A camera that looks along the world's x: its right (x) is the world's -y, its down (y) -z.
  const Matrix3 rotation{{0, 0, 1}, {-1, 0, 0}, {0, -1, 0}};
  const auto points = fuse_points(std::vector{posed(wall(1500), SE3(rotation, {2, 0, 1}))},
                                  test_camera(), fine_voxels());
  ASSERT_EQ(points.size(), 64U * 48U);  // pixels are 15 mm apart, voxels 5 mm wide
  for (const MapPoint& point : points) {
    EXPECT_NEAR(point.position.x(), 3.5, 1e-5);
    EXPECT_LT((point.normal - Eigen::Vector3f(-1, 0, 0)).norm(), 1e-4);
    EXPECT_THAT(point.color, testing::ElementsAre(30, 20, 10));
  }
}

TEST(FusePoints, PixelsLandWhereTheCameraProjectsThem) {
  RgbdFrame frame = wall(2000);
  Camera camera = test_camera();
  camera.color.distortion = {0.1, -0.05, 0.001, -0.002, 0};
  for (const int step : {1, 4}) {
    const SampledFrame sampled = sample_frame(frame, step);
    const auto points = fuse_points(std::vector<PosedFrame>{{sampled, {}}}, camera, fine_voxels());
    ASSERT_EQ(points.size(), sampled.depth.total());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto column = static_cast<int>(i) % sampled.depth.cols;
      const auto row = static_cast<int>(i) / sampled.depth.cols;
      const Eigen::Vector2d pixel = camera.color.project(points[i].position.cast<double>());
      const int middle = step / 2;
      EXPECT_NEAR(pixel.x(), step * column + middle, 1e-3);
      EXPECT_NEAR(pixel.y(), step * row + middle, 1e-3);
    }
  }
}

TEST(FusePoints, AVoxelIsAMeanThatTrustsTheNearerViewMore) {
  // One wall, seen black from 1 m and white from 2 m: weights 16 to 1.
  const std::vector<PosedFrame> frames = {
      posed(wall(1000, {0, 0, 0}), SE3(Matrix3::Identity(), {0, 0, 1})),
      posed(wall(2000, {255, 255, 255}))};
  FusionOptions options = fine_voxels();
  options.voxel_size = 0.2;
  const auto points = fuse_points(frames, test_camera(), options);
  // The voxel beside the axis holds 20 x 20 pixels of the near view and 10 x 10 of the far one:
  // (16 * 4 * 0 + 1 * 255) / (16 * 4 + 1).
  const auto center = std::find_if(points.begin(), points.end(), [](const MapPoint& point) {
    const Eigen::Vector3f& p = point.position;
    return p.x() > 0 && p.x() < 0.2F && p.y() > 0 && p.y() < 0.2F;
  });
  ASSERT_NE(center, points.end());
  EXPECT_NEAR(center->color[0], 255.0 / 65, 2);
  EXPECT_NEAR(center->position.z(), 2, 1e-5);
}

/// With a sensor whose noise does not grow with depth, both views of the test above count alike.
TEST(FusePoints, WeightsAreThoseOfTheNoiseModel) {
  const std::vector<PosedFrame> frames = {
      posed(wall(1000, {0, 0, 0}), SE3(Matrix3::Identity(), {0, 0, 1})),
      posed(wall(2000, {255, 255, 255}))};
  FusionOptions options = fine_voxels();
  options.voxel_size = 0.2;
  for (const SensorNoise& noise : {SensorNoise{.depth_floor = 0.1}, SensorNoise{0, 0, 0}}) {
    Camera camera = test_camera();
    camera.noise = noise;
    const auto points = fuse_points(frames, camera, options);
    const auto center = std::find_if(points.begin(), points.end(), [](const MapPoint& point) {
      const Eigen::Vector3f& p = point.position;
      return p.x() > 0 && p.x() < 0.2F && p.y() > 0 && p.y() < 0.2F;
    });
    ASSERT_NE(center, points.end());
    // 20 x 20 black pixels and 10 x 10 white ones: a fifth of 255.
    EXPECT_NEAR(center->color[0], 51, 2);
  }
}

TEST(FusePoints, RimsAndWhatIsFarOrMissingLeaveNoPoint) {
  RgbdFrame frame = wall(2000);
  frame.depth.at<std::uint16_t>(20, 20) = 1000;  // nothing beside it at its depth
  frame.depth.at<std::uint16_t>(30, 30) = 0;
  frame.depth.row(40).setTo(6000);  // beyond max_depth
  const auto points = fuse_points(std::vector{posed(frame)}, test_camera(), fine_voxels());
  EXPECT_EQ(points.size(), 64U * 47U - 2U);
  for (const MapPoint& point : points) EXPECT_NEAR(point.position.z(), 2, 1e-5);
}

TEST(FusePoints, SameBytesOnAnyNumberOfThreads) {
  std::vector<PosedFrame> frames;
  for (int i = 0; i < 40; ++i) {  // more than two batches
    RgbdFrame frame = wall(static_cast<std::uint16_t>(1500 + 7 * i));
    for (int v = 0; v < frame.depth.rows; ++v) {
      for (int u = 0; u < frame.depth.cols; ++u) {
        frame.depth.at<std::uint16_t>(v, u) += static_cast<std::uint16_t>((u * v + i * u) % 50);
      }
    }
    frames.push_back(posed(frame, SE3(so3_exp({0, 0.02 * i, 0}), {0.01 * i, 0, 0})));
  }
  const auto one = fuse_points(frames, test_camera());
  ASSERT_GT(one.size(), 1000U);
  for (const int threads : {2, 8}) {
    const auto many = fuse_points(frames, test_camera(), {}, Executor(threads));
    ASSERT_EQ(many.size(), one.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_EQ(many[i].position, one[i].position);
      EXPECT_EQ(many[i].normal, one[i].normal);
      EXPECT_EQ(many[i].color, one[i].color);
    }
  }
}

TEST(FusePoints, BadFramesAreLeftOut) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  RgbdFrame other_size = wall(1000);
  other_size.color = cv::Mat(24, 32, CV_8UC3, cv::Scalar::all(0));
  const std::vector<PosedFrame> frames = {
      posed(RgbdFrame()), posed(other_size), posed(wall(0)),
      posed(wall(1000), SE3(Matrix3::Identity(), {nan, 0, 0})),
      posed(wall(1000), SE3(Matrix3::Identity(), {1e12, 0, 0}))};  // beyond a million voxels
  EXPECT_THAT(fuse_points(frames, test_camera()), testing::IsEmpty());
  EXPECT_THAT(fuse_points({}, test_camera()), testing::IsEmpty());
}

TEST(FusePoints, GreyFramesMakeGreyPoints) {
  RgbdFrame frame = wall(1000);
  frame.color = cv::Mat(48, 64, CV_8UC1, cv::Scalar(77));
  const auto points = fuse_points(std::vector{posed(frame)}, test_camera());
  ASSERT_FALSE(points.empty());
  EXPECT_THAT(points[0].color, testing::Each(77));
}

TEST(FusePoints, ImpossibleOptionsAreErrors) {
  EXPECT_THROW(static_cast<void>(fuse_points({}, test_camera(), {.voxel_size = 0})), OptionError);
  Camera camera = test_camera();
  camera.color.fx = 0;
  EXPECT_THROW(static_cast<void>(fuse_points({}, camera)), OptionError);
}

}  // namespace
}  // namespace cvo_slam
