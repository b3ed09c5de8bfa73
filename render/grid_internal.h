// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "cvo_slam/render/extent_internal.h"
#include "cvo_slam/render/line_art_internal.h"

namespace cvo_slam::render {

/// A text at a position of the world. On the image it is moved away from another position.
struct Label {
  Vector3 place;
  Vector3 away_from;
  std::string text;
};

/// The metric grid: the ground below the scene or, in a view from the side, a wall behind it.
class Grid {
 public:
  /// The view must outlive the object.
  Grid(const Extent& extent, const MapView& view);

  void add_to(LineArt& art, double width) const;
  /// Returns the numbers of the lines, in metres along the level axes. They stand at the edges of
  /// the grid that are nearest to the reader.
  [[nodiscard]] std::vector<Label> labels() const;
  /// Returns the distance between lines [m].
  [[nodiscard]] double step() const { return step_; }

 private:
  [[nodiscard]] Vector3 place(double first, double second) const;
  [[nodiscard]] std::vector<double> lines(int axis) const;
  [[nodiscard]] bool is_nearer(const Vector3& a, const Vector3& b) const;
  void add_labels(int along, std::vector<Label>& labels) const;

  LevelAxes level_;
  const MapView& view_;
  int normal_ = 2;  ///< axis of the level world that is perpendicular to the grid
  double offset_ = 0;
  double step_ = 1;
  Eigen::Vector2d min_;  ///< along the other two axes, in their order
  Eigen::Vector2d max_;
};

}  // namespace cvo_slam::render
