// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

#include <Eigen/Core>
#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/loop/compact_features_internal.h"

namespace cvo_slam {
namespace {

constexpr float kPixelSteps = 16;   // a pixel, in images up to 4096 px
constexpr float kAngleSteps = 256;  // a turn
constexpr float kFullTurn = 2 * std::numbers::pi_v<float>;
/// OrbOptions::levels allows 16; a byte counts them.
constexpr std::size_t kMostSizes = 255;

constexpr long kLargestCode = std::numeric_limits<std::uint16_t>::max();

/// As many steps a pixel as two bytes have for the whole image.
float pixel_steps_for(const OrbFeatures& features) {
  float largest = 0;
  for (const OrbFeature& feature : features.points) {
    largest = std::max({largest, feature.u, feature.v});
  }
  float steps = kPixelSteps;
  while (steps * largest > static_cast<float>(kLargestCode) && steps > 1) steps /= 2;
  return steps;
}

std::uint16_t pixel_code(float pixel, float steps) {
  return static_cast<std::uint16_t>(std::clamp(std::lround(steps * pixel), 0L, kLargestCode));
}

std::uint8_t angle_code(float angle) {
  return static_cast<std::uint8_t>(std::lround(kAngleSteps * angle / kFullTurn) % 256);
}

std::uint16_t depth_code(float depth) {
  const Eigen::half value(
      std::min(depth, static_cast<float>(std::numeric_limits<Eigen::half>::max())));
  return Eigen::numext::bit_cast<std::uint16_t>(value);
}

float depth_of(std::uint16_t code) {
  return static_cast<float>(Eigen::numext::bit_cast<Eigen::half>(code));
}

/// What comes before the features in a file.
struct FeatureHeader {
  std::uint32_t features = 0;
  std::uint32_t sizes = 0;
  float pixel_steps = kPixelSteps;
};

[[noreturn]] void fail_as_damaged(const std::string& what) {
  throw DataError(fmt::format("the features of a keyframe are damaged: {}", what));
}

}  // namespace

CompactFeatures::CompactFeatures(const OrbFeatures& features)
    : pixel_steps_(pixel_steps_for(features)), descriptors_(features.descriptors) {
  points_.reserve(features.size());
  for (const OrbFeature& feature : features.points) {
    auto size = std::find(sizes_.begin(), sizes_.end(), feature.size);
    if (size == sizes_.end() && sizes_.size() < kMostSizes) {
      size = sizes_.insert(size, feature.size);
    }
    const auto size_index = static_cast<std::uint8_t>(
        std::min(sizes_.size() - 1, static_cast<std::size_t>(size - sizes_.begin())));
    points_.push_back({pixel_code(feature.u, pixel_steps_), pixel_code(feature.v, pixel_steps_),
                       depth_code(feature.depth), angle_code(feature.angle), size_index});
  }
}

OrbFeatures CompactFeatures::features(const PinholeCamera& camera) const {
  OrbFeatures features;
  features.descriptors = descriptors_;
  features.points.reserve(points_.size());
  for (const Point& point : points_) {
    OrbFeature& feature = features.points.emplace_back();
    feature.u = static_cast<float>(point.u) / pixel_steps_;
    feature.v = static_cast<float>(point.v) / pixel_steps_;
    const Vector3 ray = camera.unproject({feature.u, feature.v});
    feature.x = static_cast<float>(ray.x());
    feature.y = static_cast<float>(ray.y());
    feature.depth = depth_of(point.depth);
    feature.angle = static_cast<float>(point.angle) * kFullTurn / kAngleSteps;
    feature.size = sizes_[point.size];
  }
  return features;
}

std::size_t CompactFeatures::bytes() const {
  return sizeof(CompactFeatures) + sizes_.size() * sizeof(float) + points_.size() * sizeof(Point) +
         descriptors_.size() * sizeof(Descriptor);
}

std::string CompactFeatures::to_bytes() const {
  const FeatureHeader header = {static_cast<std::uint32_t>(points_.size()),
                                static_cast<std::uint32_t>(sizes_.size()), pixel_steps_};
  std::string bytes(reinterpret_cast<const char*>(&header), sizeof(header));
  bytes.append(reinterpret_cast<const char*>(sizes_.data()), sizes_.size() * sizeof(float));
  bytes.append(reinterpret_cast<const char*>(points_.data()), points_.size() * sizeof(Point));
  for (const Descriptor& descriptor : descriptors_) {
    const DescriptorBytes row = cvo_slam::to_bytes(descriptor);
    bytes.append(reinterpret_cast<const char*>(row.data()), row.size());
  }
  return bytes;
}

CompactFeatures CompactFeatures::from_bytes(std::string_view bytes) {
  FeatureHeader header;
  if (bytes.size() < sizeof(header)) fail_as_damaged("they are cut off");
  std::memcpy(&header, bytes.data(), sizeof(header));
  const std::size_t expected = sizeof(header) + header.sizes * sizeof(float) +
                               header.features * (sizeof(Point) + Descriptor::kBytes);
  if (bytes.size() != expected || header.sizes > kMostSizes) {
    fail_as_damaged(fmt::format("{} bytes, expected {}", bytes.size(), expected));
  }
  CompactFeatures result;
  result.pixel_steps_ = header.pixel_steps;
  result.sizes_.resize(header.sizes);
  result.points_.resize(header.features);
  const char* next = bytes.data() + sizeof(header);
  const auto take = [&next](auto& values) {
    const std::size_t size = values.size() * sizeof(values[0]);
    if (size > 0) std::memcpy(values.data(), next, size);
    next += size;
  };
  take(result.sizes_);
  take(result.points_);
  result.descriptors_.reserve(header.features);
  for (std::size_t i = 0; i < header.features; ++i, next += Descriptor::kBytes) {
    DescriptorBytes row;
    std::memcpy(row.data(), next, row.size());
    result.descriptors_.push_back(cvo_slam::from_bytes(row));
  }
  const auto is_size = [](float size) { return size > 0 && std::isfinite(size); };
  const auto is_possible = [&](const Point& point) {
    const float depth = depth_of(point.depth);
    return depth >= 0 && std::isfinite(depth) && point.size < header.sizes;
  };
  if (!(header.pixel_steps >= 1 && header.pixel_steps <= kPixelSteps) ||
      !std::all_of(result.sizes_.begin(), result.sizes_.end(), is_size) ||
      !std::all_of(result.points_.begin(), result.points_.end(), is_possible)) {
    fail_as_damaged("one has no possible place, depth or size");
  }
  return result;
}

}  // namespace cvo_slam
