// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "cvo_slam/core/map.h"

namespace cvo_slam {

/// Reads the vertices of a PLY file, binary little-endian or ASCII: x, y, z and, if present, nx,
/// ny, nz and red, green, blue (uchar, or float from 0 to 1). A file without colours gives light
/// grey points. Other properties, and faces and other elements behind the vertices, are ignored.
/// Values that are not finite are kept. Throws InputError: with the line for a bad header or a bad
/// line of an ASCII file, with the byte for a binary file that ends too early.
[[nodiscard]] std::vector<MapPoint> read_ply(const std::filesystem::path& file);

/// Writes points as binary little-endian PLY: position and normal as floats, colour as bytes.
/// read_ply() returns the same points. Throws OutputError.
void write_ply(const std::filesystem::path& file, std::span<const MapPoint> points);

}  // namespace cvo_slam
