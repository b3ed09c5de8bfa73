// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "cvo_slam/render/renderers_internal.h"

namespace cvo_slam::render {
namespace {

/// The pixels of an image row or column of `size` pixels between two borders.
struct PixelRange {
  PixelRange(double low, double high, int size)
      : begin(static_cast<int>(std::ceil(std::clamp(low, 0.0, static_cast<double>(size))))),
        end(static_cast<int>(std::floor(std::clamp(high, -1.0, size - 1.0))) + 1) {}
  int begin;
  int end;
};

cv::Vec3b to_pixel(const std::array<std::uint8_t, 4>& color) {
  return {color[0], color[1], color[2]};
}

/// Draws into colour and depth of a raster; the nearest wins.
class DepthBuffer {
 public:
  explicit DepthBuffer(Raster& raster) : raster_(raster) {}

  void add(const Splat& splat) {
    const double radius = splat.radius;
    if (!std::isfinite(splat.x + splat.y + radius)) return;
    const PixelRange columns(splat.x - radius, splat.x + radius, raster_.color.cols);
    const PixelRange rows(splat.y - radius, splat.y + radius, raster_.color.rows);
    const cv::Vec3b pixel = to_pixel(splat.color);
    for (int v = rows.begin; v < rows.end; ++v) {
      const float dy = static_cast<float>(v) - splat.y;
      auto* depths = raster_.depth.ptr<float>(v);
      auto* colors = raster_.color.ptr<cv::Vec3b>(v);
      for (int u = columns.begin; u < columns.end; ++u) {
        const float dx = static_cast<float>(u) - splat.x;
        const float rise = splat.slope_x * dx + splat.slope_y * dy;
        const bool inside = dx * dx + dy * dy + rise * rise <= splat.radius * splat.radius;
        if (!inside || !(splat.depth < depths[u])) continue;
        depths[u] = splat.depth;
        colors[u] = pixel;
      }
    }
  }

  void add(const Corner& a, const Corner& b, const Corner& c) {
    const double area = cross(a, b, c.x, c.y);
    if (area == 0 || !std::isfinite(area)) return;
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
    const PixelRange columns(left, right, raster_.color.cols);
    const PixelRange rows(top, bottom, raster_.color.rows);
    for (int v = rows.begin; v < rows.end; ++v) {
      for (int u = columns.begin; u < columns.end; ++u) {
        const double of_a = cross(b, c, u, v) / area;
        const double of_b = cross(c, a, u, v) / area;
        const double of_c = cross(a, b, u, v) / area;
        if (of_a < 0 || of_b < 0 || of_c < 0) continue;
        put(u, v, a.depth * of_a + b.depth * of_b + c.depth * of_c,
            mixed(a.color, of_a, b.color, of_b, c.color, of_c));
      }
    }
  }

 private:
  /// Returns twice the signed area of the triangle p, q, (x, y).
  static double cross(const Corner& p, const Corner& q, double x, double y) {
    const double qx = static_cast<double>(q.x) - p.x;
    const double qy = static_cast<double>(q.y) - p.y;
    return qx * (y - p.y) - qy * (x - p.x);
  }

  using Channels = std::array<std::uint8_t, 4>;
  static cv::Vec3b mixed(const Channels& a, double of_a, const Channels& b, double of_b,
                         const Channels& c, double of_c) {
    cv::Vec3b pixel;
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double level = a[k] * of_a + b[k] * of_b + c[k] * of_c;
      pixel[i] = static_cast<std::uint8_t>(std::clamp(level + 0.5, 0.0, 255.0));
    }
    return pixel;
  }

  void put(int u, int v, double depth, const cv::Vec3b& pixel) {
    auto& nearest = raster_.depth.at<float>(v, u);
    if (!(depth < nearest) || depth < 0) return;
    nearest = static_cast<float>(depth);
    raster_.color.at<cv::Vec3b>(v, u) = pixel;
  }

  Raster& raster_;
};

}  // namespace

Raster SplatRenderer::draw(const Primitives& primitives, cv::Size size, Color background) {
  Raster raster{
      cv::Mat(size, CV_8UC3, cv::Scalar(background.blue, background.green, background.red)),
      cv::Mat(size, CV_32FC1, cv::Scalar(1))};
  DepthBuffer buffer(raster);
  for (const Splat& splat : primitives.splats) buffer.add(splat);
  const auto& corners = primitives.corners;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    buffer.add(corners[i], corners[i + 1], corners[i + 2]);
  }
  return raster;
}

}  // namespace cvo_slam::render
