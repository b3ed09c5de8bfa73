// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "cvo_slam/plot/figure.h"

namespace cvo_slam {

/// A place on a picture [px]: x to the right, y down.
struct CanvasPoint {
  double x = 0;
  double y = 0;
};

/// A part of a picture [px].
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

/// The lengths of a pattern's strokes and of the gaps behind them, in turn [px]; empty for a solid
/// line. Wider lines have longer ones.
[[nodiscard]] inline std::vector<double> dashes(const LineStyle& style) {
  const double unit = 2 + style.width;
  switch (style.pattern) {
    case LinePattern::kSolid:
      return {};
    case LinePattern::kDashed:
      return {2.5 * unit, 1.5 * unit};
    case LinePattern::kDotted:
      return {0.6 * unit, 1.1 * unit};
    case LinePattern::kDashDotted:
      return {2.5 * unit, unit, 0.6 * unit, unit};
  }
  return {};
}

struct TextStyle {
  double size = 13;  ///< of the em square [px]
  Color color = kBlack;
  TextAnchor anchor = TextAnchor::kStart;
  bool vertical = false;  ///< read from below
};

/// What a figure is drawn with, whatever the format.
class Canvas {
 public:
  virtual ~Canvas() = default;
  virtual void polyline(const std::vector<CanvasPoint>& points, const LineStyle& style) = 0;
  virtual void disc(CanvasPoint center, double radius, Color color) = 0;
  /// A CV_8UC3 image that fills the rectangle.
  virtual void image(const CanvasRectangle& place, const cv::Mat& pixels) = 0;
  /// `anchor` says which part of the base line `position` is.
  virtual void text(CanvasPoint position, const std::string& text, const TextStyle& style) = 0;
};

/// Room to leave for a text [px]: a little more than what the fonts in use need.
inline double text_width(const std::string& text, double size) {
  constexpr double kEmPerCharacter = 0.7;
  return kEmPerCharacter * size * static_cast<double>(text.size());
}

}  // namespace cvo_slam
