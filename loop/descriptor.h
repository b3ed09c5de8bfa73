// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace cvo_slam {

/// The 256 binary tests of an ORB descriptor.
struct Descriptor {
  static constexpr std::size_t kBits = 256;
  static constexpr std::size_t kBytes = kBits / 8;

  /// Bit i of the descriptor is bit i % 64 of word i / 64.
  std::array<std::uint64_t, 4> words{};

  [[nodiscard]] bool bit(std::size_t i) const { return ((words[i / 64] >> (i % 64)) & 1U) != 0; }
  bool operator==(const Descriptor&) const = default;
};

/// Byte i holds bits 8 i to 8 i + 7, as in OpenCV's rows and in vocabulary files.
using DescriptorBytes = std::array<std::uint8_t, Descriptor::kBytes>;
[[nodiscard]] Descriptor from_bytes(std::span<const std::uint8_t, Descriptor::kBytes> bytes);
[[nodiscard]] DescriptorBytes to_bytes(const Descriptor& descriptor);

/// One descriptor a row of OpenCV's matrix; none of an empty one. Throws DataError where it is not
/// CV_8UC1 with 32 columns.
[[nodiscard]] std::vector<Descriptor> to_descriptors(const cv::Mat& rows);

}  // namespace cvo_slam
