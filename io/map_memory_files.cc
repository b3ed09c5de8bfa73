// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/core/numbers.h"
#include "cvo_slam/io/camera_file.h"
#include "cvo_slam/io/map_memory_files_internal.h"
#include "cvo_slam/io/text_internal.h"

namespace cvo_slam {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTableHeader = "number,stamp,submap,points_bytes,features_bytes";

/// Largest size of one keyframe's points or features [bytes]: ten times what the largest options
/// give. A larger one is damage, not to be allocated.
constexpr std::size_t kMostBytes = 64U << 20U;
constexpr std::size_t kMostSubmaps = 1000000;

std::vector<std::string_view> parts_of(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

/// A line of keyframes.csv.
struct Row {
  KeyframeMemory keyframe;
  std::size_t points = 0;    // [bytes]
  std::size_t features = 0;  // [bytes]
};

Row parse_row(std::string_view line, const fs::path& file, long line_number) {
  constexpr std::size_t kColumns = 5;
  const auto words = parts_of(line, ',');
  const auto stamp = words.size() == kColumns ? Timestamp::parse(words[1]) : std::nullopt;
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i == 1) continue;
    if (const auto number = parse_integer<std::size_t>(words[i])) numbers.push_back(*number);
  }
  if (!stamp || numbers.size() != kColumns - 1 || numbers[1] > kMostSubmaps) {
    throw InputError(file, line_number, fmt::format("expected {}", kTableHeader));
  }
  Row row;
  row.keyframe.number = numbers[0];
  row.keyframe.stamp = *stamp;
  row.keyframe.submap = static_cast<int>(numbers[1]);
  row.points = numbers[2];
  row.features = numbers[3];
  return row;
}

std::string system_message() { return std::generic_category().message(errno); }

/// Exchanges two folders at once; where the file system cannot, one after the other.
void exchange(const fs::path& ours, const fs::path& folder) {
  if (renameat2(AT_FDCWD, ours.c_str(), AT_FDCWD, folder.c_str(), RENAME_EXCHANGE) == 0) return;
  const fs::path old = ours.string() + ".old";
  if (errno != EINVAL || std::rename(folder.c_str(), old.c_str()) != 0 ||
      std::rename(ours.c_str(), folder.c_str()) != 0 ||
      std::rename(old.c_str(), ours.c_str()) != 0) {
    throw OutputError(
        folder, fmt::format("cannot be replaced: {}; check its permissions", system_message()));
  }
}

fs::path folder_aside(const fs::path& folder, pid_t process) {
  return fmt::format("{}.{}.part", folder.string(), process);
}

/// Removes what processes that were killed while they wrote this map have left.
void remove_leftovers(const fs::path& folder) {
  std::error_code problem;
  const fs::path parent = folder.has_parent_path() ? folder.parent_path() : fs::path(".");
  for (const auto& entry : fs::directory_iterator(parent, problem)) {
    const std::string name = entry.path().filename().string();
    const std::string start = folder.filename().string() + ".";
    if (!name.starts_with(start)) continue;
    const std::string_view rest = std::string_view(name).substr(start.size());
    const auto process = parse_integer<pid_t>(rest.substr(0, rest.find('.')));
    if (!process || *process <= 0 || folder_aside(folder, *process).filename() != name) continue;
    const bool is_running = kill(*process, 0) == 0 || errno != ESRCH;
    if (!is_running) fs::remove_all(entry.path(), problem);
  }
}

/// Throws OutputError if a folder holds anything but a map.
void check_is_map(const fs::path& folder) {
  if (!fs::exists(folder) || (fs::is_directory(folder) && fs::is_empty(folder))) return;
  if (fs::is_directory(folder) && fs::exists(folder / kMapHeader)) return;
  throw OutputError(folder, "is there and is no map; choose another folder");
}

}  // namespace

void write_memory(const fs::path& folder, const MapMemory& memory) {
  write_camera(folder / kCameraFile, memory.camera);
  std::string table = fmt::format("{}\n", kTableHeader);
  std::string blob;
  for (const KeyframeMemory& keyframe : memory.keyframes) {
    table += fmt::format("{},{},{},{},{}\n", keyframe.number, keyframe.stamp.to_string(),
                         keyframe.submap, keyframe.points.size(), keyframe.features.size());
    blob += keyframe.points;
    blob += keyframe.features;
  }
  write_file(folder / kTableFile, table);
  write_file(folder / kBlobFile, blob);
  if (!memory.session.empty()) write_file(folder / kSessionFile, memory.session);
}

MapMemory read_memory(const fs::path& folder, const MapHeader& header) {
  MapMemory memory;
  memory.camera = read_camera(folder / kCameraFile);
  memory.vocabulary = header.vocabulary();
  std::tie(memory.cos_theta_sum, memory.cos_theta_count) = header.cos_theta();
  const fs::path table = folder / kTableFile;
  const std::string text = header.read_checked(folder, kTableFile);
  CheckedFile blob = header.open_checked(folder, kBlobFile);
  const auto take = [&](std::size_t size) {
    if (size > blob.left() || size > kMostBytes) {
      throw InputError(folder / kBlobFile,
                       "does not have the bytes that keyframes.csv says; make the map again");
    }
    return std::string(blob.take(size));
  };
  long line_number = 0;
  for (const std::string_view line : parts_of(text, '\n')) {
    ++line_number;
    if (line.empty() || line == kTableHeader) continue;
    Row row = parse_row(line, table, line_number);
    row.keyframe.points = take(row.points);
    row.keyframe.features = take(row.features);
    memory.keyframes.push_back(std::move(row.keyframe));
  }
  if (blob.left() > 0) throw InputError(folder / kBlobFile, "is longer than keyframes.csv says");
  blob.finish();
  if (header.has(kSessionFile)) memory.session = header.read_checked(folder, kSessionFile);
  return memory;
}

void replace_folder(const fs::path& folder, const std::function<void(const fs::path&)>& write) {
  const fs::path target = folder.has_filename() ? folder : folder.parent_path();
  check_is_map(target);
  remove_leftovers(target);
  const fs::path ours = folder_aside(target, getpid());
  std::error_code problem;
  fs::remove_all(ours, problem);
  make_folder(ours);
  try {
    write(ours);
    if (fs::exists(target)) {
      exchange(ours, target);
    } else if (std::rename(ours.c_str(), target.c_str()) != 0) {
      throw OutputError(
          target,
          fmt::format("cannot be made: {}; check the permissions of its folder", system_message()));
    }
  } catch (...) {
    fs::remove_all(ours, problem);
    throw;
  }
  fs::remove_all(ours, problem);
}

}  // namespace cvo_slam
