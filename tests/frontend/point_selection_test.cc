// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/frontend/point_selection.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "cvo_slam/tests/frontend/test_frames.h"

namespace cvo_slam {
namespace {

SelectionOptions test_options() {
  SelectionOptions options;
  options.method = SelectionMethod::kGradient;
  options.min_gradient = 2;
  options.few_pixels = 0;
  options.min_depth = 0.3;
  options.max_depth = 6;
  options.max_depth_step = 0.05;
  return options;
}

class PointSelection : public testing::Test {
 protected:
  [[nodiscard]] PointCloud select(const RgbdFrame& frame, int count) const {
    return select_points(frame, camera_, count, options_);
  }

  /// Returns the share of the first `count` points in each quarter of the image.
  [[nodiscard]] std::array<double, 4> quarters(const PointCloud& cloud, std::size_t count) const {
    std::array<double, 4> shares{};
    for (std::size_t i = 0; i < count; ++i) {
      const bool right = cloud.u[i] > camera_.color.cx;
      const bool lower = cloud.v[i] > camera_.color.cy;
      shares[(right ? 1U : 0U) + (lower ? 2U : 0U)] += 1.0 / static_cast<double>(count);
    }
    return shares;
  }

  Camera camera_ = small_camera();
  SelectionOptions options_ = test_options();
  RgbdFrame frame_ = noise_frame(camera_, 1);
};

TEST_F(PointSelection, GivesAsManyPointsAsAskedForWhereThereAreSo) {
  for (const int count : {1, 50, 500, 3000}) {
    EXPECT_EQ(select(frame_, count).size(), static_cast<std::size_t>(count));
  }
  // One point per cell of 4x4 pixels within the border of 4: 78 x 58.
  EXPECT_EQ(select(frame_, 100000).size(), 78U * 58U);
}

TEST_F(PointSelection, SpreadsThePointsAndEveryPrefixOfThem) {
  const PointCloud cloud = select(frame_, 1000);
  ASSERT_EQ(cloud.size(), 1000U);
  for (const std::size_t count : {250U, 500U, 750U, 1000U}) {
    for (const double share : quarters(cloud, count)) {
      // Less than a round through the buckets takes a random part of them: 250 points leave a
      // standard deviation of 2.7 %.
      EXPECT_NEAR(share, 0.25, count < 500 ? 0.08 : 0.04) << count;
    }
  }
}

TEST_F(PointSelection, SpreadsThePointsOfAnUnevenTexture) {
  // The left half has a quarter of the contrast: by gradient alone the right would get all points.
  cv::Mat left = frame_.color.colRange(0, camera_.color.width / 2);
  left.convertTo(left, CV_8U, 0.25, 96);
  const PointCloud cloud = select(frame_, 1000);
  ASSERT_EQ(cloud.size(), 1000U);
  for (const std::size_t count : {500U, 1000U}) {  // whole rounds through the buckets
    for (const double share : quarters(cloud, count)) EXPECT_NEAR(share, 0.25, 0.05) << count;
  }
}

TEST_F(PointSelection, TakesNoPlaceTwice) {
  const PointCloud cloud = select(frame_, 3000);
  std::vector<std::pair<float, float>> pixels;
  for (std::size_t i = 0; i < cloud.size(); ++i) pixels.emplace_back(cloud.u[i], cloud.v[i]);
  std::sort(pixels.begin(), pixels.end());
  EXPECT_EQ(std::adjacent_find(pixels.begin(), pixels.end()), pixels.end());
}

TEST_F(PointSelection, BackProjectsExactly) {
  camera_.color.distortion = {0.1, -0.2, 0.001, 0.002, 0.05};
  frame_.depth = depth_image(camera_, [](int u, int v) { return 1 + 1e-3 * u + 2e-3 * v; });
  const PointCloud cloud = select(frame_, 2000);
  ASSERT_GT(cloud.size(), 1000U);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const int u = static_cast<int>(cloud.u[i]);
    const int v = static_cast<int>(cloud.v[i]);
    const double z = frame_.depth.at<std::uint16_t>(v, u) / camera_.depth_scale;
    const Vector3 expected = z * camera_.color.unproject({u, v});
    // Single precision of coordinates below 2 m.
    EXPECT_LT((cloud.position(i) - expected).norm(), 3e-7);
  }
}

TEST_F(PointSelection, TakesDepthInRangeAlone) {
  // 0.1 m on the left to 8 m on the right.
  frame_.depth = depth_image(camera_, [](int u, int) { return 0.1 + 0.025 * u; });
  options_.max_depth_step = 0.5;
  const PointCloud cloud = select(frame_, 100000);
  ASSERT_GT(cloud.size(), 1000U);
  const auto [nearest, farthest] = std::minmax_element(cloud.z.begin(), cloud.z.end());
  EXPECT_GE(*nearest, 0.3F);
  EXPECT_LE(*farthest, 6.0F);
  EXPECT_LT(*nearest, 0.6F);
  EXPECT_GT(*farthest, 5.8F);
}

TEST_F(PointSelection, AvoidsDiscontinuitiesOfDepth) {
  constexpr int kEdge = 161;  // first column of the farther surface
  frame_.depth = depth_image(camera_, [](int u, int) { return u < kEdge ? 1.0 : 1.2; });
  const PointCloud cloud = select(frame_, 100000);
  ASSERT_GT(cloud.size(), 1000U);
  for (const float u : cloud.u) {
    EXPECT_TRUE(u < kEdge - 2 || u >= kEdge + 2) << u;
  }
  // A smaller step than max_depth_step is a slant.
  frame_.depth = depth_image(camera_, [](int u, int) { return u < kEdge ? 1.0 : 1.04; });
  EXPECT_GT(select(frame_, 100000).size(), cloud.size());
}

TEST_F(PointSelection, AvoidsTheRimOfMissingDepth) {
  options_.max_depth_step = 10;  // missing depth is no step
  const cv::Rect hole(100, 80, 40, 30);
  frame_.depth(hole).setTo(0);
  const cv::Rect rim(hole.x - 2, hole.y - 2, hole.width + 4, hole.height + 4);
  const PointCloud cloud = select(frame_, 100000);
  ASSERT_GT(cloud.size(), 1000U);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    EXPECT_FALSE(rim.contains({static_cast<int>(cloud.u[i]), static_cast<int>(cloud.v[i])}));
  }
}

