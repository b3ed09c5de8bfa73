// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cvo_slam/loop/bag_of_words.h"

namespace cvo_slam {

/// A keyframe that shares words with an image.
struct KeyframeMatch {
  std::size_t keyframe = 0;  ///< counted from 0 in the order of add()
  double score = 0;          ///< bag_score()
  int shared_words = 0;

  bool operator==(const KeyframeMatch&) const = default;
};

/// Which keyframes show which words: an inverted index. A query visits the entries of its own words
/// alone, so that its cost grows with the words that are shared and not with the keyframes. Takes 8
/// bytes a word of a keyframe (8 KB with 1,000 different words), and 32 a word of the vocabulary.
/// For one thread at a time.
class KeyframeDatabase {
 public:
  /// `words` of the vocabulary.
  explicit KeyframeDatabase(std::size_t words);

  /// Adds the next keyframe. Throws DataError for a word that the vocabulary does not have.
  void add(const BagOfWords& bag);
  /// Those of the first `end` keyframes that share a word, in ascending order.
  [[nodiscard]] std::vector<KeyframeMatch> query(const BagOfWords& bag, std::size_t end);

  /// Number of keyframes.
  [[nodiscard]] std::size_t size() const { return sums_.size(); }
  /// Memory of the index [bytes].
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Entry {
    std::uint32_t keyframe = 0;
    float weight = 0;
  };
  struct Sum {
    double score = 0;
    int shared_words = 0;
  };

  std::vector<std::vector<Entry>> entries_;  // by word, keyframes ascending
  std::vector<Sum> sums_;                    // by keyframe; zero between queries
};

}  // namespace cvo_slam
