// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "cvo_slam/frontend/neighbor_grid_internal.h"

namespace cvo_slam {
namespace {

/// Largest number of columns. More cost more to clear than they save; wide clouds get wider
/// columns.
constexpr double kMaxColumns = 1 << 16;
/// Factor of the search radius, so that rounding to single precision loses no neighbour.
constexpr double kMargin = 1.01;
constexpr double kMaxBins = 1 << 16;

}  // namespace

void PointsByX::sort(const PointCloud& cloud) {
  keys_.clear();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (std::isfinite(cloud.x[i]) && std::isfinite(cloud.y[i]) && std::isfinite(cloud.z[i])) {
      keys_.emplace_back(cloud.x[i], static_cast<std::uint32_t>(i));
    }
  }
  std::sort(keys_.begin(), keys_.end());
  indices_.clear();
  for (const auto& [x, index] : keys_) indices_.push_back(index);
}

std::int64_t NeighborGrid::column_of(float y, float z) const {
  const auto iy = static_cast<std::int64_t>((y - min_y_) * inverse_width_);
  const auto iz = static_cast<std::int64_t>((z - min_z_) * inverse_width_);
  return iz * columns_y_ + iy;
}

void NeighborGrid::build(const PointCloud& cloud, double radius) {
  PointsByX by_x;
  by_x.sort(cloud);
  build(cloud, by_x, cloud.size(), radius);
}

void NeighborGrid::build(const PointCloud& cloud, const PointsByX& by_x, std::size_t count,
                         double radius) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  radius_ = radius;
  order_.clear();
  Eigen::Array3f low = Eigen::Array3f::Constant(kInfinity);
  Eigen::Array3f high = -low;
  for (const std::uint32_t i : by_x.indices()) {
    if (i >= count) continue;
    order_.push_back(i);
    const Eigen::Array3f p(cloud.x[i], cloud.y[i], cloud.z[i]);
    low = low.min(p);
    high = high.max(p);
  }
  if (order_.empty()) low = high = Eigen::Array3f::Zero();
  set_extent(low, high);

  // Counting keeps the order within a column: by x.
  column_.resize(cloud.size());
  columns_.assign(static_cast<std::size_t>(columns_y_ * columns_z_) + 2, {});
  for (const std::uint32_t i : order_) {
    column_[i] = static_cast<std::uint32_t>(column_of(cloud.y[i], cloud.z[i]));
    ++columns_[column_[i] + 2].points_begin;
  }
  for (std::size_t c = 1; c < columns_.size(); ++c) {
    columns_[c].points_begin += columns_[c - 1].points_begin;
  }
  points_.resize(order_.size() + kPadding);
  sorted_.resize(order_.size());
  for (const std::uint32_t i : order_) {
    const std::uint32_t k = columns_[column_[i] + 1].points_begin++;
    sorted_[k] = i;
    points_.x[k] = cloud.x[i];
    points_.y[k] = cloud.y[i];
    points_.z[k] = cloud.z[i];
    for (std::size_t f = 0; f < PointCloud::kFeatures; ++f) {
      points_.features[f][k] = cloud.features[f][i];
    }
  }
  order_.swap(sorted_);
  fill_bins();
}

void NeighborGrid::set_extent(const Eigen::Array3f& low, const Eigen::Array3f& high) {
  const Eigen::Array3d extent = high.cast<double>() - low.cast<double>();
  double width = std::max(kMargin * radius_, 1e-6);
  const auto columns = [&] { return (extent.y() / width + 1) * (extent.z() / width + 1); };
  while (columns() > kMaxColumns) width *= 2;
  width_ = static_cast<float>(width);
  inverse_width_ = 1 / width_;
  // So that a bin's number is an exact float even across the widest cloud.
  inverse_bin_ = static_cast<float>(std::min(2 / width, kMaxBins / std::max(extent.x(), 1e-6)));
  min_x_ = low.x();
  min_y_ = low.y();
  min_z_ = low.z();
  columns_y_ = static_cast<std::int64_t>(extent.y() / width) + 2;
  columns_z_ = static_cast<std::int64_t>(extent.z() / width) + 2;
}

void NeighborGrid::fill_bins() {
  bins_.clear();
  for (std::size_t c = 0; c + 1 < columns_.size(); ++c) {
    Column& column = columns_[c];
    const std::uint32_t end = columns_[c + 1].points_begin;
    if (column.points_begin == end) continue;
    column.bins_begin = static_cast<std::uint32_t>(bins_.size());
    column.first_bin = bin_of(points_.x[column.points_begin]);
    column.bins = bin_of(points_.x[end - 1]) - column.first_bin + 1;
    std::uint32_t k = column.points_begin;
    for (std::int32_t b = 0; b < column.bins; ++b) {
      while (bin_of(points_.x[k]) < column.first_bin + b) ++k;
      bins_.push_back(k);
    }
    bins_.push_back(end);
  }
}

std::int32_t NeighborGrid::bin_of(float x) const {
  return static_cast<std::int32_t>((x - min_x_) * inverse_bin_);
}

std::size_t NeighborGrid::query(float x, float y, float z,
                                std::array<GridRun, kMaxRuns>& runs) const {
  const float cy = std::floor((y - min_y_) * inverse_width_);
  const float cz = std::floor((z - min_z_) * inverse_width_);
  const float bin = (x - min_x_) * inverse_bin_;
  // Written so that NaN and values too large for an integer find nothing.
  const bool near = cy >= -1.0F && cy <= static_cast<float>(columns_y_) && cz >= -1.0F &&
                    cz <= static_cast<float>(columns_z_) && std::abs(bin) < 2 * kMaxBins;
  if (!near || order_.empty()) return 0;
  const auto iy = static_cast<std::int64_t>(cy);
  const auto iz = static_cast<std::int64_t>(cz);
  // Squared distance in y or z to the nearest side of a column.
  const auto gap2 = [&](float at, float min, std::int64_t own, std::int64_t column) {
    if (column == own) return 0.0F;
    const float gap = at - (min + static_cast<float>(std::max(own, column)) * width_);
    return gap * gap;
  };
  const auto radius2 = static_cast<float>(kMargin * kMargin * radius_ * radius_);
  std::size_t count = 0;
  for (std::int64_t jz = std::max<std::int64_t>(iz - 1, 0); jz <= std::min(iz + 1, columns_z_ - 1);
       ++jz) {
    const float left_of_z = radius2 - gap2(z, min_z_, iz, jz);
    for (std::int64_t jy = std::max<std::int64_t>(iy - 1, 0);
         jy <= std::min(iy + 1, columns_y_ - 1); ++jy) {
      const Column& column = columns_[static_cast<std::size_t>(jz * columns_y_ + jy)];
      const float left = left_of_z - gap2(y, min_y_, iy, jy);
      if (column.bins == 0 || left < 0) continue;
      const float reach = std::sqrt(left) * inverse_bin_;
      const std::int32_t first =
          std::max(static_cast<std::int32_t>(std::floor(bin - reach)) - column.first_bin, 0);
      const std::int32_t last = std::min(
          static_cast<std::int32_t>(std::floor(bin + reach)) - column.first_bin + 1, column.bins);
      if (first >= last) continue;
      const std::uint32_t* const bins = bins_.data() + column.bins_begin;
      if (bins[first] == bins[last]) continue;
      runs[count++] = {bins[first], bins[last]};
    }
  }
  return count;
}

}  // namespace cvo_slam
