// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/plot/figure.h"
#include "cvo_slam/render/primitives.h"

namespace cvo_slam::render {

/// What a renderer answers.
struct Raster {
  cv::Mat color;  ///< CV_8UC3: blue, green, red
  cv::Mat depth;  ///< CV_32FC1, from 0 to 1; 1 where there is nothing
};

/// Draws primitives off-screen, without a display. For one thread at a time.
class Renderer {
 public:
  virtual ~Renderer() = default;
  /// The name of its kind, and what it runs on.
  [[nodiscard]] virtual std::string name() const = 0;
  /// Throws Error where the renderer cannot draw an image of that size.
  [[nodiscard]] virtual Raster draw(const Primitives& primitives, cv::Size size,
                                    Color background) = 0;
};

enum class RendererKind {
  kAuto,    ///< kOsmesa where it is installed and works, else kSplat
  kOsmesa,  ///< Mesa's off-screen OpenGL on the CPU
  kEgl,     ///< OpenGL by EGL without a surface: on the GPU where there is one
  kSplat,   ///< no OpenGL at all, and the same pixels everywhere
};

/// The names that people type: auto, osmesa, egl, splat.
[[nodiscard]] const std::vector<std::pair<std::string, RendererKind>>& renderer_names();

/// Libraries of OpenGL are loaded here, at run time. Throws Error, with the package to install,
/// where they are missing or cannot draw.
[[nodiscard]] std::unique_ptr<Renderer> make_renderer(RendererKind kind = RendererKind::kAuto);

}  // namespace cvo_slam::render
