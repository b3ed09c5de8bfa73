// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/synthetic/shape_internal.h"
#include "cvo_slam/synthetic/world_scene.h"

namespace cvo_slam::synthetic {

/// The first surface that a ray through a pixel meets.
struct Visible {
  static constexpr std::int32_t kNothing = -1;
  double depth = 0;  ///< z in the camera frame [m]
  std::int32_t primitive = kNothing;
  std::int32_t face = 0;

  [[nodiscard]] bool same_surface(const Visible& other) const {
    return primitive == other.primitive && face == other.face;
  }
};

/// A range of image rows, both ends included.
struct RowRange {
  int first = 0;
  int last = 0;
};

/// Casts rays into a scene from one camera pose. It holds the camera in the frame of each primitive
/// and, for each tile of the image, the primitives that may be visible there. The scene must
/// outlive it.
class RayCaster {
 public:
  /// Casts rays of the whole image.
  RayCaster(const WorldScene& scene, const PinholeCamera& camera, const SE3& T_world_camera);
  /// Casts rays of some rows of the image only.
  RayCaster(const WorldScene& scene, const PinholeCamera& camera, const SE3& T_world_camera,
            const RowRange& rows);

  /// Returns the nearest surface at a position on the rows, or up to half a pixel beyond them.
  [[nodiscard]] Visible look(double x, double y) const;
  /// Returns the colour of that surface, averaged over a square of `side` pixels about the
  /// position.
  [[nodiscard]] LinearColor shade(const Visible& visible, double x, double y, double side) const;
  /// Returns the reflectance of that surface, averaged over the same square.
  [[nodiscard]] LinearColor reflectance(const Visible& visible, double x, double y,
                                        double side) const;
  /// Returns the cosine of the angle between ray and surface normal, in [0, 1]; 0 without surface.
  [[nodiscard]] double cosine_of_incidence(const Visible& visible, double x, double y) const;

 private:
  struct Placed {
    Matrix3 R_shape_camera;
    Vector3 camera_in_shape;
  };
  /// The part of the image in which a primitive may be visible (pixels, ends included), and a lower
  /// bound of its depth there.
  struct Bounds {
    std::uint32_t primitive = 0;
    int left = 0, top = 0, right = -1, bottom = -1;
    double nearest = 0;  ///< [m]
  };
  struct Candidate {
    std::uint32_t primitive;
    double nearest;  ///< lower bound of the depth [m]
  };
  /// A visible point in the frame of its shape.
  struct Point {
    Ray ray;
    Vector3 position;
    Surface surface;
  };

  [[nodiscard]] bool may_be_visible(const Vector3& center, double radius) const;
  void add_to_tiles(const Bounds& bounds);
  [[nodiscard]] Bounds image_bounds(std::size_t index) const;
  [[nodiscard]] std::size_t tile_of(double x, double y) const;
  [[nodiscard]] std::size_t tile_index(int row, int column) const;
  [[nodiscard]] Vector3 direction(double x, double y) const;
  [[nodiscard]] Ray ray_in(std::size_t index, const Vector3& direction) const;
  [[nodiscard]] Point point_at(const Visible& visible, double x, double y) const;
  [[nodiscard]] LinearColor reflectance(const Visible& visible, const Point& point,
                                        double side) const;
  [[nodiscard]] double brightness(const Vector3& point, const Vector3& normal) const;

  const WorldScene& scene_;
  PinholeCamera camera_;
  SE3 T_world_camera_;
  RowRange rows_;
  std::vector<Placed> placed_;
  int tile_columns_;
  std::vector<std::vector<Candidate>> tiles_;  // nearest first
};

}  // namespace cvo_slam::synthetic
