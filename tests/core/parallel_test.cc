// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/parallel.h"

#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace cvo_slam {
namespace {

double chunked_sum(const Executor& executor, const std::vector<double>& values) {
  constexpr std::size_t kChunk = 64;
  std::vector<double> partial(Executor::chunk_count(values.size(), kChunk));
  executor.for_each_chunk(values.size(), kChunk,
                          [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                            for (std::size_t i = begin; i < end; ++i) partial[chunk] += values[i];
                          });
  return std::accumulate(partial.begin(), partial.end(), 0.0);
}

TEST(Executor, SumsAreTheSameToTheBitForAnyNumberOfThreads) {
  std::vector<double> values(10007);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = std::sin(static_cast<double>(i)) * 1e3;
  const double expected = chunked_sum(Executor(1), values);
  for (const int threads : {2, 3, 8}) {
    EXPECT_EQ(chunked_sum(Executor(threads), values), expected) << threads;
  }
}

TEST(Executor, CoversTheRangeOnceAndAllowsAnEmptyOne) {
  for (const int threads : {1, 4}) {
    const Executor executor(threads);
    std::vector<int> touched(130, 0);
    executor.for_each_chunk(touched.size(), 64,
                            [&](std::size_t, std::size_t begin, std::size_t end) {
                              for (std::size_t i = begin; i < end; ++i) ++touched[i];
                            });
    EXPECT_EQ(touched, std::vector<int>(130, 1));
    executor.for_each_chunk(0, 64, [](std::size_t, std::size_t, std::size_t) { FAIL(); });
  }
}

}  // namespace
}  // namespace cvo_slam
