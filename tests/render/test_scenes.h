// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "cvo_slam/core/error.h"
#include "cvo_slam/render/picture.h"

namespace cvo_slam::render {

inline MapPoint map_point(const Vector3& place, const std::array<std::uint8_t, 3>& rgb,
                          const Vector3& normal = Vector3::Zero()) {
  return {place.cast<float>(), normal.cast<float>(), rgb};
}

/// A square of points at `center`, 2 cm apart, spanned by two unit vectors.
inline void add_wall(MapScene& scene, const Vector3& center, const Vector3& along,
                     const Vector3& aside, double half_size, const std::array<std::uint8_t, 3>& rgb,
                     const Vector3& normal = Vector3::Zero()) {
  constexpr double kSpacing = 0.02;
  const int n = static_cast<int>(half_size / kSpacing);
  for (int i = -n; i <= n; ++i) {
    for (int j = -n; j <= n; ++j) {
      scene.points.push_back(map_point(center + kSpacing * (i * along + j * aside), rgb, normal));
    }
  }
}

/// A world with z up: a grey floor of 2 m and a path of ten poses 1 m above it.
inline MapScene floor_scene() {
  MapScene scene;
  scene.up = Vector3::UnitZ();
  add_wall(scene, {0, 0, 0}, Vector3::UnitX(), Vector3::UnitY(), 1, {120, 120, 120},
           Vector3::UnitZ());
  std::vector<StampedPose> poses;
  // The camera looks along y of the world: x is to its right, -z is down.
  const Matrix3 ahead{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
  for (int i = 0; i < 10; ++i) {
    poses.push_back({Timestamp::from_seconds(0.1 * i), SE3(ahead, {0.1 * i - 0.5, 0, 1})});
    scene.keyframes.push_back(poses.back().T_world_camera);
  }
  add_path_by_time(scene, "trajectory", poses);
  return scene;
}

/// Returns the pixels of an image for which a predicate of blue, green and red is true.
template <typename Predicate>
std::vector<cv::Point> pixels_where(const cv::Mat& image, const Predicate& predicate) {
  std::vector<cv::Point> pixels;
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      const auto& bgr = image.at<cv::Vec3b>(v, u);
      if (predicate(bgr)) pixels.emplace_back(u, v);
    }
  }
  return pixels;
}

inline bool is_red(const cv::Vec3b& bgr) { return bgr[2] > 120 && bgr[0] < 60 && bgr[1] < 60; }

/// Returns all renderers that work on this machine. They are made once for all tests.
inline const std::vector<std::unique_ptr<Renderer>>& all_renderers() {
  static const auto all = [] {
    std::vector<std::unique_ptr<Renderer>> renderers;
    renderers.push_back(make_renderer(RendererKind::kSplat));
    renderers.push_back(make_renderer(RendererKind::kOsmesa));
    try {
      renderers.push_back(make_renderer(RendererKind::kEgl));
    } catch (const Error&) {
      // EGL may be missing or need a surface on this machine; OSMesa is in apt-packages.txt.
    }
    return renderers;
  }();
  return all;
}

}  // namespace cvo_slam::render
