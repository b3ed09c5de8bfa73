// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/training_images.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/numbers.h"
#include "cvo_slam/io/dataset.h"
#include "cvo_slam/synthetic/sensor.h"
#include "cvo_slam/synthetic/sequence.h"
#include "cvo_slam/synthetic/world.h"

namespace cvo_slam {
namespace {

constexpr std::string_view kSynthetic = "synth:";

std::size_t thinned(std::size_t count, std::size_t step) { return (count + step - 1) / step; }

/// Parses "<world>:<seed>".
std::pair<std::string, std::uint32_t> parse_world(const std::string& text) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  const auto seed =
      parse_integer<std::uint32_t>(std::string_view(text).substr(std::min(colon + 1, text.size())));
  if (seed) return {text.substr(0, colon), *seed};
  throw OptionError(fmt::format(
      "vocab train: {}{} must be synth:<world>:<seed>, e.g. synth:office:900", kSynthetic, text));
}

TrainingImages synthetic_images(const std::string& text, double rate) {
  const auto [name, seed] = parse_world(text);
  const auto world = synthetic::make_world(name, {.seed = seed});
  const Camera camera = synthetic::synthetic_camera(640, 480);
  const double duration = world.path.duration();
  const auto sensor = std::make_shared<const synthetic::Sensor>(
      world.scene, [path = world.path](double seconds) { return path.T_world_camera(seconds); },
      duration, camera, synthetic::sensor_preset("kinect"), seed);
  return {static_cast<std::size_t>(duration * rate), [sensor, rate](std::size_t i) {
            RgbdFrame frame;
            frame.index = i;
            frame.color =
                sensor->capture(i, {.color = static_cast<double>(i) / rate, .depth = {}}).color;
            return frame;
          }};
}

TrainingImages dataset_images(std::shared_ptr<const Dataset> data, std::size_t step) {
  const std::size_t count = thinned(data->size(), step);
  return {count, [data = std::move(data), step](std::size_t i) { return data->read(i * step); }};
}

bool is_image(const std::filesystem::path& file) {
  const auto extension = file.extension();
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg";
}

TrainingImages folder_images(const std::filesystem::path& folder, std::size_t step) {
  std::vector<std::filesystem::path> files;
  std::error_code problem;
  for (const auto& entry : std::filesystem::directory_iterator(folder, problem)) {
    if (is_image(entry.path())) files.push_back(entry.path());
  }
  if (problem) throw InputError(folder, "cannot be listed: " + problem.message());
  if (files.empty()) throw InputError(folder, "has no PNG or JPEG files, and is no data set");
  std::sort(files.begin(), files.end());
  const std::size_t count = thinned(files.size(), step);
  return {count, [files = std::move(files), step](std::size_t i) {
            RgbdFrame frame;
            frame.index = i * step;
            frame.color = cv::imread(files[i * step], cv::IMREAD_COLOR);
            return frame;
          }};
}

/// Returns true if the folder itself holds images; the folders of data sets do not.
bool holds_images(const std::filesystem::path& folder) {
  std::error_code problem;
  for (const auto& entry : std::filesystem::directory_iterator(folder, problem)) {
    // 7-Scenes: frame-000000.color.jpg
    if (is_image(entry.path())) return entry.path().stem().extension().empty();
  }
  return false;
}

}  // namespace

TrainingImages open_training_images(const std::string& source, const Thinning& thinning) {
  if (source.starts_with(kSynthetic)) {
    return synthetic_images(source.substr(kSynthetic.size()), thinning.synthetic_rate);
  }
  const auto step = static_cast<std::size_t>(thinning.step);
  if (holds_images(source)) return folder_images(source, step);
  return dataset_images(open_dataset(source), step);
}

}  // namespace cvo_slam
