// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <numeric>

#include "cvo_slam/loop/k_majority_internal.h"

namespace cvo_slam {
namespace {

/// Returns the index at which the running sum of `weights` first exceeds `target` < their sum.
std::size_t index_at(const std::vector<std::uint64_t>& weights, std::uint64_t target) {
  std::size_t i = 0;
  for (; target >= weights[i]; ++i) target -= weights[i];
  return i;
}

/// Returns the first centres by k-means++: each next centre is drawn with a probability in
/// proportion to the squared distance to the nearest centre so far. Returns fewer than k if there
/// are not k different descriptors.
std::vector<Descriptor> first_centers(std::span<const Descriptor> descriptors, int k,
                                      Random& random) {
  std::vector<Descriptor> centers = {descriptors[random.below(descriptors.size())]};
  std::vector<std::uint16_t> distances(descriptors.size());
  constexpr std::uint64_t kFar = (Descriptor::kBits + 1) * (Descriptor::kBits + 1);
  std::vector<std::uint64_t> squares(descriptors.size(), kFar);
  while (centers.size() < static_cast<std::size_t>(k)) {
    hamming_distances(centers.back(), descriptors, distances);
    for (std::size_t i = 0; i < squares.size(); ++i) {
      const std::uint64_t d = distances[i];
      squares[i] = std::min(squares[i], d * d);
    }
    const std::uint64_t total = std::accumulate(squares.begin(), squares.end(), std::uint64_t{0});
    if (total == 0) break;
    centers.push_back(descriptors[index_at(squares, random.below(total))]);
  }
  return centers;
}

/// Assigns each descriptor to the nearest centre. Returns true if any assignment changed.
bool assign(std::span<const Descriptor> descriptors, Clusters& clusters) {
  bool changed = false;
  for (std::size_t i = 0; i < descriptors.size(); ++i) {
    const auto nearest =
        static_cast<std::uint32_t>(nearest_descriptor(descriptors[i], clusters.centers).index);
    changed |= nearest != clusters.members[i];
    clusters.members[i] = nearest;
  }
  return changed;
}

/// Moves the centres to the majorities of their members; centres without members are removed.
void update_centers(std::span<const Descriptor> descriptors, Clusters& clusters) {
  std::vector<BitCounter> counters(clusters.centers.size());
  for (std::size_t i = 0; i < descriptors.size(); ++i) {
    counters[clusters.members[i]].add(descriptors[i]);
  }
  std::vector<Descriptor> centers;
  std::vector<std::uint32_t> new_index(counters.size());
  for (std::size_t c = 0; c < counters.size(); ++c) {
    new_index[c] = static_cast<std::uint32_t>(centers.size());
    if (counters[c].total() > 0) centers.push_back(counters[c].majority());
  }
  clusters.centers = std::move(centers);
  for (std::uint32_t& member : clusters.members) member = new_index[member];
}

}  // namespace

Clusters cluster(std::span<const Descriptor> descriptors, int k, int iterations, Random random) {
  Clusters clusters;
  if (descriptors.empty()) return clusters;
  clusters.centers = first_centers(descriptors, k, random);
  clusters.members.assign(descriptors.size(), 0);
  assign(descriptors, clusters);
  for (int i = 0; i < iterations; ++i) {
    update_centers(descriptors, clusters);
    if (!assign(descriptors, clusters)) return clusters;
  }
  update_centers(descriptors, clusters);
  return clusters;
}

}  // namespace cvo_slam
