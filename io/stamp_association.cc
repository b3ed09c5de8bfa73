// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <tuple>

#include "cvo_slam/io/stamp_association_internal.h"

namespace cvo_slam {
namespace {

/// (difference [ns], index in a, index in b): the order in which pairs are taken.
using Candidate = std::tuple<std::int64_t, std::size_t, std::size_t>;

std::vector<Candidate> find_candidates(const std::vector<Timestamp>& a,
                                       const std::vector<Timestamp>& b, std::int64_t max) {
  std::vector<Candidate> candidates;
  std::size_t first = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto difference = [&](std::size_t j) { return b[j].nanoseconds() - a[i].nanoseconds(); };
    while (first < b.size() && difference(first) < -max) ++first;
    for (std::size_t j = first; j < b.size() && difference(j) <= max; ++j) {
      candidates.emplace_back(std::abs(difference(j)), i, j);
    }
  }
  return candidates;
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> associate_stamps(const std::vector<Timestamp>& a,
                                                                  const std::vector<Timestamp>& b,
                                                                  double max_difference) {
  auto candidates = find_candidates(a, b, std::llround(max_difference * 1e9));
  std::sort(candidates.begin(), candidates.end());
  std::vector<bool> a_taken(a.size()), b_taken(b.size());
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const auto& [difference, i, j] : candidates) {
    if (a_taken[i] || b_taken[j]) continue;
    a_taken[i] = b_taken[j] = true;
    pairs.emplace_back(i, j);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace cvo_slam
