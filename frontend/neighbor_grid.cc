// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "cvo_slam/frontend/neighbor_grid_internal.h"

namespace cvo_slam {
namespace {

/// More columns than this cost more to clear than they save. Clouds so wide get wider columns.
constexpr double kMaxColumns = 1 << 16;

std::vector<std::uint32_t> finite_points(const PointCloud& cloud) {
  std::vector<std::uint32_t> indices;
  indices.reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (std::isfinite(cloud.x[i]) && std::isfinite(cloud.y[i]) && std::isfinite(cloud.z[i])) {
      indices.push_back(static_cast<std::uint32_t>(i));
    }
  }
  return indices;
}

}  // namespace

std::int64_t NeighborGrid::column_of(float y, float z) const {
  const auto iy = static_cast<std::int64_t>((y - min_y_) * inverse_width_);
  const auto iz = static_cast<std::int64_t>((z - min_z_) * inverse_width_);
  return iz * columns_y_ + iy;
}

void NeighborGrid::build(const PointCloud& cloud, double radius) {
  radius_ = radius;
  order_ = finite_points(cloud);
  float max_y = -std::numeric_limits<float>::infinity();
  float max_z = max_y;
  min_y_ = min_z_ = -max_y;
  for (const std::uint32_t i : order_) {
    min_y_ = std::min(min_y_, cloud.y[i]);
    max_y = std::max(max_y, cloud.y[i]);
    min_z_ = std::min(min_z_, cloud.z[i]);
    max_z = std::max(max_z, cloud.z[i]);
  }
  const double extent_y = order_.empty() ? 0.0 : static_cast<double>(max_y) - min_y_;
  const double extent_z = order_.empty() ? 0.0 : static_cast<double>(max_z) - min_z_;
  // A little wider than the radius, so that rounding to single precision loses no neighbour.
  double width = std::max(1.01 * radius, 1e-6);
  while ((extent_y / width + 1) * (extent_z / width + 1) > kMaxColumns) width *= 2;
  inverse_width_ = static_cast<float>(1 / width);
  columns_y_ = static_cast<std::int64_t>(extent_y / width) + 2;
  columns_z_ = static_cast<std::int64_t>(extent_z / width) + 2;

  std::vector<std::int64_t> column(cloud.size());
  for (const std::uint32_t i : order_) column[i] = column_of(cloud.y[i], cloud.z[i]);
  std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (column[a] != column[b]) return column[a] < column[b];
    return cloud.x[a] != cloud.x[b] ? cloud.x[a] < cloud.x[b] : a < b;
  });

  points_.resize(order_.size() + kPadding);
  column_begin_.assign(static_cast<std::size_t>(columns_y_ * columns_z_) + 1, 0);
  for (std::size_t k = 0; k < order_.size(); ++k) {
    const std::uint32_t i = order_[k];
    points_.x[k] = cloud.x[i];
    points_.y[k] = cloud.y[i];
    points_.z[k] = cloud.z[i];
    for (std::size_t f = 0; f < PointCloud::kFeatures; ++f) {
      points_.features[f][k] = cloud.features[f][i];
    }
    ++column_begin_[static_cast<std::size_t>(column[i]) + 1];
  }
  for (std::size_t c = 1; c < column_begin_.size(); ++c) column_begin_[c] += column_begin_[c - 1];
}

std::size_t NeighborGrid::query(float x, float y, float z,
                                std::array<GridRun, kMaxRuns>& runs) const {
  const float cy = std::floor((y - min_y_) * inverse_width_);
  const float cz = std::floor((z - min_z_) * inverse_width_);
  // Written so that NaN and values too large for an integer find nothing.
  const bool near = cy >= -1.0F && cy <= static_cast<float>(columns_y_) && cz >= -1.0F &&
                    cz <= static_cast<float>(columns_z_);
  if (!near || order_.empty()) return 0;
  const auto iy = static_cast<std::int64_t>(cy);
  const auto iz = static_cast<std::int64_t>(cz);
  const auto reach = static_cast<float>(radius_);
  std::size_t count = 0;
  for (std::int64_t jz = std::max<std::int64_t>(iz - 1, 0); jz <= std::min(iz + 1, columns_z_ - 1);
       ++jz) {
    for (std::int64_t jy = std::max<std::int64_t>(iy - 1, 0);
         jy <= std::min(iy + 1, columns_y_ - 1); ++jy) {
      const auto column = static_cast<std::size_t>(jz * columns_y_ + jy);
      const auto first = points_.x.begin() + column_begin_[column];
      const auto last = points_.x.begin() + column_begin_[column + 1];
      const auto begin = std::lower_bound(first, last, x - reach);
      const auto end = std::upper_bound(begin, last, x + reach);
      if (begin == end) continue;
      runs[count++] = {static_cast<std::uint32_t>(begin - points_.x.begin()),
                       static_cast<std::uint32_t>(end - points_.x.begin())};
    }
  }
  return count;
}

}  // namespace cvo_slam
