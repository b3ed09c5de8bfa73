// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/plot/canvas_internal.h"
#include "cvo_slam/plot/figure.h"

namespace cvo_slam {

/// How figures look; sizes in pixels.
inline constexpr Color kInk{51, 51, 51};
inline constexpr double kLabelSize = 14;
inline constexpr double kGap = 8;  ///< between a text and what it belongs to

/// Draws one panel into the part of the figure that is its own.
void draw_panel(const Panel& panel, const CanvasRectangle& cell, Canvas& canvas);

}  // namespace cvo_slam
