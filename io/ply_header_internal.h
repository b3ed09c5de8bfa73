// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cvo_slam {

enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

[[nodiscard]] std::size_t size_of(PlyType type);

/// What a property of a vertex means; kOther is ignored.
enum class PlyMeaning { kX, kY, kZ, kNx, kNy, kNz, kRed, kGreen, kBlue, kOther };
inline constexpr std::size_t kPlyMeanings = 10;

struct PlyProperty {
  PlyType type = PlyType::kFloat;
  PlyMeaning meaning = PlyMeaning::kOther;
  std::string name;
};

/// The header of a PLY file, which stands above its values.
struct PlyHeader {
  bool is_binary = false;
  std::size_t vertices = 0;
  std::vector<PlyProperty> properties;  ///< properties of a vertex, in order
  /// Numbers of ASCII lines and of binary bytes between header and vertices; the largest number
  /// there is if the sum would be larger.
  std::size_t lines_before = 0;
  std::size_t bytes_before = 0;
  std::size_t size = 0;  ///< size of the header [bytes]
  long lines = 0;        ///< number of lines of the header

  [[nodiscard]] std::size_t bytes_per_vertex() const;
  [[nodiscard]] bool has(PlyMeaning meaning) const;
};

/// Parses the header of `text`, the content of `file`. Names of properties may be in upper case.
/// The numbers of elements are those of the header, however short the file is. Throws InputError
/// with the line.
[[nodiscard]] PlyHeader parse_ply_header(const std::filesystem::path& file, std::string_view text);

}  // namespace cvo_slam