TEST_F(PointSelection, FeaturesAreTheColoursOfThePixel) {
  const PointCloud cloud = select(frame_, 500);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const auto& pixel =
        frame_.color.at<cv::Vec3b>(static_cast<int>(cloud.v[i]), static_cast<int>(cloud.u[i]));
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(cloud.features[static_cast<std::size_t>(c)][i], static_cast<float>(pixel[c]));
    }
  }
}

/// 64x48 pixels with grey level 3 u + v: at most 236.
cv::Mat ramp(int type) {
  cv::Mat image(48, 64, type);
  const int channels = image.channels();
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols * channels; ++u) {
      image.ptr<std::uint8_t>(v)[u] = static_cast<std::uint8_t>(3 * (u / channels) + v);
    }
  }
  return image;
}

TEST_F(PointSelection, GradientsOfARampAreItsSlopes) {
  camera_ = small_camera(64, 48);
  frame_ = noise_frame(camera_, 1);
  for (const int type : {CV_8UC3, CV_8UC1}) {
    frame_.color = ramp(type);
    const PointCloud cloud = select(frame_, 1000);
    ASSERT_GT(cloud.size(), 50U);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      EXPECT_EQ(cloud.features[3][i], 3.0F);
      EXPECT_EQ(cloud.features[4][i], 1.0F);
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(cloud.features[c][i], 3 * cloud.u[i] + cloud.v[i]);
      }
    }
  }
}

TEST_F(PointSelection, LeavesOutWeakGradients) {
  camera_ = small_camera(64, 48);
  frame_ = noise_frame(camera_, 1);
  frame_.color = ramp(CV_8UC1);  // its gradient is sqrt(10) = 3.16
  options_.min_gradient = 3.1;
  EXPECT_GT(select(frame_, 1000).size(), 50U);
  options_.min_gradient = 3.2;
  EXPECT_EQ(select(frame_, 1000).size(), 0U);
  options_.min_gradient = 0;
  frame_.color.setTo(128);
  EXPECT_EQ(select(frame_, 1000).size(), 0U) << "a blank image";
}

