// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The header of a map's folder, and files that are read and checked by it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>

#include "cvo_slam/core/map.h"
#include "cvo_slam/io/yaml_value.h"

namespace cvo_slam {

///@{
/// The files of a map with memory. The header makes a folder one, and names all others.
inline constexpr const char* kMapHeader = "map.yaml";
inline constexpr const char* kCameraFile = "camera.yaml";
inline constexpr const char* kTableFile = "keyframes.csv";
inline constexpr const char* kBlobFile = "keyframes.bin";
inline constexpr const char* kGraphFile = "graph.g2o";
inline constexpr const char* kEdgesFile = "edges.txt";
inline constexpr const char* kSurfaceFile = "surface.bin";
inline constexpr const char* kSessionFile = "session.bin";
///@}

/// A file that is read in pieces, and its checksum on the way, so that a large one need not be in
/// memory as a whole.
class CheckedFile {
 public:
  /// Throws InputError unless the file has this size.
  CheckedFile(std::filesystem::path file, std::uintmax_t size, std::uint32_t checksum);

  /// Number of bytes that were not taken yet.
  [[nodiscard]] std::uintmax_t left() const { return left_; }
  /// The next bytes, at most left(); valid until the next call. Throws InputError.
  [[nodiscard]] std::string_view take(std::size_t size);
  /// Throws InputError unless all bytes were taken and their checksum is as expected.
  void finish() const;

  [[nodiscard]] const std::filesystem::path& path() const { return file_; }

 private:
  std::filesystem::path file_;
  std::ifstream stream_;
  std::string piece_;
  std::uintmax_t left_ = 0;
  std::uint32_t expected_ = 0;
  std::uint32_t checksum_ = 0;
};

/// What map.yaml says.
class MapHeader {
 public:
  /// Throws InputError if it cannot be read, is of another version, or does not name the files that
  /// a map has.
  explicit MapHeader(const std::filesystem::path& folder);

  [[nodiscard]] std::uint32_t vocabulary() const;
  /// Sum and number of MapMemory.
  [[nodiscard]] std::pair<double, std::size_t> cos_theta() const;
  /// True if it names a file.
  [[nodiscard]] bool has(std::string_view name) const;
  /// The bytes of a file that it names. Throws InputError unless they are as it says.
  [[nodiscard]] std::string read_checked(const std::filesystem::path& folder,
                                         const std::string& name) const;
  /// A file that it names, to be read in pieces.
  [[nodiscard]] CheckedFile open_checked(const std::filesystem::path& folder,
                                         const std::string& name) const;
  /// Throws InputError unless every file but the large ones, which are checked while they are read,
  /// is as it says.
  void check_small_files(const std::filesystem::path& folder) const;

 private:
  [[nodiscard]] const YamlValue& files() const;

  YamlValue root_;
};

/// Writes the header of a folder, with the size and the checksum of every file in it.
void write_map_header(const std::filesystem::path& folder, const MapMemory& memory);

}  // namespace cvo_slam
