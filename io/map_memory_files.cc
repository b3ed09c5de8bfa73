// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <new>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <zlib.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/core/numbers.h"
#include "cvo_slam/io/camera_file.h"
#include "cvo_slam/io/map_memory_files_internal.h"
#include "cvo_slam/io/text_internal.h"
#include "cvo_slam/io/yaml_value.h"

namespace cvo_slam {
namespace {

namespace fs = std::filesystem;

constexpr int kFormat = 2;
constexpr const char* kCameraFile = "camera.yaml";
constexpr const char* kTableFile = "keyframes.csv";
constexpr const char* kBlobFile = "keyframes.bin";
constexpr const char* kTableHeader =
    "number,stamp,submap,points_bytes,points_packed,features_bytes,features_packed";

/// Largest size of one keyframe's points or features [bytes]: ten times what the largest options
/// give. A larger one is damage, not to be allocated.
constexpr std::size_t kMostBytes = 64U << 20U;
constexpr std::size_t kMostSubmaps = 1000000;

/// Bytes are packed in blocks, each behind its size as it is packed (uint16, little-endian). A
/// block that zlib would make less than an eighth smaller stands as it is, and says 0: unpacking
/// would cost time for nothing.
constexpr std::size_t kBlock = 8192;

void append_size(std::string& text, std::size_t size) {
  text += static_cast<char>(size & 0xFFU);
  text += static_cast<char>(size >> 8U);
}

std::string packed(std::string_view bytes) {
  std::string result;
  std::string buffer(compressBound(kBlock), '\0');
  for (; !bytes.empty(); bytes.remove_prefix(std::min(kBlock, bytes.size()))) {
    const std::string_view block = bytes.substr(0, kBlock);
    uLongf size = buffer.size();
    // It can only fail for lack of memory, or a buffer that is too small.
    if (compress(reinterpret_cast<Bytef*>(buffer.data()), &size,
                 reinterpret_cast<const Bytef*>(block.data()), block.size()) != Z_OK) {
      throw std::bad_alloc();
    }
    const bool is_worth_it = 8 * size < 7 * block.size();
    append_size(result, is_worth_it ? size : 0);
    result += is_worth_it ? std::string_view(buffer).substr(0, size) : block;
  }
  return result;
}

/// Takes a block from the front of `bytes` and writes what it was to `target`. Returns false if
/// that has not `size` bytes.
bool unpack_block(std::string_view& bytes, char* target, std::size_t size) {
  if (bytes.size() < 2) return false;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  const std::size_t packed_size = byte(0) | static_cast<std::size_t>(byte(1)) << 8U;
  bytes.remove_prefix(2);
  const std::size_t taken = packed_size == 0 ? size : packed_size;
  if (bytes.size() < taken) return false;
  uLongf length = size;
  if (packed_size == 0) {
    std::copy_n(bytes.data(), size, target);
  } else if (uncompress(reinterpret_cast<Bytef*>(target), &length,
                        reinterpret_cast<const Bytef*>(bytes.data()), packed_size) != Z_OK) {
    return false;
  }
  bytes.remove_prefix(taken);
  return length == size;
}

std::string unpacked(std::string_view bytes, std::size_t size, const fs::path& file) {
  std::string result(size, '\0');
  for (std::size_t begin = 0; begin < size; begin += kBlock) {
    if (!unpack_block(bytes, &result[begin], std::min(kBlock, size - begin))) {
      throw InputError(file, "is damaged; make the map again");
    }
  }
  if (!bytes.empty()) throw InputError(file, "is damaged; make the map again");
  return result;
}

/// A piece of the file of all keyframes' bytes.
struct Piece {
  std::size_t bytes = 0;
  std::size_t packed = 0;
};

/// Takes pieces one after the other.
class BlobReader {
 public:
  BlobReader(std::string_view blob, fs::path file) : blob_(blob), file_(std::move(file)) {}

  std::string take(const Piece& piece) {
    if (piece.packed > blob_.size() || piece.bytes > kMostBytes) {
      throw InputError(file_,
                       "does not have the bytes that keyframes.csv says; make the map again");
    }
    const std::string_view part = blob_.substr(0, piece.packed);
    blob_.remove_prefix(piece.packed);
    return unpacked(part, piece.bytes, file_);
  }
  [[nodiscard]] bool is_empty() const { return blob_.empty(); }

