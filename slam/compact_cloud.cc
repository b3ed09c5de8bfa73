// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/slam/compact_cloud_internal.h"

namespace cvo_slam {
namespace {

/// Whole numbers for positive values on a logarithmic scale: `smallest` is 0.
struct LogScale {
  double smallest = 1;
  double step = 1;  // of the logarithm

  template <typename Integer>
  [[nodiscard]] Integer code(double value) const {
    const double steps = std::log(std::max(value, smallest) / smallest) / step;
    return static_cast<Integer>(
        std::min<long>(std::lround(steps), std::numeric_limits<Integer>::max()));
  }
};

/// The values of a logarithmic scale, as products of two of few: an exponential function takes
/// longer than all else that reading a point takes.
class LogValues {
 public:
  explicit LogValues(const LogScale& scale) {
    for (int i = 0; i < kFew; ++i) {
      low_[static_cast<std::size_t>(i)] = scale.smallest * std::exp(scale.step * i);
      high_[static_cast<std::size_t>(i)] = std::exp(scale.step * kFew * i);
    }
  }
  [[nodiscard]] float operator[](std::size_t code) const {
    return static_cast<float>(low_[code % kFew] * high_[code / kFew]);
  }

 private:
  static constexpr int kFew = 256;
  std::array<double, kFew> low_{};
  std::array<double, kFew> high_{};
};

constexpr float kRaySteps = 8192;                                   // a unit of x/z
constexpr LogScale kDepth = {.smallest = 0.02, .step = 1.4e-4};     // [m]
constexpr LogScale kRoughness = {.smallest = 1e-5, .step = 0.047};  // [m], up to 1.6 m
constexpr float kOctahedron = 127;

const LogValues& depths() {
  static const LogValues values(kDepth);
  return values;
}

const LogValues& roughnesses() {
  static const LogValues values(kRoughness);
  return values;
}

template <typename Integer>
Integer rounded(float value) {
  using Limits = std::numeric_limits<Integer>;
  return static_cast<Integer>(std::clamp<long>(std::lround(value), Limits::min(), Limits::max()));
}

/// The values of a step that brings all of `arrays` within +-`largest_code`, at least 1.
float step_for(std::span<const std::vector<float>> arrays, float largest_code) {
  float largest = largest_code;
  for (const auto& array : arrays) {
    for (const float value : array) largest = std::max(largest, std::fabs(value));
  }
  return largest / largest_code;
}

/// What comes before the points in a file, little-endian like all of it.
struct Header {
  std::uint32_t points;
  std::uint32_t surfaces;
  float ray_noise_floor;
  float ray_noise_quadratic;
  float color_step;
  float gradient_step;
  float surface_noise;
};

template <typename Record>
std::string_view raw(const std::vector<Record>& records) {
  static_assert(std::has_unique_object_representations_v<Record>);
  return {reinterpret_cast<const char*>(records.data()), records.size() * sizeof(Record)};
}

template <typename Record>
void read_records(const char*& bytes, std::vector<Record>& records) {
  const std::size_t size = records.size() * sizeof(Record);
  if (size > 0) std::memcpy(records.data(), bytes, size);
  bytes += size;
}

}  // namespace

CompactCloud::RayNoise CompactCloud::RayNoise::of(const PointCloud& cloud) {
  // Near points show the floor, far ones the quadratic part, and neither shows less of the other.
  RayNoise noise;
  for (std::size_t i = 0; i < cloud.ray_noise.size(); ++i) {
    const Vector3 p = cloud.position(i);
    const auto sigma_z = static_cast<float>(cloud.ray_noise[i] * p.z() / p.norm());
    const float quadratic = sigma_z / (cloud.z[i] * cloud.z[i]);
    noise.floor = i == 0 ? sigma_z : std::min(noise.floor, sigma_z);
    noise.quadratic = i == 0 ? quadratic : std::min(noise.quadratic, quadratic);
  }
  return noise;
}

float CompactCloud::RayNoise::at(const Vector3& point) const {
  const auto z = static_cast<float>(point.z());
  return std::max(floor, quadratic * z * z) * static_cast<float>(point.norm()) / z;
}

CompactCloud::CompactCloud(const PointCloud& cloud)
    : color_step_(step_for(std::span(cloud.features).first(3), 255)),
      gradient_step_(step_for(std::span(cloud.features).last(2), 127)),
      surface_noise_(cloud.surface_noise),
      ray_noise_(RayNoise::of(cloud)),
      points_(cloud.size()),
      surfaces_(cloud.surfaces.size()) {
  const auto color = [&](std::size_t channel, std::size_t i) {
    return rounded<std::uint8_t>(cloud.features[channel][i] / color_step_);
  };
  const auto gradient = [&](std::size_t channel, std::size_t i) {
    return rounded<std::int8_t>(cloud.features[channel][i] / gradient_step_);
  };
  for (std::size_t i = 0; i < points_.size(); ++i) {
    Point& point = points_[i];
    point.x = std::bit_cast<TwoBytes>(rounded<std::int16_t>(kRaySteps * cloud.x[i] / cloud.z[i]));
    point.y = std::bit_cast<TwoBytes>(rounded<std::int16_t>(kRaySteps * cloud.y[i] / cloud.z[i]));
    point.log_z = std::bit_cast<TwoBytes>(kDepth.code<std::uint16_t>(cloud.z[i]));
    point.blue = color(0, i);
    point.green = color(1, i);
    point.red = color(2, i);
    point.dx = gradient(3, i);
    point.dy = gradient(4, i);
  }
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const auto& [normal, roughness] = cloud.surfaces[i];
    if (normal.isZero()) continue;
    const Eigen::Vector2f place = kOctahedron * to_octahedron(normal);
    surfaces_[i] = {rounded<std::int8_t>(place.x()), rounded<std::int8_t>(place.y()),
                    std::max<std::uint8_t>(1, kRoughness.code<std::uint8_t>(roughness))};
  }
}

