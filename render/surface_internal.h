// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "cvo_slam/render/extent_internal.h"
#include "cvo_slam/render/map_view.h"
#include "cvo_slam/render/renderer.h"

namespace cvo_slam::render {

/// Adds the points of the scene as splats, lit from the eye. Points whose normal points away from
/// the eye are left out, so that a view from above looks into a room through its ceiling.
void add_surface(const MapScene& scene, const Extent& extent, const MapView& view,
                 std::vector<Splat>& splats);

}  // namespace cvo_slam::render
