// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "cvo_slam/io/plot/figure.h"

namespace cvo_slam {

/// A place on a picture [px]: x to the right, y down.
struct CanvasPoint {
  double x = 0;
  double y = 0;
};

enum class TextAnchor { kStart, kMiddle, kEnd };

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
  virtual void polyline(const std::vector<CanvasPoint>& points, Color color, double width) = 0;
  virtual void disc(CanvasPoint center, double radius, Color color) = 0;
  /// `anchor` says which part of the base line `position` is.
  virtual void text(CanvasPoint position, const std::string& text, const TextStyle& style) = 0;
};

/// Room to leave for a text [px]: a little more than what the fonts in use need.
inline double text_width(const std::string& text, double size) {
  constexpr double kEmPerCharacter = 0.7;
  return kEmPerCharacter * size * static_cast<double>(text.size());
}

}  // namespace cvo_slam
