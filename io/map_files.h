// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cvo_slam/core/map.h"

namespace cvo_slam {

/// Writes a map into a folder, which is made if it is missing:
///
///     keyframes.txt  poses of the keyframes in TUM format, unless only the graph knows them
///     graph.g2o      the pose graph, if the map has one
///     edges.txt      kinds of the graph's edges, which g2o cannot store: lines "from to kind"
///     map.ply        points, if the map has any
///
/// A map with memory (Map::memory) has a folder of its own, docs/reference/map-folder.md, which is
/// written beside and takes the place of an earlier map's at once: whatever happens, there is the
/// old map or the new one. Throws OutputError, also if the folder holds anything but a map, and
/// DataError if the graph does not have one node per keyframe.
void write_map(const std::filesystem::path& folder, const Map& map);

/// Returns true for the folder of a map with memory.
[[nodiscard]] bool is_map_folder(const std::filesystem::path& folder);

/// Reads a map from a folder that write_map() or `cvo_slam run` wrote. Of a map without memory,
/// each of the files may be missing, but not all of them; of one with memory, every file must be
/// there with its checksum. Adds the notes of read_g2o() and read_ply() to `notes`. Throws
/// InputError.
[[nodiscard]] Map read_map(const std::filesystem::path& folder, std::vector<std::string>& notes);

/// Reads a map like read_map() above for a caller without a place for notes: entries of graph.g2o
/// that would be skipped with a note are refused.
[[nodiscard]] Map read_map(const std::filesystem::path& folder);

}  // namespace cvo_slam
