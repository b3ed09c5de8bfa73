// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "cvo_slam/core/camera.h"
#include "cvo_slam/core/se3.h"

namespace cvo_slam {

/// The plane that fits the depths around a point best.
struct SurfacePatch {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< unit vector; zero if no plane fits
  float roughness = 0;  ///< standard deviation of the depths' points from the plane [m]
};

/// Returns the point of the square [-1, 1]^2 that a unit vector has on the unfolded octahedron
/// |x| + |y| + |z| = 1: two numbers in place of three.
[[nodiscard]] Eigen::Vector2f to_octahedron(const Eigen::Vector3f& unit);

/// Returns the unit vector of a point that to_octahedron() returned.
[[nodiscard]] Eigen::Vector3f from_octahedron(const Eigen::Vector2f& point);

/// A coloured point cloud as a structure of arrays; all arrays have size() entries.
struct PointCloud {
  /// blue, green, red, dI/dx, dI/dy, on the scale of 8-bit values.
  static constexpr std::size_t kFeatures = 5;

  ///@{
  /// Coordinate of each position in the camera frame [m].
  std::vector<float> x, y, z;
  ///@}
  /// Feature f of point i is features[f][i].
  std::array<std::vector<float>, kFeatures> features;
  ///@{
  /// Column (u) or row (v) of the pixel that each point was seen at [px].
  std::vector<float> u, v;
  ///@}
  /// Standard deviation of each position along the ray from the origin [m]; empty = none known.
  std::vector<float> ray_noise;
  /// The surface around each point; empty = none known.
  std::vector<SurfacePatch> surfaces;
  /// Noise of the depth image as its smooth surfaces show it: the standard deviation of a depth z
  /// over z^2 [1/m]. A Kinect shows 0.0012 to 0.0016. Infinity = not known.
  float surface_noise = std::numeric_limits<float>::infinity();

  /// Returns the number of points.
  [[nodiscard]] std::size_t size() const { return x.size(); }
  /// Returns true if there are no points.
  [[nodiscard]] bool empty() const { return x.empty(); }
  /// Returns the position of point i in the camera frame [m].
  [[nodiscard]] Vector3 position(std::size_t i) const { return {x[i], y[i], z[i]}; }

  /// Removes all points and keeps the memory.
  void clear() { resize(0); }
  /// Sets the number of points; all values of new ones are zero. `ray_noise` and `surfaces` stay
  /// empty if they are.
  void resize(std::size_t n) {
    for (auto* array : {&x, &y, &z, &u, &v}) array->resize(n);
    for (auto& feature : features) feature.resize(n);
    if (!ray_noise.empty()) ray_noise.resize(n);
    if (!surfaces.empty()) surfaces.resize(n);
  }
};

/// The part of space that a camera sees, whatever stands in between.
class FieldOfView {
 public:
  /// `camera` is copied.
  explicit FieldOfView(const PinholeCamera& camera);

  /// Returns true if a point of the camera frame [m], more than 0.1 m in front of the camera, lies
  /// in the image. Points further off the axis than the corners of the image never do: Brown's
  /// polynomial may lead them back into it.
  [[nodiscard]] bool contains(const Vector3& point) const;

 private:
  PinholeCamera camera_;
  // (x^2 + y^2) / z^2 of the widest ray into the image; without distortion, none need be left out.
  double max_radius2_ = std::numeric_limits<double>::infinity();
};

/// Returns the share of a cloud's points that lie in a camera's image, whatever stands in between.
/// Only its first hundred points count: those of a selected cloud are spread over the image as all
/// are, and a hundred give the share within a few hundredths. 0 for a cloud without points. `Cloud`
/// has size() and position(i), as PointCloud has.
template <typename Cloud>
[[nodiscard]] double visible_share(const Cloud& cloud, const SE3& T_camera_cloud,
                                   const FieldOfView& field_of_view) {
  constexpr std::size_t kPoints = 100;
  const std::size_t n = std::min(kPoints, cloud.size());
  if (n == 0) return 0;
  std::size_t visible = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (field_of_view.contains(T_camera_cloud * cloud.position(i))) ++visible;
  }
  return static_cast<double>(visible) / static_cast<double>(n);
}

}  // namespace cvo_slam
