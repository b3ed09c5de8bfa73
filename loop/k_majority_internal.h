// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cvo_slam/loop/descriptor.h"
#include "cvo_slam/loop/random_internal.h"

namespace cvo_slam {

/// A partition of descriptors.
struct Clusters {
  std::vector<Descriptor> centers;     ///< none without members
  std::vector<std::uint32_t> members;  ///< of each descriptor, the index of its cluster
};

/// Parts the descriptors into at most k clusters: k-means of binary vectors, whose means are
/// majorities of bits (C. Grana et al., "A fast approach for integrating ORB descriptors in the bag
/// of words model", SPIE 2013). It starts with k-means++ (D. Arthur and S. Vassilvitskii, SODA
/// 2007) and ends when no descriptor changes its cluster, or after `iterations`. With at most k
/// different descriptors each is a cluster.
[[nodiscard]] Clusters cluster(std::span<const Descriptor> descriptors, int k, int iterations,
                               Random random);

}  // namespace cvo_slam
