// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/render/map_scene.h"

namespace cvo_slam {

/// What a path is coloured by.
enum class PathColor { kTime, kError, kPlain };

/// Adds what a file or folder holds: the folder of a run (map and trajectory), a graph (.g2o),
/// points (.ply), or else a trajectory in TUM format. Throws InputError.
void add_to_scene(render::MapScene& scene, const std::filesystem::path& input);

/// Adds the true path, fitted to the scene's first one. Where its z, which motion capture has up,
/// is within 45 degrees of the scene's up it is taken for that. With kError the first path is
/// coloured by its distance from it. Throws DataError where the two have too few times in common.
void add_reference(render::MapScene& scene, const std::vector<StampedPose>& reference,
                   PathColor color);

}  // namespace cvo_slam
