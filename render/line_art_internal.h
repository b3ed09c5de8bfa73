// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/render/primitives.h"
#include "cvo_slam/render/view.h"

namespace cvo_slam::render {

[[nodiscard]] inline std::array<std::uint8_t, 4> to_bgr(Color color) {
  return {color.blue, color.green, color.red, 255};
}

/// Adds lines and dots of a width in pixels to what will be drawn.
class LineArt {
 public:
  /// Both must outlive the object.
  LineArt(const View& view, Primitives& primitives) : view_(view), primitives_(primitives) {}

  /// From a to b in the world, `width` [px] wide, its colour from that of a to that of b.
  void line(const Vector3& a, const Vector3& b, double width, Color color_a, Color color_b);
  void line(const Vector3& a, const Vector3& b, double width, Color color) {
    line(a, b, width, color, color);
  }
  void dot(const Vector3& place, double radius, Color color);

 private:
  const View& view_;
  Primitives& primitives_;
};

}  // namespace cvo_slam::render
