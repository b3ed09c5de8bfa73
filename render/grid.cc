// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <fmt/format.h>

#include "cvo_slam/render/grid_internal.h"

namespace cvo_slam::render {
namespace {

constexpr Color kLineColor{192, 198, 204};
constexpr double kCells = 7;  // about the number of cells along the longer side

/// Returns the smallest number >= `value` that is 1, 2 or 5 times a power of ten.
double round_up(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= value) return factor * power;
  }
  return 10 * power;
}

std::string metres(double value, double step) {
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  return fmt::format("{:.{}f} m", value + 0.0, decimals);  // + 0.0 avoids "-0"
}

}  // namespace

Grid::Grid(const Extent& extent, const MapView& view) : level_(extent.axes), view_(view) {
  const Vector3 ahead = level_.coordinates(view.T_world_view.rotation().col(2));
  if (view.orthographic) ahead.cwiseAbs().maxCoeff(&normal_);
  const double margin = 0.004 * extent.size();  // puts the grid below the floor, not into it
  offset_ = ahead[normal_] > 0 ? extent.max[normal_] + margin : extent.min[normal_] - margin;
  const Vector3 sizes = extent.max - extent.min;
  const int first = normal_ == 0 ? 1 : 0;
  const int second = normal_ == 2 ? 1 : 2;
  step_ = round_up(std::max(sizes[first], sizes[second]) / kCells);
  // The grid is a little larger than the scene, and still inside the picture.
  const double around = 0.05 * std::max(sizes[first], sizes[second]);
  min_ = {extent.min[first] - around, extent.min[second] - around};
  max_ = {extent.max[first] + around, extent.max[second] + around};
}

Vector3 Grid::place(double first, double second) const {
  switch (normal_) {
    case 0:
      return level_.place({offset_, first, second});
    case 1:
      return level_.place({first, offset_, second});
    default:
      return level_.place({first, second, offset_});
  }
}

std::vector<double> Grid::lines(int axis) const {
  std::vector<double> values;
  const double first = std::ceil(min_[axis] / step_);
  const auto count = static_cast<int>(std::floor(max_[axis] / step_) - first);
  for (int i = 0; i <= count; ++i) values.push_back((first + i) * step_);
  return values;
}

void Grid::add_to(LineArt& art, double width) const {
  for (const double x : lines(0)) {
    art.line(place(x, min_.y()), place(x, max_.y()), width, kLineColor);
  }
  for (const double y : lines(1)) {
    art.line(place(min_.x(), y), place(max_.x(), y), width, kLineColor);
  }
}

bool Grid::is_nearer(const Vector3& a, const Vector3& b) const {
  const Vector3 p = view_.project(a);
  const Vector3 q = view_.project(b);
  // Nearer is lower in the picture or, at the same height, farther to the left.
  const bool same = std::fabs(p.y() - q.y()) < 1;
  return same ? p.x() < q.x() : p.y() > q.y();
}

void Grid::add_labels(int along, std::vector<Label>& labels) const {
  const int across = 1 - along;
  const auto at = [&](double value, double edge) {
    return along == 0 ? place(value, edge) : place(edge, value);
  };
  const double middle = (min_[along] + max_[along]) / 2;
  const bool at_min = is_nearer(at(middle, min_[across]), at(middle, max_[across]));
  const double edge = at_min ? min_[across] : max_[across];
  for (const double value : lines(along)) {
    labels.push_back(
        {at(value, edge), at(value, at_min ? edge + step_ : edge - step_), metres(value, step_)});
  }
}

std::vector<Label> Grid::labels() const {
  std::vector<Label> labels;
  add_labels(0, labels);
  add_labels(1, labels);
  return labels;
}

}  // namespace cvo_slam::render