Vector3 CompactCloud::position(std::size_t i) const {
  const Point& point = points_[i];
  const float z = depths()[std::bit_cast<std::uint16_t>(point.log_z)];
  const auto along = [z](const TwoBytes& ray) {
    return static_cast<float>(std::bit_cast<std::int16_t>(ray)) / kRaySteps * z;
  };
  return {along(point.x), along(point.y), z};
}

PointCloud CompactCloud::points() const {
  PointCloud cloud;
  cloud.ray_noise.resize(ray_noise_.floor > 0 ? size() : 0);
  cloud.surfaces.resize(surfaces_.size());
  cloud.surface_noise = surface_noise_;
  cloud.resize(size());
  for (std::size_t i = 0; i < size(); ++i) {
    const Point& point = points_[i];
    const Vector3 p = position(i);
    cloud.x[i] = static_cast<float>(p.x());
    cloud.y[i] = static_cast<float>(p.y());
    cloud.z[i] = static_cast<float>(p.z());
    cloud.features[0][i] = color_step_ * static_cast<float>(point.blue);
    cloud.features[1][i] = color_step_ * static_cast<float>(point.green);
    cloud.features[2][i] = color_step_ * static_cast<float>(point.red);
    cloud.features[3][i] = gradient_step_ * static_cast<float>(point.dx);
    cloud.features[4][i] = gradient_step_ * static_cast<float>(point.dy);
    if (!cloud.ray_noise.empty()) cloud.ray_noise[i] = ray_noise_.at(p);
  }
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const Surface& surface = surfaces_[i];
    if (surface.log_roughness == 0) continue;
    const Eigen::Vector2f place(static_cast<float>(surface.a), static_cast<float>(surface.b));
    cloud.surfaces[i] = {from_octahedron(place / kOctahedron),
                         roughnesses()[surface.log_roughness]};
  }
  return cloud;
}

std::size_t CompactCloud::bytes() const {
  return sizeof(CompactCloud) + points_.capacity() * sizeof(Point) +
         surfaces_.capacity() * sizeof(Surface);
}

std::string CompactCloud::to_bytes() const {
  const Header header = {static_cast<std::uint32_t>(points_.size()),
                         static_cast<std::uint32_t>(surfaces_.size()),
                         ray_noise_.floor,
                         ray_noise_.quadratic,
                         color_step_,
                         gradient_step_,
                         surface_noise_};
  std::string bytes(reinterpret_cast<const char*>(&header), sizeof(header));
  bytes += raw(points_);
  bytes += raw(surfaces_);
  return bytes;
}

CompactCloud CompactCloud::from_bytes(std::string_view bytes) {
  Header header;
  if (bytes.size() < sizeof(header)) throw DataError("the points of a keyframe are cut off");
  std::memcpy(&header, bytes.data(), sizeof(header));
  const std::size_t expected =
      sizeof(header) + header.points * sizeof(Point) + header.surfaces * sizeof(Surface);
  const auto is_deviation = [](float value) { return value >= 0 && std::isfinite(value); };
  const bool is_possible = std::isfinite(header.color_step) &&
                           std::isfinite(header.gradient_step) && header.surface_noise >= 0 &&
                           is_deviation(header.ray_noise_floor) &&
                           is_deviation(header.ray_noise_quadratic) &&
                           (header.surfaces == 0 || header.surfaces == header.points);
  if (bytes.size() != expected || !is_possible) {
    throw DataError(fmt::format("the points of a keyframe are damaged: {} bytes, expected {}",
                                bytes.size(), expected));
  }
  CompactCloud cloud;
  cloud.color_step_ = header.color_step;
  cloud.gradient_step_ = header.gradient_step;
  cloud.surface_noise_ = header.surface_noise;
  cloud.ray_noise_ = {header.ray_noise_floor, header.ray_noise_quadratic};
  cloud.points_.resize(header.points);
  cloud.surfaces_.resize(header.surfaces);
  const char* next = bytes.data() + sizeof(header);
  read_records(next, cloud.points_);
  read_records(next, cloud.surfaces_);
  return cloud;
}

}  // namespace cvo_slam
