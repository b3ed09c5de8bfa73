// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/loop/candidate_groups_internal.h"
#include "cvo_slam/loop/loop_detector.h"

namespace cvo_slam {
namespace {

using testing::ElementsAre;
using testing::Field;
using testing::IsEmpty;

/// Returns a bag of about every fourth word, with weights that sum to 1.
BagOfWords random_bag(std::mt19937& engine, WordId words) {
  BagOfWords bag;
  float total = 0;
  for (WordId word = 0; word < words; ++word) {
    if (engine() % 4 != 0) continue;
    bag.push_back({word, static_cast<float>(1 + engine() % 8)});
    total += bag.back().weight;
  }
  for (WordWeight& entry : bag) entry.weight /= total;
  return bag;
}

TEST(KeyframeDatabase, ScoresAreThoseOfTheBags) {
  constexpr WordId kWords = 60;
  std::mt19937 engine(1);
  KeyframeDatabase database(kWords);
  std::vector<BagOfWords> bags;
  for (int i = 0; i < 40; ++i) {
    bags.push_back(random_bag(engine, kWords));
    database.add(bags.back());
  }
  EXPECT_EQ(database.size(), 40U);
  for (int round = 0; round < 5; ++round) {
    const BagOfWords query = random_bag(engine, kWords);
    const auto matches = database.query(query, 30);
    ASSERT_EQ(matches.size(), 30U);  // with 15 words of 60 each, sharing none is impossible here
    for (std::size_t i = 0; i < matches.size(); ++i) {
      EXPECT_EQ(matches[i].position, i);
      EXPECT_DOUBLE_EQ(matches[i].score, bag_score(query, bags[i]));
    }
  }
}

TEST(KeyframeDatabase, OnlyKeyframesThatShareWordsAreFound) {
  KeyframeDatabase database(10);
  database.add({{1, 0.5F}, {2, 0.5F}});
  database.add({});  // an image without features
  database.add({{2, 0.25F}, {3, 0.75F}});
  EXPECT_EQ(database.query({{2, 1.0F}}, 3),
            (std::vector<KeyframeMatch>{{0, 0.5, 1}, {2, 0.25, 1}}));
  EXPECT_THAT(database.query({{2, 1.0F}}, 2), ElementsAre(Field(&KeyframeMatch::position, 0)));
  EXPECT_THAT(database.query({{7, 1.0F}}, 3), IsEmpty());
  EXPECT_THAT(database.query({}, 3), IsEmpty());
  EXPECT_THAT(KeyframeDatabase(10).query({{2, 1.0F}}, 0), IsEmpty());
}

TEST(KeyframeDatabase, ARemovedKeyframeIsNotFoundAndOthersKeepTheirPositions) {
  KeyframeDatabase database(8);
  const BagOfWords bag = {{1, 0.5F}, {3, 0.5F}};
  for (int i = 0; i < 3; ++i) database.add(bag);
  const std::size_t bytes = database.bytes();
  database.remove(1, bag);
  EXPECT_THAT(database.query(bag, 3), ElementsAre(Field(&KeyframeMatch::position, 0U),
                                                  Field(&KeyframeMatch::position, 2U)));
  database.remove(0, bag);
  database.remove(2, bag);
  EXPECT_THAT(database.query(bag, 3), IsEmpty());
  EXPECT_LT(database.bytes(), bytes) << "words that no keyframe shows take no memory";
  database.add(bag);
  EXPECT_THAT(database.query(bag, 4), ElementsAre(Field(&KeyframeMatch::position, 3U)));
}

TEST(KeyframeDatabase, WordsOfAnotherVocabularyAreRefused) {
  KeyframeDatabase database(10);
  EXPECT_THROW(database.add({{10, 1.0F}}), DataError);
  EXPECT_EQ(database.size(), 0U);
}

TEST(KeyframeDatabase, MemoryGrowsByEightBytesAWord) {
  KeyframeDatabase database(1000);
  BagOfWords bag;
  for (WordId word = 0; word < 1000; ++word) bag.push_back({word, 0.001F});
  const std::size_t before = database.bytes();
  for (int i = 0; i < 64; ++i) database.add(bag);  // a power of 2: vectors have no room to spare
  EXPECT_NEAR(static_cast<double>(database.bytes() - before), 64 * (8 * 1000 + 16), 1);
}

TEST(CandidateGroups, NeighboursMakeAGroup) {
  const auto groups =
      group_candidates({{3, 0.2, 1}, {4, 0.3, 1}, {7, 0.1, 1}, {20, 0.5, 1}, {90, 0.5, 1}}, 3);
  ASSERT_EQ(groups.size(), 3U);
  EXPECT_EQ(groups[0].first, 3U);
  EXPECT_EQ(groups[0].last, 7U);
  EXPECT_EQ(groups[0].best.position, 4U);
  EXPECT_NEAR(groups[0].total_score, 0.6, 1e-12);
  // The earlier of two equal groups comes first.
  EXPECT_EQ(groups[1].best.position, 20U);
  EXPECT_EQ(groups[2].best.position, 90U);
  EXPECT_THAT(group_candidates({}, 3), IsEmpty());
}

}  // namespace
}  // namespace cvo_slam
