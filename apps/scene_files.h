// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cvo_slam/core/trajectory.h"
#include "cvo_slam/render/map_scene.h"

namespace cvo_slam {

/// The quantity that colours a path.
enum class PathColor { kTime, kError, kPlain };

/// Adds the content of a file or folder: the folder of a run (map and trajectory), points (PLY), a
/// graph (g2o), or a trajectory in TUM format. Files are told apart by .ply and .g2o, in upper or
/// lower case, or else by how they begin. A scene that is far from zero gets an origin near by.
/// Adds what was not understood to `notes`. Throws InputError.
void add_to_scene(render::MapScene& scene, const std::filesystem::path& input,
                  std::vector<std::string>& notes);

/// Adds the true path, fitted to the first path of the scene. Its z axis points up in motion
/// capture; it becomes the up direction of the scene if the two differ by less than 45 degrees.
/// With kError the first path is coloured by its distance from the true one. Throws DataError if
/// the two have too few times in common.
void add_reference(render::MapScene& scene, const std::vector<StampedPose>& reference,
                   PathColor color);

}  // namespace cvo_slam
