// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
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

constexpr float kRaySteps = 8192;                                // a unit of x/z
constexpr LogScale kDepth = {.smallest = 0.02, .step = 1.4e-4};  // [m]
constexpr LogScale kNoise = {.smallest = 1e-5, .step = 0.047};   // [m], up to 1.6 m
constexpr float kOctahedron = 127;

const LogValues& depths() {
  static const LogValues values(kDepth);
  return values;
}

const LogValues& noises() {
  static const LogValues values(kNoise);
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
  std::uint32_t has_ray_noise;
  float color_step;
  float gradient_step;
  float surface_noise;
};

/// Appends the first byte of all records, the second of all, ...
template <typename Record>
void append_planes(const std::vector<Record>& records, std::string& bytes) {
  static_assert(std::has_unique_object_representations_v<Record>);
  const auto* const raw = reinterpret_cast<const char*>(records.data());
  for (std::size_t k = 0; k < sizeof(Record); ++k) {
    for (std::size_t i = 0; i < records.size(); ++i) bytes += raw[i * sizeof(Record) + k];
  }
}

template <typename Record>
void read_planes(const char* bytes, std::vector<Record>& records) {
  auto* const raw = reinterpret_cast<char*>(records.data());
  for (std::size_t k = 0; k < sizeof(Record); ++k) {
    for (std::size_t i = 0; i < records.size(); ++i) raw[i * sizeof(Record) + k] = *bytes++;
  }
}

float sign_of(float value) { return value < 0 ? -1.0F : 1.0F; }

/// A point of the square that the octahedron |x| + |y| + |z| = 1 unfolds to, for a unit vector.
Eigen::Vector2f unfolded(const Eigen::Vector3f& normal) {
  const Eigen::Vector3f p = normal / normal.cwiseAbs().sum();
  if (p.z() >= 0) return p.head<2>();
  return {(1 - std::fabs(p.y())) * sign_of(p.x()), (1 - std::fabs(p.x())) * sign_of(p.y())};
}

Eigen::Vector3f folded(const Eigen::Vector2f& q) {
  Eigen::Vector3f p(q.x(), q.y(), 1 - std::fabs(q.x()) - std::fabs(q.y()));
  if (p.z() < 0) {
    p.x() = (1 - std::fabs(q.y())) * sign_of(q.x());
    p.y() = (1 - std::fabs(q.x())) * sign_of(q.y());
  }
  return p.normalized();
}

}  // namespace

CompactCloud::CompactCloud(const PointCloud& cloud)
    : color_step_(step_for(std::span(cloud.features).first(3), 255)),
      gradient_step_(step_for(std::span(cloud.features).last(2), 127)),
      surface_noise_(cloud.surface_noise),
      has_ray_noise_(!cloud.ray_noise.empty()),
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
    point.x = rounded<std::int16_t>(kRaySteps * cloud.x[i] / cloud.z[i]);
    point.y = rounded<std::int16_t>(kRaySteps * cloud.y[i] / cloud.z[i]);
    point.log_z = kDepth.code<std::uint16_t>(cloud.z[i]);
    point.blue = color(0, i);
    point.green = color(1, i);
    point.red = color(2, i);
    point.dx = gradient(3, i);
    point.dy = gradient(4, i);
    if (has_ray_noise_) point.log_ray_noise = kNoise.code<std::uint8_t>(cloud.ray_noise[i]);
  }
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const auto& [normal, roughness] = cloud.surfaces[i];
    if (normal.isZero()) continue;
    const Eigen::Vector2f place = kOctahedron * unfolded(normal);
    surfaces_[i] = {rounded<std::int8_t>(place.x()), rounded<std::int8_t>(place.y()),
                    std::max<std::uint8_t>(1, kNoise.code<std::uint8_t>(roughness))};
  }
}

Vector3 CompactCloud::position(std::size_t i) const {
  const Point& point = points_[i];
  const float z = depths()[point.log_z];
  return {static_cast<float>(point.x) / kRaySteps * z, static_cast<float>(point.y) / kRaySteps * z,
          z};
}

PointCloud CompactCloud::points() const {
  PointCloud cloud;
  cloud.ray_noise.resize(has_ray_noise_ ? size() : 0);
  cloud.surfaces.resize(surfaces_.size());
  cloud.surface_noise = surface_noise_;
  cloud.resize(size());
  for (std::size_t i = 0; i < size(); ++i) {
    const Point& point = points_[i];
    const float z = depths()[point.log_z];
    cloud.x[i] = static_cast<float>(point.x) / kRaySteps * z;
    cloud.y[i] = static_cast<float>(point.y) / kRaySteps * z;
    cloud.z[i] = z;
    cloud.features[0][i] = color_step_ * static_cast<float>(point.blue);
    cloud.features[1][i] = color_step_ * static_cast<float>(point.green);
    cloud.features[2][i] = color_step_ * static_cast<float>(point.red);
    cloud.features[3][i] = gradient_step_ * static_cast<float>(point.dx);
    cloud.features[4][i] = gradient_step_ * static_cast<float>(point.dy);
    if (has_ray_noise_) cloud.ray_noise[i] = noises()[point.log_ray_noise];
  }
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const Surface& surface = surfaces_[i];
    if (surface.log_roughness == 0) continue;
    const Eigen::Vector2f place(static_cast<float>(surface.a), static_cast<float>(surface.b));
    cloud.surfaces[i] = {folded(place / kOctahedron), noises()[surface.log_roughness]};
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
                         has_ray_noise_ ? 1U : 0U,
                         color_step_,
                         gradient_step_,
                         surface_noise_};
  std::string bytes(reinterpret_cast<const char*>(&header), sizeof(header));
  append_planes(points_, bytes);
  append_planes(surfaces_, bytes);
  return bytes;
}

CompactCloud CompactCloud::from_bytes(std::string_view bytes) {
  Header header;
  if (bytes.size() < sizeof(header)) throw DataError("the points of a keyframe are cut off");
  std::memcpy(&header, bytes.data(), sizeof(header));
  const std::size_t expected =
      sizeof(header) + header.points * sizeof(Point) + header.surfaces * sizeof(Surface);
  const bool is_possible = std::isfinite(header.color_step) &&
                           std::isfinite(header.gradient_step) && header.surface_noise >= 0 &&
                           (header.surfaces == 0 || header.surfaces == header.points);
  if (bytes.size() != expected || !is_possible) {
    throw DataError(fmt::format("the points of a keyframe are damaged: {} bytes, expected {}",
                                bytes.size(), expected));
  }
  CompactCloud cloud;
  cloud.color_step_ = header.color_step;
  cloud.gradient_step_ = header.gradient_step;
  cloud.surface_noise_ = header.surface_noise;
  cloud.has_ray_noise_ = header.has_ray_noise != 0;
  cloud.points_.resize(header.points);
  cloud.surfaces_.resize(header.surfaces);
  const char* const first = bytes.data() + sizeof(header);
  read_planes(first, cloud.points_);
  read_planes(first + header.points * sizeof(Point), cloud.surfaces_);
  return cloud;
}

}  // namespace cvo_slam
