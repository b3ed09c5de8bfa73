// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/loop/loop_detector.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/loop/vocabulary.h"
#include "cvo_slam/tests/loop/poster_frames.h"

namespace cvo_slam {
namespace {

using testing::IsEmpty;

/// A walk along a poster and back: keyframe i of 40 looks at 50 i pixels, and then at
/// 50 (79 - i) pixels, shifted by (7, 3).
class LoopDetectorWalk : public testing::Test {
 protected:
  static constexpr std::size_t kTurn = 40;

  [[nodiscard]] RgbdFrame frame(std::size_t i) const {
    const auto step = static_cast<int>(i < kTurn ? i : 2 * kTurn - 1 - i);
    return i < kTurn ? poster_.frame(10 * i, 50 * step, 100)
                     : poster_.frame(10 * i, 50 * step + 7, 103);
  }

  Poster poster_{1};
  LoopDetector detector_{Poster::camera(), options()};

  static LoopOptions options() {
    LoopOptions options;
    options.orb.features = 500;
    options.verification.min_visible_share = 0.1;
    return options;
  }
};

TEST_F(LoopDetectorWalk, ThePlaceIsFoundOnTheWayBackAndNotBefore) {
  int found = 0;
  for (std::size_t i = 0; i < 2 * kTurn; ++i) {
    const auto appearance = detector_.extract(frame(i));
    EXPECT_EQ(appearance->id, 10 * i);
    for (const LoopMatch& match : detector_.find_loops(*appearance)) {
      EXPECT_EQ(match.query, 10 * i);
      EXPECT_LE(match.keyframe + 150, 10 * i);  // the temporal exclusion
      if (!match.verification.accepted) {
        EXPECT_NE(match.verification.reason, "");
        continue;
      }
      // Any keyframe that sees a part of the same scene may be found.
      const auto older = static_cast<int>(match.keyframe / 10);
      const int shift = 50 * static_cast<int>(2 * kTurn - 1 - i) + 7 - 50 * older;
      EXPECT_GE(i, kTurn);
      const Vector3 truth(Poster::metres(shift), Poster::metres(3), 0);
      EXPECT_LT((match.verification.T_a_b.translation() - truth).norm(), 0.01);
      EXPECT_LT(match.verification.T_a_b.angle(), 0.01);
      EXPECT_GT(match.score, 0);
      EXPECT_GT(match.shared_words, 0);
      found += shift == 7 ? 1 : 0;
    }
    detector_.add(appearance);
  }
  EXPECT_EQ(detector_.size(), 2 * kTurn);
  // From keyframe 48 on the same place is 17 keyframes ago and older.
  EXPECT_GE(found, 25);
}

TEST_F(LoopDetectorWalk, RelocalisationFindsAnyKeyframe) {
  for (std::size_t i = 0; i < 20; ++i) detector_.add(detector_.extract(frame(i)));
  const auto newest = detector_.extract(poster_.frame(999, 50 * 19 + 11, 100));
  EXPECT_THAT(detector_.find_loops(*newest),
              testing::Each(testing::Field(&LoopMatch::keyframe, testing::Le(40U))));
  const auto matches = detector_.relocalize(*newest);
  ASSERT_FALSE(matches.empty());
  EXPECT_TRUE(matches[0].verification.accepted) << matches[0].verification.reason;
  EXPECT_EQ(matches[0].keyframe, 190U);
  const auto elsewhere = detector_.extract(Poster(2).frame(1000, 0, 0));
  for (const auto& match : detector_.relocalize(*elsewhere)) {
    EXPECT_FALSE(match.verification.accepted);
  }
}

TEST_F(LoopDetectorWalk, FramesWithoutFeaturesHarmNothing) {
  const RgbdFrame nothing;
  const auto empty = detector_.extract(nothing);
  EXPECT_TRUE(empty->features.empty());
  EXPECT_THAT(detector_.find_loops(*empty), IsEmpty());
  EXPECT_THAT(detector_.relocalize(*empty), IsEmpty());
  for (std::size_t i = 0; i < 2 * kTurn; ++i) {
    const bool blank = i % 3 == 0;
    const auto appearance = blank ? empty : detector_.extract(frame(i));
    if (blank) {
      EXPECT_THAT(detector_.find_loops(*appearance), IsEmpty());
    }
    detector_.add(appearance);
  }
  EXPECT_FALSE(detector_.relocalize(*detector_.extract(frame(10))).empty());
}

TEST_F(LoopDetectorWalk, ResultsAreReproducible) {
  LoopDetector other(Poster::camera(), options());
  for (std::size_t i = 0; i < 2 * kTurn; i += 2) {
    const auto a = detector_.extract(frame(i));
    const auto b = other.extract(frame(i));
    const auto found_a = detector_.find_loops(*a);
    const auto found_b = other.find_loops(*b);
    ASSERT_EQ(found_a.size(), found_b.size());
    for (std::size_t k = 0; k < found_a.size(); ++k) {
      EXPECT_EQ(found_a[k].keyframe, found_b[k].keyframe);
      EXPECT_EQ(found_a[k].score, found_b[k].score);
      EXPECT_EQ(found_a[k].verification.T_a_b.matrix(), found_b[k].verification.T_a_b.matrix());
      EXPECT_EQ(found_a[k].verification.reason, found_b[k].verification.reason);
    }
    detector_.add(a);
    other.add(b);
  }
}

TEST_F(LoopDetectorWalk, MemoryOfAKeyframeIsAsDocumented) {
  const std::size_t before = detector_.bytes();
  for (std::size_t i = 0; i < 20; ++i) detector_.add(detector_.extract(frame(i)));
  // 40 of the feature itself, 8 each of its word, its node and its entry in the index.
  const double a_feature = static_cast<double>(detector_.bytes() - before) / 20 / 500;
  EXPECT_GT(a_feature, 40 + 8);
  EXPECT_LT(a_feature, 80);
}

TEST(LoopDetector, BadOptionsAndCamerasAreRefused) {
  LoopOptions options;
  options.candidates.candidates = 0;
  EXPECT_THROW(LoopDetector(Camera(), options), OptionError);
  Camera camera;
  camera.color.fx = 0;
  EXPECT_THROW(LoopDetector(camera, LoopOptions()), OptionError);
}

TEST(LoopOptions, DefaultsAreInRange) {
  LoopOptions options;
  EXPECT_NO_THROW(describe(options).check());
}

TEST(BuiltinVocabulary, HasTheWordsOfItsTraining) {
  EXPECT_GT(builtin_vocabulary()->words(), 50000U);
}

}  // namespace
}  // namespace cvo_slam
