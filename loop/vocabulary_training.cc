// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "cvo_slam/core/error.h"
#include "cvo_slam/loop/k_majority_internal.h"
#include "cvo_slam/loop/vocabulary.h"

namespace cvo_slam {
namespace {

/// A node without children so far, and the range of its descriptors.
struct OpenNode {
  std::uint32_t index = 0;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Builds the tree level by level. The descriptors are kept sorted by node.
class Grower {
 public:
  Grower(std::vector<Descriptor> descriptors, const TrainingOptions& options,
         const Executor& executor)
      : descriptors_(std::move(descriptors)),
        options_(options),
        executor_(executor),
        open_({{0, 0, descriptors_.size()}}) {}

  std::vector<VocabularyNode> grow() {
    for (int depth = 1; depth <= options_.levels && !open_.empty(); ++depth) grow_level(depth);
    return std::move(nodes_);
  }

 private:
  void grow_level(int depth) {
    std::vector<Clusters> clusters(open_.size());
    executor_.for_each_chunk(open_.size(), 1, [&](std::size_t i, std::size_t, std::size_t) {
      const OpenNode& node = open_[i];
      clusters[i] = cluster({descriptors_.data() + node.begin, node.end - node.begin},
                            options_.branching, options_.iterations,
                            Random({static_cast<std::uint64_t>(options_.seed), node.index}));
    });
    const std::vector<OpenNode> parents = std::move(open_);
    open_.clear();
    for (std::size_t i = 0; i < parents.size(); ++i) {
      add_children(parents[i], clusters[i], depth == options_.levels);
    }
  }

  void add_children(const OpenNode& parent, const Clusters& clusters, bool last_level) {
    std::vector<std::vector<Descriptor>> members(clusters.centers.size());
    for (std::size_t i = parent.begin; i < parent.end; ++i) {
      members[clusters.members[i - parent.begin]].push_back(descriptors_[i]);
    }
    std::size_t begin = parent.begin;
    for (std::size_t c = 0; c < members.size(); ++c) {
      const auto first = descriptors_.begin() + static_cast<std::ptrdiff_t>(begin);
      std::copy(members[c].begin(), members[c].end(), first);
      const std::size_t end = begin + members[c].size();
      const bool all_equal = std::all_of(members[c].begin(), members[c].end(),
                                         [&](const Descriptor& d) { return d == members[c][0]; });
      const bool is_word = last_level || all_equal;
      nodes_.push_back({parent.index, is_word, clusters.centers[c], 0});
      if (!is_word) open_.push_back({static_cast<std::uint32_t>(nodes_.size()), begin, end});
      begin = end;
    }
  }

  std::vector<Descriptor> descriptors_;
  TrainingOptions options_;
  const Executor& executor_;
  std::vector<OpenNode> open_;
  std::vector<VocabularyNode> nodes_;
};

std::vector<Descriptor> all_of(std::span<const std::vector<Descriptor>> images) {
  std::vector<Descriptor> all;
  for (const auto& image : images) all.insert(all.end(), image.begin(), image.end());
  return all;
}

/// Returns the number of images in which each word occurs.
std::vector<std::uint32_t> count_images(const Vocabulary& vocabulary,
                                        std::span<const std::vector<Descriptor>> images) {
  std::vector<std::uint32_t> counts(vocabulary.words());
  std::vector<WordId> words;
  for (const auto& image : images) {
    words.clear();
    words.reserve(image.size());
    for (const Descriptor& descriptor : image) words.push_back(vocabulary.find(descriptor, 0).word);
    std::sort(words.begin(), words.end());
    words.erase(std::unique(words.begin(), words.end()), words.end());
    for (const WordId word : words) ++counts[word];
  }
  return counts;
}

/// Sets the idf of each word: log(images / images with the word). A word that no descriptor
/// reaches, because the search is greedy, counts as a word of a single image.
void set_weights(std::vector<VocabularyNode>& nodes, const std::vector<std::uint32_t>& counts,
                 std::size_t images) {
  std::size_t word = 0;
  for (VocabularyNode& node : nodes) {
    if (!node.is_word) continue;
    const double count = std::max(1U, counts[word++]);
    node.weight = static_cast<float>(std::log(static_cast<double>(images) / count));
  }
}

}  // namespace

OptionSet describe(TrainingOptions& o) {
  return OptionSet()
      .add("branching", o.branching, {2, Vocabulary::kMaxBranching}, "",
           "Children of a node. 9 children and 5 levels make 59,049 words and a file of 2.4 MB.")
      .add("levels", o.levels, {1, 8}, "",
           "Steps from the root to a word. Words of a deeper tree distinguish more places and are "
           "recognised less often.")
      .add("iterations", o.iterations, {1, 1000}, "",
           "Most iterations of the clustering of a node; it usually ends earlier.")
      .add("seed", o.seed, {0, 1000000000}, "", "Seed of the first centres of the clusters.");
}

Vocabulary train_vocabulary(std::span<const std::vector<Descriptor>> images,
                            const TrainingOptions& options, const Executor& executor) {
  TrainingOptions checked = options;
  describe(checked).check();
  std::vector<Descriptor> descriptors = all_of(images);
  if (descriptors.empty()) {
    throw DataError("training of a vocabulary: the images have no features; give more images");
  }
  std::vector<VocabularyNode> nodes = Grower(std::move(descriptors), options, executor).grow();
  const Vocabulary unweighted(options.branching, options.levels, nodes);
  set_weights(nodes, count_images(unweighted, images), images.size());
  return {options.branching, options.levels, nodes};
}

}  // namespace cvo_slam
