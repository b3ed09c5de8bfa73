// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/loop/vocabulary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/tests/loop/descriptor_samples.h"

namespace cvo_slam {
namespace {

using testing::HasSubstr;

/// Returns a descriptor with only its first bits set.
Descriptor first_bits(std::size_t count) {
  Descriptor descriptor;
  for (std::size_t i = 0; i < count; ++i) descriptor.words[i / 64] |= std::uint64_t{1} << (i % 64);
  return descriptor;
}

/// Two branches: the first is a word, the second has two words. Children are listed last.
std::vector<VocabularyNode> small_tree() {
  return {{0, false, first_bits(200), 0},
          {0, true, first_bits(0), 1},
          {1, true, first_bits(190), 2},
          {1, true, first_bits(250), 0}};
}

std::string problem_of(int branching, int levels, const std::vector<VocabularyNode>& nodes) {
  try {
    const Vocabulary vocabulary(branching, levels, nodes);
  } catch (const DataError& error) {
    return error.what();
  }
  return "none";
}

TEST(Vocabulary, WordsAreFoundFromTheRootOn) {
  const Vocabulary vocabulary(2, 2, small_tree());
  EXPECT_EQ(vocabulary.nodes(), 5);
  EXPECT_EQ(vocabulary.words(), 3);
  // Words are numbered breadth first: the leaf nearest to the root is the first.
  EXPECT_EQ(vocabulary.find(first_bits(20), 1).word, 0);
  EXPECT_EQ(vocabulary.find(first_bits(180), 1).word, 1);
  EXPECT_EQ(vocabulary.find(first_bits(230), 1).word, 2);
  // Nearer to the word below the other branch, but the descent is greedy: 101 > 100.
  EXPECT_EQ(vocabulary.find(first_bits(101), 1).word, 1);
  EXPECT_EQ(vocabulary.find(first_bits(99), 1).word, 0);
}

TEST(Vocabulary, NodesAreThoseOfTheLevelAskedFor) {
  const Vocabulary vocabulary(2, 2, small_tree());
  EXPECT_EQ(vocabulary.find(first_bits(190), 0).node, 0);
  EXPECT_EQ(vocabulary.find(first_bits(190), 1).node, 1);
  EXPECT_EQ(vocabulary.find(first_bits(190), 2).node, 3);
  // A word above the level is its own node.
  EXPECT_EQ(vocabulary.find(first_bits(0), 2).node, 2);
}

TEST(Vocabulary, BagsAreTfIdfAndSumToOne) {
  const Vocabulary vocabulary(2, 2, small_tree());
  const std::vector<Descriptor> image = {first_bits(190), first_bits(0), first_bits(1),
                                         first_bits(250), first_bits(2)};
  const ImageWords words = vocabulary.transform(image, 1);
  // Word 0 occurs three times with weight 1, word 1 once with weight 2; word 2 has weight 0.
  EXPECT_EQ(words.bag, (BagOfWords{{0, 0.6F}, {1, 0.4F}}));
  EXPECT_EQ(words.nodes, (std::vector<NodeFeature>{{1, 0}, {1, 3}, {2, 1}, {2, 2}, {2, 4}}));
}

TEST(Vocabulary, AnImageWithoutFeaturesHasAnEmptyBag) {
  const Vocabulary vocabulary(2, 2, small_tree());
  const ImageWords words = vocabulary.transform({}, 1);
  EXPECT_TRUE(words.bag.empty());
  EXPECT_TRUE(words.nodes.empty());
  // The bag is also empty if every image shows the only word.
  EXPECT_TRUE(vocabulary.transform(std::vector<Descriptor>{first_bits(250)}, 1).bag.empty());
}

TEST(Vocabulary, TreeIsBreadthFirstWhateverTheOrderOfTheNodes) {
  std::vector<VocabularyNode> depth_first = {{0, false, first_bits(200), 0},
                                             {1, true, first_bits(190), 2},
                                             {1, true, first_bits(250), 0},
                                             {0, true, first_bits(0), 1}};
  EXPECT_EQ(Vocabulary(2, 2, depth_first).tree(), small_tree());
}

TEST(Vocabulary, NodesThatAreNoTreeAreRefused) {
  auto nodes = small_tree();
  nodes[1].parent = 2;
  EXPECT_THAT(problem_of(2, 2, nodes), HasSubstr("node 2 comes before its parent 2"));
  nodes = small_tree();
  nodes[2].is_word = false;
  EXPECT_THAT(problem_of(2, 2, nodes), HasSubstr("node 3 is no word and has no children"));
  nodes = small_tree();
  nodes[0].is_word = true;
  EXPECT_THAT(problem_of(2, 2, nodes), HasSubstr("node 1 is a word and has children"));
  nodes = small_tree();
  nodes[3].weight = -1;
  EXPECT_THAT(problem_of(2, 2, nodes), HasSubstr("node 4 has the weight -1"));
  nodes.push_back({1, true, {}, 1});
  nodes[3].weight = 1;
  EXPECT_THAT(problem_of(2, 2, nodes), HasSubstr("node 1 has more than 2 children"));
  EXPECT_THAT(problem_of(2, 1, small_tree()), HasSubstr("more than 1 levels"));
  EXPECT_THAT(problem_of(1, 2, small_tree()), HasSubstr("1 branches"));
  EXPECT_THAT(problem_of(2, 17, small_tree()), HasSubstr("17 levels"));
  EXPECT_THAT(problem_of(2, 2, {}), HasSubstr("no words"));
}

TEST(BagOfWords, ScoreIsOneForEqualAndZeroForUnrelatedImages) {
  const BagOfWords a = {{1, 0.25F}, {5, 0.75F}};
  EXPECT_DOUBLE_EQ(bag_score(a, a), 1);
  EXPECT_DOUBLE_EQ(bag_score(a, {{2, 1.0F}}), 0);
  EXPECT_DOUBLE_EQ(bag_score(a, {}), 0);
  // 1 - (|0.25 - 0.5| + 0.75 + 0.5) / 2
  EXPECT_DOUBLE_EQ(bag_score(a, {{1, 0.5F}, {9, 0.5F}}), 0.25);
}

}  // namespace
}  // namespace cvo_slam