TEST_F(PointSelection, TakesWeakGradientsWhereStrongOnesAreFew) {
  camera_ = small_camera(64, 48);
  frame_ = noise_frame(camera_, 1);
  options_.min_gradient = 4;
  options_.weak_gradient = 3;
  options_.few_pixels = 20;
  cv::Mat weak = ramp(CV_8UC1);  // its gradient is sqrt(10) = 3.16
  frame_.color = weak;
  EXPECT_GT(select(frame_, 1000).size(), 50U);
  options_.weak_gradient = 3.2;
  EXPECT_EQ(select(frame_, 1000).size(), 0U);
  options_.weak_gradient = 3;
  weak.rowRange(0, weak.rows / 2) *= 2;
  const std::size_t strong = select(frame_, 1000).size();
  EXPECT_GT(strong, 20U);
  options_.few_pixels = 1000;
  EXPECT_GT(select(frame_, 1000).size(), strong);
}

TEST_F(PointSelection, EdgesTakesPixelsOnEdgesAlone) {
  camera_ = small_camera(64, 48);
  frame_ = noise_frame(camera_, 1);
  frame_.color = ramp(CV_8UC1);  // a gradient, but no edge
  constexpr int kEdge = 30;      // first brighter column
  frame_.color.colRange(kEdge, 64) += 60;
  EXPECT_GT(select(frame_, 1000).size(), 100U);
  options_.method = SelectionMethod::kEdges;
  const PointCloud cloud = select(frame_, 1000);
  EXPECT_GE(cloud.size(), 8U) << "one a cell along the edge";
  for (const float u : cloud.u) EXPECT_NEAR(u, kEdge - 0.5, 1.5);
}

TEST_F(PointSelection, OfAnImageOfCellSizeIsEmpty) {
  camera_ = small_camera(8, 8);
  EXPECT_TRUE(select(noise_frame(camera_, 1), 100).empty());
}

TEST_F(PointSelection, IsDeterministic) {
  const PointCloud a = select(frame_, 1000);
  const PointCloud b = select(frame_, 1000);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.u, b.u);
  EXPECT_EQ(a.v, b.v);
  EXPECT_EQ(a.features, b.features);
}

TEST(CheckImages, SaysWhatIsWrong) {
  const Camera camera = small_camera();
  const auto problem_of = [&](const auto& change) {
    RgbdFrame frame = noise_frame(camera, 1);
    change(frame);
    return check_images(frame, camera);
  };
  EXPECT_EQ(problem_of([](auto&) {}), "");
  EXPECT_EQ(problem_of([](auto& f) { f.color = cv::Mat(240, 320, CV_8UC1); }), "");
  EXPECT_EQ(problem_of([](auto& f) { f.problem = "cannot read a.png"; }), "cannot read a.png");
  EXPECT_EQ(problem_of([](auto& f) { f.color.release(); }), "the colour image is empty");
  EXPECT_EQ(problem_of([](auto& f) { f.depth.release(); }), "the depth image is empty");
  for (const int type : {CV_16UC3, CV_8UC4, CV_32FC1, CV_8UC2}) {
    EXPECT_EQ(problem_of([type](auto& f) { f.color = cv::Mat(240, 320, type); }),
              "the colour image must have 8 bits and 1 or 3 channels");
  }
  for (const int type : {CV_8UC1, CV_16SC1, CV_32FC1, CV_16UC3}) {
    EXPECT_EQ(problem_of([type](auto& f) { f.depth = cv::Mat(240, 320, type); }),
              "the depth image must have 16 bits and 1 channel");
  }
  EXPECT_EQ(problem_of([](auto& f) { f.color = cv::Mat(240, 319, CV_8UC3); }),
            "the colour image has 319x240 pixels, the camera 320x240");
  EXPECT_EQ(problem_of([](auto& f) { f.depth = cv::Mat(480, 640, CV_16UC1); }),
            "the depth image has 640x480 pixels, the camera 320x240");
}

}  // namespace
}  // namespace cvo_slam
