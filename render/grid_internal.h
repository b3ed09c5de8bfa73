// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "cvo_slam/render/extent_internal.h"
#include "cvo_slam/render/line_art_internal.h"

namespace cvo_slam::render {

/// A text at a place of the world, pushed away on the image from another place.
struct Label {
  Vector3 place;
  Vector3 away_from;
  std::string text;
};

/// The grid of metres: the ground below the scene, or in a view from the side a wall behind it.
class Grid {
 public:
  Grid(const Extent& extent, const View& view);

  void add_to(LineArt& art, double width) const;
  /// Of the lines, in metres along the level axes, on the edges of the grid next to the reader.
  [[nodiscard]] std::vector<Label> labels() const;
  /// Distance of the lines [m].
  [[nodiscard]] double step() const { return step_; }

 private:
  [[nodiscard]] Vector3 place(double first, double second) const;
  [[nodiscard]] std::vector<double> lines(int axis) const;
  [[nodiscard]] bool is_nearer(const Vector3& a, const Vector3& b) const;
  void add_labels(int along, std::vector<Label>& labels) const;

  LevelAxes level_;
  const View& view_;
  int normal_ = 2;  ///< axis of the level world that the plane is square to
  double offset_ = 0;
  double step_ = 1;
  Eigen::Vector2d min_;  ///< along the other two axes, in their order
  Eigen::Vector2d max_;
};

}  // namespace cvo_slam::render
