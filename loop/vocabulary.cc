// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/loop/vocabulary.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"

namespace cvo_slam {
namespace {

[[noreturn]] void fail(const std::string& problem) { throw DataError("vocabulary: " + problem); }

void check_shape(int branching, int levels, std::size_t nodes) {
  if (branching < 2 || branching > Vocabulary::kMaxBranching) {
    fail(fmt::format("{} branches a node; 2 to {} are possible", branching,
                     Vocabulary::kMaxBranching));
  }
  if (levels < 1 || levels > Vocabulary::kMaxLevels) {
    fail(fmt::format("{} levels; 1 to {} are possible", levels, Vocabulary::kMaxLevels));
  }
  if (nodes == 0) fail("has no words");
}

void check_node(const VocabularyNode& node, std::size_t index) {
  if (node.parent >= index) {
    fail(fmt::format("node {} comes before its parent {}", index, node.parent));
  }
  if (node.is_word && !(std::isfinite(node.weight) && node.weight >= 0)) {
    fail(fmt::format("node {} has the weight {}", index, node.weight));
  }
}

/// Returns the number of children of each node, the root first.
std::vector<std::uint32_t> count_children(const std::vector<VocabularyNode>& nodes, int branching) {
  std::vector<std::uint32_t> counts(nodes.size() + 1);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    check_node(nodes[i], i + 1);
    if (++counts[nodes[i].parent] > static_cast<std::uint32_t>(branching)) {
      fail(fmt::format("node {} has more than {} children", nodes[i].parent, branching));
    }
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].is_word == (counts[i + 1] == 0)) continue;
    fail(fmt::format("node {} is {}", i + 1,
                     nodes[i].is_word ? "a word and has children" : "no word and has no children"));
  }
  return counts;
}

void check_depth(const std::vector<VocabularyNode>& nodes, int levels) {
  std::vector<int> depth(nodes.size() + 1);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    depth[i + 1] = depth[nodes[i].parent] + 1;
    if (depth[i + 1] > levels) {
      fail(fmt::format("node {} is more than {} levels below the root", i + 1, levels));
    }
  }
}

/// The children of each node in their order: those of node i are at [starts[i], starts[i + 1]).
struct ChildLists {
  ChildLists(const std::vector<VocabularyNode>& nodes, const std::vector<std::uint32_t>& counts)
      : starts(counts.size() + 1), children(nodes.size()) {
    for (std::size_t i = 0; i < counts.size(); ++i) starts[i + 1] = starts[i] + counts[i];
    std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
    for (std::uint32_t i = 0; i < nodes.size(); ++i) children[next[nodes[i].parent]++] = i + 1;
  }
  std::vector<std::uint32_t> starts;
  std::vector<std::uint32_t> children;
};

/// Returns the original indices of the nodes in breadth-first order.
std::vector<std::uint32_t> breadth_first(const ChildLists& lists) {
  std::vector<std::uint32_t> order = {0};
  order.reserve(lists.children.size() + 1);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto begin = lists.children.begin();
    const std::uint32_t node = order[i];
    order.insert(order.end(), begin + lists.starts[node], begin + lists.starts[node + 1]);
  }
  return order;
}

/// Returns the bag of a list of words with repetitions, in any order.
BagOfWords to_bag(std::vector<WordId> words, const Vocabulary& vocabulary) {
  std::sort(words.begin(), words.end());
  BagOfWords bag;
  double total = 0;
  for (std::size_t i = 0; i < words.size();) {
    const std::size_t first = i;
    while (i < words.size() && words[i] == words[first]) ++i;
    const float weight = static_cast<float>(i - first) * vocabulary.weight(words[first]);
    if (weight <= 0) continue;  // every image shows this word
    bag.push_back({words[first], weight});
    total += weight;
  }
  for (WordWeight& entry : bag) entry.weight = static_cast<float>(entry.weight / total);
  return bag;
}

}  // namespace

double bag_score(const BagOfWords& a, const BagOfWords& b) {
  // Both sum to 1, so that |a - b|_1 = 2 - 2 sum min(a, b).
  double score = 0;
  auto i = a.begin();
  auto j = b.begin();
  while (i != a.end() && j != b.end()) {
    if (i->word == j->word) {
      score += std::min(i->weight, j->weight);
      ++i;
      ++j;
    } else if (i->word < j->word) {
      ++i;
    } else {
      ++j;
    }
  }
  return score;
}

Vocabulary::Vocabulary(int branching, int levels, const std::vector<VocabularyNode>& nodes)
    : branching_(branching), levels_(levels) {
  check_shape(branching, levels, nodes.size());
  const std::vector<std::uint32_t> counts = count_children(nodes, branching);
  check_depth(nodes, levels);
  const std::vector<std::uint32_t> order = breadth_first(ChildLists(nodes, counts));
  descriptors_.resize(order.size());
  word_.resize(order.size());
  first_child_ = {1};
  first_child_.reserve(order.size() + 1);
  for (std::size_t i = 0; i < order.size(); ++i) {
    first_child_.push_back(first_child_.back() + counts[order[i]]);
    if (i == 0) continue;
    const VocabularyNode& node = nodes[order[i] - 1];
    descriptors_[i] = node.descriptor;
    if (!node.is_word) continue;
    word_[i] = static_cast<WordId>(weights_.size());
    weights_.push_back(node.weight);
  }
}

std::vector<VocabularyNode> Vocabulary::tree() const {
  std::vector<VocabularyNode> nodes(this->nodes() - 1);
  for (std::uint32_t parent = 0; parent < this->nodes(); ++parent) {
    for (std::uint32_t i = first_child_[parent]; i < first_child_[parent + 1]; ++i) {
      const bool is_word = children(i).empty();
      nodes[i - 1] = {parent, is_word, descriptors_[i], is_word ? weights_[word_[i]] : 0.0F};
    }
  }
  return nodes;
}

Vocabulary::Place Vocabulary::find(const Descriptor& descriptor, int level) const {
  std::uint32_t node = 0;
  std::uint32_t node_at_level = 0;
  int depth = 0;
  for (auto next = children(node); !next.empty(); next = children(node)) {
    node =
        first_child_[node] + static_cast<std::uint32_t>(nearest_descriptor(descriptor, next).index);
    if (++depth <= level) node_at_level = node;
  }
  return {word_[node], node_at_level};
}

ImageWords Vocabulary::transform(std::span<const Descriptor> descriptors, int level) const {
  ImageWords image;
  std::vector<WordId> words;
  words.reserve(descriptors.size());
  image.nodes.reserve(descriptors.size());
  for (std::uint32_t i = 0; i < descriptors.size(); ++i) {
    const Place place = find(descriptors[i], level);
    words.push_back(place.word);
    image.nodes.push_back({place.node, i});
  }
  std::sort(image.nodes.begin(), image.nodes.end());
  image.bag = to_bag(std::move(words), *this);
  return image;
}

}  // namespace cvo_slam
