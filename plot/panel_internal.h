// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "cvo_slam/plot/canvas_internal.h"
#include "cvo_slam/plot/figure.h"

namespace cvo_slam {

// The look that all parts of a figure share; sizes in pixels.
inline constexpr Color kInk{51, 51, 51};
inline constexpr double kLabelSize = 14;
inline constexpr double kGap = 8;  ///< gap between a text and what it names

/// Draws one panel into its cell of the figure.
void draw_panel(const Panel& panel, const CanvasRectangle& cell, Canvas& canvas);

/// A closed interval of an axis; min < max.
struct AxisRange {
  double min = 0;
  double max = 1;

  [[nodiscard]] double length() const { return max - min; }
};

/// A labelled position on an axis.
struct Tick {
  double value = 0;
  std::string label;
};

/// Returns the multiples of a step inside the range. The step is 1, 2 or 5 times a power of ten,
/// the smallest that divides the range into at most `max_count` (>= 2) steps. All labels have the
/// same number of decimals.
[[nodiscard]] std::vector<Tick> make_ticks(const AxisRange& range, int max_count);

}  // namespace cvo_slam
