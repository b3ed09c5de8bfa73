// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/loop/loop_verifier.h"

#include <algorithm>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/tests/loop/descriptor_samples.h"
#include "cvo_slam/tests/loop/point_pairs.h"

namespace cvo_slam {
namespace {

using testing::HasSubstr;

const SE3 kTruth = SE3::exp((Vector6() << 0.1, -0.05, 0.1, 0.05, -0.1, 0.1).finished());
const Camera kCamera;

/// Two images with `common` features of the same points and `others` that only one of them has.
struct Views {
  Views(int common, int others, const SE3& T_a_b = kTruth, unsigned seed = 1) {
    PairSource pairs(kCamera, T_a_b, seed);
    DescriptorSource descriptors(seed);
    for (int i = 0; i < common; ++i) {
      const PointPair pair = pairs.inlier(0.7, 0.002);
      const Descriptor descriptor = descriptors.random();
      add(a, pair.a, descriptor);
      add(b, pair.b, descriptors.near(descriptor, 20));
    }
    for (int i = 0; i < others; ++i) {
      add(a, pairs.inlier(0, 0).a, descriptors.random());
      add(b, pairs.inlier(0, 0).b, descriptors.random());
    }
    a.id = 3;
    b.id = 70;
  }

  static void add(Appearance& view, const OrbFeature& feature, const Descriptor& descriptor) {
    view.words.nodes.push_back({0, static_cast<std::uint32_t>(view.features.size())});
    view.features.points.push_back(feature);
    view.features.descriptors.push_back(descriptor);
  }

