// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cvo_slam/core/options.h"
#include "cvo_slam/core/parallel.h"
#include "cvo_slam/loop/descriptor.h"

namespace cvo_slam {

/// The index of a visual word of a vocabulary, in [0, Vocabulary::words()).
using WordId = std::uint32_t;

/// A visual word of an image.
struct WordWeight {
  WordId word = 0;   ///< its index
  float weight = 0;  ///< its tf-idf weight, as a share of the sum over the image, in (0, 1]

  /// Returns true if all members are equal.
  bool operator==(const WordWeight&) const = default;
};

/// The visual words of an image: tf-idf weights that sum to 1, in ascending order of words. Empty
/// if the image has no features, or only words that every image shows.
using BagOfWords = std::vector<WordWeight>;

/// Returns 1 - |a - b|_1 / 2, which is 1 for equal bags and 0 for bags without a common word (D.
/// Nister and H. Stewenius, "Scalable Recognition with a Vocabulary Tree", CVPR 2006, as scaled by
/// D. Galvez-Lopez and J. D. Tardos, "Bags of Binary Words for Fast Place Recognition", T-RO 2012,
/// Eq. (2)).
[[nodiscard]] double bag_score(const BagOfWords& a, const BagOfWords& b);

/// A feature of an image and the node of a vocabulary, at some level, to which it belongs.
struct NodeFeature {
  std::uint32_t node = 0;     ///< index of the node (VocabularyNode)
  std::uint32_t feature = 0;  ///< index of the feature in its image

  /// Returns true if all members are equal.
  bool operator==(const NodeFeature&) const = default;
  /// Orders by nodes, then by features.
  bool operator<(const NodeFeature& other) const {
    return std::pair(node, feature) < std::pair(other.node, other.feature);
  }
};

/// The description of an image by a vocabulary.
struct ImageWords {
  BagOfWords bag;                  ///< its words
  std::vector<NodeFeature> nodes;  ///< in ascending order; one for each feature
};

/// A node of a vocabulary's tree below the root. The root has no descriptor and the index 0; the
/// node at position i of a list of nodes has the index i + 1.
struct VocabularyNode {
  std::uint32_t parent = 0;  ///< smaller than the node's own index
  bool is_word = false;      ///< true for a leaf
  Descriptor descriptor;     ///< centre of the descriptors that belong to the node
  float weight = 0;          ///< the idf of a word; not used for other nodes
};

/// A tree of descriptors whose leaves are visual words. The word of a descriptor is found by
/// descending from the root to the nearest child at each level (D. Nister and H. Stewenius, CVPR
/// 2006; for binary descriptors D. Galvez-Lopez and J. D. Tardos, T-RO 2012).
///
/// Immutable, so that any number of threads may share one.
class Vocabulary {
 public:
  static constexpr int kMaxBranching = 255;  ///< most children of a node
  static constexpr int kMaxLevels = 16;      ///< most steps from the root to a word

  /// A node has at most `branching` children, a word is at most `levels` steps below the root.
  /// Nodes are renumbered breadth first; siblings keep their order, and words are numbered in the
  /// new order. Throws DataError if the nodes are not such a tree, or if a weight is negative or
  /// not finite.
  Vocabulary(int branching, int levels, const std::vector<VocabularyNode>& nodes);

  /// Returns the most children that a node may have, as the constructor was told.
  [[nodiscard]] int branching() const { return branching_; }
  /// Returns the most steps from the root to a word, as the constructor was told.
  [[nodiscard]] int levels() const { return levels_; }
  /// Number of words.
  [[nodiscard]] std::size_t words() const { return weights_.size(); }
  /// Number of nodes, including the root.
  [[nodiscard]] std::size_t nodes() const { return descriptors_.size(); }

  /// Returns the nodes below the root, breadth first, as the constructor takes them.
  [[nodiscard]] std::vector<VocabularyNode> tree() const;
  /// Returns the idf of a word.
  [[nodiscard]] float weight(WordId word) const { return weights_[word]; }

  /// The end of a descriptor's descent.
  struct Place {
    WordId word = 0;         ///< the word reached
    std::uint32_t node = 0;  ///< the node passed at the requested level, or the word's own node
  };
  /// Returns the word of a descriptor, and the node that it passes `level` steps below the root.
  [[nodiscard]] Place find(const Descriptor& descriptor, int level) const;

