// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/ply.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/io/ply_header_internal.h"
#include "cvo_slam/io/text_internal.h"

namespace cvo_slam {
namespace {

static_assert(std::endian::native == std::endian::little,
              "values are copied without swapping bytes");

/// Values of a vertex, indexed by PlyMeaning.
using VertexValues = std::array<double, kPlyMeanings>;

template <typename T>
double value_at(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return static_cast<double>(value);
}

double value_at(const char* bytes, PlyType type) {
  switch (type) {
    case PlyType::kInt8:
      return value_at<std::int8_t>(bytes);
    case PlyType::kUint8:
      return value_at<std::uint8_t>(bytes);
    case PlyType::kInt16:
      return value_at<std::int16_t>(bytes);
    case PlyType::kUint16:
      return value_at<std::uint16_t>(bytes);
    case PlyType::kInt32:
      return value_at<std::int32_t>(bytes);
    case PlyType::kUint32:
      return value_at<std::uint32_t>(bytes);
    case PlyType::kFloat:
      return value_at<float>(bytes);
    case PlyType::kDouble:
      return value_at<double>(bytes);
  }
  return 0;
}

double& at(VertexValues& values, PlyMeaning meaning) {
  return values[static_cast<std::size_t>(meaning)];
}

/// Converts the values of a vertex to a point, as the header describes them.
class PointMaker {
 public:
  explicit PointMaker(const PlyHeader& header)
      : has_normals_(header.has(PlyMeaning::kNx) && header.has(PlyMeaning::kNy) &&
                     header.has(PlyMeaning::kNz)),
        has_colors_(header.has(PlyMeaning::kRed) && header.has(PlyMeaning::kGreen) &&
                    header.has(PlyMeaning::kBlue)) {
    const auto is_real = [](const PlyProperty& property) {
      return property.meaning == PlyMeaning::kRed &&
             (property.type == PlyType::kFloat || property.type == PlyType::kDouble);
    };
    const bool real = std::any_of(header.properties.begin(), header.properties.end(), is_real);
    color_scale_ = real ? 255 : 1;
  }

  [[nodiscard]] MapPoint operator()(VertexValues& values) const {
    MapPoint point;
    point.position = vector(values, PlyMeaning::kX, PlyMeaning::kY, PlyMeaning::kZ);
    if (has_normals_) {
      point.normal = vector(values, PlyMeaning::kNx, PlyMeaning::kNy, PlyMeaning::kNz);
    }
    constexpr std::uint8_t kLightGrey = 190;
    point.color = {kLightGrey, kLightGrey, kLightGrey};
    if (has_colors_) {
      point.color = {level(at(values, PlyMeaning::kRed)), level(at(values, PlyMeaning::kGreen)),
                     level(at(values, PlyMeaning::kBlue))};
    }
    return point;
  }

 private:
  static Eigen::Vector3f vector(VertexValues& values, PlyMeaning x, PlyMeaning y, PlyMeaning z) {
    return {static_cast<float>(at(values, x)), static_cast<float>(at(values, y)),
            static_cast<float>(at(values, z))};
  }

  [[nodiscard]] std::uint8_t level(double value) const {
    const double scaled = std::isfinite(value) ? color_scale_ * value : 0;
    return static_cast<std::uint8_t>(std::lround(std::clamp(scaled, 0.0, 255.0)));
  }

  bool has_normals_;
  bool has_colors_;
  double color_scale_ = 1;
};

std::vector<MapPoint> read_binary(const std::filesystem::path& file, const PlyHeader& header,
                                  std::string_view text) {
  const std::size_t size = header.bytes_per_vertex();
  const std::size_t begin = header.size + header.bytes_before;
  // Division instead of multiplication: the number of vertices in a bad file may overflow.
  if (begin > text.size() || header.vertices > (text.size() - begin) / size) {
    throw InputError(file, fmt::format("ends at byte {}, but its header promises {} vertices of {} "
                                       "bytes from byte {}; the file is cut off",
                                       text.size(), header.vertices, size, begin));
  }
  const PointMaker make_point(header);
  std::vector<MapPoint> points;
  points.reserve(header.vertices);
  const char* bytes = text.data() + begin;
  VertexValues values{};
  for (std::size_t i = 0; i < header.vertices; ++i) {
    for (const PlyProperty& property : header.properties) {
      at(values, property.meaning) = value_at(bytes, property.type);
      bytes += size_of(property.type);
    }
    points.push_back(make_point(values));
  }
  return points;
}

/// Takes the lines behind the header one after the other.
class Lines {
 public:
  Lines(std::string_view text, long number) : text_(text), number_(number) {}

  [[nodiscard]] long number() const { return number_; }
  /// Returns false at the end of the file.
  bool next(std::string_view& line) {
    if (text_.empty()) return false;
    const std::size_t end = text_.find('\n');
    line = text_.substr(0, end);
    text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
    ++number_;
    return true;
  }

 private:
  std::string_view text_;
  long number_;
};

/// Accepts nan, which point clouds have where nothing was measured.
double parse_value(const std::filesystem::path& file, long line, const std::string& word) {
  if (word == "nan" || word == "-nan") return std::nan("");
  const auto value = parse_finite(word);
  if (!value) throw InputError(file, line, fmt::format("'{}' is not a number", word));
  return *value;
}

std::vector<MapPoint> read_ascii(const std::filesystem::path& file, const PlyHeader& header,
                                 std::string_view text) {
  const PointMaker make_point(header);
  Lines lines(text.substr(header.size), header.lines);
  std::vector<MapPoint> points;
  VertexValues values{};
  for (std::size_t i = 0; i < header.lines_before + header.vertices; ++i) {
    std::string_view line;
    if (!lines.next(line)) {
      throw InputError(file, lines.number(),
                       fmt::format("ends after {} of {} vertices; the file is cut off",
                                   points.size(), header.vertices));
    }
    if (i < header.lines_before) continue;
    const std::vector<std::string> words = split_words(std::string(line));
    if (words.size() != header.properties.size()) {
      throw InputError(file, lines.number(),
                       fmt::format("a vertex of {} values, the header promises {}", words.size(),
                                   header.properties.size()));
    }
    for (std::size_t k = 0; k < words.size(); ++k) {
      at(values, header.properties[k].meaning) = parse_value(file, lines.number(), words[k]);
    }
    points.push_back(make_point(values));
  }
  return points;
}

void append(std::string& bytes, const Eigen::Vector3f& vector) {
  bytes.append(reinterpret_cast<const char*>(vector.data()), 3 * sizeof(float));
}

}  // namespace

std::vector<MapPoint> read_ply(const std::filesystem::path& file) {
  const std::string text = read_file(file);
  const PlyHeader header = parse_ply_header(file, text);
  return header.is_binary ? read_binary(file, header, text) : read_ascii(file, header, text);
}

void write_ply(const std::filesystem::path& file, std::span<const MapPoint> points) {
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment cvo_slam map, metres\nelement vertex {}\n"
      "property float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n",
      points.size());
  constexpr std::size_t kBytesPerPoint = 27;
  bytes.reserve(bytes.size() + kBytesPerPoint * points.size());
  for (const MapPoint& point : points) {
    append(bytes, point.position);
    append(bytes, point.normal);
    bytes.append(reinterpret_cast<const char*>(point.color.data()), point.color.size());
  }
  write_file(file, bytes);
}

}  // namespace cvo_slam