  Appearance a;
  Appearance b;
};

TEST(LoopVerifier, FindsThePoseOfACommonPlace) {
  const Views views(200, 200);
  const Verification result = LoopVerifier(kCamera).verify(views.a, views.b);
  EXPECT_TRUE(result.accepted) << result.reason;
  EXPECT_EQ(result.reason, "");
  const Vector6 error = (kTruth.inverse() * result.T_a_b).log();
  EXPECT_LT(error.head<3>().norm(), 0.005);
  EXPECT_LT(error.tail<3>().norm(), 0.003);
  // Chi-square with six degrees of freedom exceeds 30 in one case of 20,000.
  EXPECT_LT(error.dot(result.information * error), 30);
  EXPECT_GE(result.matches, 190U);
  EXPECT_GE(result.inliers, 190U);
  EXPECT_EQ(result.pixels.size(), result.inliers);
  // Half of the features that should be visible are inliers.
  EXPECT_NEAR(result.inlier_share, 0.5, 0.06);
  EXPECT_GT(result.coverage, 0.8);
}

TEST(LoopVerifier, SameImagesGiveTheSameAnswer) {
  const Views views(100, 200);
  const LoopVerifier verifier(kCamera);
  const Verification first = verifier.verify(views.a, views.b);
  const Verification second = verifier.verify(views.a, views.b);
  EXPECT_EQ(first.T_a_b.matrix(), second.T_a_b.matrix());
  EXPECT_EQ(first.information, second.information);
}

TEST(LoopVerifier, UnrelatedImagesAreRejectedWithAReason) {
  const Views views(0, 400);
  const Verification result = LoopVerifier(kCamera).verify(views.a, views.b);
  EXPECT_FALSE(result.accepted);
  EXPECT_THAT(result.reason, HasSubstr("features match; 12 needed"));
}

TEST(LoopVerifier, MatchesWithoutACommonPoseAreRejected) {
  Views views(100, 100);
  // The points of b are permuted, so that they agree with no pose.
  auto& points = views.b.features.points;
  std::rotate(points.begin(), points.begin() + 17, points.begin() + 100);
  const Verification result = LoopVerifier(kCamera).verify(views.a, views.b);
  EXPECT_FALSE(result.accepted);
  EXPECT_THAT(result.reason, testing::AnyOf(HasSubstr("inliers of"), HasSubstr("give a pose")));
}

TEST(LoopVerifier, FewCommonFeaturesAmongManyAreRejected) {
  const Views views(40, 600);
  const Verification result = LoopVerifier(kCamera).verify(views.a, views.b);
  EXPECT_FALSE(result.accepted);
  EXPECT_THAT(result.reason, HasSubstr("of the features that both should see match"));
}

/// A poster that hangs in two rooms: its features agree with one pose, no other feature does.
TEST(LoopVerifier, ACommonObjectIsNoCommonPlace) {
  Views views(600, 100);
  for (std::size_t i = 0; i < 600; ++i) {
    const OrbFeature& point = views.a.features.points[i];
    const bool on_poster = std::abs(point.u - 320) < 110 && std::abs(point.v - 240) < 110;
    if (!on_poster) views.b.features.descriptors[i] = Descriptor();
  }
  const Verification result = LoopVerifier(kCamera).verify(views.a, views.b);
  EXPECT_FALSE(result.accepted);
  EXPECT_THAT(result.reason, HasSubstr("of the image cells that both should see match"));
}

TEST(LoopVerifier, APoseThatIsNotHeldInEveryDirectionIsRejected) {
  // All points far away: nothing tells how far the camera moved.
  Views far(0, 0);
  PairSource pairs(kCamera, SE3(), 1);
  DescriptorSource descriptors(1);
  for (int i = 0; i < 300; ++i) {
    PointPair pair = pairs.inlier(0.5, 0);
    pair.a.depth = pair.b.depth = 20;
    const Descriptor descriptor = descriptors.random();
    Views::add(far.a, pair.a, descriptor);
    Views::add(far.b, pair.b, descriptor);
  }
  const Verification result = LoopVerifier(kCamera).verify(far.a, far.b);
  EXPECT_FALSE(result.accepted);
  EXPECT_THAT(result.reason, HasSubstr("pose uncertain"));
}

TEST(LoopVerifier, DepthOnOneSideIsEnough) {
  Views views(200, 100);
  for (OrbFeature& point : views.b.features.points) point.depth = 0;
  const Verification result = LoopVerifier(kCamera).verify(views.a, views.b);
  // Features of b without depth cannot be projected into a, so that its visible features are
  // unknown.
  EXPECT_GE(result.inliers, 180U);
  EXPECT_LT((kTruth.inverse() * result.T_a_b).translation().norm(), 0.01);
}

TEST(LoopVerifier, ImagesWithoutFeaturesMatchNothing) {
  const Views views(100, 0);
  const Appearance empty;
  for (const auto& [a, b] :
       {std::pair(&empty, &views.b), std::pair(&views.a, &empty), std::pair(&empty, &empty)}) {
    const Verification result = LoopVerifier(kCamera).verify(*a, *b);
    EXPECT_FALSE(result.accepted);
    EXPECT_THAT(result.reason, HasSubstr("0 features match"));
  }
}

/// The noise of the features comes from the camera: with noise that is twice as large, the same
/// residuals leave the pose twice as uncertain.
TEST(LoopVerifier, TheNoiseIsThatOfTheCamera) {
  Camera noisy = kCamera;
  noisy.noise.pixel *= 2;
  noisy.noise.depth_floor *= 2;
  noisy.noise.depth_quadratic *= 2;
  const Views views(200, 0);
  const Verification exact = LoopVerifier(kCamera).verify(views.a, views.b);
  const Verification coarse = LoopVerifier(noisy).verify(views.a, views.b);
  ASSERT_TRUE(exact.accepted) << exact.reason;
  // A quarter, apart from the few inliers and weights that differ.
  EXPECT_NEAR(coarse.information.trace() / exact.information.trace(), 0.25, 0.05);
}

TEST(LoopVerifier, ACameraWithoutNoiseIsPossible) {
  Camera ideal = kCamera;
  ideal.noise = {.depth_floor = 0, .depth_quadratic = 0, .pixel = 0};
  const Views views(200, 0);
  const Verification result = LoopVerifier(ideal).verify(views.a, views.b);
  EXPECT_TRUE(result.T_a_b.matrix().allFinite());
  EXPECT_TRUE(result.information.allFinite());
}

TEST(LoopVerifier, BadOptionsAreRefused) {
  VerificationOptions options;
  options.min_inliers = -1;
  EXPECT_THROW(LoopVerifier(kCamera, options), OptionError);
}

}  // namespace
}  // namespace cvo_slam
