// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cvo_slam/render/extent_internal.h"
#include "cvo_slam/render/primitives.h"
#include "cvo_slam/render/view.h"

namespace cvo_slam::render {

/// Diameter that points need to close a surface, by how many there are on how much of it [m].
[[nodiscard]] double estimate_point_size(const Scene& scene, const Extent& extent);

/// The scene's points as the view sees them, lit from the eye. Surfaces that turn their back to the
/// eye are left out: so one looks into a room through its ceiling.
void add_surface(const Scene& scene, const Extent& extent, const View& view,
                 std::vector<Splat>& splats);

}  // namespace cvo_slam::render
