// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "cvo_slam/core/map.h"

namespace cvo_slam {

/// The vertices of a PLY file.
struct PlyCloud {
  std::vector<MapPoint> points;  ///< in the order of the file
  /// Added to the points' positions [m]: origin_near() of the middle of the cloud.
  Vector3 origin = Vector3::Zero();
  std::vector<std::string> notes;  ///< what of the file was not understood, a line each
};

/// Reads the vertices of a PLY file, binary little-endian or ASCII: x, y, z and, if present, nx,
/// ny, nz and red, green, blue. Other properties, and faces and other elements behind the vertices,
/// are ignored. Positions that are not finite are kept; a normal that is not finite is none.
///
/// The range of the colours is taken from their values, whatever their type is: full brightness is
/// 1 (floats and fractions), 255 or 65535; chars are bytes. Points without colours are light grey,
/// and a note says so where the file has properties that may have been meant as colours.
///
/// Throws InputError: with the line for a bad header or a bad line of an ASCII file, with the byte
/// for a binary file that ends too early.
[[nodiscard]] PlyCloud read_ply(const std::filesystem::path& file);

/// Writes points as binary little-endian PLY: position and normal as floats, colour as bytes.
/// Positions are written as doubles if the origin, which is added to them, is not zero. read_ply()
/// returns the same points. Throws OutputError.
void write_ply(const std::filesystem::path& file, std::span<const MapPoint> points,
               const Vector3& origin = Vector3::Zero());

}  // namespace cvo_slam
