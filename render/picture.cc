// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/render/picture.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/render/grid_internal.h"
#include "cvo_slam/render/line_art_internal.h"
#include "cvo_slam/render/overlay_internal.h"
#include "cvo_slam/render/surface_internal.h"

namespace cvo_slam::render {
namespace {

/// Returns the depth on a scale on which equal steps are equal shares of the distance.
cv::Mat relative_depth(const MapView& view, const cv::Mat& depth) {
  cv::Mat result;
  if (view.orthographic) {
    // An orthographic view has no eye distance; the length of its depth range takes its place.
    constexpr double kDepthsInRange = 4;
    depth.convertTo(result, CV_32F, kDepthsInRange);
    return result;
  }
  // The buffer holds 1 - near / z, of which -log(1 - depth) = log(z / near).
  depth.convertTo(result, CV_32F, -1, 1);
  result = cv::max(result, 1e-6);
  cv::log(result, result);
  result *= -1;
  return result;
}

/// Returns for each pixel the sum over its neighbours of their depth in front of it.
cv::Mat depth_behind_neighbours(const cv::Mat& depth, int radius) {
  cv::Mat sum = cv::Mat::zeros(depth.size(), CV_32FC1);
  const std::array<cv::Point, 4> directions = {cv::Point(1, 0), {0, 1}, {1, 1}, {1, -1}};
  for (const cv::Point& direction : directions) {
    for (const int sign : {-1, 1}) {
      const cv::Point shift = sign * radius * direction;
      const cv::Rect whole(cv::Point(0, 0), depth.size());
      const cv::Rect here = whole & (whole - shift);
      for (int v = here.y; v < here.y + here.height; ++v) {
        const auto* own = depth.ptr<float>(v);
        const auto* other = depth.ptr<float>(v + shift.y) + shift.x;
        auto* out = sum.ptr<float>(v);
        for (int u = here.x; u < here.x + here.width; ++u) {
          // One large step must not outweigh all others.
          out[u] += std::clamp(own[u] - other[u], 0.0F, 0.1F);
        }
      }
    }
  }
  return sum;
}

/// Darkens pixels that lie behind their neighbours, so that edges and corners are visible whatever
/// their colours are: eye-dome lighting, C. Boucheny, "Visualisation scientifique de grands volumes
/// de donnees", 2009. `radius` is the distance of the neighbours [px].
void shade_by_depth(const MapView& view, int radius, Raster& raster) {
  constexpr double kStrength = 3.5;
  constexpr float kDarkest = 0.4F;
  cv::Mat light = depth_behind_neighbours(relative_depth(view, raster.depth), radius);
  light *= -kStrength;
  cv::exp(light, light);
  for (int v = 0; v < light.rows; ++v) {
    const auto* factors = light.ptr<float>(v);
    const auto* depths = raster.depth.ptr<float>(v);
    auto* pixels = raster.color.ptr<cv::Vec3b>(v);
    for (int u = 0; u < light.cols; ++u) {
      if (depths[u] >= 1) continue;  // the background stays as it is
      const float factor = std::max(factors[u], kDarkest);
      for (int k = 0; k < 3; ++k) {
        pixels[u][k] = cv::saturate_cast<std::uint8_t>(factor * static_cast<float>(pixels[u][k]));
      }
    }
  }
}

std::string to_lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// The picture is drawn this much larger and then shrunk.
constexpr int kOversampling = 2;
constexpr Color kBackground{247, 248, 250};

/// Returns the width of a thin line [px of the picture]: the same share of any picture size, 1.5 px
/// in full HD.
double thin_line(const PinholeCamera& camera) {
  return std::clamp(std::sqrt(camera.width * static_cast<double>(camera.height)) / 960, 0.5, 6.0);
}

std::vector<Label> axis_labels(const Extent& extent) {
  if (!shows_axes(extent)) return {};
  const Matrix3 ends = axis_length(extent) * Matrix3::Identity();
  return {{ends.col(0), Vector3::Zero(), "x"},
          {ends.col(1), Vector3::Zero(), "y"},
          {ends.col(2), Vector3::Zero(), "z"}};
}

cv::Mat shrunk(const cv::Mat& image) {
  cv::Mat result;
  cv::resize(image, result, image.size() / kOversampling, 0, 0, cv::INTER_AREA);
  return result;
}

cv::Mat draw_message(const MapView& view, const std::string& message) {
  cv::Mat image(view.camera.height * kOversampling, view.camera.width * kOversampling, CV_8UC3,
                cv::Scalar(kBackground.blue, kBackground.green, kBackground.red));
  Overlay(image, view, kOversampling * thin_line(view.camera)).draw_message(message);
  return shrunk(image);
}

Primitives primitives_of(const MapScene& scene, const Extent& extent, const Grid& grid,
                         const ColorScale& scale, const MapView& view, double unit) {
  Primitives primitives;
  add_surface(scene, extent, view, primitives.splats);
  LineArt art(view, primitives);
  if (scene.ground) grid.add_to(art, unit);
  add_constraints(scene, unit, art);
  add_keyframes(scene, extent, unit, art);
  add_paths(scene, scale, unit, art);
  if (scene.ground) add_axes(extent, unit, art);
  return primitives;
}

void draw_texts(const MapScene& scene, const Extent& extent, const Grid& grid,
                const ColorScale& scale, const cv::Mat& depth, Overlay& overlay) {
  overlay.draw_title(scene.title);
  overlay.draw_legend(legend_of(scene, scale), scale, scene.value_label);
  if (!scene.ground) return;
  overlay.draw(axis_labels(extent));
  overlay.draw(grid.labels(), depth);
}

}  // namespace

Picture draw_picture(const MapScene& scene, const ViewOptions& options, Renderer& renderer) {
  const bool empty = extent_of(scene).empty;
  const ViewOptions any{.width = options.width, .height = options.height};
  return draw_picture(scene, empty ? make_view({}, any) : make_view(scene, options), renderer);
}

Picture draw_picture(const MapScene& scene, const MapView& seen_from, Renderer& renderer) {
  const Extent extent = extent_of(scene);
  if (extent.empty) {
    return {draw_message(seen_from, "nothing to draw: no point and no pose"), scene_notes(scene)};
  }
  const MapView view = enlarged(seen_from, kOversampling);
  const double unit = kOversampling * thin_line(seen_from.camera);
  const Grid grid(extent, view);
  const ColorScale scale(scene);
  const Primitives primitives = primitives_of(scene, extent, grid, scale, view, unit);
  Raster raster = renderer.draw(primitives, {view.camera.width, view.camera.height}, kBackground);
  shade_by_depth(view, std::max(1, static_cast<int>(std::lround(unit))), raster);

  Overlay overlay(raster.color, view, unit);
  draw_texts(scene, extent, grid, scale, raster.depth, overlay);
  return {shrunk(raster.color), scene_notes(scene)};
}

void write_picture(const std::filesystem::path& file, const cv::Mat& image) {
  const std::string extension = to_lower(file.extension().string());
  const bool jpeg = extension == ".jpg" || extension == ".jpeg";
  std::vector<unsigned char> bytes;
  const std::vector<int> options =
      jpeg ? std::vector<int>{cv::IMWRITE_JPEG_QUALITY, 85} : std::vector<int>{};
  if (!cv::imencode(jpeg ? ".jpg" : ".png", image, bytes, options)) {
    throw OutputError(file, "OpenCV cannot encode the image; choose another size or .png");
  }
  write_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace cvo_slam::render
