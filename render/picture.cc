// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/render/picture.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/render/cameras_internal.h"
#include "cvo_slam/render/grid_internal.h"
#include "cvo_slam/render/overlay_internal.h"
#include "cvo_slam/render/shading_internal.h"
#include "cvo_slam/render/surface_internal.h"

namespace cvo_slam::render {
namespace {

/// Drawn this much larger and shrunk.
constexpr int kOversampling = 2;
constexpr Color kBackground{247, 248, 250};

/// The width of a thin line [px of the picture]: the same share of any size, a pixel and a half of
/// a full HD picture.
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

cv::Mat draw_message(const View& view, const std::string& message) {
  cv::Mat image(view.camera.height * kOversampling, view.camera.width * kOversampling, CV_8UC3,
                cv::Scalar(kBackground.blue, kBackground.green, kBackground.red));
  Overlay(image, view, kOversampling * thin_line(view.camera)).draw_message(message);
  return shrunk(image);
}

Primitives primitives_of(const Scene& scene, const Extent& extent, const Grid& grid,
                         const ColorScale& scale, const View& view, double unit) {
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

void draw_texts(const Scene& scene, const Extent& extent, const Grid& grid, const ColorScale& scale,
                const cv::Mat& depth, Overlay& overlay) {
  overlay.draw_title(scene.title);
  overlay.draw_legend(legend_of(scene, scale), scale, scene.value_label);
  if (!scene.ground) return;
  overlay.draw(axis_labels(extent));
  overlay.draw(grid.labels(), depth);
}

}  // namespace

Picture draw_picture(const Scene& scene, const ViewOptions& options, Renderer& renderer) {
  const bool empty = extent_of(scene).empty;
  const ViewOptions any{.width = options.width, .height = options.height};
  return draw_picture(scene, empty ? make_view({}, any) : make_view(scene, options), renderer);
}

Picture draw_picture(const Scene& scene, const View& seen_from, Renderer& renderer) {
  const Extent extent = extent_of(scene);
  if (extent.empty) {
    return {draw_message(seen_from, "nothing to draw: no point and no pose"), scene_notes(scene)};
  }
  const View view = enlarged(seen_from, kOversampling);
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
  const std::string extension = file.extension().string();
  const bool jpeg = extension == ".jpg" || extension == ".jpeg";
  std::vector<unsigned char> bytes;
  const std::vector<int> options =
      jpeg ? std::vector<int>{cv::IMWRITE_JPEG_QUALITY, 85} : std::vector<int>{};
  if (!cv::imencode(jpeg ? ".jpg" : ".png", image, bytes, options)) {
    throw OutputError(file, "OpenCV cannot encode the image");
  }
  write_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace cvo_slam::render
