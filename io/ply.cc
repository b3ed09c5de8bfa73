// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/ply.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cvo_slam/core/files.h"
#include "cvo_slam/io/ply_header_internal.h"
#include "cvo_slam/io/ply_vertices_internal.h"

namespace cvo_slam {
namespace {

using Rgb = std::array<std::uint8_t, 3>;
constexpr Rgb kLightGrey = {190, 190, 190};
constexpr double kByteLevels = 255;
constexpr double kWordLevels = 65535;

Vector3 position_of(const PlyVertex& vertex) {
  return {vertex[PlyMeaning::kX], vertex[PlyMeaning::kY], vertex[PlyMeaning::kZ]};
}

Vector3 color_of(const PlyVertex& vertex) {
  return {vertex[PlyMeaning::kRed], vertex[PlyMeaning::kGreen], vertex[PlyMeaning::kBlue]};
}

/// Returns how many of three properties there are.
int count_of(const PlyHeader& header, const std::array<PlyMeaning, 3>& meanings) {
  return static_cast<int>(
      std::count_if(meanings.begin(), meanings.end(), [&](PlyMeaning m) { return header.has(m); }));
}

constexpr std::array kColors = {PlyMeaning::kRed, PlyMeaning::kGreen, PlyMeaning::kBlue};
constexpr std::array kNormals = {PlyMeaning::kNx, PlyMeaning::kNy, PlyMeaning::kNz};

/// What the values of all vertices say of how they are to be read.
struct Survey {
  std::vector<Vector3> places;  ///< finite positions, at most a few thousand
  double largest_level = 0;     ///< of the finite colours, if there are any
  double smallest_level = 0;
  bool has_fractions = false;  ///< true if a level is no whole number, whatever its type is
  std::size_t bad_colors = 0;  ///< points whose colours are not finite
};

Survey survey(const std::filesystem::path& file, const PlyHeader& header, std::string_view text) {
  constexpr std::size_t kEnough = 4096;
  const std::size_t step = 1 + header.vertices / kEnough;
  Survey result;
  std::size_t i = 0;
  for_each_vertex(file, header, text, [&](const PlyVertex& vertex) {
    const Vector3 place = position_of(vertex);
    if (i++ % step == 0 && place.allFinite()) result.places.push_back(place);
    const Vector3 color = color_of(vertex);
    if (!color.allFinite()) {
      ++result.bad_colors;
      return;
    }
    result.largest_level = std::max(result.largest_level, color.maxCoeff());
    result.smallest_level = std::min(result.smallest_level, color.minCoeff());
    result.has_fractions = result.has_fractions || color != color.array().floor().matrix();
  });
  return result;
}

/// Returns the median of the positions, coordinate by coordinate: few stray points do not move it.
Vector3 middle_of(std::vector<Vector3> places) {
  if (places.empty()) return Vector3::Zero();
  Vector3 middle;
  const auto half = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
  for (int axis = 0; axis < 3; ++axis) {
    std::nth_element(places.begin(), half, places.end(),
                     [&](const Vector3& a, const Vector3& b) { return a[axis] < b[axis]; });
    middle[axis] = (*half)[axis];
  }
  return middle;
}

/// Returns true if a colour is of a type that can have fractions.
bool has_real_colors(const PlyHeader& header) {
  return std::any_of(header.properties.begin(), header.properties.end(), [&](const auto& property) {
    const bool is_real = property.type == PlyType::kFloat || property.type == PlyType::kDouble;
    return is_real && std::find(kColors.begin(), kColors.end(), property.meaning) != kColors.end();
  });
}

/// Returns the level of full brightness; 0 if the values do not tell. Computed colours may be
/// a little brighter than full brightness, so the next larger range begins at twice a range.
double full_level(const PlyHeader& header, const Survey& values) {
  const double largest = values.largest_level;
  if ((values.has_fractions || has_real_colors(header)) && largest <= 2) return 1;
  if (largest <= 2 * kByteLevels) return kByteLevels;
  return largest <= 2 * kWordLevels ? kWordLevels : 0;
}

/// Returns the names of the properties that are not understood, the first few of them.
std::string unknown_properties(const PlyHeader& header) {
  std::vector<std::string_view> names;
  for (const PlyProperty& property : header.properties) {
    if (property.meaning == PlyMeaning::kOther) names.push_back(property.name);
  }
  constexpr std::size_t kMost = 4;
  const std::size_t shown = std::min(names.size(), kMost);
  const std::string rest =
      names.size() > shown ? fmt::format(" and {} more", names.size() - shown) : "";
  names.resize(shown);
  return fmt::format("{}{}", fmt::join(names, ", "), rest);
}

/// How the colours of a file are read.
struct ColorReading {
  double full = 0;                 ///< the level of full brightness; 0: the points are grey
  std::vector<std::string> notes;  ///< what was not understood
};

/// Returns why a file has no colours, as a note; empty if nothing in it could be one.
std::string note_without_colors(const PlyHeader& header) {
  if (count_of(header, kColors) > 0) {
    return "red, green and blue are not all there; the points are grey";
  }
  const std::string names = unknown_properties(header);
  if (names.empty()) return {};
  return fmt::format("no red, green and blue among the properties ({}); the points are grey",
                     names);
}

ColorReading reading_of(const PlyHeader& header, const Survey& values) {
  if (count_of(header, kColors) < 3) {
    const std::string note = note_without_colors(header);
    return {0, note.empty() ? std::vector<std::string>{} : std::vector{note}};
  }
  const double full = full_level(header, values);
  if (full == 0) {
    return {0,
            {fmt::format("colours up to {:.6g} are not understood: they should end at 1, 255 or "
                         "65535; the points are grey",
                         values.largest_level)}};
  }
  ColorReading reading{full, {}};
  if (values.largest_level > full) {
    reading.notes.push_back(
        fmt::format("colours up to {:.6g} are cut off at {:.6g}", values.largest_level, full));
  }
  if (values.smallest_level < 0) {
    reading.notes.push_back(
        fmt::format("colours down to {:.6g} are cut off at 0", values.smallest_level));
  }
  constexpr double kFewLevels = 4096;  // of sensors with 10 or 12 bits
  if (full == kWordLevels && values.largest_level < kFewLevels) {
    reading.notes.push_back(
        fmt::format("colours up to {:.6g} are taken as 16-bit values and are dark; write them with "
                    "full brightness at 65535",
                    values.largest_level));
  }
  if (values.bad_colors > 0) {
    reading.notes.push_back(
        fmt::format("{} point{} with colours that are not finite numbers; "
                    "grey",
                    values.bad_colors, values.bad_colors == 1 ? "" : "s"));
  }
  return reading;
}

std::uint8_t byte_of(double level, double full) {
  const double scaled = kByteLevels / full * level;
  return static_cast<std::uint8_t>(std::lround(std::clamp(scaled, 0.0, kByteLevels)));
}

Rgb rgb_of(const Vector3& color, double full) {
  if (full == 0 || !color.allFinite()) return kLightGrey;
  return {byte_of(color[0], full), byte_of(color[1], full), byte_of(color[2], full)};
}

void append(std::string& bytes, const Eigen::Vector3f& vector) {
  bytes.append(reinterpret_cast<const char*>(vector.data()), 3 * sizeof(float));
}

void append(std::string& bytes, const Vector3& vector) {
  bytes.append(reinterpret_cast<const char*>(vector.data()), 3 * sizeof(double));
}

}  // namespace

PlyCloud read_ply(const std::filesystem::path& file) {
  const std::string text = read_file(file);
  const PlyHeader header = parse_ply_header(file, text);
  // The first pass also finds a file that is cut off, before there is memory for its points.
  const Survey values = survey(file, header, text);
  const ColorReading colors = reading_of(header, values);
  const bool has_normals = count_of(header, kNormals) == 3;
  PlyCloud cloud;
  cloud.origin = origin_near(middle_of(values.places));
  for (const std::string& note : colors.notes) {
    cloud.notes.push_back(fmt::format("{}: {}", file.filename().string(), note));
  }
  cloud.points.reserve(header.vertices);
  for_each_vertex(file, header, text, [&](const PlyVertex& vertex) {
    MapPoint& point = cloud.points.emplace_back();
    point.position = (position_of(vertex) - cloud.origin).cast<float>();
    const Vector3 normal(vertex[PlyMeaning::kNx], vertex[PlyMeaning::kNy], vertex[PlyMeaning::kNz]);
    if (has_normals && normal.allFinite()) point.normal = normal.cast<float>();
    point.color = rgb_of(color_of(vertex), colors.full);
  });
  return cloud;
}

void write_ply(const std::filesystem::path& file, std::span<const MapPoint> points,
               const Vector3& origin) {
  const bool is_near = origin.isZero(0);
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment cvo_slam map, metres\nelement vertex {0}\n"
      "property {1} x\nproperty {1} y\nproperty {1} z\n"
      "property float nx\nproperty float ny\nproperty float nz\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n",
      points.size(), is_near ? "float" : "double");
  const std::size_t bytes_per_point = is_near ? 27 : 39;
  bytes.reserve(bytes.size() + bytes_per_point * points.size());
  for (const MapPoint& point : points) {
    if (is_near) {
      append(bytes, point.position);
    } else {
      append(bytes, Vector3(origin + point.position.cast<double>()));
    }
    append(bytes, point.normal);
    bytes.append(reinterpret_cast<const char*>(point.color.data()), point.color.size());
  }
  write_file(file, bytes);
}

}  // namespace cvo_slam
