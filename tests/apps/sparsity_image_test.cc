// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/sparsity_image.h"

#include <cmath>

#include <gtest/gtest.h>

namespace cvo_slam {
namespace {

TEST(RanksAlongCurve, NeighboursOnTheCurveAreNeighboursInTheImage) {
  // All pixels of a square: the curve goes through each, one step at a time.
  constexpr int kSide = 16;
  std::vector<Eigen::Vector2d> pixels;
  for (int v = 0; v < kSide; ++v) {
    for (int u = 0; u < kSide; ++u) pixels.emplace_back(u, v);
  }
  const auto ranks = ranks_along_curve(pixels);
  std::vector<Eigen::Vector2d> curve(pixels.size(), {-1, -1});
  for (std::size_t i = 0; i < pixels.size(); ++i) curve.at(ranks[i]) = pixels[i];
  for (std::size_t i = 1; i < curve.size(); ++i) {
    EXPECT_EQ((curve[i] - curve[i - 1]).lpNorm<1>(), 1) << i;
  }
}

TEST(RanksAlongCurve, PixelsBeyondTheImageAreOnItsEdge) {
  EXPECT_EQ(ranks_along_curve({{-1e9, -5}, {1, 0}}), (std::vector<std::size_t>{0, 1}));
  EXPECT_TRUE(ranks_along_curve({}).empty());
}

TEST(DrawSparsity, ADiagonalMatrixIsADiagonal) {
  std::vector<KernelEntry> entries;
  std::vector<std::size_t> ranks;
  for (std::uint32_t i = 0; i < 10; ++i) {
    entries.push_back({i, i, 1, 1});
    ranks.push_back(9 - i);  // the same order for both
  }
  const cv::Mat image = draw_sparsity(entries, ranks, ranks, {10, 10});
  for (int row = 0; row < 10; ++row) {
    for (int column = 0; column < 10; ++column) {
      EXPECT_EQ(image.at<cv::Vec3b>(row, column)[0], row == column ? 0 : 255);
    }
  }
}

TEST(DrawSparsity, PixelsAreDarkerTheMoreEntriesTheyHold) {
  // The upper left quarter of the four by four entries is full; the lower right one has one entry.
  std::vector<KernelEntry> entries = {{2, 2, 1, 1}};
  for (std::uint32_t i = 0; i < 2; ++i) {
    for (std::uint32_t j = 0; j < 2; ++j) entries.push_back({i, j, 1, 1});
  }
  const std::vector<std::size_t> ranks = {0, 1, 2, 3};
  const cv::Mat image = draw_sparsity(entries, ranks, ranks, {2, 2});
  EXPECT_EQ(image.at<cv::Vec3b>(0, 0)[0], 0);
  EXPECT_EQ(image.at<cv::Vec3b>(0, 1)[0], 255);
  EXPECT_GT(image.at<cv::Vec3b>(1, 1)[0], 100);
  EXPECT_LT(image.at<cv::Vec3b>(1, 1)[0], 200);
}

TEST(DrawSparsity, OfNothingIsWhite) {
  EXPECT_EQ(draw_sparsity({}, {}, {}, {3, 3}).at<cv::Vec3b>(1, 1), cv::Vec3b(255, 255, 255));
}

}  // namespace
}  // namespace cvo_slam
