// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/core/point_cloud.h"
#include "cvo_slam/io/surface_file_internal.h"

namespace cvo_slam {
namespace {

constexpr float kSteps = 1024;        // a metre
constexpr float kFarthest = 0x1p30F;  // [steps]
constexpr float kNormalSteps = 127;   // from the middle of the octahedron to its rim
constexpr std::int8_t kNoNormal = -128;
/// Points that are read together: as many as stay in the fastest memory.
constexpr std::size_t kChunk = 4096;
/// A point has three numbers of one to five bytes, two bytes of colour and two of the normal.
constexpr std::size_t kFewestBytes = 7;

/// Little-endian, like all that follows it.
struct SurfaceHeader {
  std::array<double, 3> origin = {};  // [m]
  std::uint64_t points = 0;
};

using Steps = std::array<std::int32_t, 3>;

template <typename Value>
void append_raw(const Value& value, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

template <typename Value>
Value value_of(std::string_view bytes) {
  Value value;
  std::memcpy(&value, bytes.data(), sizeof(value));
  return value;
}

/// Appends a whole number in bytes of seven bits, the lowest first; the eighth says that there are
/// more. The sign is the lowest bit, so that small numbers are short.
void append_number(std::int32_t value, std::string& bytes) {
  auto rest = static_cast<std::uint32_t>(value) << 1U ^ static_cast<std::uint32_t>(value >> 31);
  while (rest >= 128) {
    bytes += static_cast<char>(rest | 128U);
    rest >>= 7U;
  }
  bytes += static_cast<char>(rest);
}

/// Takes what was appended to a chunk of the file.
class ChunkReader {
 public:
  ChunkReader(std::string_view bytes, const std::filesystem::path& file)
      : bytes_(bytes), file_(file) {}

  std::uint8_t byte() {
    if (next_ == bytes_.size()) throw InputError(file_, "is damaged; make the map again");
    return static_cast<std::uint8_t>(bytes_[next_++]);
  }

  std::int32_t number() {
    std::uint32_t value = 0;
    for (unsigned shift = 0; shift < 32; shift += 7) {
      const std::uint32_t part = byte();
      value |= (part & 127U) << shift;
      if (part < 128) return static_cast<std::int32_t>(value >> 1U ^ (0U - (value & 1U)));
    }
    throw InputError(file_, "is damaged; make the map again");
  }

  [[nodiscard]] bool is_empty() const { return next_ == bytes_.size(); }

 private:
  std::string_view bytes_;
  std::size_t next_ = 0;
  const std::filesystem::path& file_;
};

Steps steps_of(const Eigen::Vector3f& position) {
  Steps steps = {};
  for (int axis = 0; axis < 3; ++axis) {
    const float value = std::round(kSteps * position[axis]);
    if (std::isfinite(value)) {
      steps[static_cast<std::size_t>(axis)] =
          static_cast<std::int32_t>(std::clamp(value, -kFarthest, kFarthest));
    }
  }
  return steps;
}

/// `last` is the point before, of which the position is told relative.
void append_point(const MapPoint& point, Steps& last, std::string& bytes) {
  const Steps steps = steps_of(point.position);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    append_number(static_cast<std::int32_t>(static_cast<std::uint32_t>(steps[axis]) -
                                            static_cast<std::uint32_t>(last[axis])),
                  bytes);
  }
  last = steps;
  const auto& [red, green, blue] = point.color;
  const auto upper = [](unsigned value, unsigned bits) { return value >> (8 - bits); };
  const unsigned color = upper(red, 5) << 11U | upper(green, 6) << 5U | upper(blue, 5);
  append_raw(static_cast<std::uint16_t>(color), bytes);
  std::array<std::int8_t, 2> normal = {kNoNormal, kNoNormal};
  if (!point.normal.isZero()) {
    const Eigen::Vector2f place = kNormalSteps * to_octahedron(point.normal);
    normal = {static_cast<std::int8_t>(std::lround(place.x())),
              static_cast<std::int8_t>(std::lround(place.y()))};
  }
  append_raw(normal, bytes);
}

MapPoint take_point(ChunkReader& reader, Steps& last) {
  MapPoint point;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // Damaged bytes may lead anywhere.
    last[axis] = static_cast<std::int32_t>(static_cast<std::uint32_t>(last[axis]) +
                                           static_cast<std::uint32_t>(reader.number()));
    point.position[static_cast<int>(axis)] = static_cast<float>(last[axis]) / kSteps;
  }
  const unsigned low = reader.byte();
  const unsigned color = low | static_cast<unsigned>(reader.byte()) << 8U;
  // The upper bits are repeated below, so that white stays white.
  const auto widened = [](unsigned value, unsigned bits) {
    return static_cast<std::uint8_t>(value << (8 - bits) | value >> (2 * bits - 8));
  };
  point.color = {widened(color >> 11U, 5), widened(color >> 5U & 63U, 6), widened(color & 31U, 5)};
  const auto a = static_cast<std::int8_t>(reader.byte());
  const auto b = static_cast<std::int8_t>(reader.byte());
  if (a != kNoNormal) point.normal = from_octahedron(Eigen::Vector2f(a, b) / kNormalSteps);
  return point;
}

}  // namespace

void write_surface(const std::filesystem::path& file, const Map& map) {
  SurfaceHeader header;
  header.points = map.points.size();
  std::copy_n(map.points_origin.data(), 3, header.origin.begin());
  std::string bytes;
  append_raw(header, bytes);
  for (std::size_t begin = 0; begin < map.points.size(); begin += kChunk) {
    std::string chunk;
    Steps last = {};
    for (std::size_t i = begin; i < std::min(begin + kChunk, map.points.size()); ++i) {
      append_point(map.points[i], last, chunk);
    }
    append_raw(static_cast<std::uint32_t>(chunk.size()), bytes);
    bytes += chunk;
  }
  write_file(file, bytes);
}

void read_surface(CheckedFile& file, Map& map) {
  const auto fail_if = [&](bool is_damaged) {
    if (is_damaged) throw InputError(file.path(), "is damaged; make the map again");
  };
  fail_if(file.left() < sizeof(SurfaceHeader));
  const auto header = value_of<SurfaceHeader>(file.take(sizeof(SurfaceHeader)));
  fail_if(header.points > file.left() / kFewestBytes);  // not to be allocated
  std::copy_n(header.origin.begin(), 3, map.points_origin.data());
  map.points.reserve(header.points);
  while (map.points.size() < header.points) {
    fail_if(file.left() < sizeof(std::uint32_t));
    const auto size = value_of<std::uint32_t>(file.take(sizeof(std::uint32_t)));
    fail_if(file.left() < size);
    ChunkReader reader(file.take(size), file.path());
    Steps last = {};
    const std::size_t end = std::min<std::size_t>(map.points.size() + kChunk, header.points);
    while (map.points.size() < end) map.points.push_back(take_point(reader, last));
    fail_if(!reader.is_empty());
  }
  file.finish();
}

}  // namespace cvo_slam
