// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <charconv>
#include <set>
#include <system_error>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/io/map_header_internal.h"

namespace cvo_slam {
namespace {

namespace fs = std::filesystem;

constexpr int kFormat = 3;

std::string hexadecimal(std::uint32_t number) { return fmt::format("{:08x}", number); }

std::uint32_t hexadecimal_of(const YamlValue& value, const std::string& what) {
  const std::string& text = value.word(what);
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, 16);
  if (error != std::errc() || end != text.data() + text.size()) {
    value.fail(what + ": expected eight hexadecimal digits");
  }
  return number;
}

[[noreturn]] void fail_as_another(const fs::path& file) {
  throw InputError(file, fmt::format("is not the file that {} describes: damaged, or of another "
                                     "map; make the map again",
                                     kMapHeader));
}

}  // namespace

CheckedFile::CheckedFile(fs::path file, std::uintmax_t size, std::uint32_t checksum)
    : file_(std::move(file)), stream_(file_, std::ios::binary), left_(size), expected_(checksum) {
  std::error_code problem;
  const std::uintmax_t there = fs::file_size(file_, problem);
  if (!stream_ || problem) {
    throw InputError(file_, "cannot be opened: check the path and its permissions");
  }
  if (there != size) fail_as_another(file_);
}

std::string_view CheckedFile::take(std::size_t size) {
  if (piece_.size() < size) piece_.resize(size);
  stream_.read(piece_.data(), static_cast<std::streamsize>(size));
  if (!stream_) throw InputError(file_, "cannot be read to its end; check the disk");
  left_ -= size;
  const std::string_view piece = std::string_view(piece_).substr(0, size);
  checksum_ = crc32_of(piece, checksum_);
  return piece;
}

void CheckedFile::finish() const {
  if (left_ > 0 || checksum_ != expected_) fail_as_another(file_);
}

MapHeader::MapHeader(const fs::path& folder) : root_(YamlValue::read(folder / kMapHeader)) {
  const YamlValue& format = root_.require("format", "the version of the map");
  if (format.number("format") != kFormat) {
    format.fail(fmt::format("the map has format {}, and this program reads {}; make it again",
                            format.word("format"), kFormat));
  }
  for (const char* name : {kCameraFile, kTableFile, kBlobFile, kGraphFile, kEdgesFile}) {
    static_cast<void>(files().require(name, "a file of the map"));
  }
}

const YamlValue& MapHeader::files() const { return root_.require("files", "the files of the map"); }

std::uint32_t MapHeader::vocabulary() const {
  return hexadecimal_of(root_.require("vocabulary", "the vocabulary"), "vocabulary");
}

std::pair<double, std::size_t> MapHeader::cos_theta() const {
  const auto numbers = root_.require("cos_theta", "cos_theta").numbers("cos_theta", 2);
  constexpr double kMost = 1e15;
  return {numbers[0], static_cast<std::size_t>(std::clamp(numbers[1], 0.0, kMost))};
}

bool MapHeader::has(std::string_view name) const {
  const auto& entries = files().map("files");
  return std::any_of(entries.begin(), entries.end(),
                     [&](const auto& entry) { return entry.first == name; });
}

CheckedFile MapHeader::open_checked(const fs::path& folder, const std::string& name) const {
  const YamlValue& entry = files().require(name, "a file of the map");
  const auto& values = entry.list(name);
  if (values.size() != 2) entry.fail(name + ": expected its size and its checksum");
  const double size = values[0].number(name);
  constexpr double kLargest = 1e15;
  if (!(size >= 0 && size <= kLargest)) entry.fail(name + ": has no possible size");
  return {folder / name, static_cast<std::uintmax_t>(size), hexadecimal_of(values[1], name)};
}

std::string MapHeader::read_checked(const fs::path& folder, const std::string& name) const {
  CheckedFile file = open_checked(folder, name);
  std::string bytes(file.take(file.left()));
  file.finish();
  return bytes;
}

void MapHeader::check_small_files(const fs::path& folder) const {
  for (const auto& [name, entry] : files().map("files")) {
    if (name.find('/') != std::string::npos) entry.fail(name + ": is no file of the map's folder");
    if (name == kBlobFile || name == kSurfaceFile || name == kTableFile || name == kSessionFile)
      continue;
    static_cast<void>(read_checked(folder, name));
  }
}

void write_map_header(const fs::path& folder, const MapMemory& memory) {
  std::string text = fmt::format(
      "# A map of cvo_slam: docs/reference/map-folder.md.\nformat: {}\nvocabulary: {}\n"
      "cos_theta: [{}, {}]  # sum and number over consecutive keyframes\n"
      "files:  # size and CRC-32\n",
      kFormat, to_yaml_word(hexadecimal(memory.vocabulary)), memory.cos_theta_sum,
      memory.cos_theta_count);
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename());
  for (const std::string& name : names) {
    const std::string bytes = read_file(folder / name);
    text += fmt::format("  {}: [{}, {}]\n", name, bytes.size(),
                        to_yaml_word(hexadecimal(crc32_of(bytes))));
  }
  write_file(folder / kMapHeader, text);
}

}  // namespace cvo_slam
