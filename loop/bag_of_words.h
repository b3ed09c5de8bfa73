// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace cvo_slam {

/// The index of a word of a vocabulary, in [0, Vocabulary::words()).
using WordId = std::uint32_t;

struct WordWeight {
  WordId word = 0;
  float weight = 0;

  bool operator==(const WordWeight&) const = default;
};

/// Which words an image shows: tf-idf weights that sum to 1, in ascending order of words. Empty
/// where an image has no features, or none with a word that tells images apart.
using BagOfWords = std::vector<WordWeight>;

/// Which node of a vocabulary, at some level, a feature of an image belongs to.
struct NodeFeature {
  std::uint32_t node = 0;
  std::uint32_t feature = 0;

  bool operator==(const NodeFeature&) const = default;
  bool operator<(const NodeFeature& other) const {
    return std::pair(node, feature) < std::pair(other.node, other.feature);
  }
};

/// An image as a vocabulary describes it.
struct ImageWords {
  BagOfWords bag;
  std::vector<NodeFeature> nodes;  ///< in ascending order; one for each feature
};

/// 1 - |a - b|_1 / 2: 1 for equal bags, 0 where no word is shared (D. Nister and H. Stewenius,
/// "Scalable Recognition with a Vocabulary Tree", CVPR 2006, as scaled by D. Galvez-Lopez and J. D.
/// Tardos, "Bags of Binary Words for Fast Place Recognition", T-RO 2012, Eq. (2)).
[[nodiscard]] double bag_score(const BagOfWords& a, const BagOfWords& b);

}  // namespace cvo_slam
