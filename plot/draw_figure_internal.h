// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/plot/canvas_internal.h"
#include "cvo_slam/plot/figure.h"

namespace cvo_slam {

/// Throws OptionError for a size, a number of columns or an image that cannot be drawn.
void check_size(const Figure& figure);

/// Lays the figure out and draws it. Throws as check_size() does.
void draw_figure(const Figure& figure, Canvas& canvas);

}  // namespace cvo_slam
