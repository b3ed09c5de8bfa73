// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/io/synthetic/scene.h"
#include "cvo_slam/io/synthetic/shape_internal.h"

namespace cvo_slam::synthetic {

/// What a ray through a pixel meets first.
struct Visible {
  static constexpr std::int32_t kNothing = -1;
  double depth = 0;  ///< z in the camera frame [m]
  std::int32_t primitive = kNothing;
  std::int32_t face = 0;

  [[nodiscard]] bool same_surface(const Visible& other) const {
    return primitive == other.primitive && face == other.face;
  }
};

/// A scene as seen from one pose: the camera in each primitive's frame, and for each tile of the
/// image the primitives that may be visible there. Refers to the scene, which must outlive it.
class View {
 public:
  View(const Scene& scene, const PinholeCamera& camera, const SE3& T_world_camera);

  /// The nearest surface at a position on the image, which may be half a pixel off its rim.
  [[nodiscard]] Visible look(double x, double y) const;
  /// The colour of that surface averaged over a square of `side` pixels around the position.
  [[nodiscard]] Color shade(const Visible& visible, double x, double y, double side) const;

 private:
  struct Placed {
    Matrix3 R_shape_camera;
    Vector3 camera_in_shape;
  };
  /// The part of the image where a primitive may be visible (pixels, inclusive), and a lower bound
  /// of its depth there.
  struct Bounds {
    int left = 0, top = 0, right = -1, bottom = -1;
    double nearest = 0;  ///< [m]
  };
  struct Candidate {
    std::uint32_t primitive;
    double nearest;  ///< lower bound of the depth [m]
  };

  void add_to_tiles(std::size_t index);
  [[nodiscard]] Bounds image_bounds(std::size_t index) const;
  [[nodiscard]] std::size_t tile_of(double x, double y) const;
  [[nodiscard]] Vector3 direction(double x, double y) const;
  [[nodiscard]] Ray ray_in(std::size_t index, const Vector3& direction) const;
  [[nodiscard]] double brightness(const Vector3& point, const Vector3& normal) const;

  const Scene& scene_;
  PinholeCamera camera_;
  SE3 T_world_camera_;
  std::vector<Placed> placed_;
  int tile_columns_;
  std::vector<std::vector<Candidate>> tiles_;  // nearest first
};

}  // namespace cvo_slam::synthetic
