// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// 7-Scenes: Shotton et al., "Scene coordinate regression forests for camera relocalization in RGB-D
// images", CVPR 2013. Depth is not registered to colour, and poses are those of the depth camera.
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include <Eigen/LU>
#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/core/numbers.h"
#include "cvo_slam/io/dataset/formats_internal.h"
#include "cvo_slam/io/text_internal.h"

namespace cvo_slam {
namespace {

using Path = std::filesystem::path;

struct NumberedFiles {
  Path color;
  Path depth;
  Path pose;
};

/// The kinds of files, by what stands behind the number: "frame-000012.color.png".
constexpr std::array<std::pair<std::string_view, Path NumberedFiles::*>, 5> kFileKinds = {
    {{".color.png", &NumberedFiles::color},
     {".color.jpg", &NumberedFiles::color},
     {".color.jpeg", &NumberedFiles::color},
     {".depth.png", &NumberedFiles::depth},
     {".pose.txt", &NumberedFiles::pose}}};

struct NumberedName {
  int number = 0;
  Path NumberedFiles::*kind = nullptr;
};

/// Returns what a name says; empty if it is not that of a file of a frame.
std::optional<NumberedName> parse_name(std::string_view name) {
  constexpr std::string_view kPrefix = "frame-";
  if (!name.starts_with(kPrefix)) return std::nullopt;
  name.remove_prefix(kPrefix.size());
  const std::size_t digits = std::min(name.find('.'), name.size());
  constexpr std::size_t kMostDigits = 9;
  const auto number = parse_integer<int>(name.substr(0, digits));
  if (!number || *number < 0 || digits > kMostDigits || name.front() == '-') return std::nullopt;
  for (const auto& [ending, kind] : kFileKinds) {
    if (name.substr(digits) == ending) return NumberedName{*number, kind};
  }
  return std::nullopt;
}

/// Returns the files of each frame by its number.
std::map<int, NumberedFiles> list_frames(const Path& folder) {
  std::map<int, NumberedFiles> frames;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto name = parse_name(entry.path().filename().string());
    if (name) frames[name->number].*(name->kind) = entry.path();
  }
  return frames;
}

/// Returns a camera-to-world matrix; empty if `file` is empty or holds none, as for frames that the
/// reference system lost.
std::optional<SE3> read_pose(const Path& file) {
  if (file.empty()) return std::nullopt;
  Eigen::Matrix<double, 4, 4, Eigen::RowMajor> matrix;
  const auto words = split_words(read_text_file(file));
  if (words.size() != static_cast<std::size_t>(matrix.size())) return std::nullopt;
  for (Eigen::Index i = 0; i < matrix.size(); ++i) {
    const auto value = parse_finite(words[static_cast<std::size_t>(i)]);
    if (!value) return std::nullopt;
    matrix.data()[i] = *value;
  }
  // A rounded rotation has a determinant of 1 +- 1e-6, a matrix of zeros has 0.
  constexpr double kSmallestDeterminant = 0.5;
  if (matrix.topLeftCorner<3, 3>().determinant() < kSmallestDeterminant) return std::nullopt;
  return SE3::from_matrix(matrix);
}

bool is_seven_scenes(const Path& folder) {
  const std::filesystem::directory_iterator files(folder);
  return std::any_of(begin(files), end(files), [](const auto& entry) {
    const auto name = parse_name(entry.path().filename().string());
    return name && name->kind == &NumberedFiles::color;
  });
}

Sequence open_seven_scenes(const Path& folder, const PairingOptions& options) {
  if (options.associations) {
    throw OptionError("7-Scenes pairs images by their numbers: leave out the list of pairs");
  }
  Sequence sequence;
  sequence.invalid_depth = 65535;
  sequence.reference_is_of_depth = true;
  sequence.has_counted_stamps = true;
  const auto listed = list_frames(folder);
  if (!listed.empty() && listed.rbegin()->first > kLatestStamp * options.frame_rate) {
    throw InputError(folder,
                     fmt::format("frame {} is beyond the latest time at {} Hz; give another "
                                 "frame rate",
                                 listed.rbegin()->first, options.frame_rate));
  }
  for (const auto& [number, files] : listed) {
    if (files.color.empty() || files.depth.empty()) {
      sequence.unpaired.color += files.color.empty() ? 0 : 1;
      sequence.unpaired.depth += files.depth.empty() ? 0 : 1;
      continue;
    }
    const Timestamp stamp = stamp_of_frame(number, options.frame_rate);
    sequence.frames.push_back({stamp, stamp, files.color, files.depth});
    const auto T_world_depth = read_pose(files.pose);
    if (T_world_depth) sequence.reference.push_back({stamp, *T_world_depth});
  }
  if (sequence.frames.empty()) {
    throw InputError(folder, "no frame has both a .color and a .depth image");
  }
  const std::size_t unusable = sequence.frames.size() - sequence.reference.size();
  if (unusable > 0) {
    sequence.notes.push_back(fmt::format(
        "{} frames have no usable pose file (missing, not finite, or all zero)", unusable));
  }
  return sequence;
}

}  // namespace

constinit const DatasetFormat kSevenScenesFormat = {
    .name = "7-Scenes",
    .layout = "frame-000000.color.png and .depth.png",
    .recognise = is_seven_scenes,
    .named_camera = nullptr,
    .open = open_seven_scenes,
};

}  // namespace cvo_slam
