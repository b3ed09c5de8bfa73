// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Features as bytes: all of one kind, then all of the next, so that they compress well. Integers
// and floats are little-endian.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/loop/orb_features.h"

namespace cvo_slam {
namespace {

constexpr float kPixelSteps = 16;   // a pixel
constexpr float kAngleSteps = 256;  // a turn
constexpr float kFullTurn = 2 * std::numbers::pi_v<float>;
constexpr std::size_t kFeatureBytes = 2 * sizeof(std::uint16_t) + 2 * sizeof(float) + 1 +
                                      Descriptor::kBytes;  // u, v, depth, size, angle

template <typename T>
void append_value(const T& value, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

template <typename T>
T take_value(const char*& bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(value));
  bytes += sizeof(value);
  return value;
}

std::uint16_t pixel_code(float pixel) {
  constexpr long kLargest = std::numeric_limits<std::uint16_t>::max();
  return static_cast<std::uint16_t>(std::clamp(std::lround(kPixelSteps * pixel), 0L, kLargest));
}

std::uint8_t angle_code(float angle) {
  return static_cast<std::uint8_t>(std::lround(kAngleSteps * angle / kFullTurn) % 256);
}

}  // namespace

std::string features_to_bytes(const OrbFeatures& features) {
  std::string bytes;
  bytes.reserve(features.size() * kFeatureBytes);
  for (const OrbFeature& point : features.points) append_value(pixel_code(point.u), bytes);
  for (const OrbFeature& point : features.points) append_value(pixel_code(point.v), bytes);
  for (const OrbFeature& point : features.points) append_value(point.depth, bytes);
  for (const OrbFeature& point : features.points) append_value(point.size, bytes);
  for (const OrbFeature& point : features.points) append_value(angle_code(point.angle), bytes);
  for (const Descriptor& descriptor : features.descriptors) {
    append_value(to_bytes(descriptor), bytes);
  }
  return bytes;
}

OrbFeatures features_from_bytes(std::string_view bytes, const PinholeCamera& camera) {
  if (bytes.size() % kFeatureBytes != 0) {
    throw DataError(
        fmt::format("the features of a keyframe are damaged: {} bytes, which {} a "
                    "feature do not divide",
                    bytes.size(), kFeatureBytes));
  }
  OrbFeatures features;
  features.points.resize(bytes.size() / kFeatureBytes);
  const char* next = bytes.data();
  for (OrbFeature& point : features.points) {
    point.u = static_cast<float>(take_value<std::uint16_t>(next)) / kPixelSteps;
  }
  for (OrbFeature& point : features.points) {
    point.v = static_cast<float>(take_value<std::uint16_t>(next)) / kPixelSteps;
    const Vector3 ray = camera.unproject({point.u, point.v});
    point.x = static_cast<float>(ray.x());
    point.y = static_cast<float>(ray.y());
  }
  for (OrbFeature& point : features.points) point.depth = take_value<float>(next);
  for (OrbFeature& point : features.points) point.size = take_value<float>(next);
  for (OrbFeature& point : features.points) {
    point.angle = static_cast<float>(take_value<std::uint8_t>(next)) * kFullTurn / kAngleSteps;
  }
  for (std::size_t i = 0; i < features.points.size(); ++i) {
    features.descriptors.push_back(from_bytes(take_value<DescriptorBytes>(next)));
  }
  const auto is_possible = [](const OrbFeature& point) {
    return point.depth >= 0 && std::isfinite(point.depth) && point.size > 0 &&
           std::isfinite(point.size);
  };
  if (!std::all_of(features.points.begin(), features.points.end(), is_possible)) {
    throw DataError("the features of a keyframe are damaged: one has no possible depth or size");
  }
  return features;
}

}  // namespace cvo_slam
