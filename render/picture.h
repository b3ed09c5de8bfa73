// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/render/map_scene.h"
#include "cvo_slam/render/map_view.h"
#include "cvo_slam/render/renderer.h"

namespace cvo_slam::render {

/// A picture of a scene.
struct Picture {
  cv::Mat image;                   ///< CV_8UC3: blue, green, red
  std::vector<std::string> notes;  ///< what was left out and why; a line each
};

/// Draws a scene: its points, paths, keyframes and constraints over a metric grid, with axes,
/// labels and a legend. The scene is drawn at twice the size and shrunk, so that edges are smooth.
/// A scene without anything to draw gives a picture that says so. Throws OptionError for an
/// impossible size or a view that the scene does not have, and Error if the renderer cannot draw.
[[nodiscard]] Picture draw_picture(const MapScene& scene, const ViewOptions& options,
                                   Renderer& renderer);

/// Draws a scene in a given view, so that several scenes can be seen from the same position.
[[nodiscard]] Picture draw_picture(const MapScene& scene, const MapView& seen_from,
                                   Renderer& renderer);

/// Writes an image as JPEG if the name ends in .jpg or .jpeg, otherwise as PNG. Throws OutputError.
void write_picture(const std::filesystem::path& file, const cv::Mat& image);

}  // namespace cvo_slam::render
