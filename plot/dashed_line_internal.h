// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "cvo_slam/plot/canvas_internal.h"

namespace cvo_slam {

/// The parts of a polyline that are drawn: `pattern` is the length of a stroke, that of the gap
/// behind it, and so on, again and again; all > 0. An empty pattern leaves the line whole.
[[nodiscard]] std::vector<std::vector<CanvasPoint>> strokes_of(
    const std::vector<CanvasPoint>& points, const std::vector<double>& pattern);

}  // namespace cvo_slam
