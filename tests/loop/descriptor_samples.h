// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "cvo_slam/loop/vocabulary.h"

namespace cvo_slam {

/// Descriptors for tests, the same on every machine.
class DescriptorSource {
 public:
  explicit DescriptorSource(std::uint64_t seed) : engine_(seed) {}

  Descriptor random() { return {{engine_(), engine_(), engine_(), engine_()}}; }

  /// Returns a copy with up to this many bits flipped; a bit may be flipped twice.
  Descriptor near(Descriptor descriptor, int flips) {
    for (int i = 0; i < flips; ++i) {
      const std::uint64_t bit = engine_() % Descriptor::kBits;
      descriptor.words[bit / 64] ^= std::uint64_t{1} << (bit % 64);
    }
    return descriptor;
  }

  std::vector<Descriptor> random(std::size_t count) {
    std::vector<Descriptor> descriptors(count);
    for (auto& descriptor : descriptors) descriptor = random();
    return descriptors;
  }

 private:
  std::mt19937_64 engine_;
};

/// A full tree: every inner node has `branching` random children, breadth first.
inline std::vector<VocabularyNode> full_tree(int branching, int levels, std::uint64_t seed) {
  DescriptorSource source(seed);
  std::vector<VocabularyNode> nodes;
  std::size_t parents = 1;
  std::uint32_t parent = 0;
  for (int level = 1; level <= levels; ++level) {
    for (std::size_t i = 0; i < parents; ++i, ++parent) {
      for (int child = 0; child < branching; ++child) {
        const bool is_word = level == levels;
        const float weight = is_word ? 1 + 0.125F * static_cast<float>(nodes.size() % 40) : 0;
        nodes.push_back({parent, is_word, source.random(), weight});
      }
    }
    parents *= static_cast<std::size_t>(branching);
  }
  return nodes;
}

inline bool operator==(const VocabularyNode& a, const VocabularyNode& b) {
  return a.parent == b.parent && a.is_word == b.is_word && a.descriptor == b.descriptor &&
         a.weight == b.weight;
}

}  // namespace cvo_slam
