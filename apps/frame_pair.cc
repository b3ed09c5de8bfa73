// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/frame_pair.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "cvo_slam/core/association.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/core/numbers.h"
#include "cvo_slam/frontend/point_selection.h"
#include "cvo_slam/io/camera_file.h"
#include "cvo_slam/io/dataset.h"
#include "cvo_slam/io/depth_registration.h"

namespace cvo_slam {
namespace {

/// Slightly more than half the period of a 30 Hz camera: every time of a recording has a frame.
constexpr double kMaxStampDifference = 0.02;  // [s]

std::size_t nearest_frame(const Dataset& data, const Timestamp& stamp) {
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < data.size(); ++i) {
    if (std::abs(seconds_between(data.stamp(i), stamp)) <
        std::abs(seconds_between(data.stamp(nearest), stamp))) {
      nearest = i;
    }
  }
  return nearest;
}

std::size_t frame_of_stamp(const Dataset& data, const std::string& word, const Timestamp& stamp) {
  const std::size_t nearest = nearest_frame(data, stamp);
  if (std::abs(seconds_between(data.stamp(nearest), stamp)) <= kMaxStampDifference) return nearest;
  throw OptionError(
      fmt::format("frame {}: no frame has a stamp within {} s; the nearest is frame "
                  "{} at {}",
                  word, kMaxStampDifference, nearest, data.stamp(nearest).to_string()));
}

/// Finds a frame by its number, or by its stamp if the word has a point.
std::size_t find_frame(const Dataset& data, const std::string& word) {
  if (word.find('.') != std::string::npos) {
    if (const auto stamp = Timestamp::parse(word)) return frame_of_stamp(data, word, *stamp);
  }
  const auto index = parse_integer<std::size_t>(word);
  if (!index) {
    throw OptionError(fmt::format("frame '{}' is neither a number nor a stamp; write e.g. 12 or {}",
                                  word, data.stamp(0).to_string()));
  }
  if (*index < data.size()) return *index;
  throw OptionError(
      fmt::format("there is no frame {}; the sequence has frames 0 to {}", word, data.size() - 1));
}

RgbdFrame read_whole(const Dataset& data, std::size_t index) {
  RgbdFrame frame = data.read(index);
  const std::string problem =
      frame.problem.empty() ? check_images(frame, data.camera()) : frame.problem;
  if (!problem.empty()) {
    throw OptionError(
        fmt::format("frame {} of {} cannot be used: {}", index, data.name(), problem));
  }
  return frame;
}

std::optional<SE3> true_motion(const Dataset& data, const RgbdFrame& a, const RgbdFrame& b) {
  if (data.reference().empty()) return std::nullopt;
  std::vector<StampedPose> wanted = {{a.stamp, SE3()}, {b.stamp, SE3()}};
  const bool swapped = b.stamp < a.stamp;
  if (swapped) std::swap(wanted[0], wanted[1]);
  try {
    const auto matches = associate(data.reference(), wanted, {.interpolate = true});
    if (matches.size() != 2) return std::nullopt;
    const SE3 motion = matches[0].reference.inverse() * matches[1].reference;
    return swapped ? motion.inverse() : motion;
  } catch (const DataError&) {  // the reference covers another time
    return std::nullopt;
  }
}

FramePair pair_of_sequence(const std::vector<std::string>& words, const std::string& camera) {
  DatasetOptions options;
  if (!camera.empty()) options.camera = find_camera(camera);
  const auto data = open_dataset(words[0], options);
  const std::size_t a = find_frame(*data, words[1]);
  const std::size_t b = find_frame(*data, words[2]);
  if (a == b) {
    throw OptionError(
        fmt::format("{} and {} are both frame {}; name two frames", words[1], words[2], a));
  }
  FramePair pair;
  pair.camera = data->camera();
  pair.a = read_whole(*data, a);
  pair.b = read_whole(*data, b);
  pair.name_a = fmt::format("frame {}", a);
  pair.name_b = fmt::format("frame {}", b);
  pair.source = fmt::format("{} ({})", data->name(), data->kind());
  pair.seconds = seconds_between(pair.a.stamp, pair.b.stamp);
  pair.T_a_b_truth = true_motion(*data, pair.a, pair.b);
  return pair;
}

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  return a == b || std::filesystem::equivalent(a, b, error);
}

FramePair pair_of_images(const std::vector<std::string>& words, const std::string& camera) {
  if (camera.empty()) {
    throw OptionError(
        fmt::format("image files need their camera: name it with --camera, a file or "
                    "one of {}",
                    fmt::join(builtin_camera_names(), ", ")));
  }
  FramePair pair;
  pair.camera = find_camera(camera);
  pair.a = read_rgbd_images(words[0], words[1], pair.camera);
  pair.b = read_rgbd_images(words[2], words[3], pair.camera);
  pair.b.index = 1;
  if (is_same_file(words[0], words[2])) {
    throw OptionError(
        fmt::format("{} is the colour image of both frames; name two frames", words[0]));
  }
  pair.name_a = std::filesystem::path(words[0]).filename().string();
  pair.name_b = std::filesystem::path(words[2]).filename().string();
  return pair;
}

}  // namespace

FramePair read_frame_pair(const std::vector<std::string>& words, const std::string& camera) {
  if (words.size() == 3) return pair_of_sequence(words, camera);
  if (words.size() == 4) return pair_of_images(words, camera);
  throw OptionError(
      fmt::format("3 or 4 arguments are needed, not {}: a sequence and two of its frames, or the "
                  "colour and the depth image of each of two frames",
                  words.size()));
}

}  // namespace cvo_slam
