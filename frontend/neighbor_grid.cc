// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cvo_slam/frontend/neighbor_grid_internal.h"

namespace cvo_slam {
namespace {

/// Returns the largest integer that is not above x, which must fit: std::floor() is a call for the
/// oldest processors that the program is built for.
std::int32_t floor_of(float x) {
  const auto towards_zero = static_cast<std::int32_t>(x);
  return towards_zero - (x < static_cast<float>(towards_zero) ? 1 : 0);
}

/// Largest number of columns. More cost more to clear than they save; wide clouds get wider
/// columns.
constexpr double kMaxColumns = 1 << 16;
/// Factor of the search radius, so that rounding to single precision loses no neighbour.
constexpr double kMargin = 1.01;
constexpr double kMaxBins = 1 << 16;

}  // namespace

void PointsByDepth::sort(const PointCloud& cloud) {
  keys_.clear();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (std::isfinite(cloud.x[i]) && std::isfinite(cloud.y[i]) && std::isfinite(cloud.z[i])) {
      keys_.emplace_back(cloud.z[i], static_cast<std::uint32_t>(i));
    }
  }
  std::sort(keys_.begin(), keys_.end());
  indices_.clear();
  for (const auto& [z, index] : keys_) indices_.push_back(index);
}

std::int64_t NeighborGrid::column_of(float x, float y) const {
  const auto ix = static_cast<std::int64_t>((x - min_x_) * inverse_width_);
  const auto iy = static_cast<std::int64_t>((y - min_y_) * inverse_width_);
  return iy * columns_x_ + ix;
}

void NeighborGrid::build(const PointCloud& cloud, double radius) {
  PointsByDepth by_depth;
  by_depth.sort(cloud);
  build(cloud, by_depth, cloud.size(), radius);
}

void NeighborGrid::build(const PointCloud& cloud, const PointsByDepth& by_depth, std::size_t count,
                         double radius) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  radius_ = radius;
  order_.clear();
  Eigen::Array3f low = Eigen::Array3f::Constant(kInfinity);
  Eigen::Array3f high = -low;
  for (const std::uint32_t i : by_depth.indices()) {
    if (i >= count) continue;
    order_.push_back(i);
    const Eigen::Array3f p(cloud.x[i], cloud.y[i], cloud.z[i]);
    low = low.min(p);
    high = high.max(p);
  }
  if (order_.empty()) low = high = Eigen::Array3f::Zero();
  set_extent(low, high);

  // Counting keeps the order within a column: by z.
  column_.resize(cloud.size());
  columns_.assign(static_cast<std::size_t>(columns_x_ * columns_y_) + 2, {});
  for (const std::uint32_t i : order_) {
    column_[i] = static_cast<std::uint32_t>(column_of(cloud.x[i], cloud.y[i]));
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
  const auto columns = [&] { return (extent.x() / width + 1) * (extent.y() / width + 1); };
  while (columns() > kMaxColumns) width *= 2;
  width_ = static_cast<float>(width);
  inverse_width_ = 1 / width_;
  // So that a bin's number is an exact float even across the widest cloud.
  inverse_bin_ = static_cast<float>(std::min(2 / width, kMaxBins / std::max(extent.z(), 1e-6)));
  min_x_ = low.x();
  min_y_ = low.y();
  min_z_ = low.z();
  columns_x_ = static_cast<std::int64_t>(extent.x() / width) + 2;
  columns_y_ = static_cast<std::int64_t>(extent.y() / width) + 2;
}

void NeighborGrid::fill_bins() {
  bins_.clear();
  for (std::size_t c = 0; c + 1 < columns_.size(); ++c) {
    Column& column = columns_[c];
    const std::uint32_t end = columns_[c + 1].points_begin;
    if (column.points_begin == end) continue;
    column.bins_begin = static_cast<std::uint32_t>(bins_.size());
    column.first_bin = bin_of(points_.z[column.points_begin]);
    column.bins = bin_of(points_.z[end - 1]) - column.first_bin + 1;
    std::uint32_t k = column.points_begin;
    for (std::int32_t b = 0; b < column.bins; ++b) {
      while (bin_of(points_.z[k]) < column.first_bin + b) ++k;
      bins_.push_back(k);
    }
    bins_.push_back(end);
  }
}

std::int32_t NeighborGrid::bin_of(float z) const {
  return static_cast<std::int32_t>((z - min_z_) * inverse_bin_);
}

/// Returns true if points near this position may be in the grid. Written so that NaN and values too
/// large for an integer are near nothing.
bool NeighborGrid::is_near(const Eigen::Array3f& center) const {
  const float cx = std::floor((center.x() - min_x_) * inverse_width_);
  const float cy = std::floor((center.y() - min_y_) * inverse_width_);
  const float bin = (center.z() - min_z_) * inverse_bin_;
  constexpr float kBorder = kMaxSide;
  return !order_.empty() && cx >= -kBorder && cx < static_cast<float>(columns_x_) + kBorder &&
         cy >= -kBorder && cy < static_cast<float>(columns_y_) + kBorder &&
         std::abs(bin) < 2 * kMaxBins;
}

