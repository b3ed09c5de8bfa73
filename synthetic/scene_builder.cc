// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "cvo_slam/synthetic/materials_internal.h"
#include "cvo_slam/synthetic/scene_builder_internal.h"

namespace cvo_slam::synthetic {
namespace {

/// Adds boxes to a wall. Positions are measured along it from its start, and from the floor.
class Layer {
 public:
  Layer(SceneBuilder& builder, const Partition& wall)
      : builder_(builder),
        from_(wall.from),
        along_((wall.to - wall.from).normalized()),
        left_(Vector3::UnitZ().cross(along_)) {}

  /// `beside` is the offset of the middle of the box to the left [m].
  void box(double begin, double end, double bottom, double top, double beside, double thickness,
           const Texture& texture) const {
    const Vector3 foot = from_ + 0.5 * (begin + end) * along_ + beside * left_;
    builder_.box(foot + Vector3(0, 0, bottom), {end - begin, thickness, top - bottom}, texture,
                 std::atan2(along_.y(), along_.x()));
  }

 private:
  SceneBuilder& builder_;
  Vector3 from_;
  Vector3 along_;
  Vector3 left_;
};

void frame(const Layer& layer, double begin, double end) {
  constexpr double kWidth = 0.07;
  constexpr double kDepth = Partition::kThickness + 0.05;
  constexpr double kTop = Partition::kOpeningHeight;
  const Texture paint = materials::white_paint();
  layer.box(begin - kWidth, begin, 0, kTop + kWidth, 0, kDepth, paint);
  layer.box(end, end + kWidth, 0, kTop + kWidth, 0, kDepth, paint);
  layer.box(begin, end, kTop, kTop + kWidth, 0, kDepth, paint);
}

}  // namespace

Matrix3 facing(const Vector3& forward) {
  const Vector3 z = forward.normalized();
  const bool vertical = std::abs(z.z()) > 0.999;
  const Vector3 up = vertical ? Vector3::UnitY() : Vector3::UnitZ();
  const Vector3 x = z.cross(up).normalized();
  Matrix3 R;
  R << x, z.cross(x), z;
  return R;
}

void SceneBuilder::add(const Shape& shape, const SE3& T_world_shape, Texture texture) {
  const std::uint32_t drawn = random_.bits();
  if (texture.seed == 0) texture.seed = drawn;
  scene_.primitives.push_back({shape, T_world_shape, texture});
}

void SceneBuilder::box(const Vector3& bottom, const Vector3& size, const Texture& texture,
                       double yaw) {
  const Vector3 center = bottom + Vector3(0, 0, 0.5 * size.z());
  add(Box{size}, SE3(so3_exp({0, 0, yaw}), center), texture);
}

void SceneBuilder::cylinder(const Vector3& bottom, double diameter, double height,
                            const Texture& texture) {
  const Vector3 center = bottom + Vector3(0, 0, 0.5 * height);
  add(Cylinder{diameter, height}, SE3(Matrix3::Identity(), center), texture);
}

void SceneBuilder::sphere(const Vector3& center, double diameter, const Texture& texture) {
  add(Sphere{diameter}, SE3(Matrix3::Identity(), center), texture);
}

void SceneBuilder::sheet(const Vector3& center, const Vector3& forward, double width, double height,
                         const Texture& texture) {
  add(Rectangle{width, height}, SE3(facing(forward), center), texture);
}

void partition(SceneBuilder& builder, const Partition& wall) {
  const Layer layer(builder, wall);
  const double length = (wall.to - wall.from).norm();
  std::vector<double> openings = wall.openings;
  std::sort(openings.begin(), openings.end());
  constexpr double kHalf = 0.5 * Partition::kThickness;
  for (const double side : {1.0, -1.0}) {
    const Texture& texture = side > 0 ? wall.left : wall.right;
    double low = 0;
    for (const double middle : openings) {
      const double high = middle - 0.5 * wall.opening_width;
      layer.box(low, high, 0, wall.height, 0.5 * side * kHalf, kHalf, texture);
      low = middle + 0.5 * wall.opening_width;
      layer.box(high, low, Partition::kOpeningHeight, wall.height, 0.5 * side * kHalf, kHalf,
                texture);
    }
    layer.box(low, length, 0, wall.height, 0.5 * side * kHalf, kHalf, texture);
  }
  for (const double middle : openings) {
    frame(layer, middle - 0.5 * wall.opening_width, middle + 0.5 * wall.opening_width);
  }
}

}  // namespace cvo_slam::synthetic
