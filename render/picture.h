// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/render/renderer.h"
#include "cvo_slam/render/scene.h"
#include "cvo_slam/render/view.h"

namespace cvo_slam::render {

struct Picture {
  cv::Mat image;                   ///< CV_8UC3: blue, green, red
  std::vector<std::string> notes;  ///< what is not in it, and why; a line each
};

/// Draws a scene: its points, paths, keyframes and constraints over a grid of metres, with axes,
/// labels and a legend. Drawn with twice the pixels along and across and shrunk, so that edges are
/// smooth. A scene in which nothing can be drawn gives a picture that says so.
/// Throws OptionError for an impossible size or a view that the scene has not, Error where the
/// renderer cannot draw.
[[nodiscard]] Picture draw_picture(const Scene& scene, const ViewOptions& view, Renderer& renderer);

/// The same from a view of one's own, so that several scenes are seen from one place.
[[nodiscard]] Picture draw_picture(const Scene& scene, const View& seen_from, Renderer& renderer);

/// Writes an image as PNG, or as JPEG where the name ends so. Throws OutputError.
void write_picture(const std::filesystem::path& file, const cv::Mat& image);

}  // namespace cvo_slam::render
