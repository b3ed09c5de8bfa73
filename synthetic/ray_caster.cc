// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "cvo_slam/synthetic/ray_caster_internal.h"

namespace cvo_slam::synthetic {
namespace {

constexpr int kTile = 8;  // [px]; small enough that most tiles hold few primitives

int tiles_along(int pixels) { return (pixels + kTile - 1) / kTile; }

Vector3 half_extent_of(const Primitive& primitive) {
  return std::visit([](const auto& shape) { return half_extent(shape); }, primitive.shape);
}

double length(double x, double y) { return std::sqrt(x * x + y * y); }

}  // namespace

RayCaster::RayCaster(const WorldScene& scene, const PinholeCamera& camera,
                     const SE3& T_world_camera)
    : RayCaster(scene, camera, T_world_camera, {0, camera.height - 1}) {}

RayCaster::RayCaster(const WorldScene& scene, const PinholeCamera& camera,
                     const SE3& T_world_camera, const RowRange& rows)
    : scene_(scene),
      camera_(camera),
      T_world_camera_(T_world_camera),
      rows_(rows),
      placed_(scene.primitives.size()),
      tile_columns_(tiles_along(camera.width)),
      tiles_(static_cast<std::size_t>(tile_columns_) *
             static_cast<std::size_t>(tiles_along(rows.last - rows.first + 1))) {
  const SE3 T_camera_world = T_world_camera.inverse();
  std::vector<Bounds> visible;
  for (std::size_t i = 0; i < placed_.size(); ++i) {
    const Primitive& primitive = scene.primitives[i];
    if (!may_be_visible(T_camera_world * primitive.T_world_shape.translation(),
                        half_extent_of(primitive).norm())) {
      continue;
    }
    const SE3 T_shape_camera = primitive.T_world_shape.inverse() * T_world_camera;
    placed_[i] = {T_shape_camera.rotation(), T_shape_camera.translation()};
    visible.push_back(image_bounds(i));
  }
  std::stable_sort(visible.begin(), visible.end(),
                   [](const Bounds& a, const Bounds& b) { return a.nearest < b.nearest; });
  for (const auto& bounds : visible) add_to_tiles(bounds);
}

/// Returns false only if a sphere is certainly outside the view frustum.
bool RayCaster::may_be_visible(const Vector3& center, double radius) const {
  // Distance from the plane through the camera and a border of the image, positive inside. The
  // border is one pixel wider than the half pixel by which positions may be beyond the image.
  const auto inside = [radius](double focal, double offset, double across, double z) {
    return focal * across + offset * z > -radius * length(focal, offset);
  };
  return center.z() > -radius && inside(camera_.fx, camera_.cx + 1.5, center.x(), center.z()) &&
         inside(camera_.fx, camera_.width + 0.5 - camera_.cx, -center.x(), center.z()) &&
         inside(camera_.fy, camera_.cy + 1.5 - rows_.first, center.y(), center.z()) &&
         inside(camera_.fy, rows_.last + 1.5 - camera_.cy, -center.y(), center.z());
}

void RayCaster::add_to_tiles(const Bounds& bounds) {
  if (bounds.right < bounds.left) return;
  const int first_row = (bounds.top - rows_.first) / kTile;
  const int last_row = (bounds.bottom - rows_.first) / kTile;
  for (int row = first_row; row <= last_row; ++row) {
    for (int column = bounds.left / kTile; column <= bounds.right / kTile; ++column) {
      auto& tile = tiles_[tile_index(row, column)];
      constexpr std::size_t kUsual = 8;  // primitives in a tile; avoids most reallocations
      if (tile.empty()) tile.reserve(kUsual);
      tile.push_back({bounds.primitive, bounds.nearest});
    }
  }
}

RayCaster::Bounds RayCaster::image_bounds(std::size_t index) const {
  constexpr double kNear = 1e-3;  // [m]
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Vector3 half = half_extent_of(scene_.primitives[index]);
  const Placed& placed = placed_[index];
  const auto corner_at = [&](int corner) -> Vector3 {
    const Vector3 sign((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                       (corner & 4) != 0 ? 1 : -1);
    return placed.R_shape_camera.transpose() * (half.cwiseProduct(sign) - placed.camera_in_shape);
  };
  Eigen::Array2d low = Eigen::Array2d::Constant(kInfinity);
  Eigen::Array2d high = -low;
  const auto include = [&](const Vector3& point) {
    const Eigen::Array2d pixel = camera_.project(point).array();
    low = low.min(pixel);
    high = high.max(pixel);
  };
  double nearest = kInfinity;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3 point = corner_at(corner);
    nearest = std::min(nearest, point.z());
    if (point.z() < kNear) continue;
    include(point);
    // Edges that reach behind the camera are cut off at the near plane.
    for (const int direction : {1, 2, 4}) {
      const Vector3 other = corner_at(corner ^ direction);
      if (other.z() >= kNear) continue;
      include(point + (other - point) * ((point.z() - kNear) / (point.z() - other.z())));
    }
  }
  const Eigen::Array2d first(0, rows_.first);
  const Eigen::Array2d last(camera_.width - 1, rows_.last);
  // Positions on the image reach half a pixel beyond the centre of a pixel.
  if ((high < first - 0.5).any() || (low > last + 0.5).any()) return {};
  low = (low - 1).floor().max(first).min(last);
  high = (high + 1).ceil().max(first).min(last);
  // 1e-6 is far more than rounding errors. A bound that is too low only costs time.
  return {static_cast<std::uint32_t>(index), static_cast<int>(low.x()),  static_cast<int>(low.y()),
          static_cast<int>(high.x()),        static_cast<int>(high.y()), nearest - 1e-6};
}

std::size_t RayCaster::tile_of(double x, double y) const {
  const auto tile_along = [](double position, int first, int last) {
    const double shifted = position + 0.5;  // >= 0, so that truncation rounds the position
    return (std::clamp(static_cast<int>(shifted), first, last) - first) / kTile;
  };
  return tile_index(tile_along(y, rows_.first, rows_.last), tile_along(x, 0, camera_.width - 1));
}

std::size_t RayCaster::tile_index(int row, int column) const {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(tile_columns_) +
         static_cast<std::size_t>(column);
}

Vector3 RayCaster::direction(double x, double y) const {
  return {(x - camera_.cx) / camera_.fx, (y - camera_.cy) / camera_.fy, 1.0};
}

Ray RayCaster::ray_in(std::size_t index, const Vector3& direction) const {
  const Placed& placed = placed_[index];
  return {placed.camera_in_shape, placed.R_shape_camera * direction};
}

Visible RayCaster::look(double x, double y) const {
  // z of the direction is 1, so that the distance along the ray is the depth.
  const Vector3 direction = RayCaster::direction(x, y);
  Visible nearest;
  for (const auto& [index, bound] : tiles_[tile_of(x, y)]) {
    if (nearest.primitive != Visible::kNothing && bound > nearest.depth) break;
    const Ray ray = ray_in(index, direction);
    const auto hit = std::visit([&ray](const auto& shape) { return intersect(shape, ray); },
                                scene_.primitives[index].shape);
    if (hit && (nearest.primitive == Visible::kNothing || hit->distance < nearest.depth)) {
      nearest = {hit->distance, static_cast<std::int32_t>(index), hit->face};
    }
  }
  return nearest;
}

RayCaster::Point RayCaster::point_at(const Visible& visible, double x, double y) const {
  const auto index = static_cast<std::size_t>(visible.primitive);
  const Ray ray = ray_in(index, direction(x, y));
  const Vector3 position = ray.origin + visible.depth * ray.direction;
  return {ray, position,
          std::visit([&](const auto& shape) { return surface_at(shape, visible.face, position); },
                     scene_.primitives[index].shape)};
}

LinearColor RayCaster::shade(const Visible& visible, double x, double y, double side) const {
  if (visible.primitive == Visible::kNothing) return LinearColor::Zero();
  const Point point = point_at(visible, x, y);
  const Vector3& normal = point.surface.normal;
  const Vector3 towards_viewer = normal.dot(point.ray.direction) < 0 ? normal : Vector3(-normal);
  const SE3& T_world_shape =
      scene_.primitives[static_cast<std::size_t>(visible.primitive)].T_world_shape;
  return reflectance(visible, point, side) *
         brightness(T_world_shape * point.position, T_world_shape.rotation() * towards_viewer);
}

LinearColor RayCaster::reflectance(const Visible& visible, double x, double y, double side) const {
  if (visible.primitive == Visible::kNothing) return LinearColor::Zero();
  return reflectance(visible, point_at(visible, x, y), side);
}

double RayCaster::cosine_of_incidence(const Visible& visible, double x, double y) const {
  if (visible.primitive == Visible::kNothing) return 0;
  const Point point = point_at(visible, x, y);
  return std::min(
      1.0, std::abs(point.surface.normal.dot(point.ray.direction)) / point.ray.direction.norm());
}

LinearColor RayCaster::reflectance(const Visible& visible, const Point& point, double side) const {
  const auto index = static_cast<std::size_t>(visible.primitive);
  const auto& [ray, position, surface] = point;
  // The motion of the point on the tangent plane for a step of one pixel: ray differentials, H.
  // Igehy, "Tracing ray differentials", SIGGRAPH 1999.
  const double slope = surface.normal.dot(ray.direction);
  const auto moved = [&, &direction = ray.direction,
                      &normal = surface.normal](const Vector3& step) -> Vector3 {
    return visible.depth * (step - direction * (normal.dot(step) / slope));
  };
  const Matrix3& R = placed_[index].R_shape_camera;
  const Vector3 across = moved(R.col(0) * (side / camera_.fx));
  const Vector3 along = moved(R.col(1) * (side / camera_.fy));
  return sample(scene_.primitives[index].texture,
                {surface.u, surface.v, surface.size_u, surface.size_v,
                 length(surface.right.dot(across), surface.right.dot(along)),
                 length(surface.down.dot(across), surface.down.dot(along))});
}

double RayCaster::brightness(const Vector3& point, const Vector3& normal) const {
  double sum = scene_.ambient;
  for (const auto& light : scene_.lights) {
    const Vector3 to_light = light.position - point;
    const double towards = normal.dot(to_light);
    if (!(towards > 0)) continue;
    const double squared = to_light.squaredNorm();
    // Lambert's law. The inverse square is softened, so that a wall beside a lamp is not
    // overexposed.
    sum += light.power * towards / (std::sqrt(squared) * (1 + squared));
  }
  return sum;
}

}  // namespace cvo_slam::synthetic