/// Adds the points of a column with z from `low` to `high`, and some others.
void NeighborGrid::add_run(const Column& column, float low, float high,
                           std::array<GridRun, kMaxRuns>& runs, std::size_t& count) const {
  const auto bin = [this](float z) { return floor_of((z - min_z_) * inverse_bin_); };
  const std::int32_t first = std::max(bin(low) - column.first_bin, 0);
  const std::int32_t last = std::min(bin(high) - column.first_bin + 1, column.bins);
  if (first >= last) return;
  const std::uint32_t* const bins = bins_.data() + column.bins_begin;
  if (bins[first] != bins[last]) runs[count++] = {bins[first], bins[last]};
}

std::size_t NeighborGrid::query(float x, float y, float z,
                                std::array<GridRun, kMaxRuns>& runs) const {
  if (!is_near({x, y, z})) return 0;
  const auto ix = std::int64_t{floor_of((x - min_x_) * inverse_width_)};
  const auto iy = std::int64_t{floor_of((y - min_y_) * inverse_width_)};
  // Squared distance in x or y to the nearest side of a column.
  const auto gap2 = [&](float at, float min, std::int64_t own, std::int64_t column) {
    if (column == own) return 0.0F;
    const float gap = at - (min + static_cast<float>(std::max(own, column)) * width_);
    return gap * gap;
  };
  const auto radius2 = static_cast<float>(kMargin * kMargin * radius_ * radius_);
  std::size_t count = 0;
  for (std::int64_t jy = std::max<std::int64_t>(iy - 1, 0); jy <= std::min(iy + 1, columns_y_ - 1);
       ++jy) {
    const float left_of_y = radius2 - gap2(y, min_y_, iy, jy);
    for (std::int64_t jx = std::max<std::int64_t>(ix - 1, 0);
         jx <= std::min(ix + 1, columns_x_ - 1); ++jx) {
      const Column& column = columns_[static_cast<std::size_t>(jy * columns_x_ + jx)];
      const float left = left_of_y - gap2(x, min_x_, ix, jx);
      if (column.bins == 0 || left < 0) continue;
      const float reach = std::sqrt(left);
      add_run(column, z - reach, z + reach, runs, count);
    }
  }
  return count;
}

std::size_t NeighborGrid::query(const Eigen::Array3f& center, const Eigen::Array3f& along,
                                float stretch, std::array<GridRun, kMaxRuns>& runs) const {
  if (!is_near(center)) return 0;
  const auto radius = static_cast<float>(kMargin * radius_);
  const Eigen::Array3f extent = radius * (1 + (stretch * stretch - 1) * along.square()).sqrt();
  const auto columns = [&](float at, float half, float min, std::int64_t last) {
    const auto index = [&](float value) {
      return std::int64_t{floor_of((value - min) * inverse_width_)};
    };
    const std::int64_t own = index(at);
    return std::pair(std::max({index(at - half), own - kMaxSide / 2, std::int64_t{0}}),
                     std::min({index(at + half), own + kMaxSide / 2, last}));
  };
  const auto [x_begin, x_end] = columns(center.x(), extent.x(), min_x_, columns_x_ - 1);
  const auto [y_begin, y_end] = columns(center.y(), extent.y(), min_y_, columns_y_ - 1);
  // The ellipsoid lies within `radius` of the line of length 2 stretch radius. Returns the part of
  // the line that is as near to a column's interval in x or y.
  const auto clip = [&](float low, float direction, float& begin, float& end) {
    constexpr float kAcross = 1e-3F;
    if (std::abs(direction) < kAcross) return;
    const float a = (low - radius) / direction;
    const float b = (low + width_ + radius) / direction;
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  };
  const float half_length = stretch * radius;
  const float around = radius * std::sqrt(std::max(0.0F, 1 - along.z() * along.z()));
  std::size_t count = 0;
  for (std::int64_t jy = y_begin; jy <= y_end; ++jy) {
    for (std::int64_t jx = x_begin; jx <= x_end; ++jx) {
      const Column& column = columns_[static_cast<std::size_t>(jy * columns_x_ + jx)];
      if (column.bins == 0) continue;
      float begin = -half_length;
      float end = half_length;
      clip(min_x_ + static_cast<float>(jx) * width_ - center.x(), along.x(), begin, end);
      clip(min_y_ + static_cast<float>(jy) * width_ - center.y(), along.y(), begin, end);
      if (begin > end) continue;
      const float a = begin * along.z();
      const float b = end * along.z();
      add_run(column, center.z() + std::min(a, b) - around, center.z() + std::max(a, b) + around,
              runs, count);
    }
  }
  return count;
}

}  // namespace cvo_slam
