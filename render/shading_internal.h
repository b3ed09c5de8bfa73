// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/render/renderer.h"
#include "cvo_slam/render/view.h"

namespace cvo_slam::render {

/// Darkens pixels that lie behind their neighbours, so that edges and corners stand out whatever
/// their colours: C. Boucheny, "Visualisation scientifique de grands volumes de donnees", 2009,
/// eye-dome lighting. `radius` is the distance of the neighbours [px].
void shade_by_depth(const View& view, int radius, Raster& raster);

}  // namespace cvo_slam::render