  /// Returns the words of an image's descriptors, and the nodes they pass `level` steps below the
  /// root.
  [[nodiscard]] ImageWords transform(std::span<const Descriptor> descriptors, int level) const;

 private:
  [[nodiscard]] std::span<const Descriptor> children(std::uint32_t node) const {
    return {descriptors_.data() + first_child_[node], first_child_[node + 1] - first_child_[node]};
  }

  int branching_;
  int levels_;
  // Indexed by node, breadth first, so that siblings are adjacent.
  std::vector<Descriptor> descriptors_;
  std::vector<std::uint32_t> first_child_;  // one more than nodes
  std::vector<WordId> word_;                // of leaves
  std::vector<float> weights_;              // indexed by word
};

/// Returns the vocabulary of config/vocabulary/, whose bytes are part of this library. Each call
/// makes a new one; share it.
[[nodiscard]] std::shared_ptr<const Vocabulary> builtin_vocabulary();

/// How a vocabulary is made.
struct TrainingOptions {
  int branching = 9;    ///< children of a node, 2 to 255
  int levels = 5;       ///< steps from the root to a word, 1 to 8
  int iterations = 10;  ///< most iterations of the clustering of a node, 1 to 1000
  int seed = 1;         ///< seed of the first centres of the clusters, 0 to 1000000000
};

/// Returns the options with their keys, ranges and documentation.
[[nodiscard]] OptionSet describe(TrainingOptions& options);

/// Returns a vocabulary made from the descriptors of many images, one list per image, by
/// hierarchical k-majority clustering. The weight of a word is the logarithm of the number of
/// images over the number of images that show it (idf). The same descriptors and options give the
/// same vocabulary on any number of threads. Throws DataError if there are no descriptors,
/// OptionError for a bad option.
[[nodiscard]] Vocabulary train_vocabulary(std::span<const std::vector<Descriptor>> images,
                                          const TrainingOptions& options = {},
                                          const Executor& executor = Executor());

/// Reads a vocabulary in either format, which its first bytes tell. Throws InputError if the file
/// cannot be read, is cut off, damaged, of a later version, or no vocabulary; the message says as
/// which format it was read.
[[nodiscard]] Vocabulary read_vocabulary(const std::filesystem::path& file);

/// Returns the bytes of the binary format of this library. They depend on the vocabulary alone.
/// All numbers are little-endian:
///
///     offset  bytes
///          0      8  "cvo-voc\n"
///          8      4  version of the format: 1
///         12      4  branching
///         16      4  levels
///         20      4  bits of a descriptor: 256
///         24      4  n, number of nodes including the root
///         28      4  w, number of words
///         32      8  checksum of all other bytes: FNV-1a over 64-bit words, padded with zeros
///         40      n  number of children of each node, breadth first; 0 for a word
///             32n-32 descriptors of the nodes below the root
///                 4w weights of the words (IEEE 754)
[[nodiscard]] std::string vocabulary_bytes(const Vocabulary& vocabulary);
/// Parses the binary format; `name` is for messages. Throws InputError.
[[nodiscard]] Vocabulary vocabulary_from_bytes(std::span<const char> bytes,
                                               const std::filesystem::path& name);
/// Writes a file in the binary format. Throws OutputError.
void write_vocabulary(const std::filesystem::path& file, const Vocabulary& vocabulary);

/// Parses the text format that ORB-SLAM2 and 3 and DBoW2 use for ORB vocabularies. The first line
/// is `branching levels scoring weighting`; only scoring 0 (L1) and weighting 0 (tf-idf) are
/// supported. Each following line is a node: `parent is_word d0 ... d31 weight`, with the bytes of
/// the descriptor in decimal. Nodes are numbered from 1 in the order of lines; 0 is the root.
/// `name` is for messages. Throws InputError with the line.
[[nodiscard]] Vocabulary vocabulary_from_text(std::string_view text,
                                              const std::filesystem::path& name);
/// Writes a file in the text format, breadth first; the weights have as many digits as are needed
/// to read them back unchanged. Throws OutputError.
void write_vocabulary_text(const std::filesystem::path& file, const Vocabulary& vocabulary);

}  // namespace cvo_slam
