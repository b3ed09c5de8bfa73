// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cvo_slam/loop/bag_of_words.h"
#include "cvo_slam/loop/descriptor.h"

namespace cvo_slam {

/// A node of a vocabulary's tree below the root. The root has no descriptor and the index 0; the
/// node at place i of a list of nodes has the index i + 1.
struct VocabularyNode {
  std::uint32_t parent = 0;  ///< a smaller index than the node's own
  bool is_word = false;      ///< a leaf
  Descriptor descriptor;
  float weight = 0;  ///< of a word: its idf; otherwise without meaning
};

/// A tree of descriptors whose leaves are visual words. A descriptor's word is found by descending
/// to the nearest child from the root on (D. Nister and H. Stewenius, CVPR 2006; for binary
/// descriptors D. Galvez-Lopez and J. D. Tardos, T-RO 2012).
///
/// Immutable, so that one may be shared by any number of threads.
class Vocabulary {
 public:
  static constexpr int kMaxBranching = 255;
  static constexpr int kMaxLevels = 16;

  /// A node has at most `branching` children, a word at most `levels` steps from the root. Nodes
  /// are renumbered breadth first; siblings keep their order, and words are counted in the new one.
  /// Throws DataError where the nodes are no such tree, or a weight is negative or not finite.
  Vocabulary(int branching, int levels, const std::vector<VocabularyNode>& nodes);

  [[nodiscard]] int branching() const { return branching_; }
  [[nodiscard]] int levels() const { return levels_; }
  [[nodiscard]] std::size_t words() const { return weights_.size(); }
  /// With the root.
  [[nodiscard]] std::size_t nodes() const { return descriptors_.size(); }

  /// The nodes below the root, breadth first, as the constructor takes them.
  [[nodiscard]] std::vector<VocabularyNode> tree() const;
  /// The idf of a word.
  [[nodiscard]] float weight(WordId word) const { return weights_[word]; }

  /// Where a descriptor's descent ends.
  struct Place {
    WordId word = 0;
    std::uint32_t node = 0;  ///< passed at the level that was asked for, or the word's own
  };
  [[nodiscard]] Place find(const Descriptor& descriptor, int level) const;

  /// The words of an image's descriptors, and the nodes they pass `level` steps below the root.
  [[nodiscard]] ImageWords transform(std::span<const Descriptor> descriptors, int level) const;

 private:
  [[nodiscard]] std::span<const Descriptor> children(std::uint32_t node) const {
    return {descriptors_.data() + first_child_[node], first_child_[node + 1] - first_child_[node]};
  }

  int branching_;
  int levels_;
  // By node, breadth first, so that siblings lie side by side.
  std::vector<Descriptor> descriptors_;
  std::vector<std::uint32_t> first_child_;  // one more than nodes
  std::vector<WordId> word_;                // of leaves
  std::vector<float> weights_;              // by word
};

}  // namespace cvo_slam
