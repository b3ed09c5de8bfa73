// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The two implementations of Renderer.
#pragma once

#include <memory>
#include <string>

#include "cvo_slam/render/gl_context_internal.h"
#include "cvo_slam/render/renderer.h"

namespace cvo_slam::render {

/// Returns a renderer that draws with OpenGL 2.1 in the given context. The context is current only
/// while the renderer draws. Throws Error if the context lacks a function or cannot draw.
[[nodiscard]] std::unique_ptr<Renderer> make_gl_renderer(std::string name,
                                                         std::unique_ptr<GlContext> context);

/// Draws without OpenGL. The order of the operations is fixed and all of them are those of IEEE 754
/// (+ - * /), so that every machine gives the same pixels.
class SplatRenderer : public Renderer {
 public:
  [[nodiscard]] std::string name() const override { return "splat"; }
  [[nodiscard]] Raster draw(const Primitives& primitives, cv::Size size, Color background) override;
};

}  // namespace cvo_slam::render
