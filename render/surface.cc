// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "cvo_slam/render/extent_internal.h"
#include "cvo_slam/render/surface_internal.h"

namespace cvo_slam::render {
namespace {

/// Returns the number of cells of a cubic grid that contain points.
std::size_t count_cells(const std::vector<Vector3>& places, double cell) {
  std::vector<std::uint64_t> keys;
  keys.reserve(places.size());
  for (const Vector3& place : places) {
    std::uint64_t key = 0;
    for (const double coordinate : (place - places.front()) / cell) {
      constexpr double kMiddle = 1 << 20;
      key = (key << 21U) | static_cast<std::uint64_t>(coordinate + kMiddle);
    }
    keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end());
  return static_cast<std::size_t>(std::unique(keys.begin(), keys.end()) - keys.begin());
}

/// Least radius of a disc [px]; a smaller one would fall between the pixels.
constexpr double kLeastRadius = 0.71;

/// Sets the slopes on the image of a disc that lies in the plane of its point.
void set_slopes(const Vector3& normal, const Vector3& ray, const Matrix3& R_view_world,
                Splat& splat) {
  // Steeper discs would become lines with gaps between them, or fall between the pixels.
  const double least_cosine = std::clamp(kLeastRadius / splat.radius, 0.3, 1.0);
  const double cosine = std::min(normal.dot(ray), -least_cosine);
  const Vector3 across = R_view_world * (normal - normal.dot(ray) * ray);
  splat.slope_x = static_cast<float>(across.x() / cosine);
  splat.slope_y = static_cast<float>(across.y() / cosine);
}

std::array<std::uint8_t, 4> lit(const std::array<std::uint8_t, 3>& rgb, double cosine) {
  // The colours of a camera already contain the light of the room; a little more shows shapes.
  constexpr double kAmbient = 0.74;
  const double light = kAmbient + (1 - kAmbient) * cosine;
  const auto level = [&](std::uint8_t value) {
    return static_cast<std::uint8_t>(std::lround(light * value));
  };
  return {level(rgb[2]), level(rgb[1]), level(rgb[0]), 255};
}

/// Turns the points of a scene into splats of a view.
class SurfaceView {
 public:
  SurfaceView(const MapView& view, double point_size)
      : view_(view),
        radius_(point_size / 2),
        R_view_world_(view.T_world_view.rotation().transpose()) {}

  /// Returns the splat of a point, or nothing if the point is not visible.
  [[nodiscard]] std::optional<Splat> splat_of(const MapPoint& point) const {
    const Vector3 place = point.position.cast<double>();
    if (!is_drawable(place)) return std::nullopt;
    const Vector3 p = view_.project(place);
    const double depth = view_.buffer_depth(p.z());
    const bool in_front = view_.orthographic || p.z() > view_.near;
    if (!in_front || !(depth >= 0 && depth < 1) || !view_.camera.contains(p.head<2>())) {
      return std::nullopt;
    }
    const Vector3 normal = unit_normal(point);
    const Vector3 ray = view_.ray(place);
    const bool has_normal = !normal.isZero(0);
    if (has_normal && normal.dot(ray) >= 0) return std::nullopt;
    const double radius = std::max(radius_ * view_.scale(p.z()), kLeastRadius);
    Splat splat;
    splat.x = static_cast<float>(p.x());
    splat.y = static_cast<float>(p.y());
    splat.depth = static_cast<float>(depth);
    splat.radius = std::min(static_cast<float>(radius), kMaxSplatRadius);
    if (has_normal) set_slopes(normal, ray, R_view_world_, splat);
    splat.color = lit(point.color, has_normal ? -normal.dot(ray) : 1);
    return splat;
  }

 private:
  const MapView& view_;
  double radius_;
  Matrix3 R_view_world_;
};

/// Returns the diameter at which discs close the surface that the points lie on [m], estimated from
/// the number of points and the area.
double estimate_point_size(const MapScene& scene, const Extent& extent) {
  constexpr std::size_t kEnough = 200'000;
  const std::vector<Vector3> places = points_within(scene.points, extent, kEnough);
  constexpr double kSingle = 0.02;  // [m]
  if (places.size() < 2) return kSingle;
  // With cells that hold several points each, the number of cells times their face is the area.
  constexpr std::size_t kPointsInACell = 4;
  const double widest = (extent.max - extent.min).maxCoeff();
  double cell = widest / 256;
  std::size_t cells = count_cells(places, cell);
  while (kPointsInACell * cells > places.size() && cell < widest) {
    cell *= 1.5;
    cells = count_cells(places, cell);
  }
  const double area = static_cast<double>(cells) * cell * cell;
  // Discs a little wider than the diagonal of a cell of a square grid leave no holes in it.
  constexpr double kDiagonal = 1.6;
  return kDiagonal * std::sqrt(area / static_cast<double>(scene.points.size()));
}

}  // namespace

void add_surface(const MapScene& scene, const Extent& extent, const MapView& view,
                 std::vector<Splat>& splats) {
  const double size = scene.point_size > 0 ? scene.point_size : estimate_point_size(scene, extent);
  const SurfaceView surface(view, size);
  splats.reserve(splats.size() + scene.points.size());
  for (const MapPoint& point : scene.points) {
    if (const auto splat = surface.splat_of(point)) splats.push_back(*splat);
  }
}

}  // namespace cvo_slam::render
