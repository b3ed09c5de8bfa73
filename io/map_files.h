// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "cvo_slam/core/map.h"

namespace cvo_slam {

/// Writes a map into a folder, which is made where it is missing:
///
///   keyframes.txt  poses, TUM format
///   graph.g2o      the pose graph; edges.txt what its edges are, "from to kind" a line, because
///                  g2o has no word for it. Where the map has a graph
///   map.ply        points; where the map has any
///
/// Throws OutputError, and DataError where a graph has not one node a keyframe.
void write_map(const std::filesystem::path& folder, const Map& map);

/// Reads a map from a folder that write_map() or `cvo_slam run` wrote; each of the files may be
/// missing, but not all. Throws InputError.
[[nodiscard]] Map read_map(const std::filesystem::path& folder);

}  // namespace cvo_slam
