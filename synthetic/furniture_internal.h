// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Furniture and small things of an office and a household.
#pragma once

#include "cvo_slam/synthetic/scene_builder_internal.h"

namespace cvo_slam::synthetic {

/// Thickness of furniture boards [m].
inline constexpr double kBoard = 0.025;
/// Gap that keeps thin things off the surface that they lie on [m].
inline constexpr double kGap = 0.002;

/// Puts furniture against a wall. Positions (x, y, z) are relative to the wall [m]: x runs along it
/// to the right of a viewer who faces it, y comes out of it, z points up.
class Wall {
 public:
  /// `foot` is the position of x = y = z = 0 in the world, `forward` the viewing direction of a
  /// viewer who faces the wall.
  Wall(SceneBuilder& builder, const Vector3& foot, const Vector3& forward);

  /// Adds a box. `at` is the centre of the lower edge of its back face, size = width, depth,
  /// height, `turn` its rotation about its own vertical axis [rad].
  void box(const Vector3& at, const Vector3& size, const Texture& texture, double turn = 0) const;
  /// Adds a column. `at` is the centre of its foot.
  void cylinder(const Vector3& at, double diameter, double height, const Texture& texture) const;
  void sphere(const Vector3& center, double diameter, const Texture& texture) const;
  /// Adds a sheet on or in front of the wall.
  void sheet(const Vector3& center, double width, double height, const Texture& texture) const;
  /// Adds a sheet of paper that lies flat.
  void page(const Vector3& at, double width, double height) const;

  /// Adds books side by side on a board of that width, their backs towards the room.
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

  /// Adds a screen on a foot. `at` is the foot of its back.
  void screen(const Vector3& at) const;

 private:
  [[nodiscard]] Vector3 in_world(const Vector3& at) const;

  SceneBuilder& builder_;
  Vector3 foot_;
  Vector3 right_;
  Vector3 out_;
  double yaw_;
};

/// Adds a table on four legs in the middle of the room, with papers and a box on it.
void table(SceneBuilder& builder, const Vector3& foot, const Vector3& size);

// Small things (clutter.cc); positions as in Wall.

void mug(const Wall& wall, const Vector3& at);
/// Adds a pile of papers or books, each turned a little.
void paper_pile(const Wall& wall, const Vector3& at, int sheets);
void desk_lamp(const Wall& wall, const Vector3& at);
/// Adds a bush in a pot; `height` is that of the whole.
void plant(const Wall& wall, const Vector3& at, double height);
void waste_bin(const Wall& wall, const Vector3& at);
/// Adds a chair with the centre of its seat above (x, y) and its back away from the wall.
void chair(const Wall& wall, double x, double y, double turn);
void office_chair(const Wall& wall, double x, double y, double turn);

/// Adds a row of ring binders.
void binders(const Wall& wall, const Vector3& at, double width);
/// Adds a shelf of binders, books and boxes.
void filing_shelf(const Wall& wall, double x, double width, int boards);
/// Adds a desk with a screen and the usual clutter.
void workplace(const Wall& wall, double x, double width);
void whiteboard(const Wall& wall, double x, double width, double height);

}  // namespace cvo_slam::synthetic
