// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/loop/descriptor.h"
#include "cvo_slam/loop/k_majority_internal.h"
#include "cvo_slam/loop/vocabulary.h"
#include "cvo_slam/tests/loop/descriptor_samples.h"

namespace cvo_slam {
namespace {

/// Images of features that are noisy copies of a few prototypes.
std::vector<std::vector<Descriptor>> sample_images(std::size_t images, std::size_t prototypes) {
  DescriptorSource source(5);
  const auto centers = source.random(prototypes);
  std::vector<std::vector<Descriptor>> result(images);
  for (std::size_t i = 0; i < images; ++i) {
    for (std::size_t j = 0; j < 60; ++j) {
      result[i].push_back(source.near(centers[(7 * i + j) % prototypes], 8));
    }
  }
  return result;
}

TEST(BitCounter, MajorityIsThatOfEachBit) {
  DescriptorSource source(2);
  const auto descriptors = source.random(101);
  BitCounter counter;
  for (const auto& descriptor : descriptors) counter.add(descriptor);
  const Descriptor majority = counter.majority();
  EXPECT_EQ(counter.total(), 101U);
  for (std::size_t i = 0; i < Descriptor::kBits; ++i) {
    int with = 0;
    for (const auto& descriptor : descriptors) with += descriptor.bit(i) ? 1 : 0;
    EXPECT_EQ(majority.bit(i), with > 50) << i;
  }
}

TEST(KMajority, FindsTheClustersThatThereAre) {
  // Random descriptors are 128 bits apart give or take 8; members at most 12 from their centre.
  DescriptorSource source(3);
  const auto centers = source.random(4);
  std::vector<Descriptor> members;
  for (std::size_t i = 0; i < 400; ++i) members.push_back(source.near(centers[i % 4], 12));
  const Clusters clusters = cluster(members, 4, 20, Random({1}));
  ASSERT_EQ(clusters.centers.size(), 4U);
  for (const auto& center : centers) {
    // With 100 members, 5 % of whose bits are flipped, no majority is wrong.
    EXPECT_EQ(nearest_descriptor(center, clusters.centers).distance, 0);
  }
  for (std::size_t i = 4; i < members.size(); ++i) {
    EXPECT_EQ(clusters.members[i], clusters.members[i % 4]);
  }
}

TEST(KMajority, FewDifferentDescriptorsAreTheirOwnClusters) {
  DescriptorSource source(4);
  const auto three = source.random(3);
  std::vector<Descriptor> members;
  for (std::size_t i = 0; i < 30; ++i) members.push_back(three[i % 3]);
  const Clusters clusters = cluster(members, 9, 10, Random({1}));
  EXPECT_THAT(clusters.centers, testing::UnorderedElementsAreArray(three));
}

TEST(VocabularyTraining, SameSeedGivesSameBytesOnAnyNumberOfThreads) {
  const auto images = sample_images(20, 50);
  const TrainingOptions options{.branching = 4, .levels = 3};
  const std::string bytes = vocabulary_bytes(train_vocabulary(images, options));
  EXPECT_EQ(vocabulary_bytes(train_vocabulary(images, options, Executor(3))), bytes);
  EXPECT_NE(vocabulary_bytes(train_vocabulary(
                images, {.branching = 4, .levels = 3, .iterations = 10, .seed = 2})),
            bytes);
}

TEST(VocabularyTraining, FeaturesOfOneKindShareAWord) {
  const auto images = sample_images(20, 50);
  const Vocabulary vocabulary = train_vocabulary(images, {.branching = 4, .levels = 3});
  // 64 words for 50 kinds; a greedy search may divide some kinds. Unrelated features share a word
  // by chance in one of 64 cases.
  DescriptorSource source(5);
  const auto centers = source.random(50);
  int shared = 0;
  for (const auto& center : centers) {
    shared +=
        vocabulary.find(center, 0).word == vocabulary.find(source.near(center, 8), 0).word ? 1 : 0;
  }
  EXPECT_GE(shared, 35);
}

TEST(VocabularyTraining, WeightIsTheLogarithmOfRarity) {
  DescriptorSource source(6);
  const auto kinds = source.random(3);
  // The first kind is in all four images, the second in two, the third in one.
  const std::vector<std::vector<Descriptor>> images = {
      {kinds[0], kinds[1], kinds[1]}, {kinds[0], kinds[1]}, {kinds[0], kinds[2]}, {kinds[0]}};
  const Vocabulary vocabulary = train_vocabulary(images, {.branching = 3, .levels = 2});
  ASSERT_EQ(vocabulary.words(), 3U);
  const auto weight = [&](std::size_t i) {
    return vocabulary.weight(vocabulary.find(kinds[i], 0).word);
  };
  EXPECT_FLOAT_EQ(weight(0), 0);
  EXPECT_FLOAT_EQ(weight(1), std::log(2.0F));
  EXPECT_FLOAT_EQ(weight(2), std::log(4.0F));
}

TEST(VocabularyTraining, NothingToLearnFromIsAnError) {
  EXPECT_THROW(static_cast<void>(train_vocabulary({})), DataError);
  const std::vector<std::vector<Descriptor>> blank(3);
  EXPECT_THROW(static_cast<void>(train_vocabulary(blank)), DataError);
  EXPECT_THROW(static_cast<void>(train_vocabulary(sample_images(1, 5), {.branching = 1})),
               OptionError);
}

}  // namespace
}  // namespace cvo_slam
