// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdint>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "cvo_slam/render/renderers_internal.h"
#include "cvo_slam/tests/render/test_scenes.h"

namespace cvo_slam::render {
namespace {

constexpr Color kPaper{250, 240, 230};

/// Splats and triangles over an image of 96 x 64 pixels and its border; every value is a small
/// fraction of a power of two, so that it is exact.
Primitives random_primitives() {
  std::mt19937_64 rng(5);
  const auto draw = [&](int most) {
    return static_cast<float>(rng() % static_cast<unsigned>(most));
  };
  const auto color = [&] {
    return std::array<std::uint8_t, 4>{static_cast<std::uint8_t>(rng()),
                                       static_cast<std::uint8_t>(rng()),
                                       static_cast<std::uint8_t>(rng()), 255};
  };
  Primitives primitives;
  for (int i = 0; i < 300; ++i) {
    primitives.splats.push_back({.x = draw(440) / 4 - 6,
                                 .y = draw(300) / 4 - 6,
                                 .depth = draw(1024) / 1024,
                                 .radius = draw(32) / 4,
                                 .slope_x = draw(16) / 8 - 1,
                                 .slope_y = draw(16) / 8 - 1,
                                 .color = color()});
  }
  for (int i = 0; i < 60; ++i) {
    primitives.corners.push_back({.x = draw(440) / 4 - 6,
                                  .y = draw(300) / 4 - 6,
                                  .depth = draw(1024) / 1024,
                                  .color = color()});
  }
  return primitives;
}

// The expected splat of each pixel is found by trying all of them.
TEST(SplatRenderer, DrawsTheNearestSplatOfEachPixel) {
  const auto splats = random_primitives().splats;
  const Raster raster = SplatRenderer().draw({splats, {}}, {96, 64}, kPaper);
  for (int v = 0; v < 64; ++v) {
    for (int u = 0; u < 96; ++u) {
      float depth = 1;
      cv::Vec3b color(kPaper.blue, kPaper.green, kPaper.red);
      for (const Splat& s : splats) {
        const float dx = static_cast<float>(u) - s.x;
        const float dy = static_cast<float>(v) - s.y;
        const float rise = s.slope_x * dx + s.slope_y * dy;
        if (dx * dx + dy * dy + rise * rise > s.radius * s.radius || s.depth >= depth) continue;
        depth = s.depth;
        color = {s.color[0], s.color[1], s.color[2]};
      }
      ASSERT_EQ(raster.depth.at<float>(v, u), depth) << u << " " << v;
      ASSERT_EQ(raster.color.at<cv::Vec3b>(v, u), color) << u << " " << v;
    }
  }
}

TEST(SplatRenderer, ATriangleCoversItsPixelsAndNoOthers) {
  // The lower left half of a square of 8 pixels, its depth from 0.25 at the left to 0.75.
  const std::array<std::uint8_t, 4> red = {0, 0, 255, 255};
  const std::vector<Corner> corners = {{0, 0, 0.25F, red}, {0, 8, 0.25F, red}, {8, 8, 0.75F, red}};
  for (const bool turned : {false, true}) {
    auto triangle = corners;
    if (turned) std::swap(triangle[1], triangle[2]);
    const Raster raster = SplatRenderer().draw({{}, triangle}, {12, 12}, kPaper);
    for (int v = 0; v < 12; ++v) {
      for (int u = 0; u < 12; ++u) {
        const bool inside = u <= v && v <= 8;
        EXPECT_EQ(raster.depth.at<float>(v, u) < 1, inside) << u << " " << v;
        if (inside) {
          EXPECT_NEAR(raster.depth.at<float>(v, u), 0.25 + u / 16.0, 1e-6);
        }
      }
    }
  }
}

/// FNV-1a over all bytes of an image.
std::uint64_t hash_of(const cv::Mat& image) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (int v = 0; v < image.rows; ++v) {
    const auto* row = image.ptr(v);
    for (std::size_t i = 0; i < image.elemSize() * static_cast<std::size_t>(image.cols); ++i) {
      hash = (hash ^ row[i]) * 0x100000001b3ULL;
    }
  }
  return hash;
}

// The pixels are the same on every machine. If drawing is changed on purpose, the message of the
// failure has the new values.
TEST(SplatRenderer, GoldenPicture) {
  const Raster raster = SplatRenderer().draw(random_primitives(), {96, 64}, kPaper);
  EXPECT_EQ(hash_of(raster.color), 9960269797441616321ULL);
  EXPECT_EQ(hash_of(raster.depth), 17145607247441969016ULL);
}

TEST(SplatRenderer, ValuesThatAreNotFiniteDrawNothing) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  Primitives primitives;
  for (const float bad : {nan, inf, -inf, 1e30F}) {
    primitives.splats.push_back({.x = bad, .y = 3, .depth = 0.5F, .radius = 2});
    primitives.splats.push_back({.x = 3, .y = 3, .depth = nan, .radius = 2});
    for (const float x : {bad, 1.0F, 2.0F}) primitives.corners.push_back({.x = x, .y = bad});
  }
  const Raster raster = SplatRenderer().draw(primitives, {8, 8}, kPaper);
  EXPECT_EQ(cv::countNonZero(raster.depth != 1), 0);
}

}  // namespace
}  // namespace cvo_slam::render
