// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/loop/descriptor.h"

#include <fmt/format.h>

#include "cvo_slam/core/error.h"

namespace cvo_slam {

// Compilers for little-endian machines turn both conversions into plain copies.
Descriptor from_bytes(std::span<const std::uint8_t, Descriptor::kBytes> bytes) {
  Descriptor descriptor;
  for (std::size_t i = 0; i < Descriptor::kBytes; ++i) {
    descriptor.words[i / 8] |= static_cast<std::uint64_t>(bytes[i]) << (8 * (i % 8));
  }
  return descriptor;
}

DescriptorBytes to_bytes(const Descriptor& descriptor) {
  DescriptorBytes bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes[i] = static_cast<std::uint8_t>(descriptor.words[i / 8] >> (8 * (i % 8)));
  }
  return bytes;
}

std::vector<Descriptor> to_descriptors(const cv::Mat& rows) {
  if (rows.empty()) return {};
  if (rows.type() != CV_8UC1 || rows.cols != static_cast<int>(Descriptor::kBytes)) {
    throw DataError(
        fmt::format("descriptors of {} bytes (OpenCV type {}): ORB descriptors have {} (type 0)",
                    rows.cols, rows.type(), Descriptor::kBytes));
  }
  std::vector<Descriptor> descriptors;
  descriptors.reserve(static_cast<std::size_t>(rows.rows));
  for (int i = 0; i < rows.rows; ++i) {
    descriptors.push_back(from_bytes(
        std::span<const std::uint8_t, Descriptor::kBytes>(rows.ptr(i), Descriptor::kBytes)));
  }
  return descriptors;
}

}  // namespace cvo_slam
