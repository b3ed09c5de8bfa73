// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/loop/feature_matching_internal.h"
#include "cvo_slam/tests/loop/descriptor_samples.h"

namespace cvo_slam {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class FeatureMatching : public testing::Test {
 protected:
  /// Features of the given descriptors, all in node 0.
  static OrbFeatures features_of(const std::vector<Descriptor>& descriptors) {
    OrbFeatures features;
    features.descriptors = descriptors;
    features.points.resize(descriptors.size());
    return features;
  }
  static std::vector<NodeFeature> in_one_node(std::uint32_t count) {
    std::vector<NodeFeature> nodes;
    for (std::uint32_t i = 0; i < count; ++i) nodes.push_back({0, i});
    return nodes;
  }

  DescriptorSource source_{1};
  std::vector<Descriptor> kinds_ = source_.random(4);
  MatchingOptions options_;
};

TEST_F(FeatureMatching, NearestBothWaysMatch) {
  const OrbFeatures a = features_of({kinds_[0], kinds_[1], kinds_[2]});
  const OrbFeatures b =
      features_of({source_.near(kinds_[2], 9), source_.near(kinds_[0], 9), kinds_[3]});
  EXPECT_THAT(match_by_nodes(a, in_one_node(3), b, in_one_node(3), options_),
              ElementsAre(FeatureMatch{0, 1}, FeatureMatch{2, 0}));
}

TEST_F(FeatureMatching, ASecondSimilarFeatureMakesAMatchAmbiguous) {
  const OrbFeatures a = features_of({kinds_[0]});
  const OrbFeatures b = features_of({source_.near(kinds_[0], 10), source_.near(kinds_[0], 10)});
  EXPECT_THAT(match_by_nodes(a, in_one_node(1), b, in_one_node(2), options_), IsEmpty());
  // The other direction.
  EXPECT_THAT(match_by_nodes(b, in_one_node(2), a, in_one_node(1), options_), IsEmpty());
}

TEST_F(FeatureMatching, OnlyFeaturesOfOneNodeAreCompared) {
  const OrbFeatures a = features_of({kinds_[0], kinds_[1]});
  const OrbFeatures b = features_of({kinds_[0], kinds_[1]});
  EXPECT_THAT(match_by_nodes(a, {{1, 1}, {3, 0}}, b, {{1, 1}, {2, 0}}, options_),
              ElementsAre(FeatureMatch{1, 1}));
  EXPECT_THAT(match_by_nodes(a, {{1, 1}, {3, 0}}, b, {}, options_), IsEmpty());
}

TEST_F(FeatureMatching, TheCommonRotationIsKept) {
  OrbFeatures a = features_of(source_.random(8));
  OrbFeatures b = a;
  // Six features rotate by about -0.1 rad, across the zero of the angle; two rotate otherwise.
  const std::vector<float> turns = {-0.05F, -0.1F, -0.1F, -0.15F, 0.1F, -0.2F, 1.5F, 3.1F};
  std::vector<FeatureMatch> matches;
  for (std::uint32_t i = 0; i < 8; ++i) {
    a.points[i].angle = 0.7F * static_cast<float>(i);
    b.points[i].angle = std::fmod(a.points[i].angle + turns[i] + 6.2831853F, 6.2831853F);
    matches.push_back({i, i});
  }
  const auto kept = keep_common_rotation(a, b, matches, options_);
  EXPECT_THAT(kept, testing::ElementsAreArray(matches.begin(), matches.begin() + 6));
  EXPECT_THAT(keep_common_rotation(a, b, {}, options_), IsEmpty());
}

TEST_F(FeatureMatching, AKnownPoseLimitsTheSearch) {
  const PinholeCamera camera;
  OrbFeatures a = features_of({kinds_[0], kinds_[1], kinds_[2]});
  for (auto& point : a.points) point.depth = 2;
  a.points[1].x = 0.2F;
  a.points[2].x = 5;  // outside the image of b
  OrbFeatures b = features_of({kinds_[1], kinds_[0], kinds_[0]});
  b.points[0].x = 0.2F + 6 / 525.0F;  // within the 8 pixels
  b.points[1].x = 0.1F;               // the right descriptor in the wrong place
  b.points[2].y = -3 / 525.0F;
  const ProjectionMatches found = match_by_projection(a, b, SE3(), camera, options_);
  EXPECT_EQ(found.visible.size(), 2U);
  EXPECT_THAT(found.matches, ElementsAre(FeatureMatch{0, 2}, FeatureMatch{1, 0}));
  // With the camera half a metre to the right, no feature is near its projection.
  const SE3 aside(Matrix3::Identity(), {0.5, 0, 0});
  EXPECT_THAT(match_by_projection(a, b, aside, camera, options_).matches, IsEmpty());
}

}  // namespace
}  // namespace cvo_slam
