// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/loop/compact_features_internal.h"
#include "cvo_slam/tests/loop/poster_frames.h"

namespace cvo_slam {
namespace {

const Camera kPosterCamera = Poster::camera();

OrbFeatures poster_features(int count) {
  return extract_orb(Poster(1).frame(0, 100, 100), kPosterCamera, {.features = count});
}

TEST(CompactFeatures, AreThoseThatWentInButForTheRounding) {
  const OrbFeatures features = poster_features(200);
  const OrbFeatures again = CompactFeatures(features).features(kPosterCamera.color);
  ASSERT_EQ(again.size(), features.size());
  EXPECT_EQ(again.descriptors, features.descriptors);
  for (std::size_t i = 0; i < features.size(); ++i) {
    const OrbFeature& a = features.points[i];
    const OrbFeature& b = again.points[i];
    EXPECT_NEAR(a.u, b.u, 0.04) << i;
    EXPECT_NEAR(a.v, b.v, 0.04) << i;
    EXPECT_NEAR(a.x, b.x, 0.04 / kPosterCamera.color.fx) << i;
    EXPECT_NEAR(std::remainder(a.angle - b.angle, 2 * std::numbers::pi_v<float>), 0, 0.013) << i;
    EXPECT_NEAR(a.depth, b.depth, 0.0005 * a.depth) << i;
    EXPECT_EQ(a.size, b.size) << i;
  }
}

// A map that is saved in the middle of a sequence goes on bit for bit: what is in memory is what
// its file says.
TEST(CompactFeatures, AreTheSameAfterTheirBytes) {
  const CompactFeatures features(poster_features(200));
  const std::string bytes = features.to_bytes();
  const CompactFeatures again = CompactFeatures::from_bytes(bytes);
  EXPECT_EQ(again.to_bytes(), bytes);
  EXPECT_EQ(CompactFeatures(again.features(kPosterCamera.color)).to_bytes(), bytes);
  EXPECT_LT(static_cast<double>(bytes.size()), 41.0 * 200);
}

TEST(CompactFeatures, AnUnknownDepthStaysUnknown) {
  OrbFeatures features = poster_features(20);
  features.points[3].depth = 0;
  features.points[4].depth = 1e6F;  // more than the rounded number can be
  const OrbFeatures again = CompactFeatures(features).features(kPosterCamera.color);
  EXPECT_FALSE(again.points[3].has_depth());
  EXPECT_GT(again.points[4].depth, 6e4F);
  EXPECT_TRUE(std::isfinite(again.points[4].depth));
}

TEST(CompactFeatures, LargeImagesHaveCoarserPixels) {
  OrbFeatures features = poster_features(20);
  features.points[3].u = 8000.3F;
  const OrbFeatures again = CompactFeatures(features).features(kPosterCamera.color);
  EXPECT_NEAR(again.points[3].u, 8000.3F, 0.07);
  EXPECT_NEAR(again.points[4].v, features.points[4].v, 0.07);
}

TEST(CompactFeatures, DamagedBytesAreErrors) {
  const std::string bytes = CompactFeatures(poster_features(20)).to_bytes();
  EXPECT_THROW(std::ignore = CompactFeatures::from_bytes(bytes.substr(1)), DataError);
  EXPECT_THROW(std::ignore = CompactFeatures::from_bytes(""), DataError);
  std::string sizes = bytes;
  sizes.replace(12, 4, std::string(4, '\0'));  // a size of 0
  EXPECT_THROW(std::ignore = CompactFeatures::from_bytes(sizes), DataError);
  EXPECT_TRUE(CompactFeatures::from_bytes(CompactFeatures().to_bytes()).descriptors().empty());
}

}  // namespace
}  // namespace cvo_slam
