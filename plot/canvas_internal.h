// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/plot/figure.h"

namespace cvo_slam {

/// A position in the picture [px]: x to the right, y down.
struct CanvasPoint {
  double x = 0;
  double y = 0;
};

/// A part of the picture [px].
struct CanvasRectangle {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;

  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double height() const { return bottom - top; }
};

enum class TextAnchor { kStart, kMiddle, kEnd };

struct LineStyle {
  Color color = kBlack;
  double width = 1;  ///< [px]
  LinePattern pattern = LinePattern::kSolid;
};

struct TextStyle {
  double size = 13;  ///< size of the em square [px]
  Color color = kBlack;
  TextAnchor anchor = TextAnchor::kStart;
  bool vertical = false;  ///< true if the text runs upwards
};

/// A picture in the making, in one of the formats. Figures are drawn with these four operations
/// only.
class Canvas {
 public:
  virtual ~Canvas() = default;
  virtual void polyline(const std::vector<CanvasPoint>& points, const LineStyle& style) = 0;
  virtual void disc(CanvasPoint center, double radius, Color color) = 0;
  /// Draws a CV_8UC3 image that fills the rectangle.
  virtual void image(const CanvasRectangle& place, const cv::Mat& pixels) = 0;
  /// Draws a text. `position` is the point of its base line that the style's anchor names.
  virtual void text(CanvasPoint position, const std::string& text, const TextStyle& style) = 0;
  /// Returns the bytes of the picture's file.
  [[nodiscard]] virtual std::string file_bytes() const = 0;
};

/// Return an empty white picture of a size in pixels.
[[nodiscard]] std::unique_ptr<Canvas> make_svg_canvas(int width, int height);
[[nodiscard]] std::unique_ptr<Canvas> make_png_canvas(int width, int height);

/// Returns the width that a text may take [px]: a little more than any font in use needs.
[[nodiscard]] double text_width(const std::string& text, double size);

/// Returns the lengths of a pattern's strokes and gaps in turn [px]; empty for a solid line. Wider
/// lines have longer strokes.
[[nodiscard]] std::vector<double> dashes(const LineStyle& style);

/// Returns the visible parts of a polyline. `pattern` holds the lengths of a stroke, of the gap
/// behind it, and so on [px], all > 0; it is repeated. An empty pattern returns the line whole.
[[nodiscard]] std::vector<std::vector<CanvasPoint>> strokes_of(
    const std::vector<CanvasPoint>& points, const std::vector<double>& pattern);

}  // namespace cvo_slam