 private:
  std::string_view blob_;
  fs::path file_;
};

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

/// Throws InputError unless a file is as its entry in the header says.
void check_file(const YamlValue& entry, const std::string& name, const fs::path& file,
                std::string_view bytes) {
  const auto& values = entry.list(name);
  if (values.size() != 2) entry.fail(name + ": expected its size and its checksum");
  if (static_cast<double>(bytes.size()) == values[0].number(name) &&
      crc32_of(bytes) == hexadecimal_of(values[1], name)) {
    return;
  }
  throw InputError(file, fmt::format("is not the file that {} describes: damaged, or of another "
                                     "map; make the map again",
                                     kMapHeader));
}

/// Returns the bytes of a file of a map, which are as its header says. Throws InputError.
std::string read_checked(const fs::path& folder, const std::string& name, const YamlValue& header) {
  std::string bytes = read_file(folder / name);
  const YamlValue& files = header.require("files", "the files of the map");
  check_file(files.require(name, "a file of the map"), name, folder / name, bytes);
  return bytes;
}

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
  Piece points;
  Piece features;
};

Row parse_row(std::string_view line, const fs::path& file, long line_number) {
  constexpr std::size_t kColumns = 7;
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
  row.points = {numbers[2], numbers[3]};
  row.features = {numbers[4], numbers[5]};
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
    const std::string points = packed(keyframe.points);
    const std::string features = packed(keyframe.features);
    table += fmt::format("{},{},{},{},{},{},{}\n", keyframe.number, keyframe.stamp.to_string(),
                         keyframe.submap, keyframe.points.size(), points.size(),
                         keyframe.features.size(), features.size());
    blob += points;
    blob += features;
  }
  write_file(folder / kTableFile, table);
  write_file(folder / kBlobFile, blob);
}

MapMemory read_memory(const fs::path& folder) {
  const YamlValue root = YamlValue::read(folder / kMapHeader);
  MapMemory memory;
  memory.camera = read_camera(folder / kCameraFile);
  memory.vocabulary = hexadecimal_of(root.require("vocabulary", "the vocabulary"), "vocabulary");
  const auto cos_theta = root.require("cos_theta", "cos_theta").numbers("cos_theta", 2);
  memory.cos_theta_sum = cos_theta[0];
  memory.cos_theta_count = static_cast<std::size_t>(std::max(0.0, cos_theta[1]));
  const fs::path table = folder / kTableFile;
  const std::string text = read_checked(folder, kTableFile, root);
  const std::string bytes = read_checked(folder, kBlobFile, root);
  BlobReader blob(bytes, folder / kBlobFile);
  long line_number = 0;
  for (const std::string_view line : parts_of(text, '\n')) {
    ++line_number;
    if (line.empty() || line == kTableHeader) continue;
    Row row = parse_row(line, table, line_number);
    row.keyframe.points = blob.take(row.points);
    row.keyframe.features = blob.take(row.features);
    memory.keyframes.push_back(std::move(row.keyframe));
  }
  if (!blob.is_empty()) throw InputError(folder / kBlobFile, "is longer than keyframes.csv says");
  return memory;
}

void write_header(const fs::path& folder, const MapMemory& memory) {
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

void check_header(const fs::path& folder) {
  const YamlValue root = YamlValue::read(folder / kMapHeader);
  const YamlValue& format = root.require("format", "the version of the map");
  if (format.number("format") != kFormat) {
    format.fail(fmt::format("the map has format {}, and this program reads {}; make it again",
                            format.word("format"), kFormat));
  }
  const YamlValue& files = root.require("files", "the files of the map");
  for (const char* name : {kCameraFile, kTableFile, kBlobFile, "graph.g2o", "edges.txt"}) {
    static_cast<void>(files.require(name, "a file of the map"));
  }
  for (const auto& [name, entry] : files.map("files")) {
    if (name.find('/') != std::string::npos) entry.fail(name + ": is no file of the map's folder");
    if (name == kTableFile || name == kBlobFile) continue;  // read_memory() reads them
    check_file(entry, name, folder / name, read_file(folder / name));
  }
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
