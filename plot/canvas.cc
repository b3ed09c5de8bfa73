// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <utility>

#include "cvo_slam/plot/canvas_internal.h"

namespace cvo_slam {
namespace {

CanvasPoint between(const CanvasPoint& a, const CanvasPoint& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

/// Draws along a line and lifts the pen in the gaps.
class Pen {
 public:
  Pen(const CanvasPoint& start, const std::vector<double>& pattern)
      : pattern_(pattern), left_(pattern.front()), last_(start), stroke_{start} {}

  void draw_to(const CanvasPoint& end) {
    CanvasPoint at = last_;
    double distance = std::hypot(end.x - at.x, end.y - at.y);
    while (distance > left_) {
      at = between(at, end, left_ / distance);
      distance -= left_;
      turn_over(at);
    }
    left_ -= distance;
    if (is_down()) stroke_.push_back(end);
    last_ = end;
  }

  std::vector<std::vector<CanvasPoint>> finish() {
    keep_stroke();
    return std::move(strokes_);
  }

 private:
  [[nodiscard]] bool is_down() const { return part_ % 2 == 0; }

  /// Ends a stroke or a gap and begins the next one.
  void turn_over(const CanvasPoint& at) {
    if (is_down()) stroke_.push_back(at);
    keep_stroke();
    part_ = (part_ + 1) % pattern_.size();
    left_ = pattern_[part_];
    if (is_down()) stroke_.push_back(at);
  }

  void keep_stroke() {
    if (stroke_.size() > 1) strokes_.push_back(stroke_);
    stroke_.clear();
  }

  const std::vector<double>& pattern_;
  std::size_t part_ = 0;  // index into the pattern; odd parts are gaps
  double left_;           // remaining length of the part [px]
  CanvasPoint last_;
  std::vector<CanvasPoint> stroke_;
  std::vector<std::vector<CanvasPoint>> strokes_;
};

}  // namespace

double text_width(const std::string& text, double size) {
  constexpr double kEmPerCharacter = 0.7;
  return kEmPerCharacter * size * static_cast<double>(text.size());
}

std::vector<double> dashes(const LineStyle& style) {
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

std::vector<std::vector<CanvasPoint>> strokes_of(const std::vector<CanvasPoint>& points,
                                                 const std::vector<double>& pattern) {
  if (pattern.empty() || points.empty()) return {points};
  Pen pen(points.front(), pattern);
  for (std::size_t i = 1; i < points.size(); ++i) pen.draw_to(points[i]);
  return pen.finish();
}

}  // namespace cvo_slam
