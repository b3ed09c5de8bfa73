// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/render/renderer.h"

namespace cvo_slam::render {

/// Draws without OpenGL, in an order and with operations (+ - * / of IEEE 754) that give the same
/// pixels on every machine.
class SplatRenderer : public Renderer {
 public:
  [[nodiscard]] std::string name() const override { return "splat"; }
  [[nodiscard]] Raster draw(const Primitives& primitives, cv::Size size, Color background) override;
};

}  // namespace cvo_slam::render
