// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/plot/figure.h"

namespace cvo_slam::render {

/// A piece of surface on the image: the ellipse as which a disc is seen. A pixel at (dx, dy) from
/// the centre belongs to it if dx^2 + dy^2 + (slope_x dx + slope_y dy)^2 <= radius^2.
struct Splat {
  float x = 0;        ///< column of the centre [px]; 0 is the middle of the leftmost pixels
  float y = 0;        ///< row of the centre [px]; 0 is the middle of the uppermost pixels
  float depth = 0;    ///< 0 = nearest to 1 = farthest
  float radius = 0;   ///< [px], at most kMaxSplatRadius
  float slope_x = 0;  ///< slope of the disc along the rows; 0 = it faces the viewer
  float slope_y = 0;  ///< slope of the disc along the columns; 0 = it faces the viewer
  std::array<std::uint8_t, 4> color = {0, 0, 0, 255};  ///< blue, green, red; the fourth is unused
};

/// Largest radius of a splat [px]. OpenGL limits the size of its points, Mesa to 255 pixels.
inline constexpr float kMaxSplatRadius = 120;

/// A corner of a triangle on the image.
struct Corner {
  float x = 0;                                         ///< column [px], as of a splat
  float y = 0;                                         ///< row [px], as of a splat
  float depth = 0;                                     ///< 0 = nearest to 1 = farthest
  std::array<std::uint8_t, 4> color = {0, 0, 0, 255};  ///< blue, green, red; the fourth is unused
};

/// All that a renderer draws. At each pixel the nearest one is visible.
struct Primitives {
  std::vector<Splat> splats;    ///< pieces of surfaces
  std::vector<Corner> corners;  ///< three in a row are a triangle, in either orientation
};

/// The result of a renderer.
struct Raster {
  cv::Mat color;  ///< CV_8UC3: blue, green, red
  cv::Mat depth;  ///< CV_32FC1, from 0 to 1; 1 = nothing was drawn
};

/// Draws primitives off-screen, without a display. An object serves one thread at a time.
class Renderer {
 public:
  virtual ~Renderer() = default;
  /// Returns the name of the renderer and of the device that it runs on.
  [[nodiscard]] virtual std::string name() const = 0;
  /// Throws Error if the renderer cannot draw an image of that size.
  [[nodiscard]] virtual Raster draw(const Primitives& primitives, cv::Size size,
                                    Color background) = 0;
};

/// The renderers that make_renderer() can make.
enum class RendererKind {
  kAuto,    ///< kOsmesa if it is installed and works, otherwise kSplat
  kOsmesa,  ///< Mesa's off-screen OpenGL on the CPU
  kEgl,     ///< OpenGL through EGL without a surface: on the GPU if there is one
  kSplat,   ///< software renderer without OpenGL; gives the same pixels on every machine
};
/// Returns the names that users type: auto, osmesa, egl, splat.
[[nodiscard]] const std::vector<std::pair<std::string, RendererKind>>& renderer_names();

/// Returns a renderer. Libraries of OpenGL are loaded here, at run time. Throws Error, which names
/// the package to install, if they are missing or cannot draw.
[[nodiscard]] std::unique_ptr<Renderer> make_renderer(RendererKind kind = RendererKind::kAuto);

}  // namespace cvo_slam::render
