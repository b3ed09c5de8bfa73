// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/loop/orb_features.h"

#include <cmath>
#include <set>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/tests/loop/poster_frames.h"

namespace cvo_slam {
namespace {

const Camera kCamera = Poster::camera();
const RgbdFrame kFrame = Poster(1).frame(0, 100, 100);

/// Returns the number of cells of a grid that have a feature.
std::size_t covered_cells(const OrbFeatures& features, int columns, int rows) {
  std::set<std::pair<int, int>> cells;
  for (const OrbFeature& point : features.points) {
    cells.emplace(static_cast<int>(point.u) * columns / 320,
                  static_cast<int>(point.v) * rows / 240);
  }
  return cells.size();
}

TEST(OrbFeatures, AreAsManyAsAskedForAndKnowWhereTheyAre) {
  const OrbFeatures features = extract_orb(kFrame, kCamera, {.features = 200});
  EXPECT_EQ(features.size(), 200U);
  EXPECT_EQ(features.descriptors.size(), features.size());
  for (const OrbFeature& point : features.points) {
    ASSERT_TRUE(point.has_depth());
    const Eigen::Vector2d seen = kCamera.color.project(point.position());
    EXPECT_NEAR(seen.x(), point.u, 1e-3);
    EXPECT_NEAR(seen.y(), point.v, 1e-3);
    EXPECT_FLOAT_EQ(point.depth, 1);
    EXPECT_GE(point.size, 1);
  }
}

TEST(OrbFeatures, SameImageGivesTheSame) {
  const OrbFeatures first = extract_orb(kFrame, kCamera);
  const OrbFeatures second = extract_orb(kFrame, kCamera);
  EXPECT_EQ(first.descriptors, second.descriptors);
}

/// OpenCV alone keeps the corners with the strongest response: if one half of an image has more
/// contrast, all corners are in that half.
TEST(OrbFeatures, AreSpreadOverTheImage) {
  RgbdFrame frame = kFrame;
  frame.color = kFrame.color.clone();
  cv::Mat right = frame.color(cv::Rect(160, 0, 160, 240));
  right.convertTo(right, -1, 0.6, 50);
  const OrbFeatures features = extract_orb(frame, kCamera, {.features = 150});
  int in_right = 0;
  for (const OrbFeature& point : features.points) in_right += point.u >= 160 ? 1 : 0;
  EXPECT_GT(in_right, 50);
  // 28 cells of 40 by 40 pixels are clear of the border of 31 pixels.
  EXPECT_GE(covered_cells(features, 8, 6), 28U);
}

/// A plain wall beside a poster: the threshold for corners is lower in cells without corners.
TEST(OrbFeatures, WeakCornersAreTakenInEmptyCells) {
  RgbdFrame frame = kFrame;
  frame.color = kFrame.color.clone();
  cv::Mat right = frame.color(cv::Rect(160, 0, 160, 240));
  right.convertTo(right, -1, 0.075, 110);  // differences of at most 19 grey levels
  const OrbOptions with = {.features = 1000, .low_threshold = 3};
  const OrbOptions without = {.features = 1000, .low_threshold = 20};
  const auto count = [&](const OrbOptions& options) {
    int in_right = 0;
    for (const OrbFeature& point : extract_orb(frame, kCamera, options).points) {
      in_right += point.u >= 192 ? 1 : 0;
    }
    return in_right;
  };
  EXPECT_LT(count(without), 5);
  EXPECT_GT(count(with), 50);
}

TEST(OrbFeatures, DepthIsUnknownAtEdgesAndHoles) {
  RgbdFrame frame = kFrame;
  frame.depth = kFrame.depth.clone();
  // Alternating near and far stripes of 20 pixels; no depth on the right.
  for (int u = 0; u < 320; u += 40) {
    frame.depth(cv::Rect(u, 0, 20, 240)).setTo(2 * kCamera.depth_scale);
  }
  frame.depth(cv::Rect(240, 0, 80, 240)).setTo(0);
  int at_edges = 0;
  for (const OrbFeature& point : extract_orb(frame, kCamera).points) {
    const auto u = static_cast<int>(std::lround(point.u));
    const bool at_edge = (u % 20 == 0 || u % 20 == 19) && u != 239;  // beyond is no depth
    if (u >= 240 || at_edge) {
      EXPECT_FALSE(point.has_depth()) << u;
      at_edges += at_edge ? 1 : 0;
    } else {
      EXPECT_FLOAT_EQ(point.depth, u % 40 < 20 ? 2 : 1) << u;
    }
  }
  EXPECT_GT(at_edges, 0);
}

TEST(OrbFeatures, AnUnusableImageHasNone) {
  RgbdFrame frame = kFrame;
  frame.color = cv::Mat();
  EXPECT_TRUE(extract_orb(frame, kCamera).empty());
  frame.color = cv::Mat(240, 320, CV_8UC3, cv::Scalar(90, 90, 90));  // blank
  EXPECT_TRUE(extract_orb(frame, kCamera).empty());
  frame.color = cv::Mat(40, 40, CV_8UC3, cv::Scalar(90, 90, 90));  // too small for a descriptor
  EXPECT_TRUE(extract_orb(frame, kCamera).empty());
  frame.color = cv::Mat(240, 320, CV_32FC1, cv::Scalar(1));
  EXPECT_TRUE(extract_orb(frame, kCamera).empty());
}

TEST(OrbFeatures, WithoutADepthImageNoneHasADepth) {
  for (const cv::Mat& depth : {cv::Mat(), cv::Mat(120, 160, CV_16UC1, cv::Scalar(5000)),
                               cv::Mat(240, 320, CV_32FC1, cv::Scalar(1))}) {
    RgbdFrame frame = kFrame;
    frame.depth = depth;
    const OrbFeatures features = extract_orb(frame, kCamera, {.features = 50});
    EXPECT_EQ(features.size(), 50U);
    for (const OrbFeature& point : features.points) EXPECT_FALSE(point.has_depth());
  }
}

TEST(OrbFeatures, GreyImagesAreAccepted) {
  RgbdFrame frame = kFrame;
  cv::cvtColor(kFrame.color, frame.color, cv::COLOR_BGR2GRAY);
  EXPECT_EQ(extract_orb(frame, kCamera).descriptors, extract_orb(kFrame, kCamera).descriptors);
}

}  // namespace
}  // namespace cvo_slam
