// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/synthetic/scene_builder_internal.h"

namespace cvo_slam::synthetic {

/// Puts furniture against a wall: x runs along the wall to the right of someone who looks at it, y
/// comes out of the wall, z goes up [m].
class Wall {
 public:
  /// `foot` is where x = y = z = 0 is in the world; `forward` is the view of who faces the wall.
  Wall(SceneBuilder& builder, const Vector3& foot, const Vector3& forward);

  /// A box with the centre of its back face's lower edge at (x, y, z); size = width, depth, height.
  /// `turn` about its own vertical axis [rad].
  void box(const Vector3& at, const Vector3& size, const Texture& texture, double turn = 0) const;
  /// A column with the centre of its foot at (x, y, z).
  void cylinder(const Vector3& at, double diameter, double height, const Texture& texture) const;
  void sphere(const Vector3& center, double diameter, const Texture& texture) const;
  /// A sheet on or in front of the wall, centred at (x, y, z).
  void sheet(const Vector3& center, double width, double height, const Texture& texture) const;
  /// A sheet of paper that lies at (x, y, z).
  void page(const Vector3& at, double width, double height) const;

  /// Books side by side on a board of that width, their backs towards the room.
  void books(const Vector3& at, double width, double depth, double max_height) const;
  void bookshelf(double x, double width, double height, int boards) const;
  void wardrobe(double x, double width, double height) const;
  void desk(double x, double width) const;
  void bed(double x, double width) const;
  void sofa(double x, double width) const;
  void cabinet(double x, double width, double height) const;
  [[nodiscard]] Random& random() const { return builder_.random(); }

  void window(double x, double width, double bottom, double height) const;
  void door(double x) const;

  /// A screen on a foot, its back's foot at (x, y, z).
  void screen(const Vector3& at) const;

 private:
  [[nodiscard]] Vector3 in_world(const Vector3& at) const;

  SceneBuilder& builder_;
  Vector3 foot_;
  Vector3 right_;
  Vector3 out_;
  double yaw_;
};

/// A table on four legs in the middle of the room, with papers and a box on it.
void table(SceneBuilder& builder, const Vector3& foot, const Vector3& size);

}  // namespace cvo_slam::synthetic
