// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/frontend/simd.h"
#include "cvo_slam/loop/descriptor.h"
#include "cvo_slam/tests/loop/descriptor_samples.h"

namespace cvo_slam {
namespace {

/// Returns the distance by its definition, bit by bit.
int counted_distance(const Descriptor& a, const Descriptor& b) {
  int distance = 0;
  for (std::size_t i = 0; i < Descriptor::kBits; ++i) distance += a.bit(i) != b.bit(i) ? 1 : 0;
  return distance;
}

class Hamming : public testing::Test {
 protected:
  ~Hamming() override { pin_simd(SimdPath::kBest); }

  DescriptorSource source_{1};
};

TEST_F(Hamming, CountsTheBitsThatDiffer) {
  for (int i = 0; i < 100; ++i) {
    const Descriptor a = source_.random();
    const Descriptor b = source_.random();
    EXPECT_EQ(hamming_distance(a, b), counted_distance(a, b));
  }
  Descriptor all;
  all.words.fill(~std::uint64_t{0});
  EXPECT_EQ(hamming_distance(all, Descriptor()), 256);
  EXPECT_EQ(hamming_distance(all, all), 0);
}

TEST_F(Hamming, EveryInstructionSetGivesTheSameNumbers) {
  const Descriptor query = source_.random();
  std::vector<Descriptor> candidates = source_.random(37);
  candidates.emplace_back();
  candidates.back().words.fill(~std::uint64_t{0});
  for (const auto& [name, path] : simd_path_names()) {
    try {
      pin_simd(path);
    } catch (const OptionError&) {
      continue;  // not on this CPU
    }
    SCOPED_TRACE(name);
    std::vector<std::uint16_t> distances(candidates.size());
    hamming_distances(query, candidates, distances);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      EXPECT_EQ(distances[i], counted_distance(query, candidates[i]));
    }
  }
}

TEST_F(Hamming, NearestIsTheFirstOfTheNearest) {
  const Descriptor query = source_.random();
  std::vector<Descriptor> candidates = source_.random(20);
  candidates[7] = query;
  candidates[7].words[0] ^= 1U;
  candidates[3] = query;
  candidates[3].words[3] ^= 1U << 5U;
  const NearestDescriptor nearest = nearest_descriptor(query, candidates);
  EXPECT_EQ(nearest.index, 3);
  EXPECT_EQ(nearest.distance, 1);
  EXPECT_GT(nearest_descriptor(query, {}).distance, 256);
}

TEST(Descriptor, BytesAreThoseOfOpenCv) {
  cv::Mat row(1, 32, CV_8UC1, cv::Scalar(0));
  row.at<std::uint8_t>(0, 9) = 0b101;  // bits 72 and 74
  const Descriptor descriptor = to_descriptors(row).at(0);
  for (std::size_t i = 0; i < Descriptor::kBits; ++i) {
    EXPECT_EQ(descriptor.bit(i), i == 72 || i == 74) << i;
  }
  EXPECT_EQ(to_bytes(descriptor)[9], 0b101);
  EXPECT_EQ(from_bytes(to_bytes(descriptor)), descriptor);
}

TEST(Descriptor, MatricesOfAnotherKindAreRefused) {
  EXPECT_TRUE(to_descriptors(cv::Mat()).empty());
  for (const cv::Mat& wrong :
       {cv::Mat(3, 64, CV_8UC1), cv::Mat(3, 31, CV_8UC1), cv::Mat(3, 32, CV_32FC1)}) {
    EXPECT_THROW(static_cast<void>(to_descriptors(wrong)), DataError);
  }
}

}  // namespace
}  // namespace cvo_slam
