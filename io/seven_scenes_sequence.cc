// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <regex>

#include <Eigen/LU>
#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/io/dataset_camera_internal.h"
#include "cvo_slam/io/sequence_internal.h"
#include "cvo_slam/io/text_internal.h"

namespace cvo_slam {
namespace {

using Path = std::filesystem::path;

struct NumberedFiles {
  Path color;
  Path depth;
  Path pose;
};

/// The files of each frame by its number.
std::map<int, NumberedFiles> list_frames(const Path& folder) {
  static const std::regex kName(
      R"(frame-(\d{1,9})\.(?:(color)\.(?:png|jpe?g)|(depth)\.png|(pose)\.txt))");
  std::map<int, NumberedFiles> frames;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    std::smatch match;
    if (!std::regex_match(name, match, kName)) continue;
    NumberedFiles& files = frames[std::stoi(match[1].str())];
    (match[2].matched ? files.color : match[3].matched ? files.depth : files.pose) = entry.path();
  }
  return frames;
}

/// Frames are numbered at 30 Hz. Whole microseconds, as trajectory files have them.
Timestamp stamp_of(int number) {
  constexpr std::int64_t kMicrosecond = 1000;
  return Timestamp(std::llround(number * 1e6 / 30) * kMicrosecond);
}

/// A camera-to-world matrix; empty where it is not one, as in frames the reference system lost.
std::optional<SE3> read_pose(const Path& file) {
  Eigen::Matrix<double, 4, 4, Eigen::RowMajor> matrix;
  const auto words = split_words(read_file(file));
  if (words.size() != static_cast<std::size_t>(matrix.size())) return std::nullopt;
  for (Eigen::Index i = 0; i < matrix.size(); ++i) {
    const auto value = parse_finite(words[static_cast<std::size_t>(i)]);
    if (!value) return std::nullopt;
    matrix.data()[i] = *value;
  }
  // Rounding makes a volume of 1 +- 1e-6; a matrix of zeros has none.
  constexpr double kSmallestVolume = 0.5;
  if (matrix.topLeftCorner<3, 3>().determinant() < kSmallestVolume) return std::nullopt;
  return SE3::from_matrix(matrix);
}

class ReferenceReader {
 public:
  explicit ReferenceReader(const Camera& camera)
      : T_depth_color_(camera.depth ? camera.depth->T_color_depth.inverse() : SE3()) {}

  /// Poses in the files are those of the depth camera; ours are those of the colour camera.
  void add(Timestamp stamp, const Path& file) {
    const auto T_world_depth = file.empty() ? std::nullopt : read_pose(file);
    if (T_world_depth) {
      poses_.push_back({stamp, *T_world_depth * T_depth_color_});
    } else {
      ++unusable_;
    }
  }

  void finish(Sequence& sequence) {
    sequence.reference = std::move(poses_);
    if (unusable_ == 0) return;
    sequence.notes.push_back(fmt::format(
        "{} frames have no usable pose file (missing, not finite, or all zero)", unusable_));
  }

 private:
  SE3 T_depth_color_;
  std::vector<StampedPose> poses_;
  std::size_t unusable_ = 0;
};

}  // namespace

bool is_seven_scenes_folder(const Path& folder) {
  static const std::regex kName(R"(frame-\d{1,9}\.color\.(png|jpe?g))");
  const std::filesystem::directory_iterator files(folder);
  return std::any_of(begin(files), end(files), [](const auto& entry) {
    return std::regex_match(entry.path().filename().string(), kName);
  });
}

Sequence open_seven_scenes_sequence(const Path& folder, const DatasetOptions& options) {
  Sequence sequence;
  sequence.name = folder_name(folder);
  sequence.kind = "7-Scenes";
  sequence.camera = choose_camera(folder, options, "7scenes");
  sequence.invalid_depth = 65535;
  ReferenceReader reference(sequence.camera);
  for (const auto& [number, files] : list_frames(folder)) {
    if (files.color.empty() || files.depth.empty()) {
      sequence.unpaired.color += files.color.empty() ? 0 : 1;
      sequence.unpaired.depth += files.depth.empty() ? 0 : 1;
      continue;
    }
    const Timestamp stamp = stamp_of(number);
    sequence.frames.push_back({stamp, stamp, files.color, files.depth});
    reference.add(stamp, files.pose);
  }
  if (sequence.frames.empty()) {
    throw InputError(folder, "no frame has both a .color and a .depth image");
  }
  reference.finish(sequence);
  return sequence;
}

}  // namespace cvo_slam
