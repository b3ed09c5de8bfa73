// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "cvo_slam/core/map.h"
#include "cvo_slam/io/map_header_internal.h"

namespace cvo_slam {

/// Writes the surface of a map (Map::points and their origin) in about 8 bytes a point: positions
/// are rounded to 1/1024 m, colours to 5, 6 and 5 bits, normals to half a degree. Throws
/// OutputError.
void write_surface(const std::filesystem::path& file, const Map& map);
/// Reads what write_surface() wrote. Throws InputError.
void read_surface(CheckedFile& file, Map& map);

}  // namespace cvo_slam
